//! The simulation of one flight [theory: integration.grid].

use std::sync::{Arc, OnceLock};

use crate::equations::Controls;
use crate::plant::{Course, LimitExceeded, PackagedStrip, Trim, TrimPoint};
use crate::structure::ReducedModel;
use crate::symmetry::{FlyingPlant, Plants};

use super::actions::Acts;
use super::encounter::encounter;
use super::error::SimulationError;
use super::evaluation::{Wind, refresh};
use super::inputs::Inputs;
use super::instant::{Freshness, Instant};
use super::integrator::{CellEnd, ErrorScale, Integrator, MAX_SUBSTEPS};
use super::moment::{LATEST, LONGEST_STEP, Moment, ON_GRID, resolution};
use super::point::{Path, Point};
use super::sensors::Sensors;
use super::settings::Settings;
use super::steering::Steering;

/// The rates' linear part is taken at a reference airspeed, which follows the flight when the two differ by more than
/// this share; the rest, 160/s for the jet's wake, a step bears well [theory: integration.linear-part].
const AIRSPEED_DRIFT: f64 = 0.1;

/// A flight of one aircraft: state, time and everything needed to go on.
///
/// Cells of time begin and end on a grid that begins with the flight. Where a step ends inside a cell, the present is computed
/// from the cell's beginning, the anchor, and the next step begins at the anchor again, unless the inputs
/// have changed: one step of 10 ms and ten of 1 ms are the same computation and give the same bits.
///
/// ```
/// # use std::sync::Arc;
/// use flexible_aircraft::flight::{Inputs, Settings, Simulation};
/// # use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let jet = Arc::new(ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?);
/// let mut flight = Simulation::new(Arc::clone(&jet), &Settings::of(&jet), 0.0)?;
/// let constant = Inputs::zero(&jet);
/// let mut inputs = constant.clone();
/// inputs.wind.z = -3.0; // m/s: the air rises
/// flight.set_inputs(&inputs, &constant);
/// flight.advance_to(0.5)?; // s
/// assert!(flight.outputs().load_factor.z > 1.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Simulation {
    pub(super) model: Arc<ReducedModel>,
    /// Tells settings apart in snapshots.
    pub(super) settings_hash: u128,
    /// Tells apart models and settings, once a snapshot has been asked for.
    pub(super) identity: OnceLock<u128>,
    /// In which all states on the path are.
    pub(super) flying: FlyingPlant<Integrator>,
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
    pub(super) evaluated_in: Option<Wind>,
    pub(super) sensors: Sensors,
    pub(super) instant: Instant,
    /// How much of it is the present under the present inputs.
    pub(super) instant_is: Freshness,
    /// Whether the plant that flies does so on under what acts, where that is known and does not change with time.
    pub(super) stays: Option<bool>,
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
        settings.check(&model)?;
        let along_course = settings.plant.along_course();
        let plants = Plants::under(&model, &along_course)?;
        let condition = along_course.trim_condition();
        let found = plants.trim(&condition)?;
        let trimmed = found.trim().clone();
        let gust = encounter(&model, settings, plants.plant_of_trim(&condition), &trimmed);
        let gust_is_in_plane = gust.as_ref().map(|gust| gust.is_in_plane());
        let plants = match gust {
            Some(gust) => plants.map(|plant| plant.clone().in_gust(&gust)),
            None => plants,
        };
        let room = plants.most_states();
        let attitude = plants.plant_of_trim(&condition).layout().attitude();
        let flying = FlyingPlant::new(plants, &found, |plant, trim| {
            let scale = ErrorScale { tolerance: settings.tolerance, floors: plant.magnitudes() };
            Integrator::new(plant.layout(), scale, plant.linear_part(trim))
        });
        let (course, steering) = (
            Course::new(settings.plant.heading).from(&trimmed.state[attitude]),
            Steering::new(&trimmed, settings, &model).in_gust(gust_is_in_plane),
        );
        steering.check_trim(&model)?;
        let plant = flying.plant();
        let sensors = Sensors::new(&model, &settings.sensors, || {
            plant.outputs_along(course, &trimmed.state, &trimmed.controls, &mut plant.workspace())
        });
        Ok(Simulation {
            settings_hash: settings.hash(),
            identity: OnceLock::new(),
            course,
            start,
            path: Path::new(Moment::START, &trimmed.state, steering.at_rest(), room),
            steering,
            controls: flying.plant().neutral_controls(),
            evaluated_in: None,
            instant: Instant::new(flying.plant().room_for_outputs(), trimmed.point, sensors.count()),
            instant_is: Freshness::Stale,
            stays: None,
            sensors,
            limits_exceeded: LimitExceeded::find(&model.limits, flying.plant(), &trimmed),
            flying,
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
        self.instant_is = Freshness::Stale;
        self.stays = None;
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
        let reference_airspeed = self.flying.marcher().reference_airspeed();
        // What stands now stays until a second cell is flown.
        let turns_back = self.path.begins_here()
            && self.plant_stays()
            && end.since(self.path.present.time.cell_end()) < ON_GRID;
        if !turns_back {
            self.path.keep();
            self.sensors.keep();
        }
        self.flying.keep();
        self.instant_is = Freshness::Stale;
        self.take_actions(reference_airspeed);
        let flown = self.fly(end);
        if flown.is_err() {
            if turns_back {
                self.path.turn_back();
            } else {
                self.path.restore_kept();
                self.sensors.restore_kept();
            }
            self.flying.restore_kept();
            self.stays = None;
            self.forget_evaluation();
            self.take_reference_airspeed(reference_airspeed);
        }
        flown
    }

    /// Has that plant fly on that can under what acts now.
    fn take_actions(&mut self, reference_airspeed: f64) {
        if self.plant_stays() {
            return;
        }
        self.stays = None;
        let (acting, states) = self.path.acting_and_states();
        if self.flying.take_actions(&Acts::new(&self.steering, acting), states) {
            self.forget_evaluation();
            self.take_reference_airspeed(reference_airspeed);
        }
    }

    /// Whether the same plant flies on under what acts now.
    pub(super) fn plant_stays(&mut self) -> bool {
        let known = self.stays.filter(|_| !self.steering.lags());
        let acts = Acts::new(&self.steering, &self.path.present.acting);
        *self.stays.insert(known.unwrap_or_else(|| self.flying.stays_under(&acts)))
    }

    /// Whether the motion has been symmetric and is computed so.
    pub fn is_symmetric(&self) -> bool {
        self.flying.is_symmetric()
    }

    /// Takes the linear part of the rates at an airspeed, m/s.
    pub(super) fn take_reference_airspeed(&mut self, airspeed: f64) {
        let (plant, integrator) = self.flying.plant_and_marcher();
        integrator.take_reference_airspeed(plant, airspeed);
    }

    /// Has the equations evaluated anew when they are next asked.
    pub(super) fn forget_evaluation(&mut self) {
        self.evaluated_in = None;
        self.instant_is = Freshness::Stale;
        for point in self.path.points_mut() {
            point.forget_slope();
        }
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
                self.take_samples();
            }
        }
        Ok(())
    }

    /// Flies from the anchor over one cell or part of one.
    fn fly_cell(&mut self, begin: Moment, end: Moment) -> Result<(), SimulationError> {
        let Simulation { path, flying, steering, controls, evaluated_in, .. } = self;
        let (mut plant, integrator) = flying.active();
        let (anchor, present) = path.set_off();
        refresh(anchor, &mut plant, steering, controls, evaluated_in);
        *evaluated_in = None;
        let (width, set_before, set_before_end) =
            (end.since(begin), begin.since(steering.since), end.since(steering.since));
        let mut rates = |time: f64, state: &[f64], rates: &mut [f64]| {
            // At the end as whoever evaluates there again counts the time, to the bit.
            let elapsed = if time == width { set_before_end } else { set_before + time };
            steering.write_after((time, set_before, elapsed), &anchor.acting, controls);
            plant.rates(state, controls, rates);
        };
        let (from, to) =
            ((&anchor.state[..], &anchor.slope[..]), (&mut present.state[..], &mut present.slope[..]));
        steering.move_on((width, set_before), &anchor.acting, &mut present.acting);
        let cell_end = integrator.fly_cell(width, anchor.substeps, from, to, &mut rates);
        let reversed = plant.reversed_strip(&present.state, controls).cloned();
        match cell_end {
            CellEnd::Accepted { next } => {
                (present.time, present.substeps, present.slope_is_fresh) = (end, next, true);
                *evaluated_in = Some((controls.wind, controls.wind_rate));
                reversed.map_or(Ok(()), |strip| Err(reverse_flow(self.time_of(end), strip)))
            }
            CellEnd::Failed => Err(self.failure(begin, end, reversed)),
        }
    }

    /// Keeps the linear part near that of the flight.
    fn follow_airspeed(&mut self) {
        let anchor = self.path.anchor();
        self.steering.write_at(anchor.time, &anchor.acting, &mut self.controls);
        let airspeed = self.flying.plant().airspeed(&anchor.state, &self.controls);
        let reference = self.flying.marcher().reference_airspeed();
        if (airspeed - reference).abs() > AIRSPEED_DRIFT * reference {
            self.take_reference_airspeed(airspeed);
        }
    }

    /// Why a cell could not be flown, not even in the smallest sub-steps.
    fn failure(&self, begin: Moment, end: Moment, reversed: Option<PackagedStrip>) -> SimulationError {
        let Point { state, slope, .. } = &self.path.present;
        let time = self.time_of(begin);
        if let Some(strip) = reversed {
            return reverse_flow(time, strip);
        }
        if state.iter().chain(slope).any(|x| !x.is_finite()) {
            return SimulationError::NotFinite { time };
        }
        let step = end.since(begin) / f64::from(MAX_SUBSTEPS);
        SimulationError::Tolerance { time, step, tolerance: self.flying.marcher().tolerance() }
    }
}

fn reverse_flow(time: f64, strip: PackagedStrip) -> SimulationError {
    SimulationError::ReverseFlow { time, strip: strip.number, component: strip.component }
}

fn check_time(time: f64) -> Result<(), SimulationError> {
    if time.abs() <= LATEST { Ok(()) } else { Err(SimulationError::Time { found: time }) }
}
