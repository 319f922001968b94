//! What the loops that joints close exclude: the level that has none, and cuts within them
//! [theory: limits-of-validity.loops, section-loads.loops].

use crate::aircraft::{Aircraft, Fidelity};

use super::StructureError;

/// What an aircraft file is refused for, of an aircraft that a program has made.
pub(super) fn refuse(aircraft: &Aircraft) -> Result<(), StructureError> {
    if let (Fidelity::GeometricallyExact, Some(joint)) = (aircraft.fidelity, aircraft.joints.first()) {
        return Err(StructureError::Loop { joint: joint.to_string() });
    }
    let within = aircraft.cuts.iter().find_map(|cut| Some((cut, aircraft.loop_through(cut)?)));
    match within {
        Some((cut, joint)) => {
            Err(StructureError::CutInLoop { cut: cut.name.clone(), joint: joint.to_string() })
        }
        None => Ok(()),
    }
}
