//! The table `limits` of an aircraft file.

use super::allowed::{ANGLE_DEG, Allowed, MACH, THRUST};
use super::document::Table;
use super::error::Problem;
use super::limits::{Bound, Bounds, Limits};

/// What `[limits]` may hold.
const LIMITS: &[&str] = &[
    "minimum_angle_of_attack_deg",
    "maximum_angle_of_attack_deg",
    "maximum_mach",
    "minimum_thrust_N",
    "maximum_thrust_N",
    "surface",
];

/// What `[limits.surface]` may hold.
const SURFACES: &[&str] = &["elevator", "aileron", "aileron_symmetric", "rudder"];

/// What `[limits.surface.<input>]` may hold.
const SURFACE: &[&str] = &["minimum_deg", "maximum_deg"];

/// Those of an aircraft file: its table `limits`, and the usual ones for what it does not say.
pub(super) fn read_limits(file: &Table) -> Limits {
    let mut limits = Limits::default();
    let Some(table) = file.optional("limits").and_then(|value| value.table(LIMITS)) else {
        return limits;
    };
    let attack = ["minimum_angle_of_attack_deg", "maximum_angle_of_attack_deg"];
    take(&mut limits.angle_of_attack, &table, attack, &ANGLE_DEG, f64::to_radians);
    if let Some(mach) = table.optional("maximum_mach").and_then(|value| value.number(&MACH)) {
        limits.mach.maximum = Bound::Given(mach);
    }
    take(&mut limits.thrust, &table, ["minimum_thrust_N", "maximum_thrust_N"], &THRUST, |newtons| newtons);
    let Some(surfaces) = table.optional("surface").and_then(|value| value.table(SURFACES)) else {
        return limits;
    };
    let Limits { elevator, aileron, aileron_symmetric, rudder, .. } = &mut limits;
    for (input, bounds) in SURFACES.iter().zip([elevator, aileron, aileron_symmetric, rudder]) {
        if let Some(surface) = surfaces.optional(input).and_then(|value| value.table(SURFACE)) {
            take(bounds, &surface, ["minimum_deg", "maximum_deg"], &ANGLE_DEG, f64::to_radians);
        }
    }
    limits
}

/// Takes what two fields of a table say. A usual end that contradicts the other, given one goes.
fn take(
    bounds: &mut Bounds,
    table: &Table,
    fields: [&'static str; 2],
    allowed: &Allowed,
    to_si: fn(f64) -> f64,
) {
    let [low, high] = fields.map(|field| table.optional(field).and_then(|value| value.number(allowed)));
    if let (Some(low), Some(high)) = (low, high)
        && low >= high
    {
        let [minimum, maximum] = fields;
        let found = format!("found {minimum} = {low} and {maximum} = {high}");
        let allowed = format!("{maximum} > {minimum} is allowed");
        table.report.add(Problem::OutOfRange, &table.place.within(maximum), found, allowed);
    }
    for (bound, given) in [(&mut bounds.minimum, low), (&mut bounds.maximum, high)] {
        if let Some(value) = given {
            *bound = Bound::Given(to_si(value));
        }
    }
    if bounds.minimum.value() >= bounds.maximum.value() && bounds.maximum.value().is_some() {
        for bound in [&mut bounds.minimum, &mut bounds.maximum] {
            if matches!(bound, Bound::Usual(_)) {
                *bound = Bound::None;
            }
        }
    }
}
