//! Flights of the generic business jet with actuators and engines that lag.

use std::sync::Arc;

use crate::devices::{Actuator, Command, EngineLag, Holding, Surface};
use crate::flight::{InputReference, Inputs, SensorSettings, Settings, Simulation};
use crate::plant::PlantSettings;
use crate::structure::test_jet::{AILERON, AILERON_SYMMETRIC, ELEVATOR, RUDDER, jet};

const SERVO: Actuator =
    Actuator { frequency: 40.0, damping: 0.7, rate_limit: 0.7, minimum: -0.35, maximum: 0.35 };
const TURBINE: EngineLag = EngineLag { time_constant: 0.5, minimum: 0.0, maximum: 30_000.0 };

pub(super) fn few_modes() -> Settings {
    PlantSettings { mode_count: 4, ..PlantSettings::of(jet()) }.into()
}

/// With an actuator on each control and engines that lag.
fn with_devices() -> Settings {
    let mut settings = few_modes();
    (0..4).for_each(|control| settings.actuators.set(control, SERVO));
    (0..2).for_each(|engine| settings.engines.set(engine, TURBINE));
    settings
}

pub(super) fn begin(settings: &Settings) -> Simulation {
    Simulation::new(Arc::new(jet().clone()), settings, 0.0).unwrap()
}

pub(super) fn hold(flight: &mut Simulation, change: impl FnOnce(&mut Inputs)) {
    let still = Inputs::zero(jet());
    let mut inputs = still.clone();
    change(&mut inputs);
    flight.set_inputs(&inputs, &still);
}

#[test]
fn surfaces_and_thrusts_lag_behind_the_inputs_as_their_devices_say() {
    for input_reference in [InputReference::Trim, InputReference::Absolute] {
        let mut flight = begin(&Settings { input_reference, ..with_devices() });
        let trim = *flight.trim();
        hold(&mut flight, |inputs| (inputs.controls[ELEVATOR], inputs.thrust) = (-0.1, vec![5e3; 2]));
        let from = if input_reference == InputReference::Trim { 1.0 } else { 0.0 };
        let asked = |trim: f64, input: f64| Command { value: from * trim + input, rate: 0.0 };
        let (mut surface, mut thrust) = (Surface { angle: trim.pitch_control, rate: 0.0 }, trim.thrust);
        assert_eq!(flight.instant().actuators[ELEVATOR].rate, 0.0);
        for cell in 1..=30 {
            flight.advance_to(0.01 * f64::from(cell)).unwrap();
            surface = SERVO.after(surface, asked(trim.pitch_control, -0.1), 0.01);
            thrust = TURBINE.after(thrust, asked(trim.thrust, 5e3), 0.01);
            let instant = flight.instant();
            assert!((instant.outputs.controls[ELEVATOR] - surface.angle).abs() < 1e-12, "{cell}");
            assert!((instant.actuators[ELEVATOR].rate - surface.rate).abs() < 1e-10, "{cell}");
            assert!((instant.outputs.thrust[1] - thrust).abs() < 1e-7, "{cell}");
        }
        assert!(flight.outputs().rate.y.abs() > 1e-3, "it pitches");
    }
}

/// A ramp of the elevator into its stop, a step of the rudder, more thrust on the left, under noisy, late and lagging sensors.
fn set_inputs(flight: &mut Simulation, cell: u32) {
    let (mut inputs, mut rates) = (Inputs::zero(jet()), Inputs::zero(jet()));
    (inputs.controls[ELEVATOR], rates.controls[ELEVATOR]) = (0.03 * f64::from(cell), 3.0);
    inputs.controls[RUDDER] = if cell < 10 { 0.0 } else { 0.2 };
    inputs.thrust[0] = 1e4;
    inputs.wind.z = -0.1 * f64::from(cell);
    flight.set_inputs(&inputs, &rates);
}

