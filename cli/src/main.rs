//! `flexair`, the command line of flexible-aircraft.
fn main() {}
