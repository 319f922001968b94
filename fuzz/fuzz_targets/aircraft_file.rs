//! Any text as an aircraft file: it is refused with diagnostics, or becomes an aircraft that can be reduced and flown.

#![no_main]

use flexible_aircraft::aircraft::{Aircraft, AircraftFileError};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft_fuzz as support;
use libfuzzer_sys::fuzz_target;

/// Larger aircraft take too long to reduce for a fuzzer; they differ in nothing else.
const BEAMS: usize = 24;

fuzz_target!(init: support::seed("aircraft_file", "seed", support::WING.as_bytes()), |text: &str| {
    match Aircraft::parse(text, "fuzzed.toml") {
        Ok(aircraft) if aircraft.beams.len() <= BEAMS => {
            if let Ok(model) = ReducedModel::new(&aircraft, 4) {
                support::fly(model);
            }
        }
        Ok(_) => {}
        Err(error) => {
            assert!(!error.to_string().is_empty());
            if let AircraftFileError::Rejected { diagnostics, .. } = error {
                assert!(!diagnostics.is_empty());
            }
        }
    }
});
