//! The C interface of FMI 2.0 co-simulation: types and functions, a thin shell over [`fmi`](crate::fmi).
//!
//! | module | its one idea |
//! | --- | --- |
//! | `types` | the types of the C headers |
//! | `exports` | the functions of the C header: pointers in, safe Rust types out, nothing else |
//! | `logger` | messages to the importer's logger |
//!
//! This is the only module with `unsafe`: in `exports`, where C's pointers arrive, and in `logger`, where the
//! importer's function is called.

mod exports;
mod logger;
mod types;

use crate::fmi::life_cycle::Operation;

/// The names of all functions that the shared library exports.
pub fn function_names() -> impl Iterator<Item = &'static str> {
    let without_instance = ["fmi2GetTypesPlatform", "fmi2GetVersion", "fmi2Instantiate", "fmi2FreeInstance"];
    without_instance.into_iter().chain(Operation::all().map(Operation::name))
}

#[cfg(test)]
mod tests;
