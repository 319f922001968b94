//! The complete state of a flight as bytes: restoring them continues bit for bit.
//!
//! Layout, little-endian: 8 bytes of magic with the format's version, identity of model and settings (u128),
//! sub-steps of anchor and present and whether half the aircraft flies (1) or all (0) (u32 each), the numbers (f64,
//! times as cells of the grid and a part of one), FNV-1a hash of all before (u128).

use crate::structure::{ReducedModel, fnv1a};

use super::integrator::MAX_SUBSTEPS;
use super::moment::{LATEST, Moment};
use super::{Settings, Simulation, SimulationError};

/// Names the format and its version.
const MAGIC: &[u8; 8] = b"FLXSNP05";

/// Bytes before the numbers.
const HEADER: usize = 8 + 16 + 3 * 4;

/// Identifies the model and the settings that a snapshot belongs to.
pub(super) fn identity(model: &ReducedModel, settings: &Settings) -> u128 {
    let description = format!("{:032x} {settings:?}", model.content_hash());
    fnv1a(description.as_bytes())
}

impl Simulation {
    /// Appends the complete state as bytes; allocates only when `bytes` lacks room.
    pub fn snapshot(&self, bytes: &mut Vec<u8>) {
        let start = bytes.len();
        bytes.extend_from_slice(MAGIC);
        bytes.extend_from_slice(&self.identity.to_le_bytes());
        let is_half = u32::from(self.airframes.is_half());
        let (anchor, present) = (self.path.anchor(), &self.path.present);
        for count in [anchor.substeps, present.substeps, is_half] {
            bytes.extend_from_slice(&count.to_le_bytes());
        }
        let reference_airspeed = self.airframes.flying().reference_airspeed;
        let times = [present.time, anchor.time, self.steering.since].into_iter().flat_map(Moment::numbers);
        for number in times.chain([self.start, reference_airspeed]) {
            bytes.extend_from_slice(&number.to_le_bytes());
        }
        let inputs = self.steering.inputs.values().chain(self.steering.rates.values());
        let states = anchor.state.iter().chain(&present.state).copied();
        for number in inputs.chain(states) {
            bytes.extend_from_slice(&number.to_le_bytes());
        }
        let hash = fnv1a(&bytes[start..]);
        bytes.extend_from_slice(&hash.to_le_bytes());
    }

    /// Length of a snapshot in bytes; it grows when the whole aircraft takes over from its half.
    pub fn snapshot_size(&self) -> usize {
        self.size_with(self.path.present.state.len())
    }

    /// Length of a snapshot in bytes when the whole aircraft flies.
    pub fn largest_snapshot_size(&self) -> usize {
        self.size_with(self.airframes.whole().equations.layout().len())
    }

    /// The time, s, at which a snapshot was taken, if it is one; what else it says is not checked.
    pub fn time_of_snapshot(bytes: &[u8]) -> Option<f64> {
        let number = |place: usize| {
            bytes.get(HEADER + 8 * place..)?.first_chunk().map(|bytes| f64::from_le_bytes(*bytes))
        };
        let [present, start] = [Moment::from_numbers([number(0)?, number(1)?])?.seconds(), number(6)?];
        Some(start + present)
    }

    /// Whether a snapshot is of half or of all of the aircraft, and the length of its states, if its mark says one of the
    /// two and its own length is that of such a snapshot.
    fn airframe_of(&self, bytes: &[u8]) -> Option<(bool, usize)> {
        let (is_half, airframe) = match bytes.get(HEADER - 4..HEADER)? {
            [0, 0, 0, 0] => (false, self.airframes.whole()),
            [1, 0, 0, 0] => (true, self.airframes.half()?),
            _ => return None,
        };
        let states = airframe.equations.layout().len();
        (bytes.len() == self.size_with(states)).then_some((is_half, states))
    }

    /// Length of a snapshot with states of some length.
    fn size_with(&self, state: usize) -> usize {
        let numbers = 8 + 2 * self.steering.inputs.values().count() + 2 * state;
        HEADER + 8 * numbers + 16
    }

    /// Goes back to a snapshot taken of a simulation of the same model with the same settings.
    ///
    /// # Errors
    /// When the bytes are damaged or of another model, settings or version; nothing changes then.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SimulationError> {
        let refuse = |reason| Err(SimulationError::Snapshot(reason));
        let Some((is_half, length)) = self.airframe_of(bytes) else {
            return refuse("its length is not that of this model and these settings");
        };
        let (content, hash) = bytes.split_at(bytes.len() - 16);
        if !content.starts_with(MAGIC) {
            return refuse("it does not begin with the mark of this version");
        }
        if hash != fnv1a(content).to_le_bytes() {
            return refuse("its checksum is not the recorded one");
        }
        if content[8..24] != self.identity.to_le_bytes() {
            return refuse("it was taken of another aircraft or with other parameters");
        }
        // PROOF: chunks_exact(n) yields slices of n bytes only, here and below.
        let mut counts = content[24..HEADER]
            .chunks_exact(4)
            .map(|bytes| u32::from_le_bytes(bytes.try_into().expect("4 bytes")));
        let (anchor_substeps, substeps) = (counts.next().unwrap_or(0), counts.next().unwrap_or(0));
        if [anchor_substeps, substeps].iter().any(|count| !(1..=MAX_SUBSTEPS).contains(count)) {
            return refuse("its number of sub-steps is out of range");
        }
        // PROOF: as above.
        let mut numbers = content[HEADER..]
            .chunks_exact(8)
            .map(|bytes| f64::from_le_bytes(bytes.try_into().expect("8 bytes")));
        if numbers.clone().any(|number| !number.is_finite()) {
            return refuse("it holds numbers that are not finite");
        }
        let mut next = || numbers.next().unwrap_or(f64::NAN);
        let times = [(); 3].map(|()| Moment::from_numbers([next(), next()]));
        let [start, reference_airspeed] = [next(), next()];
        let [Some(present), Some(anchor), Some(since)] = times else {
            return refuse("its times are out of range");
        };
        let is_in_cell = (anchor..=anchor.cell_end()).contains(&present) && since <= present;
        let is_in_time = start.abs() <= LATEST && (start + present.seconds()).abs() <= LATEST;
        if !is_in_cell || !is_in_time || reference_airspeed < 0.0 {
            return refuse("its times or its airspeed are out of range");
        }
        self.start = start;
        self.steering.since = since;
        for number in self.steering.inputs.values_mut().chain(self.steering.rates.values_mut()) {
            *number = next();
        }
        let [present_point, anchor_point] = self.path.points_mut();
        for point in [anchor_point, present_point] {
            point.resize(length);
            point.state.fill_with(&mut next);
        }
        self.path.stand([(anchor, anchor_substeps), (present, substeps)]);
        self.forget_evaluation();
        self.airframes.choose(is_half);
        self.airframes.flying_mut().take_reference_airspeed(reference_airspeed);
        Ok(())
    }
}
