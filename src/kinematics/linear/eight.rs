//! Eight sections side by side, displaced and turned by superposition, in space and in the mirror plane.

use nalgebra::Vector3;

use crate::math::{
    Arithmetic, Eight, EightVectors, LaneVector, Lanes, PlaneRotation, PlaneVector, Rotation, Window,
};
use crate::structure::{ModeShapes, ReducedStrip};

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
    pub q: &'a [f64],
    pub q_dot: &'a [f64],
}

impl EightSections {
    /// Of up to eight strips with the shapes of so many modes.
    pub fn new(strips: &[ReducedStrip], modes: usize) -> Self {
        let position = |lane: usize| strips.get(lane).map_or(Vector3::zeros(), |strip| strip.position);
        let shape = |mode: usize, row: usize| {
            lanes(strips, |ReducedStrip { shapes: ModeShapes { translation, rotation }, .. }| {
                (if row < 3 { translation } else { rotation })[row % 3 * modes + mode]
            })
        };
        EightSections {
            at_rest: EightVectors::new(std::array::from_fn(position)),
            shapes: (0..modes).map(|mode| std::array::from_fn(|row| shape(mode, row))).collect(),
        }
    }

    /// The largest displacement or rotation by a unit coordinate, m or rad.
    pub fn largest_shape(&self) -> f64 {
        let shapes = self.shapes.iter().flatten().flat_map(|lanes| lanes.0);
        shapes.fold(0.0, |largest, shape| shape.abs().max(largest))
    }
}

impl EightEdgeOn {
    /// Of up to eight strips with the shapes of so many modes.
    pub fn new(strips: &[ReducedStrip], modes: usize) -> Self {
        let shape = |mode: usize| {
            [
                lanes(strips, |strip| strip.shapes.translation[mode]),
                lanes(strips, |strip| strip.shapes.translation[2 * modes + mode]),
                lanes(strips, |strip| strip.shapes.rotation[modes + mode]),
            ]
        };
        EightEdgeOn {
            at_rest: [lanes(strips, |strip| strip.position.x), lanes(strips, |strip| strip.position.z)],
            shapes: (0..modes).map(shape).collect(),
        }
    }
}

/// A number of each strip; zero where there is none.
fn lanes(strips: &[ReducedStrip], value: impl Fn(&ReducedStrip) -> f64) -> Eight {
    Eight(std::array::from_fn(|lane| strips.get(lane).map_or(0.0, &value)))
}

impl Superposed<'_, EightSections> {
    /// Ψᵘq, Ψᵠq, Ψᵘq̇ and Ψᵠq̇.
    #[inline(always)]
    pub fn sums<S: Arithmetic>(&self, window: Window<S>) -> [LaneVector<S>; 4] {
        let (mut sums, mut rates) = ([window.splat(0.0); 6], [window.splat(0.0); 6]);
        for (shape, (&q, &q_dot)) in self.sections.shapes.iter().zip(self.q.iter().zip(self.q_dot)) {
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
    fn rows(&self) -> impl Iterator<Item = &[Eight; 6]> {
        self.sections.shapes.iter()
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
        superpose_in_plane(
            window,
            SectionsInPlane::at_rest(self, window),
            SectionsInPlane::rows(self),
            [self.q, self.q_dot],
        )
    }

    #[inline(always)]
    fn rows(&self) -> impl Iterator<Item = [&Eight; 3]> {
        self.sections.shapes.iter().map(|[x, _, z, _, about_y, _]| [x, z, about_y])
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
        superpose_in_plane(window, self.at_rest(window), self.rows(), [self.q, self.q_dot])
    }

    #[inline(always)]
    fn rows(&self) -> impl Iterator<Item = [&Eight; 3]> {
        self.sections.shapes.iter().map(<[Eight; 3]>::each_ref)
    }
}

/// Where sections in the mirror plane are and how they move. They turn about a fixed axis: Ψᵠq̇ is their spin.
#[inline(always)]
fn superpose_in_plane<'a, S: Arithmetic>(
    window: Window<S>,
    at_rest: PlaneVector<S>,
    shapes: impl Iterator<Item = [&'a Eight; 3]>,
    [q, q_dot]: [&[f64]; 2],
) -> SectionMotion<PlaneVector<S>, Lanes<S>, PlaneRotation<S>> {
    let zero = window.splat(0.0);
    let (mut x, mut z, mut turn) = (zero, zero, zero);
    let (mut x_rate, mut z_rate, mut turn_rate) = (zero, zero, zero);
    for (shape, (&q, &q_dot)) in shapes.zip(q.iter().zip(q_dot)) {
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
