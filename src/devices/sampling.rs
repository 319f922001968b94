//! Sampled channels: each sample lags, waits, and is held until the next [theory: sensors.lag, sensors.turns, sensors.delay].

use std::f64::consts::{PI, TAU};

/// How some channels are sampled.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampling {
    /// A = e^{−h/τ}, what is left of the last sample; 0 without a lag.
    kept: f64,
    /// κ = (1 − A) τ/h, 0 without a lag.
    weight: f64,
    /// Samples to wait.
    delay: usize,
}

/// What comes into a channel at a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Input {
    /// Any quantity without jumps.
    Number(f64),
    /// rad; it jumps by a whole turn where it passes half a turn.
    Angle(f64),
}

/// What some channels keep from one sample to the next.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    /// What came in last.
    inputs: Vec<f64>,
    /// Behind the lag, an angle counted in the turn of what came in last.
    lagged: Vec<f64>,
    /// Behind the lag and the delay.
    delayed: Vec<f64>,
    /// Lagged samples that wait: one row of all channels for each sample of the delay.
    waiting: Vec<f64>,
}

impl Sampling {
    /// Every period (s), behind a lag (s) and a delay of so many samples.
    pub fn new(period: f64, time_constant: f64, delay: usize) -> Self {
        let (kept, weight) = if time_constant > 0.0 {
            let lost = -libm::expm1(-period / time_constant);
            (1.0 - lost, lost * time_constant / period)
        } else {
            (0.0, 0.0)
        };
        Sampling { kept, weight, delay }
    }

    /// The first samples: as if it had been so always.
    pub fn begin(&self, inputs: &[f64]) -> Samples {
        let again = || inputs.to_vec();
        Samples { inputs: again(), lagged: again(), delayed: again(), waiting: inputs.repeat(self.delay) }
    }

    /// Takes a sample of each channel; the first after the beginning has number 1.
    pub fn take(&self, samples: &mut Samples, number: u64, inputs: impl Iterator<Item = Input>) {
        let Samples { inputs: before, lagged, delayed, waiting } = samples;
        let Sampling { kept, weight, delay } = *self;
        let first = if delay == 0 { 0 } else { (number % delay as u64) as usize * before.len() };
        for (channel, input) in inputs.enumerate().take(before.len()) {
            let (lagged, before) = (&mut lagged[channel], &mut before[channel]);
            let input = match input {
                Input::Number(number) => number,
                Input::Angle(angle) => {
                    let turns = whole_turns(angle - *before);
                    if turns != 0.0 {
                        (*before, *lagged) = (*before + turns, *lagged + turns);
                    }
                    angle
                }
            };
            *lagged = kept * *lagged + (weight - kept) * *before + (1.0 - weight) * input;
            *before = input;
            delayed[channel] = match waiting.get_mut(first + channel) {
                Some(place) => std::mem::replace(place, *lagged),
                None => *lagged,
            };
        }
    }
}

/// An angle from −π to π, rad, whole turns away from one.
pub fn within_half_a_turn(angle: f64) -> f64 {
    if angle.abs() <= PI { angle } else { libm::remainder(angle, TAU) }
}

/// The whole turns nearest to an angle, rad.
fn whole_turns(angle: f64) -> f64 {
    TAU * libm::round(angle / TAU)
}

impl Samples {
    /// Of all channels, behind lag and delay.
    pub fn delayed(&self) -> &[f64] {
        &self.delayed
    }

    /// All numbers, for a snapshot.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let Samples { inputs, lagged, delayed, waiting } = self;
        inputs.iter().chain(lagged).chain(delayed).chain(waiting).copied()
    }

    /// All numbers, to be changed.
    pub fn numbers_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        let Samples { inputs, lagged, delayed, waiting } = self;
        inputs.iter_mut().chain(lagged).chain(delayed).chain(waiting)
    }

    /// Takes the numbers of other samples of the same channels, without allocating.
    pub fn take_from(&mut self, other: &Samples) {
        self.inputs.copy_from_slice(&other.inputs);
        self.lagged.copy_from_slice(&other.lagged);
        self.delayed.copy_from_slice(&other.delayed);
        self.waiting.copy_from_slice(&other.waiting);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The delayed samples of one channel.
    fn sample(sampling: &Sampling, signal: impl Fn(u64) -> f64, count: u64) -> Vec<f64> {
        let mut samples = sampling.begin(&[signal(0)]);
        let taken = (1..count).map(|number| {
            sampling.take(&mut samples, number, std::iter::once(Input::Number(signal(number))));
            samples.delayed()[0]
        });
        std::iter::once(signal(0)).chain(taken).collect()
    }

    /// ẏ = (u − y)/τ with u = a + b t and y(0) = a: y = a + b (t − τ + τ e^{−t/τ}).
    #[test]
    fn a_signal_that_is_linear_between_samples_is_followed_exactly() {
        let (period, lag) = (0.02, 0.07);
        let found = sample(&Sampling::new(period, lag, 0), |k| 3.0 + 5.0 * period * k as f64, 40);
        for (k, found) in found.iter().enumerate() {
            let time = period * k as f64;
            let expected = 3.0 + 5.0 * (time - lag + lag * libm::exp(-time / lag));
            assert!((found - expected).abs() < 1e-13, "{k}: {found} {expected}");
        }
    }

    #[test]
    fn a_delay_holds_the_first_sample_and_then_gives_all_of_them_in_order() {
        let signal = |k: u64| (k * k) as f64;
        for (delay, expected) in [(0, [0.0, 1.0, 4.0, 9.0, 16.0, 25.0]), (1, [0.0, 0.0, 1.0, 4.0, 9.0, 16.0])]
        {
            assert_eq!(sample(&Sampling::new(0.01, 0.0, delay), signal, 6), expected);
        }
        assert_eq!(sample(&Sampling::new(0.01, 0.0, 3), signal, 6), [0.0, 0.0, 0.0, 0.0, 1.0, 4.0]);
    }

    #[test]
    fn an_angle_lags_as_if_it_had_never_jumped_however_many_turns_it_makes() {
        let (period, count) = (0.02, 300);
        for rate in [7.0, -7.0] {
            for (lag, delay) in [(0.0, 0), (0.0, 3), (0.5, 0), (0.1, 2)] {
                let sampling = Sampling::new(period, lag, delay);
                let angle = |k: u64| 3.0 + rate * period * k as f64;
                let counted = sample(&sampling, angle, count);
                let jumping = |k: u64| within_half_a_turn(angle(k));
                let mut samples = sampling.begin(&[jumping(0)]);
                for number in 1..count {
                    sampling.take(&mut samples, number, std::iter::once(Input::Angle(jumping(number))));
                    let found = within_half_a_turn(samples.delayed()[0]);
                    assert!(found.abs() <= PI);
                    let apart = libm::remainder(found - counted[number as usize], TAU);
                    assert!(apart.abs() < 1e-12, "{rate} {lag} {delay} {number}: {apart:e}");
                    if lag == 0.0 && delay == 0 {
                        assert_eq!(found.to_bits(), jumping(number).to_bits());
                    }
                }
            }
        }
    }

    #[test]
    fn the_smallest_lag_is_none() {
        let signal = |k: u64| 1.0 / (1.0 + k as f64);
        let none = sample(&Sampling::new(0.01, 0.0, 1), signal, 6);
        for lag in [f64::MIN_POSITIVE, 1e-300, 1e-18] {
            let found = sample(&Sampling::new(0.01, lag, 1), signal, 6);
            assert!(found.iter().zip(&none).all(|(found, none)| (found - none).abs() < 1e-15), "{lag:e}");
        }
    }
}
