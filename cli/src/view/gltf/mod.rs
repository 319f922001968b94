//! Files for game engines, in glTF: a skeleton that the FMU's outputs drive, with an animation for each show; or one mesh with a target
//! for each mode and each control.
//!
//! Both rest in the jig shape. O is the origin; `axes` says how they lie. docs/game-engine.md shows how an engine drives them.

use std::path::PathBuf;

use clap::builder::{PathBufValueParser, TypedValueParser};
use flexible_aircraft::aircraft::Fidelity;

mod about;
mod animation;
mod axes;
mod bodies;
mod document;
mod joints;
mod leaders;
mod mesh;
mod morph;
mod rig;
mod shape;
mod skeleton;
mod strips;
#[cfg(test)]
mod tests;

pub use morph::file as morph;
pub use skeleton::file as skeleton;

/// A level at which displacements are no sums of mode shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "--gltf-morph: found the level {}, allowed are {}, at which displacements are sums of mode shapes; --gltf writes a skeleton at any level",
    .0.name(),
    Fidelity::ALL.into_iter().filter(|level| is_linear(*level)).map(Fidelity::name).collect::<Vec<_>>().join(", ")
)]
pub struct NotLinear(Fidelity);

/// A name without the ending by which engines know binary files.
#[derive(Debug, thiserror::Error)]
#[error("allowed is the path of a file that ends in .glb")]
struct NotBinary;

/// Whether displacements are sums of mode shapes at a level.
pub fn is_linear(level: Fidelity) -> bool {
    level != Fidelity::GeometricallyExact
}

/// Makes sure that targets can be what an aircraft does at some levels.
///
/// # Errors
/// At the first one at which they cannot.
pub fn check_linear(levels: &[Fidelity]) -> Result<(), NotLinear> {
    levels.iter().find(|level| !is_linear(**level)).map_or(Ok(()), |level| Err(NotLinear(*level)))
}

/// Reads the path of a file.
pub fn path() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| {
        let is_binary = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("glb"));
        if is_binary { Ok(path) } else { Err(NotBinary) }
    })
}
