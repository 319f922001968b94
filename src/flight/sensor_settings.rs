//! What a user chooses of the sensors [theory: sensors.samples, sensors.lag, sensors.delay, sensors.noise].

use std::ops::RangeInclusive;

use crate::plant::SettingError;

use super::channels::NoiseKind;
use super::moment::{CELL, Moment};

/// What a user chooses of the sensors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensorSettings {
    /// Whether they are sampled; otherwise they give the outputs that they mirror.
    pub enabled: bool,
    /// From one sample to the next, s, a multiple of 0.01 s.
    pub period: f64,
    /// Of the lag, s, ≥ 0.
    pub time_constant: f64,
    /// Of so many samples.
    pub delay: usize,
    /// Rms of each kind, in its unit, ≥ 0.
    pub noise: [f64; NoiseKind::ALL.len()],
    /// Of all noise.
    pub seed: u32,
}

impl Default for SensorSettings {
    fn default() -> Self {
        let noise = [0.0; NoiseKind::ALL.len()];
        SensorSettings { enabled: false, period: 0.01, time_constant: 0.0, delay: 0, noise, seed: 1 }
    }
}

impl SensorSettings {
    /// s.
    pub const PERIODS: RangeInclusive<f64> = CELL..=10.0;
    /// s.
    pub const TIME_CONSTANTS: RangeInclusive<f64> = 0.0..=1e4;
    /// Samples.
    pub const DELAYS: RangeInclusive<usize> = 0..=1000;
    /// Of any kind, in its unit.
    pub const NOISES: RangeInclusive<f64> = 0.0..=1e6;

    /// Checks every setting against its range.
    ///
    /// # Errors
    /// Names the first that is outside.
    pub(super) fn check(&self) -> Result<(), SettingError> {
        let SensorSettings { period, time_constant, delay, noise, .. } = *self;
        let refuse = |setting: &str, found: String, allowed: String| {
            Err(SettingError { setting: format!("sensor.{setting}"), found, allowed })
        };
        let whole = Moment::cells_in(period) * CELL;
        if !Self::PERIODS.contains(&period) || (period - whole).abs() > 1e-9 * period {
            let (least, most) = Self::PERIODS.into_inner();
            let allowed = format!("a multiple of {CELL} from {least} to {most} (s)");
            return refuse("period", period.to_string(), allowed);
        }
        if !Self::TIME_CONSTANTS.contains(&time_constant) {
            let (least, most) = Self::TIME_CONSTANTS.into_inner();
            return refuse("time_constant", time_constant.to_string(), format!("{least} to {most} (s)"));
        }
        if !Self::DELAYS.contains(&delay) {
            let (least, most) = Self::DELAYS.into_inner();
            return refuse("delay", delay.to_string(), format!("{least} to {most} samples"));
        }
        for (kind, rms) in NoiseKind::ALL.into_iter().zip(noise) {
            if !Self::NOISES.contains(&rms) {
                let (least, most) = Self::NOISES.into_inner();
                let allowed = format!("{least} to {most}, the rms in the unit of what is measured");
                return refuse(&format!("noise.{}", kind.name()), rms.to_string(), allowed);
            }
        }
        Ok(())
    }
}
