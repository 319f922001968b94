//! Units of a deck, which knows none: what a length, a force and a mass are in SI.

use clap::ValueEnum;

/// Consistent units: a mass is a force by a length, times the square of a second.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum UnitSystem {
    /// Metres, newtons, kilograms
    M,
    /// Millimetres, newtons, tonnes; masses in kilograms with PARAM,WTMASS,0.001
    Mm,
    /// Inches, pounds of force, masses in lbf s²/in; in pounds with PARAM,WTMASS,0.00259
    In,
    /// Feet, pounds of force, slugs; in pounds with PARAM,WTMASS,0.0311
    Ft,
}

/// N of a pound of force: the pound of 0.45359237 kg under standard gravity.
const POUND: f64 = 0.453_592_37 * 9.806_65;

/// What numbers of the deck are in SI.
#[derive(Clone, Copy, Debug)]
pub struct Units {
    /// m.
    pub length: f64,
    /// N.
    pub force: f64,
    /// kg, with what WTMASS multiplies by.
    pub mass: f64,
}

impl UnitSystem {
    pub fn name(self) -> &'static str {
        match self {
            UnitSystem::M => "m, N, kg",
            UnitSystem::Mm => "mm, N, t",
            UnitSystem::In => "in, lbf, lbf s²/in",
            UnitSystem::Ft => "ft, lbf, slug",
        }
    }

    /// With what masses are multiplied by.
    pub fn units(self, mass_factor: f64) -> Units {
        let (length, force) = match self {
            UnitSystem::M => (1.0, 1.0),
            UnitSystem::Mm => (1e-3, 1.0),
            UnitSystem::In => (0.0254, POUND),
            UnitSystem::Ft => (0.3048, POUND),
        };
        Units { length, force, mass: mass_factor * force / length }
    }
}

impl Units {
    /// N of a modulus times an area.
    pub fn axial(&self) -> f64 {
        self.force
    }

    /// N m² of a modulus times a second moment of area.
    pub fn bending(&self) -> f64 {
        self.force * self.length * self.length
    }

    /// kg/m of a mass by a length.
    pub fn mass_by_length(&self) -> f64 {
        self.mass / self.length
    }

    /// kg m².
    pub fn inertia(&self) -> f64 {
        self.mass * self.length * self.length
    }

    /// N m/rad.
    pub fn moment(&self) -> f64 {
        self.force * self.length
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn consistent_masses_are_those_of_the_books() {
        // 1 slug is 14.5939 kg, 1 lbf s²/in 175.127 kg [NIST Special Publication 811, appendix B.8].
        for (system, mass) in [
            (UnitSystem::M, 1.0),
            (UnitSystem::Mm, 1000.0),
            (UnitSystem::Ft, 14.5939),
            (UnitSystem::In, 175.127),
        ] {
            assert!((system.units(1.0).mass / mass - 1.0).abs() < 4e-6, "{}", system.name());
        }
        // A pound by WTMASS = 1/386.0886, the inches by s² of standard gravity.
        let pound = UnitSystem::In.units(1.0 / 386.0886).mass;
        assert!((pound / 0.453_592_37 - 1.0).abs() < 1e-7, "{pound}");
        let bending = UnitSystem::Mm.units(1.0).bending();
        assert_eq!(bending, 1e-6);
    }
}
