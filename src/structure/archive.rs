//! The reduced model as bytes, for the FMU's `resources/`.
//!
//! Layout, little-endian: 8 bytes of magic with the format's version, the payload's length (u64), its
//! 128-bit XXH3 hash, the payload (postcard).

use nalgebra::Vector3;

use crate::aircraft::{ALTITUDES, Fidelity, Flap, MOST_INFLOW_STATES, Support, TEMPERATURE_OFFSETS};
use crate::sealed::hash;

use super::cuts::{ROUNDING, is_unit};
use super::{
    BeamSection, Carrier, ModeFamily, ModeShapes, ReducedEngine, ReducedMass, ReducedModel, StructureError,
};

/// Names the format and its version.
const MAGIC: &[u8; 8] = b"FLXAIR09";

/// Bytes before the payload.
const HEADER: usize = 8 + 8 + 16;

impl ReducedModel {
    /// The bytes that go into the FMU's `resources/`.
    pub fn to_bytes(&self) -> Vec<u8> {
        let payload = self.payload();
        let mut bytes = Vec::with_capacity(HEADER + payload.len());
        bytes.extend_from_slice(MAGIC);
        bytes.extend_from_slice(&(payload.len() as u64).to_le_bytes());
        bytes.extend_from_slice(&hash(&payload).to_le_bytes());
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
        let (length, recorded) = rest.split_at(8);
        if magic != MAGIC {
            return Err(StructureError::Bytes("it does not begin with the mark of this version"));
        }
        if length != (payload.len() as u64).to_le_bytes() {
            return Err(StructureError::Bytes("its length is not the recorded one"));
        }
        if recorded != hash(payload).to_le_bytes() {
            return Err(StructureError::Bytes("its checksum is not the recorded one"));
        }
        let model: ReducedModel = postcard::from_bytes(payload)
            .map_err(|_| StructureError::Bytes("its content cannot be decoded"))?;
        if model.fidelity == Fidelity::GeometricallyExact && !model.joints.is_empty() {
            return Err(StructureError::Bytes("it has joints, and a level that has none"));
        }
        if !model.is_consistent() {
            return Err(StructureError::Bytes("its arrays do not fit together"));
        }
        if !model.is_finite() || !model.is_physical() {
            return Err(StructureError::Bytes("it holds numbers that no aircraft has"));
        }
        if let Some(fault) = model.fault_of_section_loads() {
            return Err(StructureError::Bytes(fault));
        }
        Ok(model)
    }

    /// 128-bit content hash: equal models, equal hashes. Computed anew by every call.
    pub fn content_hash(&self) -> u128 {
        hash(&self.payload())
    }

    fn payload(&self) -> Vec<u8> {
        // PROOF: serialising plain structs of numbers, strings and sequences of known length cannot fail.
        postcard::to_allocvec(self).expect("a reduced model is serialisable")
    }

    /// Whether masses, frequencies, strips, flaps, directions and inflow are such as an aircraft has and its file allows.
    fn is_physical(&self) -> bool {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        positive(self.integrals.mass)
            && self.modes.iter().all(|mode| positive(mode.angular_frequency))
            && self.sections.iter().all(|section| section.body.mass >= 0.0)
            && self.gravity.is_finite()
            && self.support.airspeeds().contains(&self.airspeed)
            && ALTITUDES.contains(&self.altitude)
            && TEMPERATURE_OFFSETS.contains(&self.temperature_offset)
            && self.tunnel_air.is_none_or(|air| positive(air.density) && positive(air.temperature))
            && self.mount.iter().all(|angle| angle.is_finite())
            && (self.support == Support::Clamped
                || self.tunnel_air.is_none() && self.mount == Vector3::zeros())
            && self.limits.are_finite()
            && self.controls.iter().all(|control| control.limits.are_finite())
            && self.inflow_states <= MOST_INFLOW_STATES
            && self.strips.iter().all(|strip| {
                positive(strip.semichord)
                    && is_unit(&strip.forward)
                    && is_unit(&strip.span)
                    && strip.forward.dot(&strip.span).abs() < ROUNDING
                    && strip.zero_lift_moment.is_finite()
                    && strip.moment_slope.is_finite()
                    && positive(strip.width)
                    && strip.flap.as_ref().is_none_or(Flap::is_physical)
            })
            && self.engines.iter().all(ReducedEngine::is_physical)
            && (self.engines.is_empty() || self.engines.iter().any(|engine| engine.trim_share > 0.0))
            && self.stations.iter().all(|station| is_unit(&station.twist_axis))
    }

