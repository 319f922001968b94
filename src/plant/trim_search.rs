//! Newton's method for the trim [theory: trim.residual, trim.newton, trim.balance].

use nalgebra::Vector3;

use crate::air::STANDARD_GRAVITY;
use crate::aircraft::{Support, TrimRole};
use crate::equations::{Controls, Workspace};
use crate::kinematics::{ASIDE, GeneralisedVector};
use crate::math::{central, largest, quaternion_of_euler_angles, solve};

use super::manoeuvre::{Manoeuvre, SteadyFlight};
use super::system::Plant;
use super::trim::{Trim, TrimCondition, TrimPoint};
use super::trim_error::{TrimError, TrimFailure};
use super::trim_problem::{Balance, TrimProblem, TrimUnknown, steady_load_factors};

/// Newton steps before giving up.
const MAX_STEPS: usize = 60;

/// Newton steps smaller than this (rad, weights, metres of mode) no longer improve the trim.
const SMALLEST_STEP: f64 = 1e-15;

/// Largest change of an angle in one Newton step, rad.
const LARGEST_TURN: f64 = 0.2;

/// Accelerations below this are in balance: m/s², rad/s², and modal accelerations relative to the largest
/// elastic one.
pub(super) const BALANCED: f64 = 1e-7;

/// An aircraft that goes aside or turns by less than this, m/s² or rad/s², is symmetric up to rounding.
const STRAIGHT: f64 = 1e-10;

/// How Newton's method ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum SearchEnd {
    /// The steps stopped shrinking.
    Steps(usize),
    /// They did not in so many.
    TooMany(usize),
    /// The Jacobian became singular.
    Singular(usize),
}

/// A search, then what it has found.
pub(crate) struct Search<'a> {
    pub(super) plant: &'a Plant,
    pub(super) condition: TrimCondition,
    /// The unknowns before q, and what they balance.
    pub(super) problem: TrimProblem,
    pub(super) values: Vec<f64>,
    /// Whether the last steps led to where the rows vanish.
    pub(super) converged: bool,
    pub(super) state: Vec<f64>,
    pub(super) controls: Controls,
    rates: Vec<f64>,
    pub(super) workspace: Workspace,
}

impl<'a> Search<'a> {
    /// Searches in the plane of symmetry first; where the aircraft leaves it, all around.
    pub fn find(plant: &'a Plant, condition: TrimCondition) -> Result<Self, Box<TrimError>> {
        let mut search = Search::new(plant, condition, TrimProblem::in_plane(plant, &condition));
        if plant.support() == Support::Free && !moves_anything(plant, TrimRole::Pitch) {
            return Err(Box::new(search.without_pitch_control()));
        }
        if plant.support() == Support::Free && !condition.manoeuvre.is_symmetric() {
            return Search::find_aside(plant, condition);
        }
        let in_plane = search.run();
        if search.is_straight() {
            return in_plane.map(|()| search);
        }
        let controls = lateral_controls(plant);
        let Some(problem) = TrimProblem::all_around(plant, &condition, controls) else {
            return match in_plane {
                Ok(()) => Ok(search),
                Err(error) => Err(Box::new(search.without_lateral_controls(*error))),
            };
        };
        let mut all_around = Search::new(plant, condition, problem);
        if search.converged {
            all_around.begin_at(&search);
        }
        match (all_around.run(), in_plane) {
            (Ok(()), _) => Ok(all_around),
            (Err(_), Ok(())) => Ok(search),
            (Err(error), Err(_)) => Err(error),
        }
    }

    /// Searches a flight that leaves the plane of symmetry, from the level one on [theory: trim.manoeuvres].
    fn find_aside(plant: &'a Plant, condition: TrimCondition) -> Result<Self, Box<TrimError>> {
        let level = TrimCondition { manoeuvre: Manoeuvre::LEVEL, ..condition };
        let Some(problem) = TrimProblem::all_around(plant, &condition, lateral_controls(plant)) else {
            let mut search = Search::new(plant, condition, TrimProblem::in_plane(plant, &level));
            search.evaluate();
            let error = search.error(SearchEnd::Steps(0), 0.0);
            return Err(Box::new(TrimError { failure: TrimFailure::NoControlAside, ..error }));
        };
        let of_this =
            |error: Box<TrimError>| Box::new(TrimError { manoeuvre: condition.manoeuvre, ..*error });
        let level = Search::find(plant, level).map_err(of_this)?;
        let mut search = Search::new(plant, condition, problem);
        search.begin_at(&level);
        search.begin_turn();
        search.run().map(|()| search)
    }

