//! What the description declares is what the Jacobian has.

use super::*;
use crate::variables::{InputSlot, Slot};

/// A number between -1 and 1 that depends on a place and looks as if by chance.
fn scattered(place: usize) -> f64 {
    let number = 12.9898 * (place as f64 + 1.0);
    2.0 * (libm::sin(number) * 43_758.545 - libm::floor(libm::sin(number) * 43_758.545)) - 1.0
}

/// Entries of the Jacobian that are not zero have been declared; returns how many of the declared ones are zero.
fn check(model: &ReducedModel, values: &[(&str, f64)], what: &str) -> f64 {
    let exchange = Exchange::flying(model, values);
    let table = &exchange.table;
    let x: Vec<f64> = exchange
        .states()
        .iter()
        .zip(table.states())
        .enumerate()
        .map(|(place, (x, (_, reference)))| {
            let nominal = table.get(*reference).unwrap().nominal.unwrap();
            x + 0.02 * nominal * scattered(place)
        })
        .collect();
    exchange.set_states(0.0, &x);
    exchange.set(&[("wind_down", 0.7), ("wind_north", -0.4)]);
    let outputs = exchange.reals(|place| matches!(place, Place::Common(Slot::Output(_))));
    let unknowns = [outputs, table.rates().collect()].concat();
    let mut knowns: Vec<u32> = table.states().iter().map(|(_, reference)| *reference).collect();
    knowns.extend(exchange.reals(|place| matches!(place, Place::Common(Slot::Input(_)))));
    let width = |known: u32| match table.get(known).unwrap().slot {
        Place::Common(Slot::Input(InputSlot::Thrust(_))) => 1e4,
        _ => table.get(known).unwrap().nominal.unwrap_or(1.0),
    };
    let declared: Vec<Vec<u32>> =
        unknowns.iter().map(|unknown| table.dependencies(*unknown, false)).collect();
    let columns: Vec<Vec<f64>> = knowns.iter().map(|known| exchange.derivatives(&unknowns, *known)).collect();
    let (mut said, mut idle) = (0, 0);
    for (row, unknown) in unknowns.iter().enumerate() {
        let entry = |column: usize| columns[column][row] * width(knowns[column]);
        let largest = (0..knowns.len()).map(|column| entry(column).abs()).fold(0.0, f64::max);
        for (column, known) in knowns.iter().enumerate() {
            let acts = entry(column).abs() > 1e-9 * largest.max(1e-9);
            let is_declared = declared[row].contains(known);
            said += u32::from(is_declared);
            idle += u32::from(is_declared && !acts);
            assert!(
                is_declared || !acts,
                "{what}: {} depends on {}, which is not declared: {:e} of {largest:e}",
                exchange.name(*unknown),
                exchange.name(*known),
                entry(column)
            );
        }
    }
    f64::from(idle) / f64::from(said)
}

#[test]
fn nothing_undeclared_acts_at_any_level_of_fidelity() {
    let values = |level: u8| {
        vec![
            ("model", f64::from(level)),
            ("heading", 0.8),
            ("gust.shape", 2.0),
            ("gust.start", 0.0),
            ("actuator.elevator.frequency", 20.0),
            ("engine.left.time_constant", 1.0),
        ]
    };
    for level in 1..=6 {
        let idle = check(jet(), &values(level), &format!("level {level}"));
        // Modes and inflow are declared at all levels, though one has none.
        assert!(idle < 0.9, "level {level}: {idle}");
    }
}

#[test]
fn nothing_undeclared_acts_on_a_wing_in_a_tunnel() {
    check(&goland(), &[("gust.shape", 2.0), ("gust.start", 0.01), ("airspeed", 60.0)], "the wing");
}

#[test]
fn every_output_that_is_a_state_declares_itself_alone() {
    let exchange = Exchange::new(jet());
    for (_, reference) in exchange.table.states() {
        let row = exchange.table.get(*reference).unwrap();
        if let Place::Common(_) = row.slot {
            assert_eq!(exchange.table.dependencies(*reference, true), [*reference], "{}", row.name);
        }
    }
}
