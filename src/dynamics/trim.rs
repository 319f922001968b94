//! Trim: steady level flight, or the static deformation in a wind tunnel [5.1; physics.md §6].

use nalgebra::Vector3;

use crate::aerodynamics::STANDARD_GRAVITY;
use crate::aircraft::Support;

use super::attitude::quaternion_of_euler_angles;
use super::controls::Controls;
use super::equations::EquationsOfMotion;
use super::linear_solve::solve;
use super::workspace::Workspace;

/// Newton steps before giving up.
const MAX_STEPS: usize = 60;

/// Newton steps smaller than this (rad, weights, metres of mode) no longer improve the trim.
const SMALLEST_STEP: f64 = 1e-15;

/// Largest change of pitch and elevator in one Newton step, rad.
const LARGEST_TURN: f64 = 0.2;

/// Accelerations below this are in balance: m/s², rad/s², and modal accelerations relative to the largest
/// elastic one.
const BALANCED: f64 = 1e-7;

/// The flight condition to be trimmed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrimCondition {
    /// m/s; in a wind tunnel the equations' tunnel flow replaces it.
    pub airspeed: f64,
    /// m.
    pub altitude: f64,
    /// Yaw angle, rad.
    pub heading: f64,
}

/// A trimmed flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Trim {
    /// θ, rad.
    pub pitch: f64,
    /// rad.
    pub elevator: f64,
    /// N per engine.
    pub thrust: f64,
    /// The complete state, wake at rest.
    pub state: Vec<f64>,
    /// What the search changed, in its own units and order.
    pub unknowns: Vec<f64>,
}

impl Trim {
    /// The controls of the trimmed flight, in still air.
    pub fn controls(&self, engines: usize) -> Controls {
        let mut controls = Controls::neutral(engines);
        controls.elevator = self.elevator;
        controls.thrust.fill(self.thrust);
        controls
    }
}

/// Why there is no trim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TrimFailure {
    /// Newton's method ended elsewhere.
    #[error("no steady level flight found")]
    NotFound,
    /// The unknowns do not move the forces independently.
    #[error(
        "no steady level flight: pitch, elevator and thrust do not act independently (is there a wing, an elevator, an engine?)"
    )]
    NoAuthority,
    /// The plane of symmetry is in balance, the rest is not.
    #[error(
        "no steady level flight: pitch, elevator and equal thrust balance the aircraft in its plane of symmetry, but not sideways"
    )]
    Sideways,
    /// A clamped aircraft finds no shape at rest.
    #[error("no deformation at rest found in the wind tunnel")]
    NoRest,
}

/// A trim that was not found, and where the search ended.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "{failure} at {airspeed} m/s and {altitude} m: {steps} Newton steps ended at pitch {pitch:.4} rad, \
     elevator {elevator:.4} rad, thrust {thrust:.0} N per engine with the imbalance v̇ = ({:.2e}, {:.2e}, {:.2e}) m/s², \
     ω̇ = ({:.2e}, {:.2e}, {:.2e}) rad/s², largest modal acceleration {modal:.2e}",
    rigid[0], rigid[1], rigid[2], rigid[3], rigid[4], rigid[5]
)]
pub struct TrimError {
    /// Why.
    pub failure: TrimFailure,
    /// m/s.
    pub airspeed: f64,
    /// m.
    pub altitude: f64,
    /// Newton steps taken.
    pub steps: usize,
    /// Where they ended, rad.
    pub pitch: f64,
    /// rad.
    pub elevator: f64,
    /// N per engine.
    pub thrust: f64,
    /// v̇ and ω̇ that remained.
    pub rigid: [f64; 6],
    /// Largest |q̈| that remained.
    pub modal: f64,
}

/// How Newton's method ended.
#[derive(Clone, Copy, Debug, PartialEq)]
enum SearchEnd {
    /// The steps stopped shrinking, or there were too many.
    Steps(usize),
    /// The Jacobian became singular.
    Singular(usize),
}

