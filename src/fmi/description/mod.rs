//! `modelDescription.xml`, written from the variable table, and the guid (FMI 3.0: instantiation token) by which an importer
//! knows that description and library belong together. The same model gives the same bytes.

mod shared;
mod source;
mod v2;
mod v3;

use crate::flight::Settings;
use crate::sealed;
use crate::structure::ReducedModel;
use crate::variables::ArchiveTable;

use super::interface::{Interface, Version};

pub use shared::MODEL_IDENTIFIER;

use source::Source;

/// The model description of an FMU of an aircraft whose parameters start there.
pub fn write(interface: Interface, model: &ReducedModel, starts: &Settings) -> String {
    let table = ArchiveTable::new(model, starts, interface.extent());
    let token = token_of(identity(interface, model, starts, &table));
    text(Source { interface, model, starts, table: &table, token: &token })
}

/// The guid or instantiation token of an FMU of an aircraft: the same for the same interface, aircraft, variables, starts and
/// version of this crate, and another one when any of them changes.
pub fn token(interface: Interface, model: &ReducedModel, starts: &Settings) -> String {
    let table = ArchiveTable::new(model, starts, interface.extent());
    token_of(identity(interface, model, starts, &table))
}

/// The token of an identity.
pub(super) fn token_of(id: u128) -> String {
    let group = |shift: u32, digits: u32| (id >> shift) & ((1 << (4 * digits)) - 1);
    format!(
        "{{{:08x}-{:04x}-{:04x}-{:04x}-{:012x}}}",
        group(96, 8),
        group(80, 4),
        group(64, 4),
        group(48, 4),
        group(0, 12)
    )
}

/// Hash of the model's content and of the model description (without a token), which says everything else
/// that an importer relies on.
pub(super) fn identity(
    interface: Interface,
    model: &ReducedModel,
    starts: &Settings,
    table: &ArchiveTable,
) -> u128 {
    let description = text(Source { interface, model, starts, table, token: "" });
    sealed::hash(&[&model.content_hash().to_le_bytes(), description.as_bytes()].concat())
}

fn text(source: Source) -> String {
    match source.interface.version {
        Version::V2 => v2::text(source),
        Version::V3 => v3::text(source),
    }
}

#[cfg(test)]
mod tests;
