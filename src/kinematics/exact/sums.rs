//! Sums over the bodies on all sections, lane by lane: what the inertia of each makes of its twists, and of products with them.
//!
//! [theory: geometrically-exact.inertia]

use nalgebra::Vector3;

use crate::math::{Arithmetic, Arrow, Eight, LaneVector, Lanes, PlaneVector, SquareMatrix, Window};

use super::bodies::{EightBodies, EightCarried, EightWrenches};
use super::in_plane;
use super::twists::EightTwists;

/// Sums of momenta and of their products with twists.
#[derive(Clone, Debug)]
pub struct ModalMass {
    modes: usize,
    /// P above H, of each mode.
    momenta: Vec<[Eight; 6]>,
    /// M: a row for each mode, of which what stands above the diagonal has no meaning.
    products: Vec<Eight>,
    /// Which of them are not always zero.
    pairs: Vec<[usize; 2]>,
}

impl ModalMass {
    /// Nothing moves; some modes move each group of eight sections.
    pub fn none<'a>(modes: usize, of_eights: impl Iterator<Item = &'a EightTwists>) -> Self {
        let mut pairs: Vec<[usize; 2]> = of_eights
            .flat_map(|twists| {
                twists.iter().flat_map(|(row, _)| twists.iter().map(|(column, _)| [*row, *column]))
            })
            .filter(|[row, column]| column <= row)
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        ModalMass {
            modes,
            momenta: vec![[Eight::ZERO; 6]; modes],
            products: vec![Eight::ZERO; modes * modes],
            pairs,
        }
    }

    /// Forgets the last sums.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.momenta.fill([Eight::ZERO; 6]);
        for &[row, column] in &self.pairs {
            self.products[row * self.modes + column] = Eight::ZERO;
        }
    }

    /// Adds what eight bodies have.
    #[inline(always)]
    pub fn add<S: Arithmetic>(
        &mut self,
        simd: S,
        bodies: (&EightBodies, &EightCarried),
        twists: &EightTwists,
    ) {
        for window in Window::all(simd) {
            let body = Body::load(window, bodies);
            for (place, (mode, twist)) in twists.iter().enumerate() {
                let momentum = body.momentum(&twist.each_ref().map(|row| window.load(row)));
                for (sum, own) in self.momenta[*mode].iter_mut().zip(momentum) {
                    window.store(sum, window.load(sum) + own);
                }
                let products = &mut self.products[mode * self.modes..][..self.modes];
                for (other, twist) in &twists[..=place] {
                    let part = |component: usize| momentum[component] * window.load(&twist[component]);
                    let product = (part(0) + part(1) + part(2)) + (part(3) + part(4) + part(5));
                    let sum = &mut products[*other];
                    window.store(sum, window.load(sum) + product);
                }
            }
        }
    }

    /// Adds what eight bodies in the mirror plane have.
    #[inline(always)]
    pub fn add_in_plane<S: Arithmetic>(
        &mut self,
        simd: S,
        (bodies, carried): (&EightBodies, &EightCarried),
        twists: &EightTwists,
    ) {
        for window in Window::all(simd) {
            let mass = window.load(&bodies.mass);
            let moment = in_plane::load(window, &carried.first_moment);
            let inertia = window.load(&carried.about_origin[1]);
            let load = |[x, _, z, _, about_y, _]: &[Eight; 6]| {
                (PlaneVector::load(window, [x, z]), window.load(about_y))
            };
            for (place, (mode, twist)) in twists.iter().enumerate() {
                let (along, about) = load(twist);
                let momentum = along * mass + moment.turned_by(about);
                let turning = moment.cross(&along) + inertia * about;
                let [x, _, z, _, about_y, _] = &mut self.momenta[*mode];
                for (sum, own) in [(x, momentum.x), (z, momentum.z), (about_y, turning)] {
                    window.store(sum, window.load(sum) + own);
                }
                let products = &mut self.products[mode * self.modes..][..self.modes];
                for (other, twist) in &twists[..=place] {
                    let (along, about) = load(twist);
                    let sum = &mut products[*other];
                    window.store(sum, window.load(sum) + (momentum.dot(&along) + turning * about));
                }
            }
        }
    }

    /// Writes the rows of some components of the rigid motion, and M, whose first row and column are given.
    #[inline(always)]
    pub fn write(&self, components: impl Iterator<Item = usize>, first: usize, matrix: &mut SquareMatrix) {
        for (row, component) in components.enumerate() {
            for (mode, momenta) in self.momenta.iter().enumerate() {
                let momentum = momenta[component].sum();
                (matrix[(row, first + mode)], matrix[(first + mode, row)]) = (momentum, momentum);
            }
        }
        for mode in 0..self.modes {
            matrix.row_mut(first + mode)[first..][..self.modes].fill(0.0);
        }
        for &[mode, other] in &self.pairs {
            let mass = self.products[mode * self.modes + other].sum();
            matrix[(first + mode, first + other)] = mass;
            matrix[(first + other, first + mode)] = mass;
        }
    }

    /// Adds the forces of gravity on the coordinates.
    #[inline(always)]
    pub fn add_weight(&self, gravity: &Vector3<f64>, modal: &mut [f64]) {
        for ([x, y, z, ..], force) in self.momenta.iter().zip(modal) {
            *force += x.sum() * gravity.x + y.sum() * gravity.y + z.sum() * gravity.z;
        }
    }
}

