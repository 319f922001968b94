//! Torque and angular momentum of engines against the aircraft's size.

use flexible_aircraft::aircraft::Engine;

use super::super::facts::Facts;
use crate::numbers::short;

/// Torque by thrust, by the span: that of a propeller is J/(2π η) of its diameter, 0.05 standing still and up to 0.35 in fast flight, and the
/// diameter is less than 0.3 of the span.
const MOST_TORQUE: f64 = 0.1;

/// Angular momentum by mass and span, m/s: what turns is up to 0.05 of the aircraft's mass, with a radius of gyration of up to 0.04 of its span that
/// moves at up to 250 m/s. By our own estimates a light single has 0.04 to 0.1, an airliner with two turbofans 0.02,
/// a fighter of 1917 with a rotary engine 0.4.
const MOST_MOMENTUM: f64 = 0.5;

/// What is unusual about what turns in an engine.
pub fn turning(engine: &Engine, facts: &Facts) -> Vec<String> {
    let Some(lengths) = facts.reference else { return Vec::new() };
    let Engine { name, torque, angular_momentum, .. } = engine;
    let most_torque = MOST_TORQUE * lengths.span;
    let most_momentum = MOST_MOMENTUM * facts.mass * lengths.span;
    let torque = (torque.abs() > most_torque).then(|| {
        format!(
            "the engine {name}: torque_m is {}, usual is up to {} m either way at a span of {} m: a propeller has up to a third of its diameter",
            short(*torque),
            short(most_torque),
            short(lengths.span)
        )
    });
    let momentum = (angular_momentum.abs() > most_momentum).then(|| {
        format!(
            "the engine {name}: angular_momentum_kg_m2_s is {}, usual is up to {} kg m²/s either way at this mass and span: is it the moment of inertia \
             times rad/s?",
            short(*angular_momentum),
            short(most_momentum)
        )
    });
    torque.into_iter().chain(momentum).collect()
}
