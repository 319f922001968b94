//! The simulation of one flight [theory: integration.grid].

use std::sync::{Arc, OnceLock};

use nalgebra::Vector3;

use crate::equations::Controls;
use crate::plant::{Trim, TrimPoint};
use crate::structure::ReducedModel;

use super::airframe::{Airframe, Airframes};
use super::course::Course;
use super::error::SimulationError;
use super::inputs::Inputs;
use super::integrator::{CellEnd, MAX_SUBSTEPS};
use super::limits::LimitExceeded;
use super::moment::{LATEST, LONGEST_STEP, Moment, ON_GRID, resolution};
use super::outputs::{self, Outputs};
use super::point::{Path, Point};
use super::settings::Settings;
use super::steering::Steering;

/// The inflow's linear part is taken at a reference airspeed, which follows the flight when the two differ by more than
/// this share; the rest of the decay, 160/s for the jet, a step bears well [theory: integration.linear-part].
const AIRSPEED_DRIFT: f64 = 0.1;

/// A state and slope of the whole aircraft while the half flies.
#[derive(Clone, Debug)]
pub(super) struct View {
    pub state: Vec<f64>,
    slope: Vec<f64>,
    /// Whether they are those of the present under the present inputs.
    is_fresh: bool,
}

/// Velocity of the air and its rate along the course, m/s and m/s².
type Wind = (Vector3<f64>, Vector3<f64>);

/// A flight of one aircraft: state, time and everything needed to go on.
///
/// Cells of time begin and end on a grid that begins with the flight. Where a step ends inside a cell, the present is computed
/// from the cell's beginning, the anchor, and the next step begins at the anchor again, unless the inputs
/// have changed: one step of 10 ms and ten of 1 ms are the same computation and give the same bits.
#[derive(Clone, Debug)]
pub struct Simulation {
    pub(super) model: Arc<ReducedModel>,
    /// Tells settings apart in snapshots.
    pub(super) settings_hash: u128,
    /// Tells apart models and settings, once a snapshot has been asked for.
    pub(super) identity: OnceLock<u128>,
    pub(super) airframes: Airframes,
    /// How the flight began.
    pub(super) trimmed: Trim,
    pub(super) course: Course,
    /// Time at which the flight begins, s.
    pub(super) start: f64,
    pub(super) steering: Steering,
    /// Where the flight is and where its cell of time begins.
    pub(super) path: Path,
    /// Absolute controls at the last evaluation.
    pub(super) controls: Controls,
    /// The wind of the last evaluation, if that was at the present state.
    evaluated_in: Option<Wind>,
    /// The whole aircraft at the present, for reading what acts on one side alone before it flies on.
    pub(super) view: View,
    pub(super) outputs: Outputs,
    /// Whether they are those of the present under the present inputs.
    outputs_are_fresh: bool,
    /// Of the trim.
    limits_exceeded: Vec<LimitExceeded>,
}

impl Simulation {
    /// Trims the aircraft and stands at the trimmed state at time `start` (s), inputs zero.
    ///
    /// # Errors
    /// When a setting or the time is out of range or no trim exists.
    pub fn new(model: Arc<ReducedModel>, settings: &Settings, start: f64) -> Result<Self, SimulationError> {
        check_time(start)?;
        settings.check_ranges(model.support)?;
        let (airframes, trimmed) = Airframes::new(&model, &settings.along_course())?;
        let limits_exceeded = LimitExceeded::find(&model.limits, &airframes.flying().equations, &trimmed);
        let engines = model.engines.len();
        let room = airframes.whole().equations.layout().len();
        Ok(Simulation {
            settings_hash: super::snapshot::settings_hash(settings),
            identity: OnceLock::new(),
            steering: Steering::new(trimmed.point, settings, engines),
            course: Course::new(settings.heading),
            start,
            path: Path::new(Moment::START, &trimmed.state, room),
            controls: Controls::neutral(engines),
            evaluated_in: None,
            view: View { state: Vec::with_capacity(room), slope: vec![0.0; room], is_fresh: false },
            outputs: Outputs::new(&model),
            outputs_are_fresh: false,
            limits_exceeded,
            airframes,
            trimmed,
            model,
        })
    }

