//! International Standard Atmosphere, troposphere and isothermal lower stratosphere (ISO 2533), and air of one density.
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

impl Air {
    /// The standard atmosphere at a geopotential altitude in m [theory: air.atmosphere].
    pub fn at(altitude: f64) -> Self {
        let temperature = SEA_LEVEL_TEMPERATURE - LAPSE_RATE * altitude.min(TROPOPAUSE);
        let exponent = STANDARD_GRAVITY / (LAPSE_RATE * GAS_CONSTANT);
        let mut pressure = SEA_LEVEL_PRESSURE * libm::pow(temperature / SEA_LEVEL_TEMPERATURE, exponent);
        if altitude > TROPOPAUSE {
            pressure *= libm::exp(-STANDARD_GRAVITY * (altitude - TROPOPAUSE) / (GAS_CONSTANT * temperature));
        }
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
        ] {
            let air = Air::at(altitude);
            assert!((air.density / density - 1.0).abs() < 2e-5, "{altitude}: {air:?}");
            assert!((air.speed_of_sound / sound - 1.0).abs() < 2e-5, "{altitude}: {air:?}");
        }
    }
}
