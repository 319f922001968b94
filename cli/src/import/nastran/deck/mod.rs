//! A Nastran deck as cards: its files, their lines, the fields in them. Nothing here knows what a card means, but that equations
//! are text.

mod fields;
mod files;
mod number;

use std::ops::Range;
use std::path::Path;

pub use fields::DATA;
use fields::{Span, Unreadable};
use files::{DeckLine, Files, Refused};
pub use files::{OnDisk, Source};
pub use number::{integer, real};

use super::mistakes::Mistakes;

/// The name of a card of text, in which commas divide nothing.
const EQUATION: &str = "DEQATN";

/// What a line begins with that has its fields from the line above.
const REPEATS: char = '=';

/// Letters of a field that messages show.
const LONGEST_SHOWN: usize = 40;

/// A line of a file of the deck, from 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    pub file: usize,
    pub line: usize,
}

/// A file with its text.
#[derive(Debug)]
pub struct DeckFile {
    pub name: String,
    pub text: String,
}

/// A field of a card: where it is.
#[derive(Clone, Debug)]
pub struct Field {
    pub line: u32,
    pub span: Span,
}

/// A card with its continuations.
#[derive(Debug)]
pub struct Card {
    /// In capitals.
    pub name: String,
    pub place: Place,
    /// The line after its last one.
    pub end: usize,
    /// The name itself.
    head: Span,
    /// Data fields, eight for each line of the small format.
    fields: Vec<Field>,
}

/// All of it.
#[derive(Debug, Default)]
pub struct Deck {
    pub files: Vec<DeckFile>,
    pub cards: Vec<Card>,
    /// The sets of constraints that the case control asks for; none of a deck without case control.
    pub constraint_sets: Option<Vec<i64>>,
    /// Lines before BEGIN BULK that say something.
    pub control_lines: Vec<Place>,
}

impl Deck {
    /// Reads a deck; lines that are no cards are mistakes.
    pub fn read(path: &Path, source: &dyn Source, mistakes: &mut Mistakes) -> Deck {
        let (files, refused) = Files::read(path, source);
        match refused {
            Some(Refused { place: Some((place, bytes)), found, allowed }) => {
                mistakes.add(place.file, bytes, "INCLUDE".to_owned(), found, allowed);
            }
            Some(Refused { place: None, found, allowed }) => mistakes.of_whole(format!("{found}; {allowed}")),
            None => {}
        }
        let Files { files, lines, .. } = files;
        let mut deck = Deck { files, ..Deck::default() };
        let (bulk, parameters) = deck.control(&lines);
        deck.bulk(lines[bulk..].iter(), mistakes);
        // A parameter of the case control counts before one of the bulk data: it is read last.
        deck.bulk(parameters, mistakes);
        deck
    }

