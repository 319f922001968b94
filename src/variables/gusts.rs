//! The rows of gusts and turbulence, parameters and outputs.

use crate::air::{GUST_GRADIENTS, GUST_STARTS, MAXIMUM_OPERATING_ALTITUDES, TURBULENCE_SCALES};
use crate::flight::Settings;

use super::axis::Axis;
use super::enumeration::EnumerationType;
use super::gust_slot::{GustSetting, TurbulenceSetting};
use super::output_slot::OutputSlot;
use super::row::{output, parameter};
use super::slot::ParameterSlot;
use super::unit::Unit;
use super::variable::{Type, Variability, Variable};

/// The parameters of the single gust and of the turbulence.
pub(super) fn parameters(start: &Settings) -> Vec<Variable> {
    let mut rows = gust(start);
    rows.extend(turbulence(start));
    rows
}

/// The air's velocity, and the gust's.
pub(super) fn outputs() -> Vec<Variable> {
    let wind = Axis::ALL.into_iter().zip(["north", "east", "down"]).map(|(axis, direction)| {
        let text = format!("Velocity of the air at O towards {direction}: wind, tunnel, gust and turbulence");
        output(format!("wind.{direction}"), Unit::MetrePerSecond, OutputSlot::Wind(axis), text)
    });
    let text = "Peak of the single gust (true airspeed), as set or by its criterion; 0 where there is none";
    let peak = output(
        "gust.peak_velocity".to_owned(),
        Unit::MetrePerSecond,
        OutputSlot::GustPeakVelocity,
        text.to_owned(),
    );
    wind.chain([Variable { variability: Variability::Discrete, ..peak }]).collect()
}

fn gust(start: &Settings) -> Vec<Variable> {
    use GustSetting as G;
    let row = |name: &str, setting, text: &str| {
        parameter(format!("gust.{name}"), ParameterSlot::Gust(setting), start, text)
    };
    let real = |name, setting, unit, text| Variable { unit: Some(unit), ..row(name, setting, text) };
    vec![
        choice(
            row("shape", G::Shape, "Shape of a single gust, frozen in the air ahead"),
            EnumerationType::GustShape,
        ),
        real(
            "gradient",
            G::Gradient,
            Unit::Metre,
            "From where the gust begins to where it peaks; 9.144 to 106.68 m with CS-25",
        )
        .within(GUST_GRADIENTS),
        real(
            "peak",
            G::Peak,
            Unit::MetrePerSecond,
            "Peak of the gust, true airspeed, where gust.criterion says so",
        ),
        real(
            "direction",
            G::Direction,
            Unit::Radian,
            "Direction of the gust across the track: 0 upwards, positive to the right",
        ),
        real(
            "inclination",
            G::Inclination,
            Unit::Radian,
            "Inclination of the gust from across the track to along it",
        ),
        real("start", G::Start, Unit::Second, "When the foremost strip meets the gust, after the start")
            .within(GUST_STARTS),
        choice(
            row("criterion", G::Criterion, "What the peak of the gust follows from"),
            EnumerationType::GustCriterion,
        ),
        real(
            "alleviation",
            G::Alleviation,
            Unit::One,
            "Flight profile alleviation factor F_g of CS-25 at sea level",
        )
        .between(0.0, 1.0),
        real(
            "maximum_operating_altitude",
            G::MaximumOperatingAltitude,
            Unit::Metre,
            "Altitude at which F_g is 1",
        )
        .within(MAXIMUM_OPERATING_ALTITUDES)
        .nominal(10_000.0),
    ]
}

fn turbulence(start: &Settings) -> Vec<Variable> {
    use TurbulenceSetting as T;
    let row = |name: &str, setting, text: &str| {
        parameter(format!("turbulence.{name}"), ParameterSlot::Turbulence(setting), start, text)
    };
    let real = |name, setting, unit, text| Variable { unit: Some(unit), ..row(name, setting, text) };
    vec![
        choice(
            row("spectrum", T::Spectrum, "Spectrum of continuous turbulence, frozen in the air ahead"),
            EnumerationType::TurbulenceSpectrum,
        ),
        real(
            "intensity",
            T::Intensity,
            Unit::MetrePerSecond,
            "Root mean square of each component of the turbulence, true airspeed",
        )
        .at_least(0.0),
        real(
            "scale",
            T::Scale,
            Unit::Metre,
            "Length scale L of the turbulence; 0 stands for 533.4 m (dryden) or 762 m (von_karman)",
        )
        .between(0.0, *TURBULENCE_SCALES.end()),
        Variable { kind: Type::Integer, ..row("seed", T::Seed, "Which of all fields of turbulence") },
        choice(
            row("components", T::Components, "Components of the turbulence that blow"),
            EnumerationType::TurbulenceComponents,
        ),
        real(
            "start",
            T::Start,
            Unit::Second,
            "When the foremost strip meets the turbulence, after the start",
        )
        .within(GUST_STARTS),
    ]
}

/// A choice among the items of an enumeration.
fn choice(row: Variable, kind: EnumerationType) -> Variable {
    Variable { kind: Type::Enumeration(kind), ..row }.between(1.0, kind.items().len() as f64)
}
