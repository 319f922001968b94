//! What rigid bodies on the sections do: mass matrix, inertial forces, weight.
//!
//! [theory: geometrically-exact.inertia, kinematics.inertia, kinematics.twist]
//!
//! A coordinate moves a body as a rigid motion of the aircraft would, by the twist [J°; S] of its section about O. So the
//! mass matrix is a sum of products of twists with what the bodies' inertia makes of them.

use nalgebra::{Matrix3, Vector3};

use crate::math::{AlignedNumbers, Arithmetic, LANES, SquareMatrix, Window, zeros};
use crate::structure::RigidBody;

use super::super::freedom::RigidFreedom;
use super::super::kind::Inertia;
use super::super::rigid_motion::RigidMotion;
use super::super::velocities::GeneralisedVectorMut;
use super::instant::{GeometricallyExact, Instant};
use super::tree::Moving;

/// The inertia of the bodies on all sections.
#[derive(Clone, Debug)]
pub struct ExactInertia {
    freedom: RigidFreedom,
    present: Integrals,
    undeformed: Integrals,
    /// What the inertia of a body makes of the twists of its section: six rows over the modes.
    momenta: AlignedNumbers,
    /// Generalised forces on q.
    modal: AlignedNumbers,
}

/// The sums over the bodies.
#[derive(Clone, Debug)]
struct Integrals {
    modes: usize,
    /// m, kg.
    mass: f64,
    /// Σ m X, kg·m.
    first_moment: Vector3<f64>,
    /// Ĵ about O, kg·m².
    inertia: Matrix3<f64>,
    /// P above H: six rows over the modes.
    momenta: AlignedNumbers,
    /// M: a row for each mode, of which what stands before the group of lanes with its diagonal has no meaning.
    modal: AlignedNumbers,
}

/// A body where its section has taken it.
struct Carried {
    mass: f64,
    /// Of the centre of mass.
    moving: Moving,
    /// I, body axes.
    inertia: Matrix3<f64>,
}

impl Carried {
    #[inline(always)]
    fn new(body: &RigidBody, section: &Moving) -> Self {
        let turn = &section.turn;
        Carried {
            mass: body.mass,
            moving: section.with_offset(&body.offset),
            inertia: turn * body.inertia * turn.transpose(),
        }
    }

    /// The inertial force, and the moment about O, in a motion of the body axes that no acceleration makes.
    #[inline(always)]
    fn wrench(&self, RigidMotion { velocity, rate }: &RigidMotion, with_rates: bool) -> [Vector3<f64>; 2] {
        let Moving { position, velocity: relative, spin, acceleration, angular_acceleration, .. } =
            &self.moving;
        let mut along = rate.cross(&(velocity + rate.cross(position)));
        let (mut turning, mut about) = (*rate, Vector3::zeros());
        if with_rates {
            along += rate.cross(relative) * 2.0 + acceleration;
            turning += spin;
            about = self.inertia * (rate.cross(spin) + angular_acceleration);
        }
        about += turning.cross(&(self.inertia * turning));
        let force = along * -self.mass;
        [force, position.cross(&force) - about]
    }
}