#[test]
fn one_step_of_ten_milliseconds_ten_of_one_and_a_restored_snapshot_have_the_same_bits() {
    let mut settings = with_devices();
    settings.sensors = SensorSettings {
        enabled: true,
        period: 0.02,
        time_constant: 0.03,
        delay: 2,
        noise: [1e-3; 7],
        seed: 5,
    };
    let [mut whole, mut parts, mut other] = [(); 3].map(|()| begin(&settings));
    for cell in 0..30 {
        [&mut whole, &mut parts].into_iter().for_each(|flight| set_inputs(flight, cell));
        let time = 0.01 * f64::from(cell);
        whole.advance_to(time + 0.01).unwrap();
        for part in 1..=10 {
            parts.advance_to(time + 1e-3 * f64::from(part)).unwrap();
            // Inside a cell and at its end, before and after the whole aircraft has taken over.
            if part % 5 == 0 {
                let mut bytes = Vec::new();
                parts.snapshot(&mut bytes);
                assert_eq!(bytes.len(), parts.snapshot_size());
                other.restore(&bytes).unwrap();
                assert_eq!(other.instant(), parts.instant());
                std::mem::swap(&mut other, &mut parts);
            }
        }
        assert_eq!(whole.instant(), parts.instant(), "{cell}");
    }
    let holding = whole.instant().actuators.iter().map(|actuator| actuator.holding);
    assert_eq!(holding.collect::<Vec<_>>(), [Holding::Rate, Holding::None, Holding::None, Holding::Rate]);
    assert!(!whole.is_symmetric());
}

#[test]
fn a_step_that_fails_leaves_devices_as_they_were() {
    let mut settings = with_devices();
    settings.sensors = SensorSettings { enabled: true, delay: 3, ..SensorSettings::default() };
    let [mut failing, mut smooth] = [(); 2].map(|()| begin(&settings));
    for flight in [&mut failing, &mut smooth] {
        hold(flight, |inputs| inputs.controls[ELEVATOR] = -0.2);
        flight.advance_to(0.053).unwrap();
    }
    // In the first cell and after several: a wind from behind, and one that grows.
    for (end, wind, growth) in [(0.055, 1000.0, 0.0), (0.5, 0.0, 1000.0)] {
        let before = failing.instant().clone();
        let (mut inputs, mut rates) = (Inputs::zero(jet()), Inputs::zero(jet()));
        (inputs.controls[ELEVATOR], inputs.wind.x, rates.wind.x) = (-0.2, wind, growth);
        failing.set_inputs(&inputs, &rates);
        assert!(failing.advance_to(end).is_err());
        hold(&mut failing, |inputs| inputs.controls[ELEVATOR] = -0.2);
        assert_eq!(*failing.instant(), before);
    }
    for end in [0.06, 0.2] {
        // The same settings of the inputs at the same time.
        if end == 0.06 {
            hold(&mut smooth, |_| {});
            hold(&mut smooth, |inputs| inputs.controls[ELEVATOR] = -0.2);
        }
        [&mut failing, &mut smooth].into_iter().for_each(|flight| flight.advance_to(end).unwrap());
        assert_eq!(failing.instant(), smooth.instant());
    }
}

#[test]
fn half_the_aircraft_flies_on_while_what_acts_is_even() {
    let fly = |settings: &Settings, change: fn(&mut Inputs)| {
        let mut flight = begin(settings);
        hold(&mut flight, change);
        flight.advance_to(0.1).unwrap();
        flight.is_symmetric()
    };
    let even = |inputs: &mut Inputs| {
        (inputs.controls[ELEVATOR], inputs.controls[AILERON_SYMMETRIC]) = (-0.1, 0.05);
        inputs.thrust = vec![3e4; 2];
    };
    assert!(fly(&with_devices(), even));
    assert!(!fly(&with_devices(), |inputs| inputs.controls[AILERON] = 1e-3));
    assert!(!fly(&with_devices(), |inputs| inputs.thrust[0] = 100.0));
    // What a stop takes from the command does not act.
    let mut jammed = with_devices();
    jammed.actuators.set(AILERON, Actuator { minimum: 0.0, maximum: 0.0, ..Actuator::default() });
    assert!(fly(&jammed, |inputs| inputs.controls[AILERON] = 0.1));
    // Engines that are not alike part sooner or later.
    let mut unlike = with_devices();
    unlike.engines.set(1, EngineLag { time_constant: 0.4, ..TURBINE });
    assert!(!fly(&unlike, even));
}

#[test]
fn the_half_with_actuators_flies_as_the_whole() {
    let mut flights = [(); 2].map(|()| begin(&with_devices()));
    // What hardly acts unfolds the state.
    hold(&mut flights[1], |inputs| inputs.controls[RUDDER] = 1e-14);
    for flight in &mut flights {
        flight.advance_to(0.01).unwrap();
        hold(flight, |inputs| inputs.controls[ELEVATOR] = -0.2);
        flight.advance_to(1.0).unwrap();
    }
    let [half, whole] = &mut flights;
    assert!(half.is_symmetric() && !whole.is_symmetric());
    let apart = half.outputs().attitude.y - whole.outputs().attitude.y;
    assert!(apart.abs() < 1e-11, "{apart:e}");
}

