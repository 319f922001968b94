//! What an FMU does, whatever the version of FMI: safe Rust over [`Simulation`](crate::flight::Simulation), without C.
//!
//! | module | its one idea |
//! | --- | --- |
//! | `instance` | an instance: life cycle, experiment, steps |
//! | `values` | getting and setting variables of an instance |
//! | `derivatives` | directional derivatives of outputs by inputs and, at the initialisation, parameters |
//! | `saved_state` | the state of an instance as bytes |
//! | `life_cycle` | what may be asked of an instance in which state |
//! | `status` | how a call ended |
//! | `log` | messages to the importer |
//! | `build_mark` | what a library says of its origin |
//! | [`starts`] | where parameters start that `package --set` has changed |
//! | `resource` | from the resource location to the folder of the reduced model |
//! | [`description`] | the model description, written from the variable table, and the guid |
//!
//! A refused call leaves the instance as it was.

mod build_mark;
mod derivatives;
pub mod description;
pub(crate) mod instance;
pub(crate) mod life_cycle;
pub(crate) mod log;
pub(crate) mod resource;
pub(crate) mod saved_state;
pub mod starts;
pub(crate) mod status;
pub(crate) mod values;

pub use build_mark::{BUILD_MARK, BUILD_MARK_BEGINNING};
pub use description::MODEL_IDENTIFIER;
pub use resource::RESOURCE_FILE;