/// m, m X and Ĵ of bodies.
struct Body<S: Arithmetic> {
    mass: Lanes<S>,
    moment: LaneVector<S>,
    inertia: [Lanes<S>; 6],
}

impl<S: Arithmetic> Body<S> {
    #[inline(always)]
    fn load(window: Window<S>, (bodies, carried): (&EightBodies, &EightCarried)) -> Self {
        Body {
            mass: window.load(&bodies.mass),
            moment: LaneVector::load(window, &carried.first_moment),
            inertia: carried.about_origin.each_ref().map(|entry| window.load(entry)),
        }
    }

    /// m J and X × m J + I S by the twists about O.
    #[inline(always)]
    fn momentum(&self, [x, y, z, about_x, about_y, about_z]: &[Lanes<S>; 6]) -> [Lanes<S>; 6] {
        let along = LaneVector { x: *x, y: *y, z: *z };
        let about = LaneVector { x: *about_x, y: *about_y, z: *about_z };
        let momentum = along * self.mass + about.cross(&self.moment);
        let turning = self.moment.cross(&along) + super::bodies::symmetric_times(&self.inertia, &about);
        [momentum.x, momentum.y, momentum.z, turning.x, turning.y, turning.z]
    }
}

/// Adds what eight wrenches do on each coordinate.
#[inline(always)]
pub fn add_generalised<S: Arithmetic>(
    simd: S,
    EightWrenches { force, moment }: &EightWrenches,
    twists: &EightTwists,
    forces: &mut [Eight],
) {
    for window in Window::all(simd) {
        let (force, moment) = (LaneVector::load(window, force), LaneVector::load(window, moment));
        for (mode, twist) in twists {
            let [x, y, z, about_x, about_y, about_z] = twist.each_ref().map(|row| window.load(row));
            let along = force.dot(&LaneVector { x, y, z });
            let about = moment.dot(&LaneVector { x: about_x, y: about_y, z: about_z });
            let sum = &mut forces[*mode];
            window.store(sum, window.load(sum) + (along + about));
        }
    }
}

/// The same in the mirror plane.
#[inline(always)]
pub fn add_generalised_in_plane<S: Arithmetic>(
    simd: S,
    EightWrenches { force, moment }: &EightWrenches,
    twists: &EightTwists,
    forces: &mut [Eight],
) {
    for window in Window::all(simd) {
        let (force, moment) = (in_plane::load(window, force), window.load(&moment.y));
        for (mode, [x, _, z, _, about_y, _]) in twists {
            let along = force.dot(&PlaneVector::load(window, [x, z]));
            let sum = &mut forces[*mode];
            window.store(sum, window.load(sum) + (along + moment * window.load(about_y)));
        }
    }
}