impl ExactInertia {
    /// Of bodies on sections as they are now, which then count as undeformed.
    pub fn new<S: Arithmetic>(simd: S, modes: usize, freedom: RigidFreedom, undeformed: &Instant) -> Self {
        let width = modes.next_multiple_of(LANES);
        let none = Integrals {
            modes,
            mass: 0.0,
            first_moment: Vector3::zeros(),
            inertia: Matrix3::zeros(),
            momenta: zeros(6 * width),
            modal: zeros(modes * width),
        };
        let mut inertia = ExactInertia {
            freedom,
            present: none.clone(),
            undeformed: none,
            momenta: zeros(6 * width),
            modal: zeros(width),
        };
        inertia.present.sum(simd, undeformed, &mut inertia.momenta);
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
    fn sum<S: Arithmetic>(&mut self, simd: S, sections: &Instant, momenta: &mut [f64]) {
        let tree = sections.tree();
        self.mass = 0.0;
        (self.first_moment, self.inertia) = (Vector3::zeros(), Matrix3::zeros());
        self.momenta.fill(0.0);
        self.modal.fill(0.0);
        for (section, body) in sections.bodies() {
            let Carried { mass, moving, inertia } = Carried::new(body, &tree.sections[*section]);
            let arm = moving.position.cross_matrix();
            self.mass += mass;
            self.first_moment += moving.position * mass;
            self.inertia += inertia - arm * arm * mass;
            let twists = tree.twists.of(*section);
            write_momenta(simd, (mass, &moving.position, &inertia), twists, momenta);
            self.add_momenta(simd, momenta);
            self.add_products(simd, twists, momenta);
        }
    }

    #[inline(always)]
    fn add_momenta<S: Arithmetic>(&mut self, simd: S, momenta: &[f64]) {
        for (sum, own) in self.momenta.chunks_exact_mut(LANES).zip(momenta.chunks_exact(LANES)) {
            for window in Window::all(simd) {
                window.store_slice(sum, window.load_slice(sum) + window.load_slice(own));
            }
        }
    }

    /// Adds the products of twists and momenta to M.
    #[inline(always)]
    fn add_products<S: Arithmetic>(&mut self, simd: S, twists: &[f64], momenta: &[f64]) {
        let width = twists.len() / 6;
        for (mode, row) in self.modal.chunks_exact_mut(width.max(1)).enumerate() {
            let twist: [f64; 6] = std::array::from_fn(|component| twists[component * width + mode]);
            for first in (mode / LANES * LANES..width).step_by(LANES) {
                let sum = &mut row[first..][..LANES];
                for window in Window::all(simd) {
                    let momentum = |component: usize| {
                        window.load_slice(&momenta[component * width + first..][..LANES]) * twist[component]
                    };
                    let along = momentum(0) + momentum(1) + momentum(2);
                    let about = momentum(3) + momentum(4) + momentum(5);
                    window.store_slice(sum, window.load_slice(sum) + (along + about));
                }
            }
        }
    }

    /// Writes the mass matrix of the components that move.
    #[inline(always)]
    fn write(&self, freedom: RigidFreedom, matrix: &mut SquareMatrix) {
        let [along, about] = freedom.motions();
        let (turns, first) = (along.len(), along.len() + about.len());
        let width = self.momenta.len() / 6;
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
        for (row, component) in components.enumerate() {
            for mode in 0..self.modes {
                let momentum = self.momenta[component * width + mode];
                (matrix[(row, first + mode)], matrix[(first + mode, row)]) = (momentum, momentum);
            }
        }
        for mode in 0..self.modes {
            for other in mode..self.modes {
                let mass = self.modal[mode * width + other];
                (matrix[(first + mode, first + other)], matrix[(first + other, first + mode)]) = (mass, mass);
            }
        }
    }
}

/// Writes m J and X × m J + I S of all modes, by the twists of the section about O.
#[inline(always)]
fn write_momenta<S: Arithmetic>(
    simd: S,
    (mass, position, inertia): (f64, &Vector3<f64>, &Matrix3<f64>),
    twists: &[f64],
    momenta: &mut [f64],
) {
    let width = twists.len() / 6;
    for first in (0..width).step_by(LANES) {
        for window in Window::all(simd) {
            let load = |row: usize| window.load_slice(&twists[row * width + first..][..LANES]);
            let [x, y, z, about_x, about_y, about_z] = [0, 1, 2, 3, 4, 5].map(load);
            let momentum = [
                (x + (about_y * position.z - about_z * position.y)) * mass,
                (y + (about_z * position.x - about_x * position.z)) * mass,
                (z + (about_x * position.y - about_y * position.x)) * mass,
            ];
            for axis in 0..3 {
                let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                let turning = about_x * inertia[(axis, 0)]
                    + about_y * inertia[(axis, 1)]
                    + about_z * inertia[(axis, 2)];
                let moment = momentum[last] * position[next] - momentum[next] * position[last] + turning;
                window.store_slice(&mut momenta[axis * width + first..][..LANES], momentum[axis]);
                window.store_slice(&mut momenta[(3 + axis) * width + first..][..LANES], moment);
            }
        }
    }
}

/// Adds J°ᵀf + Sᵀg of all modes.
#[inline(always)]
fn add_generalised<S: Arithmetic>(
    simd: S,
    [force, moment]: &[Vector3<f64>; 2],
    twists: &[f64],
    modal: &mut [f64],
) {
    let width = modal.len();
    for (place, sum) in modal.chunks_exact_mut(LANES).enumerate() {
        for window in Window::all(simd) {
            let load = |row: usize| window.load_slice(&twists[row * width + place * LANES..][..LANES]);
            let along = load(0) * force.x + load(1) * force.y + load(2) * force.z;
            let about = load(3) * moment.x + load(4) * moment.y + load(5) * moment.z;
            window.store_slice(sum, window.load_slice(sum) + (along + about));
        }
    }
}

impl Inertia<GeometricallyExact> for ExactInertia {
    #[inline(always)]
    fn deform<S: Arithmetic>(&mut self, simd: S, sections: &Instant<'_>) {
        self.present.sum(simd, sections, &mut self.momenta);
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
        let tree = sections.tree();
        let mut force = GeneralisedVectorMut::of(force);
        self.modal.fill(0.0);
        for (section, body) in sections.bodies() {
            let wrench = Carried::new(body, &tree.sections[*section]).wrench(motion, with_rates);
            let [along, about] = self.counted(wrench);
            force.add_rigid(&along, &about);
            add_generalised(simd, &wrench, tree.twists.of(*section), &mut self.modal);
        }
        force.modal.iter_mut().zip(self.modal.iter()).for_each(|(force, own)| *force += own);
    }

    #[inline(always)]
    fn add_gravity(&self, _: &Instant<'_>, gravity: &Vector3<f64>, force: &mut [f64]) {
        let Integrals { mass, first_moment, momenta, .. } = &self.present;
        let mut force = GeneralisedVectorMut::of(force);
        let [along, about] = self.counted([gravity * *mass, first_moment.cross(gravity)]);
        force.add_rigid(&along, &about);
        let width = momenta.len() / 6;
        let [x, y, z] = [0, 1, 2].map(|row| &momenta[row * width..][..width]);
        for (mode, force) in force.modal.iter_mut().enumerate() {
            *force += x[mode] * gravity.x + y[mode] * gravity.y + z[mode] * gravity.z;
        }
    }
}
