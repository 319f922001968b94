//! The linear pose of each section, summed from O outward [theory: geometrically-exact.sections].

use nalgebra::Vector3;

use super::{BeamSection, ModeShapes};

/// Ψᵘ and Ψᵠ of each of the sections.
pub(crate) fn linear_poses(sections: &[BeamSection]) -> Vec<ModeShapes> {
    let mut poses: Vec<ModeShapes> = Vec::with_capacity(sections.len());
    for section in sections {
        let pose = match poses.get(section.parent) {
            Some(parent) => {
                let arm = section.position - sections[section.parent].position;
                linear_pose_after(parent, &section.steps, &arm)
            }
            None => section.steps.clone(),
        };
        poses.push(pose);
    }
    poses
}

/// Ψᵘ and Ψᵠ an arm (m) and some steps beyond a section.
pub(crate) fn linear_pose_after(parent: &ModeShapes, steps: &ModeShapes, arm: &Vector3<f64>) -> ModeShapes {
    let modes = steps.modes();
    let mut pose = steps.clone();
    for mode in 0..modes {
        let ([u_parent, phi_parent], [slide, turn]) = (parent.of_mode(mode), steps.of_mode(mode));
        let (u, phi) = (u_parent + slide + (phi_parent + turn * 0.5).cross(arm), phi_parent + turn);
        for axis in 0..3 {
            pose.translation[axis * modes + mode] = u[axis];
            pose.rotation[axis * modes + mode] = phi[axis];
        }
    }
    pose
}
