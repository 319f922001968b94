//! Flights of the generic business jet: what must not depend on when, nor on where to.

mod devices;
mod sensors;

use std::sync::Arc;

use nalgebra::Vector3;

use crate::aircraft::Fidelity;
use crate::equations::evaluations;
use crate::plant::{ModeSelection, PlantSettings};
use crate::structure::test_jet::{AILERON, ELEVATOR, RUDDER, jet};

use super::inputs::Inputs;
use super::moment::Moment;
use super::settings::{InputReference, Settings};
use super::simulation::Simulation;

fn flight(settings: &Settings) -> Simulation {
    Simulation::new(
        Arc::new(jet().clone()),
        &Settings::from(PlantSettings { mode_count: 4, ..settings.plant }),
        0.0,
    )
    .unwrap()
}

/// What is flown depends on the time since the inputs were set, not on the time since the start: here a year.
#[test]
fn a_flight_goes_on_after_a_year_with_the_bits_of_its_first_second() {
    let [mut young, mut old] = [(); 2].map(|()| flight(&Settings::of(jet())));
    let year = 3.2e7;
    let now = Moment::after_start(year, 0.0);
    old.path.stand([(now, 1), (now, 1)]);
    old.steering.since = now;
    let mut rates = Inputs { wind_rate: Vector3::new(0.0, 0.0, 2.0), ..Inputs::zero(jet()) };
    rates.controls[ELEVATOR] = -0.3;
    for i in 0..60 {
        let mut inputs = rates.clone();
        inputs.controls[ELEVATOR] = 1e-3 * f64::from(i);
        for (flight, since) in [(&mut young, 0.0), (&mut old, year)] {
            flight.set_inputs(&inputs, &rates);
            flight.step(since + 0.01 * f64::from(i), 0.01).unwrap();
        }
        assert_eq!(young.outputs(), old.outputs(), "{i}");
    }
    assert!((old.time() - (year + 0.6)).abs() < 1e-8);
}

/// A wind of 9.7 m/s straight ahead, as a program computes it that knows the heading.
fn wind_ahead(heading: f64) -> Vector3<f64> {
    Vector3::new(9.7 * heading.cos(), 9.7 * heading.sin(), -1.0)
}

#[test]
fn wind_along_the_heading_leaves_half_the_aircraft_flying_whatever_the_heading() {
    let north = {
        let mut north = flight(&Settings::of(jet()));
        north.set_inputs(&Inputs { wind: wind_ahead(0.0), ..Inputs::zero(jet()) }, &Inputs::zero(jet()));
        north.advance_to(0.2).unwrap();
        north.outputs().clone()
    };
    for degrees in (0..360).step_by(30) {
        let heading = f64::from(degrees).to_radians();
        let wind = wind_ahead(heading);
        let mut flight = flight(&Settings::from(PlantSettings { heading, ..PlantSettings::of(jet()) }));
        let at_rest = Inputs::zero(jet());
        flight.set_inputs(&Inputs { wind, ..at_rest.clone() }, &at_rest);
        flight.advance_to(0.2).unwrap();
        assert!(flight.is_symmetric(), "{degrees} degrees");
        let found = flight.outputs();
        assert!((found.load_factor - north.load_factor).norm() < 1e-12, "{degrees} degrees");
        assert!(found.air.sideslip == 0.0 && found.velocity.y == 0.0, "{degrees} degrees");
        // Nor do its rates, alone and against each other, bring it out of symmetry, also where they cancel the wind.
        let inputs = Inputs { wind, wind_rate: -10.0 * wind, ..at_rest.clone() };
        flight.set_inputs(&inputs, &Inputs { wind: wind / 3.0, ..at_rest.clone() });
        flight.advance_to(0.4).unwrap();
        assert!(flight.is_symmetric() && flight.outputs().air.sideslip == 0.0, "{degrees} degrees");
        let aside = Vector3::new(1e-9 * heading.sin(), -1e-9 * heading.cos(), 0.0);
        flight.set_inputs(&Inputs { wind: wind + aside, ..at_rest.clone() }, &at_rest);
        flight.advance_to(0.5).unwrap();
        assert!(!flight.is_symmetric(), "{degrees} degrees");
    }
}

