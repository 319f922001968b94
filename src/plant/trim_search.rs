//! Newton's method for the trim [theory: trim.residual, trim.newton, trim.balance].

use nalgebra::Vector3;

use crate::air::STANDARD_GRAVITY;
use crate::aircraft::{Support, TrimRole};
use crate::equations::{Controls, Workspace};
use crate::kinematics::{ASIDE, GeneralisedVector, IN_PLANE};
use crate::math::{Attitude, central, largest, quaternion_of_euler_angles, solve};

use super::system::Plant;
use super::trim::{Trim, TrimCondition, TrimPoint};
use super::trim_error::{TrimError, TrimFailure};

/// Newton steps before giving up.
const MAX_STEPS: usize = 60;

/// Newton steps smaller than this (rad, weights, metres of mode) no longer improve the trim.
const SMALLEST_STEP: f64 = 1e-15;

/// Largest change of an angle in one Newton step, rad.
const LARGEST_TURN: f64 = 0.2;

/// Accelerations below this are in balance: m/s², rad/s², and modal accelerations relative to the largest
/// elastic one.
const BALANCED: f64 = 1e-7;

/// An aircraft that goes aside or turns by less than this, m/s² or rad/s², is symmetric up to rounding.
const STRAIGHT: f64 = 1e-10;

/// Wings that do not carry the weight at this angle of attack are too slow, rad.
const STEEP: f64 = 15.0 * std::f64::consts::PI / 180.0;

/// What the search may change of a [`TrimPoint`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum TrimUnknown {
    Pitch,
    /// The angle of the control with this role.
    Control(TrimRole),
    /// In parts of the weight.
    Thrust,
    ClimbAngle,
    Roll,
    Sideslip,
}

/// How Newton's method ended.
#[derive(Clone, Copy, Debug, PartialEq)]
enum SearchEnd {
    /// The steps stopped shrinking.
    Steps(usize),
    /// They did not in so many.
    TooMany(usize),
    /// The Jacobian became singular.
    Singular(usize),
}

/// A search, then what it has found.
pub(crate) struct Search<'a> {
    plant: &'a Plant,
    condition: TrimCondition,
    /// The unknowns before q.
    flight: Vec<TrimUnknown>,
    /// The rows of ν that they balance.
    rows: Vec<usize>,
    values: Vec<f64>,
    /// Whether the last steps led to where the rows vanish.
    converged: bool,
    state: Vec<f64>,
    controls: Controls,
    rates: Vec<f64>,
    workspace: Workspace,
}

impl<'a> Search<'a> {
    /// Searches in the plane of symmetry first; where the aircraft leaves it, all around.
    pub fn find(plant: &'a Plant, condition: TrimCondition) -> Result<Self, Box<TrimError>> {
        let mut search = Search::new(plant, condition);
        if plant.support() == Support::Free && !moves_anything(plant, TrimRole::Pitch) {
            return Err(Box::new(search.without_pitch_control()));
        }
        let in_plane = search.run();
        if search.is_straight() {
            return in_plane.map(|()| search);
        }
        let controls = lateral_controls(plant);
        if controls == [false; 2] {
            return match in_plane {
                Ok(()) => Ok(search),
                Err(error) => Err(Box::new(search.without_lateral_controls(*error))),
            };
        }
        let mut all_around = Search::new(plant, condition);
        if search.converged {
            all_around.values.clone_from(&search.values);
        }
        all_around.add_lateral(controls);
        match (all_around.run(), in_plane) {
            (Ok(()), _) => Ok(all_around),
            (Err(_), Ok(())) => Ok(search),
            (Err(error), Err(_)) => Err(error),
        }
    }

    /// What was found, or where the search is.
    pub fn point(&self) -> TrimPoint {
        // Of a clamped aircraft the mount's; of a free one there is none.
        let mount = &self.plant.equations.mount;
        let mut point = TrimPoint { roll: mount.x, pitch: mount.y, ..TrimPoint::default() };
        for (unknown, &value) in self.flight.iter().zip(&self.values) {
            match unknown {
                TrimUnknown::Pitch => point.pitch = value,
                TrimUnknown::Control(TrimRole::Pitch) => point.pitch_control = value,
                TrimUnknown::Control(TrimRole::Roll) => point.roll_control = value,
                TrimUnknown::Control(TrimRole::Yaw) => point.yaw_control = value,
                TrimUnknown::Thrust => point.thrust = value * self.weight_per_engine(),
                TrimUnknown::ClimbAngle => point.climb_angle = value,
                TrimUnknown::Roll => point.roll = value,
                TrimUnknown::Sideslip => point.sideslip = value,
            }
        }
        point
    }

