//! What rigid bodies on the sections do: mass matrix, inertial forces, weight.
//!
//! [theory: geometrically-exact.inertia, kinematics.inertia, kinematics.twist]
//!
//! A coordinate moves a body as a rigid motion of the aircraft would, by the twist [J°; S] of its section about O. So the
//! mass matrix is a sum of products of twists with what the bodies' inertia makes of them.

use nalgebra::{Matrix3, Vector3};

use crate::math::{Arithmetic, Eight, EightVectors, LANES, SquareMatrix};

use super::super::freedom::RigidFreedom;
use super::super::kind::Inertia;
use super::super::rigid_motion::RigidMotion;
use super::super::velocities::GeneralisedVectorMut;
use super::bodies::{EightCarried, EightWrenches};
use super::instant::{GeometricallyExact, Instant};
use super::sums::{ModalMass, add_generalised, add_generalised_in_plane};

/// The inertia of the bodies on all sections.
#[derive(Clone, Debug)]
pub struct ExactInertia {
    freedom: RigidFreedom,
    present: Integrals,
    undeformed: Integrals,
    carried: Vec<EightCarried>,
    wrenches: EightWrenches,
    /// Generalised forces on the coordinates.
    modal: Vec<Eight>,
}

/// The sums over the bodies.
#[derive(Clone, Debug)]
struct Integrals {
    /// m, kg.
    mass: f64,
    /// Σ m X, kg·m.
    first_moment: Vector3<f64>,
    /// Ĵ about O, kg·m².
    inertia: Matrix3<f64>,
    modal: ModalMass,
}

impl ExactInertia {
    /// Of bodies on sections as they are now, which then count as undeformed.
    pub fn new<S: Arithmetic>(simd: S, modes: usize, freedom: RigidFreedom, undeformed: &Instant) -> Self {
        let eights = undeformed.tree().eights.len();
        let none = Integrals {
            mass: undeformed.bodies().mass,
            first_moment: Vector3::zeros(),
            inertia: Matrix3::zeros(),
            modal: ModalMass::none(modes, undeformed.tree().twists.iter()),
        };
        let mut inertia = ExactInertia {
            freedom,
            present: none.clone(),
            undeformed: none,
            carried: vec![EightCarried::none(); eights],
            wrenches: EightWrenches::none(),
            modal: vec![Eight::ZERO; modes],
        };
        inertia.present.sum(simd, (undeformed, freedom), &mut inertia.carried);
        inertia.undeformed = inertia.present.clone();
        inertia
    }

    /// What counts of a force and of a moment on the rigid motion: across the mirror plane what the other side does cancels them.
    #[inline(always)]
    fn counted(&self, [mut force, mut moment]: [Vector3<f64>; 2]) -> [Vector3<f64>; 2] {
        if self.freedom == RigidFreedom::InPlane {
            (force.y, moment.x, moment.z) = (0.0, 0.0, 0.0);
        }
        [force, moment]
    }
}

