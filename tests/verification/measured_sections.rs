//! Sections whose moment slope was measured, and flaps whose moment and drag were [theory: air-loads.moment-slope, air-loads.drag].

use std::f64::consts::TAU;
use std::sync::Arc;

use flexible_aircraft::air::Air;
use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{Course, LinearInput, Plant, PlantSettings};
use flexible_aircraft::structure::{ReducedModel, ReducedStrip};

use crate::support::strip::{PrescribedStrip, SEMICHORD, SPEED};
use crate::support::{ELEVATOR, jet};

use super::record::Record;

/// A half wing of 6 m with a chord of 1 m in a wind tunnel; what its sections are is put in.
const WING: &str = r#"
format = 1
name = "Half wing"
gravity_m_s2 = 0.0
support = "clamped"
mode_basis = "bending_torsion"
model = "exact"
airspeed_m_s = 25.0
altitude_m = 0.0

[[component]]
name = "wing"
attached_to = "origin"
axis_m = [[0.0, 0.0, 0.0], [0.0, 6.0, 0.0]]
elements = 24
y_axis = [1.0, 0.0, 0.0]
EA_N = 1e9
GJ_N_m2 = 1e5
EI_y_N_m2 = 1e5
EI_z_N_m2 = 4e6
chord_m = 1.0

[[component.distributed_mass]]
parts = [{ total_kg = 60.0, chord_power = 0.0 }]
gyration_chords = [0.01, 0.3, 0.3]

[[component.surface]]
lift_slope_per_rad = 6.283185307179586
profile_drag = 0.0
incidence_deg = 2.0
"#;

const TIP: &str = "\n[[station]]\nname = \"tip\"\ncomponent = \"wing\"\nat = 1.0\n";

/// The static twist of the tip, rad, with more said about the sections.
fn twist(fidelity: Fidelity, sections: &str) -> f64 {
    let wing = Aircraft::parse(&format!("{WING}{sections}{TIP}"), "wing.toml").unwrap();
    let model = Arc::new(ReducedModel::new(&wing, 16).unwrap());
    let settings = PlantSettings { fidelity, mode_count: 16, ..PlantSettings::of(&model) };
    Simulation::new(model, &Settings::from(settings), 0.0).unwrap().outputs().deflections[0].twist
}

#[test]
fn a_wing_diverges_by_the_aerodynamic_centre_that_its_moment_slope_says() {
    let mut record = Record::new(
        "divergence-moment-slope",
        "Static tip twist of a uniform wing whose aerodynamic centre is not at the quarter chord, rad",
        "α₀ (1/cos λl − 1), λ² = qceCLα/GJ with e from the aerodynamic centre to the elastic axis, (¼ + c_mα/CLα) chords: \
         Bisplinghoff, Ashley, Halfman, *Aeroelasticity* (1955), §8-2; and the wing whose elastic axis is as far from the quarter chord",
    );
    let pressure = 0.5 * density() * 25.0 * 25.0;
    for (slope, fidelity) in
        [(-0.9, Fidelity::Exact), (0.2, Fidelity::Exact), (-0.9, Fidelity::GeometricallyExact)]
    {
        let arm = 0.25 + slope / TAU;
        let lambda = libm::sqrt(pressure * arm * TAU / 1e5);
        let expected = f64::to_radians(2.0) * (1.0 / libm::cos(lambda * 6.0) - 1.0);
        let found = twist(fidelity, &format!("elastic_axis = 0.5\nmoment_slope = {slope}\n"));
        let case = format!("{}, c_mα = {slope}", fidelity.name().replace('_', " "));
        record.relative(&case, expected, 0.02, found);
        let moved = twist(fidelity, &format!("elastic_axis = {}\n", 0.5 + slope / TAU));
        record.relative(&format!("{case}, and the other wing"), moved, 1e-9, found);
    }
    record.finish();
}

/// At sea level, kg/m³.
fn density() -> f64 {
    Air::at(0.0).density
}

/// A section with its elastic axis at 0.15 chords behind mid-chord, and so many inflow states.
fn section(inflow_states: usize, alter: impl FnOnce(&mut ReducedStrip)) -> PrescribedStrip {
    PrescribedStrip::altered(inflow_states, 0.3, 0.0, 0.8, alter)
}

#[test]
fn the_moment_follows_the_wake_as_a_lift_ahead_of_the_quarter_chord_would() {
    let slope = 0.7;
    let mut strip = section(5, |strip| strip.moment_slope = slope);
    strip.move_with(0.04 * SPEED, 0.3);
    let ([_, down, moment], _) = strip.evaluate();
    let inflow = strip.inflow();
    for (place, state) in strip.state[inflow].iter_mut().enumerate() {
        *state = 0.3 - 0.1 * place as f64;
    }
    let ([_, down_in_wake, moment_in_wake], _) = strip.evaluate();
    // What the wake changes of the lift acts b/2 + d ahead of the elastic axis, and c_mα/CLα chords more.
    let arm = SEMICHORD * (0.5 + 0.3) + slope / TAU * 2.0 * SEMICHORD;
    let (lift, pitching) = (down - down_in_wake, moment_in_wake - moment);
    assert!(lift.abs() > 0.1 && (pitching / (lift * arm) - 1.0).abs() < 1e-12, "{pitching} {}", lift * arm);
}