    /// What was found at the last evaluation, for a plant that may have an inflow.
    pub fn trim_of(&self, plant: &Plant) -> Trim {
        let mut state = vec![0.0; plant.layout().len()];
        let steady = self.plant.layout().structure();
        state[plant.layout().structure()].copy_from_slice(&self.state[steady]);
        plant.equations.settle_inflow(&mut state, &self.controls);
        Trim { point: self.point(), controls: self.controls.clone(), state, unknowns: self.values.clone() }
    }

    /// At unknowns of a trim that such a plant has found.
    pub fn resume(plant: &'a Plant, condition: TrimCondition, unknowns: &[f64]) -> Self {
        let mut search = Search::new(plant, condition);
        if unknowns.len() > search.values.len() {
            search.add_lateral(lateral_controls(plant));
        }
        search.values.copy_from_slice(unknowns);
        search
    }

    /// Goes elsewhere.
    pub fn set_unknowns(&mut self, unknowns: impl Iterator<Item = f64>) {
        self.values.iter_mut().zip(unknowns).for_each(|(place, unknown)| *place = unknown);
    }

    /// In the plane of symmetry, all unknowns at zero.
    fn new(plant: &'a Plant, condition: TrimCondition) -> Self {
        let along = |along| vec![TrimUnknown::Pitch, TrimUnknown::Control(TrimRole::Pitch), along];
        let flight = match (plant.support(), plant.engine_count()) {
            (Support::Free, 0) => along(TrimUnknown::ClimbAngle),
            (Support::Free, _) => along(TrimUnknown::Thrust),
            (Support::Clamped, _) => Vec::new(),
        };
        Search {
            condition,
            rows: IN_PLANE[..flight.len()].to_vec(),
            values: vec![0.0; flight.len() + plant.layout().modes()],
            flight,
            converged: false,
            state: vec![0.0; plant.layout().len()],
            controls: plant.neutral_controls(),
            rates: vec![0.0; plant.layout().len()],
            workspace: plant.workspace(),
            plant,
        }
    }

    /// Takes bank angle and the controls for roll and yaw that there are as unknowns too; sideslip for one that is not.
    ///
    /// [theory: trim.lateral]
    fn add_lateral(&mut self, [roll, yaw]: [bool; 2]) {
        let place = self.flight.len();
        let control = |there, role| if there { TrimUnknown::Control(role) } else { TrimUnknown::Sideslip };
        self.flight.extend([TrimUnknown::Roll, control(roll, TrimRole::Roll), control(yaw, TrimRole::Yaw)]);
        self.rows.extend(ASIDE);
        self.values.splice(place..place, [0.0; 3]);
    }

    fn weight_per_engine(&self) -> f64 {
        let weight = self.plant.equations.integrals().mass * STANDARD_GRAVITY;
        weight / self.plant.engine_count().max(1) as f64
    }

    /// Writes the unknowns into state and controls, and evaluates the equations there.
    fn evaluate(&mut self) {
        let point = self.point();
        for (angle, trimmed) in self.controls.angles.iter_mut().zip(point.angles(self.plant.controls())) {
            *angle = trimmed;
        }
        self.controls.thrust.fill(point.thrust);
        let layout = *self.plant.layout();
        let TrimCondition { airspeed, altitude, heading } = self.condition;
        self.state[layout.position().end - 1] = 0.0 - altitude;
        if self.plant.support() == Support::Free {
            self.state[layout.velocity()].copy_from_slice(&point.velocity(airspeed));
        }
        let angles = Vector3::new(point.roll, point.pitch, heading + self.plant.equations.mount.z);
        self.state[layout.attitude()].copy_from_slice(&quaternion_of_euler_angles(&angles));
        self.state[layout.coordinates()].copy_from_slice(&self.values[self.flight.len()..]);
        self.plant.rates(&self.state, &self.controls, &mut self.rates, &mut self.workspace);
    }

