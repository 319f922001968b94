//! The simulation of one flight.

use std::sync::Arc;

use nalgebra::Vector3;

use crate::aircraft::Support;
use crate::dynamics::{Configuration, Controls, EquationsOfMotion, Trim, TrimCondition, Workspace};
use crate::structure::ReducedModel;

use super::integrator::{CELL, CellEnd, ErrorScale, MAX_SUBSTEPS, Stages};
use super::{InputReference, Inputs, Outputs, Settings, SimulationError, outputs};

/// Communication points this close to a grid point (in cells) are on it.
const ON_GRID: f64 = 1e-6;

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

/// A flight of one aircraft: state, time and everything needed to go on.
#[derive(Clone, Debug)]
pub struct Simulation {
    pub(super) model: Arc<ReducedModel>,
    /// Tells apart models and settings in snapshots.
    pub(super) identity: u128,
    pub(super) modes: Vec<usize>,
    pub(super) equations: EquationsOfMotion,
    tolerance: ErrorScale,
    trim: TrimPoint,
    reference: InputReference,
    pub(super) inputs: Inputs,
    pub(super) input_rates: Inputs,
    /// When the inputs were set, s.
    pub(super) input_time: f64,
    pub(super) time: f64,
    pub(super) state: Vec<f64>,
    /// Sub-steps to try in the next cell.
    pub(super) substeps: u32,
    /// f at the present time, state and inputs, when `slope_is_fresh`.
    slope: Vec<f64>,
    pub(super) slope_is_fresh: bool,
    /// Absolute controls at the last evaluation.
    pub(super) controls: Controls,
    pub(super) workspace: Workspace,
    stages: Stages,
    before: Vec<f64>,
    pub(super) outputs: Outputs,
}

impl Simulation {
    /// Trims the aircraft and stands at the trimmed state at time `start` (s), inputs zero.
    ///
    /// # Errors
    /// When a setting is out of range or no trim exists.
    pub fn new(model: Arc<ReducedModel>, settings: &Settings, start: f64) -> Result<Self, SimulationError> {
        let modes = settings.choose_modes(&model)?;
        let reduced = model.select(&modes);
        let equations = EquationsOfMotion::new(&reduced, &configuration(&reduced, settings));
        let condition = TrimCondition {
            airspeed: settings.airspeed,
            altitude: settings.altitude,
            heading: settings.heading,
        };
        let Trim { pitch, elevator, thrust, state } = equations.trim(&condition)?;
        let engines = model.engines.len();
        let states = state.len();
        Ok(Simulation {
            identity: super::snapshot::identity(&model, settings),
            tolerance: error_scale(&reduced, settings.tolerance),
            trim: TrimPoint { pitch, elevator, thrust },
            reference: settings.input_reference,
            inputs: Inputs::zero(engines),
            input_rates: Inputs::zero(engines),
            input_time: start,
            time: start,
            substeps: 1,
            slope: vec![0.0; states],
            slope_is_fresh: false,
            controls: Controls::neutral(engines),
            workspace: Workspace::new(&equations),
            stages: Stages::new(states),
            before: state.clone(),
            outputs: Outputs::new(&model),
            state,
            equations,
            modes,
            model,
        })
    }

    /// Time, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The trim found at construction.
    pub fn trim(&self) -> &TrimPoint {
        &self.trim
    }

    /// Sets the inputs that act from now on, and their rates of change (zero: held constant).
    pub fn set_inputs(&mut self, inputs: &Inputs, rates: &Inputs) {
        // The slope at this instant depends on the inputs, and through the wind on their rates.
        self.slope_is_fresh &= self.inputs == *inputs && self.input_rates.is_zero() && rates.is_zero();
        self.inputs.clone_from(inputs);
        self.input_rates.clone_from(rates);
        self.input_time = self.time;
    }

    /// Flies to `end` (s, ≥ [`time`](Self::time)), without allocating.
    ///
    /// # Errors
    /// When the flight leaves the model's validity; the simulation is then as it was before the call.
    pub fn advance_to(&mut self, end: f64) -> Result<(), SimulationError> {
        let (time, substeps) = (self.time, self.substeps);
        self.before.copy_from_slice(&self.state);
        let flown = self.fly_cells(end);
        if flown.is_err() {
            (self.time, self.substeps, self.slope_is_fresh) = (time, substeps, false);
            self.state.copy_from_slice(&self.before);
        }
        flown
    }

    /// The outputs at the present time under the present inputs, without allocating.
    pub fn outputs(&mut self) -> &Outputs {
        self.refresh_slope();
        outputs::write(self);
        &self.outputs
    }

    fn fly_cells(&mut self, end: f64) -> Result<(), SimulationError> {
        self.refresh_slope();
        while end - self.time > ON_GRID * CELL {
            let position = self.time / CELL;
            let nearest = libm::round(position);
            let on_grid = (position - nearest).abs() < ON_GRID;
            let boundary = CELL * (if on_grid { nearest } else { libm::floor(position) } + 1.0);
            let (width, next) = if end - boundary < -ON_GRID * CELL {
                (end - self.time, end)
            } else if on_grid {
                (CELL, boundary)
            } else {
                (boundary - self.time, boundary)
            };
            self.fly_cell(width)?;
            self.time = next;
            self.check_validity()?;
        }
        Ok(())
    }

