//! Eight sections side by side, displaced and turned by superposition, in space and in the mirror plane.

use std::ops::Range;

use nalgebra::Vector3;

use crate::math::{
    Arithmetic, Eight, EightVectors, LaneVector, Lanes, PlaneRotation, PlaneVector, Rotation, Window,
};
use crate::structure::{ModeShapes, ReducedStrip};

use super::super::kind::Coordinates;
use super::super::sections::{SectionMotion, SectionsInPlane, SectionsInSpace};

/// Sections of eight strips; those that a group lacks rest at O.
#[derive(Clone, Debug)]
pub struct EightSections {
    at_rest: EightVectors,
    /// Ψᵘ_x, Ψᵘ_y, Ψᵘ_z, Ψᵠ_x, Ψᵠ_y, Ψᵠ_z of each mode.
    shapes: Vec<[Eight; 6]>,
}

/// Sections in the mirror plane of strips across it.
#[derive(Clone, Debug)]
pub struct EightEdgeOn {
    /// x and z.
    at_rest: [Eight; 2],
    /// Ψᵘ_x, Ψᵘ_z, Ψᵠ_y of each mode.
    shapes: Vec<[Eight; 3]>,
}

/// Sections at an instant.
#[derive(Clone, Copy, Debug)]
pub struct Superposed<'a, T> {
    pub sections: &'a T,
    pub coordinates: Coordinates<'a>,
}

impl EightSections {
    /// Of up to eight strips with the shapes of so many modes.
    pub fn new(strips: &[ReducedStrip], modes: usize) -> Self {
        EightSections {
            at_rest: EightVectors::of(strips, |strip| strip.position, Vector3::zeros()),
            shapes: (0..modes).map(|mode| rows(strips, mode, ALL)).collect(),
        }
    }

    /// The largest of some of the rows, m or rad.
    pub fn largest(&self, rows: Range<usize>) -> f64 {
        let shapes = self.shapes.iter().flat_map(|shape| &shape[rows.clone()]).flat_map(|lanes| lanes.0);
        shapes.fold(0.0, |largest, shape| shape.abs().max(largest))
    }
}

impl EightEdgeOn {
    /// Of up to eight strips with the shapes of so many modes.
    pub fn new(strips: &[ReducedStrip], modes: usize) -> Self {
        let at_rest = |axis: usize| Eight::of(strips, |strip| strip.position[axis], 0.0);
        EightEdgeOn {
            at_rest: [at_rest(0), at_rest(2)],
            shapes: (0..modes).map(|mode| rows(strips, mode, ModeShapes::IN_PLANE)).collect(),
        }
    }
}

/// All rows of mode shapes.
const ALL: [usize; 6] = [0, 1, 2, 3, 4, 5];

/// What some rows have of a mode at each strip.
fn rows<const N: usize>(strips: &[ReducedStrip], mode: usize, rows: [usize; N]) -> [Eight; N] {
    rows.map(|row| Eight::of(strips, |strip| strip.shapes.row(row)[mode], 0.0))
}

impl Superposed<'_, EightSections> {
    /// Ψᵘq, Ψᵠq, Ψᵘq̇ and Ψᵠq̇.
    #[inline(always)]
    pub fn sums<S: Arithmetic>(&self, window: Window<S>) -> [LaneVector<S>; 4] {
        let (mut sums, mut rates) = ([window.splat(0.0); 6], [window.splat(0.0); 6]);
        let Coordinates { q, q_dot } = self.coordinates;
        for (shape, (&q, &q_dot)) in self.sections.shapes.iter().zip(q.iter().zip(q_dot)) {
            for row in 0..6 {
                let shape = window.load(&shape[row]);
                sums[row] += shape * q;
                rates[row] += shape * q_dot;
            }
        }
        let [ux, uy, uz, rx, ry, rz] = sums;
        let [vx, vy, vz, wx, wy, wz] = rates;
        [
            LaneVector { x: ux, y: uy, z: uz },
            LaneVector { x: rx, y: ry, z: rz },
            LaneVector { x: vx, y: vy, z: vz },
            LaneVector { x: wx, y: wy, z: wz },
        ]
    }
}

