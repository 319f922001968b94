//! Flights of the generic business jet with sampled sensors.

use std::f64::consts::{PI, TAU};

use crate::devices::Noise;
use crate::flight::instant::{Freshness, Parts};
use crate::flight::{Channel, NoiseKind, SensorSettings, Settings, Simulation};
use crate::structure::test_jet::{AILERON, ELEVATOR, RUDDER, jet};

use super::devices::{begin, few_modes, hold};

/// A turn with some pitching in air that rises and sinks.
fn turn(flight: &mut Simulation, cell: u32) {
    hold(flight, |inputs| {
        inputs.controls[ELEVATOR] = if cell % 7 < 3 { -0.05 } else { 0.02 };
        (inputs.controls[AILERON], inputs.controls[RUDDER]) = (0.03, 0.02);
        inputs.wind.z = -0.1 * f64::from(cell % 5);
    });
}

/// The place of a channel.
fn channel(name: &str) -> usize {
    Channel::of(jet()).iter().position(|channel| channel.mirrored == name).unwrap()
}

#[test]
fn sensors_that_are_off_give_the_outputs_that_they_mirror() {
    let mut flight = begin(&few_modes());
    hold(&mut flight, |inputs| (inputs.controls[RUDDER], inputs.wind.z) = (0.1, -3.0));
    for end in [0.0, 0.017, 0.2] {
        flight.advance_to(end).unwrap();
        let instant = flight.instant();
        for (channel, reading) in Channel::of(jet()).iter().zip(&instant.sensors) {
            assert_eq!(channel.read(&instant.outputs).to_bits(), reading.to_bits(), "{}", channel.name());
        }
    }
}

#[test]
fn sensors_are_sampled_before_inputs_of_the_instant_act_and_held_until_the_next_sample() {
    let mut settings = few_modes();
    settings.sensors = SensorSettings { enabled: true, period: 0.02, ..SensorSettings::default() };
    let (mut sampled, place) = (begin(&settings), channel("load_factor.z"));
    let mut trimmed = begin(&few_modes());
    let at_rest = trimmed.outputs().load_factor.z;
    // At the beginning it is trimmed, whatever acts from then on.
    hold(&mut sampled, |inputs| inputs.wind.z = -1.0);
    assert_eq!(sampled.instant().sensors[place], at_rest);
    assert!(sampled.outputs().load_factor.z > at_rest + 1e-3);
    for cell in 1..20 {
        let time = 0.01 * f64::from(cell);
        sampled.advance_to(time).unwrap();
        let before = sampled.instant().clone();
        if cell % 2 == 0 {
            assert_eq!(before.sensors[place], before.outputs.load_factor.z);
        }
        hold(&mut sampled, |inputs| inputs.wind.z = -1.0 - f64::from(cell));
        assert_ne!(sampled.outputs().load_factor, before.outputs.load_factor);
        assert_eq!(sampled.instant().sensors, before.sensors, "{cell}");
        sampled.advance_to(time + 0.004).unwrap();
        assert_eq!(sampled.instant().sensors, before.sensors, "{cell}");
    }
}

#[test]
fn noise_is_added_last_and_is_that_of_its_channel_seed_and_number() {
    let mut settings = few_modes();
    settings.sensors.enabled = true;
    let mut silent = begin(&settings);
    settings.sensors.noise = [0.0, 1e-3, 0.0, 0.0, 0.0, 0.0, 0.0];
    let (mut noisy, place) = (begin(&settings), channel("rate.y"));
    // The numbers of devices::noise.
    for (sample, number) in [1.768_671_3, -0.041_571_1, 0.461_534_9].into_iter().enumerate() {
        [&mut silent, &mut noisy]
            .into_iter()
            .for_each(|flight| flight.advance_to(0.01 * sample as f64).unwrap());
        let (noisy, silent) = (noisy.instant(), silent.instant());
        assert!((noisy.sensors[place] - silent.sensors[place] - 1e-3 * number).abs() < 1e-9, "{sample}");
        assert_eq!(noisy.sensors[channel("attitude.roll")], silent.sensors[channel("attitude.roll")]);
    }
}

