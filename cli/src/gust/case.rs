//! One gust of a set.

use flexible_aircraft::air::GustSettings;

use crate::numbers::{Plain, short};

/// A gust or its opposite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    Positive,
    Negative,
}

/// A gust.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    pub gust: GustSettings,
    /// Against the direction that was asked for, or along it.
    pub sense: Sense,
    /// Into which it blows across the track: 0 upwards, 90 to the right, more than −180 and up to 180.
    pub degrees: f64,
}

impl Sense {
    pub const BOTH: [Sense; 2] = [Sense::Positive, Sense::Negative];

    /// For tables.
    pub fn name(self) -> &'static str {
        match self {
            Sense::Positive => "positive",
            Sense::Negative => "negative",
        }
    }
}

impl Case {
    /// A gust like others with a gradient, m, in a direction or against it. Its velocity changes sign as a whole: that of
    /// cos ι (cos δ up + sin δ right) + sin ι e does with δ + 180° and −ι.
    pub fn new(like: &GustSettings, gradient: f64, degrees: f64, sense: Sense) -> Self {
        let (degrees, inclination) = match sense {
            Sense::Positive => (degrees, like.inclination),
            Sense::Negative => (degrees + 180.0, -like.inclination),
        };
        // Rounded: of -149.9 subtractions leave -149.89999999999998.
        let degrees = (1e9 * (180.0 - (180.0 - degrees).rem_euclid(360.0))).round() / 1e9;
        let gust = GustSettings { gradient, direction: degrees.to_radians(), inclination, ..*like };
        Case { gust, sense, degrees }
    }

    /// The bits that tell it from others of the set.
    pub fn identity(&self) -> [u64; 3] {
        // Plus 0: of both zeros there is one.
        [self.gust.gradient, self.degrees, self.gust.inclination].map(|number| (number + 0.0).to_bits())
    }

    /// Where it blows, for people.
    pub fn way(&self) -> String {
        let across = across(self.degrees);
        match self.gust.inclination {
            0.0 => across,
            forward => format!("{across} {} rad forward", Plain(forward)),
        }
    }

    /// For people, and in tables.
    pub fn name(&self) -> String {
        format!("gust {} m {}", short(self.gust.gradient), self.way())
    }
}

/// Where that blows which is so many degrees from upwards to the right, for people.
pub fn across(degrees: f64) -> String {
    match degrees {
        0.0 => "up".to_owned(),
        90.0 => "right".to_owned(),
        180.0 => "down".to_owned(),
        -90.0 => "left".to_owned(),
        other => format!("{} deg", Plain(other)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// cos ι (cos δ up + sin δ right) + sin ι e, as the gust is defined.
    fn vector(gust: &GustSettings) -> [f64; 3] {
        let GustSettings { direction, inclination, .. } = *gust;
        let across = inclination.cos();
        [across * direction.cos(), across * direction.sin(), inclination.sin()]
    }

    #[test]
    fn the_negative_sense_turns_the_whole_vector_around() {
        for (degrees, inclination) in [(0.0, 0.0), (90.0, 0.0), (0.0, 0.4), (-37.0, -1.2), (180.0, 1.5)] {
            let like = GustSettings { inclination, ..GustSettings::default() };
            let [positive, negative] =
                Sense::BOTH.map(|sense| vector(&Case::new(&like, 30.0, degrees, sense).gust));
            for (one, other) in positive.iter().zip(negative) {
                assert!((one + other).abs() < 1e-15, "{degrees} {inclination}: {positive:?} {negative:?}");
            }
        }
    }

    #[test]
    fn a_gust_is_named_after_where_it_blows() {
        let named = |degrees: f64, inclination: f64, sense: Sense| {
            Case::new(&GustSettings { inclination, ..GustSettings::default() }, 30.0, degrees, sense).name()
        };
        let [up, down] = Sense::BOTH.map(|sense| named(0.0, 0.0, sense));
        assert_eq!([up.as_str(), &down], ["gust 30 m up", "gust 30 m down"]);
        assert_eq!(named(270.0, 0.0, Sense::Positive), "gust 30 m left");
        assert_eq!(named(-180.0, 0.5, Sense::Negative), "gust 30 m up -0.5 rad forward");
        assert_eq!(named(30.1, 0.0, Sense::Positive), "gust 30 m 30.1 deg");
        assert_eq!(named(30.1, 0.0, Sense::Negative), "gust 30 m -149.9 deg");
    }
}