    /// Goes to where another search is, in what both may change.
    pub(super) fn begin_at(&mut self, other: &Search) {
        for (unknown, value) in self.problem.unknowns.iter().zip(&mut self.values) {
            let theirs = other.problem.unknowns.iter().zip(&other.values);
            let found = theirs.into_iter().find(|(other, _)| *other == unknown);
            found.into_iter().for_each(|(_, found)| *value = *found);
        }
        let [flight, theirs] = [&self.problem, &other.problem].map(|problem| problem.unknowns.len());
        self.values[flight..].copy_from_slice(&other.values[theirs..]);
    }

    /// Banks and turns as a point mass would.
    fn begin_turn(&mut self) {
        let TrimCondition { airspeed, manoeuvre, .. } = self.condition;
        let bank_angle = match manoeuvre.flight {
            SteadyFlight::Turn { bank_angle } => bank_angle,
            SteadyFlight::TurnAtLoadFactor { load_factor } => {
                let share = libm::cos(manoeuvre.climb_angle) / load_factor.abs();
                libm::copysign(libm::acos(share), load_factor)
            }
            _ => return,
        };
        let turn_rate = self.plant.equations.gravity * libm::tan(bank_angle) / airspeed;
        for (unknown, value) in self.problem.unknowns.iter().zip(&mut self.values) {
            match unknown {
                TrimUnknown::Roll => *value = bank_angle,
                TrimUnknown::TurnRate => *value = turn_rate,
                _ => {}
            }
        }
    }

    /// What was found, or where the search is.
    pub fn point(&self) -> TrimPoint {
        let mut point = self.problem.given;
        for (unknown, &value) in self.problem.unknowns.iter().zip(&self.values) {
            *unknown.of(&mut point) = value;
        }
        if self.problem.unknowns.contains(&TrimUnknown::Thrust) {
            point.thrust *= self.weight_per_engine();
        }
        point
    }

    /// What was found at the last evaluation, for a plant that may have an inflow.
    pub fn trim_of(&self, plant: &Plant) -> Trim {
        let mut state = vec![0.0; plant.layout().len()];
        let steady = self.plant.layout().structure();
        state[plant.layout().structure()].copy_from_slice(&self.state[steady]);
        plant.equations.settle_inflow(&mut state, &self.controls);
        let [_, load_factor] = steady_load_factors(&plant.equations, &state);
        let is_free = plant.support() == Support::Free;
        let point = TrimPoint { load_factor: if is_free { load_factor } else { 0.0 }, ..self.point() };
        Trim { point, controls: self.controls.clone(), state, unknowns: self.values.clone() }
    }

    /// At unknowns of a trim that such a plant has found.
    pub fn resume(plant: &'a Plant, condition: TrimCondition, unknowns: &[f64]) -> Self {
        let in_plane = Search::new(plant, condition, TrimProblem::in_plane(plant, &condition));
        let all_around = || TrimProblem::all_around(plant, &condition, lateral_controls(plant));
        let is_aside = unknowns.len() > in_plane.values.len();
        let problem = if is_aside { all_around() } else { None };
        let mut search = problem.map_or(in_plane, |problem| Search::new(plant, condition, problem));
        search.values.copy_from_slice(unknowns);
        search
    }

    /// Goes elsewhere.
    pub fn set_unknowns(&mut self, unknowns: impl Iterator<Item = f64>) {
        self.values.iter_mut().zip(unknowns).for_each(|(place, unknown)| *place = unknown);
    }

    /// All unknowns at zero.
    pub(super) fn new(plant: &'a Plant, condition: TrimCondition, problem: TrimProblem) -> Self {
        Search {
            condition,
            values: vec![0.0; problem.unknowns.len() + plant.layout().modes()],
            problem,
            converged: false,
            state: vec![0.0; plant.layout().len()],
            controls: plant.neutral_controls(),
            rates: vec![0.0; plant.layout().len()],
            workspace: plant.workspace(),
            plant,
        }
    }