/// What follows τẏ = u − y while u goes along a line, after a time in units of τ, in steps of the classical Runge-Kutta method.
fn followed(start: f64, [from, to]: [f64; 2], time: f64) -> f64 {
    let steps = 200;
    let width = time / f64::from(steps);
    (0..steps).fold(start, |y, step| {
        let slope = |part: f64, y: f64| from + (to - from) * (f64::from(step) + part) / f64::from(steps) - y;
        let first = slope(0.0, y);
        let second = slope(0.5, y + 0.5 * width * first);
        let third = slope(0.5, y + 0.5 * width * second);
        let fourth = slope(1.0, y + width * third);
        y + width / 6.0 * (first + 2.0 * (second + third) + fourth)
    })
}

#[test]
fn each_channel_follows_what_it_mirrors_as_the_equation_of_its_lag_says_and_is_late() {
    let (period, lag, delay) = (0.02, 0.07, 2);
    let mut settings = few_modes();
    let mut plain = begin(&settings);
    settings.sensors =
        SensorSettings { enabled: true, period, time_constant: lag, delay, ..SensorSettings::default() };
    let mut sampled = begin(&settings);
    let channels = Channel::of(jet());
    let read = |flight: &mut Simulation| -> Vec<f64> {
        let outputs = flight.outputs();
        channels.iter().map(|channel| channel.read(outputs)).collect()
    };
    let mut before = read(&mut plain);
    let (mut lagged, mut furthest) = (vec![before.clone()], 0.0_f64);
    for cell in 0..40 {
        for flight in [&mut plain, &mut sampled] {
            turn(flight, cell);
            flight.advance_to(0.01 * f64::from(cell + 1)).unwrap();
        }
        if cell % 2 == 1 {
            let now = read(&mut plain);
            let last = lagged.last().unwrap().iter().zip(before.iter().zip(&now));
            let next = last.map(|(y, (from, to))| followed(*y, [*from, *to], period / lag)).collect();
            lagged.push(next);
            before = now;
        }
        let expected = &lagged[lagged.len().saturating_sub(1 + delay)];
        for ((expected, found), channel) in expected.iter().zip(&sampled.instant().sensors).zip(&channels) {
            let apart = (found - expected).abs() / expected.abs().max(1.0);
            furthest = furthest.max(apart);
            assert!(apart < 1e-12, "{} {cell}: {found} {expected}", channel.name());
        }
    }
    println!("{furthest:e}");
}

/// Of a channel, by its name.
fn kind(mirrored: &str) -> NoiseKind {
    match mirrored {
        "air.speed" => NoiseKind::AirSpeed,
        "air.alpha" | "air.beta" => NoiseKind::AirAngle,
        "position.down" => NoiseKind::Position,
        _ if mirrored.starts_with("attitude.") => NoiseKind::Attitude,
        _ if mirrored.starts_with("load_factor.") => NoiseKind::LoadFactor,
        _ if mirrored.contains(".specific_force.") => NoiseKind::SpecificForce,
        _ => {
            assert!(mirrored.starts_with("rate.") || mirrored.contains(".rate."), "{mirrored}");
            NoiseKind::Rate
        }
    }
}