impl SectionsInSpace for Superposed<'_, EightSections> {
    type Turn<S: Arithmetic> = Rotation<S>;

    #[inline(always)]
    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> LaneVector<S> {
        LaneVector::load(window, &self.sections.at_rest)
    }

    #[inline(always)]
    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<LaneVector<S>, LaneVector<S>, Rotation<S>> {
        let [displacement, rotation, velocity, rate] = self.sums(window);
        let turn = Rotation::new(rotation);
        SectionMotion {
            position: SectionsInSpace::at_rest(self, window) + displacement,
            turn,
            velocity,
            rate,
            spin: rate + turn.excess_spin(&rate),
            bias: None,
        }
    }

    #[inline(always)]
    fn rows<T>(&self, all: impl Iterator<Item = T>) -> impl Iterator<Item = (&[Eight; 6], T)> {
        self.sections.shapes.iter().zip(all)
    }
}

impl SectionsInPlane for Superposed<'_, EightSections> {
    type Turn<S: Arithmetic> = PlaneRotation<S>;

    #[inline(always)]
    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> PlaneVector<S> {
        PlaneVector::load(window, [&self.sections.at_rest.x, &self.sections.at_rest.z])
    }

    #[inline(always)]
    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<PlaneVector<S>, Lanes<S>, PlaneRotation<S>> {
        let Coordinates { q, q_dot } = self.coordinates;
        let rows = SectionsInPlane::rows(self, q.iter().zip(q_dot));
        superpose_in_plane(window, SectionsInPlane::at_rest(self, window), rows)
    }

    #[inline(always)]
    fn rows<T>(&self, all: impl Iterator<Item = T>) -> impl Iterator<Item = ([&Eight; 3], T)> {
        self.sections.shapes.iter().map(|[x, _, z, _, about_y, _]| [x, z, about_y]).zip(all)
    }
}

impl SectionsInPlane for Superposed<'_, EightEdgeOn> {
    type Turn<S: Arithmetic> = PlaneRotation<S>;

    #[inline(always)]
    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> PlaneVector<S> {
        PlaneVector::load(window, self.sections.at_rest.each_ref())
    }

    #[inline(always)]
    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<PlaneVector<S>, Lanes<S>, PlaneRotation<S>> {
        let Coordinates { q, q_dot } = self.coordinates;
        superpose_in_plane(window, self.at_rest(window), self.rows(q.iter().zip(q_dot)))
    }

    #[inline(always)]
    fn rows<T>(&self, all: impl Iterator<Item = T>) -> impl Iterator<Item = ([&Eight; 3], T)> {
        self.sections.shapes.iter().map(<[Eight; 3]>::each_ref).zip(all)
    }
}

/// Where sections in the mirror plane are and how they move. They turn about a fixed axis: Ψᵠq̇ is their spin.
#[inline(always)]
fn superpose_in_plane<'a, S: Arithmetic>(
    window: Window<S>,
    at_rest: PlaneVector<S>,
    shapes: impl Iterator<Item = ([&'a Eight; 3], (&'a f64, &'a f64))>,
) -> SectionMotion<PlaneVector<S>, Lanes<S>, PlaneRotation<S>> {
    let zero = window.splat(0.0);
    let (mut x, mut z, mut turn) = (zero, zero, zero);
    let (mut x_rate, mut z_rate, mut turn_rate) = (zero, zero, zero);
    for (shape, (&q, &q_dot)) in shapes {
        let [along_x, along_z, about_y] = shape.map(|shape| window.load(shape));
        x += along_x * q;
        z += along_z * q;
        turn += about_y * q;
        x_rate += along_x * q_dot;
        z_rate += along_z * q_dot;
        turn_rate += about_y * q_dot;
    }
    SectionMotion {
        position: at_rest + PlaneVector { x, z },
        turn: PlaneRotation::new(turn),
        velocity: PlaneVector { x: x_rate, z: z_rate },
        rate: turn_rate,
        spin: turn_rate,
        bias: None,
    }
}
