//! The FMI 2.0 co-simulation interface: a thin C shell over [`Simulation`](crate::flight::Simulation).
//!
//! | module | its one idea |
//! | --- | --- |
//! | `exports` | the functions of the C header: pointers in, safe Rust types out, nothing else |
//! | `instance` | an instance: life cycle, experiment, steps, in safe Rust |
//! | `values` | getting and setting variables of an instance |
//! | `derivatives` | directional derivatives of outputs by inputs and, at the initialisation, parameters |
//! | `saved_state` | the state of an instance as bytes |
//! | `life_cycle` | which function may be called in which state |
//! | `logger` | messages to the importer |
//! | `build_mark` | what a library says of its origin |
//! | `resource` | from the resource location to the reduced model |
//! | [`model_description`] | the XML, written from the variable table |
//!
//! This is the only module with `unsafe`: in `exports`, where C's pointers arrive, and in `logger`, where the
//! importer's function is called. A refused call leaves the instance as it was.

mod build_mark;
mod derivatives;
mod exports;
mod instance;
mod life_cycle;
mod logger;
pub mod model_description;
mod resource;
mod saved_state;
mod types;
mod values;

use crate::sealed;
use crate::structure::ReducedModel;

pub use build_mark::{BUILD_MARK, BUILD_MARK_BEGINNING};

/// Name of the reduced model's file in the FMU's `resources/`.
pub const RESOURCE_FILE: &str = "model.bin";

/// `modelName` and `modelIdentifier`; the shared libraries of the archive are named after it.
pub const MODEL_IDENTIFIER: &str = "FlexibleAircraft";

/// The names of all functions that the shared library exports.
pub fn function_names() -> impl Iterator<Item = &'static str> {
    let without_instance = ["fmi2GetTypesPlatform", "fmi2GetVersion", "fmi2Instantiate", "fmi2FreeInstance"];
    without_instance.into_iter().chain(life_cycle::Function::all().map(life_cycle::Function::name))
}

/// The guid of the FMU of an aircraft: the same for the same aircraft, variables and version of this
/// crate, and another one when any of them changes.
pub fn guid(model: &ReducedModel) -> String {
    guid_of(identity(model))
}

fn guid_of(id: u128) -> String {
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
fn identity(model: &ReducedModel) -> u128 {
    let description = model_description::with_guid(model, "");
    sealed::hash(&[&model.content_hash().to_le_bytes(), description.as_bytes()].concat())
}

#[cfg(test)]
mod tests;
