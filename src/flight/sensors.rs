//! The sensors of a flight: sampled on the grid of time, or the outputs themselves.
//!
//! [theory: sensors.samples, sensors.turns, sensors.noise]

use crate::devices::{Noise, Samples, Sampling};
use crate::plant::Outputs;
use crate::structure::ReducedModel;

use super::channels::Channel;
use super::moment::Moment;
use super::sensor_settings::SensorSettings;

/// The channels of a flight.
#[derive(Clone, Debug)]
pub(super) struct Sensors {
    channels: Vec<Channel>,
    /// Where they are sampled.
    sampled: Option<Sampled>,
}

#[derive(Clone, Debug)]
struct Sampled {
    sampling: Sampling,
    /// Cells of time from one sample to the next.
    cells: f64,
    /// Of each channel: rms and noise.
    noises: Vec<(f64, Noise)>,
    samples: Samples,
    /// Those that were kept last.
    before: Samples,
}

impl Sensors {
    /// Of a flight that begins with these outputs, trimmed and before any input.
    pub fn new(model: &ReducedModel, settings: &SensorSettings, trimmed: impl FnOnce() -> Outputs) -> Self {
        let channels = Channel::of(model);
        let SensorSettings { enabled, period, time_constant, delay, noise, seed } = *settings;
        let sampled = enabled.then(|| {
            let sampling = Sampling::new(period, time_constant, delay);
            let outputs = trimmed();
            let first: Vec<f64> = channels.iter().map(|channel| channel.read(&outputs)).collect();
            let samples = sampling.begin(&first);
            let of_channel = |channel: &Channel| {
                (noise[channel.noise as usize], Noise::new(u64::from(seed), &channel.name()))
            };
            Sampled {
                sampling,
                cells: Moment::cells_in(period),
                noises: channels.iter().map(of_channel).collect(),
                before: samples.clone(),
                samples,
            }
        });
        Sensors { channels, sampled }
    }

    /// The outputs themselves.
    pub fn unsampled(model: &ReducedModel) -> Self {
        Sensors { channels: Channel::of(model), sampled: None }
    }

    /// How many channels there are.
    pub fn count(&self) -> usize {
        self.channels.len()
    }

    /// Whether they give samples, and not the outputs.
    pub fn are_sampled(&self) -> bool {
        self.sampled.is_some()
    }

    /// Whether a sample is taken at a time.
    pub fn sample_at(&self, time: Moment) -> bool {
        self.sampled.as_ref().is_some_and(|sampled| time.is_on_grid_of(sampled.cells))
    }

    /// Takes a sample of the outputs at a time.
    pub fn take(&mut self, time: Moment, outputs: &Outputs) {
        let Sensors { channels, sampled } = self;
        if let Some(Sampled { sampling, cells, samples, .. }) = sampled {
            let inputs = channels.iter().map(|channel| channel.input(outputs));
            sampling.take(samples, time.whole(*cells), inputs);
        }
    }

    /// Writes what the channels give at a time; where they are not sampled, these have to be the outputs there.
    pub fn write(&self, time: Moment, outputs: &Outputs, readings: &mut [f64]) {
        match &self.sampled {
            None => {
                for (reading, channel) in readings.iter_mut().zip(&self.channels) {
                    *reading = channel.read(outputs);
                }
            }
            Some(Sampled { cells, noises, samples, .. }) => {
                let number = time.whole(*cells);
                let delayed = self.channels.iter().zip(samples.delayed()).zip(noises);
                for (reading, ((channel, delayed), (rms, noise))) in readings.iter_mut().zip(delayed) {
                    let noisy = if *rms == 0.0 { *delayed } else { delayed + rms * noise.number(number) };
                    *reading = channel.within_range(noisy);
                }
            }
        }
    }

    /// Keeps everything as it is now.
    pub fn keep(&mut self) {
        if let Some(Sampled { samples, before, .. }) = &mut self.sampled {
            before.take_from(samples);
        }
    }

    /// Goes back to what was kept.
    pub fn restore_kept(&mut self) {
        if let Some(Sampled { samples, before, .. }) = &mut self.sampled {
            samples.take_from(before);
        }
    }

    /// All numbers that change, for a snapshot.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        self.sampled.iter().flat_map(|sampled| sampled.samples.numbers())
    }

    /// All numbers that change.
    pub fn numbers_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        self.sampled.iter_mut().flat_map(|sampled| sampled.samples.numbers_mut())
    }
}
