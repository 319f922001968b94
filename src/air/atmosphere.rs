//! International Standard Atmosphere, troposphere and lower stratosphere (ISO 2533), on warmer and colder days, and air of one density.
//!
//! [theory: air.atmosphere, air.tunnel]

use crate::aircraft::TunnelAir;

/// g₀: standard gravity, m/s².
pub const STANDARD_GRAVITY: f64 = 9.80665;
/// Specific gas constant of dry air, J/(kg·K).
const GAS_CONSTANT: f64 = 287.05287;
/// Sea-level temperature, K.
const SEA_LEVEL_TEMPERATURE: f64 = 288.15;
/// Sea-level pressure, Pa.
pub const SEA_LEVEL_PRESSURE: f64 = 101_325.0;
/// Temperature lapse rate of the troposphere, K/m.
const LAPSE_RATE: f64 = 0.0065;
/// Geopotential altitude of the tropopause, m.
const TROPOPAUSE: f64 = 11_000.0;
/// Geopotential altitude from which on the stratosphere becomes warmer, m.
const WARMING: f64 = 20_000.0;
/// By how much it does, K/m.
const WARMING_RATE: f64 = 0.001;
/// Sea-level density, kg/m³.
pub const SEA_LEVEL_DENSITY: f64 = 1.225;
/// Ratio of specific heats.
const HEAT_RATIO: f64 = 1.4;

/// The air at one altitude.
///
/// ```
/// use flexible_aircraft::air::Air;
///
/// let [ground, cruise] = [0.0, 11_000.0].map(Air::at); // m
/// assert!((ground.density - 1.225).abs() < 1e-4); // kg/m³
/// assert!((cruise.speed_of_sound - 295.07).abs() < 0.01); // m/s
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Air {
    /// ρ, kg/m³.
    pub density: f64,
    /// m/s.
    pub speed_of_sound: f64,
    /// Pa.
    pub pressure: f64,
    /// K.
    pub temperature: f64,
}

/// How the air is over altitude.
///
/// ```
/// use flexible_aircraft::air::{Air, Atmosphere};
///
/// let hot = Atmosphere::Standard { temperature_offset: 20.0 }.at(0.0); // K, m
/// assert_eq!((hot.pressure, hot.temperature), (101_325.0, 308.15)); // Pa, K
/// assert!((hot.density - 1.1455).abs() < 1e-4); // kg/m³
/// assert_eq!(Atmosphere::Standard { temperature_offset: 0.0 }.at(7620.0), Air::at(7620.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Atmosphere {
    /// The standard atmosphere's pressures, at temperatures that differ from the standard's by the same everywhere.
    Standard {
        /// K.
        temperature_offset: f64,
    },
    /// The same at all altitudes.
    Uniform(Air),
}

impl Atmosphere {
    /// That of a tunnel with air of its own, or the standard one on a day that is warmer by so many K.
    pub fn new(tunnel_air: Option<&TunnelAir>, temperature_offset: f64) -> Self {
        match tunnel_air {
            Some(air) => Atmosphere::Uniform(Air::of_tunnel(air)),
            None => Atmosphere::Standard { temperature_offset },
        }
    }

    /// At a geopotential altitude in m.
    pub fn at(self, altitude: f64) -> Air {
        match self {
            Atmosphere::Standard { temperature_offset } => Air::warmer(altitude, temperature_offset),
            Atmosphere::Uniform(air) => air,
        }
    }
}

impl Air {
    /// The standard atmosphere at a geopotential altitude in m [theory: air.atmosphere].
    pub fn at(altitude: f64) -> Self {
        Air::warmer(altitude, 0.0)
    }

