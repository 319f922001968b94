//! The functions of `fmi2Functions.h`.
//!
//! Each turns C's arguments into safe types and hands them to the [`Instance`](crate::fmi::instance::Instance). What
//! [`pointers`](crate::fmi::pointers) says of an importer is what all of them rely on, and is not repeated at each.

mod co_simulation;
mod common;
mod model_exchange;
mod states;
mod variables;

#[cfg(test)]
pub(super) use {co_simulation::*, common::*, model_exchange::*, states::*, variables::*};
