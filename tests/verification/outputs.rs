//! Outputs beside the state: the load factor at the centre of mass, quaternions, places in space, the path
//! [theory: outputs.centre-of-mass, outputs.placement, outputs.path, outputs.load-factor].

use std::f64::consts::{PI, TAU};

use flexible_aircraft::equations::{Fidelity, Mechanics};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::math::Attitude;
use flexible_aircraft::plant::{Outputs, Plant, PlantSettings};
use nalgebra::Vector3;

use crate::support::{AILERON, RUDDER, derivative, jet, soft};

use super::strip_loads::disturbed;

#[test]
fn the_load_factor_at_the_centre_of_mass_is_that_of_the_momentum() {
    let model = jet().select(&(0..12).collect::<Vec<_>>());
    for fidelity in [Fidelity::Exact, Fidelity::Inconsistent, Fidelity::GeometricallyExact] {
        let plant = Plant::new(&model, &soft(fidelity)).unwrap();
        for seed in 0..3 {
            let (state, controls) = disturbed(plant.equations(), seed);
            let mut rates = vec![0.0; state.len()];
            plant.rates(&state, &controls, &mut rates, &mut plant.workspace());
            let momentum = |axis: usize| {
                derivative(1e-4, |time| {
                    let then: Vec<f64> = state.iter().zip(&rates).map(|(x, rate)| x + time * rate).collect();
                    Mechanics::new(plant.equations(), &then).linear_momentum[axis]
                })
            };
            let force = Vector3::new(momentum(0), momentum(1), momentum(2));
            let acceleration = force / model.integrals.mass - Vector3::z() * model.gravity;
            let to_body = Attitude::from_quaternion(&state[plant.layout().attitude()]).body_from_inertial;
            let expected = to_body * acceleration / model.gravity;
            let expected = Vector3::new(expected.x, expected.y, -expected.z);
            let found = plant.outputs_at(&state, &controls, &mut plant.workspace());
            let apart = (found.load_factor_cg - expected).norm() / expected.norm();
            assert!(apart < 1e-8, "{fidelity:?}: {apart:e}, {expected}");
            assert!((found.load_factor - expected).norm() > 1e-3 * expected.norm());
        }
    }
}

#[test]
fn in_level_flight_the_load_factor_across_the_flow_is_one_everywhere() {
    for fidelity in Fidelity::ALL {
        let settings = PlantSettings { fidelity, ..PlantSettings::of(&jet()) };
        let mut flight = Simulation::new(jet(), &settings.into(), 0.0).unwrap();
        let outputs = flight.outputs();
        assert!((outputs.lift_load_factor - 1.0).abs() < 1e-7, "{fidelity:?}");
        assert!((outputs.load_factor_cg - outputs.load_factor).norm() < 1e-7, "{fidelity:?}");
        assert!(outputs.angular_acceleration.norm() < 1e-7 && outputs.path.climb_angle.abs() < 1e-12);
    }
}

/// Whether a quaternion turns as the Euler angles do.
fn turns_alike(outputs: &Outputs) -> bool {
    let [roll, pitch, yaw] = [outputs.attitude.x, outputs.attitude.y, outputs.attitude.z];
    let turn = nalgebra::Rotation3::from_euler_angles(roll, pitch, yaw).into_inner();
    let found = Attitude::from_quaternion(&outputs.quaternion).body_from_inertial.transpose();
    (found - turn).norm() < 1e-12
}

#[test]
fn quaternions_are_continuous_and_begin_with_a_scalar_that_is_not_negative() {
    for heading in [0.0, 3.0, PI, -PI, 4.0, TAU, -9.0] {
        let settings = PlantSettings { fidelity: Fidelity::Rigid, heading, ..PlantSettings::of(&jet()) };
        let mut flight = Simulation::new(jet(), &settings.into(), 0.0).unwrap();
        assert!(flight.outputs().quaternion[0] >= 0.0, "{heading}");
        let mut before = flight.outputs().quaternion;
        let mut inputs = Inputs::zero(&jet());
        (inputs.controls[AILERON], inputs.controls[RUDDER]) = (0.02, 0.05);
        flight.set_inputs(&inputs, &Inputs::zero(&jet()));
        for step in 1..=60 {
            flight.advance_to(0.1 * f64::from(step)).unwrap();
            let outputs = flight.outputs();
            assert!(turns_alike(outputs), "{heading}");
            let moved: f64 = before.iter().zip(&outputs.quaternion).map(|(a, b)| (a - b).powi(2)).sum();
            assert!(moved.sqrt() < 0.1, "{heading}");
            before = outputs.quaternion;
        }
    }
}

#[test]
fn stations_are_where_the_body_has_them_and_turned_as_their_sections() {
    let settings = Settings::from(PlantSettings {
        fidelity: Fidelity::GeometricallyExact,
        stiffness_scale: 0.1,
        heading: 2.0,
        ..PlantSettings::of(&jet())
    });
    let mut flight = Simulation::new(jet(), &settings, 0.0).unwrap();
    let outputs = flight.outputs();
    let to_inertial = Attitude::from_quaternion(&outputs.quaternion).body_from_inertial.transpose();
    for (index, station) in jet().stations.iter().enumerate() {
        let (placement, displacement) = (&outputs.placements[index], outputs.deflections[index].displacement);
        let expected = outputs.position + to_inertial * (station.position + displacement);
        assert!((placement.position - expected).norm() < 1e-9, "{}", station.name);
        // An accelerometer in level flight reads what holds the section up, in its own axes.
        let turn = Attitude::from_quaternion(&placement.quaternion).body_from_inertial;
        let reading = turn * Vector3::new(0.0, 0.0, -jet().gravity);
        assert!((reading - outputs.sensors[index].specific_force).norm() < 1e-5, "{}", station.name);
    }
}
