//! What instruments would read of the flow at O, and the path over the ground [theory: outputs.air-data, outputs.path].

use std::f64::consts::PI;

use nalgebra::Vector3;

use crate::air::{Air, SEA_LEVEL_DENSITY, SEA_LEVEL_PRESSURE};

/// Speed of sound of the standard atmosphere at sea level, m/s.
const SEA_LEVEL_SOUND: f64 = 340.294;

/// The undisturbed flow at O [theory: outputs.air-data].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AirData {
    /// True airspeed, m/s.
    pub speed: f64,
    /// Equivalent airspeed, m/s.
    pub equivalent: f64,
    /// Calibrated airspeed, m/s.
    pub calibrated: f64,
    /// Angle of attack of the body x axis, rad.
    pub angle_of_attack: f64,
    /// Sideslip angle, rad, positive with the wind from the right.
    pub sideslip: f64,
    /// Mach number.
    pub mach: f64,
    /// kg/m³.
    pub density: f64,
    /// Static pressure, Pa.
    pub pressure: f64,
    /// Static temperature, K.
    pub temperature: f64,
    /// Pa.
    pub dynamic_pressure: f64,
}

/// The motion of O over the ground [theory: outputs.path].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Path {
    /// Of the velocity above the horizon, rad.
    pub climb_angle: f64,
    /// Direction of its horizontal part, from north to east, in (−π, π], rad.
    pub track: f64,
    /// Upwards, m/s.
    pub vertical_speed: f64,
}

impl AirData {
    /// From the velocity relative to the air, body axes, m/s; the calibrated airspeed is left at 0.
    pub(super) fn uncalibrated(velocity: &Vector3<f64>, air: &Air) -> Self {
        let speed = velocity.norm();
        let mach = speed / air.speed_of_sound;
        AirData {
            speed,
            equivalent: speed * libm::sqrt(air.density / SEA_LEVEL_DENSITY),
            calibrated: 0.0,
            angle_of_attack: libm::atan2(velocity.z, velocity.x),
            sideslip: if speed > 0.0 { libm::asin((velocity.y / speed).clamp(-1.0, 1.0)) } else { 0.0 },
            mach,
            density: air.density,
            pressure: air.pressure,
            temperature: air.temperature,
            dynamic_pressure: 0.5 * air.density * speed * speed,
        }
    }

    /// Finds the calibrated airspeed.
    pub(super) fn calibrate(&mut self) {
        self.calibrated = calibrated(self.mach, self.pressure);
    }
}

/// The speed at sea level at which a pitot tube is under as much impact pressure, m/s.
fn calibrated(mach: f64, pressure: f64) -> f64 {
    let impact = pressure * (libm::pow(1.0 + 0.2 * mach * mach, 3.5) - 1.0);
    SEA_LEVEL_SOUND * libm::sqrt(5.0 * (libm::pow(impact / SEA_LEVEL_PRESSURE + 1.0, 2.0 / 7.0) - 1.0))
}

impl Path {
    /// Of a velocity towards north, east and down, m/s.
    pub(super) fn new(velocity: &Vector3<f64>) -> Self {
        let speed = velocity.norm();
        let track = libm::atan2(velocity.y, velocity.x);
        Path {
            climb_angle: if speed > 0.0 { libm::asin((-velocity.z / speed).clamp(-1.0, 1.0)) } else { 0.0 },
            track: if track == -PI { PI } else { track },
            vertical_speed: 0.0 - velocity.z,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flow(velocity: &Vector3<f64>, air: &Air) -> AirData {
        let mut data = AirData::uncalibrated(velocity, air);
        data.calibrate();
        data
    }

    /// Values of the independent computation with which the outputs were specified.
    #[test]
    fn airspeeds_are_those_that_instruments_read() {
        for (speed, equivalent, calibrated, mach) in
            [(127.0, 85.0159, 86.1233, 0.410115), (177.8, 119.0223, 122.0162, 0.574161)]
        {
            let data = flow(&Vector3::new(speed, 0.0, 0.0), &Air::at(7620.0));
            assert!((data.equivalent - equivalent).abs() < 1e-4, "{data:?}");
            assert!((data.calibrated - calibrated).abs() < 1e-4, "{data:?}");
            assert!((data.mach - mach).abs() < 1e-6, "{data:?}");
        }
    }

    #[test]
    fn airspeeds_are_one_at_sea_level() {
        let data = flow(&Vector3::new(60.0, 0.0, 10.0), &Air::at(0.0));
        assert!((data.equivalent / data.speed - 1.0).abs() < 1e-6);
        assert!((data.calibrated / data.speed - 1.0).abs() < 1e-5);
        assert_eq!(flow(&Vector3::zeros(), &Air::at(0.0)).calibrated, 0.0);
    }

    #[test]
    fn a_path_to_the_south_has_the_track_of_half_a_turn_however_it_is_rounded() {
        let path = Path::new(&Vector3::new(-3.0, -0.0, -4.0));
        assert_eq!(path, Path { climb_angle: libm::asin(0.8), track: PI, vertical_speed: 4.0 });
        assert_eq!(Path::new(&Vector3::zeros()), Path::default());
    }
}
