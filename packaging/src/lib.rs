//! Builds the `.fmu` archive of a flexible aircraft, and loads one as an importing tool does.

pub mod c_abi;
mod model_description;
mod platform;

pub use platform::{Platform, UnknownPlatform};
