//! What a trim's search may change, and what it brings into balance [theory: trim.unknowns, trim.lateral, trim.manoeuvres].

use nalgebra::Vector3;

use crate::aircraft::{Support, TrimRole};
use crate::equations::EquationsOfMotion;
use crate::kinematics::{ASIDE, IN_PLANE};
use crate::math::Attitude;

use super::manoeuvre::SteadyFlight;
use super::outputs::load_factor;
use super::system::Plant;
use super::trim::{TrimCondition, TrimPoint};

/// What the search may change of a [`TrimPoint`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TrimUnknown {
    Pitch,
    /// The angle of the control with this role.
    Control(TrimRole),
    /// In parts of the weight.
    Thrust,
    ClimbAngle,
    Roll,
    Sideslip,
    /// rad/s.
    TurnRate,
    /// rad/s.
    PitchRate,
}

/// What must vanish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Balance {
    /// The generalised force in this row of ν.
    Row(usize),
    /// The acceleration in this row of ν.
    Acceleration(usize),
    /// The acceleration across the path in the aircraft's plane of symmetry.
    AcrossPath,
    /// The acceleration across the path and that.
    AsideOfPath,
    /// The load factor along the wings.
    Coordination,
    /// What the load factor across the flow differs from this by.
    LoadFactor(f64),
}

/// Unknowns of the flight and as many balances; those of q come beside them.
#[derive(Clone, Debug)]
pub(super) struct TrimProblem {
    pub unknowns: Vec<TrimUnknown>,
    pub balances: Vec<Balance>,
    /// What is given.
    pub given: TrimPoint,
    /// Whether something is held where it does not balance: accelerations vanish then, and not forces.
    pub is_held: bool,
}

impl TrimUnknown {
    /// Its place in a point, but for thrust, which has another unit.
    pub fn of(self, point: &mut TrimPoint) -> &mut f64 {
        match self {
            TrimUnknown::Pitch => &mut point.pitch,
            TrimUnknown::Control(TrimRole::Pitch) => &mut point.pitch_control,
            TrimUnknown::Control(TrimRole::Roll) => &mut point.roll_control,
            TrimUnknown::Control(TrimRole::Yaw) => &mut point.yaw_control,
            TrimUnknown::Thrust => &mut point.thrust,
            TrimUnknown::ClimbAngle => &mut point.climb_angle,
            TrimUnknown::Roll => &mut point.roll,
            TrimUnknown::Sideslip => &mut point.sideslip,
            TrimUnknown::TurnRate => &mut point.turn_rate,
            TrimUnknown::PitchRate => &mut point.pitch_rate,
        }
    }
}

impl TrimProblem {
    /// In the plane of symmetry: all there is of a symmetric flight, the beginning of any other.
    pub fn in_plane(plant: &Plant, condition: &TrimCondition) -> Self {
        // Of a clamped aircraft the mount's; of a free one there is none.
        let mount = &plant.equations.mount;
        let manoeuvre = &condition.manoeuvre;
        let given = TrimPoint {
            roll: mount.x,
            pitch: mount.y,
            climb_angle: manoeuvre.climb_angle,
            ..TrimPoint::default()
        };
        let along = match (plant.support(), plant.engine_count()) {
            (Support::Clamped, _) => {
                return TrimProblem { unknowns: Vec::new(), balances: Vec::new(), given, is_held: false };
            }
            (Support::Free, 0) => TrimUnknown::ClimbAngle,
            (Support::Free, _) => TrimUnknown::Thrust,
        };
        let mut problem = TrimProblem {
            unknowns: vec![TrimUnknown::Pitch, TrimUnknown::Control(TrimRole::Pitch), along],
            balances: IN_PLANE.map(Balance::Row).to_vec(),
            given,
            is_held: false,
        };
        if let SteadyFlight::PullUp { load_factor } = manoeuvre.flight {
            problem.unknowns.push(TrimUnknown::PitchRate);
            problem.balances.push(Balance::LoadFactor(load_factor));
        }
        problem
    }

