//! What an aircraft file says of how finely the aircraft is modelled unless someone asks for another way: its level of
//! fidelity, what stands beside the natural modes, the states of the inflow.
//!
//! [theory: equations-of-motion.levels, load-modes.shapes, inflow.state]

use super::document::Table;
use super::fidelity::Fidelity;
use super::format::file;

/// The level of fidelity at which the aircraft flies.
pub(super) fn read_fidelity(table: &Table) -> Fidelity {
    let levels = Fidelity::ALL.map(|level| (level.name(), level));
    table.optional(&file::MODEL).and_then(|v| v.one_of(&levels)).unwrap_or(Fidelity::USUAL)
}

/// Whether the modal basis holds the shapes of static loads too.
pub(super) fn read_load_modes(table: &Table) -> bool {
    let basis = table.optional(&file::BASIS).and_then(|v| v.table());
    basis.is_some_and(|basis| basis.flag(&file::LOAD_MODES))
}
