//! A swept wing of composites that twists as it bends, at all levels of fidelity: with wash-out its root is bent less.
//!
//! [theory: coupled-sections.energy, coupled-sections.mirrored]

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Fidelity};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::{ModeFamily, ReducedModel};

use super::record::Record;

/// Wings of 7 m, swept by 30°, and a body with a tail, written for the right side.
const SWEPT: &str = r#"
format = 1
name = "Swept composite wing"
support = "free"
mode_basis = "bending_torsion"
airspeed_m_s = 60
altitude_m = 1000
symmetric = true

[[control]]
name = "elevator"
positive = "nose-down"
mirror = "same"
trim = "pitch"

[[component]]
name = "wing_right"
mirror = "wing_left"
attached_to = "origin"
axis_m = [[0, 0, 0], [-4, 7, -0.4]]
elements = 10
y_axis = [1, 0, 0]
chord_m = { at = [0, 1], values = [1.4, 0.7] }
EA_N = 2e7
GJ_N_m2 = { root = 1e6, chord_power = 3 }
EI_y_N_m2 = { root = 1e6, chord_power = 3 }
EI_z_N_m2 = { multiple_of = "EI_y_N_m2", factor = 20 }
COUPLING

[[component.distributed_mass]]
parts = [{ total_kg = 90, chord_power = 2 }]
offset_chords = [-0.05, 0, 0]
gyration_chords = [0, 0.25, 0.25]
gyration_lengths = [0.2887, 0, 0.2887]

[[component.surface]]
elastic_axis = 0.35
incidence_deg = 2
lift_slope_per_rad = 5
profile_drag = 0.01
leading_edge_suction = 0.8

[[component]]
name = "body"
attached_to = "origin"
axis_m = [[0, 0, 0], [-6, 0, 0]]
elements = 5
y_axis = [0, 1, 0]
EA_N = 1e8
GJ_N_m2 = 1e7
EI_y_N_m2 = 1e7
EI_z_N_m2 = 1e7

[[component.point_masses]]
at_m = [0, 3, 6]
mass_kg = [600, 60, 20]
offset_m = [-1.6, 0, 0.1]
gyration_m = [0.4, 0.9, 0.9]

[[component]]
name = "tail_right"
mirror = "tail_left"
attached_to = { component = "body", at = 1 }
axis_m = [[0, 0, 0], [0, 2, 0]]
elements = 4
y_axis = [1, 0, 0]
chord_m = 0.8
EA_N = 1e7
GJ_N_m2 = 1e5
EI_y_N_m2 = 1e5
EI_z_N_m2 = 1e6

[[component.surface]]
elastic_axis = 0.4
lift_slope_per_rad = 4
profile_drag = 0.01
flap = { lift_slope_per_rad = 2, hinge = 0.6 }
control = [{ input = "elevator", gain = 1 }]

[[engine]]
name = "nose"
component = "body"
at_m = 0
offset_m = [1, 0, 0]
direction = [1, 0, 0]

[[station]]
name = "tip_right"
component = "wing_right"
at = 1

[[station]]
name = "tip_left"
component = "wing_left"
at = 1

[[cut]]
name = "root"
component = "wing_right"
at = 0
"#;

/// Of bending and torsion, as a share of the geometric mean of their stiffnesses.
fn model(share: f64, more: &str) -> Arc<ReducedModel> {
    let coupling = format!("bend_twist_y_N_m2 = {{ multiple_of = \"EI_y_N_m2\", factor = {share} }}\n{more}");
    let text = SWEPT.replace("COUPLING", &coupling);
    let aircraft = Aircraft::parse(&text, "swept.toml").unwrap_or_else(|error| panic!("{error}"));
    Arc::new(ReducedModel::new(&aircraft, 16).unwrap())
}

const LEVELS: [Fidelity; 6] = [
    Fidelity::Exact,
    Fidelity::ConsistentlyLinearised,
    Fidelity::Inconsistent,
    Fidelity::RuthlesslyLinearised,
    Fidelity::Rigid,
    Fidelity::GeometricallyExact,
];

/// Bending at the root and twist at the tip, nose-up, rad, in trim; then half a second of flight.
fn flown(model: &Arc<ReducedModel>, fidelity: Fidelity) -> [f64; 2] {
    let usual = PlantSettings::of(model);
    let settings: Settings = PlantSettings { fidelity, mode_count: 16, ..usual }.into();
    let mut flight = Simulation::new(Arc::clone(model), &settings, 0.0).unwrap();
    let instant = flight.instant_with_loads();
    let bending = instant.outputs.loads.known().unwrap()[0].bending;
    let twists = [0, 1].map(|tip: usize| instant.outputs.deflections[tip].twist);
    assert!((twists[0] - twists[1]).abs() < 1e-9 * (1.0 + twists[0].abs()), "{twists:?}");
    let zero = Inputs::zero(model);
    flight.set_inputs(&Inputs { controls: vec![0.02], ..zero.clone() }, &zero);
    flight.advance_to(0.5).unwrap();
    [bending, twists[0]]
}

#[test]
fn bending_that_turns_the_nose_down_takes_load_off_the_root_at_all_levels() {
    let mut record = Record::new(
        "wash-out",
        "Swept wing in level flight at 60 m/s: root bending with bend–twist coupling of ± 0.5 √(EI·GJ), over that without; twist of the tip \
         by the coupling, 1e-3 rad",
        "wash-out moves lift inboard, wash-in outboard; without modes nothing changes",
    );
    let [out, none, inwards] = [0.5, 0.0, -0.5].map(|share| model(share, ""));
    for model in [&out, &none, &inwards] {
        assert!(model.modes.iter().all(|mode| mode.family != ModeFamily::Unsymmetric));
    }
    for fidelity in LEVELS {
        let [[less, down], [usual, level], [more, up]] =
            [&out, &none, &inwards].map(|model| flown(model, fidelity));
        let symbol = fidelity.symbol();
        if fidelity == Fidelity::Rigid {
            record.rounding(
                &format!("{symbol}: bending"),
                1e-12,
                (less / usual - 1.0).abs().max((more / usual - 1.0).abs()),
            );
            continue;
        }
        record.at_most(&format!("{symbol}: bending, wash-out"), 0.97, less / usual);
        record.at_least(&format!("{symbol}: bending, wash-in"), 1.03, more / usual);
        record.at_most(&format!("{symbol}: twist, wash-out"), -10.0, 1e3 * (down - level));
        record.at_least(&format!("{symbol}: twist, wash-in"), 10.0, 1e3 * (up - level));
    }
    record.finish();
}

#[test]
fn a_wing_with_all_couplings_and_a_hinge_is_the_image_of_the_other() {
    let more = "EI_yz_N_m2 = { multiple_of = \"EI_y_N_m2\", factor = 0.7 }\nbend_twist_z_N_m2 = { multiple_of = \"EI_y_N_m2\", factor = -0.3 }\n\
                tension_axis_y_m = -0.05\ntension_axis_z_m = 0.02\nshear_centre_y_m = 0.04\nshear_centre_z_m = -0.01\n\
                hinge = { stiffnesses_N_m_per_rad = [4e6, 3e6, 2e7] }";
    let model = model(0.3, more);
    assert!(model.modes.iter().all(|mode| mode.family != ModeFamily::Unsymmetric));
    for fidelity in LEVELS {
        flown(&model, fidelity);
    }
}