    /// Out of the plane, of an aircraft with controls for roll and yaw, or without; none where what is given leaves too little
    /// to hold it.
    pub fn all_around(plant: &Plant, condition: &TrimCondition, controls: [bool; 2]) -> Option<Self> {
        let mut problem = TrimProblem::in_plane(plant, condition);
        let TrimProblem { unknowns, balances, given, .. } = &mut problem;
        balances.extend(ASIDE.map(Balance::Row));
        let has_both = controls == [true; 2];
        // What stands in for a control that is not there.
        let mut stand_in = None;
        match condition.manoeuvre.flight {
            SteadyFlight::Straight { sideslip } => {
                given.sideslip = sideslip;
                stand_in = (sideslip == 0.0).then_some(TrimUnknown::Sideslip);
                unknowns.push(TrimUnknown::Roll);
            }
            SteadyFlight::PullUp { .. } => {
                stand_in = Some(TrimUnknown::Sideslip);
                unknowns.push(TrimUnknown::Roll);
            }
            SteadyFlight::Banked { bank_angle } => {
                given.roll = bank_angle;
                unknowns.push(TrimUnknown::Sideslip);
            }
            SteadyFlight::Turn { bank_angle } => {
                given.roll = bank_angle;
                unknowns.extend([TrimUnknown::Sideslip, TrimUnknown::TurnRate]);
                // Without one of the controls sideslip balances the rest, and nothing coordinates.
                balances.extend(has_both.then_some(Balance::Coordination));
            }
            SteadyFlight::TurnAtLoadFactor { load_factor } => {
                unknowns.extend([TrimUnknown::Roll, TrimUnknown::Sideslip, TrimUnknown::TurnRate]);
                balances.push(Balance::LoadFactor(load_factor.abs()));
                balances.extend(has_both.then_some(Balance::Coordination));
            }
        }
        for (role, is_there) in [TrimRole::Roll, TrimRole::Yaw].into_iter().zip(controls) {
            unknowns.extend(if is_there { Some(TrimUnknown::Control(role)) } else { stand_in.take() });
        }
        (unknowns.len() == balances.len()).then_some(problem)
    }
}

impl TrimProblem {
    /// The same with an unknown held at a value (thrust in N), and what it balances dropped [theory: trim.limits].
    pub fn holding(mut self, held: TrimUnknown, value: f64) -> Self {
        let ([forward, downward, pitching], [aside, rolling, yawing]) = (IN_PLANE, ASIDE);
        let paired = match held {
            TrimUnknown::Control(TrimRole::Pitch) => pitching,
            TrimUnknown::Control(TrimRole::Roll) => rolling,
            TrimUnknown::Control(TrimRole::Yaw) => yawing,
            _ => forward,
        };
        for balance in &mut self.balances {
            if let Balance::Row(row) = *balance {
                *balance = Balance::Acceleration(row);
            }
        }
        self.balances.retain(|balance| *balance != Balance::Acceleration(paired));
        if held == TrimUnknown::Thrust {
            for balance in &mut self.balances {
                *balance = match *balance {
                    Balance::Acceleration(row) if row == downward => Balance::AcrossPath,
                    Balance::Acceleration(row) if row == aside => Balance::AsideOfPath,
                    other => other,
                };
            }
        }
        self.unknowns.retain(|unknown| *unknown != held);
        *held.of(&mut self.given) = value;
        self.is_held = true;
        self
    }
}

impl TrimPoint {
    /// ω of the flight, body axes, rad/s [theory: trim.manoeuvres].
    pub fn rate(&self) -> Vector3<f64> {
        let ((sin_pitch, cos_pitch), (sin_roll, cos_roll)) =
            (libm::sincos(self.pitch), libm::sincos(self.roll));
        let turn = Vector3::new(0.0 - sin_pitch, sin_roll * cos_pitch, cos_roll * cos_pitch) * self.turn_rate;
        turn + Vector3::y() * self.pitch_rate
    }
}

/// Load factors at O while nothing accelerates in body axes: along the wings, and across the flow in still air.
pub(super) fn steady_load_factors(equations: &EquationsOfMotion, state: &[f64]) -> [f64; 2] {
    let motion = equations.motion(state);
    let to_body = Attitude::from_quaternion(&state[equations.layout().attitude()]).body_from_inertial;
    let factors = load_factor(&motion.rate.cross(&motion.velocity), &to_body, equations.gravity);
    let [x, z] = [motion.velocity.x, motion.velocity.z];
    let speed = libm::hypot(x, z);
    [factors.y, if speed > 0.0 { (factors.z * x + factors.x * z) / speed } else { 0.0 }]
}
