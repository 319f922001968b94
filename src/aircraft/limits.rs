//! What an aircraft is flown within: angle of attack, Mach number, thrust, angles of the surfaces.
//!
//! Limits do not change a flight. A trim beyond them stands, with a warning that says what nobody could fly: stall,
//! compressibility and stops are not modelled. Where the file gives no limit the usual ones are assumed.

use serde::{Deserialize, Serialize};

use super::allowed::{ANGLE_DEG, Allowed, MACH, THRUST};
use super::document::Table;
use super::error::Problem;

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

/// Angle of attack up to which flow is attached to most wings, degrees.
const USUAL_ANGLE_OF_ATTACK: f64 = 15.0;

/// Deflection that most surfaces reach, degrees.
const USUAL_DEFLECTION: f64 = 30.0;

/// Mach number from which the air's compressibility, which is not modelled, shows.
const USUAL_MACH: f64 = 0.7;

/// What a trimmed flight should stay within.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Of the body x axis at O, rad.
    pub angle_of_attack: Bounds,
    /// Mach number.
    pub mach: Bounds,
    /// Of each engine, N.
    pub thrust: Bounds,
    /// rad.
    pub elevator: Bounds,
    /// rad.
    pub aileron: Bounds,
    /// Of both ailerons together, rad.
    pub aileron_symmetric: Bounds,
    /// rad.
    pub rudder: Bounds,
}

/// The least and the greatest that a quantity should be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounds {
    /// The least.
    pub minimum: Bound,
    /// The greatest.
    pub maximum: Bound,
}

/// One end of [`Bounds`], in the unit of the quantity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Bound {
    /// There is none.
    None,
    /// The usual one, since the aircraft file says nothing.
    Usual(f64),
    /// The aircraft file's.
    Given(f64),
}

impl Bounds {
    /// The bound that a value is beyond, if any.
    pub fn exceeded_by(&self, value: f64) -> Option<Bound> {
        let is_beyond = |bound: &Bound, outwards: f64| {
            bound.value().is_some_and(|bound| outwards * value > outwards * bound)
        };
        let ends = [(self.minimum, -1.0), (self.maximum, 1.0)];
        ends.into_iter().find(|(bound, outwards)| is_beyond(bound, *outwards)).map(|(bound, _)| bound)
    }

    fn usual_angles(degrees: f64) -> Self {
        let bound = degrees.to_radians();
        Bounds { minimum: Bound::Usual(-bound), maximum: Bound::Usual(bound) }
    }
}

impl Bound {
    /// The number, if there is a bound.
    pub fn value(&self) -> Option<f64> {
        match *self {
            Bound::None => None,
            Bound::Usual(value) | Bound::Given(value) => Some(value),
        }
    }
}

impl Default for Limits {
    /// The usual ones: ±15° of incidence, Mach 0.7, no negative thrust, ±30° of each surface.
    fn default() -> Self {
        let surface = Bounds::usual_angles(USUAL_DEFLECTION);
        Limits {
            angle_of_attack: Bounds::usual_angles(USUAL_ANGLE_OF_ATTACK),
            mach: Bounds { minimum: Bound::None, maximum: Bound::Usual(USUAL_MACH) },
            thrust: Bounds { minimum: Bound::Usual(0.0), maximum: Bound::None },
            elevator: surface,
            aileron: surface,
            aileron_symmetric: surface,
            rudder: surface,
        }
    }
}

impl Limits {
    /// Those of an aircraft file: its table `limits`, and the usual ones for what it does not say.
    pub(super) fn read(file: &Table) -> Limits {
        let mut limits = Limits::default();
        let Some(table) = file.optional("limits").and_then(|value| value.table(LIMITS)) else {
            return limits;
        };
        let attack = ["minimum_angle_of_attack_deg", "maximum_angle_of_attack_deg"];
        limits.angle_of_attack.take(&table, attack, &ANGLE_DEG, f64::to_radians);
        if let Some(mach) = table.optional("maximum_mach").and_then(|value| value.number(&MACH)) {
            limits.mach.maximum = Bound::Given(mach);
        }
        limits.thrust.take(&table, ["minimum_thrust_N", "maximum_thrust_N"], &THRUST, |newtons| newtons);
        let Some(surfaces) = table.optional("surface").and_then(|value| value.table(SURFACES)) else {
            return limits;
        };
        let Limits { elevator, aileron, aileron_symmetric, rudder, .. } = &mut limits;
        for (input, bounds) in SURFACES.iter().zip([elevator, aileron, aileron_symmetric, rudder]) {
            if let Some(surface) = surfaces.optional(input).and_then(|value| value.table(SURFACE)) {
                bounds.take(&surface, ["minimum_deg", "maximum_deg"], &ANGLE_DEG, f64::to_radians);
            }
        }
        limits
    }
}

impl Bounds {
    /// Takes what two fields of a table say. A usual end that contradicts the other, given one goes.
    fn take(&mut self, table: &Table, fields: [&'static str; 2], allowed: &Allowed, to_si: fn(f64) -> f64) {
        let [low, high] = fields.map(|field| table.optional(field).and_then(|value| value.number(allowed)));
        if let (Some(low), Some(high)) = (low, high)
            && low >= high
        {
            let [minimum, maximum] = fields;
            let found = format!("found {minimum} = {low} and {maximum} = {high}");
            let allowed = format!("{maximum} > {minimum} is allowed");
            table.report.add(Problem::OutOfRange, &table.place.within(maximum), found, allowed);
        }
        for (bound, given) in [(&mut self.minimum, low), (&mut self.maximum, high)] {
            if let Some(value) = given {
                *bound = Bound::Given(to_si(value));
            }
        }
        if self.minimum.value() >= self.maximum.value() && self.maximum.value().is_some() {
            for bound in [&mut self.minimum, &mut self.maximum] {
                if matches!(bound, Bound::Usual(_)) {
                    *bound = Bound::None;
                }
            }
        }
    }
}