impl Integrals {
    /// Sums over all bodies.
    #[inline(always)]
    fn sum<S: Arithmetic>(
        &mut self,
        simd: S,
        (sections, freedom): (&Instant, RigidFreedom),
        carried: &mut [EightCarried],
    ) {
        let (tree, bodies, in_plane) = (sections.tree(), sections.bodies(), in_plane(sections, freedom));
        let none = EightVectors::new([Vector3::zeros(); LANES]);
        let (mut first_moment, mut inertia) = (none, [Eight::ZERO; 6]);
        self.modal.clear();
        for (index, eight) in &bodies.eights {
            let (moving, twists, carried) =
                (&tree.eights[*index], &tree.twists[*index], &mut carried[*index]);
            let sums = (&mut first_moment, &mut inertia);
            if *index < in_plane {
                eight.carry_in_plane(simd, moving, carried, sums);
                self.modal.add_in_plane(simd, (eight, carried), twists);
            } else {
                eight.carry(simd, moving, carried, sums);
                self.modal.add(simd, (eight, carried), twists);
            }
        }
        self.first_moment = first_moment.sum();
        let [xx, yy, zz, yz, zx, xy] = inertia.map(|entry| entry.sum());
        self.inertia = Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz);
    }

    /// Writes the mass matrix of the components that move.
    #[inline(always)]
    fn write(&self, freedom: RigidFreedom, matrix: &mut SquareMatrix) {
        let [along, about] = freedom.motions();
        let (turns, first) = (along.len(), along.len() + about.len());
        for (row, &axis) in along.iter().enumerate() {
            for column in 0..along.len() {
                matrix[(row, column)] = if row == column { self.mass } else { 0.0 };
            }
            for (column, &turn) in (turns..).zip(about) {
                let momentum = Vector3::ith(turn, 1.0).cross(&self.first_moment)[axis];
                (matrix[(row, column)], matrix[(column, row)]) = (momentum, momentum);
            }
        }
        for (row, &axis) in (turns..).zip(about) {
            for (column, &other) in (turns..).zip(about) {
                matrix[(row, column)] = self.inertia[(axis, other)];
            }
        }
        let components = along.iter().copied().chain(about.iter().map(|axis| 3 + axis));
        self.modal.write(components, first, matrix);
    }
}

/// How many groups of sections, the first, have bodies that move in the mirror plane, as the aircraft does.
#[inline(always)]
fn in_plane(sections: &Instant, freedom: RigidFreedom) -> usize {
    if freedom == RigidFreedom::InPlane { sections.bodies().in_plane } else { 0 }
}

impl Inertia<GeometricallyExact> for ExactInertia {
    #[inline(always)]
    fn deform<S: Arithmetic>(&mut self, simd: S, sections: &Instant<'_>) {
        self.present.sum(simd, (sections, self.freedom), &mut self.carried);
    }

    #[inline(always)]
    fn write_mass_matrix(&self, _: &Instant<'_>, deformed: bool, matrix: &mut SquareMatrix) {
        let integrals = if deformed { &self.present } else { &self.undeformed };
        integrals.write(self.freedom, matrix);
    }

    #[inline(always)]
    fn add_forces<S: Arithmetic>(
        &mut self,
        simd: S,
        sections: &Instant<'_>,
        motion: &RigidMotion,
        with_rates: bool,
        force: &mut [f64],
    ) {
        let (tree, bodies, in_plane) = (sections.tree(), sections.bodies(), in_plane(sections, self.freedom));
        let mut sums = EightWrenches::none();
        self.modal.fill(Eight::ZERO);
        for (index, eight) in &bodies.eights {
            let (at, motion) = ((&tree.eights[*index], &self.carried[*index]), (motion, with_rates));
            let (twists, wrenches) = (&tree.twists[*index], &mut self.wrenches);
            if *index < in_plane {
                eight.write_wrenches_in_plane(simd, at, motion, wrenches, &mut sums);
                add_generalised_in_plane(simd, wrenches, twists, &mut self.modal);
            } else {
                eight.write_wrenches(simd, at, motion, wrenches, &mut sums);
                add_generalised(simd, wrenches, twists, &mut self.modal);
            }
        }
        let mut force = GeneralisedVectorMut::of(force);
        let [along, about] = self.counted([sums.force.sum(), sums.moment.sum()]);
        force.add_rigid(&along, &about);
        force.modal.iter_mut().zip(&self.modal).for_each(|(force, own)| *force += own.sum());
    }

    #[inline(always)]
    fn add_gravity(&self, _: &Instant<'_>, gravity: &Vector3<f64>, force: &mut [f64]) {
        let Integrals { mass, first_moment, modal, .. } = &self.present;
        let mut force = GeneralisedVectorMut::of(force);
        let [along, about] = self.counted([gravity * *mass, first_moment.cross(gravity)]);
        force.add_rigid(&along, &about);
        modal.add_weight(gravity, force.modal);
    }
}
