//! A swept wing of composites that twists as it bends, at all levels of fidelity: with wash-out its root is bent less.
//!
//! [theory: coupled-sections.energy, coupled-sections.mirrored]

use std::sync::Arc;

use flexible_aircraft::air::Air;
use flexible_aircraft::aircraft::{Aircraft, Fidelity};
use flexible_aircraft::equations::SectionLoads;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::{ModeFamily, ReducedModel};

use super::record::Record;
use crate::support::wash_out::Wing;

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

/// Of bending and torsion, as a share of the geometric mean of their stiffnesses; and what else a wing has.
pub fn swept(share: f64, more: &str) -> Aircraft {
    let coupling = format!("bend_twist_y_N_m2 = {{ multiple_of = \"EI_y_N_m2\", factor = {share} }}\n{more}");
    let text = SWEPT.replace("COUPLING", &coupling);
    Aircraft::parse(&text, "swept.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn model(share: f64, more: &str) -> Arc<ReducedModel> {
    Arc::new(ReducedModel::new(&swept(share, more), 16).unwrap())
}

/// All others, and a hinge.
pub const ALL_COUPLINGS: &str = r#"
EI_yz_N_m2 = { multiple_of = "EI_y_N_m2", factor = 0.7 }
bend_twist_z_N_m2 = { multiple_of = "EI_y_N_m2", factor = -0.3 }
tension_axis_y_m = -0.05
tension_axis_z_m = 0.02
shear_centre_y_m = 0.04
shear_centre_z_m = -0.01
hinge = { stiffnesses_N_m_per_rad = [4e6, 3e6, 2e7] }
"#;

pub const LEVELS: [Fidelity; 6] = [
    Fidelity::Exact,
    Fidelity::ConsistentlyLinearised,
    Fidelity::Inconsistent,
    Fidelity::RuthlesslyLinearised,
    Fidelity::Rigid,
    Fidelity::GeometricallyExact,
];

/// Loads at the cuts and the twist of the right tip, nose-up, rad, in trim; then half a second of flight.
fn flown(model: &Arc<ReducedModel>, fidelity: Fidelity) -> (Vec<SectionLoads>, f64) {
    let usual = PlantSettings::of(model);
    let settings: Settings = PlantSettings { fidelity, mode_count: 16, ..usual }.into();
    let mut flight = Simulation::new(Arc::clone(model), &settings, 0.0).unwrap();
    let instant = flight.instant_with_loads();
    let loads = instant.outputs.loads.known().unwrap().to_vec();
    let twists = [0, 1].map(|tip: usize| instant.outputs.deflections[tip].twist);
    assert!((twists[0] - twists[1]).abs() < 1e-9 * (1.0 + twists[0].abs()), "{twists:?}");
    let zero = Inputs::zero(model);
    flight.set_inputs(&Inputs { controls: vec![0.02], ..zero.clone() }, &zero);
    flight.advance_to(0.5).unwrap();
    (loads, twists[0])
}

#[test]
fn bending_that_turns_the_nose_down_takes_load_off_the_root_at_all_levels() {
    let mut record = Record::new(
        "wash-out",
        "Swept wing in level flight at 60 m/s: root bending with bend–twist coupling of ± 0.5 √(EI·GJ), over that without; twist of the tip \
         by the coupling, 1e-3 rad",
        "statics of a beam under strips, in `support/wash_out.rs`: lift of the strips that the coupling turns, by the inverse of the section's stiffness, to the \
         first order, from the loads of the wing without; a tail at x = −6 m keeps the balance. Twists differ by what modes and first order leave \
         out. E bends less, held by tension that superposed displacements make [theory: section-loads.not-by-modes]: it has part of it",
    );
    let aircraft = [0.5, 0.0, -0.5].map(|share| {
        let mut aircraft = swept(share, "");
        aircraft.cuts = aircraft.cuts_along("wing_right").unwrap();
        aircraft
    });
    let models = aircraft.each_ref().map(|aircraft| Arc::new(ReducedModel::new(aircraft, 16).unwrap()));
    assert!(models.iter().flat_map(|model| &model.modes).all(|mode| mode.family != ModeFamily::Unsymmetric));
    let pressure = 0.5 * Air::at(1000.0).density * 60.0 * 60.0;
    for fidelity in LEVELS {
        let [out, none, inwards] = models.each_ref().map(|model| flown(model, fidelity));
        let symbol = fidelity.symbol();
        for (name, share, (loads, twist)) in [("wash-out", 0.5, out), ("wash-in", -0.5, inwards)] {
            let ratio = loads[0].bending / none.0[0].bending;
            let turned = 1e3 * (twist - none.1);
            if fidelity == Fidelity::Rigid {
                record.rounding(&format!("{symbol}: bending, {name}"), 1e-12, ratio - 1.0);
                continue;
            }
            let [expected, tip] =
                Wing::new(&aircraft[1], "wing_right", pressure, share, &none.0).coupled(-6.0);
            let tip = 1e3 * tip;
            if fidelity == Fidelity::Exact {
                for (what, part) in [("bending", (ratio - 1.0) / (expected - 1.0)), ("twist", turned / tip)] {
                    record.at_least(&format!("{symbol}: {what}, {name}, part of it"), 0.5, part);
                    record.at_most(&format!("{symbol}: {what}, {name}, part of it"), 1.0, part);
                }
                continue;
            }
            record.relative(&format!("{symbol}: bending, {name}"), expected, 0.02, ratio);
            record.relative(&format!("{symbol}: twist, {name}"), tip, 0.2, turned);
        }
    }
    record.finish();
}

#[test]
fn a_wing_with_all_couplings_and_a_hinge_is_the_image_of_the_other() {
    let model = model(0.3, ALL_COUPLINGS);
    assert!(model.modes.iter().all(|mode| mode.family != ModeFamily::Unsymmetric));
    for fidelity in LEVELS {
        flown(&model, fidelity);
    }
}
