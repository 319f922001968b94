//! The numbers that may be given, and between which they lie.

use std::ops::RangeInclusive;

/// A number that describes an aircraft.
pub struct Quantity {
    /// On the command line.
    pub option: &'static str,
    /// For people.
    pub label: &'static str,
    pub unit: &'static str,
    /// Numbers outside are slips of the pen, or aircraft for which the rules here do not hold.
    pub allowed: RangeInclusive<f64>,
}

pub const SPAN: Quantity = Quantity { option: "--span", label: "span", unit: "m", allowed: 0.5..=100.0 };
pub const ROOT_CHORD: Quantity =
    Quantity { option: "--root-chord", label: "chord at the root", unit: "m", allowed: 0.01..=40.0 };
pub const TIP_CHORD: Quantity =
    Quantity { option: "--tip-chord", label: "chord at the tip", unit: "m", allowed: 0.005..=40.0 };
pub const SWEEP: Quantity =
    Quantity { option: "--sweep", label: "sweep of the quarter chord", unit: "deg", allowed: -20.0..=40.0 };
pub const DIHEDRAL: Quantity =
    Quantity { option: "--dihedral", label: "dihedral", unit: "deg", allowed: -10.0..=15.0 };
pub const MASS: Quantity = Quantity { option: "--mass", label: "mass", unit: "kg", allowed: 0.01..=1e6 };
pub const ALTITUDE: Quantity =
    Quantity { option: "--altitude", label: "altitude", unit: "m", allowed: -500.0..=20000.0 };
pub const AIRSPEED: Quantity =
    Quantity { option: "--airspeed", label: "true airspeed", unit: "m/s", allowed: 2.0..=250.0 };
pub const FREQUENCY: Quantity = Quantity {
    option: "--bending-frequency",
    label: "first bending of the wing",
    unit: "Hz",
    allowed: 0.05..=200.0,
};

/// Of both chords and the span together, b²/S.
pub const ASPECT_RATIOS: RangeInclusive<f64> = 3.0..=60.0;

/// Tip chord by root chord.
pub const TAPERS: RangeInclusive<f64> = 0.1..=1.0;

/// Lift coefficients of trims: nothing stalls in this program, the aircraft that is meant does.
pub const LIFT_COEFFICIENTS: RangeInclusive<f64> = 0.1..=1.3;

/// The highest Mach number: the air is incompressible in this program.
pub const MOST_MACH: f64 = 0.65;

/// How many bends a second a wing may have by what is usual of its span.
pub const FREQUENCY_RATIOS: RangeInclusive<f64> = 0.2..=5.0;