#[test]
fn without_lift_a_section_still_has_its_moment_slope() {
    let mut strip = section(0, |strip| {
        (strip.lift_slope, strip.moment_slope, strip.flap) = (0.0, 0.5, None);
    });
    strip.move_with(0.04 * SPEED, 0.0);
    let ([_, _, moment], _) = strip.evaluate();
    let expected = 2.0 * 0.5 * density() * SEMICHORD * SEMICHORD * SPEED * (0.04 * SPEED);
    assert!((moment / expected - 1.0).abs() < 1e-12, "{moment} {expected}");
}

#[test]
fn a_flap_drags_by_the_square_of_its_angle_against_the_flow() {
    let forces = |drag: f64, angles: [f64; 2]| {
        let mut strip = section(0, |strip| {
            let flap = strip.flap.as_mut().unwrap();
            (flap.drag, flap.gains) = (drag, vec![1.0, -0.4]);
        });
        strip.controls.angles.copy_from_slice(&angles);
        strip.move_with(0.3 * SPEED, 0.0);
        strip.evaluate().0
    };
    for angles in [[0.3, 0.0], [-0.2, 0.3], [0.2, 0.5]] {
        let [plain, dragging] = [0.0, 1.5].map(|drag| forces(drag, angles));
        let delta = angles[0] - 0.4 * angles[1];
        let speed = SPEED * libm::sqrt(1.0 + 0.3 * 0.3);
        let drag = 1.5 * delta * delta * density() * SEMICHORD * speed;
        for (axis, velocity) in [SPEED, 0.3 * SPEED].into_iter().enumerate() {
            let found = plain[axis] - dragging[axis];
            // The two forces are differences of forces of the strip's size.
            let size = plain[0].hypot(plain[1]);
            assert!((found - drag * velocity).abs() < 1e-12 * size, "{found} of {size}");
        }
        assert_eq!(plain[2], dragging[2]);
    }
}

#[test]
fn a_flap_with_a_moment_of_its_own_has_that_and_the_arm_of_its_lift() {
    let moment = |slope: Option<f64>| {
        let mut strip = section(0, |strip| strip.flap.as_mut().unwrap().moment_slope = slope);
        let at_rest = strip.evaluate().0;
        strip.controls.angles[0] = 0.2;
        let ([_, down, moment], _) = strip.evaluate();
        (moment - at_rest[2]) - SEMICHORD * (0.5 + 0.3) * (at_rest[1] - down)
    };
    let coefficient = -0.55;
    let expected = 2.0 * coefficient * density() * SEMICHORD * SEMICHORD * SPEED * SPEED * 0.2;
    assert!((moment(Some(coefficient)) / expected - 1.0).abs() < 1e-12);
    assert!((moment(None) / expected - 1.0).abs() > 0.1);
}

#[test]
fn linear_models_have_the_slope_of_the_drag_at_the_flap_angle_of_the_trim() {
    let settings = PlantSettings { fidelity: Fidelity::Rigid, inflow_states: 0, ..PlantSettings::of(&jet()) };
    let plant = |drag: f64| {
        let mut model = (*jet()).clone();
        for flap in model.strips.iter_mut().filter_map(|strip| strip.flap.as_mut()) {
            flap.drag = if flap.gains[ELEVATOR] == 0.0 { 0.0 } else { drag };
        }
        Plant::under(&model, &settings).unwrap()
    };
    let [plain, dragging] = [0.0, 1.5].map(plant);
    let trim = plain.trim(&settings.trim_condition()).unwrap();
    // What k adds to the effect of the elevator on the forward acceleration, 1/s² m, with the elevator elsewhere.
    let added = |angle: f64| {
        let mut trim = trim.clone();
        trim.controls.angles[ELEVATOR] = angle;
        let [one, other] = [&dragging, &plain].map(|plant| {
            let model = plant.linear_model(&trim, Course::NORTH, |outputs| vec![outputs.acceleration.x]);
            let column = model.inputs.iter().position(|input| *input == LinearInput::Control(ELEVATOR));
            model.d[(0, column.unwrap())]
        });
        one - other
    };
    let [at_rest, down, up] = [0.0, 0.2, -0.1].map(added);
    assert!(down < -0.1, "{down}");
    assert!(at_rest.abs() < 1e-8 * down.abs(), "{at_rest} {down}");
    assert!((up / down + 0.5).abs() < 1e-8, "{up} {down}");
}
