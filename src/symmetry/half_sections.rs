//! The sections of the structure that count for both sides in motion that is its own mirror image.
//!
//! [theory: geometrically-exact.half, symmetry.mirror]

use nalgebra::Vector3;

use crate::math::largest;
use crate::structure::{BeamSection, Carrier, ModeShapes, ReducedModel, RigidBody, linear_poses};

/// How far mirror images may differ, in parts of the aircraft's size or of the largest shape.
const SYMMETRIC: f64 = 1e-9;

/// Sections with symmetric modes, of which those on the right carry the mass of both sides.
pub struct HalfSections {
    sections: Vec<BeamSection>,
    /// Of each section its mirror image, if it has one: itself in the plane.
    images: Vec<Option<usize>>,
    is_left: Vec<bool>,
}

impl HalfSections {
    /// Of an aircraft whose modes are symmetric.
    pub fn of(whole: &[BeamSection]) -> Self {
        let poses = Poses::of(whole);
        let images: Vec<Option<usize>> = (0..whole.len()).map(|section| poses.image(section)).collect();
        let side = |section: &BeamSection| poses.side(&section.position);
        let is_own_image = |section: usize| images[section] == Some(section);
        let mut sections = whole.to_vec();
        for (index, section) in sections.iter_mut().enumerate() {
            if is_own_image(index) && is_own_image(section.parent) {
                lay_in_plane(section);
            } else if images[index].is_some() {
                section.body = counted(&section.body, side(section));
            }
        }
        let is_left = whole.iter().map(|section| side(section) < 0).collect();
        HalfSections { sections, images, is_left }
    }

    /// Gives these sections to the model, and what hangs on the left to their images.
    pub fn take_place_in(self, model: &mut ReducedModel) {
        let engines = model.engines.iter_mut().map(|engine| &mut engine.carrier);
        let stations = model.stations.iter_mut().map(|station| &mut station.carrier);
        let masses = model.masses.iter_mut().map(|mass| &mut mass.carrier);
        for carrier in engines.chain(stations).chain(masses) {
            if let Some(section) = self.images[carrier.section].filter(|_| self.is_left[carrier.section]) {
                *carrier = Carrier { section, mirrored: !carrier.mirrored };
            }
        }
        model.sections = self.sections;
    }
}

/// A body as it counts: twice on the right, not on the left, once in the plane.
fn counted(body: &RigidBody, side: i8) -> RigidBody {
    let RigidBody { mass, offset, inertia } = *body;
    match side {
        1 => RigidBody { mass: mass * 2.0, offset, inertia: inertia * 2.0 },
        -1 => RigidBody::NONE,
        _ => *body,
    }
}

/// Takes off what symmetry up to rounding has left across the mirror plane.
fn lay_in_plane(section: &mut BeamSection) {
    section.position.y = 0.0;
    ModeShapes::ACROSS.into_iter().for_each(|row| section.steps.row_mut(row).fill(0.0));
}

/// Where sections are and how the modes move and turn them.
struct Poses<'a> {
    sections: &'a [BeamSection],
    /// Of each section.
    shapes: Vec<ModeShapes>,
    size: f64,
    shape: f64,
}

impl<'a> Poses<'a> {
    fn of(sections: &'a [BeamSection]) -> Self {
        let shapes = linear_poses(sections);
        let size = largest(sections.iter().map(|section| section.position.norm()));
        let all = shapes.iter().flat_map(|shapes| shapes.translation.iter().chain(&shapes.rotation));
        let shape = largest(all.copied());
        Poses { sections, shapes, size, shape }
    }

    /// 1 on the right, −1 on the left, 0 in the plane.
    fn side(&self, position: &Vector3<f64>) -> i8 {
        match position.y {
            y if y > SYMMETRIC * self.size => 1,
            y if y < -SYMMETRIC * self.size => -1,
            _ => 0,
        }
    }

    /// The mirror image of a section, itself before others.
    fn image(&self, section: usize) -> Option<usize> {
        std::iter::once(section).chain(0..self.sections.len()).find(|&other| self.are_images(section, other))
    }

