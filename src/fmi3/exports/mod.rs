//! The functions of `fmi3Functions.h`.
//!
//! Each turns C's arguments into safe types and hands them to the [`Instance`](crate::fmi::instance::Instance). What
//! [`pointers`](crate::fmi::pointers) says of an importer is what all of them rely on, and is not repeated at each.

mod co_simulation;
mod common;
mod model_exchange;
mod refused;
mod states;
mod variables;

#[cfg(test)]
pub(super) use {co_simulation::*, common::*, model_exchange::*, refused::*, states::*, variables::*};

use crate::fmi::refusal::Refusal;

/// That there are as many values as variables: all are scalars.
fn check_count(values: usize, variables: usize, name: &str) -> Result<(), Refusal> {
    if values == variables {
        return Ok(());
    }
    Err(Refusal::error(format!("{name}: found {values} values for {variables} scalar variables")))
}
