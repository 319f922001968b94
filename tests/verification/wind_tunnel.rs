//! A clamped wing in a wind tunnel: no rigid-body motion, the air moves.

use std::sync::Arc;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::simulation::{Inputs, Settings, Simulation};
use flexible_aircraft::structure::ReducedModel;

use super::record::Record;

/// A uniform half wing of 6 m, elastic axis and centre of mass at mid-chord.
const WING: &str = r#"
format = 1
name = "Half wing"
gravity_m_s2 = 0.0
support = "clamped"
mode_basis = "bending_torsion"

[[component]]
name = "wing"
attached_to = "origin"
axis_m = [[0.0, 0.0, 0.0], [0.0, 6.0, 0.0]]
elements = 12
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
elastic_axis = 0.5
lift_slope_per_rad = 6.283185307179586
profile_drag = 0.0
incidence_deg = 2.0

[[station]]
name = "tip"
component = "wing"
at = 1.0
"#;

fn wing() -> Arc<ReducedModel> {
    let wing = Aircraft::parse(WING, "wing.toml").unwrap();
    Arc::new(ReducedModel::new(&wing, 6).unwrap())
}

fn settings(airspeed: f64) -> Settings {
    Settings { airspeed, altitude: 0.0, mode_count: 6, ..Settings::default() }
}

#[test]
fn the_clamped_wing_stands_still_bends_up_and_shows_the_tunnels_flow() {
    let mut flight = Simulation::new(wing(), &settings(20.0), 0.0).unwrap();
    flight.advance_to(5.0).unwrap();
    let outputs = flight.outputs();
    assert_eq!(outputs.position.x, 0.0);
    assert_eq!((outputs.velocity.norm(), outputs.rate.norm(), outputs.acceleration.norm()), (0.0, 0.0, 0.0));
    assert!((outputs.air.speed - 20.0).abs() < 1e-12 && outputs.air.angle_of_attack.abs() < 1e-12);
    assert!(-outputs.deflections[0].displacement.z > 0.0);
    assert!(outputs.deflections[0].twist > 0.0);
}

#[test]
fn static_twist_is_that_of_the_divergence_problem() {
    // Bisplinghoff, Ashley, Halfman, Aeroelasticity (1955), §8-2: a uniform wing under strip theory with its
    // aerodynamic centre a distance e ahead of the elastic axis twists by α₀ (1/cos λl − 1) at the tip,
    // λ² = q c e CLα / GJ. Six modes of a wing without bending–torsion coupling hold three of torsion.
    let (speed, length, chord) = (25.0, 6.0, 1.0);
    let pressure = 0.5 * 1.225 * speed * speed;
    let lambda = libm::sqrt(pressure * chord * 0.25 * std::f64::consts::TAU / 1e5);
    let expected = f64::to_radians(2.0) * (1.0 / libm::cos(lambda * length) - 1.0);
    let mut flight = Simulation::new(wing(), &settings(speed), 0.0).unwrap();
    let twist = flight.outputs().deflections[0].twist;
    let mut record = Record::new(
        "divergence",
        "Static tip twist of a uniform wing near divergence, rad",
        "α₀ (1/cos λl − 1), λ² = qceCLα/GJ: Bisplinghoff, Ashley, Halfman, *Aeroelasticity* (1955), §8-2; \
         three torsion modes carry the twist",
    );
    record.relative("25 m/s at sea level, λl = 0.85", expected, 0.02, twist);
    record.finish();
}

#[test]
fn a_gust_shakes_the_wing_and_it_settles_again() {
    let mut flight = Simulation::new(wing(), &settings(20.0), 0.0).unwrap();
    let tip = |flight: &mut Simulation| -flight.outputs().deflections[0].displacement.z;
    let steady = tip(&mut flight);
    let mut gust = Inputs::zero(0);
    gust.wind.z = -1.0;
    flight.set_inputs(&gust, &Inputs::zero(0));
    flight.advance_to(0.2).unwrap();
    let shaken = tip(&mut flight);
    assert!(shaken > 1.2 * steady, "{shaken} {steady}");
    flight.set_inputs(&Inputs::zero(0), &Inputs::zero(0));
    flight.advance_to(30.0).unwrap();
    assert!((tip(&mut flight) / steady - 1.0).abs() < 1e-3);
}