    /// The number of lines before the bulk data, 0 of a deck that is nothing else; and those of them that are cards all the same.
    fn control<'l>(
        &mut self,
        lines: &'l [DeckLine],
    ) -> (usize, impl Iterator<Item = &'l DeckLine> + use<'l>) {
        let words = |line: &DeckLine| -> Vec<String> {
            let text = self.line(line).split('$').next().unwrap_or_default().to_uppercase();
            text.split([' ', '\t', '=', ',']).filter(|word| !word.is_empty()).map(str::to_owned).collect()
        };
        let is_begin = |line: &DeckLine| words(line).starts_with(&["BEGIN".to_owned(), "BULK".to_owned()]);
        let bulk = lines.iter().position(is_begin).map_or(0, |begin| begin + 1);
        let (mut sets, mut said, mut parameters) = (Vec::new(), Vec::new(), Vec::new());
        let mut has_cases = false;
        for line in &lines[..bulk] {
            let words = words(line);
            let Some(first) = words.first() else { continue };
            if first == "PARAM" {
                parameters.push(line);
                continue;
            }
            sets.extend(words.get(1).filter(|_| first == "SPC").and_then(|set| integer(set)));
            said.push(line.place);
            has_cases |= matches!(first.as_str(), "CEND" | "SPC");
        }
        self.control_lines = said;
        self.constraint_sets = has_cases.then_some(sets);
        (bulk, parameters.into_iter())
    }

    fn bulk<'l>(&mut self, lines: impl Iterator<Item = &'l DeckLine>, mistakes: &mut Mistakes) {
        let mut tail = String::new();
        let mut cards = std::mem::take(&mut self.cards);
        for line in lines {
            let text = self.line(line);
            let said = text.split('$').next().unwrap_or_default().trim();
            if said.is_empty() {
                continue;
            }
            if said.eq_ignore_ascii_case("ENDDATA") {
                break;
            }
            if let Some(word) = equation(text, cards.last()) {
                match cards.last_mut().filter(|_| word.is_empty()) {
                    Some(card) => card.end = line.place.line + 1,
                    None => cards.push(Card::of_text(word, line)),
                }
                tail.clear();
                continue;
            }
            let Some(cut) = Self::cut(text, line, mistakes) else { continue };
            let of = |span: &Span| &self.files[line.place.file].text[span.start as usize..span.end as usize];
            let head = of(&cut.head);
            let is_continuation = head.is_empty() || head.starts_with(['+', '*']);
            let fields =
                cut.data.iter().map(|span| Field { line: line.place.line as u32, span: span.clone() });
            if !is_continuation {
                let name = head.to_uppercase();
                let mut card = Card {
                    name,
                    place: line.place,
                    end: line.place.line + 1,
                    head: cut.head.clone(),
                    fields: fields.collect(),
                };
                card.pad(cut.is_large);
                cards.push(card);
            } else if let Some(card) = continued(cards.last_mut(), line.place, (&tail, head)) {
                card.extend(fields, cut.is_large, line.place);
            } else {
                let found =
                    format!("found the continuation {:?} after {:?}", cut_short(head), cut_short(&tail));
                let allowed = "a continuation is allowed right below the line that it continues".to_owned();
                mistakes.add(line.place.file, line.bytes.clone(), "continuation".to_owned(), found, allowed);
            }
            tail = of(&cut.tail).to_owned();
        }
        self.cards = cards;
    }

    /// The fields of a line; if it has none, says why.
    fn cut(text: &str, line: &DeckLine, mistakes: &mut Mistakes) -> Option<fields::Line> {
        let (bytes, found, allowed) = match fields::cut(text, line.bytes.start as u32) {
            Ok(_) if text.trim_start().starts_with(REPEATS) => {
                let found =
                    format!("found {:?}, which repeats fields of the line above", cut_short(text.trim()));
                (line.bytes.clone(), found, "cards that are written out are allowed".to_owned())
            }
            Ok(cut) => return Some(cut),
            Err(Unreadable::TooMany { found, allowed }) => (
                line.bytes.clone(),
                format!("found {found} fields between commas"),
                format!("up to {allowed} are allowed on a line, the last for the continuation"),
            ),
            Err(Unreadable::TooLong { found, allowed }) => (
                line.bytes.start..line.bytes.start + DATA.min(text.len()),
                format!("found a line of {found} bytes without its comment"),
                format!("up to {allowed} are allowed"),
            ),
        };
        mistakes.add(line.place.file, bytes, "line".to_owned(), found, allowed);
        None
    }

    fn line(&self, line: &DeckLine) -> &str {
        &self.files[line.place.file].text[line.bytes.clone()]
    }

    /// A field of a card, counted from 0 for the one behind the name; blank beyond the last.
    pub fn text(&self, card: &Card, index: usize) -> &str {
        card.fields.get(index).map_or("", |field| &self.files[card.place.file].text[bytes(&field.span)])
    }

    /// The bytes of a line, without the blanks around it.
    pub fn bytes_of(&self, place: Place) -> Range<usize> {
        let text = self.files.get(place.file).map_or("", |file| file.text.as_str());
        let begin: usize = text.split_inclusive('\n').take(place.line.saturating_sub(1)).map(str::len).sum();
        let line = text[begin..].lines().next().unwrap_or_default();
        begin..begin + line.trim_end().len()
    }

    /// `deck.bdf:12`.
    pub fn shown(&self, place: Place) -> String {
        let name = self.files.get(place.file).map_or("", |file| file.name.as_str());
        format!("{name}:{}", place.line)
    }

    /// The same without folders.
    pub fn shown_briefly(&self, place: Place) -> String {
        let name = self.files.get(place.file).map_or("", |file| file.name.as_str());
        let name = Path::new(name).file_name().unwrap_or_default();
        format!("{}:{}", name.to_string_lossy(), place.line)
    }
}

