//! The numbers that a quantity can take: wide ranges for anything that flies, narrow enough to find slips of
//! the pen and to keep the arithmetic that follows far from overflow.

use crate::aircraft::model::{AIRSPEEDS, ALTITUDES, TEMPERATURE_OFFSETS, TUNNEL_SPEEDS};

/// The numbers that a quantity can take.
#[derive(Debug)]
pub struct Allowed {
    /// What it is and in which unit, with its article: `a mass in kg`.
    pub quantity: &'static str,
    /// Its numbers.
    pub range: Range,
    /// Whether the range is said behind the verb, where the quantity's own words would run into it.
    pub is_range_last: bool,
}

/// Finite numbers from one to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// All.
    All,
    /// With both ends.
    Closed(f64, f64),
    /// Without the lower end.
    Above(f64, f64),
    /// Without the ends.
    Between(f64, f64),
}

impl Allowed {
    const fn new(quantity: &'static str, range: Range) -> Self {
        Allowed { quantity, range, is_range_last: false }
    }

    /// The end of a message: `a mass in kg from 1e-9 to 1e9 is allowed`.
    pub fn text(&self) -> String {
        let quantity = self.quantity;
        match self.range {
            Range::All => format!("{quantity} is allowed"),
            range if self.is_range_last => format!("{quantity} is allowed, {}", range.in_a_sentence()),
            range => format!("{quantity} {} is allowed", range.in_a_sentence()),
        }
    }
}

impl Range {
    /// Whether a number is one of these.
    pub fn contains(self, number: f64) -> bool {
        number.is_finite()
            && match self {
                Range::All => true,
                Range::Closed(least, most) => least <= number && number <= most,
                Range::Above(low, most) => low < number && number <= most,
                Range::Between(low, high) => low < number && number < high,
            }
    }

    /// For tables: `0 to 1000`. `None` of all numbers.
    pub fn in_words(self) -> Option<String> {
        match self {
            Range::All => None,
            Range::Closed(least, most) => Some(format!("{} to {}", in_digits(least), in_digits(most))),
            Range::Above(low, most) => Some(format!("above {} up to {}", in_digits(low), in_digits(most))),
            Range::Between(low, high) => Some(format!("between {} and {}", in_digits(low), in_digits(high))),
        }
    }

    /// Within a sentence.
    fn in_a_sentence(self) -> String {
        match self {
            Range::All => String::new(),
            Range::Closed(least, most) => format!("from {} to {}", in_digits(least), in_digits(most)),
            Range::Above(low, most) => format!("above {} up to {}", in_digits(low), in_digits(most)),
            Range::Between(low, high) => {
                format!("greater than {} and less than {}", in_digits(low), in_digits(high))
            }
        }
    }
}

/// A bound as people write it: with an exponent where there would be many zeros otherwise.
fn in_digits(bound: f64) -> String {
    let magnitude = bound.abs();
    if magnitude == 0.0 || (1e-3..1e5).contains(&magnitude) {
        format!("{bound}")
    } else {
        format!("{bound:e}")
    }
}

pub static ANY: Allowed = Allowed::new("a finite number", Range::All);
pub static FRACTION: Allowed = Allowed::new("a fraction", Range::Closed(0.0, 1.0));
pub static ANGLE_DEG: Allowed = Allowed::new("an angle in degrees", Range::Closed(-90.0, 90.0));
pub static TURN_DEG: Allowed = Allowed::new("an angle in degrees", Range::Closed(-180.0, 180.0));
pub static PITCH_DEG: Allowed = Allowed::new("a pitch in degrees", Range::Closed(-89.0, 89.0));

pub static GRAVITY: Allowed = Allowed::new("an acceleration in m/s²", Range::Closed(0.0, 1000.0));
/// In a tunnel, where the air may stand still.
pub static AIRSPEED: Allowed =
    Allowed::new("an airspeed in m/s", Range::Closed(*TUNNEL_SPEEDS.start(), *TUNNEL_SPEEDS.end()));
/// Of what flies.
pub static FLIGHT_SPEED: Allowed =
    Allowed::new("an airspeed in m/s", Range::Closed(*AIRSPEEDS.start(), *AIRSPEEDS.end()));
pub static ALTITUDE: Allowed =
    Allowed::new("an altitude in metres", Range::Closed(*ALTITUDES.start(), *ALTITUDES.end()));
