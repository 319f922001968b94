//! The table `limits` of an aircraft file, and limits in other tables.

use super::document::{Table, Value};
use super::error::Problem;
use super::format::{Field, control, file, limits as fields};
use super::limits::{Bound, Bounds, Limits};
use super::schema::FormerLimits;

/// The least and the greatest angle of a control.
pub(super) static CONTROL_LIMITS: [&Field; 2] = [&control::MINIMUM, &control::MAXIMUM];

/// Those of an aircraft file: its table `limits`, and the usual ones for what it does not say; then those of controls that
/// stand there as they used to.
pub(super) fn read_limits(table: &Table) -> (Limits, Vec<FormerLimits>) {
    let mut limits = Limits::default();
    let Some(table) = table.optional(&file::LIMITS_FIELD).and_then(|value| value.table()) else {
        return (limits, Vec::new());
    };
    let attack = [&fields::LEAST_ANGLE_OF_ATTACK, &fields::MOST_ANGLE_OF_ATTACK];
    take(&mut limits.angle_of_attack, &table, attack, "degrees", f64::to_radians);
    if let Some(mach) = table.optional(&fields::MOST_MACH).and_then(|value| value.number()) {
        limits.mach.maximum = Bound::Given(mach);
    }
    let thrust = [&fields::LEAST_THRUST, &fields::MOST_THRUST];
    take(&mut limits.thrust, &table, thrust, "N", |newtons| newtons);
    let former =
        table.optional(&fields::FORMER_SURFACE).and_then(|surfaces| surfaces.entries()).unwrap_or_default();
    (limits, former.iter().filter_map(|(name, value)| read_former(name, value)).collect())
}

/// Complains about limits of a control outside its table; it says what to write.
fn read_former(name: &str, value: &Value) -> Option<FormerLimits> {
    let table = value.table()?;
    let line = |field: &Field| {
        let limit = table.optional(field)?.number()?;
        Some(format!("{} = {limit}", field.name))
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
    take(&mut bounds, control, CONTROL_LIMITS, "degrees", f64::to_radians);
    bounds
}

/// Takes what two fields of a table say. A usual end that contradicts the other, given one goes.
fn take(bounds: &mut Bounds, table: &Table, fields: [&Field; 2], unit: &str, to_si: fn(f64) -> f64) {
    let [low, high] = fields.map(|field| table.optional(field).and_then(|v| v.located(Value::number)));
    if let (Some(low), Some(high)) = (&low, &high)
        && low.value >= high.value
    {
        let [minimum, maximum] = fields.map(|field| field.name);
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