impl EquationsOfMotion {
    /// Finds pitch, elevator, thrust (equal on all engines) and q at which all accelerations vanish. A
    /// clamped aircraft keeps its attitude; only q is found.
    ///
    /// # Errors
    /// When Newton's method finds no such state.
    pub fn trim(&self, condition: &TrimCondition) -> Result<Trim, TrimError> {
        let mut search = Search::new(self.with_steady_inflow(), *condition);
        let end = search.run();
        search.check_balance(end)?;
        Ok(search.trim_of(self))
    }
}

/// Newton's method on the unknowns [pitch, elevator, thrust / weight, q] in free flight, q in a tunnel.
pub(super) struct Search {
    equations: EquationsOfMotion,
    condition: TrimCondition,
    unknowns: Vec<f64>,
    state: Vec<f64>,
    controls: Controls,
    rates: Vec<f64>,
    workspace: Workspace,
}

impl Search {
    fn new(equations: EquationsOfMotion, condition: TrimCondition) -> Self {
        let modes = equations.layout().modes();
        let unknowns = match equations.support() {
            Support::Free => vec![0.0; 3 + modes],
            Support::Clamped => vec![0.0; modes],
        };
        Search {
            condition,
            unknowns,
            state: vec![0.0; equations.layout().len()],
            controls: Controls::neutral(equations.engine_count()),
            rates: vec![0.0; equations.layout().len()],
            workspace: Workspace::new(&equations),
            equations,
        }
    }

    /// At unknowns of a trim.
    pub fn resume(equations: EquationsOfMotion, condition: TrimCondition, unknowns: &[f64]) -> Self {
        let mut search = Search::new(equations, condition);
        search.unknowns.copy_from_slice(unknowns);
        search
    }

    /// Goes elsewhere.
    pub fn set_unknowns(&mut self, unknowns: impl Iterator<Item = f64>) {
        self.unknowns.iter_mut().zip(unknowns).for_each(|(place, unknown)| *place = unknown);
    }

    /// What was found at the last evaluation, for equations that may have an inflow.
    pub fn trim_of(&self, equations: &EquationsOfMotion) -> Trim {
        let mut state = vec![0.0; equations.layout().len()];
        let steady = self.equations.layout().structure();
        state[equations.layout().structure()].copy_from_slice(&self.state[steady]);
        equations.settle_inflow(&mut state, &self.controls);
        let [pitch, elevator, thrust] = self.flight();
        Trim { pitch, elevator, thrust, state, unknowns: self.unknowns.clone() }
    }

    /// Number of unknowns before q.
    fn flight_unknowns(&self) -> usize {
        self.unknowns.len() - self.equations.layout().modes()
    }

    /// Pitch, elevator, thrust per engine.
    fn flight(&self) -> [f64; 3] {
        match self.unknowns[..self.flight_unknowns()] {
            [pitch, elevator, thrust] => [pitch, elevator, thrust * self.weight_per_engine()],
            _ => [0.0; 3],
        }
    }

    fn weight_per_engine(&self) -> f64 {
        let weight = self.equations.integrals().mass * STANDARD_GRAVITY;
        weight / self.equations.engine_count().max(1) as f64
    }

    /// Writes the unknowns into state and controls, and evaluates the equations there.
    fn evaluate(&mut self) {
        let [pitch, elevator, thrust] = self.flight();
        self.controls.elevator = elevator;
        self.controls.thrust.fill(thrust);
        let layout = *self.equations.layout();
        let TrimCondition { airspeed, altitude, heading } = self.condition;
        self.state[layout.position().end - 1] = -altitude;
        let angles = Vector3::new(0.0, pitch, heading);
        self.state[layout.attitude()].copy_from_slice(&quaternion_of_euler_angles(&angles));
        if self.equations.support() == Support::Free {
            let (sin, cos) = libm::sincos(pitch);
            self.state[layout.velocity()].copy_from_slice(&[airspeed * cos, 0.0, airspeed * sin]);
        }
        let q = &self.unknowns[self.flight_unknowns()..];
        self.state[layout.coordinates()].copy_from_slice(q);
        self.equations.rates(&self.state, &self.controls, &mut self.rates, &mut self.workspace);
    }