    /// Time, s.
    pub fn time(&self) -> f64 {
        self.time_of(self.path.present.time)
    }

    /// s.
    fn time_of(&self, moment: Moment) -> f64 {
        self.start + moment.seconds()
    }

    /// The trim found at construction.
    pub fn trim(&self) -> &TrimPoint {
        &self.steering.trim
    }

    /// Where the trim is beyond the aircraft's limits: it stands, but nobody could fly it.
    pub fn limits_exceeded(&self) -> &[LimitExceeded] {
        &self.limits_exceeded
    }

    /// Writes the inputs as they stand now: what was set last, and what its rates have made of it since.
    pub fn write_inputs(&self, inputs: &mut Inputs) {
        self.steering.write_inputs(self.path.present.time, inputs);
    }

    /// Per second, as set last.
    pub fn input_rates(&self) -> &Inputs {
        &self.steering.rates
    }

    /// Sets the inputs that act from now on, and their rates of change (zero: held constant, the wind but for its
    /// `wind_rate`).
    pub fn set_inputs(&mut self, inputs: &Inputs, rates: &Inputs) {
        if self.steering.set(inputs, rates, self.path.present.time) {
            self.path.begin_here();
            self.take_inputs();
        }
    }

    /// Has the present evaluated anew under the inputs that act now.
    fn take_inputs(&mut self) {
        self.path.present.slope_is_fresh = false;
        self.view.is_fresh = false;
        self.outputs_are_fresh = false;
    }

    /// Flies to `end` (s, ≥ [`time`](Self::time)), without allocating.
    ///
    /// # Errors
    /// When the flight leaves the model's validity or `end` is out of range or more than [`LONGEST_STEP`] away; the
    /// simulation is then as it was before the call.
    pub fn advance_to(&mut self, end: f64) -> Result<(), SimulationError> {
        self.step(end, 0.0)
    }

    /// Flies over a step of a size (s) from a communication point (s): to (point − start) + size after the start, or to
    /// the grid if that is within the [`resolution`] of the point. What points have lost of their digits, sizes still have:
    /// where they are coarser than the grid, the size counts from the present, as long as that is within their resolution.
    ///
    /// # Errors
    /// As for [`advance_to`](Self::advance_to).
    pub fn step(&mut self, point: f64, size: f64) -> Result<(), SimulationError> {
        check_time(point + size)?;
        let present = self.path.present.time;
        let resolution = resolution(point.abs().max(self.start.abs()));
        let end = Moment::after_start((point - self.start) + size, resolution);
        if end.since(present) > LONGEST_STEP {
            return Err(SimulationError::Step { found: end.since(present) });
        }
        let by_size = Moment::after_start(present.seconds() + size, 0.0);
        let is_coarse = size > 0.0 && resolution > ON_GRID && !end.is_on_grid();
        let keeps_to_size = is_coarse && by_size.since(end).abs() <= resolution;
        let end = if keeps_to_size { by_size } else { end };
        if !self.steering.is_finite_until(end) {
            return Err(SimulationError::Inputs { time: self.start + end.seconds() });
        }
        self.fly_or_stay(end)
    }

    /// Flies to a time, or is as before.
    fn fly_or_stay(&mut self, end: Moment) -> Result<(), SimulationError> {
        let (was_half, reference_airspeed) =
            (self.airframes.is_half(), self.airframes.flying().reference_airspeed);
        // What stands now stays until a second cell is flown.
        let turns_back = self.path.begins_here()
            && !self.must_unfold()
            && end.since(self.path.present.time.cell_end()) < ON_GRID;
        if !turns_back {
            self.path.keep();
        }
        self.outputs_are_fresh = false;
        self.view.is_fresh = false;
        if self.must_unfold() {
            self.unfold();
        }
        let flown = self.fly(end);
        if flown.is_err() {
            if turns_back {
                self.path.turn_back();
            } else {
                self.path.restore_kept();
            }
            self.forget_evaluation();
            self.airframes.choose(was_half);
            self.airframes.flying_mut().take_reference_airspeed(reference_airspeed);
        }
        flown
    }