    /// The generalised forces that must vanish: those that the flight's unknowns balance, and on each q.
    ///
    /// [theory: trim.residual]
    pub fn residual(&mut self, out: &mut [f64]) {
        self.evaluate();
        let forces = self.workspace.forces();
        let (flight, elastic) = out.split_at_mut(self.rows.len());
        for (out, &row) in flight.iter_mut().zip(&self.rows) {
            *out = forces[row];
        }
        elastic.copy_from_slice(GeneralisedVector::of(forces).modal);
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
    fn iterate(&mut self) -> SearchEnd {
        let n = self.values.len();
        let (mut jacobian, mut step) = (vec![0.0; n * n], vec![0.0; n]);
        let mut previous = f64::INFINITY;
        for count in 0..MAX_STEPS {
            self.jacobian(&mut jacobian);
            self.residual(&mut step);
            if !solve(&jacobian, &mut step) {
                return SearchEnd::Singular(count);
            }
            let angles =
                self.flight.iter().zip(&step).filter(|(unknown, _)| **unknown != TrimUnknown::Thrust);
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
    fn rigid(&self) -> [f64; 6] {
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
        let reversed = self.plant.reversed_strip(&self.state, &self.controls, &self.workspace);
        let in_balance = self.workspace.accelerations().iter().all(|a| a.is_finite())
            && largest(self.rigid()) < BALANCED
            && modal < BALANCED * elastic
            && reversed.is_none();
        if in_balance { Ok(()) } else { Err(Box::new(self.error(end, modal))) }
    }

    /// Why the search ended out of balance, and where.
    fn error(&self, end: SearchEnd, modal: f64) -> TrimError {
        let TrimCondition { airspeed, altitude, .. } = self.condition;
        let (SearchEnd::Steps(steps) | SearchEnd::TooMany(steps) | SearchEnd::Singular(steps)) = end;
        let failure = match (self.plant.support(), end) {
            (Support::Clamped, _) => TrimFailure::NoRest,
            (Support::Free, end) => match (self.share_carried(), end) {
                (Some(share), _) if share < 1.0 => TrimFailure::TooSlow { share },
                (_, SearchEnd::Singular(_)) => TrimFailure::NoAuthority,
                (_, SearchEnd::Steps(_) | SearchEnd::TooMany(_)) => TrimFailure::NotFound,
            },
        };
        TrimError {
            failure,
            airspeed,
            altitude,
            density: self.plant.air(&self.state).density,
            steps,
            point: self.point(),
            support: self.plant.support(),
            controls: self.plant.controls().to_vec(),
            has_engines: self.plant.engine_count() > 0,
            rigid: self.rigid(),
            modal,
        }
    }

    /// What nothing holds in pitch.
    fn without_pitch_control(&mut self) -> TrimError {
        self.evaluate();
        TrimError { failure: TrimFailure::NoPitchControl, ..self.error(SearchEnd::Steps(0), 0.0) }
    }

    /// What an aircraft whose plane of symmetry is in balance lacks, if it has no control for roll or yaw.
    fn without_lateral_controls(&self, error: TrimError) -> TrimError {
        let goes_aside = ASIDE.iter().any(|&row| self.rigid()[row].abs() >= BALANCED);
        if !self.converged || !goes_aside {
            return error;
        }
        let forces = self.workspace.forces();
        let [side_force, rolling, yawing] = ASIDE.map(|row| forces[row]);
        TrimError { failure: TrimFailure::NoLateralControl { side_force, rolling, yawing }, ..error }
    }

    /// Which share of the weight level, undeformed wings carry at 15° of incidence, without thrust and controls; none
    /// without wings or weight.
    fn share_carried(&self) -> Option<f64> {
        let mut level = Search::new(self.plant, self.condition);
        *level.values.first_mut()? = STEEP;
        level.evaluate();
        let layout = self.plant.layout();
        let attitude = Attitude::from_quaternion(&level.state[layout.attitude()]);
        let force = GeneralisedVector::of(level.workspace.forces()).translation;
        let downwards = attitude.body_from_inertial.tr_mul(&force).z;
        let weight = self.plant.equations.integrals().mass * self.plant.equations.gravity;
        let share = 1.0 - downwards / weight;
        (share.is_finite() && share > 1e-9).then_some(share)
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
