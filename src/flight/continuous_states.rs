//! The states of the motion for whoever integrates it by his own method: one vector at every level of fidelity, in the
//! order that aeronautical engineers are used to [theory: continuous-model.states].

use nalgebra::Vector3;

use crate::aircraft::Support;
use crate::equations::StateLayout;
use crate::math::{Attitude, quaternion_of_euler_angles};
use crate::plant::{Course, Plant, Unknown};
use crate::structure::ReducedModel;

use super::acting::Acting;

/// A state; axes are 0, 1, 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ContinuousState {
    /// Of O towards north, east, down, m.
    Position(usize),
    /// Roll, pitch, yaw angle, rad; yaw goes on beyond half a turn.
    Attitude(usize),
    /// Of O along a body axis, m/s.
    Velocity(usize),
    /// About a body axis, rad/s.
    Rate(usize),
    /// q of the packaged mode with this index.
    Coordinate(usize),
    /// q̇ of the packaged mode with this index.
    CoordinateRate(usize),
    /// An inflow state of a strip, m/s.
    Inflow {
        /// Index of the strip.
        strip: usize,
        /// Index of the state among those of the strip: real ones, then real and imaginary part of each complex one.
        number: usize,
    },
    /// D: how far the air has gone towards north, east, down, m [theory: gusts.field].
    Drift(usize),
    /// Of the control with this index, where its actuator lags, rad.
    SurfaceAngle(usize),
    /// Of the control with this index, where its actuator lags, rad/s.
    SurfaceRate(usize),
    /// Of the engine with this index, where it lags, N.
    LaggedThrust(usize),
}

impl ContinuousState {
    /// All of an aircraft, whatever its settings.
    pub fn all(model: &ReducedModel) -> Vec<ContinuousState> {
        use ContinuousState as S;
        let mut states = Vec::new();
        if model.support == Support::Free {
            for part in [S::Position, S::Attitude, S::Velocity, S::Rate] {
                states.extend((0..3).map(part));
            }
        }
        let modes = model.modes.len();
        states.extend((0..modes).map(S::Coordinate));
        states.extend((0..modes).map(S::CoordinateRate));
        let of_strip = |strip| (0..model.inflow_states).map(move |number| S::Inflow { strip, number });
        states.extend((0..model.strips.len()).flat_map(of_strip));
        states.extend((0..3).map(S::Drift));
        states.extend((0..model.controls.len()).flat_map(|i| [S::SurfaceAngle(i), S::SurfaceRate(i)]));
        states.extend((0..model.engines.len()).map(S::LaggedThrust));
        states
    }

    /// What is usual of it: of coordinates a tenth of one that moves some strip by about 1 m, of velocities at an airspeed (m/s).
    pub fn nominal(self, coordinate_magnitude: f64, airspeed: f64) -> f64 {
        match self {
            ContinuousState::Position(_) | ContinuousState::Drift(_) => 1000.0,
            ContinuousState::Attitude(_) | ContinuousState::Rate(_) | ContinuousState::SurfaceAngle(_) => 0.1,
            ContinuousState::Velocity(_) => 10.0,
            ContinuousState::Coordinate(_) => 0.1 * coordinate_magnitude,
            ContinuousState::CoordinateRate(_) => 0.1 * coordinate_magnitude * airspeed,
            ContinuousState::Inflow { .. } | ContinuousState::SurfaceRate(_) => 1.0,
            ContinuousState::LaggedThrust(_) => 10_000.0,
        }
    }

    /// By how much it may depart at an airspeed (m/s) for differences that are exact to rounding
    /// [theory: linearisation.differences].
    pub(super) fn step(self, plant: &Plant, airspeed: f64) -> f64 {
        let unknown = match self {
            ContinuousState::Position(2) => Unknown::Down,
            ContinuousState::Position(axis) => Unknown::Horizontal(axis),
            ContinuousState::Drift(_) => Unknown::Down,
            ContinuousState::Attitude(0) => Unknown::Roll,
            ContinuousState::Attitude(1) => Unknown::Pitch,
            ContinuousState::Attitude(_) => Unknown::Yaw,
            ContinuousState::Velocity(axis) => Unknown::Velocity(axis),
            ContinuousState::Rate(axis) => Unknown::Rate(axis),
            ContinuousState::Coordinate(mode) => Unknown::Coordinate(mode),
            ContinuousState::CoordinateRate(mode) => Unknown::CoordinateRate(mode),
            ContinuousState::Inflow { strip, number } => Unknown::Inflow { strip, place: number },
            ContinuousState::SurfaceAngle(_) => return 1e-2,
            ContinuousState::SurfaceRate(_) => return 1.0,
            ContinuousState::LaggedThrust(_) => return 1e3,
        };
        plant.step(unknown, airspeed)
    }
}

