//! Units of the variables, and how they are made of SI base units with integer exponents: all that FMI can say.
//! The √kg of mass-normalised modes is outside of that, and their coordinates have no unit.

/// Unit of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unit {
    /// 1
    One,
    /// m
    Metre,
    /// m/s
    MetrePerSecond,
    /// m/s²
    MetrePerSecondSquared,
    /// rad, shown in degrees
    Radian,
    /// rad/s, shown in degrees per second
    RadianPerSecond,
    /// rad/s², shown in degrees per second squared
    RadianPerSecondSquared,
    /// N
    Newton,
    /// N·m
    NewtonMetre,
    /// Pa
    Pascal,
    /// kg/m³
    KilogramPerCubicMetre,
    /// s
    Second,
    /// K
    Kelvin,
    /// N/s
    NewtonPerSecond,
}

/// Integer exponents of the SI base units in a unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BaseUnit {
    /// Of kg.
    pub kilogram: i32,
    /// Of m.
    pub metre: i32,
    /// Of s.
    pub second: i32,
    /// Of rad.
    pub radian: i32,
    /// Of K.
    pub kelvin: i32,
}

/// A unit for showing: its name and the factor from the unit to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplayUnit {
    /// Name.
    pub name: &'static str,
    /// Shown value = factor × value.
    pub factor: f64,
}

const DEGREES_PER_RADIAN: f64 = 180.0 / core::f64::consts::PI;

impl Unit {
    /// All units, in the order of the model description.
    pub const ALL: [Unit; 14] = [
        Unit::One,
        Unit::Metre,
        Unit::MetrePerSecond,
        Unit::MetrePerSecondSquared,
        Unit::Radian,
        Unit::RadianPerSecond,
        Unit::RadianPerSecondSquared,
        Unit::Newton,
        Unit::NewtonMetre,
        Unit::Pascal,
        Unit::KilogramPerCubicMetre,
        Unit::Second,
        Unit::Kelvin,
        Unit::NewtonPerSecond,
    ];

    /// As written in the model description.
    pub fn name(self) -> &'static str {
        match self {
            Unit::One => "1",
            Unit::Metre => "m",
            Unit::MetrePerSecond => "m/s",
            Unit::MetrePerSecondSquared => "m/s2",
            Unit::Radian => "rad",
            Unit::RadianPerSecond => "rad/s",
            Unit::RadianPerSecondSquared => "rad/s2",
            Unit::Newton => "N",
            Unit::NewtonMetre => "N.m",
            Unit::Pascal => "Pa",
            Unit::KilogramPerCubicMetre => "kg/m3",
            Unit::Second => "s",
            Unit::Kelvin => "K",
            Unit::NewtonPerSecond => "N/s",
        }
    }

    /// What it is made of.
    pub fn base(self) -> BaseUnit {
        let one = BaseUnit::default();
        match self {
            Unit::One => one,
            Unit::Metre => BaseUnit { metre: 1, ..one },
            Unit::MetrePerSecond => BaseUnit { metre: 1, second: -1, ..one },
            Unit::MetrePerSecondSquared => BaseUnit { metre: 1, second: -2, ..one },
            Unit::Radian => BaseUnit { radian: 1, ..one },
            Unit::RadianPerSecond => BaseUnit { radian: 1, second: -1, ..one },
            Unit::RadianPerSecondSquared => BaseUnit { radian: 1, second: -2, ..one },
            Unit::Newton => BaseUnit { kilogram: 1, metre: 1, second: -2, ..one },
            Unit::NewtonMetre => BaseUnit { kilogram: 1, metre: 2, second: -2, ..one },
            Unit::Pascal => BaseUnit { kilogram: 1, metre: -1, second: -2, ..one },
            Unit::KilogramPerCubicMetre => BaseUnit { kilogram: 1, metre: -3, ..one },
            Unit::Second => BaseUnit { second: 1, ..one },
            Unit::Kelvin => BaseUnit { kelvin: 1, ..one },
            Unit::NewtonPerSecond => BaseUnit { kilogram: 1, metre: 1, second: -3, ..one },
        }
    }

    /// That of a rate of what has this unit, for the units of states.
    pub fn per_second(self) -> Option<Unit> {
        match self {
            Unit::Metre => Some(Unit::MetrePerSecond),
            Unit::MetrePerSecond => Some(Unit::MetrePerSecondSquared),
            Unit::Radian => Some(Unit::RadianPerSecond),
            Unit::RadianPerSecond => Some(Unit::RadianPerSecondSquared),
            Unit::Newton => Some(Unit::NewtonPerSecond),
            _ => None,
        }
    }

    /// The unit that people prefer to see, if another one.
    pub fn display(self) -> Option<DisplayUnit> {
        match self {
            Unit::Radian => Some(DisplayUnit { name: "deg", factor: DEGREES_PER_RADIAN }),
            Unit::RadianPerSecond => Some(DisplayUnit { name: "deg/s", factor: DEGREES_PER_RADIAN }),
            Unit::RadianPerSecondSquared => Some(DisplayUnit { name: "deg/s2", factor: DEGREES_PER_RADIAN }),
            _ => None,
        }
    }
}
