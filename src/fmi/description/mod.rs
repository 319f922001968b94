//! `modelDescription.xml`, written from the variable table, and the guid by which an importer knows that description
//! and library belong together. The same model gives the same bytes.

mod shared;
mod v2;

use crate::flight::Settings;
use crate::sealed;
use crate::structure::ReducedModel;

pub use shared::MODEL_IDENTIFIER;

/// The model description of the FMU of an aircraft whose parameters start there.
pub fn write(model: &ReducedModel, starts: &Settings) -> String {
    v2::with_guid(model, starts, &guid(model, starts))
}

/// The guid of the FMU of an aircraft: the same for the same aircraft, variables, starts and version of this
/// crate, and another one when any of them changes.
pub fn guid(model: &ReducedModel, starts: &Settings) -> String {
    guid_of(identity(model, starts))
}

/// The guid of an identity.
pub(super) fn guid_of(id: u128) -> String {
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

/// Hash of the model's content and of the model description (without a guid), which says everything else
/// that an importer relies on.
pub(super) fn identity(model: &ReducedModel, starts: &Settings) -> u128 {
    let description = v2::with_guid(model, starts, "");
    sealed::hash(&[&model.content_hash().to_le_bytes(), description.as_bytes()].concat())
}

#[cfg(test)]
mod tests;
