//! What an engineer reads after a step.

use nalgebra::{Matrix3, Vector3};

use crate::air::{Air, STANDARD_GRAVITY};
use crate::equations::{Controls, EquationsOfMotion, StateLayout, Workspace};
use crate::kinematics::combine;
use crate::math::Attitude;
use crate::structure::{ReducedModel, ReducedStation};

use super::course::Course;
use super::sensors::{BodyMotion, Sensors};

/// All outputs at one instant.
///
/// ```
/// # use std::sync::Arc;
/// # use flexible_aircraft::flight::{Settings, Simulation};
/// # use flexible_aircraft::{Aircraft, ReducedModel};
/// let jet = Arc::new(ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?);
/// let mut flight = Simulation::new(Arc::clone(&jet), &Settings::of(&jet), 0.0)?;
/// let tip = jet.stations.iter().position(|station| station.name == "wing_tip_right").ok_or("no such station")?;
/// let outputs = flight.outputs();
/// assert!((outputs.air.speed - jet.airspeed).abs() < 1e-9); // m/s
/// assert!((outputs.load_factor.z - outputs.attitude.y.cos()).abs() < 1e-6); // level flight
/// assert!(outputs.deflections[tip].displacement.z < -0.5); // m: up
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Outputs {
    /// Of O, north-east-down, m.
    pub position: Vector3<f64>,
    /// Roll, pitch, yaw: 3-2-1 Euler angles, rad.
    pub attitude: Vector3<f64>,
    /// Inertial velocity of O, body axes, m/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity, body axes, rad/s.
    pub rate: Vector3<f64>,
    /// v̇: rates of change of the body-axis velocity components, m/s².
    pub acceleration: Vector3<f64>,
    /// (inertial acceleration − gravity)/g at O along x_b, y_b and −z_b.
    pub load_factor: Vector3<f64>,
    /// Flow at O.
    pub air: AirData,
    /// One per station of the model.
    pub deflections: Vec<Deflection>,
    /// One per station of the model.
    pub sensors: Vec<Sensors>,
    /// Generalised coordinates of all packaged modes; those not in use are 0.
    pub modal_q: Vec<f64>,
    /// Their rates, 1/s.
    pub modal_q_dot: Vec<f64>,
    /// Absolute elevator angle acting, rad.
    pub elevator: f64,
    /// Absolute aileron angle acting, rad.
    pub aileron: f64,
    /// Absolute angle of both ailerons together, rad.
    pub aileron_symmetric: f64,
    /// Absolute rudder angle acting, rad.
    pub rudder: f64,
    /// Absolute thrust acting per engine, N.
    pub thrust: Vec<f64>,
}

/// The undisturbed flow at O.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AirData {
    /// True airspeed, m/s.
    pub speed: f64,
    /// Angle of attack of the body x axis, rad.
    pub angle_of_attack: f64,
    /// Sideslip angle, rad, positive with the wind from the right.
    pub sideslip: f64,
    /// Mach number.
    pub mach: f64,
    /// kg/m³.
    pub density: f64,
    /// Pa.
    pub dynamic_pressure: f64,
}

/// Elastic displacement and twist of a station.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deflection {
    /// Body axes, m.
    pub displacement: Vector3<f64>,
    /// Rotation about the station's twist axis, nose-up positive, rad.
    pub twist: f64,
}

impl Outputs {
    /// Room for the outputs of a model, all zero.
    pub(crate) fn new(model: &ReducedModel) -> Self {
        Outputs {
            position: Vector3::zeros(),
            attitude: Vector3::zeros(),
            velocity: Vector3::zeros(),
            rate: Vector3::zeros(),
            acceleration: Vector3::zeros(),
            load_factor: Vector3::zeros(),
            air: AirData::default(),
            deflections: vec![Deflection::default(); model.stations.len()],
            sensors: vec![Sensors::default(); model.stations.len()],
            modal_q: vec![0.0; model.modes.len()],
            modal_q_dot: vec![0.0; model.modes.len()],
            elevator: 0.0,
            aileron: 0.0,
            aileron_symmetric: 0.0,
            rudder: 0.0,
            thrust: vec![0.0; model.engines.len()],
        }
    }