    /// N per engine that runs, or per unit of share.
    fn weight_per_engine(&self) -> f64 {
        let whole = self.running().map(|(_, share)| share).sum::<f64>();
        self.weight() / if whole > 0.0 { whole } else { 1.0 }
    }

    /// The engines that run, and their shares of the thrust [theory: trim.shares].
    pub(super) fn running(&self) -> impl Iterator<Item = (usize, f64)> {
        let failed = self.condition.manoeuvre.failed_engine;
        let shares = self.plant.equations.trim_shares().iter().copied().enumerate();
        shares.filter(move |(engine, _)| failed != Some(*engine))
    }

    fn weight(&self) -> f64 {
        self.plant.equations.integrals().mass * STANDARD_GRAVITY
    }

    /// Writes the unknowns into state and controls, and evaluates the equations there.
    pub(super) fn evaluate(&mut self) {
        let point = self.point();
        for (angle, trimmed) in self.controls.angles.iter_mut().zip(point.angles(self.plant.controls())) {
            *angle = trimmed;
        }
        let TrimCondition { airspeed, altitude, heading, manoeuvre } = self.condition;
        self.controls.thrust.fill(0.0);
        for (engine, &share) in self.plant.equations.trim_shares().iter().enumerate() {
            if manoeuvre.failed_engine != Some(engine) {
                self.controls.thrust[engine] = share * point.thrust;
            }
        }
        let layout = *self.plant.layout();
        self.state[layout.position().end - 1] = 0.0 - altitude;
        if self.plant.support() == Support::Free {
            self.state[layout.velocity()].copy_from_slice(&point.velocity(airspeed));
            self.state[layout.rate()].copy_from_slice(point.rate().as_slice());
        }
        let angles = Vector3::new(point.roll, point.pitch, heading + self.plant.equations.mount.z);
        self.state[layout.attitude()].copy_from_slice(&quaternion_of_euler_angles(&angles));
        self.state[layout.coordinates()].copy_from_slice(&self.values[self.problem.unknowns.len()..]);
        self.plant.rates(&self.state, &self.controls, &mut self.rates, &mut self.workspace);
    }

    /// The generalised forces that must vanish: those that the flight's unknowns balance, and on each q.
    ///
    /// [theory: trim.residual]
    pub fn residual(&mut self, out: &mut [f64]) {
        self.evaluate();
        let (forces, weight) = (self.workspace.forces(), self.weight());
        let accelerations = self.workspace.accelerations();
        let acceleration = GeneralisedVector::of(accelerations).translation;
        let velocity = self.plant.equations.motion(&self.state).velocity;
        let [aside, across] = steady_load_factors(&self.plant.equations, &self.state);
        let (flight, elastic) = out.split_at_mut(self.problem.balances.len());
        for (out, balance) in flight.iter_mut().zip(&self.problem.balances) {
            *out = match *balance {
                Balance::Row(row) => forces[row],
                Balance::Acceleration(row) => accelerations[row],
                Balance::AcrossPath => acceleration.z * velocity.x - acceleration.x * velocity.z,
                Balance::AsideOfPath => {
                    acceleration.y * velocity.norm_squared() - velocity.y * acceleration.dot(&velocity)
                }
                Balance::Coordination => weight * aside,
                Balance::LoadFactor(asked) => weight * (across - asked),
            };
        }
        let elastic_rows = if self.problem.is_held { accelerations } else { forces };
        elastic.copy_from_slice(GeneralisedVector::of(elastic_rows).modal);
    }

    /// What was found, or where the search is, in its own units and order.
    pub fn unknowns(&self) -> &[f64] {
        &self.values
    }

    /// Searches from the present unknowns on.
    ///
    /// # Errors
    /// When nothing is in balance where the search ends.
    pub fn run(&mut self) -> Result<(), Box<TrimError>> {
        let end = self.iterate();
        self.converged = matches!(end, SearchEnd::Steps(_));
        self.check_balance(end)
    }

