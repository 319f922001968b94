//! Decks without end: refused, or an aircraft, in a time that does not grow with what they repeat.

use std::fmt::Write as _;
use std::time::{Duration, Instant};

use super::*;

/// A clamped stick of one element.
const STICK: &str = "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,.01,1.-4,4.-4,1.-4\nGRID,1,,0.,0.,0.\nGRID,2,,0.,3.,0.\nCBAR,1,1,1,2,0.,0.,1.\nSPC1,1,123456,1\n";

/// The stick with lines for numbers of a range.
fn deck(more: &str, numbers: std::ops::Range<usize>, line: impl Fn(usize) -> String) -> String {
    numbers.fold(format!("{STICK}{more}"), |mut text, number| {
        // PROOF: a string takes every text.
        let _ = write!(text, "{}", line(number));
        text
    })
}

/// Each of them took up to 0.25 s, on a machine that did nothing else.
const LONGEST: Duration = Duration::from_secs(3);

/// What becomes of a deck, soon: what is refused, or what is imported.
#[track_caller]
fn in_time(deck: &str) -> Result<Imported, String> {
    let begin = Instant::now();
    let found = of_text(deck).map_err(|error| error.to_string());
    let taken = begin.elapsed();
    assert!(taken < LONGEST, "{taken:?}");
    found
}

fn grids(first: usize, count: usize) -> String {
    deck("", first..first + count, |grid| format!("GRID,{grid},,0.,{grid}.,0.\n")).replace(STICK, "")
}

#[test]
fn lists_that_name_all_grids_many_times_count_them_once() {
    let grids = grids(3, 60_000);
    let runs = ",1,THRU,99999999,1,THRU,9999999\n".repeat(20_000);
    let panel = "CAERO1,1001,1,,1,1,,,1\n,-.25,0.,0.,1.,-.25,3.,0.,1.\nSPLINE1,1,1001,1001,1001,1\n";
    for list in ["SPC1,9,1,1\n".to_owned(), "RBE2,9,2,123456,2\n".to_owned(), format!("{panel}SET1,1,2\n")] {
        let text = format!("{STICK}{grids}{list}{runs}");
        // All grids on one rigid body have no element: what is asked is that it ends.
        let _ = in_time(&text);
    }
    let many =
        (0..200_000).fold(String::new(), |text, set| text + &format!("SPC1,{},1,1,THRU,99999999\n", 9 + set));
    let told = in_time(&format!("{STICK}{grids}{many}")).unwrap_err();
    assert!(
        told.contains(
            "SPC1 25 (list): found lists that name 1020035 grids up to here; up to 1000000 are allowed"
        ),
        "{told}"
    );
}

#[test]
fn panels_splines_and_control_surfaces_without_end_are_refused() {
    let panel = |id: usize| format!("CAERO1,{id},1,,2,2,,,1\n,-.25,0.,0.,1.,-.25,3.,0.,1.\n");
    let told = in_time(&deck("", 1..100_000, |number| panel(10 * number))).unwrap_err();
    assert!(
        told.contains("CAERO1 10010 (ID): found 99999 cards of its kind; up to 1000 are allowed"),
        "{told}"
    );
    let spline = |number: usize| format!("SPLINE1,{number},10,10,13,1\n");
    let told = in_time(&deck(&panel(10), 1..100_000, spline)).unwrap_err();
    assert!(told.contains("SPLINE1 2001 (ID): found 99999 cards"), "{told}");
    let surface = |number: usize| format!("AESURF,{number},S{number},0,1,0,1\n");
    let told = in_time(&deck(&(panel(10) + "AELIST,1,10,11\n"), 1..100_000, surface)).unwrap_err();
    assert!(told.contains("AESURF 1001 (ID): found 99999 cards"), "{told}");
    let large = |number: usize| panel(100_000 * number).replace(",2,2,", ",300,300,");
    let told = in_time(&deck("", 1..101, large)).unwrap_err();
    assert!(told.contains("CAERO1 3400000 (NSPAN): found 10200 boxes along the spans"), "{told}");
    // Nearly as many boxes as are allowed, on panels that meet and that do not.
    for apart in [1, 2] {
        let row = |number: usize| {
            let front = apart * number;
            format!("CAERO1,{},1,,10,1,,,1\n,{front}.,0.,0.,1.,{front}.,3.,0.,1.\n", 10 * number)
        };
        let list = "AELIST,1,10,THRU,9999999\nCORD2R,1,,5.,0.,0.,5.,0.,1.\n,6.,0.,0.\n";
        let surface = |number: usize| surface(number).replace(",0,1", ",1,1");
        let all = deck(list, 1..400, row) + &(1..120).map(surface).collect::<String>();
        let _ = in_time(&all).unwrap();
    }
}

#[test]
fn fans_and_turning_chains_get_their_names_at_once() {
    let fan = deck("", 10..4000, |grid| {
        format!(
            "GRID,{grid},,0.,{:.4},{:.4}\nCBAR,{grid},1,1,{grid},1.,0.,0.\n",
            1.0 + 2e-4 * grid as f64,
            1e-4 * grid as f64
        )
    });
    let found = in_time(&fan).unwrap();
    assert!(found.text().contains("name = \"wing_3991_right\"\n"));
    let turning = deck("", 10..2000, |grid| {
        let before = if grid == 10 { 2 } else { grid - 1 };
        let (y, z) = (3 + grid / 2, grid.div_ceil(2));
        format!("GRID,{grid},,0.,{y}.e-1,{z}.e-1\nCBAR,{grid},1,{before},{grid},1.,0.,0.\n")
    });
    let found = in_time(&turning).unwrap();
    assert!(found.aircraft.components.len() > 1900);
}

#[test]
fn chains_longer_than_a_component_of_the_format_go_on_as_another_one() {
    let chain = deck("", 10..2510, |grid| {
        let before = if grid == 10 { 2 } else { grid - 1 };
        format!(
            "GRID,{grid},,0.,{}.,0.\nCBAR,{grid},1,{before},{grid},0.,0.,1.\n",
            3.0 + 0.01 * (grid - 9) as f64
        )
    });
    let found = in_time(&chain.replace(".,0.\nCBAR", ",0.\nCBAR")).unwrap();
    assert_eq!(found.aircraft.beams.len(), 2501);
    assert_eq!(reports(&found), [""; 0]);
}
