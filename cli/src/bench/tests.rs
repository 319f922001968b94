use std::path::Path;

use flexible_aircraft_packaging::c_abi::Fmu;
use flexible_aircraft_packaging::{Package, Platform};

use super::equations::{Size, multiplications};
use super::standard_flight::{errors, fly};

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
    Package { aircraft, mode_count: 26, binaries, workspace }.write(&output).unwrap();
    let fmu = Fmu::open(&output).unwrap();
    (folder, fmu)
}

#[test]
fn the_standard_flight_keeps_its_tolerance_and_its_bits() {
    let (_folder, fmu) = jet();
    let exact = fly(&fmu, 1e-10, 1, |_| {}).unwrap();
    let usual = fly(&fmu, TOLERANCE, 1, |_| {}).unwrap();
    let found = errors(&usual.history, &exact.history);
    assert!(found.iter().all(|error| *error < 1e-5 && *error > 0.0), "{found:?}");
    let mut steps = 0;
    let in_parts = fly(&fmu, TOLERANCE, 10, |_| steps += 1).unwrap();
    assert_eq!(steps, 15_000);
    assert_eq!(usual.history, in_parts.history);
}

#[test]
fn multiplications_grow_linearly_with_strips_and_are_those_of_the_formulas() {
    let of = |strips, symmetric, antisymmetric, inflow_states| {
        multiplications(&Size {
            strips,
            in_plane: 0,
            edge_on: 0,
            rigid: 6,
            symmetric,
            antisymmetric,
            inflow_states,
        })
    };
    assert_eq!(of(200, 6, 6, 5) - of(100, 6, 6, 5), of(300, 6, 6, 5) - of(200, 6, 6, 5));
    // Two symmetric modes: K₀ has 4 entries, D 2 · 3, F 3 · 3, and there are 3 products q_a q_b, each of which becomes
    // forces on two modes; 15 tensors of the inertia with 2 · 2 numbers; 8 unknowns.
    assert_eq!(of(0, 2, 0, 0), 4 + 6 + 9 + 3 * 3 + 15 * 4 + 30 * 2 + 512 / 6 + 64);
}