    /// Iterates until the steps stop shrinking [theory: trim.newton].
    pub(super) fn iterate(&mut self) -> SearchEnd {
        let n = self.values.len();
        let (mut jacobian, mut step) = (vec![0.0; n * n], vec![0.0; n]);
        let mut previous = f64::INFINITY;
        for count in 0..MAX_STEPS {
            self.jacobian(&mut jacobian);
            self.residual(&mut step);
            if !solve(&jacobian, &mut step) {
                return SearchEnd::Singular(count);
            }
            let angles = self
                .problem
                .unknowns
                .iter()
                .zip(&step)
                .filter(|(unknown, _)| **unknown != TrimUnknown::Thrust);
            let largest_turn = largest(angles.map(|(_, &turn)| turn));
            let damping = (LARGEST_TURN / largest_turn).min(1.0);
            for (value, step) in self.values.iter_mut().zip(&step) {
                *value -= damping * step;
            }
            let size = relative_size(&step, &self.values);
            if size <= SMALLEST_STEP || (size < 1e-10 && size >= previous) {
                return SearchEnd::Steps(count + 1);
            }
            previous = size;
        }
        SearchEnd::TooMany(MAX_STEPS)
    }

    /// Derivatives of the residual by central differences, row-major.
    pub fn jacobian(&mut self, jacobian: &mut [f64]) {
        let n = self.values.len();
        let (mut ahead, mut behind) = (vec![0.0; n], vec![0.0; n]);
        for column in 0..n {
            let value = self.values[column];
            let step = 1e-5 * value.abs().max(0.1);
            self.values[column] = value + step;
            self.residual(&mut ahead);
            self.values[column] = value - step;
            self.residual(&mut behind);
            self.values[column] = value;
            for row in 0..n {
                jacobian[row * n + column] = central([behind[row], ahead[row]], step);
            }
        }
    }

    /// v̇ and ω̇ of the last evaluation.
    pub(super) fn rigid(&self) -> [f64; 6] {
        GeneralisedVector::rigid_part(self.workspace.accelerations())
    }

    /// Whether nothing at the last evaluation moves a free aircraft aside, or nothing can.
    fn is_straight(&self) -> bool {
        self.plant.support() == Support::Clamped
            || ASIDE.iter().all(|&row| self.rigid()[row].abs() < STRAIGHT)
    }

    /// Accepts the present unknowns only when nothing accelerates, laterally too [theory: trim.balance].
    fn check_balance(&mut self, end: SearchEnd) -> Result<(), Box<TrimError>> {
        self.evaluate();
        let modal = largest(GeneralisedVector::of(self.workspace.accelerations()).modal.iter().copied());
        let elastic = largest(self.workspace.elastic_force.iter().copied()).max(1.0);
        let in_balance = self.is_valid() && largest(self.rigid()) < BALANCED && modal < BALANCED * elastic;
        if in_balance { Ok(()) } else { Err(Box::new(self.error(end, modal))) }
    }

    /// Whether the last evaluation is a flight, with the load factors that are asked for; whatever accelerates.
    pub(super) fn is_valid(&self) -> bool {
        let [aside, across] = steady_load_factors(&self.plant.equations, &self.state);
        let meets = |balance: &Balance| match *balance {
            Balance::Row(_) | Balance::Acceleration(_) | Balance::AcrossPath | Balance::AsideOfPath => true,
            Balance::Coordination => aside.abs() < BALANCED,
            Balance::LoadFactor(asked) => (across - asked).abs() < BALANCED,
        };
        self.workspace.accelerations().iter().all(|a| a.is_finite())
            && self.problem.balances.iter().all(meets)
            && self.plant.reversed_strip(&self.state, &self.controls, &self.workspace).is_none()
    }
}

/// Whether there are controls for roll and for yaw that move anything.
fn lateral_controls(plant: &Plant) -> [bool; 2] {
    [TrimRole::Roll, TrimRole::Yaw].map(|role| moves_anything(plant, role))
}

/// Whether there is a control with a role that moves anything.
fn moves_anything(plant: &Plant, role: TrimRole) -> bool {
    let has_role = plant.controls().iter().map(|control| control.role == Some(role));
    let angles: Vec<f64> = has_role.map(|has_role| if has_role { 1.0 } else { 0.0 }).collect();
    plant.equations.flap_factors().iter().any(|factor| factor.value(&angles) != 0.0)
}

/// Largest step relative to its unknown.
fn relative_size(steps: &[f64], unknowns: &[f64]) -> f64 {
    steps
        .iter()
        .zip(unknowns)
        .fold(0.0, |size, (step, unknown)| size.max(step.abs() / unknown.abs().max(1.0)))
}
