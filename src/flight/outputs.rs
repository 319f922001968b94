//! What an engineer reads after a step.

use nalgebra::{Matrix3, Vector3};

use crate::air::{Air, STANDARD_GRAVITY};
use crate::equations::{Controls, EquationsOfMotion};
use crate::kinematics::{GeneralisedVector, Section, Sections};
use crate::math::Attitude;
use crate::plant::{BodyMotion, Sensors};
use crate::structure::ReducedModel;

use super::airframe::Airframe;
use super::simulation::Simulation;

/// All outputs at one instant.
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
    pub(super) fn new(model: &ReducedModel) -> Self {
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
}

/// Writes the outputs of a simulation whose accelerations and controls are up to date.
pub(super) fn write(simulation: &mut Simulation) {
    let must_unfold = simulation.must_unfold();
    let Simulation { airframes, course, path, view, controls, outputs, model, .. } = simulation;
    let (airframe, state) = if must_unfold {
        (airframes.whole(), &view.state)
    } else {
        (airframes.flying(), &path.present.state)
    };
    let Airframe { equations, modes, stations, workspace, .. } = airframe;
    let layout = equations.layout();
    let to_body = Attitude::from_quaternion(&state[layout.attitude()]).body_from_inertial;
    let motion = equations.motion(state);
    let accelerations = GeneralisedVector::of(workspace.accelerations());
    let acceleration = accelerations.translation;

    outputs.position = course.north_east_down(&Vector3::from_column_slice(&state[layout.position()]));
    outputs.attitude = Attitude { body_from_inertial: to_body * course.matrix() }.euler_angles();
    outputs.velocity = motion.velocity;
    outputs.rate = motion.rate;
    outputs.acceleration = acceleration;
    outputs.load_factor =
        load_factor(&(acceleration + motion.rate.cross(&motion.velocity)), &to_body, model.gravity);
    outputs.air = air_data(equations, state, controls);

    let (q, q_dot) = (&state[layout.coordinates()], &state[layout.coordinate_rates()]);
    outputs.modal_q.fill(0.0);
    outputs.modal_q_dot.fill(0.0);
    for ((&packaged, q), q_dot) in modes.iter().zip(q).zip(q_dot) {
        outputs.modal_q[packaged] = *q;
        outputs.modal_q_dot[packaged] = *q_dot;
    }
    let body = BodyMotion {
        motion,
        acceleration,
        angular_acceleration: accelerations.rotation,
        gravity: to_body * Vector3::new(0.0, 0.0, model.gravity),
        q_ddot: accelerations.modal,
    };
    let places = outputs.deflections.iter_mut().zip(&mut outputs.sensors);
    let sections = equations.sections(state);
    for (((deflection, sensors), station), section) in places.zip(stations).zip(sections.stations()) {
        *deflection =
            Deflection { displacement: section.displacement(), twist: section.twist(&station.twist_axis) };
        *sensors = Sensors::read(&section, &body);
    }
    (outputs.elevator, outputs.rudder) = (controls.elevator, controls.rudder);
    (outputs.aileron, outputs.aileron_symmetric) = (controls.aileron, controls.aileron_symmetric);
    outputs.thrust.copy_from_slice(&controls.thrust);
}

/// The flow at O in a state under some controls.
pub(super) fn air_data(equations: &EquationsOfMotion, state: &[f64], controls: &Controls) -> AirData {
    AirData::new(&equations.air_velocity(state, controls), &equations.air(state))
}

/// (inertial acceleration − gravity)/g along x_b, y_b, −z_b; without gravity, in units of standard gravity.
fn load_factor(inertial: &Vector3<f64>, to_body: &Matrix3<f64>, gravity: f64) -> Vector3<f64> {
    let unit = if gravity > 0.0 { gravity } else { STANDARD_GRAVITY };
    let specific_force = (inertial - to_body * Vector3::new(0.0, 0.0, gravity)) / unit;
    Vector3::new(specific_force.x, specific_force.y, -specific_force.z)
}

impl AirData {
    /// From the velocity relative to the air, body axes, m/s.
    fn new(velocity: &Vector3<f64>, air: &Air) -> Self {
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
