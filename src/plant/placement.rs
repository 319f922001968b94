//! Where sections of the structure are in space and how they stand [theory: outputs.placement].

use nalgebra::{Matrix3, Vector3};

use crate::kinematics::Section;
use crate::math::{quaternion_of_turn, quaternion_product};

use super::course::Course;

/// The place and the attitude of a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// North, east, down, m.
    pub position: Vector3<f64>,
    /// The unit quaternion, scalar first, that turns the components that a vector has in the section's axes into north, east,
    /// down. The section's axes are those of the body while nothing deforms.
    pub quaternion: [f64; 4],
}

/// Where the body axes are.
#[derive(Clone, Copy, Debug)]
pub(super) struct BodyPlacement {
    /// Of O, along the course, m.
    pub position: Vector3<f64>,
    /// C_bI, of axes along the course.
    pub to_body: Matrix3<f64>,
    /// The body's own.
    pub quaternion: [f64; 4],
    /// The course.
    pub course: Course,
}

impl Placement {
    /// At O, not turned.
    pub(super) const ORIGIN: Placement =
        Placement { position: Vector3::new(0.0, 0.0, 0.0), quaternion: [1.0, 0.0, 0.0, 0.0] };

    /// Of a section.
    pub(super) fn of(section: &impl Section, body: &BodyPlacement) -> Self {
        let place = section.at_rest() + section.displacement();
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let turn = Matrix3::from_columns(&axes.map(|axis| section.turned(&axis)));
        Placement {
            position: body.course.north_east_down(&(body.position + body.to_body.tr_mul(&place))),
            quaternion: quaternion_product(body.quaternion, quaternion_of_turn(&turn)),
        }
    }
}
