//! The C interface of FMI 2.0 co-simulation: types and functions, a thin shell over [`fmi`](crate::fmi).
//!
//! | module | its one idea |
//! | --- | --- |
//! | `types` | the types of the C headers |
//! | `exports` | the functions of the C header: pointers in, safe Rust types out, nothing else |
//! | `functions` | their names |
//! | `logger` | messages to the importer's logger |
//!
//! This is the only module with `unsafe`: in `exports`, where C's pointers arrive, and in `logger`, where the
//! importer's function is called.

mod exports;
mod functions;
mod logger;
mod types;

pub use functions::function_names;

#[cfg(test)]
mod tests;
