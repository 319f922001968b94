//! The page in the documentation of an archive: the aircraft in its trim and in its modes.

use std::sync::Arc;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::flight::{Settings, Simulation, SimulationError};
use flexible_aircraft::structure::ModeCount;

use super::{Error, View, flights, shapes};

/// A page, and why it has no trim if there is none.
pub struct Scene {
    pub page: String,
    pub without_trim: Option<SimulationError>,
}

/// Of an aircraft with so many natural modes, whose archive starts with some settings. There is none without trim and modes.
pub fn scene(aircraft: &Aircraft, modes: ModeCount, starts: &Settings) -> Result<Option<Scene>, Error> {
    let view = View::new(aircraft, modes, |_, _| Ok(starts.clone()))?;
    let (mut shows, mut without_trim) = (Vec::new(), None);
    match Simulation::new(Arc::clone(&view.model), &view.settings, 0.0) {
        Ok(simulation) => shows.push(flights::beginning(&view, simulation)),
        Err(error) => without_trim = Some(error),
    }
    shows.extend(shapes::shows(&view).map_err(SimulationError::from)?);
    if shows.is_empty() {
        return Ok(None);
    }
    Ok(Some(Scene { page: view.page(&shows)?, without_trim }))
}