    /// The outputs at the present time under the present inputs, without allocating.
    pub fn outputs(&mut self) -> &Outputs {
        if !self.outputs_are_fresh {
            if self.must_unfold() {
                self.refresh_view();
            } else {
                self.refresh();
            }
            outputs::write(self);
            self.outputs_are_fresh = true;
        }
        &self.outputs
    }

    /// Reads the outputs as they would be at the present time and state under other inputs, and leaves the flight as it was.
    pub fn outputs_under<T>(
        &mut self,
        inputs: &Inputs,
        rates: &Inputs,
        read: impl FnOnce(&Outputs, &TrimPoint) -> T,
    ) -> T {
        let acting = self.steering.clone();
        self.steering.set(inputs, rates, self.path.present.time);
        self.take_inputs();
        self.outputs();
        let read = read(&self.outputs, &acting.trim);
        self.steering = acting;
        self.take_inputs();
        read
    }

    /// Whether half the aircraft flies for the whole, since the motion is symmetric.
    pub fn is_symmetric(&self) -> bool {
        self.airframes.is_half()
    }

    /// Whether half the aircraft has flown, and something acts on one side alone now.
    pub(super) fn must_unfold(&self) -> bool {
        self.airframes.mirrored_engines().is_some_and(|engines| !self.steering.is_symmetric(engines))
    }

    /// Lets the whole aircraft fly on in place of the half.
    fn unfold(&mut self) {
        for point in self.path.points_mut() {
            self.airframes.unfold(&point.state, &mut self.view.state);
            point.resize(self.view.state.len());
            point.state.copy_from_slice(&self.view.state);
        }
        self.airframes.leave_half();
        self.forget_evaluation();
    }

    /// Has the equations evaluated anew when they are next asked.
    pub(super) fn forget_evaluation(&mut self) {
        self.evaluated_in = None;
        self.view.is_fresh = false;
        self.outputs_are_fresh = false;
        for point in self.path.points_mut() {
            point.slope_is_fresh = false;
        }
    }

    /// Evaluates the equations of the whole aircraft at the present of the half.
    fn refresh_view(&mut self) {
        let View { state, slope, is_fresh } = &mut self.view;
        if !*is_fresh {
            self.airframes.unfold(&self.path.present.state, state);
            self.steering.write_at(self.path.present.time, &mut self.controls);
            let Airframe { equations, workspace, .. } = self.airframes.whole_mut();
            equations.rates(state, &self.controls, slope, workspace);
            *is_fresh = true;
        }
    }

    /// Brings the slope at the present up to date with the inputs.
    fn refresh(&mut self) {
        let Simulation { path, airframes, steering, controls, evaluated_in, .. } = self;
        refresh(&mut path.present, airframes.flying_mut(), steering, controls, evaluated_in);
    }

    /// Flies full cells from the anchor as far as `end` allows, then the rest of the way.
    fn fly(&mut self, end: Moment) -> Result<(), SimulationError> {
        while end.since(self.path.present.time) > ON_GRID {
            let begin = self.path.anchor().time;
            let boundary = begin.cell_end();
            let is_full = end >= boundary;
            if !self.path.begins_here() {
                self.evaluated_in = None;
            }
            self.follow_airspeed();
            self.fly_cell(begin, if is_full { boundary } else { end })?;
            if is_full {
                self.path.begin_here();
            }
        }
        Ok(())
    }