    /// Whether all arrays have the lengths that the modes ask for.
    fn is_consistent(&self) -> bool {
        let n = self.modes.len();
        let fits_controls = |flap: &Flap| flap.gains.len() == self.controls.len();
        let fits = |shapes: &ModeShapes| [shapes.translation.len(), shapes.rotation.len()] == [3 * n; 2];
        self.integrals.is_consistent(n)
            && self.static_loads.iter().all(|load| load.forces.len() == n)
            && self.strain_energy.is_consistent(n)
            && self.sections.iter().all(|section| fits(&section.steps))
            && self.is_tree()
            && self.has_the_loads_of_its_modes()
            && self.strips.iter().all(|strip| fits(&strip.shapes))
            && self.strips.iter().filter_map(|strip| strip.flap.as_ref()).all(fits_controls)
            && self.engines.iter().all(|engine| fits(&engine.shapes))
            && self.stations.iter().all(|station| fits(&station.shapes))
            && self.cuts.iter().all(|cut| fits(&cut.steps))
    }

    /// Whether the first section is that of O, which is clamped, all others come after their parents, and all that is attached
    /// hangs on one: itself, not as its mirror image, which half an aircraft alone has.
    fn is_tree(&self) -> bool {
        let is_clamped = |first: &BeamSection| {
            let steps = first.steps.translation.iter().chain(&first.steps.rotation);
            first.position == Vector3::zeros() && steps.into_iter().all(|step| *step == 0.0)
        };
        let comes_later = |(place, section): (usize, &BeamSection)| section.parent < place.max(1);
        let engines = self.engines.iter().map(|engine| engine.carrier);
        let stations = self.stations.iter().map(|station| station.carrier);
        let masses = self.masses.iter().map(|mass| mass.carrier);
        let carriers: Vec<Carrier> = engines.chain(stations).chain(masses).collect();
        let strips = self.strips.iter().map(|strip| strip.section);
        let cuts = self.cuts.iter().map(|cut| cut.section);
        let mut all = strips.chain(carriers.iter().map(|carrier| carrier.section)).chain(cuts);
        self.sections.first().is_some_and(is_clamped)
            && self.sections.iter().enumerate().all(comes_later)
            && all.all(|section| section < self.sections.len())
            && !carriers.iter().any(|carrier| carrier.mirrored)
    }

    /// Whether load modes have the loads that they are the strains of.
    fn has_the_loads_of_its_modes(&self) -> bool {
        let loads = |family| self.static_loads.iter().any(|load| load.family == family);
        let load_modes = |family| self.modes.iter().any(|mode| mode.of_loads && mode.family == family);
        [ModeFamily::Symmetric, ModeFamily::Antisymmetric, ModeFamily::Unsymmetric]
            .into_iter()
            .all(|family| loads(family) || !load_modes(family))
    }

    /// What is wrong with what section loads are summed from, if anything is: masses and cuts.
    fn fault_of_section_loads(&self) -> Option<&'static str> {
        let is_mass = |ReducedMass { position, body, .. }: &ReducedMass| {
            body.mass >= 0.0 && body.is_finite() && position.iter().all(|x| x.is_finite())
        };
        if !self.masses.iter().all(is_mass) {
            return Some("a mass is negative, or it or its place is not finite");
        }
        let counts = [self.strips.len(), self.engines.len(), self.stations.len(), self.masses.len()];
        self.cuts.iter().find_map(|cut| cut.fault(counts))
    }
}

impl ReducedEngine {
    /// Whether it is such as an aircraft file allows.
    fn is_physical(&self) -> bool {
        is_unit(&self.direction)
            && self.torque.is_finite()
            && self.angular_momentum.is_finite()
            && self.trim_share.is_finite()
            && self.trim_share >= 0.0
    }
}

