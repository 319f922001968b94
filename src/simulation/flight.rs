//! The simulation of one flight.

use std::sync::Arc;

use crate::dynamics::{Controls, EquationsOfMotion, FreeModes, Trim, Workspace};
use crate::structure::{ReducedModel, ReducedStation};

use super::amplitudes::Amplitudes;
use super::integrator::{CellEnd, ErrorScale, Integrator, MAX_SUBSTEPS};
use super::steering::Steering;
use super::{Inputs, Outputs, Settings, SimulationError, outputs};

/// Width of a grid cell, s: the usual communication step. In the standard flight of README.md one step over it keeps
/// pitch, wing tip and load factor within 2e-6 of their peaks; the error control halves from there.
pub(super) const CELL: f64 = 10e-3;

/// Communication points this close to a grid point (in cells) are on it.
const ON_GRID: f64 = 1e-6;

/// Times beyond this, s, leave too few digits to tell the cells of the grid apart.
pub const LATEST: f64 = 1e7;

/// The inflow's linear part is taken at a reference airspeed, which follows the flight when the two differ
/// by more than this share; the rest of the decay, 160/s for the jet, is then well inside what a step bears.
const AIRSPEED_DRIFT: f64 = 0.1;

/// The trimmed flight condition found at construction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrimPoint {
    /// Pitch angle, rad.
    pub pitch: f64,
    /// Elevator angle, rad.
    pub elevator: f64,
    /// Thrust per engine, N.
    pub thrust: f64,
}

/// A place on the flight path, with what the integrator needs to go on from it.
#[derive(Clone, Debug)]
pub(super) struct Point {
    /// s.
    pub time: f64,
    /// All states.
    pub state: Vec<f64>,
    /// Sub-steps to try in the next cell.
    pub substeps: u32,
    /// f at the time and state under the present inputs.
    slope: Vec<f64>,
    /// Whether `slope` is that.
    pub slope_is_fresh: bool,
}

impl Point {
    fn copy_from(&mut self, other: &Point) {
        self.time = other.time;
        self.state.copy_from_slice(&other.state);
        self.substeps = other.substeps;
        self.slope.copy_from_slice(&other.slope);
        self.slope_is_fresh = other.slope_is_fresh;
    }
}

/// A flight of one aircraft: state, time and everything needed to go on.
///
/// Cells of time begin and end on an absolute grid. Where a step ends inside a cell, the present is computed
/// from the cell's beginning, the anchor, and the next step begins at the anchor again, unless the inputs
/// have changed: one step of 10 ms and ten of 1 ms are the same computation and give the same bits.
#[derive(Clone, Debug)]
pub struct Simulation {
    pub(super) model: Arc<ReducedModel>,
    /// Tells apart models and settings in snapshots.
    pub(super) identity: u128,
    pub(super) modes: Vec<usize>,
    pub(super) equations: EquationsOfMotion,
    /// With the shapes of the modes that take part.
    pub(super) stations: Vec<ReducedStation>,
    pub(super) steering: Steering,
    /// Where the present cell begins.
    pub(super) anchor: Point,
    pub(super) present: Point,
    /// What the present was before the call, should it fail.
    before: [Point; 2],
    /// At which the integrator's linear part was taken, m/s.
    pub(super) reference_airspeed: f64,
    /// Absolute controls at the last evaluation.
    pub(super) controls: Controls,
    pub(super) workspace: Workspace,
    integrator: Integrator,
    pub(super) outputs: Outputs,
}

impl Simulation {
    /// Trims the aircraft and stands at the trimmed state at time `start` (s), inputs zero.
    ///
    /// # Errors
    /// When a setting or the time is out of range or no trim exists.
    pub fn new(model: Arc<ReducedModel>, settings: &Settings, start: f64) -> Result<Self, SimulationError> {
        check_time(start)?;
        let modes = settings.choose_modes(&model)?;
        let reduced = model.select(&modes);
        let equations = EquationsOfMotion::new(&reduced, &settings.configuration(&reduced));
        let Trim { pitch, elevator, thrust, state } = equations.trim(&settings.trim_condition())?;
        let engines = model.engines.len();
        let present =
            Point { time: start, slope: vec![0.0; state.len()], state, substeps: 1, slope_is_fresh: false };
        let trimmed = Controls { elevator, thrust: vec![thrust; engines], ..Controls::neutral(engines) };
        let free_modes = FreeModes::new(&equations, &present.state, &trimmed);
        let amplitudes = Amplitudes::new(equations.layout(), free_modes);
        Ok(Simulation {
            identity: super::snapshot::identity(&model, settings),
            steering: Steering::new(TrimPoint { pitch, elevator, thrust }, settings, engines, start),
            anchor: present.clone(),
            before: [present.clone(), present.clone()],
            present,
            reference_airspeed: 0.0,
            controls: Controls::neutral(engines),
            workspace: Workspace::new(&equations),
            integrator: Integrator::new(
                equations.layout(),
                error_scale(&reduced, settings.tolerance),
                amplitudes,
            ),
            outputs: Outputs::new(&model),
            equations,
            stations: reduced.stations,
            modes,
            model,
        })
    }

    /// Time, s.
    pub fn time(&self) -> f64 {
        self.present.time
    }

    /// The trim found at construction.
    pub fn trim(&self) -> &TrimPoint {
        &self.steering.trim
    }

    /// Sets the inputs that act from now on, and their rates of change (zero: held constant).
    pub fn set_inputs(&mut self, inputs: &Inputs, rates: &Inputs) {
        if self.steering.set(inputs, rates, self.present.time) {
            self.present.slope_is_fresh = false;
            self.anchor.copy_from(&self.present);
        }
    }