    /// At a geopotential altitude (m) on a day that is warmer than the standard's by so many K [theory: air.temperature-offset].
    fn warmer(altitude: f64, offset: f64) -> Self {
        let standard = SEA_LEVEL_TEMPERATURE - LAPSE_RATE * altitude.min(TROPOPAUSE);
        let exponent = STANDARD_GRAVITY / (LAPSE_RATE * GAS_CONSTANT);
        let mut pressure = SEA_LEVEL_PRESSURE * libm::pow(standard / SEA_LEVEL_TEMPERATURE, exponent);
        if altitude > TROPOPAUSE {
            let above = altitude.min(WARMING) - TROPOPAUSE;
            pressure *= libm::exp(-STANDARD_GRAVITY * above / (GAS_CONSTANT * standard));
        }
        let mut temperature = standard;
        if altitude > WARMING {
            temperature += WARMING_RATE * (altitude - WARMING);
            let exponent = STANDARD_GRAVITY / (WARMING_RATE * GAS_CONSTANT);
            pressure *= libm::pow(standard / temperature, exponent);
        }
        let temperature = temperature + offset;
        Air {
            density: pressure / (GAS_CONSTANT * temperature),
            speed_of_sound: speed_of_sound(temperature),
            pressure,
            temperature,
        }
    }

    /// That of a wind tunnel [theory: air.tunnel].
    pub fn of_tunnel(air: &TunnelAir) -> Self {
        let TunnelAir { density, temperature } = *air;
        Air {
            density,
            speed_of_sound: speed_of_sound(temperature),
            pressure: density * GAS_CONSTANT * temperature,
            temperature,
        }
    }
}

/// Of air at a temperature in K, m/s.
fn speed_of_sound(temperature: f64) -> f64 {
    libm::sqrt(HEAT_RATIO * GAS_CONSTANT * temperature)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tunnel_has_the_density_and_temperature_that_it_is_given() {
        // √(1.4 · 287.05287 · 300) m/s.
        let air = Air::of_tunnel(&TunnelAir { density: 0.9, temperature: 300.0 });
        assert!(air.density == 0.9 && (air.speed_of_sound - 347.220687).abs() < 1e-5, "{air:?}");
    }

    #[test]
    fn density_and_speed_of_sound_are_those_of_the_standard_tables() {
        // ISO 2533:1975, table 5: altitude (m), density (kg/m³), speed of sound (m/s).
        for (altitude, density, sound) in [
            (0.0, 1.225, 340.294),
            (5000.0, 0.736116, 320.529),
            (11_000.0, 0.363918, 295.069),
            (15_000.0, 0.193674, 295.069),
            (20_000.0, 0.0880349, 295.070),
            (25_000.0, 0.0394658, 298.455),
            (30_000.0, 0.0180119, 301.803),
        ] {
            let air = Air::at(altitude);
            assert!((air.density / density - 1.0).abs() < 2e-5, "{altitude}: {air:?}");
            assert!((air.speed_of_sound / sound - 1.0).abs() < 2e-5, "{altitude}: {air:?}");
        }
    }

    #[test]
    fn pressures_and_temperatures_are_those_of_the_standard_where_its_layers_meet() {
        // U.S. Standard Atmosphere 1976, whose lower part is that of ISO 2533: geopotential altitude (m), pressure (Pa),
        // temperature (K) at the bases of its layers; the last is the top of the third.
        for (altitude, pressure, temperature) in [
            (0.0, 101_325.0, 288.15),
            (11_000.0, 22_632.1, 216.65),
            (20_000.0, 5474.89, 216.65),
            (32_000.0, 868.02, 228.65),
        ] {
            let air = Air::at(altitude);
            assert!((air.temperature - temperature).abs() < 1e-9, "{altitude}: {air:?}");
            assert!((air.pressure / pressure - 1.0).abs() < 5e-6, "{altitude}: {air:?}");
        }
    }

    #[test]
    fn a_warm_day_has_the_standard_pressures_and_thinner_air() {
        for altitude in [-500.0, 7620.0, 15_000.0, 27_000.0] {
            let standard = Air::at(altitude);
            assert_eq!(Atmosphere::new(None, 0.0).at(altitude), standard);
            for offset in [-60.0, 25.0] {
                let air = Atmosphere::new(None, offset).at(altitude);
                let ratio = (standard.temperature + offset) / standard.temperature;
                assert_eq!(
                    (air.pressure, air.temperature),
                    (standard.pressure, standard.temperature + offset)
                );
                assert!((air.density * ratio / standard.density - 1.0).abs() < 1e-15, "{altitude}: {air:?}");
                let sound = standard.speed_of_sound * ratio.sqrt();
                assert!((air.speed_of_sound / sound - 1.0).abs() < 1e-15, "{altitude}: {air:?}");
            }
        }
    }
}