#[test]
fn noise_of_a_kind_is_in_the_channels_of_that_kind_and_in_no_other() {
    let mut settings = few_modes();
    (settings.sensors.enabled, settings.sensors.seed) = (true, 9);
    let silent = begin(&settings).instant().sensors.clone();
    for noisy in NoiseKind::ALL {
        settings.sensors.noise = [0.0; NoiseKind::ALL.len()];
        settings.sensors.noise[noisy as usize] = 0.25;
        let mut flight = begin(&settings);
        let found = &flight.instant().sensors;
        for ((channel, silent), found) in Channel::of(jet()).iter().zip(&silent).zip(found) {
            let is_noisy = kind(&channel.mirrored) == noisy;
            let noise = Noise::new(9, &format!("sensor.{}", channel.mirrored)).number(0);
            let expected = if is_noisy { silent + 0.25 * noise } else { *silent };
            assert_eq!(found.to_bits(), expected.to_bits(), "{noisy:?} {}", channel.name());
        }
    }
}

/// The yaw angle at the end of three seconds of a turn, and what a lagging sensor gives of it every 0.1 s.
fn yaw_in_a_turn(settings: &Settings) -> (f64, Vec<f64>) {
    let (mut flight, place) = (begin(settings), channel("attitude.yaw"));
    let readings = (1..=30).map(|step| {
        hold(&mut flight, |inputs| (inputs.controls[AILERON], inputs.controls[RUDDER]) = (0.02, 0.05));
        flight.advance_to(0.1 * f64::from(step)).unwrap();
        flight.instant().sensors[place]
    });
    let readings = readings.collect();
    (flight.outputs().attitude.z, readings)
}

#[test]
fn a_lagging_yaw_sensor_passes_half_a_turn_as_it_passes_any_other_angle() {
    let mut settings = few_modes();
    settings.sensors = SensorSettings { enabled: true, time_constant: 0.1, ..SensorSettings::default() };
    let (turned, anywhere) = yaw_in_a_turn(&settings);
    assert!(turned.abs() > 0.01, "{turned}");
    settings.plant.heading = libm::copysign(PI, turned) - 0.5 * turned;
    let (end, found) = yaw_in_a_turn(&settings);
    assert!(end * turned < 0.0, "it passes half a turn: {end} {turned}");
    for (found, anywhere) in found.iter().zip(&anywhere) {
        let apart = libm::remainder(found - anywhere - settings.plant.heading, TAU);
        assert!(found.abs() <= PI && apart.abs() < 1e-11, "{found} {anywhere}: {apart:e}");
    }
}

#[test]
fn noise_moves_an_angle_past_half_a_turn_to_the_other_side() {
    let mut settings = few_modes();
    settings.plant.heading = PI - 1e-3;
    settings.sensors = SensorSettings { enabled: true, ..SensorSettings::default() };
    settings.sensors.noise[NoiseKind::Attitude as usize] = 1.0;
    let (mut flight, place) = (begin(&settings), channel("attitude.yaw"));
    let noise = Noise::new(1, "sensor.attitude.yaw");
    let (mut low, mut high) = (0, 0);
    for sample in 0..20_u32 {
        flight.advance_to(0.01 * f64::from(sample)).unwrap();
        let found = flight.instant().sensors[place];
        let apart = libm::remainder(found - settings.plant.heading - noise.number(u64::from(sample)), TAU);
        assert!(found.abs() <= PI && apart.abs() < 1e-9, "{found}");
        *(if found < 0.0 { &mut low } else { &mut high }) += 1;
    }
    assert!(low > 3 && high > 3, "{low} {high}");
}

#[test]
fn channels_are_read_without_outputs_that_they_do_not_need() {
    let sensors = Parts { sensors: true, ..Parts::default() };
    for (enabled, fresh) in [(true, sensors), (false, Parts { usual: true, ..sensors })] {
        let mut settings = few_modes();
        settings.sensors.enabled = enabled;
        let [mut flight, mut other] = [(); 2].map(|()| begin(&settings));
        [&mut flight, &mut other].into_iter().for_each(|flight| flight.advance_to(0.013).unwrap());
        assert_eq!(flight.instant_is, Freshness::Stale);
        flight.instant_of(sensors);
        assert_eq!(flight.instant_is, Freshness::Of(fresh));
        assert_eq!(flight.instant().sensors, other.instant().sensors);
    }
}