pub static TEMPERATURE_OFFSET: Allowed = Allowed::new(
    "a difference of temperatures in K",
    Range::Closed(*TEMPERATURE_OFFSETS.start(), *TEMPERATURE_OFFSETS.end()),
);
pub static DENSITY: Allowed = Allowed::new("a density in kg/m³", Range::Closed(1e-9, 1e5));
pub static TEMPERATURE: Allowed = Allowed::new("a temperature in K", Range::Closed(1.0, 2000.0));
pub static MACH: Allowed = Allowed::new("a Mach number", Range::Above(0.0, 10.0));
pub static THRUST: Allowed = Allowed::new("a thrust in N", Range::Closed(-1e9, 1e9));

pub static TORQUE_PER_THRUST: Allowed =
    Allowed::new("a torque in N m per N of thrust", Range::Closed(-100.0, 100.0));
pub static ANGULAR_MOMENTUM: Allowed =
    Allowed::new("an angular momentum in kg m²/s", Range::Closed(-1e9, 1e9));
pub static THRUST_SHARE: Allowed = Allowed::new("a share of the thrust", Range::Closed(0.0, 1e6));

pub static LENGTH: Allowed = Allowed::new("a length in metres", Range::Closed(-1000.0, 1000.0));
pub static POSITIVE_LENGTH: Allowed = Allowed::new("a length in metres", Range::Closed(1e-6, 1000.0));
/// Along a component, which ends somewhere.
pub static DISTANCE: Allowed = Allowed::new("a distance in metres", Range::Closed(0.0, 1e6));
pub static REFERENCE_AREA: Allowed = Allowed::new("an area in m²", Range::Closed(1e-12, 1e6));
pub static GYRATION: Allowed = Allowed::new("a radius of gyration", Range::Closed(0.0, 1000.0));
pub static CHORDS: Allowed = Allowed::new("a number of chords", Range::Closed(-1000.0, 1000.0));

pub static BEAM_STIFFNESS: Allowed = Allowed::new("a stiffness in N or N m²", Range::Closed(1e-6, 1e15));
pub static STIFFNESS_PRODUCT: Allowed =
    Allowed::new("a coupling stiffness in N m²", Range::Closed(-1e15, 1e15));
pub static STIFFNESS_ENTRY: Allowed =
    Allowed::new("a stiffness in N, N m or N m²", Range::Closed(-1e15, 1e15));
pub static MASS_ENTRY: Allowed =
    Allowed::new("a mass per length in kg/m, kg or kg m", Range::Closed(-1e9, 1e9));
pub static MODULUS: Allowed = Allowed::new("a modulus in Pa", Range::Closed(1.0, 1e13));
pub static SPRING: Allowed = Allowed::new("a stiffness in N m/rad", Range::Closed(1e-6, 1e15));
pub static MASS: Allowed = Allowed::new("a mass in kg", Range::Closed(1e-9, 1e9));
pub static SHARE: Allowed = Allowed::new("a share", Range::Closed(1e-9, 1e9));
pub static INERTIA: Allowed = Allowed::new("a moment of inertia in kg m²", Range::Closed(0.0, 1e12));
pub static INERTIA_PRODUCT: Allowed =
    Allowed::new("a product of inertia in kg m²", Range::Closed(-1e12, 1e12));

pub static LIFT_SLOPE: Allowed = Allowed::new("a lift slope per radian", Range::Closed(0.0, 100.0));
pub static FLAP_LIFT_SLOPE: Allowed = Allowed::new("a lift slope per radian", Range::Closed(1e-6, 100.0));
pub static DRAG_COEFFICIENT: Allowed = Allowed::new("a drag coefficient", Range::Closed(0.0, 10.0));
pub static MOMENT_COEFFICIENT: Allowed = Allowed::new("a moment coefficient", Range::Closed(-10.0, 10.0));
pub static MOMENT_COEFFICIENT_SLOPE: Allowed =
    Allowed::new("a slope of a moment coefficient per radian", Range::Closed(-100.0, 100.0));
pub static FLAP_DRAG_COEFFICIENT: Allowed =
    Allowed::new("a drag coefficient per square radian", Range::Closed(0.0, 100.0));
pub static GAIN: Allowed = Allowed::new("a gain", Range::Closed(-100.0, 100.0));
pub static INSIDE_THE_CHORD: Allowed = Allowed {
    quantity: "a fraction of the chord behind the leading edge",
    range: Range::Between(0.0, 1.0),
    is_range_last: true,
};
pub static NEAR_THE_CHORD: Allowed = Allowed {
    quantity: "a fraction of the chord behind the leading edge",
    range: Range::Closed(-1.0, 2.0),
    is_range_last: true,
};
