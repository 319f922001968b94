//! Any text as a Nastran deck: it is refused with words, or becomes an aircraft file that the library reads.

#![no_main]

use flexair::import::nastran;
use flexible_aircraft::Aircraft;
use flexible_aircraft_fuzz as support;
use libfuzzer_sys::fuzz_target;

const PARTS: [&str; 4] = [
    include_str!("../../examples/nastran/fuselage.bdf"),
    include_str!("../../examples/nastran/wing.bdf"),
    include_str!("../../examples/nastran/tails.bdf"),
    include_str!("../../examples/nastran/aero.bdf"),
];

fn seed() {
    let whole = format!("MAT1,1,7.1+10,,.33,2780.\n{}", PARTS.concat());
    support::seed("nastran_deck", "transport", whole.as_bytes());
    let stick = "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,.01,1.-4,4.-4,1.-4\nGRID,1,,0.,0.,0.\nGRID,2,,0.,3.,0.\nCBAR,1,1,1,2,0.,0.,1.\nSPC1,1,123456,1\n";
    support::seed("nastran_deck", "stick", stick.as_bytes());
}

fuzz_target!(init: seed(), |text: &str| {
    match nastran::of_text(text) {
        Ok(imported) => assert!(Aircraft::parse(imported.text(), "fuzzed.toml").is_ok()),
        // What the library refuses names a file that nobody has.
        Err(nastran::Error::NotRead(error)) => panic!("{error}"),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});
