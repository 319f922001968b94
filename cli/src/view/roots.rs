//! Shows of linear modes of the aircraft in flight: the trim and a departure from it that swings, decays or grows as its root says
//! [theory: stability.modes], seen by somebody who flies along.

use std::f64::consts::TAU;
use std::sync::Arc;

use flexible_aircraft::flight::SimulationError;
use flexible_aircraft::math::Attitude;
use flexible_aircraft::plant::{Plant, Trim, Unknown};
use flexible_aircraft::stability::{Complex, FlightMode};
use flexible_aircraft::{Inflow, flight_modes};
use nalgebra::Vector3;

use crate::linearise::modes::family;
use crate::numbers::rounded;

use super::View;
use super::recording::Recording;
use super::show::{Kind, Show};

/// Of a swing, and how many are shown.
const FRAMES: usize = 32;
const SWINGS: usize = 3;

/// What does not swing is shown for so many time constants, and at most so long, s.
const TIME_CONSTANTS: f64 = 3.0;
const LONGEST: f64 = 120.0;

/// Largest angle of the body, rad, and largest displacement of a section, in parts of the airframe's size.
const ANGLE: f64 = 0.1;
const DISPLACEMENT: f64 = 0.05;

/// A departure by which derivatives are taken, as a part of what is drawn.
const SMALL: f64 = 1e-4;

/// Why a root cannot be shown.
#[derive(Debug, thiserror::Error)]
pub enum RootError {
    #[error(transparent)]
    Flight(#[from] SimulationError),
    #[error("--root: found `{found}`, allowed is the name or the number of a mode in this flight: {allowed}")]
    Unknown { found: String, allowed: String },
}

/// Of the modes with some names or numbers.
pub fn shows(view: &View, asked: &[String]) -> Result<Vec<Show>, RootError> {
    if asked.is_empty() {
        return Ok(Vec::new());
    }
    let modes = flight_modes(Arc::clone(&view.model), &view.settings, Inflow::Kept)?;
    let settings = &view.settings.plant;
    let plant = Plant::under(&view.model, settings).map_err(SimulationError::from)?;
    let trim = plant.trim(&settings.trim_condition()).map_err(SimulationError::from)?;
    let find = |name: &String| {
        let by_number = name.parse().ok().and_then(|number: usize| modes.modes.get(number.checked_sub(1)?));
        let is_named = |mode: &&FlightMode| mode.name.to_string().eq_ignore_ascii_case(name.trim());
        let listed =
            modes.modes.iter().enumerate().map(|(place, mode)| format!("{} {}", place + 1, mode.name));
        by_number.or_else(|| modes.modes.iter().find(is_named)).ok_or_else(|| RootError::Unknown {
            found: name.clone(),
            allowed: listed.collect::<Vec<_>>().join(", "),
        })
    };
    let mut shows: Vec<Show> = Vec::new();
    for name in asked {
        let mode = find(name)?;
        let show = Departing::new(view, (&plant, &trim), (&modes.unknowns, mode)).show(view, mode);
        // Whoever asks twice sees it once.
        if shows.iter().all(|other| other.name != show.name) {
            shows.push(show);
        }
    }
    Ok(shows)
}

/// A trim with a departure from it.
struct Departing<'a> {
    plant: &'a Plant,
    trim: &'a Trim,
    /// Unknowns and their parts in the departure, path and heading among them.
    parts: Vec<(Unknown, Complex<f64>)>,
    eigenvalue: Complex<f64>,
    duration: f64,
}

impl<'a> Departing<'a> {
    /// So large that the largest angle or displacement of the show is as large as it may be.
    fn new(
        view: &View,
        (plant, trim): (&'a Plant, &'a Trim),
        (unknowns, mode): (&[Unknown], &FlightMode),
    ) -> Self {
        let eigenvalue = mode.eigenvalue();
        let duration = if eigenvalue.im > 0.0 {
            SWINGS as f64 * TAU / eigenvalue.im
        } else {
            (TIME_CONSTANTS / eigenvalue.re.abs().max(f64::MIN_POSITIVE)).min(LONGEST)
        };
        let shape: Vec<Complex<f64>> = mode.root.shape.iter().copied().collect();
        let largest = (eigenvalue.re * duration).exp().max(1.0);
        let parts = unknowns.iter().copied().zip(shape).collect();
        let mut departing = Departing { plant, trim, parts, eigenvalue, duration };
        let factor = 1.0 / (departing.extent(view) * largest);
        departing.parts.iter_mut().for_each(|(_, part)| *part *= factor);
        departing.add_heading_and_path();
        departing
    }