    /// Flies the state over the next `width` seconds.
    fn fly_cell(&mut self, width: f64) -> Result<(), SimulationError> {
        let controls = &mut self.controls;
        let (equations, workspace) = (&self.equations, &mut self.workspace);
        let acting = Acting {
            reference: self.reference,
            trim: &self.trim,
            inputs: &self.inputs,
            rates: &self.input_rates,
            since: self.input_time,
        };
        let rates = |time: f64, state: &[f64], rates: &mut [f64]| {
            acting.write(time, controls);
            equations.rates(state, controls, rates, workspace);
        };
        let end = self.stages.fly_cell(
            equations.layout(),
            &self.tolerance,
            (self.time, width),
            self.substeps,
            &mut self.state,
            &mut self.slope,
            rates,
        );
        match end {
            CellEnd::Accepted { next } => {
                self.substeps = next;
                Ok(())
            }
            CellEnd::Failed => Err(self.failure(width)),
        }
    }

    /// Why a cell could not be flown.
    fn failure(&self, width: f64) -> SimulationError {
        let time = self.time;
        if let Some(strip) = self.workspace.reversed_strip() {
            return self.reverse_flow(strip);
        }
        if self.state.iter().chain(&self.slope).any(|x| !x.is_finite()) {
            return SimulationError::NotFinite { time };
        }
        let step = width / f64::from(MAX_SUBSTEPS);
        SimulationError::Tolerance { time, step, tolerance: self.tolerance.tolerance }
    }

    fn check_validity(&self) -> Result<(), SimulationError> {
        self.workspace.reversed_strip().map_or(Ok(()), |strip| Err(self.reverse_flow(strip)))
    }

    fn reverse_flow(&self, strip: usize) -> SimulationError {
        let component = self.model.strips[strip].component.clone();
        SimulationError::ReverseFlow { time: self.time, strip, component }
    }

    fn refresh_slope(&mut self) {
        if self.slope_is_fresh {
            return;
        }
        let acting = Acting {
            reference: self.reference,
            trim: &self.trim,
            inputs: &self.inputs,
            rates: &self.input_rates,
            since: self.input_time,
        };
        acting.write(self.time, &mut self.controls);
        self.equations.rates(&self.state, &self.controls, &mut self.slope, &mut self.workspace);
        self.slope_is_fresh = true;
    }
}

/// The inputs as functions of time.
struct Acting<'a> {
    reference: InputReference,
    trim: &'a TrimPoint,
    inputs: &'a Inputs,
    rates: &'a Inputs,
    since: f64,
}

impl Acting<'_> {
    /// The absolute controls at a time.
    fn write(&self, time: f64, controls: &mut Controls) {
        let elapsed = time - self.since;
        let (elevator, thrust) = match self.reference {
            InputReference::Trim => (self.trim.elevator, self.trim.thrust),
            InputReference::Absolute => (0.0, 0.0),
        };
        controls.elevator = elevator + self.inputs.elevator + elapsed * self.rates.elevator;
        controls.aileron = self.inputs.aileron + elapsed * self.rates.aileron;
        controls.rudder = self.inputs.rudder + elapsed * self.rates.rudder;
        for ((acting, input), rate) in
            controls.thrust.iter_mut().zip(&self.inputs.thrust).zip(&self.rates.thrust)
        {
            *acting = thrust + input + elapsed * rate;
        }
        controls.wind = self.inputs.wind + self.rates.wind * elapsed;
        controls.wind_rate = self.rates.wind;
    }
}

/// What the settings mean for the equations.
fn configuration(model: &ReducedModel, settings: &Settings) -> Configuration {
    let tunnel_flow = match model.support {
        Support::Free => Vector3::zeros(),
        Support::Clamped => {
            let (sin, cos) = libm::sincos(settings.heading);
            Vector3::new(cos, sin, 0.0) * -settings.airspeed
        }
    };
    Configuration {
        fidelity: settings.fidelity,
        stiffness_scale: settings.stiffness_scale,
        structural_damping: settings.structural_damping,
        inflow_states: settings.inflow_states,
        tunnel_flow,
    }
}

/// Magnitudes below which errors are absolute: 10 m and 1 m/s of O, 0.1 rad/s, 0.1 m and 1 m/s of the most
/// moving strip of any mode, 1 m/s of inflow.
fn error_scale(model: &ReducedModel, tolerance: f64) -> ErrorScale {
    let translations = model.strips.iter().flat_map(|strip| &strip.shapes.translation);
    let largest = translations.fold(0.0_f64, |largest, shape| largest.max(shape.abs()));
    let per_metre = if largest > 0.0 { 1.0 / largest } else { 1.0 };
    ErrorScale { tolerance, floors: [10.0, 1.0, 1.0, 0.1, 0.1 * per_metre, per_metre, 1.0] }
}