    fn are_images(&self, one: usize, other: usize) -> bool {
        let close =
            |one: Vector3<f64>, other: &Vector3<f64>, size: f64| (one - other).amax() <= SYMMETRIC * size;
        close(mirror(&self.sections[one].position), &self.sections[other].position, self.size)
            && (0..self.shapes[one].modes()).all(|mode| {
                let [[u, phi], [moved, turned]] =
                    [one, other].map(|section| self.shapes[section].of_mode(mode));
                close(mirror(&u), &moved, self.shape) && close(-mirror(&phi), &turned, self.shape)
            })
    }
}

/// An arrow's image in the plane y = 0.
fn mirror(arrow: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(arrow.x, -arrow.y, arrow.z)
}

#[cfg(test)]
mod tests {
    use super::super::SymmetricHalf;
    use super::*;
    use pulp::Scalar;

    use crate::kinematics::{
        Coordinates, GeometricallyExact, Inertia, Kinematics, RigidFreedom, RigidMotion, Section, Sections,
    };
    use crate::math::SquareMatrix;
    use crate::structure::test_jet::jet;

    /// In symmetric motion: the mass matrix, forces and weight, and what stations and engines do.
    fn moving(model: &ReducedModel, freedom: RigidFreedom) -> Vec<Vec<f64>> {
        let modes = model.modes.len();
        let kinematics = GeometricallyExact::new(model, &[]);
        let q: Vec<f64> = (0..modes).map(|mode| 40.0 * libm::sin(mode as f64 + 0.7)).collect();
        let at = Coordinates { q: &q, q_dot: &q };
        let mut memory = kinematics.memory();
        kinematics.evaluate(Scalar::new(), at, &mut memory);
        let sections = kinematics.sections(at, &memory);
        let mut inertia = kinematics.inertia(&model.integrals, freedom);
        inertia.deform(Scalar::new(), &sections);
        let mut matrix = SquareMatrix::new(freedom.moving(modes).len());
        inertia.write_mass_matrix(&sections, true, &mut matrix);
        let mut forces = vec![0.0; 6 + modes];
        let motion = RigidMotion { velocity: Vector3::new(1.0, 0.0, 0.1), rate: Vector3::y() * 0.3 };
        inertia.add_forces(Scalar::new(), &sections, &motion, true, &mut forces);
        inertia.add_gravity(&sections, &Vector3::new(-1.0, 0.0, 9.0), &mut forces);
        let size = matrix.size();
        let entries = (0..size).flat_map(|row| matrix.row(row)[..size].to_vec()).collect();
        let stations = sections.stations().flat_map(|station| {
            let [turning, turned] =
                [station.angular_velocity(&Vector3::y()), station.turned(&Vector3::new(0.6, 0.0, 0.8))];
            let [place, velocity] = [station.displacement(), station.velocity()];
            let back = station.turned_back(&turned);
            let acceleration = station.acceleration(&q);
            [place, velocity, turning, turned, back, acceleration]
                .map(|vector| vector.as_slice().to_vec())
                .concat()
        });
        let stations = stations.collect();
        let engines = sections.engines().flat_map(|engine| {
            let mut on_coordinates = vec![0.0; modes];
            engine.write_generalised_force(&Vector3::new(1.0, 0.0, 0.2), &mut on_coordinates);
            on_coordinates
        });
        let engines = engines.collect();
        vec![entries, forces, stations, engines]
    }

    #[test]
    fn the_half_has_the_mass_and_forces_of_the_whole_and_moves_what_hangs_on_either_side() {
        let half = SymmetricHalf::find(jet()).unwrap();
        let mirrored = half.model.stations.iter().filter(|station| station.carrier.mirrored).count();
        let left = half.model.stations.iter().filter(|station| station.position.y < 0.0).count();
        assert!(left > 0 && mirrored == left, "{mirrored} {left}");
        for freedom in [RigidFreedom::InPlane, RigidFreedom::Held] {
            let [found, expected] =
                [&half.model, &jet().select(&half.modes)].map(|model| moving(model, freedom));
            for (found, expected) in found.iter().zip(&expected) {
                let scale = largest(expected.iter().copied());
                for (place, (found, expected)) in found.iter().zip(expected).enumerate() {
                    let is_across = freedom == RigidFreedom::Held && place < 6;
                    assert!(
                        is_across || (found - expected).abs() < 1e-12 * scale,
                        "{place}: {found} {expected}"
                    );
                }
            }
        }
    }
}
