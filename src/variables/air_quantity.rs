//! The quantities of the flow at O [theory: outputs.air-data].

use crate::flight::Part;
use crate::plant::AirData;

/// A quantity of the flow at O.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the quantities are documented in AirData")]
#[non_exhaustive]
pub enum AirQuantity {
    Speed,
    AngleOfAttack,
    Sideslip,
    Mach,
    Density,
    DynamicPressure,
    Equivalent,
    Calibrated,
    Pressure,
    Temperature,
}

impl AirQuantity {
    /// The part of what is read at an instant that it is in.
    pub(super) fn part(self) -> Part {
        match self {
            AirQuantity::Speed
            | AirQuantity::AngleOfAttack
            | AirQuantity::Sideslip
            | AirQuantity::Mach
            | AirQuantity::Density
            | AirQuantity::DynamicPressure
            | AirQuantity::Equivalent
            | AirQuantity::Pressure
            | AirQuantity::Temperature => Part::Usual,
            AirQuantity::Calibrated => Part::Further,
        }
    }

    /// Of the flow.
    pub(super) fn of(self, air: &AirData) -> f64 {
        match self {
            AirQuantity::Speed => air.speed,
            AirQuantity::AngleOfAttack => air.angle_of_attack,
            AirQuantity::Sideslip => air.sideslip,
            AirQuantity::Mach => air.mach,
            AirQuantity::Density => air.density,
            AirQuantity::DynamicPressure => air.dynamic_pressure,
            AirQuantity::Equivalent => air.equivalent,
            AirQuantity::Calibrated => air.calibrated,
            AirQuantity::Pressure => air.pressure,
            AirQuantity::Temperature => air.temperature,
        }
    }
}
