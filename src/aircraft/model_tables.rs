//! What an aircraft file says of how finely the aircraft is modelled unless someone asks for another way: its level of
//! fidelity, what stands beside the natural modes, the states of the inflow.
//!
//! [theory: equations-of-motion.levels, load-modes.shapes, inflow.state]

use super::document::Table;
use super::fidelity::Fidelity;
use super::model::MOST_INFLOW_STATES;

const BASIS: &[&str] = &["load_modes"];

/// The level of fidelity at which the aircraft flies.
pub(super) fn read_fidelity(table: &Table) -> Fidelity {
    let levels = Fidelity::ALL.map(|level| (level.name(), level));
    table.optional("model").and_then(|v| v.one_of(&levels)).unwrap_or(Fidelity::GeometricallyExact)
}

/// Whether the modal basis holds the shapes of static loads too.
pub(super) fn read_load_modes(table: &Table) -> bool {
    let basis = table.optional("basis").and_then(|v| v.table(BASIS));
    basis.and_then(|basis| basis.optional("load_modes")?.flag()).unwrap_or(false)
}

/// Of each strip.
pub(super) fn read_inflow_states(table: &Table) -> usize {
    table.optional("inflow_states").and_then(|v| v.integer(0..MOST_INFLOW_STATES + 1)).unwrap_or(5)
}
