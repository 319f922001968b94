//! The table `limits` of an aircraft file, and limits in other tables.

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
    SURFACE,
];

/// Where limits of controls stood before controls had tables of their own.
const SURFACE: &str = "surface";

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
    if let Some(surface) = table.optional(SURFACE) {
        let allowed = "each control has its own: minimum_deg and maximum_deg are allowed in its [[control]]";
        table.report.add(Problem::UnknownField, &surface.place, "found limits of surfaces", allowed);
    }
    limits
}

/// Those of a control: what its table says, and the usual ones.
pub(super) fn read_control_limits(control: &Table) -> Bounds {
    let mut bounds = Bounds::of_usual_control();
    take(&mut bounds, control, ["minimum_deg", "maximum_deg"], &ANGLE_DEG, f64::to_radians);
    bounds
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
