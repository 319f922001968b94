//! What the section of a beam has beyond EA, GJ and two EI, and the hinge at its beginning, as data.
//!
//! [theory: coupled-sections.energy, coupled-sections.mirrored, coupled-sections.hinge]

use nalgebra::Vector3;

/// Stiffnesses that couple bending in two planes, torsion and stretch, and axes apart from the reference axis; places are
/// (y, z) along the element's local axes.
///
/// ```
/// use flexible_aircraft::aircraft::Coupling;
///
/// let washes_out = Coupling { bend_twist: [2e4, 0.0], ..Coupling::NONE };
/// assert!(!washes_out.is_none() && Coupling::default().is_none());
/// assert_eq!(washes_out.mirrored().bend_twist, [2e4, 0.0]); // so does the other wing
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coupling {
    /// EI_yz = ∫E y z dA about the tension axis, N·m².
    pub bending: f64,
    /// K_y and K_z: torsion with w″ and with v″, N·m².
    pub bend_twist: [f64; 2],
    /// k, m: how much stretch goes with twist per length.
    pub stretch_by_twist: f64,
    /// (y_t, z_t), m: where an axial force makes no bending moment.
    pub tension_axis: [f64; 2],
    /// (y_s, z_s), m: where a transverse force does not twist.
    pub shear_centre: [f64; 2],
}

impl Coupling {
    /// Of a section that has none, and all axes in one.
    pub const NONE: Coupling = Coupling {
        bending: 0.0,
        bend_twist: [0.0; 2],
        stretch_by_twist: 0.0,
        tension_axis: [0.0; 2],
        shear_centre: [0.0; 2],
    };

    /// Whether there is none.
    pub fn is_none(&self) -> bool {
        *self == Coupling::NONE
    }

    /// Of the mirror image, whose local x and y are mirrored and z = x × y.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let Coupling { bending, bend_twist: [y, z], stretch_by_twist, .. } = *self;
        let place = |[y, z]: [f64; 2]| [y, 0.0 - z];
        Coupling {
            bending: 0.0 - bending,
            bend_twist: [y, 0.0 - z],
            stretch_by_twist: 0.0 - stretch_by_twist,
            tension_axis: place(self.tension_axis),
            shear_centre: place(self.shear_centre),
        }
    }

    /// Of the same section in axes of which y and z are turned about.
    #[must_use]
    pub fn turned_about(&self) -> Self {
        let opposite = |[y, z]: [f64; 2]| [0.0 - y, 0.0 - z];
        Coupling {
            bend_twist: opposite(self.bend_twist),
            tension_axis: opposite(self.tension_axis),
            shear_centre: opposite(self.shear_centre),
            ..*self
        }
    }

    /// With other stiffnesses and the same axes.
    #[must_use]
    pub fn scaled(&self, by: f64) -> Self {
        let [y, z] = self.bend_twist;
        Coupling { bending: self.bending * by, bend_twist: [y * by, z * by], ..*self }
    }
}

/// Springs at the beginning of an element, by which it may turn against its first node; about what has no spring it does not.
#[derive(Clone, Debug, PartialEq)]
pub struct Hinge {
    /// One, or three about perpendicular axes.
    pub springs: Vec<Spring>,
}

/// A spring against rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Unit vector, body axes.
    pub axis: Vector3<f64>,
    /// N·m/rad.
    pub stiffness: f64,
}

impl Hinge {
    /// With other stiffnesses.
    #[must_use]
    pub fn scaled(&self, by: f64) -> Self {
        let springs =
            self.springs.iter().map(|spring| Spring { stiffness: spring.stiffness * by, ..*spring });
        Hinge { springs: springs.collect() }
    }

    /// With its axes where a map of vectors takes them.
    #[must_use]
    pub(super) fn turned(&self, map: impl Fn(Vector3<f64>) -> Vector3<f64>) -> Self {
        let springs = self.springs.iter().map(|spring| Spring { axis: map(spring.axis), ..*spring });
        Hinge { springs: springs.collect() }
    }
}
