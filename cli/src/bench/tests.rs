use std::path::Path;

use flexible_aircraft_packaging::c_abi::Fmu;
use flexible_aircraft_packaging::{Package, Platform};

use super::standard_flight::{Flown, errors, fly};

/// The FMU's default.
const TOLERANCE: f64 = 1e-5;

/// The jet's FMU with the library that cargo built beside this test.
fn jet() -> (tempfile::TempDir, Fmu) {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("jet.fmu");
    let name = format!("{}flexible_aircraft{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let library = std::env::current_exe().unwrap().with_file_name(name);
    let binaries = vec![(Platform::host().unwrap(), library)];
    let aircraft = workspace.join("aircraft/generic-business-jet.toml");
    Package {
        aircraft,
        mode_count: 26.into(),
        load_modes: false,
        stations_along: Vec::new(),
        binaries,
        workspace,
    }
    .write(&output)
    .unwrap();
    let fmu = Fmu::open(&output).unwrap();
    (folder, fmu)
}

#[test]
fn the_standard_flight_keeps_its_tolerance_and_its_bits() {
    let (_folder, fmu) = jet();
    let flown = Flown { fmu: &fmu, control: "elevator", station: "wing_tip_right" };
    let exact = fly(flown, 1e-10, 1, |_| {}).unwrap();
    let usual = fly(flown, TOLERANCE, 1, |_| {}).unwrap();
    let found = errors(&usual.history, &exact.history);
    assert!(found.iter().all(|error| *error < 1e-5 && *error > 0.0), "{found:?}");
    let mut steps = 0;
    let in_parts = fly(flown, TOLERANCE, 10, |_| steps += 1).unwrap();
    assert_eq!(steps, 15_000);
    assert_eq!(usual.history, in_parts.history);
}