#[test]
fn a_trim_beyond_a_limit_is_refused_by_name_with_value_and_limit() {
    let refusal = |change: fn(&mut Settings)| {
        let mut settings = few_modes();
        change(&mut settings);
        Simulation::new(Arc::new(jet().clone()), &settings, 0.0).unwrap_err().to_string()
    };
    let trim = *begin(&few_modes()).trim();
    for frequency in [0.0, 40.0] {
        let mut settings = few_modes();
        settings.actuators.set(ELEVATOR, Actuator { frequency, minimum: 0.1, ..Actuator::default() });
        let refused = Simulation::new(Arc::new(jet().clone()), &settings, 0.0).unwrap_err().to_string();
        let needed = format!("actuator elevator at {} rad", trim.pitch_control);
        assert!(refused.contains(&needed), "{refused}");
        assert!(refused.contains("`actuator.elevator.minimum` is 0.1 rad"), "{refused}");
    }
    let thrust = refusal(|s| s.engines.set(1, EngineLag { maximum: 10.0, ..EngineLag::default() }));
    assert!(thrust.contains(&format!("engine right at {} N", trim.thrust)), "{thrust}");
    assert!(thrust.contains("`engine.right.maximum` is 10 N"), "{thrust}");
    let neutral = refusal(|s| s.actuators.set(RUDDER, Actuator { maximum: -0.1, ..Actuator::default() }));
    assert!(
        neutral.contains("actuator rudder at 0 rad, and `actuator.rudder.maximum` is -0.1 rad"),
        "{neutral}"
    );
}

#[test]
fn without_a_frequency_the_stops_clamp_the_command_at_once() {
    let mut settings = few_modes();
    settings.actuators.set(ELEVATOR, Actuator { minimum: -0.3, maximum: 0.2, ..Actuator::default() });
    settings.engines.set(0, EngineLag { maximum: 30_000.0, ..EngineLag::default() });
    let mut flight = begin(&settings);
    hold(&mut flight, |inputs| (inputs.controls[ELEVATOR], inputs.thrust[0]) = (-0.5, 1e5));
    for end in [0.0, 0.1] {
        flight.advance_to(end).unwrap();
        let instant = flight.instant();
        assert_eq!((instant.outputs.controls[ELEVATOR], instant.outputs.thrust[0]), (-0.3, 30_000.0));
        assert_eq!(instant.actuators[ELEVATOR].holding, Holding::Stop);
    }
}

/// An actuator that moves within a cell of 10 ms as a control that is flown along the same curve in pieces of 0.1 ms; one that were
/// seen at the ends of the cell alone would not: of a surface so quick the mean over the cell is 0.32 more by its ends, and 0.003 by
/// its ends and the middle (Simpson).
#[test]
fn the_stages_of_a_step_see_the_surface_where_it_is() {
    let quick = Actuator { frequency: 100.0, rate_limit: 20.0, ..Actuator::default() };
    let asked = Command { value: -0.1, rate: 0.0 };
    let along = |pieces: u32| {
        let mut flight = begin(&few_modes());
        let trim = flight.trim().pitch_control;
        let start = Surface { angle: trim, rate: 0.0 };
        let asked = Command { value: trim + asked.value, ..asked };
        let at =
            |piece: u32| quick.after(start, asked, 0.01 * f64::from(piece) / f64::from(pieces)).angle - trim;
        for piece in 0..pieces {
            let (mut inputs, mut rates) = (Inputs::zero(jet()), Inputs::zero(jet()));
            inputs.controls[ELEVATOR] = at(piece);
            rates.controls[ELEVATOR] = (at(piece + 1) - at(piece)) * 100.0 * f64::from(pieces);
            flight.set_inputs(&inputs, &rates);
            flight.advance_to(0.01 * f64::from(piece + 1) / f64::from(pieces)).unwrap();
        }
        flight.outputs().rate.y
    };
    let mut settings = few_modes();
    settings.actuators.set(ELEVATOR, quick);
    let mut flight = begin(&settings);
    hold(&mut flight, |inputs| inputs.controls[ELEVATOR] = asked.value);
    flight.advance_to(0.01).unwrap();
    let (found, fine, coarse) = (flight.outputs().rate.y, along(100), along(1));
    let apart = |rate: f64| (rate / fine - 1.0).abs();
    println!("{:e} {:e}", apart(found), apart(coarse));
    assert!(apart(found) < 1e-2 && apart(coarse) > 0.1, "{found} {fine} {coarse}");
}
