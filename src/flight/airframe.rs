//! The equations in flight: those of the whole aircraft, and those of its right half while the motion is symmetric.
//!
//! [theory: symmetry.half, symmetry.unfolding]
//!
//! An aircraft with a mirror plane that nothing has ever moved out of symmetry needs half its strips, half its modes
//! and half its rigid motion. As soon as something acts on one side alone, the whole aircraft takes over for good.

use std::sync::Arc;

use crate::equations::{EquationsOfMotion, StateLayout, Workspace};
use crate::plant::{FreeModes, Trim};
use crate::structure::{ReducedModel, ReducedStation};
use crate::symmetry::{Counterpart, SymmetricHalf};

use super::amplitudes::Amplitudes;
use super::error::SimulationError;
use super::integrator::{ErrorScale, Integrator};
use super::settings::Settings;

/// One set of equations with all that flying by them needs.
#[derive(Clone, Debug)]
pub(super) struct Airframe {
    pub equations: EquationsOfMotion,
    /// Which of the packaged modes take part.
    pub modes: Vec<usize>,
    /// With the shapes of those modes.
    pub stations: Vec<ReducedStation>,
    pub workspace: Workspace,
    pub integrator: Integrator,
    /// At which the integrator's linear part was taken, m/s.
    pub reference_airspeed: f64,
}

/// The equations that fly now, and those that may have to.
#[derive(Clone, Debug)]
pub(super) struct Airframes {
    whole: Airframe,
    half: Option<Half>,
    /// Whether the half flies: it exists then.
    is_half: bool,
}

#[derive(Clone, Debug)]
struct Half {
    airframe: Airframe,
    unfolding: Unfolding,
    /// For each engine its mirror image.
    engines: Vec<usize>,
    /// For each strip of the whole the one that stands for it.
    strips: Vec<Counterpart>,
}

/// How the state of the half becomes that of the whole: for each place its source and a sign; what has no source is
/// at rest [theory: symmetry.unfolding].
#[derive(Clone, Debug)]
struct Unfolding {
    sources: Vec<Option<(usize, f64)>>,
}

impl Airframes {
    /// Trims the aircraft, as half of it if it has a mirror plane; returns the trim of the equations that fly.
    ///
    /// # Errors
    /// When a setting is out of range or no trim exists.
    pub fn new(model: &Arc<ReducedModel>, settings: &Settings) -> Result<(Self, Trim), SimulationError> {
        let modes = settings.choose_modes(model)?;
        let reduced = model.select(&modes);
        let configuration = settings.configuration(&reduced);
        let equations = EquationsOfMotion::new(&reduced, &configuration);
        let Some(half) = SymmetricHalf::find(&reduced) else {
            let trim = equations.trim(&settings.trim_condition())?;
            let whole = Airframe::new(equations, &reduced, modes, settings, &trim);
            return Ok((Airframes { whole, half: None, is_half: false }, trim));
        };
        let halved = half.equations(&configuration);
        let trim = halved.trim(&settings.trim_condition())?;
        let unfolding = Unfolding::new(&half, halved.layout(), equations.layout());
        let mut unfolded = Trim { state: Vec::new(), ..trim.clone() };
        unfolding.unfold(&trim.state, &mut unfolded.state);
        let half_modes = half.modes.iter().map(|&mode| modes[mode]).collect();
        let whole = Airframe::new(equations, &reduced, modes, settings, &unfolded);
        let airframe = Airframe::new(halved, &half.model, half_modes, settings, &trim);
        let half = Half { airframe, unfolding, engines: half.engines, strips: half.strips };
        Ok((Airframes { whole, half: Some(half), is_half: true }, trim))
    }

    /// The equations that fly.
    pub fn flying(&self) -> &Airframe {
        match &self.half {
            Some(half) if self.is_half => &half.airframe,
            _ => &self.whole,
        }
    }

    /// The equations that fly.
    pub fn flying_mut(&mut self) -> &mut Airframe {
        match &mut self.half {
            Some(half) if self.is_half => &mut half.airframe,
            _ => &mut self.whole,
        }
    }

    /// Whether half the aircraft flies.
    pub fn is_half(&self) -> bool {
        self.is_half
    }

    /// Lets half or all of the aircraft fly from now on.
    pub fn choose(&mut self, is_half: bool) {
        self.is_half = is_half && self.half.is_some();
    }

    /// The equations of the half, if there is one, whichever fly.
    pub fn half(&self) -> Option<&Airframe> {
        self.half.as_ref().map(|half| &half.airframe)
    }

    /// For each engine its mirror image, while the half flies.
    pub fn mirrored_engines(&self) -> Option<&[usize]> {
        self.half.as_ref().filter(|_| self.is_half).map(|half| half.engines.as_slice())
    }