impl Flap {
    /// Whether it is such as an aircraft file allows.
    fn is_physical(&self) -> bool {
        self.hinge > 0.0
            && self.hinge < 1.0
            && self.moment_slope.is_none_or(f64::is_finite)
            && self.drag.is_finite()
            && self.drag >= 0.0
            && self.gains.iter().all(|gain| gain.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::test_jet::jet;

    /// Whether the jet, changed, is refused when its bytes are read.
    fn is_refused(change: impl FnOnce(&mut ReducedModel)) -> bool {
        let mut model = jet().clone();
        change(&mut model);
        ReducedModel::from_bytes(&model.to_bytes()).is_err()
    }

    #[test]
    fn what_section_loads_cannot_be_summed_from_is_refused_by_name() {
        let refusal = |change: fn(&mut ReducedModel)| {
            let mut model = jet().clone();
            change(&mut model);
            ReducedModel::from_bytes(&model.to_bytes()).unwrap_err()
        };
        let mass = StructureError::Bytes("a mass is negative, or it or its place is not finite");
        assert_eq!(refusal(|jet| jet.masses[2].body.mass = -1.0), mass);
        assert_eq!(refusal(|jet| jet.masses[2].body.mass = f64::NAN), mass);
        assert_eq!(refusal(|jet| jet.masses[2].body.inertia[4] = f64::INFINITY), mass);
        assert_eq!(refusal(|jet| jet.masses[2].position.x = f64::INFINITY), mass);
        let place = StructureError::Bytes("a cut is at no fraction of a component's length from 0 to 1");
        assert_eq!(refusal(|jet| jet.cuts[1].at = 1.5), place);
        assert_eq!(refusal(|jet| jet.cuts[1].asked = f64::NAN), place);
        let place = StructureError::Bytes("the place of a cut is not finite");
        assert_eq!(refusal(|jet| jet.cuts[1].position.z = f64::NAN), place);
        let axes = StructureError::Bytes("the axes of a cut are not of length 1 and at right angles");
        assert_eq!(refusal(|jet| jet.cuts[0].up *= 2.0), axes);
        assert_eq!(refusal(|jet| jet.cuts[0].chordwise = jet.cuts[0].along), axes);
        assert_eq!(refusal(|jet| jet.cuts[0].along.y = f64::NAN), axes);
        assert_eq!(refusal(|jet| jet.cuts[0].torsion = jet.cuts[0].up), axes);
        let outboard =
            StructureError::Bytes("what is outboard of a cut is not there, or not in ascending order");
        assert_eq!(refusal(|jet| jet.cuts[0].outboard.strips.swap(0, 1)), outboard);
        assert_eq!(refusal(|jet| jet.cuts[0].outboard.masses[1] = jet.cuts[0].outboard.masses[0]), outboard);
        assert_eq!(refusal(|jet| jet.cuts[0].outboard.stations.push(1000)), outboard);
    }

    #[test]
    fn what_no_aircraft_has_is_refused() {
        assert!(!is_refused(|_| ()));
        assert!(is_refused(|jet| jet.sections[0].steps.rotation[3] = 1e-3), "O turns");
        assert!(is_refused(|jet| jet.sections[0].position.x = 1.0), "the first section is not O");
        assert!(is_refused(|jet| jet.sections[3].parent = 3), "a section is its own parent");
        assert!(is_refused(|jet| jet.stations[0].carrier.mirrored = true), "a station is on an image");
        assert!(is_refused(|jet| jet.engines[0].carrier.section = 1000), "an engine is on no section");
        assert!(is_refused(|jet| jet.sections[5].body.mass = -1.0), "a body has no mass");
        assert!(is_refused(|jet| jet.modes[2].angular_frequency = 0.0), "a mode has no stiffness");
        assert!(is_refused(|jet| jet.modes[3].of_loads = true), "a load mode has no load");
        assert!(is_refused(|jet| jet.strips[0].span = jet.strips[0].forward), "a strip has no normal");
        assert!(is_refused(|jet| jet.engines[0].direction *= 2.0), "an engine pushes twice");
        assert!(is_refused(|jet| jet.stations[0].twist_axis.x = f64::NAN), "a station has no axis");
        assert!(is_refused(|jet| jet.strips[0].moment_slope = f64::NAN), "a strip has no moment");
        let flap = |jet: &mut ReducedModel, change: fn(&mut Flap)| {
            change(jet.strips.iter_mut().find_map(|strip| strip.flap.as_mut()).unwrap());
        };
        assert!(is_refused(|jet| flap(jet, |flap| flap.drag = -0.1)), "a flap propels");
        assert!(
            is_refused(|jet| flap(jet, |flap| flap.moment_slope = Some(f64::NAN))),
            "a flap has no moment"
        );
        assert!(is_refused(|jet| jet.engines[1].angular_momentum = f64::NAN), "an engine turns without end");
        assert!(
            is_refused(|jet| jet.engines.iter_mut().for_each(|engine| engine.trim_share = 0.0)),
            "no thrust"
        );
        assert!(is_refused(|jet| jet.temperature_offset = -61.0), "the air is too cold");
    }
}
