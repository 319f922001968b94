//! What an aircraft is flown within: angle of attack, Mach number, thrust, angles of its controls.
//!
//! Limits do not change a flight. A trim beyond them stands, with a warning that says what nobody could fly: stall,
//! compressibility and stops are not modelled. Where the file gives no limit the usual ones are assumed.
//!
//! [theory: limits-of-validity.unlimited]

use serde::{Deserialize, Serialize};

/// Angle of attack up to which flow is attached to most wings, degrees.
pub(super) const USUAL_ANGLE_OF_ATTACK: f64 = 15.0;

/// Deflection that most controls reach, degrees.
pub(super) const USUAL_DEFLECTION: f64 = 30.0;

/// Mach number from which the air's compressibility, which is not modelled, shows.
pub(super) const USUAL_MACH: f64 = 0.7;

/// Most engines do not push backwards in flight, N.
pub(super) const USUAL_LEAST_THRUST: f64 = 0.0;

/// What a trimmed flight should stay within, but for the angles of the controls, which have limits of their own.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Of the body x axis at O, rad.
    pub angle_of_attack: Bounds,
    /// Mach number.
    pub mach: Bounds,
    /// Of each engine, N.
    pub thrust: Bounds,
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

impl Limits {
    /// Whether all bounds that there are are finite.
    pub(crate) fn are_finite(&self) -> bool {
        [self.angle_of_attack, self.mach, self.thrust].iter().all(Bounds::are_finite)
    }
}

impl Bounds {
    /// The usual ones of a control: ±30°.
    pub fn of_usual_control() -> Self {
        Bounds::usual_angles(USUAL_DEFLECTION)
    }

    /// Minimum and maximum of the aircraft file, where it gives them.
    pub fn given(&self) -> [Option<f64>; 2] {
        [self.minimum, self.maximum].map(|bound| match bound {
            Bound::Given(bound) => Some(bound),
            Bound::None | Bound::Usual(_) => None,
        })
    }

    /// Whether all ends that there are are finite.
    pub(crate) fn are_finite(&self) -> bool {
        [self.minimum, self.maximum].iter().all(|end| end.value().is_none_or(f64::is_finite))
    }

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
    /// The usual ones: ±15° of incidence, Mach 0.7, no negative thrust.
    fn default() -> Self {
        Limits {
            angle_of_attack: Bounds::usual_angles(USUAL_ANGLE_OF_ATTACK),
            mach: Bounds { minimum: Bound::None, maximum: Bound::Usual(USUAL_MACH) },
            thrust: Bounds { minimum: Bound::Usual(USUAL_LEAST_THRUST), maximum: Bound::None },
        }
    }
}
