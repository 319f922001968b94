//! The complete state of a flight as bytes: restoring them continues bit for bit.
//!
//! Layout, little-endian: 8 bytes of magic with the format's version, identity of model and settings (u128),
//! sub-steps of anchor and present and number of numbers (u32 each), the numbers (f64), FNV-1a hash of all
//! before (u128).

use crate::structure::{ReducedModel, fnv1a};

use super::flight::{CELL, LATEST};
use super::integrator::MAX_SUBSTEPS;
use super::{Settings, Simulation, SimulationError};

/// Names the format and its version.
const MAGIC: &[u8; 8] = b"FLXSNP02";

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
        for count in [self.anchor.substeps, self.present.substeps, self.numbers() as u32] {
            bytes.extend_from_slice(&count.to_le_bytes());
        }
        for number in [self.anchor.time, self.present.time, self.steering.since, self.reference_airspeed] {
            bytes.extend_from_slice(&number.to_le_bytes());
        }
        let inputs = self.steering.inputs.values().chain(self.steering.rates.values());
        let states = self.anchor.state.iter().chain(&self.present.state).copied();
        for number in inputs.chain(states) {
            bytes.extend_from_slice(&number.to_le_bytes());
        }
        let hash = fnv1a(&bytes[start..]);
        bytes.extend_from_slice(&hash.to_le_bytes());
    }

    /// Length of a snapshot in bytes.
    pub fn snapshot_size(&self) -> usize {
        HEADER + 8 * self.numbers() + 16
    }

    /// Goes back to a snapshot taken of a simulation of the same model with the same settings.
    ///
    /// # Errors
    /// When the bytes are damaged or of another model, settings or version; nothing changes then.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SimulationError> {
        let refuse = |reason| Err(SimulationError::Snapshot(reason));
        if bytes.len() != self.snapshot_size() {
            return refuse("its length is not that of this model and these settings");
        }
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
        let mut counts = content[24..32]
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
        let [anchor, present, since, reference_airspeed] = [next(), next(), next(), next()];
        if !(anchor..=anchor + CELL).contains(&present) || present.abs() > LATEST || reference_airspeed < 0.0
        {
            return refuse("its times or its airspeed are out of range");
        }
        (self.anchor.time, self.present.time, self.steering.since) = (anchor, present, since);
        for number in self.steering.inputs.values_mut().chain(self.steering.rates.values_mut()) {
            *number = next();
        }
        for number in self.anchor.state.iter_mut().chain(&mut self.present.state) {
            *number = next();
        }
        (self.anchor.substeps, self.present.substeps) = (anchor_substeps, substeps);
        (self.anchor.slope_is_fresh, self.present.slope_is_fresh) = (false, false);
        self.take_reference_airspeed(reference_airspeed);
        Ok(())
    }

    /// How many floating-point numbers a snapshot holds.
    fn numbers(&self) -> usize {
        4 + 2 * self.steering.inputs.values().count() + 2 * self.present.state.len()
    }
}