    /// The generalised forces that must vanish: along x and z, about y, and on each q.
    pub fn residual(&mut self, out: &mut [f64]) {
        self.evaluate();
        let flight = self.flight_unknowns();
        let forces = self.workspace.forces();
        for (out, row) in out[..flight].iter_mut().zip([0, 2, 4]) {
            *out = forces[row];
        }
        out[flight..].copy_from_slice(&forces[6..]);
    }

    /// Iterates until the steps stop shrinking.
    fn run(&mut self) -> SearchEnd {
        let n = self.unknowns.len();
        let (mut jacobian, mut step) = (vec![0.0; n * n], vec![0.0; n]);
        let mut previous = f64::INFINITY;
        for count in 0..MAX_STEPS {
            self.jacobian(&mut jacobian);
            self.residual(&mut step);
            if !solve(&jacobian, &mut step) {
                return SearchEnd::Singular(count);
            }
            let turns = &step[..self.flight_unknowns().min(2)];
            let largest_turn = turns.iter().fold(0.0_f64, |largest, turn| largest.max(turn.abs()));
            let damping = (LARGEST_TURN / largest_turn).min(1.0);
            for (unknown, step) in self.unknowns.iter_mut().zip(&step) {
                *unknown -= damping * step;
            }
            let size = relative_size(&step, &self.unknowns);
            if size <= SMALLEST_STEP || (size < 1e-10 && size >= previous) {
                return SearchEnd::Steps(count + 1);
            }
            previous = size;
        }
        SearchEnd::Steps(MAX_STEPS)
    }

    /// Derivatives of the residual by central differences, row-major.
    pub fn jacobian(&mut self, jacobian: &mut [f64]) {
        let n = self.unknowns.len();
        let (mut ahead, mut behind) = (vec![0.0; n], vec![0.0; n]);
        for column in 0..n {
            let value = self.unknowns[column];
            let step = 1e-5 * value.abs().max(0.1);
            self.unknowns[column] = value + step;
            self.residual(&mut ahead);
            self.unknowns[column] = value - step;
            self.residual(&mut behind);
            self.unknowns[column] = value;
            for row in 0..n {
                jacobian[row * n + column] = (ahead[row] - behind[row]) / (2.0 * step);
            }
        }
    }

    /// Accepts the present unknowns only when nothing accelerates, laterally too.
    fn check_balance(&mut self, end: SearchEnd) -> Result<(), TrimError> {
        self.evaluate();
        let accelerations = self.workspace.accelerations();
        let rigid: [f64; 6] = std::array::from_fn(|i| accelerations[i]);
        let largest = |values: &[f64]| values.iter().fold(0.0_f64, |max, value| max.max(value.abs()));
        let modal = largest(&accelerations[6..]);
        let elastic = largest(&self.workspace.elastic_force).max(1.0);
        let in_balance = accelerations.iter().all(|a| a.is_finite())
            && largest(&rigid) < BALANCED
            && modal < BALANCED * elastic
            && self.workspace.reversed_strip().is_none();
        if in_balance {
            return Ok(());
        }
        let in_plane = largest(&[rigid[0], rigid[2], rigid[4]]);
        let (failure, steps) = match (self.equations.support(), end) {
            (Support::Clamped, SearchEnd::Steps(steps) | SearchEnd::Singular(steps)) => {
                (TrimFailure::NoRest, steps)
            }
            (Support::Free, SearchEnd::Singular(steps)) => (TrimFailure::NoAuthority, steps),
            (Support::Free, SearchEnd::Steps(steps)) if in_plane < BALANCED => (TrimFailure::Sideways, steps),
            (Support::Free, SearchEnd::Steps(steps)) => (TrimFailure::NotFound, steps),
        };
        let [pitch, elevator, thrust] = self.flight();
        let TrimCondition { airspeed, altitude, .. } = self.condition;
        Err(TrimError { failure, airspeed, altitude, steps, pitch, elevator, thrust, rigid, modal })
    }
}

/// Largest step relative to its unknown.
fn relative_size(steps: &[f64], unknowns: &[f64]) -> f64 {
    steps
        .iter()
        .zip(unknowns)
        .fold(0.0, |size, (step, unknown)| size.max(step.abs() / unknown.abs().max(1.0)))
}