    /// Flies to `end` (s, ≥ [`time`](Self::time)), without allocating.
    ///
    /// # Errors
    /// When the flight leaves the model's validity or `end` is out of range; the simulation is then as it was
    /// before the call.
    pub fn advance_to(&mut self, end: f64) -> Result<(), SimulationError> {
        check_time(end)?;
        let reference_airspeed = self.reference_airspeed;
        self.before[0].copy_from(&self.anchor);
        self.before[1].copy_from(&self.present);
        let flown = self.fly(end);
        if flown.is_err() {
            let [anchor, present] = &self.before;
            self.anchor.copy_from(anchor);
            self.present.copy_from(present);
            self.present.slope_is_fresh = false;
            self.take_reference_airspeed(reference_airspeed);
        }
        flown
    }

    /// The outputs at the present time under the present inputs, without allocating.
    pub fn outputs(&mut self) -> &Outputs {
        if !self.present.slope_is_fresh {
            self.steering.write(self.present.time, &mut self.controls);
            let Point { state, slope, .. } = &mut self.present;
            self.equations.rates(state, &self.controls, slope, &mut self.workspace);
            self.present.slope_is_fresh = true;
        }
        outputs::write(self);
        &self.outputs
    }

    /// Flies full cells from the anchor as far as `end` allows, then the rest of the way.
    fn fly(&mut self, end: f64) -> Result<(), SimulationError> {
        while end - self.present.time > ON_GRID * CELL {
            let begin = self.anchor.time;
            let boundary = CELL * (libm::floor(begin / CELL + ON_GRID) + 1.0);
            let is_full = boundary - end < ON_GRID * CELL;
            self.follow_airspeed();
            self.present.copy_from(&self.anchor);
            self.fly_cell(begin, if is_full { boundary } else { end })?;
            if is_full {
                self.anchor.copy_from(&self.present);
            }
        }
        Ok(())
    }

    /// Flies the present, which stands at the anchor, over one cell or part of one.
    fn fly_cell(&mut self, begin: f64, end: f64) -> Result<(), SimulationError> {
        let controls = &mut self.controls;
        let (equations, workspace) = (&self.equations, &mut self.workspace);
        let steering = &self.steering;
        let mut rates = |time: f64, state: &[f64], rates: &mut [f64]| {
            steering.write(time, controls);
            equations.rates(state, controls, rates, workspace);
        };
        let Point { time, state, substeps, slope, slope_is_fresh } = &mut self.present;
        if !*slope_is_fresh {
            rates(begin, state, slope);
        }
        match self.integrator.fly_cell((begin, end), *substeps, state, slope, rates) {
            CellEnd::Accepted { next } => {
                (*time, *substeps, *slope_is_fresh) = (end, next, true);
                self.workspace.reversed_strip().map_or(Ok(()), |strip| Err(self.reverse_flow(strip)))
            }
            CellEnd::Failed => Err(self.failure(end - begin)),
        }
    }

    /// Keeps the inflow's linear part near that of the flight.
    fn follow_airspeed(&mut self) {
        self.steering.write(self.anchor.time, &mut self.controls);
        let airspeed = self.equations.airspeed(&self.anchor.state, &self.controls);
        if (airspeed - self.reference_airspeed).abs() > AIRSPEED_DRIFT * self.reference_airspeed {
            self.take_reference_airspeed(airspeed);
        }
    }

    /// Takes the inflow's linear part at the given airspeed.
    pub(super) fn take_reference_airspeed(&mut self, airspeed: f64) {
        if airspeed != self.reference_airspeed {
            self.reference_airspeed = airspeed;
            let equations = &self.equations;
            self.integrator.set_inflow_linear_part(|linear| equations.inflow_linear_part(airspeed, linear));
        }
    }

    /// Why a cell could not be flown, not even in the smallest sub-steps.
    fn failure(&self, width: f64) -> SimulationError {
        let Point { time, state, slope, .. } = &self.present;
        let time = *time;
        if let Some(strip) = self.workspace.reversed_strip() {
            return self.reverse_flow(strip);
        }
        if state.iter().chain(slope).any(|x| !x.is_finite()) {
            return SimulationError::NotFinite { time };
        }
        let step = width / f64::from(MAX_SUBSTEPS);
        SimulationError::Tolerance { time, step, tolerance: self.integrator.tolerance() }
    }

    fn reverse_flow(&self, strip: usize) -> SimulationError {
        let component = self.model.strips[strip].component.clone();
        SimulationError::ReverseFlow { time: self.present.time, strip, component }
    }
}

fn check_time(time: f64) -> Result<(), SimulationError> {
    if time.abs() <= LATEST { Ok(()) } else { Err(SimulationError::Time { found: time }) }
}

/// Magnitudes below which errors are absolute: 10 m and 1 m/s of O, 0.1 rad/s, 0.1 m and 1 m/s of the most
/// moving strip of any mode, 1 m/s of inflow.
fn error_scale(model: &ReducedModel, tolerance: f64) -> ErrorScale {
    let translations = model.strips.iter().flat_map(|strip| &strip.shapes.translation);
    let largest = translations.fold(0.0_f64, |largest, shape| largest.max(shape.abs()));
    let per_metre = if largest > 0.0 { 1.0 / largest } else { 1.0 };
    ErrorScale { tolerance, floors: [10.0, 1.0, 1.0, 0.1, 0.1 * per_metre, per_metre, 1.0] }
}
