//! The reduced model as bytes, for the FMU's `resources/`.
//!
//! Layout, little-endian: 8 bytes of magic with the format's version, the payload's length (u64), its
//! 128-bit FNV-1a hash, the payload (postcard).

use crate::aerodynamics::PetersInflow;
use crate::aircraft::{AIRSPEEDS, ALTITUDES};

use super::{ModeShapes, ReducedModel, StructureError};

/// Names the format and its version.
const MAGIC: &[u8; 8] = b"FLXAIR03";

/// Bytes before the payload.
const HEADER: usize = 8 + 8 + 16;

impl ReducedModel {
    /// The bytes that go into the FMU's `resources/`.
    pub fn to_bytes(&self) -> Vec<u8> {
        let payload = self.payload();
        let mut bytes = Vec::with_capacity(HEADER + payload.len());
        bytes.extend_from_slice(MAGIC);
        bytes.extend_from_slice(&(payload.len() as u64).to_le_bytes());
        bytes.extend_from_slice(&fnv1a(&payload).to_le_bytes());
        bytes.extend_from_slice(&payload);
        bytes
    }

    /// Reads what [`to_bytes`](Self::to_bytes) wrote.
    ///
    /// # Errors
    /// When the bytes are damaged, foreign or of another version.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, StructureError> {
        let (header, payload) = bytes.split_at_checked(HEADER).ok_or(StructureError::Bytes("too short"))?;
        let (magic, rest) = header.split_at(8);
        let (length, hash) = rest.split_at(8);
        if magic != MAGIC {
            return Err(StructureError::Bytes("it does not begin with the mark of this version"));
        }
        if length != (payload.len() as u64).to_le_bytes() {
            return Err(StructureError::Bytes("its length is not the recorded one"));
        }
        if hash != fnv1a(payload).to_le_bytes() {
            return Err(StructureError::Bytes("its checksum is not the recorded one"));
        }
        let model: ReducedModel = postcard::from_bytes(payload)
            .map_err(|_| StructureError::Bytes("its content cannot be decoded"))?;
        if !model.is_consistent() {
            return Err(StructureError::Bytes("its arrays do not fit together"));
        }
        if !model.is_finite() || !model.is_physical() {
            return Err(StructureError::Bytes("it holds numbers that no aircraft has"));
        }
        Ok(model)
    }

    /// 128-bit content hash: equal models, equal hashes.
    pub fn content_hash(&self) -> u128 {
        fnv1a(&self.payload())
    }

    fn payload(&self) -> Vec<u8> {
        // PROOF: serialising plain structs of numbers, strings and sequences of known length cannot fail.
        postcard::to_allocvec(self).expect("a reduced model is serialisable")
    }

    /// Whether strips, flaps and inflow are such as an aircraft file allows.
    fn is_physical(&self) -> bool {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        positive(self.integrals.mass)
            && self.gravity.is_finite()
            && AIRSPEEDS.contains(&self.airspeed)
            && ALTITUDES.contains(&self.altitude)
            && self.inflow_states <= PetersInflow::MAX_STATES
            && self.strips.iter().all(|strip| {
                positive(strip.semichord)
                    && positive(strip.width)
                    && strip.flap.is_none_or(|flap| flap.hinge > 0.0 && flap.hinge < 1.0)
            })
    }

    /// Whether all arrays have the lengths that the modes ask for.
    fn is_consistent(&self) -> bool {
        let n = self.modes.len();
        let fits = |shapes: &ModeShapes| [shapes.translation.len(), shapes.rotation.len()] == [3 * n; 2];
        self.integrals.is_consistent(n)
            && self.strain_energy.is_consistent(n)
            && self.strips.iter().all(|strip| fits(&strip.shapes))
            && self.engines.iter().all(|engine| fits(&engine.shapes))
            && self.stations.iter().all(|station| fits(&station.shapes))
    }
}

/// The 128-bit FNV-1a hash (Fowler, Noll, Vo; RFC 9923).
pub fn fnv1a(bytes: &[u8]) -> u128 {
    const OFFSET_BASIS: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    bytes.iter().fold(OFFSET_BASIS, |hash, &byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_fnv1a() {
        // RFC 9923, appendix with test vectors: FNV-1a 128 of "a".
        assert_eq!(fnv1a(b""), 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d);
        assert_eq!(fnv1a(b"a"), 0xd228_cb69_6f1a_8caf_7891_2b70_4e4a_8964);
    }
}
