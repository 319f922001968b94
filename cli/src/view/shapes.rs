//! Shows of natural modes and load modes: small swings of the structure held at O, drawn large [theory: structure.modes, load-modes.shapes].

use std::f64::consts::TAU;

use flexible_aircraft::plant::SettingError;
use flexible_aircraft::structure::{Mode, ReducedModel};
use nalgebra::{UnitQuaternion, Vector3};

use crate::describe::modes::{self, family_name};
use crate::numbers::rounded;

use super::View;
use super::recording::{Recording, TWIST};
use super::show::{Kind, Show};

/// Of a swing.
const FRAMES: usize = 48;

/// A swing is drawn in so long, s.
const PERIOD: f64 = 2.0;

/// The largest displacement, in parts of the airframe's size.
const AMPLITUDE: f64 = 0.05;

/// Of all modes that fly, natural ones first.
pub fn shows(view: &View) -> Result<Vec<Show>, SettingError> {
    let View { airframe, model, motions, settings, .. } = view;
    let named = modes::name(&airframe.aircraft, &model.modes, motions, &settings.plant);
    let mut shows: Vec<Show> = named
        .iter()
        .map(|mode| {
            let moves = mode.kinetic.iter().map(|(name, share)| format!("{name} {:.0} %", 100.0 * share));
            let facts = vec![
                ("frequency", format!("{} Hz", rounded(mode.frequency()))),
                ("family", family_name(mode.family).unwrap_or("none: there is no mirror plane").to_owned()),
                ("moves", moves.collect::<Vec<_>>().join(", ")),
            ];
            let name = format!("{} · {:.3} Hz · {}", mode.number, mode.frequency(), mode.motion);
            show(view, model, mode.number - 1, (name, facts))
        })
        .collect();
    let in_use = model.in_use(&settings.plant.choose_modes(model)?);
    let of_loads = in_use.modes.iter().enumerate().filter(|(_, mode)| mode.of_loads);
    for (number, (place, mode)) in of_loads.enumerate() {
        shows.push(load_mode(view, &in_use, (place, mode), number + 1));
    }
    Ok(shows)
}

fn load_mode(view: &View, model: &ReducedModel, (place, mode): (usize, &Mode), number: usize) -> Show {
    let frequency = mode.angular_frequency * view.settings.plant.stiffness_scale.sqrt() / TAU;
    let family = family_name(mode.family);
    let facts = vec![
        ("frequency", format!("{} Hz, were it a natural mode", rounded(frequency))),
        ("family", family.unwrap_or("none: there is no mirror plane").to_owned()),
        ("shape", "what typical static loads give beside the natural modes".to_owned()),
    ];
    let family = family.map_or(String::new(), |family| format!(", {family}"));
    show(view, model, place, (format!("load mode {number}{family}"), facts))
}

/// One swing of a mode of a model.
fn show(
    view: &View,
    model: &ReducedModel,
    mode: usize,
    (name, facts): (String, Vec<(&str, String)>),
) -> Show {
    let airframe = &view.airframe;
    let stations = &model.stations[airframe.at_sections()];
    let shapes: Vec<[Vector3<f64>; 2]> =
        stations.iter().map(|station| station.shapes.of_mode(mode)).collect();
    let largest =
        shapes.iter().fold(f64::MIN_POSITIVE, |most, [translation, _]| most.max(translation.norm()));
    let amplitude = AMPLITUDE * airframe.size() / largest;
    let mut recording = Recording::default();
    for frame in 0..=FRAMES {
        // The last frame is the first.
        let swing = amplitude * libm::sin(TAU * (frame % FRAMES) as f64 / FRAMES as f64);
        for (section, [translation, rotation]) in airframe.sections.iter().zip(&shapes) {
            let turn = UnitQuaternion::from_scaled_axis(rotation * swing).coords;
            recording.poses.extend((section.position + translation * swing).iter());
            recording.poses.extend([turn.w, turn.x, turn.y, turn.z]);
        }
        recording.body.extend([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
        let twist = |(station, [_, rotation]): (
            &flexible_aircraft::structure::ReducedStation,
            &[Vector3<f64>; 2],
        )| { station.twist_axis.dot(rotation) * swing };
        recording.colour(TWIST, stations.iter().zip(&shapes).map(twist));
        recording.frames += 1;
    }
    let drawn = format!(
        "{:.0} % of the aircraft's size at most, a swing in {PERIOD} s; the structure is held at O",
        100.0 * AMPLITUDE
    );
    let facts = facts.into_iter().chain([("drawn", drawn)]);
    Show {
        kind: Kind::Mode,
        name,
        level: "linear",
        facts: facts.map(|(label, text)| (label.to_owned(), text)).collect(),
        start: 0.0,
        step: PERIOD / FRAMES as f64,
        loops: true,
        recording,
        charted: Vec::new(),
        gust: None,
        ghost: None,
    }
}
