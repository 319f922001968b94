//! Decks of several files and formats.

use std::collections::BTreeMap;
use std::path::PathBuf;

use super::*;

struct InMemory(BTreeMap<&'static str, String>);

impl Source for InMemory {
    fn read(&self, path: &Path) -> Result<(PathBuf, String), String> {
        let text = self.0.get(path.to_str().unwrap()).ok_or("there is none")?;
        Ok((path.to_owned(), text.clone()))
    }
}

fn read(files: &[(&'static str, &str)]) -> (Deck, String) {
    let source = InMemory(files.iter().map(|(name, text)| (*name, (*text).to_owned())).collect());
    let mut mistakes = Mistakes::default();
    let deck = Deck::read(Path::new(files[0].0), &source, &mut mistakes);
    let told = mistakes.conclude(&deck).map_or_else(|rejected| rejected.to_string(), |()| String::new());
    (deck, told)
}

#[test]
fn cards_have_their_continuations_and_the_lines_of_their_files() {
    let main =
        "SOL 103\nCEND\nSPC = 7\nBEGIN BULK\nGRID,1,,0.,0.,0.\ninclude 'wing.bdf'\nGRID,3\nENDDATA\nrubbish";
    let wing = "$ a wing\n\nPBAR    5       1       2.      3.      4.      5.              \n\n+       1.\n+       .5\n";
    let (deck, told) = read(&[("a.bdf", main), ("wing.bdf", wing)]);
    assert_eq!(told, "");
    let shown: Vec<String> =
        deck.cards.iter().map(|card| format!("{} {}", card.name, deck.shown(card.place))).collect();
    assert_eq!(shown, ["GRID a.bdf:5", "PBAR wing.bdf:3", "GRID a.bdf:7"]);
    let bar = &deck.cards[1];
    assert_eq!([0, 8, 16, 99].map(|index| deck.text(bar, index)), ["5", "1.", ".5", ""]);
    assert_eq!((bar.field_place(16).0.line, bar.end, bar.len()), (6, 7, 17));
    assert_eq!((deck.constraint_sets, deck.control_lines.len()), (Some(vec![7]), 4));
}

#[test]
fn large_fields_fill_lines_of_eight() {
    let text = "PBAR*,5,1,2.,3.\n*,4.,5.,,\n,1.,2.\n";
    let (deck, told) = read(&[("a.bdf", text)]);
    assert_eq!(told, "");
    let texts: Vec<&str> = (0..10).map(|index| deck.text(&deck.cards[0], index)).collect();
    assert_eq!(texts, ["5", "1", "2.", "3.", "4.", "5.", "", "", "1.", "2."]);
}

#[test]
fn continuations_of_large_fields_may_have_names_behind_their_star() {
    let columns = "GRID*                  1                              0.              2.*GA1\n*GA1                  .5\n";
    let commas = "GRID*,1,,0.,2.,*GA1\n*GA1,.5\n";
    for text in [columns, commas] {
        let (deck, told) = read(&[("a.bdf", text)]);
        assert_eq!((told.as_str(), deck.cards.len()), ("", 1), "{text}");
        let texts: Vec<&str> = (0..5).map(|index| deck.text(&deck.cards[0], index)).collect();
        assert_eq!(texts, ["1", "", "0.", "2.", ".5"]);
    }
    let (_, told) = read(&[("a.bdf", "GRID*,1,,0.,2.,*GA1\n*GA2,.5\n")]);
    assert!(told.contains("found the continuation \"*GA2\" after \"*GA1\""), "{told}");
}

#[test]
fn parameters_of_the_case_control_are_cards_and_what_follows_enddata_is_nothing() {
    let text = "\u{feff}SOL 144\nCEND\nPARAM,WTMASS,.00259 $ pounds\nECHO = NONE\nBEGIN BULK\nGRID,1\nenddata $ of the deck\nrubbish,1\n";
    let (deck, told) = read(&[("a.bdf", text)]);
    assert_eq!(told, "");
    let names: Vec<&str> = deck.cards.iter().map(|card| card.name.as_str()).collect();
    assert_eq!(names, ["GRID", "PARAM"]);
    assert_eq!((deck.constraint_sets, deck.control_lines.len()), (Some(vec![]), 4));
    // A mark of the alphabet is no letter of the first card.
    let (bare, _) = read(&[("a.bdf", "\u{feff}GRID,1\n")]);
    assert_eq!((bare.cards[0].name.as_str(), bare.constraint_sets), ("GRID", None));
}

#[test]
fn included_files_are_beside_the_file_or_beside_the_deck() {
    let files = [
        ("in/a.bdf", "INCLUDE 'sub/b.bdf'\nINCLUDE\n'c.bdf'\n"),
        ("in/sub/b.bdf", "INCLUDE 'd.bdf'\n"),
        ("in/c.bdf", "GRID,3\n"),
        ("in/d.bdf", "GRID,4\n"),
    ];
    let (deck, told) = read(&files);
    assert_eq!(told, "");
    let places: Vec<String> = deck.cards.iter().map(|card| deck.shown(card.place)).collect();
    assert_eq!(places, ["in/d.bdf:1", "in/c.bdf:1"]);
    let (_, told) = read(&files[..3]);
    assert_eq!(
        told,
        "in/sub/b.bdf:1:1: INCLUDE: found in/sub/d.bdf, which cannot be read: there is none; nor in/d.bdf, which cannot be read: \
         there is none; a file that can be read is allowed"
    );
    let (_, told) = read(&[("a.bdf", "INCLUDE\nGRID,1\n")]);
    assert_eq!(told, "a.bdf:1:1: INCLUDE: found no path; the path of a file is needed");
}

#[test]
fn continuations_in_another_place_and_before_any_card_are_mistakes() {
    let text = "+A,1\nGRID,1,,0.,0.,0.,,,,+B\n+C,1.\n";
    let (_, told) = read(&[("a.bdf", text)]);
    assert_eq!(
        told,
        "a.bdf:1:1: continuation: found the continuation \"+A\" after \"\"; a continuation is allowed right below the line that it continues\n\
         a.bdf:3:1: continuation: found the continuation \"+C\" after \"+B\"; a continuation is allowed right below the line that it continues"
    );
}

#[test]
fn the_first_letter_of_the_mark_that_a_line_ends_with_may_be_any() {
    let text = "FLFACT  3       .1      .2      .3      .4      .5      .6      .7      KFREQ\n+FREQ   .8\n";
    let (deck, told) = read(&[("a.bdf", text)]);
    assert_eq!(told, "");
    assert_eq!((deck.cards.len(), deck.text(&deck.cards[0], 8)), (1, ".8"));
}

#[test]
fn equations_are_text_and_lines_that_repeat_others_are_refused() {
    let text =
        "DEQATN  301     Z(A,B,C,D,E,F,G,H,I,J,K)=SUM(A,B,C)\n        +MAX(A,B,C,D,E,F,G,H,I,J,K)\nGRID,1\n";
    let (deck, told) = read(&[("a.bdf", text)]);
    assert_eq!(told, "");
    assert_eq!(deck.cards.iter().map(|card| card.name.as_str()).collect::<Vec<_>>(), ["DEQATN", "GRID"]);
    assert_eq!(deck.cards[0].end, 3);
    let (_, told) = read(&[("a.bdf", "GRID,101,2,48.,0.,0.,1\n=,*(1),=,=,*(12.5),==\n=(8)\n")]);
    assert_eq!(
        told,
        "a.bdf:2:1: line: found \"=,*(1),=,=,*(12.5),==\", which repeats fields of the line above; cards that are written out are allowed\n\
         a.bdf:3:1: line: found \"=(8)\", which repeats fields of the line above; cards that are written out are allowed"
    );
}

#[test]
fn includes_go_neither_in_circles_nor_without_end_nor_to_what_is_missing() {
    let (_, told) = read(&[("a.bdf", "GRID,1\nINCLUDE 'b.bdf'\n"), ("b.bdf", "$\nINCLUDE 'a.bdf'\n")]);
    assert!(
        told.starts_with("b.bdf:2:1: INCLUDE: found a.bdf, which leads here; a file is allowed that"),
        "{told}"
    );
    let (_, told) = read(&[("a.bdf", "INCLUDE 'gone/\nno.bdf'\n")]);
    assert!(
        told.starts_with("a.bdf:1:1: INCLUDE: found gone/no.bdf, which cannot be read: there is none"),
        "{told}"
    );
    let names: Vec<&'static str> = (0..18).map(|level| format!("{level}.bdf").leak() as &str).collect();
    let chain = |deepest: usize| {
        let texts: Vec<String> =
            (0..=deepest).map(|level| format!("INCLUDE '{}.bdf'\n", level + 1)).collect();
        let mut files: Vec<(&'static str, &str)> =
            names.iter().copied().zip(texts.iter().map(String::as_str)).collect();
        files[deepest].1 = "GRID,1\n";
        read(&files).1
    };
    assert_eq!(chain(16), "");
    assert!(chain(17).contains("found 17.bdf one level deeper; 16 levels"), "{}", chain(17));
}

#[test]
fn a_file_that_includes_the_next_many_times_is_refused_before_it_fills_the_memory() {
    let many = "INCLUDE 'b.bdf'\n".repeat(20_000);
    let (_, told) = read(&[("a.bdf", &many), ("b.bdf", &"$ comment\n".repeat(1000))]);
    assert!(told.contains("1000 files, 64 MiB and 1000000 lines are allowed"), "{told}");
    // Lines that include are lines, and files without any are files.
    let lines = "INCLUDE 'b.bdf'\n".repeat(1_000_001);
    for many in [&lines, &many] {
        let (deck, told) = read(&[("a.bdf", many), ("b.bdf", "")]);
        assert!(told.contains("1000 files, 64 MiB and 1000000 lines are allowed"), "{told}");
        assert!(deck.files.len() <= 1000);
    }
}

#[test]
fn lines_and_fields_without_end_are_refused_in_short_messages() {
    let long = format!(
        "GRID,5,,{}.,0.,0.\nGRID{}\n$ {}\n",
        "1".repeat(100_000),
        ",".repeat(100_000),
        "-".repeat(2000)
    );
    let (_, told) = read(&[("a.bdf", &long)]);
    assert_eq!(
        told,
        "a.bdf:1:1: line: found a line of 100015 bytes without its comment; up to 1000 are allowed\n\
         a.bdf:2:1: line: found a line of 100004 bytes without its comment; up to 1000 are allowed"
    );
}