    /// Writes the motion of O, in axes along a course.
    pub(super) fn write_motion(
        &mut self,
        equations: &EquationsOfMotion,
        state: &[f64],
        workspace: &Workspace,
        course: Course,
    ) {
        let layout = equations.layout();
        let to_body = Attitude::from_quaternion(&state[layout.attitude()]).body_from_inertial;
        let motion = equations.motion(state);
        let acceleration = Vector3::from_column_slice(&workspace.accelerations()[0..3]);
        self.position = course.north_east_down(&Vector3::from_column_slice(&state[layout.position()]));
        self.attitude = Attitude { body_from_inertial: to_body * course.matrix() }.euler_angles();
        self.velocity = motion.velocity;
        self.rate = motion.rate;
        self.acceleration = acceleration;
        let inertial = acceleration + motion.rate.cross(&motion.velocity);
        self.load_factor = load_factor(&inertial, &to_body, equations.gravity);
    }

    /// Writes the coordinates of the packaged modes, of which these take part.
    pub(super) fn write_modes(&mut self, modes: &[usize], layout: &StateLayout, state: &[f64]) {
        self.modal_q.fill(0.0);
        self.modal_q_dot.fill(0.0);
        let coordinates = state[layout.coordinates()].iter().zip(&state[layout.coordinate_rates()]);
        for (&packaged, (q, q_dot)) in modes.iter().zip(coordinates) {
            self.modal_q[packaged] = *q;
            self.modal_q_dot[packaged] = *q_dot;
        }
    }

    /// Writes what is seen and measured at the stations.
    pub(super) fn write_stations(
        &mut self,
        stations: &[ReducedStation],
        equations: &EquationsOfMotion,
        state: &[f64],
        workspace: &Workspace,
    ) {
        let layout = equations.layout();
        let to_body = Attitude::from_quaternion(&state[layout.attitude()]).body_from_inertial;
        let q = &state[layout.coordinates()];
        let body = BodyMotion {
            motion: equations.motion(state),
            acceleration: Vector3::from_column_slice(&workspace.accelerations()[0..3]),
            angular_acceleration: Vector3::from_column_slice(&workspace.accelerations()[3..6]),
            gravity: to_body * Vector3::new(0.0, 0.0, equations.gravity),
            q_dot: &state[layout.coordinate_rates()],
            q_ddot: &workspace.accelerations()[6..],
        };
        let places = self.deflections.iter_mut().zip(&mut self.sensors);
        for ((deflection, sensors), station) in places.zip(stations) {
            let displacement = combine(&station.shapes.translation, q);
            let turned = combine(&station.shapes.rotation, q);
            *deflection = Deflection { displacement, twist: station.twist_axis.dot(&turned) };
            *sensors = Sensors::read(station, [&displacement, &turned], &body);
        }
    }

    /// Writes what acts.
    pub(super) fn write_controls(&mut self, controls: &Controls) {
        (self.elevator, self.rudder) = (controls.elevator, controls.rudder);
        (self.aileron, self.aileron_symmetric) = (controls.aileron, controls.aileron_symmetric);
        self.thrust.copy_from_slice(&controls.thrust);
    }
}

/// (inertial acceleration − gravity)/g along x_b, y_b, −z_b; without gravity, in units of standard gravity.
fn load_factor(inertial: &Vector3<f64>, to_body: &Matrix3<f64>, gravity: f64) -> Vector3<f64> {
    let unit = if gravity > 0.0 { gravity } else { STANDARD_GRAVITY };
    let specific_force = (inertial - to_body * Vector3::new(0.0, 0.0, gravity)) / unit;
    Vector3::new(specific_force.x, specific_force.y, -specific_force.z)
}

impl AirData {
    /// From the velocity relative to the air, body axes, m/s.
    pub(super) fn new(velocity: &Vector3<f64>, air: &Air) -> Self {
        let speed = velocity.norm();
        AirData {
            speed,
            angle_of_attack: libm::atan2(velocity.z, velocity.x),
            sideslip: if speed > 0.0 { libm::asin((velocity.y / speed).clamp(-1.0, 1.0)) } else { 0.0 },
            mach: speed / air.speed_of_sound,
            density: air.density,
            dynamic_pressure: 0.5 * air.density * speed * speed,
        }
    }
}
