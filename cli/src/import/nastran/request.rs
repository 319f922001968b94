//! What is asked for: a deck, where its texts come from, and what its options say.

use std::path::{Path, PathBuf};

use super::aero::SurfaceLine;
use super::axes::DeckAxes;
use super::choices::Support;
use super::deck::Source;
use super::units::UnitSystem;

/// What is asked for.
pub struct Request<'a> {
    pub deck: &'a Path,
    pub source: &'a dyn Source,
    pub units: UnitSystem,
    pub axes: Option<DeckAxes>,
    pub root: Option<i64>,
    pub support: Option<Support>,
    pub airspeed: Option<f64>,
    pub altitude: f64,
    pub surfaces: &'a [SurfaceLine],
    pub engines: &'a [(String, i64)],
}

/// A deck that is one text.
pub struct OneText<'t>(pub &'t str);

/// What it is called.
const ONE_TEXT: &str = "deck.bdf";

impl Source for OneText<'_> {
    fn read(&self, path: &Path) -> Result<(PathBuf, String), String> {
        if path == Path::new(ONE_TEXT) {
            Ok((path.to_owned(), self.0.to_owned()))
        } else {
            Err("there are no other files".to_owned())
        }
    }
}

impl<'a> Request<'a> {
    /// With what is usual, in metres.
    pub fn of_text(source: &'a OneText<'a>) -> Self {
        Request {
            deck: Path::new(ONE_TEXT),
            source,
            units: UnitSystem::M,
            axes: None,
            root: None,
            support: None,
            airspeed: None,
            altitude: 0.0,
            surfaces: &[],
            engines: &[],
        }
    }
}
