//! The jet's flutter of fuselage and tailplane wants many natural modes, or few with load modes
//! [theory: load-modes.loads, stability.crossings].

use flexible_aircraft::aircraft::{Aircraft, Fidelity};
use flexible_aircraft::plant::{ModeSelection, PlantSettings};
use flexible_aircraft::stability::{CrossingKind, Sweep};
use flexible_aircraft::structure::{ModeCount, ModeKind, ReducedModel};

use super::load_modes::jet;
use super::record::Record;

/// Symmetric natural modes, whether with their four load modes; airspeed of the flutter, m/s, and a unit of its last digit.
const FLUTTER: [(usize, bool, f64, f64); 6] = [
    (8, true, 166.1, 0.1),
    (12, true, 167.2, 0.1),
    (8, false, 224.0, 1.0),
    (12, false, 196.0, 1.0),
    (16, false, 192.0, 1.0),
    (24, false, 167.0, 1.0),
];

/// Angular frequency of the flutter with many modes, rad/s.
const FREQUENCY: f64 = 14.7;

/// The lowest airspeed at which the jet begins to flutter within 8 m/s of one, m/s, and its angular frequency, rad/s.
fn flutter(mode_count: usize, load_modes: bool, near: f64) -> (f64, f64) {
    let aircraft = Aircraft { load_modes, ..jet() };
    let model = ReducedModel::with(&aircraft, ModeCount::Asked(mode_count), ModeKind::Symmetric).unwrap();
    let settings = PlantSettings {
        fidelity: Fidelity::GeometricallyExact,
        mode_selection: ModeSelection::Symmetric,
        mode_count,
        stiffness_scale: 0.1,
        inflow_states: 5,
        ..PlantSettings::of(&model)
    };
    let sweep = Sweep::new(&model, &settings, &[near - 8.0, near + 8.0]).unwrap();
    let is_flutter = |kind: &CrossingKind| *kind == CrossingKind::Flutter;
    let onset = sweep.crossings.iter().find(|crossing| is_flutter(&crossing.kind) && crossing.is_onset);
    onset.map(|onset| (onset.airspeed, onset.root.eigenvalue.im)).unwrap()
}

#[test]
fn with_load_modes_few_modes_find_the_flutter_of_many() {
    let mut record = Record::new(
        "load-modes-flutter",
        "Flutter of the jet without `aileron_symmetric` at one-tenth stiffness, GE, 7620 m, N = 5: airspeed, m/s, over the number of \
         symmetric modes",
        "an independent computation (with 40 modes: 167.3 m/s, 14.7 rad/s); a unit of its last digit",
    );
    for (count, load_modes, expected, digit) in FLUTTER {
        let loads = if load_modes { " + 4" } else { "" };
        let (speed, frequency) = flutter(count, load_modes, expected);
        record.absolute(&format!("{count}{loads} modes"), expected, digit, speed);
        if load_modes {
            record.absolute(&format!("{count}{loads} modes: frequency, rad/s"), FREQUENCY, 0.1, frequency);
        }
    }
    record.finish();
}