    /// A strip of the packaged aircraft that one of the equations that fly is, or stands for.
    pub fn packaged_strip(&self, strip: usize) -> usize {
        let Some(half) = self.half.as_ref().filter(|_| self.is_half) else { return strip };
        let lifting = half.airframe.equations.strip_count();
        let stands_for = |counterpart: &Counterpart| match *counterpart {
            Counterpart::Lifting { index, .. } => index == strip,
            Counterpart::EdgeOn(index) => lifting + index == strip,
        };
        half.strips.iter().position(stands_for).unwrap_or(strip)
    }

    /// Writes a state of the half as one of the whole.
    pub fn unfold(&self, state: &[f64], whole: &mut Vec<f64>) {
        if let Some(half) = &self.half {
            half.unfolding.unfold(state, whole);
        }
    }

    /// Takes other equations of the same layout, and those of the half, if there are, to fly by.
    pub fn take_equations(&mut self, whole: EquationsOfMotion, half: Option<EquationsOfMotion>) {
        self.whole.equations = whole;
        self.is_half = half.is_some();
        if let (Some(half), Some(equations)) = (&mut self.half, half) {
            half.airframe.equations = equations;
        }
    }

    /// The equations of the whole aircraft, whichever fly.
    pub fn whole(&self) -> &Airframe {
        &self.whole
    }

    /// The equations of the whole aircraft, whichever fly.
    pub fn whole_mut(&mut self) -> &mut Airframe {
        &mut self.whole
    }

    /// Lets the whole aircraft fly on in place of the half.
    pub fn leave_half(&mut self) {
        let reference_airspeed = self.flying().reference_airspeed;
        self.is_half = false;
        self.whole.take_reference_airspeed(reference_airspeed);
    }
}

impl Airframe {
    /// Flies about a trim of the equations.
    fn new(
        equations: EquationsOfMotion,
        model: &ReducedModel,
        modes: Vec<usize>,
        settings: &Settings,
        trim: &Trim,
    ) -> Self {
        let controls = trim.controls(model.engines.len());
        let free_modes = FreeModes::new(&equations, &trim.state, &controls);
        let amplitudes = Amplitudes::new(equations.layout(), free_modes);
        let scale = error_scale(model, settings.tolerance);
        Airframe {
            modes,
            stations: model.stations.clone(),
            workspace: Workspace::new(&equations),
            integrator: Integrator::new(equations.layout(), scale, amplitudes),
            reference_airspeed: 0.0,
            equations,
        }
    }

    /// Takes the inflow's linear part at the given airspeed.
    pub fn take_reference_airspeed(&mut self, airspeed: f64) {
        if airspeed != self.reference_airspeed {
            self.reference_airspeed = airspeed;
            let equations = &self.equations;
            self.integrator.set_inflow_linear_part(|linear| equations.inflow_linear_part(airspeed, linear));
        }
    }
}

impl Unfolding {
    fn new(half: &SymmetricHalf, from: &StateLayout, to: &StateLayout) -> Self {
        let mut sources = vec![None; to.len()];
        for (place, source) in to.rigid().zip(from.rigid()) {
            sources[place] = Some((source, 1.0));
        }
        for (kept, &mode) in half.modes.iter().enumerate().take(from.modes()) {
            sources[to.coordinates().start + mode] = Some((from.coordinates().start + kept, 1.0));
            sources[to.coordinate_rates().start + mode] = Some((from.coordinate_rates().start + kept, 1.0));
        }
        for (strip, counterpart) in half.strips.iter().enumerate() {
            let Counterpart::Lifting { index, sign } = *counterpart else { continue };
            for (place, source) in
                to.inflow_layout().of_strip(strip).into_iter().zip(from.inflow_layout().of_strip(index))
            {
                sources[place] = Some((source, sign));
            }
        }
        Unfolding { sources }
    }

    fn unfold(&self, half: &[f64], whole: &mut Vec<f64>) {
        whole.clear();
        whole
            .extend(self.sources.iter().map(|source| source.map_or(0.0, |(place, sign)| sign * half[place])));
    }
}

/// Magnitudes below which errors are absolute: 10 m and 1 m/s of O, 0.1 rad/s, 0.1 m and 1 m/s of the most
/// moving strip of any mode, 1 m/s of inflow [theory: integration.error].
fn error_scale(model: &ReducedModel, tolerance: f64) -> ErrorScale {
    let translations = model.strips.iter().flat_map(|strip| &strip.shapes.translation);
    let largest = translations.fold(0.0_f64, |largest, shape| largest.max(shape.abs()));
    let per_metre = if largest > 0.0 { 1.0 / largest } else { 1.0 };
    ErrorScale { tolerance, floors: [10.0, 1.0, 1.0, 0.1, 0.1 * per_metre, per_metre, 1.0] }
}
