//! What all strips of an aircraft share at an instant [theory: air-loads.flow].

use nalgebra::Vector3;

use crate::kinematics::RigidFreedom;

use super::gust_at_strips::GustAtStrips;
use super::inflow::PetersInflow;

/// The state of the aircraft and of the air that all strips share.
pub struct Surroundings<'a, A> {
    /// The air as the aircraft meets it.
    pub air: A,
    /// What blows at the strips beside it, if the aircraft flies into a gust [theory: gusts.chord].
    pub gust: Option<&'a GustAtStrips>,
    /// ω, body axes, rad/s.
    pub rate: Vector3<f64>,
    /// ρ, kg/m³.
    pub density: f64,
    /// The inflow model of every strip.
    pub inflow: &'a PetersInflow,
    /// Whether forces act at the deformed place (all models but RL).
    pub deformed_arms: bool,
    /// Which components of v and ω move.
    pub freedom: RigidFreedom,
}
