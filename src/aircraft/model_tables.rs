//! What an aircraft file says of how finely the aircraft is modelled unless someone asks for another way: its level of
//! fidelity, what stands beside the natural modes, the states of the inflow.
//!
//! [theory: equations-of-motion.levels, load-modes.shapes, inflow.state]

use super::document::Table;
use super::fidelity::Fidelity;
use super::format::{Absent, file};

/// The level of fidelity at which the aircraft flies.
pub(super) fn read_fidelity(table: &Table) -> Fidelity {
    let usual = || match file::MODEL.absent {
        Absent::Word(word) => Fidelity::named(word),
        _ => None,
    };
    let given = table.optional(&file::MODEL).and_then(|v| v.one_of(&Fidelity::ALL));
    given.or_else(usual).unwrap_or(Fidelity::GeometricallyExact)
}

/// Whether the modal basis holds the shapes of static loads too.
pub(super) fn read_load_modes(table: &Table) -> bool {
    let basis = table.optional(&file::BASIS).and_then(|v| v.table());
    basis.is_some_and(|basis| basis.flag(&file::LOAD_MODES))
}