/// Where a state acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Along north, east, down.
    Position(usize),
    /// Of roll, pitch, yaw.
    Attitude(usize),
    /// A number of the plant's state.
    Plant(usize),
    /// Along north, east, down.
    Drift(usize),
    /// Of a control.
    SurfaceAngle(usize),
    /// Of a control; only where it lags.
    SurfaceRate(usize),
    /// Of an engine.
    Thrust(usize),
    /// Nowhere: it is 0.
    Resting,
}

/// From the states to the plant's, and back.
#[derive(Clone, Debug)]
pub(super) struct StateMap {
    places: Vec<Place>,
    course: Course,
    /// By how much the yaw angle is greater than that from the course.
    yaw_of_course: f64,
}

impl StateMap {
    /// Of states of a plant that flies along a course; `lags` says which actuators do.
    pub fn new(
        states: &[ContinuousState],
        plant: &Plant,
        (course, yaw_of_course): (Course, f64),
        lags: impl Fn(usize) -> bool,
    ) -> Self {
        let layout = plant.layout();
        let coordinate = |mode| (0..layout.modes()).find(|&place| plant.packaged_mode(place) == Some(mode));
        let inflow = |strip| layout.inflow_layout().of_strip(strip);
        let plant_or_rest = |place: Option<usize>| place.map_or(Place::Resting, Place::Plant);
        let place = |state: &ContinuousState| match *state {
            ContinuousState::Position(axis) => Place::Position(axis),
            ContinuousState::Attitude(axis) => Place::Attitude(axis),
            ContinuousState::Velocity(axis) => Place::Plant(layout.velocity().start + axis),
            ContinuousState::Rate(axis) => Place::Plant(layout.rate().start + axis),
            ContinuousState::Coordinate(mode) => {
                plant_or_rest(coordinate(mode).map(|place| layout.coordinates().start + place))
            }
            ContinuousState::CoordinateRate(mode) => {
                plant_or_rest(coordinate(mode).map(|place| layout.coordinate_rates().start + place))
            }
            ContinuousState::Inflow { strip, number } => plant_or_rest(inflow(strip).get(number).copied()),
            ContinuousState::Drift(axis) => Place::Drift(axis),
            ContinuousState::SurfaceAngle(control) => Place::SurfaceAngle(control),
            ContinuousState::SurfaceRate(control) if lags(control) => Place::SurfaceRate(control),
            ContinuousState::SurfaceRate(_) => Place::Resting,
            ContinuousState::LaggedThrust(engine) => Place::Thrust(engine),
        };
        StateMap { places: states.iter().map(place).collect(), course, yaw_of_course }
    }

    /// Where each state acts.
    pub fn places(&self) -> &[Place] {
        &self.places
    }

    /// Puts states into those of the plant and what lags; returns north, east, down of the air's way, m.
    pub fn apply(
        &self,
        (x, layout): (&[f64], &StateLayout),
        state: &mut [f64],
        acting: &mut Acting,
    ) -> Vector3<f64> {
        let mut drift = Vector3::zeros();
        let [mut position, mut angles] = [None, None];
        for (place, &number) in self.places.iter().zip(x) {
            match *place {
                Place::Position(axis) => position.get_or_insert_with(Vector3::zeros)[axis] = number,
                Place::Attitude(axis) => angles.get_or_insert_with(Vector3::zeros)[axis] = number,
                Place::Plant(place) => state[place] = number,
                Place::Drift(axis) => drift[axis] = number,
                Place::SurfaceAngle(control) => acting.surfaces[control].angle = number,
                Place::SurfaceRate(control) => acting.surfaces[control].rate = number,
                Place::Thrust(engine) => acting.thrusts[engine] = number,
                Place::Resting => {}
            }
        }
        if let Some(position) = position {
            state[layout.position()].copy_from_slice(self.course.along(&position).as_slice());
        }
        if let Some(mut angles) = angles {
            angles.z -= self.yaw_of_course;
            state[layout.attitude()].copy_from_slice(&quaternion_of_euler_angles(&angles));
        }
        drift
    }

    /// The states of a plant in a state, and of what lags.
    pub fn read(&self, (state, layout): (&[f64], &StateLayout), acting: &Acting) -> Vec<f64> {
        let position = self.course.north_east_down(&Vector3::from_column_slice(&state[layout.position()]));
        let mut angles = Attitude::from_quaternion(&state[layout.attitude()]).euler_angles();
        angles.z += self.yaw_of_course;
        let number = |place: &Place| match *place {
            Place::Position(axis) => position[axis],
            Place::Attitude(axis) => angles[axis],
            Place::Plant(place) => state[place],
            Place::Drift(_) | Place::Resting => 0.0,
            Place::SurfaceAngle(control) => acting.surfaces[control].angle,
            Place::SurfaceRate(control) => acting.surfaces[control].rate,
            Place::Thrust(engine) => acting.thrusts[engine],
        };
        self.places.iter().map(number).collect()
    }
}
