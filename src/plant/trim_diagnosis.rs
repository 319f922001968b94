//! Why a search for a trim ended where nothing is in balance [theory: trim.balance].

use crate::aircraft::Support;
use crate::kinematics::{ASIDE, GeneralisedVector};
use crate::math::Attitude;

use super::manoeuvre::Manoeuvre;
use super::trim::TrimCondition;
use super::trim_error::{TrimError, TrimFailure};
use super::trim_problem::TrimProblem;
use super::trim_search::{BALANCED, Search, SearchEnd};

/// Wings that do not carry the weight at this angle of attack are too slow, rad.
const STEEP: f64 = 15.0 * std::f64::consts::PI / 180.0;

impl Search<'_> {
    /// Why the search ended out of balance, and where.
    pub(super) fn error(&self, end: SearchEnd, modal: f64) -> TrimError {
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
            manoeuvre: self.condition.manoeuvre,
            modal,
        }
    }

    /// What nothing holds in pitch.
    pub(super) fn without_pitch_control(&mut self) -> TrimError {
        self.evaluate();
        TrimError { failure: TrimFailure::NoPitchControl, ..self.error(SearchEnd::Steps(0), 0.0) }
    }

    /// What an aircraft whose plane of symmetry is in balance lacks, if it has no control for roll or yaw.
    pub(super) fn without_lateral_controls(&self, error: TrimError) -> TrimError {
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
        let condition = TrimCondition { manoeuvre: Manoeuvre::LEVEL, ..self.condition };
        let mut level = Search::new(self.plant, condition, TrimProblem::in_plane(self.plant, &condition));
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
