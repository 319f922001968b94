//! Shows of flights and of the trim with which they begin.

use std::sync::Arc;

use flexible_aircraft::aircraft::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation, SimulationError};
use flexible_aircraft::plant::PlantSettings;

use crate::flown::{condition, trimmed};
use crate::progress::Audience;
use crate::simulate::schedule::Schedule;
use crate::watched::Watched;

use super::View;
use super::gust::Gust;
use super::recording::Recording;
use super::show::{Kind, Show};

/// Parts of a step by which a moment may miss its frame.
const ON_FRAME: f64 = 1e-5;

/// A flight at a level, so many frames a second.
pub fn flight(
    view: &View,
    (schedule, rate): (&Schedule, f64),
    charted: &[Watched],
    fidelity: Fidelity,
) -> Result<Show, SimulationError> {
    let settings = at_level(&view.settings, fidelity);
    let mut simulation = trimmed(&view.model, &settings, schedule.start())?;
    let gust = Gust::of(&view.airframe, &settings, simulation.outputs());
    let mut recording = Recording::default();
    let step = 1.0 / rate;
    let frames = (schedule.duration() * rate) as usize;
    let progress = Audience::of_command().progress(frames, "frames");
    schedule.fly(&mut simulation, &view.model, Some(step), |time, simulation| {
        let frame = recording.frames as f64 * step;
        if (time - schedule.start() - frame).abs() < ON_FRAME * step {
            recording.look(&view.airframe, charted, simulation);
            progress.advance();
        }
        Ok::<(), SimulationError>(())
    })?;
    Ok(Show {
        kind: Kind::Flight,
        name: format!("flight, {}", fidelity.name()),
        level: fidelity.name(),
        facts: facts(view, &settings, &simulation),
        start: schedule.start(),
        step,
        loops: false,
        recording,
        charted: charted.to_vec(),
        gust,
        ghost: None,
    })
}

/// The trim with which flights begin.
pub fn trim(view: &View) -> Result<Show, SimulationError> {
    Ok(beginning(view, trimmed(&view.model, &view.settings, 0.0)?))
}

/// How a flight begins.
pub fn beginning(view: &View, mut simulation: Simulation) -> Show {
    let mut recording = Recording::default();
    recording.look(&view.airframe, &[], &mut simulation);
    let fidelity = view.settings.plant.fidelity;
    Show {
        kind: Kind::Trim,
        name: "trim".to_owned(),
        level: fidelity.name(),
        facts: facts(view, &view.settings, &simulation),
        start: 0.0,
        step: 1.0,
        loops: false,
        recording,
        charted: Vec::new(),
        gust: None,
        ghost: None,
    }
}

/// The same settings at another level.
fn at_level(settings: &Settings, fidelity: Fidelity) -> Settings {
    Settings { plant: PlantSettings { fidelity, ..settings.plant }, ..settings.clone() }
}

/// What is said of a trim.
fn facts(view: &View, settings: &Settings, simulation: &Simulation) -> Vec<(String, String)> {
    let trim = simulation.trim();
    let degrees = |angle: f64| format!("{:.2}°", angle.to_degrees() + 0.0);
    let mut facts = vec![
        ("condition", condition(&view.model, settings)),
        ("pitch in the trim", degrees(trim.pitch)),
        ("angle of attack in the trim", degrees(trim.angle_of_attack())),
    ];
    let model = Arc::as_ref(&view.model);
    if let Some(control) = model.control_for(flexible_aircraft::aircraft::TrimRole::Pitch) {
        facts.push((
            "control for pitch",
            format!("{} {}", model.controls[control].name, degrees(trim.pitch_control)),
        ));
    }
    if !model.engines.is_empty() {
        facts.push(("thrust of each engine", format!("{:.0} N", trim.thrust + 0.0)));
    }
    facts.into_iter().map(|(label, text)| (label.to_owned(), text)).collect()
}
