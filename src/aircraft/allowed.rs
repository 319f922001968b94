//! The numbers that a quantity can take: wide ranges for anything that flies, narrow enough to find slips of
//! the pen and to keep the arithmetic that follows far from overflow.

use super::error::{Place, Problem, Report};
use super::model::{ALTITUDES, TUNNEL_SPEEDS};

/// The numbers that a quantity can take.
pub(super) struct Allowed {
    contains: fn(f64) -> bool,
    text: &'static str,
}

pub(super) const ANY: Allowed = Allowed { contains: |_| true, text: "a finite number is allowed" };
pub(super) const FRACTION: Allowed =
    Allowed { contains: |x| (0.0..=1.0).contains(&x), text: "a fraction from 0 to 1 is allowed" };
pub(super) const ANGLE_DEG: Allowed = Allowed {
    contains: |x| (-90.0..=90.0).contains(&x),
    text: "an angle in degrees from -90 to 90 is allowed",
};
pub(super) const GRAVITY: Allowed = Allowed {
    contains: |x| (0.0..=1000.0).contains(&x),
    text: "an acceleration in m/s² from 0 to 1000 is allowed",
};
pub(super) const AIRSPEED: Allowed =
    Allowed { contains: |x| TUNNEL_SPEEDS.contains(&x), text: "an airspeed in m/s from 0 to 400 is allowed" };
pub(super) const ALTITUDE: Allowed = Allowed {
    contains: |x| ALTITUDES.contains(&x),
    text: "an altitude in metres from -1000 to 20000 is allowed",
};
pub(super) const DENSITY: Allowed = Allowed {
    contains: |x| (1e-9..=1e5).contains(&x),
    text: "a density in kg/m³ from 1e-9 to 1e5 is allowed",
};
pub(super) const TEMPERATURE: Allowed = Allowed {
    contains: |x| (1.0..=2000.0).contains(&x),
    text: "a temperature in K from 1 to 2000 is allowed",
};
pub(super) const TURN_DEG: Allowed = Allowed {
    contains: |x| (-180.0..=180.0).contains(&x),
    text: "an angle in degrees from -180 to 180 is allowed",
};

pub(super) const MACH: Allowed =
    Allowed { contains: |x| x > 0.0 && x <= 10.0, text: "a Mach number above 0 up to 10 is allowed" };
pub(super) const THRUST: Allowed =
    Allowed { contains: |x| (-1e9..=1e9).contains(&x), text: "a thrust in N from -1e9 to 1e9 is allowed" };

pub(super) const LENGTH: Allowed = Allowed {
    contains: |x| (-1000.0..=1000.0).contains(&x),
    text: "a length in metres from -1000 to 1000 is allowed",
};
pub(super) const POSITIVE_LENGTH: Allowed = Allowed {
    contains: |x| (1e-6..=1000.0).contains(&x),
    text: "a length in metres from 1e-6 to 1000 is allowed",
};
pub(super) const REFERENCE_AREA: Allowed =
    Allowed { contains: |x| (1e-12..=1e6).contains(&x), text: "an area in m² from 1e-12 to 1e6 is allowed" };
pub(super) const GYRATION: Allowed = Allowed {
    contains: |x| (0.0..=1000.0).contains(&x),
    text: "a radius of gyration from 0 to 1000 is allowed",
};
pub(super) const CHORDS: Allowed = Allowed {
    contains: |x| (-1000.0..=1000.0).contains(&x),
    text: "a number of chords from -1000 to 1000 is allowed",
};

pub(super) const BEAM_STIFFNESS: Allowed = Allowed {
    contains: |x| (1e-6..=1e15).contains(&x),
    text: "a stiffness in N or N m² from 1e-6 to 1e15 is allowed",
};
pub(super) const MASS: Allowed =
    Allowed { contains: |x| (1e-9..=1e9).contains(&x), text: "a mass in kg from 1e-9 to 1e9 is allowed" };
pub(super) const SHARE: Allowed =
    Allowed { contains: |x| (1e-9..=1e9).contains(&x), text: "a share from 1e-9 to 1e9 is allowed" };
pub(super) const INERTIA: Allowed = Allowed {
    contains: |x| (0.0..=1e12).contains(&x),
    text: "a moment of inertia in kg m² from 0 to 1e12 is allowed",
};
pub(super) const INERTIA_PRODUCT: Allowed = Allowed {
    contains: |x| (-1e12..=1e12).contains(&x),
    text: "a product of inertia in kg m² from -1e12 to 1e12 is allowed",
};

pub(super) const LIFT_SLOPE: Allowed = Allowed {
    contains: |x| (0.0..=100.0).contains(&x),
    text: "a lift slope per radian from 0 to 100 is allowed",
};
pub(super) const FLAP_LIFT_SLOPE: Allowed = Allowed {
    contains: |x| (1e-6..=100.0).contains(&x),
    text: "a lift slope per radian from 1e-6 to 100 is allowed",
};
pub(super) const DRAG: Allowed =
    Allowed { contains: |x| (0.0..=10.0).contains(&x), text: "a drag coefficient from 0 to 10 is allowed" };
pub(super) const MOMENT: Allowed = Allowed {
    contains: |x| (-10.0..=10.0).contains(&x),
    text: "a moment coefficient from -10 to 10 is allowed",
};
pub(super) const GAIN: Allowed =
    Allowed { contains: |x| (-100.0..=100.0).contains(&x), text: "a gain from -100 to 100 is allowed" };
pub(super) const INSIDE_THE_CHORD: Allowed = Allowed {
    contains: |x| x > 0.0 && x < 1.0,
    text: "a fraction of the chord behind the leading edge is allowed, greater than 0 and less than 1",
};
pub(super) const NEAR_THE_CHORD: Allowed = Allowed {
    contains: |x| (-1.0..=2.0).contains(&x),
    text: "a fraction of the chord behind the leading edge is allowed, from -1 to 2",
};

impl Allowed {
    /// Complains about a number that is not finite or not allowed; true when it is in order.
    pub(super) fn check(&self, number: f64, place: &Place, report: &Report) -> bool {
        let problem = match number {
            _ if !number.is_finite() => Problem::NotFinite,
            _ if !(self.contains)(number) => Problem::OutOfRange,
            _ => return true,
        };
        report.add(problem, place, format!("found {}", in_digits(number)), self.text);
        false
    }
}

/// As people write it: with an exponent where there would be many digits otherwise.
fn in_digits(number: f64) -> String {
    let magnitude = number.abs();
    let is_plain = magnitude == 0.0 || (1e-6..1e10).contains(&magnitude) || !number.is_finite();
    if is_plain { format!("{number}") } else { format!("{number:e}") }
}