/// Of a line of an equation the name that it begins with, which a line that continues one has not.
fn equation<'t>(text: &'t str, before: Option<&Card>) -> Option<&'t str> {
    let word = text.get(..EQUATION.len()).filter(|word| word.eq_ignore_ascii_case(EQUATION));
    let goes_on =
        before.is_some_and(|card| card.name == EQUATION) && text.starts_with([' ', '\t', '+', '*', ',']);
    word.or(goes_on.then_some(""))
}

/// The card that a line continues, if it does: marks at both ends are alike where both are there. Of the one that a line ends with, the
/// first letter may be any: `KFREQ` is continued by `+FREQ`.
fn continued<'c>(
    card: Option<&'c mut Card>,
    place: Place,
    (tail, head): (&str, &str),
) -> Option<&'c mut Card> {
    let bare = |mark: &str| mark.trim_start_matches(['+', '*']).to_uppercase();
    let behind_first = tail.chars().skip(1).collect::<String>().to_uppercase();
    let (tail, head) = (bare(tail), bare(head));
    let fits = tail.is_empty() || head.is_empty() || tail == head || behind_first == head;
    card.filter(|card| fits && card.place.file == place.file)
}

fn bytes(span: &Span) -> Range<usize> {
    span.start as usize..span.end as usize
}

impl Card {
    /// One of which only the name is read.
    fn of_text(name: &str, line: &DeckLine) -> Card {
        let begin = line.bytes.start as u32;
        let head = begin..begin + name.len() as u32;
        Card {
            name: name.to_uppercase(),
            place: line.place,
            end: line.place.line + 1,
            head,
            fields: Vec::new(),
        }
    }

    /// Lines have eight fields: after a large one alone the rest is blank.
    fn pad(&mut self, is_large: bool) {
        if !is_large {
            let blank = self.fields.last().map_or(Field { line: 0, span: 0..0 }, blank_after);
            let whole = self.fields.len().next_multiple_of(DATA);
            self.fields.resize(whole, blank);
        }
    }

    fn extend(&mut self, fields: impl Iterator<Item = Field>, is_large: bool, place: Place) {
        self.pad(is_large);
        self.fields.extend(fields);
        self.end = place.line + 1;
    }

    /// How many data fields there are, blank ones at the end left out.
    pub fn len(&self) -> usize {
        self.fields.iter().rposition(|field| !field.span.is_empty()).map_or(0, |last| last + 1)
    }

    /// The line of a field, and the bytes that stand for it; the name where it is beyond the end.
    pub fn field_place(&self, index: usize) -> (Place, Range<usize>) {
        let field = self.fields.get(index).filter(|field| !field.span.is_empty());
        field.map_or((self.place, bytes(&self.head)), |field| {
            (Place { line: field.line as usize, ..self.place }, bytes(&field.span))
        })
    }
}

fn blank_after(field: &Field) -> Field {
    Field { line: field.line, span: field.span.end..field.span.end }
}

/// What stands in a field, for people: cut where it is long.
pub fn cut_short(text: &str) -> std::borrow::Cow<'_, str> {
    match text.char_indices().nth(LONGEST_SHOWN) {
        Some((end, _)) => format!("{}…", &text[..end]).into(),
        None => text.into(),
    }
}

/// A field as the manuals count it: the name is field 1, each line has ten.
pub fn field_number(index: usize) -> usize {
    index % DATA + 2
}

#[cfg(test)]
mod tests;
