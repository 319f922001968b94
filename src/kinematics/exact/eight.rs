//! The sections of eight strips side by side, gathered from the tree.
//!
//! [theory: geometrically-exact.air, kinematics.rows]

use nalgebra::Vector3;

use crate::math::{
    Arithmetic, Eight, EightVectors, LANES, LaneVector, Lanes, PlaneRotation, PlaneVector, Window,
};
use crate::structure::ReducedStrip;

use super::super::sections::{Bias, SectionMotion, SectionsInPlane, SectionsInSpace, Turn};
use super::tree::{Moving, MovingTree};

/// Where eight strips hang; those that a group lacks rest at O.
#[derive(Clone, Debug)]
pub struct EightStrips {
    sections: [usize; LANES],
    at_rest: EightVectors,
}

/// What an evaluation writes of their sections.
#[derive(Clone, Debug)]
pub struct EightSections {
    at_rest: EightVectors,
    position: EightVectors,
    /// Columns of R.
    turn: [EightVectors; 3],
    velocity: EightVectors,
    spin: EightVectors,
    acceleration: EightVectors,
    angular_acceleration: EightVectors,
    /// J and S of each mode.
    rows: Vec<[Eight; 6]>,
}

/// R of eight sections.
pub struct LaneTurn<S: Arithmetic> {
    columns: [LaneVector<S>; 3],
}

impl<S: Arithmetic> Turn<LaneVector<S>> for LaneTurn<S> {
    #[inline(always)]
    fn apply(&self, vectors: &LaneVector<S>) -> LaneVector<S> {
        let [x, y, z] = self.columns;
        x * vectors.x + y * vectors.y + z * vectors.z
    }
}

impl EightStrips {
    /// Of up to eight strips; `place` says where a section stands in the tree.
    pub fn new(strips: &[ReducedStrip], place: impl Fn(usize) -> usize) -> Self {
        EightStrips {
            sections: std::array::from_fn(|lane| strips.get(lane).map_or(0, |strip| place(strip.section))),
            at_rest: EightVectors::of(strips, |strip| strip.position, Vector3::zeros()),
        }
    }

    /// Room for an evaluation.
    pub fn resting(&self, modes: usize) -> EightSections {
        let none = EightVectors::new([Vector3::zeros(); LANES]);
        EightSections {
            at_rest: self.at_rest,
            position: none,
            turn: [none; 3],
            velocity: none,
            spin: none,
            acceleration: none,
            angular_acceleration: none,
            rows: vec![[Eight::ZERO; 6]; modes],
        }
    }

    /// Gathers the sections from an evaluated tree.
    #[inline(always)]
    pub fn write<S: Arithmetic>(&self, simd: S, tree: &MovingTree, written: &mut EightSections) {
        for (lane, &section) in self.sections.iter().enumerate() {
            let Moving { turn, position, velocity, spin, acceleration, angular_acceleration } =
                &tree.sections[section];
            set(&mut written.position, lane, position);
            set(&mut written.velocity, lane, velocity);
            set(&mut written.spin, lane, spin);
            set(&mut written.acceleration, lane, acceleration);
            set(&mut written.angular_acceleration, lane, angular_acceleration);
            for (axis, column) in written.turn.iter_mut().enumerate() {
                set(column, lane, &turn.column(axis).into_owned());
            }
            let width = tree.twists.width();
            let twists = tree.twists.of(section);
            for (mode, rows) in written.rows.iter_mut().enumerate() {
                for (row, eight) in rows.iter_mut().enumerate() {
                    eight.0[lane] = twists[row * width + mode];
                }
            }
        }
        for rows in &mut written.rows {
            for window in Window::all(simd) {
                let [x, y, z, about_x, about_y, about_z] = rows.each_ref().map(|row| window.load(row));
                let turning = LaneVector { x: about_x, y: about_y, z: about_z };
                // J = J° + S × X.
                let moved =
                    LaneVector { x, y, z } + turning.cross(&LaneVector::load(window, &written.position));
                for (axis, row) in rows[..3].iter_mut().enumerate() {
                    window.store(row, moved.component(axis));
                }
            }
        }
    }
}

#[inline(always)]
fn set(vectors: &mut EightVectors, lane: usize, vector: &Vector3<f64>) {
    (vectors.x.0[lane], vectors.y.0[lane], vectors.z.0[lane]) = (vector.x, vector.y, vector.z);
}

impl EightSections {
    /// How far each section is from where it is at rest.
    pub fn displacements(&self) -> impl Iterator<Item = Vector3<f64>> {
        let at = |vectors: &EightVectors, lane: usize| {
            Vector3::new(vectors.x.0[lane], vectors.y.0[lane], vectors.z.0[lane])
        };
        (0..LANES).map(move |lane| at(&self.position, lane) - at(&self.at_rest, lane))
    }
}

impl SectionsInSpace for &EightSections {
    type Turn<S: Arithmetic> = LaneTurn<S>;

    #[inline(always)]
    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> LaneVector<S> {
        LaneVector::load(window, &self.at_rest)
    }

    #[inline(always)]
    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<LaneVector<S>, LaneVector<S>, LaneTurn<S>> {
        let load = |vectors: &EightVectors| LaneVector::load(window, vectors);
        SectionMotion {
            position: load(&self.position),
            turn: LaneTurn { columns: self.turn.each_ref().map(load) },
            velocity: load(&self.velocity),
            rate: load(&self.spin),
            spin: load(&self.spin),
            bias: Some(Bias {
                acceleration: load(&self.acceleration),
                angular_acceleration: load(&self.angular_acceleration),
            }),
        }
    }

    #[inline(always)]
    fn rows(&self) -> impl Iterator<Item = &[Eight; 6]> {
        self.rows.iter()
    }
}

/// x and z.
#[inline(always)]
fn in_plane<S: Arithmetic>(window: Window<S>, vectors: &EightVectors) -> PlaneVector<S> {
    PlaneVector::load(window, [&vectors.x, &vectors.z])
}

impl SectionsInPlane for &EightSections {
    type Turn<S: Arithmetic> = PlaneRotation<S>;

    #[inline(always)]
    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> PlaneVector<S> {
        in_plane(window, &self.at_rest)
    }

    #[inline(always)]
    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<PlaneVector<S>, Lanes<S>, PlaneRotation<S>> {
        let [_, _, z_axis] = &self.turn;
        SectionMotion {
            position: in_plane(window, &self.position),
            // The z axis turned about y is along [sin θ, cos θ].
            turn: PlaneRotation::to(in_plane(window, z_axis)),
            velocity: in_plane(window, &self.velocity),
            rate: window.load(&self.spin.y),
            spin: window.load(&self.spin.y),
            bias: Some(Bias {
                acceleration: in_plane(window, &self.acceleration),
                angular_acceleration: window.load(&self.angular_acceleration.y),
            }),
        }
    }

    #[inline(always)]
    fn rows(&self) -> impl Iterator<Item = [&Eight; 3]> {
        self.rows.iter().map(|[x, _, z, _, about_y, _]| [x, z, about_y])
    }
}
