//! What an engineer reads after a step [theory: outputs.air-data, outputs.load-factor, outputs.deflection].

use nalgebra::{Matrix3, Vector3};

use crate::air::STANDARD_GRAVITY;
use crate::equations::{CentreOfMass, Controls, EquationsOfMotion, StateLayout, Workspace};
use crate::kinematics::{GeneralisedVector, Kinematics, OfKind, Section, Sections, by_kind};
use crate::math::Attitude;
use crate::structure::{ModesInUse, ReducedStation};

use super::air_data::{AirData, Path};
use super::course::Course;
use super::cut_loads::CutLoads;
use super::placement::{BodyPlacement, Placement};
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
    /// The unit quaternion, scalar first, that turns body components into north, east, down; continuous, its scalar not
    /// negative where the flight begins.
    pub quaternion: [f64; 4],
    /// Inertial velocity of O, body axes, m/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity, body axes, rad/s.
    pub rate: Vector3<f64>,
    /// v̇: rates of change of the body-axis velocity components, m/s².
    pub acceleration: Vector3<f64>,
    /// ω̇, body axes, rad/s².
    pub angular_acceleration: Vector3<f64>,
    /// (inertial acceleration − gravity)/g at O along x_b, y_b and −z_b.
    pub load_factor: Vector3<f64>,
    /// The same at the momentary centre of mass.
    pub load_factor_cg: Vector3<f64>,
    /// That at O across the flow there: 1 in level flight.
    pub lift_load_factor: f64,
    /// Of O over the ground.
    pub path: Path,
    /// Flow at O.
    pub air: AirData,
    /// Velocity of the air at O, all of it, north-east-down, m/s [theory: gusts.outputs].
    pub wind: Vector3<f64>,
    /// Of the single gust into which the aircraft flies, m/s of true airspeed; 0 where there is none.
    pub gust_peak_velocity: f64,
    /// One per station of the model.
    pub deflections: Vec<Deflection>,
    /// One per station of the model.
    pub sensors: Vec<Sensors>,
    /// One per station of the model.
    pub placements: Vec<Placement>,
    /// Generalised coordinates of all packaged modes; those not in use are 0.
    pub modal_q: Vec<f64>,
    /// Their rates, 1/s.
    pub modal_q_dot: Vec<f64>,
    /// Absolute angle acting per control, rad.
    pub controls: Vec<f64>,
    /// Absolute thrust acting per engine, N.
    pub thrust: Vec<f64>,
    /// One per cut of the model, where they were asked for.
    pub loads: CutLoads,
}

/// Elastic displacement and twist of a station [theory: outputs.deflection].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deflection {
    /// Body axes, m.
    pub displacement: Vector3<f64>,
    /// Rotation about the station's twist axis, nose-up positive, rad.
    pub twist: f64,
}

