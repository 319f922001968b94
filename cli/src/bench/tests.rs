use std::path::Path;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::fmi::Interface;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft_packaging::c_abi::Fmu;
use flexible_aircraft_packaging::{Licences, Package, Platform};

use super::equations::{EquationCosts, RightHandSide};
use super::options::Optional;
use super::report::Report;
use super::scaling::{Costs, GeometricallyExact, Point, Scaling};
use super::standard_flight::{Accuracy, Flown, StandardFlight, errors, fly};

/// The FMU's default.
const TOLERANCE: f64 = 1e-5;

/// The standard flight at a level.
fn flown(fmu: &Fmu, level: Fidelity) -> Flown<'_> {
    Flown { fmu, level, control: "elevator", station: "wing_tip_right", parameters: &[] }
}

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
        interface: Interface::USUAL,
        aircraft,
        mode_count: 26.into(),
        load_modes: false,
        starts: Vec::new(),
        stations_along: Vec::new(),
        binaries,
        licences: Licences::Workspace(workspace),
        scene: None,
    }
    .write(&output)
    .unwrap();
    let fmu = Fmu::open(&output).unwrap();
    (folder, fmu)
}

#[test]
fn the_standard_flight_keeps_its_tolerance_and_its_bits() {
    let (_folder, fmu) = jet();
    let flown = flown(&fmu, Fidelity::Exact);
    let exact = fly(flown, 1e-10, 1, |_| {}).unwrap();
    let usual = fly(flown, TOLERANCE, 1, |_| {}).unwrap();
    let found = errors(&usual.history, &exact.history);
    assert!(found.iter().all(|error| *error < 1e-5 && *error > 0.0), "{found:?}");
    let mut steps = 0;
    let in_parts = fly(flown, TOLERANCE, 10, |_| steps += 1).unwrap();
    assert_eq!(steps, 15_000);
    assert_eq!(usual.history, in_parts.history);
}

#[test]
fn the_standard_flight_is_flown_at_the_level_that_is_asked_for() {
    let (_folder, fmu) = jet();
    let [exact, bending] = [Fidelity::Exact, Fidelity::GeometricallyExact]
        .map(|level| fly(flown(&fmu, level), TOLERANCE, 1, |_| {}).unwrap());
    let apart = errors(&bending.history, &exact.history);
    // Pitch, wing tip and load factor, as measured: the tip bends by a twentieth of the half span.
    for (apart, measured) in apart.iter().zip([2.3e-4, 6.1e-2, 2.9e-3]) {
        assert!((0.5..2.0).contains(&(apart / measured)), "{apart} {measured}");
    }
    let closer = fly(flown(&fmu, Fidelity::GeometricallyExact), 1e-8, 1, |_| {}).unwrap();
    let found = errors(&bending.history, &closer.history);
    assert!(found.iter().all(|error| *error < 2e-5 && *error > 0.0), "{found:?}");
}

fn points(what: &str, sizes: &[usize]) -> Vec<Point> {
    let costs = |size: usize| Costs { right_hand_side: 1e-6 * size as f64, time_per_second: 2e-3 };
    let point = |&size: &usize| Point {
        label: format!("{size} {what}"),
        size,
        half: costs(size),
        whole: costs(3 * size),
    };
    sizes.iter().map(point).collect()
}

/// Of costs that are made up.
fn report(model: &ReducedModel) -> Report<'_> {
    let accuracy = |tolerance, time_per_second| Accuracy { tolerance, time_per_second, errors: [2e-6; 3] };
    let flight = StandardFlight {
        accuracies: vec![accuracy(1e-5, 1e-3)],
        geometrically_exact: accuracy(1e-5, 4e-3),
        latencies: Vec::new(),
        instantiation: 1e-3,
        trim: 1e-3,
        same_bits: true,
    };
    let side = || RightHandSide { time: 2e-6, narrow_time: 8e-6, multiplications: 20_000 };
    let equations =
        EquationCosts { half: side(), whole: side(), plain_time_per_second: 0.1, most_multiplications: 3e10 };
    let scaling = Scaling {
        modes: points("modes", &[12]),
        strips: points("strips", &[99]),
        inflow_states: points("inflow states", &[5]),
        fidelity: points("levels", &[1]),
        geometrically_exact: GeometricallyExact {
            modes: points("modes", &[12, 20]),
            strips: points("strips", &[99, 198]),
            sections: points("sections", &[135, 207]),
        },
        memory: None,
    };
    let options = vec![Optional { name: "gust", accuracy: accuracy(1e-3, 2e-3) }];
    Report { model, control: "elevator", flight, options, equations, scaling }
}

#[test]
fn the_page_says_what_the_geometrically_exact_level_costs_over_modes_strips_and_sections() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/generic-business-jet.toml");
    let model = ReducedModel::new(&Aircraft::read(&path).unwrap(), 2).unwrap();
    let report = report(&model);
    let page = report.markdown();
    assert!(page.contains("nominal stiffness, exact model, 12 modes"), "{page}");
    let rows = "| 1e-5 | 0.00100 | 1000 | 2.0e-6 | 2.0e-6 | 2.0e-6 |\n\
                | geometrically exact, 1e-5 | 0.00400 | 250 | 2.0e-6 | 2.0e-6 | 2.0e-6 |\n\
                | plain method | 0.1000 | 10.0 | | | |\n";
    assert!(page.contains(rows), "{page}");
    assert!(
        page.contains("| --- |\n| gust, 1e-3 | 0.00200 | 500 | 2.0e-6 | 2.0e-6 | 2.0e-6 |\n\n"),
        "{page}"
    );
    let bending: Vec<&str> =
        page.split("\n\n").filter(|t| t.starts_with("| geometrically exact: ")).collect();
    for (table, (what, sizes)) in
        bending.iter().zip([("modes", [12, 20]), ("strips", [99, 198]), ("sections", [135, 207])])
    {
        assert!(table.starts_with(&format!("| geometrically exact: {what}")), "{table}");
        for size in sizes {
            let row = format!("| {size} {what} | {size}.00 | {}.00 | 2.00 | 2.00 |", 3 * size);
            assert!(table.contains(&row), "{row} in {table}");
        }
    }
    assert_eq!(bending.len(), 3);
    assert!(report.summary().contains("\ngeometrically exact, tolerance 1e-5: 250 times real time"));
}
