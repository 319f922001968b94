//! What an FMU does whatever the version of FMI: over [`Simulation`](crate::flight::Simulation) where it integrates, over
//! [`ContinuousModel`](crate::flight::ContinuousModel) where the importer does.
//!
//! | module | its one idea |
//! | --- | --- |
//! | [`interface`] | which FMU an archive is: a version and a kind |
//! | `operation` | what can be asked of an instance, and by which function |
//! | `life_cycle` | what may be asked of an instance in which state |
//! | `instance` | an instance: life cycle, experiment |
//! | `motion` | what moves in an instance |
//! | `trimming` | it is made when first needed |
//! | `steps` | co-simulation: steps from one communication point to the next |
//! | `exchange` | model exchange: time, states and their rates |
//! | `values` | getting and setting variables of an instance |
//! | `derivatives` | directional derivatives of outputs by inputs and, at the initialisation, parameters |
//! | `exchange_derivatives` | the same of outputs and rates by states and inputs |
//! | `saved_state` | the state of an instance as bytes |
//! | `status` | how a call ended |
//! | `log` | messages to the importer |
//! | `pointers` | what C passes: arrays, texts, places for results, handles; the one module here with `unsafe` |
//! | `build_mark` | what a library says of its origin |
//! | [`starts`] | where parameters start that `package --set` has changed |
//! | `resource` | from the resource location to the folder of the reduced model |
//! | [`description`] | the model description, written from the variable table, and the token |
//!
//! A refused call leaves the instance as it was; in FMI 3.0 a wrong one ends it, as that standard wants it.

mod build_mark;
mod derivatives;
pub mod description;
pub(crate) mod exchange;
mod exchange_derivatives;
pub(crate) mod instance;
pub mod interface;
pub(crate) mod life_cycle;
pub(crate) mod log;
mod motion;
pub(crate) mod operation;
pub(crate) mod pointers;
pub(crate) mod refusal;
pub(crate) mod resource;
pub(crate) mod saved_state;
pub mod starts;
pub(crate) mod status;
mod steps;
mod trimming;
pub(crate) mod values;

pub use build_mark::{BUILD_MARK, BUILD_MARK_BEGINNING};
pub use description::MODEL_IDENTIFIER;
pub use interface::{Interface, Kind, Version};
pub use resource::RESOURCE_FILE;
