//! What is flown: one flight, or one for each gust of a set.

use flexible_aircraft::air::GustSettings;
use flexible_aircraft::flight::Settings;

use crate::diagnostics;
use crate::gust::case::Case;
use crate::gust::set::{Error, GustSetOptions, cut_off};

/// The flights by name and by gust.
pub struct Cases {
    pub names: Vec<String>,
    pub gusts: Vec<GustSettings>,
}

impl Cases {
    /// Of a set of gusts, if one is asked for, that are met in a flight of so many seconds.
    ///
    /// # Errors
    /// When there are no such gusts.
    pub fn of(
        set: Option<&GustSetOptions>,
        settings: &Settings,
        assignments: &[String],
        duration: f64,
    ) -> Result<Self, Error> {
        let Some(set) = set else {
            return Ok(Cases { names: vec!["flight".to_owned()], gusts: vec![settings.gust] });
        };
        let cases = set.cases(settings, assignments, duration)?;
        if let Some(warning) = cut_off(&cases, settings, duration) {
            diagnostics::warn(&warning);
        }
        Ok(Cases {
            names: cases.iter().map(Case::name).collect(),
            gusts: cases.iter().map(|case| case.gust).collect(),
        })
    }
}