    /// Flies from the anchor over one cell or part of one.
    fn fly_cell(&mut self, begin: Moment, end: Moment) -> Result<(), SimulationError> {
        let Simulation { path, airframes, steering, controls, evaluated_in, .. } = self;
        let airframe = airframes.flying_mut();
        let (anchor, present) = path.set_off();
        refresh(anchor, airframe, steering, controls, evaluated_in);
        *evaluated_in = None;
        let Airframe { equations, workspace, integrator, .. } = airframe;
        let (width, set_before, set_before_end) =
            (end.since(begin), begin.since(steering.since), end.since(steering.since));
        let mut rates = |time: f64, state: &[f64], rates: &mut [f64]| {
            // At the end as whoever evaluates there again counts the time, to the bit.
            let elapsed = if time == width { set_before_end } else { set_before + time };
            steering.write_after(elapsed, controls);
            equations.rates(state, controls, rates, workspace);
        };
        let (from, to) =
            ((&anchor.state[..], &anchor.slope[..]), (&mut present.state[..], &mut present.slope[..]));
        let cell_end = integrator.fly_cell(width, anchor.substeps, from, to, &mut rates);
        let reversed = equations.reversed_strip(&present.state, controls, workspace);
        match cell_end {
            CellEnd::Accepted { next } => {
                (present.time, present.substeps, present.slope_is_fresh) = (end, next, true);
                *evaluated_in = Some((controls.wind, controls.wind_rate));
                reversed.map_or(Ok(()), |strip| Err(self.reverse_flow(self.time_of(end), strip)))
            }
            CellEnd::Failed => Err(self.failure(begin, end, reversed)),
        }
    }

    /// Keeps the inflow's linear part near that of the flight.
    fn follow_airspeed(&mut self) {
        let anchor = self.path.anchor();
        self.steering.write_at(anchor.time, &mut self.controls);
        let airframe = self.airframes.flying_mut();
        let airspeed = airframe.equations.airspeed(&anchor.state, &self.controls);
        let reference = airframe.reference_airspeed;
        if (airspeed - reference).abs() > AIRSPEED_DRIFT * reference {
            airframe.take_reference_airspeed(airspeed);
        }
    }

    /// Why a cell could not be flown, not even in the smallest sub-steps.
    fn failure(&self, begin: Moment, end: Moment, reversed: Option<usize>) -> SimulationError {
        let Point { state, slope, .. } = &self.path.present;
        let time = self.time_of(begin);
        if let Some(strip) = reversed {
            return self.reverse_flow(time, strip);
        }
        if state.iter().chain(slope).any(|x| !x.is_finite()) {
            return SimulationError::NotFinite { time };
        }
        let step = end.since(begin) / f64::from(MAX_SUBSTEPS);
        SimulationError::Tolerance { time, step, tolerance: self.airframes.flying().integrator.tolerance() }
    }

    fn reverse_flow(&self, time: f64, strip: usize) -> SimulationError {
        let strip = self.airframes.packaged_strip(strip);
        let component = self.model.strips[strip].component.clone();
        SimulationError::ReverseFlow { time, strip, component }
    }
}

/// Brings the slope at a point up to date with the inputs; `evaluated_in` is the wind of the last evaluation, if that
/// was at this point.
fn refresh(
    point: &mut Point,
    airframe: &mut Airframe,
    steering: &Steering,
    controls: &mut Controls,
    evaluated_in: &mut Option<Wind>,
) {
    if point.slope_is_fresh {
        return;
    }
    steering.write_at(point.time, controls);
    let wind = (controls.wind, controls.wind_rate);
    let Airframe { equations, workspace, .. } = airframe;
    if *evaluated_in == Some(wind) {
        equations.steer(controls, &mut point.slope, workspace);
    } else {
        equations.rates(&point.state, controls, &mut point.slope, workspace);
        *evaluated_in = Some(wind);
    }
    point.slope_is_fresh = true;
}

fn check_time(time: f64) -> Result<(), SimulationError> {
    if time.abs() <= LATEST { Ok(()) } else { Err(SimulationError::Time { found: time }) }
}
