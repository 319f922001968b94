//! What acts on an aircraft, as it tells whether half the aircraft may fly [theory: symmetry.unfolding].

use nalgebra::Vector3;

/// What decides how a control or an engine acts from an instant on, where its actuator and its limits are known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// What acts, what is asked for, and the rate of what acts, times the time in which that changes; rad or N.
    pub values: [f64; 3],
    /// Of what is asked for, per second.
    pub rate: f64,
}

/// What acts on an aircraft from an instant on.
pub trait Actions {
    /// Whether what acts is what is asked for: all controls and engines then move alike that are asked to.
    fn are_direct(&self) -> bool;
    /// Of a control, rad.
    fn angle(&self, control: usize) -> Motion;
    /// Of an engine, N.
    fn thrust(&self, engine: usize) -> Motion;
    /// Whether any control or engine follows what is asked of it later; where none does, the first of a [`Motion`]'s values tells
    /// the others.
    fn lag(&self) -> bool;
    /// Whether actuators keep controls to Σ factor · angle = 0 as long as their [`Motion`]s keep to it.
    fn controls_move_alike(&self, terms: &[(usize, f64)]) -> bool;
    /// Whether two engines give the same while their [`Motion`]s are the same.
    fn engines_move_alike(&self, engine: usize, image: usize) -> bool;
    /// Along the course: the wind, m/s, its rate, m/s², and the rate of that, m/s³.
    fn winds(&self) -> [Vector3<f64>; 3];
    /// Whether what is frozen in the air blows in the mirror plane.
    fn gust_is_in_plane(&self) -> bool;
}
