//! The C interface of FMI 2.0: types and functions, a thin shell over [`fmi`](crate::fmi).
//!
//! | module | its one idea |
//! | --- | --- |
//! | `types` | the types of the C headers |
//! | `exports` | the functions of the C header: pointers in, safe Rust types out, nothing else |
//! | `logger` | messages to the importer's logger |
//!
//! `unsafe` is in `exports`, where C's pointers arrive, and in `logger`, where the importer's function is called.

mod exports;
mod logger;
mod types;

#[cfg(test)]
pub(crate) mod tests;