/// A law that holds the heading or shares a thrust out leaves such traces.
#[test]
fn thrusts_and_controls_that_differ_by_rounding_leave_half_the_aircraft_flying() {
    for input_reference in [InputReference::Trim, InputReference::Absolute] {
        let settings = Settings { input_reference, ..Settings::of(jet()) };
        let mut flight = flight(&settings);
        let trim = *flight.trim();
        let absolute = match input_reference {
            InputReference::Trim => Inputs::zero(jet()),
            InputReference::Absolute => Inputs {
                controls: trim.angles(&jet().controls).collect(),
                thrust: vec![trim.thrust; 2],
                ..Inputs::zero(jet())
            },
        };
        let mut set_and_fly = |change: fn(&mut Inputs, &mut Inputs), end: f64| {
            let (mut inputs, mut rates) = (absolute.clone(), Inputs::zero(jet()));
            change(&mut inputs, &mut rates);
            flight.set_inputs(&inputs, &rates);
            flight.advance_to(end).unwrap();
            flight.is_symmetric()
        };
        assert!(set_and_fly(|inputs, _| inputs.thrust[0] += 0.1 + 0.2 - 0.3, 0.1));
        assert!(set_and_fly(
            |inputs, rates| (inputs.thrust[1], rates.thrust[0]) = (inputs.thrust[0], 0.0),
            0.2
        ));
        assert!(set_and_fly(|_, rates| rates.thrust = vec![0.1 + 0.2, 0.3], 0.3));
        assert!(set_and_fly(
            |inputs, _| (inputs.controls[AILERON], inputs.controls[RUDDER]) = (2e-16, -4e-16),
            0.4
        ));
        assert!(!set_and_fly(|inputs, _| inputs.controls[RUDDER] = 1e-12, 0.5));
    }
}

/// Under inputs for which the half flies on, and under some that ask for the whole.
#[test]
fn a_plant_asked_at_the_state_of_a_flight_gives_its_outputs_bit_for_bit() {
    for (rudder, is_symmetric) in [(0.0, true), (0.02, false)] {
        let mut flight = flight(&Settings::of(jet()));
        let (mut inputs, rates) = (Inputs::zero(jet()), Inputs::zero(jet()));
        inputs.controls[ELEVATOR] = -0.02;
        inputs.controls[RUDDER] = rudder;
        inputs.wind = Vector3::new(2.0, 0.0, -1.0);
        flight.set_inputs(&inputs, &rates);
        flight.advance_to(0.3).unwrap();
        assert_eq!(flight.is_symmetric(), is_symmetric);
        let expected = flight.outputs().clone();
        let (plant, state) = (flight.flying.plant(), &flight.path.present.state);
        let (mut workspace, mut controls) = (plant.workspace(), plant.neutral_controls());
        // What another instant has left in the workspace does not matter.
        let mut elsewhere = state.clone();
        elsewhere[plant.layout().velocity()][0] *= 0.5;
        assert_ne!(plant.outputs_at(&elsewhere, &controls, &mut workspace), expected);
        let present = &flight.path.present;
        flight.steering.write_at(present.time, &present.acting, &mut controls);
        assert_eq!(plant.outputs_at(state, &controls, &mut workspace), expected);
        let (mut slope, mut outputs) = (vec![0.0; state.len()], plant.room_for_outputs());
        plant.rates_and_outputs(state, &controls, &mut slope, &mut outputs, &mut workspace);
        assert_eq!(outputs, expected);
        assert_eq!(flight.outputs_under(&inputs, &rates), expected);
    }
}

#[test]
fn asking_for_the_outputs_under_one_sided_inputs_leaves_the_half_flying() {
    let mut flight = flight(&Settings::of(jet()));
    let still = Inputs::zero(jet());
    let mut turned = still.clone();
    turned.controls[RUDDER] = 0.1;
    let asked = flight.outputs_under(&turned, &still);
    assert!(flight.is_symmetric() && asked.acceleration.y != 0.0);
    flight.set_inputs(&turned, &still);
    assert_eq!(*flight.outputs(), asked);
}

#[test]
fn the_jet_with_wings_bent_by_almost_half_of_their_length_flies_in_whole_cells() {
    let settings = Settings::from(PlantSettings {
        fidelity: Fidelity::GeometricallyExact,
        stiffness_scale: 0.1,
        mode_selection: ModeSelection::Symmetric,
        mode_count: 8,
        ..PlantSettings::of(jet())
    });
    let mut flight = Simulation::new(Arc::new(jet().clone()), &settings, 0.0).unwrap();
    let mut inputs = Inputs::zero(jet());
    inputs.controls[ELEVATOR] = -0.02;
    flight.set_inputs(&inputs, &Inputs::zero(jet()));
    let before = evaluations::so_far();
    flight.advance_to(1.0).unwrap();
    // One at the beginning and four in each of a hundred cells.
    assert_eq!(evaluations::so_far() - before, 401);
}
