//! The complete state of a flight as bytes: restoring them continues bit for bit.
//!
//! Content of the [sealed] bytes: whether the aircraft flies in its form of symmetric motion and whether the cell of time begins at the present (a
//! byte each), sub-steps of anchor and present (u32), then numbers (f64): when present and anchor are and when the inputs
//! were set, each as cells of the grid and a part of one, start time, reference airspeed, how far the air had gone when the
//! inputs were set, inputs, their rates, the present's state and what lags there, where the cell begins elsewhere the anchor's,
//! and the samples of the sensors.

use std::iter::from_fn;

use nalgebra::Vector3;

use crate::sealed::{self, BrokenSeal, CHECKSUM, HEADER, Mark, Reader, Writer};

use super::error::SimulationError;
use super::integrator::MAX_SUBSTEPS;
use super::moment::{LATEST, Moment};
use super::point::Point;
use super::simulation::Simulation;

/// Names the format and its version.
const MARK: Mark = *b"FLXSNP06";

/// Bytes of the content before its numbers.
const FLAGS_AND_COUNTS: usize = 2 + 2 * size_of::<u32>();

impl Simulation {
    /// Appends the complete state as bytes; allocates only when `bytes` lacks room, and the first time, to hash the model.
    pub fn snapshot(&self, bytes: &mut Vec<u8>) {
        sealed::seal(bytes, &MARK, self.identity(), |writer| self.write_state(writer));
    }

    /// Length of a snapshot in bytes. It is longer once something has acted on one side alone, and longer inside a cell of
    /// time than at its beginning.
    pub fn snapshot_size(&self) -> usize {
        let points = if self.path.begins_here() { 1 } else { 2 };
        HEADER + self.content_size(points, self.path.present.state.len()) + CHECKSUM
    }

    /// Goes back to a snapshot taken of a simulation of the same model with the same settings.
    ///
    /// # Errors
    /// When the bytes are damaged or of another model, settings or version; nothing changes then.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SimulationError> {
        let content = sealed::open(bytes, &MARK, self.identity()).map_err(|seal| {
            SimulationError::Snapshot(match seal {
                BrokenSeal::Mark => "it does not begin with the mark of this version",
                BrokenSeal::Length { .. } => "its length is not the recorded one",
                BrokenSeal::Checksum => "its checksum is not the recorded one",
                BrokenSeal::Identity => "it was taken of another aircraft or with other parameters",
            })
        })?;
        self.read_state(content)
    }

    /// Identifies the model and the settings that a snapshot belongs to.
    fn identity(&self) -> u128 {
        *self.identity.get_or_init(|| {
            let parts = [self.model.content_hash(), self.settings_hash].map(u128::to_le_bytes);
            sealed::hash(parts.as_flattened())
        })
    }

    /// Writes the complete state.
    pub(crate) fn write_state(&self, writer: &mut Writer) {
        // Room for the largest, the whole aircraft inside a cell, so that it never has to grow.
        writer.reserve(self.content_size(2, self.flying.plants().most_states()));
        let (anchor, present) = (self.path.anchor(), &self.path.present);
        writer.flag(self.flying.is_symmetric());
        writer.flag(self.path.begins_here());
        writer.count(anchor.substeps);
        writer.count(present.substeps);
        let reference_airspeed = self.flying.marcher().reference_airspeed();
        let times = [present.time, anchor.time, self.steering.since].into_iter().flat_map(Moment::numbers);
        writer.reals(times.chain([self.start, reference_airspeed]));
        writer.reals(self.steering.air_travel.iter().copied());
        writer.reals(self.steering.inputs.values().chain(self.steering.rates.values()));
        let here = [present, anchor].into_iter().take(if self.path.begins_here() { 1 } else { 2 });
        for Point { state, acting, .. } in here {
            writer.reals(state.iter().copied().chain(self.steering.lagging(acting)));
        }
        writer.reals(self.sensors.numbers());
    }

    /// Of the content, with so many points of so many states.
    fn content_size(&self, points: usize, states: usize) -> usize {
        let at_a_point = states + self.steering.lagging(&self.path.present.acting).count();
        let inputs = self.steering.inputs.values().count();
        let numbers = 11 + 2 * inputs + points * at_a_point + self.sensors.numbers().count();
        FLAGS_AND_COUNTS + size_of::<f64>() * numbers
    }

    /// The time, s, of what [`write_state`](Self::write_state) wrote; what else it says is not checked.
    #[cfg(feature = "fmi")]
    pub(crate) fn time_of_state(mut state: Reader) -> Option<f64> {
        state.skip(FLAGS_AND_COUNTS)?;
        let [cells, part, _, _, _, _, start] = [(); 7].map(|()| state.real());
        Some(start? + Moment::from_numbers([cells?, part?])?.seconds())
    }

    /// Goes back to what [`write_state`](Self::write_state) wrote of a simulation of the same model and settings, or
    /// changes nothing.
    pub(crate) fn read_state(&mut self, mut state: Reader) -> Result<(), SimulationError> {
        let refuse = |reason| Err(SimulationError::Snapshot(reason));
        let length = state.left();
        let (Some(is_symmetric), Some(begins_here)) = (state.flag(), state.flag()) else {
            return refuse("it does not say which equations fly");
        };
        let recorded = self.flying.recorded(is_symmetric);
        let points = if begins_here { 1 } else { 2 };
        let (Some(anchor_substeps), Some(substeps)) = (state.count(), state.count()) else {
            return refuse("it ends too early");
        };
        let recorded = recorded.filter(|plant| length == self.content_size(points, plant.states()));
        let Some(recorded) = recorded else {
            return refuse("its length is not that of this model and these settings");
        };
        if [anchor_substeps, substeps].iter().any(|count| !(1..=MAX_SUBSTEPS).contains(count)) {
            return refuse("its number of sub-steps is out of range");
        }
        let mut all = state;
        if from_fn(|| all.real()).any(|number| !number.is_finite()) {
            return refuse("it holds numbers that are not finite");
        }
        let mut next = || state.real().unwrap_or(f64::NAN);
        let times = [(); 3].map(|()| Moment::from_numbers([next(), next()]));
        let [start, reference_airspeed] = [next(), next()];
        let [Some(present), Some(anchor), Some(since)] = times else {
            return refuse("its times are out of range");
        };
        let latest = if begins_here { anchor } else { anchor.cell_end() };
        let is_in_cell = (anchor..=latest).contains(&present) && since <= present;
        let is_in_time = start.abs() <= LATEST && (start + present.seconds()).abs() <= LATEST;
        if !is_in_cell || !is_in_time || reference_airspeed < 0.0 {
            return refuse("its times or its airspeed are out of range");
        }
        self.start = start;
        self.steering.since = since;
        self.steering.air_travel = Vector3::from_fn(|_, _| next());
        for number in self.steering.inputs.values_mut().chain(self.steering.rates.values_mut()) {
            *number = next();
        }
        self.steering.know_winds();
        self.stays = None;
        let [present_point, anchor_point] = self.path.points_mut();
        for point in [&mut *present_point, &mut *anchor_point] {
            point.resize(recorded.states());
        }
        let points = [present_point, anchor_point].into_iter().take(points);
        for Point { state, acting, .. } in points {
            state.fill_with(&mut next);
            self.steering.take_lagging(acting, &mut next);
        }
        self.sensors.numbers_mut().for_each(|number| *number = next());
        self.path.stand([(anchor, anchor_substeps), (present, substeps)]);
        self.forget_evaluation();
        self.flying.take_recorded(recorded);
        self.take_reference_airspeed(reference_airspeed);
        Ok(())
    }
}