impl Outputs {
    /// All zero, for so many packaged modes, stations, controls, engines and cuts.
    pub(super) fn zero(modes: usize, stations: usize, [controls, engines, cuts]: [usize; 3]) -> Self {
        Outputs {
            position: Vector3::zeros(),
            attitude: Vector3::zeros(),
            quaternion: [1.0, 0.0, 0.0, 0.0],
            velocity: Vector3::zeros(),
            rate: Vector3::zeros(),
            acceleration: Vector3::zeros(),
            angular_acceleration: Vector3::zeros(),
            load_factor: Vector3::zeros(),
            load_factor_cg: Vector3::zeros(),
            lift_load_factor: 0.0,
            path: Path::default(),
            air: AirData::default(),
            wind: Vector3::zeros(),
            gust_peak_velocity: 0.0,
            deflections: vec![Deflection::default(); stations],
            sensors: vec![Sensors::default(); stations],
            placements: vec![Placement::ORIGIN; stations],
            modal_q: vec![0.0; modes],
            modal_q_dot: vec![0.0; modes],
            controls: vec![0.0; controls],
            thrust: vec![0.0; engines],
            loads: CutLoads::unknown(cuts),
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
        let accelerations = GeneralisedVector::of(workspace.accelerations());
        let acceleration = accelerations.translation;
        self.position = course.north_east_down(&Vector3::from_column_slice(&state[layout.position()]));
        self.attitude = Attitude { body_from_inertial: to_body * course.matrix() }.euler_angles();
        self.velocity = motion.velocity;
        self.rate = motion.rate;
        self.acceleration = acceleration;
        self.angular_acceleration = accelerations.rotation;
        let inertial = acceleration + motion.rate.cross(&motion.velocity);
        self.load_factor = load_factor(&inertial, &to_body, equations.gravity);
    }

    /// Writes the load factor at the centre of mass.
    pub(super) fn write_load_factor_cg(
        &mut self,
        equations: &EquationsOfMotion,
        state: &[f64],
        workspace: &Workspace,
    ) {
        let to_body = Attitude::from_quaternion(&state[equations.layout().attitude()]).body_from_inertial;
        let centre = equations.centre_of_mass(state, workspace);
        let of_origin = self.acceleration + self.rate.cross(&self.velocity);
        let at_centre = of_origin + beside_origin(&centre, &self.rate, &self.angular_acceleration);
        self.load_factor_cg = load_factor(&at_centre, &to_body, equations.gravity);
    }

    /// Writes attitudes as quaternions, where stations are, and the path, in axes along a course.
    pub(super) fn write_placements(
        &mut self,
        equations: &EquationsOfMotion,
        state: &[f64],
        workspace: &Workspace,
        course: Course,
    ) {
        let layout = equations.layout();
        let to_body = Attitude::from_quaternion(&state[layout.attitude()]).body_from_inertial;
        self.quaternion = course.quaternion(&state[layout.attitude()]);
        self.path = Path::new(&course.north_east_down(&to_body.tr_mul(&self.velocity)));
        let body = BodyPlacement {
            position: Vector3::from_column_slice(&state[layout.position()]),
            to_body,
            quaternion: self.quaternion,
            course,
        };
        let at = equations.coordinates(state);
        by_kind!(equations.kinematics.as_ref().with(workspace.kinematics().as_ref()), |(
            kinematics,
            memory,
        )| {
            for (place, section) in self.placements.iter_mut().zip(kinematics.sections(at, memory).stations())
            {
                *place = Placement::of(&section, &body);
            }
        });
    }

    /// Writes the flow at O, across which the load factor counts as lift.
    pub(super) fn write_air(&mut self, air: AirData) {
        let (sin, cos) = libm::sincos(air.angle_of_attack);
        self.lift_load_factor = self.load_factor.z * cos + self.load_factor.x * sin;
        self.air = air;
    }

    /// Writes the coordinates of the packaged modes, of which these take part.
    pub(super) fn write_modes(&mut self, modes: &ModesInUse, layout: &StateLayout, state: &[f64]) {
        modes.write_packaged(&state[layout.coordinates()], &mut self.modal_q);
        modes.write_packaged(&state[layout.coordinate_rates()], &mut self.modal_q_dot);
    }

    /// Writes what is seen and measured at the stations.
    pub(super) fn write_stations(
        &mut self,
        stations: &[ReducedStation],
        equations: &EquationsOfMotion,
        state: &[f64],
        workspace: &Workspace,
    ) {
        let to_body = Attitude::from_quaternion(&state[equations.layout().attitude()]).body_from_inertial;
        let accelerations = GeneralisedVector::of(workspace.accelerations());
        let body = BodyMotion {
            motion: equations.motion(state),
            acceleration: accelerations.translation,
            angular_acceleration: accelerations.rotation,
            gravity: to_body * Vector3::new(0.0, 0.0, equations.gravity),
            q_ddot: accelerations.modal,
        };
        let at = equations.coordinates(state);
        by_kind!(equations.kinematics.as_ref().with(workspace.kinematics().as_ref()), |(
            kinematics,
            memory,
        )| {
            let sections = kinematics.sections(at, memory);
            self.write_sections(sections.stations(), stations, &body);
        });
    }

    /// Writes what is seen and measured at the sections of the stations.
    fn write_sections(
        &mut self,
        sections: impl Iterator<Item = impl Section>,
        stations: &[ReducedStation],
        body: &BodyMotion,
    ) {
        let places = self.deflections.iter_mut().zip(&mut self.sensors);
        for (((deflection, sensors), station), section) in places.zip(stations).zip(sections) {
            let (displacement, twist) = (section.displacement(), section.twist(&station.twist_axis));
            *deflection = Deflection { displacement, twist };
            *sensors = Sensors::read(&section, body);
        }
    }

    /// Writes what acts.
    pub(super) fn write_controls(&mut self, controls: &Controls) {
        self.controls.copy_from_slice(&controls.angles);
        self.thrust.copy_from_slice(&controls.thrust);
    }
}

/// By how much the inertial acceleration of a point that moves in the body axes exceeds that of O, m/s².
fn beside_origin(
    CentreOfMass { position, velocity, acceleration }: &CentreOfMass,
    rate: &Vector3<f64>,
    angular_acceleration: &Vector3<f64>,
) -> Vector3<f64> {
    angular_acceleration.cross(position) + rate.cross(&(rate.cross(position) + velocity * 2.0)) + acceleration
}

/// (inertial acceleration − gravity)/g along x_b, y_b, −z_b; without gravity, in units of standard gravity.
///
/// [theory: outputs.load-factor]
pub(super) fn load_factor(inertial: &Vector3<f64>, to_body: &Matrix3<f64>, gravity: f64) -> Vector3<f64> {
    let unit = if gravity > 0.0 { gravity } else { STANDARD_GRAVITY };
    let specific_force = (inertial - to_body * Vector3::new(0.0, 0.0, gravity)) / unit;
    Vector3::new(specific_force.x, specific_force.y, -specific_force.z)
}
