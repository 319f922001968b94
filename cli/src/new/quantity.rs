//! The numbers that may be given, and between which they lie.

use std::ops::RangeInclusive;

use super::Given;
use crate::numbers::{Plain, short};

/// A number that describes an aircraft.
pub struct Quantity {
    /// On the command line.
    pub option: &'static str,
    /// For people.
    pub label: &'static str,
    pub unit: &'static str,
    /// Numbers outside are slips of the pen, or aircraft for which the rules here do not hold.
    pub allowed: RangeInclusive<f64>,
    /// Why, where other numbers decide.
    pub because: &'static str,
    /// Where it is given.
    pub of: fn(&mut Given) -> &mut Option<f64>,
}

pub const SPAN: Quantity = quantity("--span", "span", "m", 0.5..=100.0, |given| &mut given.span);
pub const ROOT_CHORD: Quantity =
    quantity("--root-chord", "chord at the root", "m", 0.01..=40.0, |given| &mut given.root_chord);
pub const TIP_CHORD: Quantity =
    quantity("--tip-chord", "chord at the tip", "m", 0.005..=40.0, |given| &mut given.tip_chord);
pub const SWEEP: Quantity =
    quantity("--sweep", "sweep of the quarter chord", "deg", -20.0..=40.0, |given| &mut given.sweep);
pub const DIHEDRAL: Quantity =
    quantity("--dihedral", "dihedral", "deg", -10.0..=15.0, |given| &mut given.dihedral);
pub const MASS: Quantity = quantity("--mass", "mass", "kg", 0.01..=1e6, |given| &mut given.mass);
pub const ALTITUDE: Quantity =
    quantity("--altitude", "altitude", "m", -500.0..=30000.0, |given| &mut given.altitude);
pub const AIRSPEED: Quantity =
    quantity("--airspeed", "true airspeed", "m/s", 2.0..=250.0, |given| &mut given.airspeed);
pub const FREQUENCY: Quantity =
    quantity("--bending-frequency", "first bending of the wing", "Hz", 0.05..=200.0, |given| {
        &mut given.bending_frequency
    });

/// All of them, in the order in which they are asked for.
pub const ALL: [Quantity; 9] =
    [SPAN, ROOT_CHORD, TIP_CHORD, SWEEP, DIHEDRAL, MASS, ALTITUDE, AIRSPEED, FREQUENCY];

const fn quantity(
    option: &'static str,
    label: &'static str,
    unit: &'static str,
    allowed: RangeInclusive<f64>,
    of: fn(&mut Given) -> &mut Option<f64>,
) -> Quantity {
    Quantity { option, label, unit, allowed, because: "", of }
}

impl Quantity {
    /// With narrower ends.
    pub fn within(self, [low, high]: [f64; 2], because: &'static str) -> Self {
        let allowed = low.max(*self.allowed.start())..=high.min(*self.allowed.end());
        Quantity { allowed, because, ..self }
    }

    /// What is allowed, for people.
    pub fn allowed(&self) -> String {
        let [low, high] = [self.allowed.start(), self.allowed.end()].map(|end| short(*end));
        format!("{low} to {high} {}{}", self.unit, self.because)
    }
}

/// As people give numbers.
pub fn to_three_digits(number: f64) -> f64 {
    // PROOF: what is written as a number is read as one; the number itself stands in for any doubt.
    format!("{number:.2e}").parse().unwrap_or(number)
}

/// For people, with three digits.
pub fn in_three_digits(number: f64) -> String {
    Plain(to_three_digits(number)).to_string()
}

/// What is aimed at, by the mean aerodynamic chord.
pub const STATIC_MARGIN: f64 = 0.1;

/// Of both chords and the span together, b²/S.
pub const ASPECT_RATIOS: [f64; 2] = [3.0, 60.0];

/// Sweeps of what has no tail, degrees: less gives elevons no arm.
pub const SWEEPS_WITHOUT_TAIL: [f64; 2] = [10.0, 40.0];

/// Tip chord by root chord.
pub const TAPERS: [f64; 2] = [0.1, 1.0];

/// Lift coefficients of trims: nothing stalls in this program, the aircraft that is meant does.
pub const LIFT_COEFFICIENTS: [f64; 2] = [0.1, 1.3];

/// The highest Mach number: the air is incompressible in this program, and above this `flexair` warns of trims.
pub const MOST_MACH: f64 = 0.7;

/// How many bends a second a wing may have by what is usual of its span: its frequency times its span is then 9 to 350 m/s, which
/// is not unusual to `flexair check`.
pub const FREQUENCY_RATIOS: [f64; 2] = [0.2, 5.0];