    /// The largest angle or displacement in what may be drawn of it.
    fn extent(&self, view: &View) -> f64 {
        let angle = |(unknown, part): &(Unknown, Complex<f64>)| match unknown {
            Unknown::Roll | Unknown::Pitch => part.norm() / ANGLE,
            Unknown::Rate(_) => part.norm() / self.eigenvalue.norm().max(f64::MIN_POSITIVE) / ANGLE,
            _ => 0.0,
        };
        let angles = self.parts.iter().map(angle).fold(0.0, f64::max);
        let [real, imaginary] = [0.0, 0.25].map(|turn| self.displacements(Complex::cis(TAU * turn)));
        let moved = real.iter().zip(&imaginary).map(|(one, other)| one.norm().hypot(other.norm()));
        let moved = moved.skip(view.airframe.named[0]).fold(0.0, f64::max);
        angles.max(moved / (DISPLACEMENT * view.airframe.size())).max(f64::MIN_POSITIVE)
    }

    /// How far stations are beside their places in the trim, to first order, m.
    fn displacements(&self, phase: Complex<f64>) -> Vec<Vector3<f64>> {
        let at = |size: f64| {
            let state = self.state(phase * size);
            self.plant.outputs_at(&state, &self.trim.controls, &mut self.plant.workspace()).deflections
        };
        let pairs = std::iter::zip(at(SMALL), at(-SMALL));
        pairs.map(|(one, other)| (one.displacement - other.displacement) / (2.0 * SMALL)).collect()
    }

    /// A state with a part of the departure.
    fn state(&self, phase: Complex<f64>) -> Vec<f64> {
        let mut state = self.trim.state.clone();
        for (unknown, part) in &self.parts {
            self.plant.displace(*unknown, (part * phase).re, &mut state);
        }
        state
    }

    /// What nothing depends on, and no mode has therefore: yaw angle and horizontal position are what their rates make of them.
    fn add_heading_and_path(&mut self) {
        let is_free = self.parts.iter().any(|(unknown, _)| *unknown == Unknown::Down);
        if !is_free || self.eigenvalue.norm() < f64::EPSILON {
            return;
        }
        let pitch = self.trim.point.pitch;
        let yaw_rate = self.parts.iter().find(|(unknown, _)| *unknown == Unknown::Rate(2));
        let yaw = yaw_rate.map(|(_, part)| *part / (self.eigenvalue * pitch.cos()));
        self.parts.extend(yaw.map(|yaw| (Unknown::Yaw, yaw)));
        let rates = [1.0, -1.0].map(|sign| {
            // The real part at a quarter turn back is the imaginary one.
            [0.0, -0.25].map(|turn| self.earth_velocity(Complex::cis(TAU * turn) * (sign * SMALL)))
        });
        for axis in [0, 1] {
            let [real, imaginary] =
                [0, 1].map(|part| (rates[0][part][axis] - rates[1][part][axis]) / (2.0 * SMALL));
            self.parts.push((Unknown::Horizontal(axis), Complex::new(real, imaginary) / self.eigenvalue));
        }
    }

    /// Of O, m/s.
    fn earth_velocity(&self, phase: Complex<f64>) -> Vector3<f64> {
        let (state, layout) = (self.state(phase), self.plant.layout());
        let attitude = Attitude::from_quaternion(&state[layout.attitude()]);
        attitude.body_from_inertial.tr_mul(&Vector3::from_column_slice(&state[layout.velocity()]))
    }

    fn show(&self, view: &View, mode: &FlightMode) -> Show {
        let mut recording = Recording::default();
        let frames = FRAMES * SWINGS;
        let step = self.duration / frames as f64;
        let mut workspace = self.plant.workspace();
        for frame in 0..=frames {
            let phase = (self.eigenvalue * (frame as f64 * step)).exp();
            let outputs = self.plant.outputs_at(&self.state(phase), &self.trim.controls, &mut workspace);
            recording.take(&view.airframe, &outputs, &[]);
        }
        Show {
            kind: Kind::Root,
            name: mode.name.to_string(),
            level: view.settings.plant.fidelity.name(),
            facts: self.facts(mode),
            start: 0.0,
            step,
            loops: true,
            recording,
            charted: Vec::new(),
            gust: None,
            ghost: None,
        }
    }

    fn facts(&self, mode: &FlightMode) -> Vec<(String, String)> {
        let Complex { re, im } = self.eigenvalue;
        let imaginary = if im > 0.0 { format!(" ± {}i", rounded(im)) } else { String::new() };
        let mut facts = vec![("eigenvalue", format!("{}{imaginary} 1/s", rounded(re)))];
        if im > 0.0 {
            facts.push(("frequency", format!("{} Hz", rounded(im / TAU))));
            facts.push(("damping ratio", rounded(-re / self.eigenvalue.norm())));
        }
        let what = if re < 0.0 { "time to half" } else { "time to double" };
        facts.push((what, format!("{} s", rounded(std::f64::consts::LN_2 / re.abs()))));
        facts.extend(family(mode).map(|family| ("family", family.to_owned())));
        facts.push((
            "drawn",
            "as somebody sees it who flies along; linear, so that its size says nothing".to_owned(),
        ));
        if mode.is_quasi_steady {
            facts.push((
                "wake",
                "follows at once: with its own lag the mode is lost among the wake's".to_owned(),
            ));
        }
        facts.into_iter().map(|(label, text)| (label.to_owned(), text)).collect()
    }
}
