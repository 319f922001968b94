//! What an engineer reads after a step.

use nalgebra::Vector3;

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
    /// Generalised coordinates of all packaged modes; those not in use are 0.
    pub modal_q: Vec<f64>,
    /// Their rates, 1/s.
    pub modal_q_dot: Vec<f64>,
    /// Absolute elevator angle acting, rad.
    pub elevator: f64,
    /// Absolute aileron angle acting, rad.
    pub aileron: f64,
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
