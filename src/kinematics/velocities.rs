//! ν = [v; ω; q̇], over which the equations of motion stand, and vectors over it by their parts: velocities, accelerations,
//! generalised forces. Nobody else counts its components.
//!
//! [theory: frames.rates; thesis §2.2]

use nalgebra::Vector3;

/// Components of v, and of ω.
const AXES: usize = 3;

/// How many components of ν are the rigid motion's: they come first.
pub const RIGID: usize = 2 * AXES;

/// Places in ν of the motion in the mirror plane y = 0: v_x, v_z and ω_y.
pub const IN_PLANE: [usize; 3] = [0, 2, 4];

/// Places in ν of the motion across the mirror plane: v_y, ω_x and ω_z.
pub const ASIDE: [usize; 3] = [1, 3, 5];

/// Length of ν with so many generalised coordinates.
pub const fn velocities(modes: usize) -> usize {
    RIGID + modes
}

/// A vector over ν by its parts.
#[derive(Clone, Copy, Debug)]
pub struct GeneralisedVector<'a> {
    /// Over v: m/s, m/s² or N.
    pub translation: Vector3<f64>,
    /// Over ω: rad/s, rad/s² or N·m.
    pub rotation: Vector3<f64>,
    /// Over q̇, one number for each mode.
    pub modal: &'a [f64],
}

/// A vector over ν by its parts, to be changed.
#[derive(Debug)]
pub struct GeneralisedVectorMut<'a> {
    /// Over v.
    pub translation: &'a mut [f64],
    /// Over ω.
    pub rotation: &'a mut [f64],
    /// Over q̇.
    pub modal: &'a mut [f64],
}

impl<'a> GeneralisedVector<'a> {
    /// What the components over v and ω are called as outputs, and what the aircraft does that is accelerated along them.
    pub const RIGID_COMPONENTS: [(&'static str, &'static str); RIGID] = [
        ("velocity.x", "forwards"),
        ("velocity.y", "sideways"),
        ("velocity.z", "downwards"),
        ("rate.x", "roll"),
        ("rate.y", "pitch"),
        ("rate.z", "yaw"),
    ];

    /// What a vector of the length of [`velocities`] has over v and ω.
    pub fn rigid_part(vector: &[f64]) -> [f64; RIGID] {
        std::array::from_fn(|component| vector[component])
    }

    /// The parts of a vector of the length of [`velocities`].
    pub fn of(vector: &'a [f64]) -> Self {
        let (rigid, modal) = vector.split_at(RIGID);
        let (translation, rotation) = rigid.split_at(AXES);
        GeneralisedVector {
            translation: Vector3::from_column_slice(translation),
            rotation: Vector3::from_column_slice(rotation),
            modal,
        }
    }
}

impl<'a> GeneralisedVectorMut<'a> {
    /// The parts of a vector of the length of [`velocities`].
    #[inline(always)]
    pub fn of(vector: &'a mut [f64]) -> Self {
        let (rigid, modal) = vector.split_at_mut(RIGID);
        let (translation, rotation) = rigid.split_at_mut(AXES);
        GeneralisedVectorMut { translation, rotation, modal }
    }

    /// Writes what stands over v and over ω.
    #[inline(always)]
    pub fn set_rigid(&mut self, translation: &Vector3<f64>, rotation: &Vector3<f64>) {
        self.translation.copy_from_slice(translation.as_slice());
        self.rotation.copy_from_slice(rotation.as_slice());
    }

    /// Adds to what stands over v and over ω.
    #[inline(always)]
    pub fn add_rigid(&mut self, translation: &Vector3<f64>, rotation: &Vector3<f64>) {
        self.add_translation(translation);
        add(self.rotation, rotation);
    }

    /// Adds to what stands over v.
    #[inline(always)]
    pub fn add_translation(&mut self, translation: &Vector3<f64>) {
        add(self.translation, translation);
    }
}

#[inline(always)]
fn add(target: &mut [f64], vector: &Vector3<f64>) {
    for (target, value) in target.iter_mut().zip(vector.iter()) {
        *target += value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_follow_one_another_and_the_rest_is_modal() {
        let mut vector: Vec<f64> = (0..velocities(2)).map(|place| place as f64).collect();
        GeneralisedVectorMut::of(&mut vector).add_rigid(&Vector3::x(), &Vector3::z());
        let GeneralisedVector { translation, rotation, modal } = GeneralisedVector::of(&vector);
        assert_eq!((translation, rotation), (Vector3::new(1.0, 1.0, 2.0), Vector3::new(3.0, 4.0, 6.0)));
        assert_eq!(modal, [6.0, 7.0]);
    }

    #[test]
    fn every_rigid_component_is_either_in_the_mirror_plane_or_across_it() {
        let mut all = [IN_PLANE, ASIDE].concat();
        all.sort_unstable();
        assert!(all.into_iter().eq(0..RIGID));
    }
}
