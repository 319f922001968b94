//! What a model description is written from.

use crate::flight::Settings;
use crate::fmi::interface::Interface;
use crate::structure::ReducedModel;
use crate::variables::ArchiveTable;

/// An FMU that is described.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// For which it is.
    pub interface: Interface,
    /// The aircraft.
    pub model: &'a ReducedModel,
    /// Where its parameters start.
    pub starts: &'a Settings,
    /// Of the interface.
    pub table: &'a ArchiveTable,
    /// The guid or instantiation token.
    pub token: &'a str,
}
