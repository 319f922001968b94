//! Flights that the importer integrates, beside those that the FMU does.

use super::*;
use crate::by_name::Flight;

/// Flies both for so many centiseconds, the inputs held over each, and returns the largest difference of each output as a share of
/// its largest departure from the start; what departs by less than a share of its usual magnitude is left out.
fn deviations(
    model: &ReducedModel,
    settings: &[(&str, f64)],
    inputs: impl Fn(f64) -> Vec<(&'static str, f64)>,
    outputs: &[&str],
    cells: u32,
) -> Vec<f64> {
    const SUBSTEPS: u32 = 10;
    let exchange = Exchange::flying(model, settings);
    let mut flight = Flight::new(model.clone());
    for (name, value) in settings {
        flight.set(name, *value).unwrap();
    }
    flight.set("tolerance", 1e-8).unwrap();
    let start = exchange.get(outputs);
    for (name, start) in outputs.iter().zip(&start) {
        let same = flight.get(name).unwrap();
        assert!((start - same).abs() < 1e-7 * (1.0 + same.abs()), "{name}: {start} {same}");
    }
    let mut peaks = vec![0.0_f64; outputs.len()];
    let mut differences = vec![0.0_f64; outputs.len()];
    for cell in 0..cells {
        let time = 0.01 * f64::from(cell);
        let inputs = inputs(time);
        exchange.set(&inputs);
        for (name, value) in inputs {
            flight.set(name, value).unwrap();
        }
        flight.advance(0.01).unwrap();
        for substep in 0..SUBSTEPS {
            exchange.step(time + 1e-3 * f64::from(substep), 1e-3);
        }
        if cell % 5 == 4 {
            for (i, (name, found)) in outputs.iter().zip(exchange.get(outputs)).enumerate() {
                let flown = flight.get(name).unwrap();
                peaks[i] = peaks[i].max((flown - start[i]).abs());
                differences[i] = differences[i].max((flown - found).abs());
            }
        }
    }
    differences.iter().zip(&peaks).map(|(difference, peak)| difference / peak).collect()
}

/// The elevator of the thesis: 2, 3, 1, 1 s to and fro, behind a lag of 0.05 s.
fn two_three_one_one(time: f64, angle: f64) -> f64 {
    let jumps = [(0.0, 1.0), (2.0, -2.0), (5.0, 2.0), (6.0, -2.0), (7.0, 1.0)];
    let risen = |since: f64| if since > 0.0 { 1.0 - libm::exp(-since / 0.05) } else { 0.0 };
    jumps.iter().map(|(at, by)| angle * by * risen(time - at)).sum()
}

const OUTPUTS: [&str; 9] = [
    "attitude.pitch",
    "velocity.x",
    "rate.y",
    "position.down",
    "load_factor.z",
    "deflection.wing_tip_right.up",
    "station.wing_tip_right.specific_force.z",
    "modal.q[1]",
    "loads.wing_root_right.bending",
];

fn assert_below(bound: f64, outputs: &[&str], found: &[f64], what: &str) {
    for (name, found) in outputs.iter().zip(found) {
        assert!(*found < bound, "{what}, {name}: {found:e}");
    }
}

#[test]
fn the_elevator_manoeuvre_is_that_of_co_simulation() {
    let inputs = |time| vec![("elevator", two_three_one_one(time, 0.02))];
    let found = deviations(jet(), &[], inputs, &OUTPUTS, 1500);
    assert_below(1e-5, &OUTPUTS, &found, "fifteen seconds");
}

#[test]
fn everything_that_moves_and_blows_is_flown_as_in_co_simulation() {
    let settings = [
        ("heading", 1.0),
        ("gust.shape", 2.0),
        ("gust.start", 0.5),
        ("turbulence.intensity", 0.5),
        ("actuator.elevator.frequency", 25.0),
        ("actuator.aileron.frequency", 30.0),
        ("engine.left.time_constant", 0.8),
    ];
    let inputs = |time| {
        vec![
            ("elevator", two_three_one_one(2.0 * time, 0.02)),
            ("aileron", if time < 1.0 { 0.03 } else { -0.01 }),
            ("rudder", 0.02 * libm::sin(3.0 * time)),
            ("thrust_left", if time < 1.0 { 2000.0 } else { 0.0 }),
            ("wind_north", 4.0),
            ("wind_east", -3.0),
            ("wind_down", -2.0),
        ]
    };
    let outputs = [
        &OUTPUTS[..],
        &["attitude.roll", "attitude.yaw", "position.north", "position.east", "air.beta", "wind.down"],
        &["surface.elevator", "actuator.aileron.rate", "engine.left.thrust", "sensor.air.alpha"],
    ]
    .concat();
    let found = deviations(jet(), &settings, inputs, &outputs, 300);
    assert_below(1e-5, &outputs, &found, "everything");
}

#[test]
fn every_level_of_fidelity_is_flown_as_in_co_simulation() {
    const RIGID: u8 = crate::equations::Fidelity::Rigid as u8 + 1;
    for level in 1..=6 {
        let inputs = |time| vec![("elevator", two_three_one_one(4.0 * time, 0.03)), ("aileron", 0.01 * time)];
        let outputs = if level == RIGID { &OUTPUTS[..5] } else { &OUTPUTS[..] };
        let found = deviations(jet(), &[("model", f64::from(level))], inputs, outputs, 150);
        assert_below(1e-5, outputs, &found, &format!("level {level}"));
    }
}

#[test]
fn a_wing_in_a_tunnel_meets_wind_and_gust_as_in_co_simulation() {
    let outputs = ["deflection.tip.up", "modal.q[1]", "modal.q_dot[2]", "air.speed", "wind.down"];
    let outputs: Vec<&str> = {
        let exchange = Exchange::new(&goland());
        outputs.into_iter().filter(|name| exchange.table.iter().any(|(_, row)| row.name == *name)).collect()
    };
    assert!(outputs.len() >= 3, "{outputs:?}");
    let settings = [("gust.shape", 2.0), ("gust.start", 0.2), ("gust.gradient", 20.0), ("airspeed", 80.0)];
    let inputs = |time| vec![("wind_down", -2.0 * libm::sin(6.0 * time)), ("wind_north", 3.0 * time)];
    let found = deviations(&goland(), &settings, inputs, &outputs, 150);
    assert_below(1e-5, &outputs, &found, "the wing");
}
