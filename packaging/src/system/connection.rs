//! What holds them together.

use super::endpoint::Endpoint;

/// An output and the input that it feeds, of the same type and unit.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Connection {
    pub(super) output: Endpoint,
    pub(super) input: Endpoint,
    /// The end that does not say its unit, where the other one does.
    pub(super) without_unit: Option<Endpoint>,
}
