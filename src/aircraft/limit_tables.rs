//! The table `limits` of an aircraft file, and limits in other tables.

use super::allowed::{ANGLE_DEG, Allowed, MACH, THRUST};
use super::document::{Table, Value};
use super::error::Problem;
use super::limits::{Bound, Bounds, Limits};
use super::schema::FormerLimits;

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

/// The least and the greatest angle of a control.
pub(super) const CONTROL_LIMITS: [&str; 2] = ["minimum_deg", "maximum_deg"];

/// Those of an aircraft file: its table `limits`, and the usual ones for what it does not say; then those of controls that
/// stand there as they used to.
pub(super) fn read_limits(file: &Table) -> (Limits, Vec<FormerLimits>) {
    let mut limits = Limits::default();
    let Some(table) = file.optional("limits").and_then(|value| value.table(LIMITS)) else {
        return (limits, Vec::new());
    };
    let attack = ["minimum_angle_of_attack_deg", "maximum_angle_of_attack_deg"];
    take(&mut limits.angle_of_attack, &table, attack, (&ANGLE_DEG, "degrees"), f64::to_radians);
    if let Some(mach) = table.optional("maximum_mach").and_then(|value| value.number(&MACH)) {
        limits.mach.maximum = Bound::Given(mach);
    }
    let thrust = ["minimum_thrust_N", "maximum_thrust_N"];
    take(&mut limits.thrust, &table, thrust, (&THRUST, "N"), |newtons| newtons);
    let former = table.optional(SURFACE).and_then(|surfaces| surfaces.entries()).unwrap_or_default();
    (limits, former.iter().filter_map(|(name, value)| read_former(name, value)).collect())
}

/// Complains about limits of a control outside its table; it says what to write.
fn read_former(name: &str, value: &Value) -> Option<FormerLimits> {
    let table = value.table(&CONTROL_LIMITS)?;
    let line = |field: &'static str| {
        let limit = table.optional(field)?.number(&ANGLE_DEG)?;
        Some(format!("{field} = {limit}"))
    };
    let lines: Vec<String> = CONTROL_LIMITS.into_iter().filter_map(line).collect();
    let found = format!("found limits of \"{name}\" outside its [[control]]");
    let allowed = match lines.as_slice() {
        [] => format!("minimum_deg and maximum_deg are allowed in the [[control]] of {name}"),
        lines => format!("move {} of {name} into its [[control]]", lines.join(", ")),
    };
    value.report.add(Problem::UnknownField, &value.place, found, allowed);
    Some(FormerLimits { name: name.to_owned(), lines })
}

/// Those of a control: what its table says, and the usual ones.
pub(super) fn read_control_limits(control: &Table) -> Bounds {
    let mut bounds = Bounds::of_usual_control();
    take(&mut bounds, control, CONTROL_LIMITS, (&ANGLE_DEG, "degrees"), f64::to_radians);
    bounds
}

/// Takes what two fields of a table say. A usual end that contradicts the other, given one goes.
fn take(
    bounds: &mut Bounds,
    table: &Table,
    fields: [&'static str; 2],
    (allowed, unit): (&Allowed, &str),
    to_si: fn(f64) -> f64,
) {
    let [low, high] =
        fields.map(|field| table.optional(field).and_then(|v| v.located(|v| v.number(allowed))));
    if let (Some(low), Some(high)) = (&low, &high)
        && low.value >= high.value
    {
        let [minimum, maximum] = fields;
        let found = format!("found {minimum} = {} and {maximum} = {}, in {unit}", low.value, high.value);
        let allowed = format!("{maximum} > {minimum} is allowed");
        table.report.add(Problem::OutOfRange, &high.place, found, allowed);
    }
    let [low, high] = [low, high].map(|limit| limit.map(|limit| limit.value));
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
