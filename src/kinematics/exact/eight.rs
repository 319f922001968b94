//! The sections of eight strips side by side, gathered from the tree.
//!
//! [theory: geometrically-exact.air, kinematics.rows]

use nalgebra::Vector3;

use crate::math::{
    Arithmetic, Eight, EightVectors, LANES, LaneVector, Lanes, PlaneRotation, PlaneVector, Window,
};
use crate::structure::{ModeShapes, ReducedStrip};

use super::super::sections::{Bias, SectionMotion, SectionsInPlane, SectionsInSpace, Turn};
use super::moving::EightMoving;
use super::strands::Strands;
use super::tree::MovingTree;
use super::twists::EightTwists;

/// Where eight strips hang; those that a group lacks rest at O.
#[derive(Clone, Debug)]
pub struct EightStrips {
    lanes: Vec<LaneOfStrip>,
    at_rest: EightVectors,
    /// Of each mode the row that there is for it if it moves any of them.
    rows: Vec<Option<usize>>,
    /// Whether all of them stay in the mirror plane.
    in_plane: bool,
    /// The group of sections that they are, strip by strip, if they are one.
    same: Option<usize>,
}

/// Where a strip hangs.
#[derive(Clone, Debug)]
struct LaneOfStrip {
    place: usize,
    /// Of the modes that move it the rows here and in its section's group.
    rows: Vec<[usize; 2]>,
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
    /// Of each mode its row, if it moves them.
    row_of: Vec<Option<usize>>,
    /// J and S.
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
    /// Of up to eight strips that hang at some places.
    pub fn new(strips: &[ReducedStrip], places: &[usize], order: &Strands, modes: usize) -> Self {
        let moved = |mode: usize| {
            places.iter().any(|&place| order.modes_at(place).iter().any(|(moved, _)| *moved == mode))
        };
        let mut count = 0;
        let row = |mode: usize| {
            moved(mode).then(|| {
                count += 1;
                count - 1
            })
        };
        let rows: Vec<Option<usize>> = (0..modes).map(row).collect();
        let lane = |&place: &usize| LaneOfStrip {
            place,
            rows: order.modes_at(place).iter().filter_map(|&(mode, row)| Some([rows[mode]?, row])).collect(),
        };
        EightStrips {
            lanes: places.iter().map(lane).collect(),
            at_rest: EightVectors::of(strips, |strip| strip.position, Vector3::zeros()),
            rows,
            in_plane: places.iter().all(|&place| place / LANES < order.in_plane),
            same: places.chunks_exact(LANES).next().and_then(|places| {
                let first = places[0];
                let is_group = first % LANES == 0 && places.iter().copied().eq(first..first + LANES);
                is_group.then_some(first / LANES)
            }),
        }
    }

    /// Room for an evaluation.
    pub fn resting(&self) -> EightSections {
        let of = |vector: Vector3<f64>| EightVectors::new([vector; LANES]);
        let none = of(Vector3::zeros());
        EightSections {
            at_rest: self.at_rest,
            position: none,
            turn: [Vector3::x(), Vector3::y(), Vector3::z()].map(of),
            velocity: none,
            spin: none,
            acceleration: none,
            angular_acceleration: none,
            row_of: self.rows.clone(),
            rows: vec![[Eight::ZERO; 6]; self.rows.iter().flatten().count()],
        }
    }

    /// Gathers the sections from an evaluated tree.
    #[inline(always)]
    pub fn write<S: Arithmetic>(&self, simd: S, tree: &MovingTree, written: &mut EightSections) {
        if self.in_plane {
            self.write_in_plane(simd, tree, written);
            return;
        }
        match self.same {
            Some(group) => written.copy(&tree.eights[group], &tree.twists[group]),
            None => self.gather(tree, written),
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

    /// Gathers sections from wherever they stand.
    #[inline(always)]
    fn gather(&self, tree: &MovingTree, written: &mut EightSections) {
        for (lane, LaneOfStrip { place, rows }) in self.lanes.iter().enumerate() {
            let (moving, from) = (&tree.eights[place / LANES], place % LANES);
            let copy = |to: &mut EightVectors, vectors: &EightVectors| {
                to.x.0[lane] = vectors.x.0[from];
                to.y.0[lane] = vectors.y.0[from];
                to.z.0[lane] = vectors.z.0[from];
            };
            copy(&mut written.position, &moving.position);
            copy(&mut written.velocity, &moving.velocity);
            copy(&mut written.spin, &moving.spin);
            copy(&mut written.acceleration, &moving.acceleration);
            copy(&mut written.angular_acceleration, &moving.angular_acceleration);
            for (to, column) in written.turn.iter_mut().zip(&moving.turn) {
                copy(to, column);
            }
            let twists = &tree.twists[place / LANES];
            for &[row, of_group] in rows {
                for (eight, twist) in written.rows[row].iter_mut().zip(&twists[of_group].1) {
                    eight.0[lane] = twist.0[from];
                }
            }
        }
    }
}

impl EightStrips {
    /// The same of sections that stay in the mirror plane.
    #[inline(always)]
    fn write_in_plane<S: Arithmetic>(&self, simd: S, tree: &MovingTree, written: &mut EightSections) {
        for (lane, LaneOfStrip { place, rows }) in self.lanes.iter().enumerate() {
            let (moving, from) = (&tree.eights[place / LANES], place % LANES);
            let copy = |to: &mut EightVectors, vectors: &EightVectors| {
                to.x.0[lane] = vectors.x.0[from];
                to.z.0[lane] = vectors.z.0[from];
            };
            copy(&mut written.position, &moving.position);
            copy(&mut written.velocity, &moving.velocity);
            copy(&mut written.acceleration, &moving.acceleration);
            copy(&mut written.turn[0], &moving.turn[0]);
            copy(&mut written.turn[2], &moving.turn[2]);
            written.spin.y.0[lane] = moving.spin.y.0[from];
            let twists = &tree.twists[place / LANES];
            for &[row, of_group] in rows {
                let (_, twists) = &twists[of_group];
                for component in ModeShapes::IN_PLANE {
                    written.rows[row][component].0[lane] = twists[component].0[from];
                }
            }
        }
        for [x, _, z, _, about_y, _] in &mut written.rows {
            for window in Window::all(simd) {
                let turned = in_plane(window, &written.position).turned_by(window.load(about_y));
                window.store(x, window.load(x) + turned.x);
                window.store(z, window.load(z) + turned.z);
            }
        }
    }
}

impl EightSections {
    /// Copies a group of sections, of which each has its strip.
    #[inline(always)]
    fn copy(&mut self, moving: &EightMoving, twists: &EightTwists) {
        let EightMoving { turn, position, velocity, spin, acceleration, angular_acceleration, .. } = moving;
        (self.turn, self.position, self.velocity, self.spin) = (*turn, *position, *velocity, *spin);
        (self.acceleration, self.angular_acceleration) = (*acceleration, *angular_acceleration);
        for (rows, (_, twists)) in self.rows.iter_mut().zip(twists) {
            *rows = *twists;
        }
    }

    /// How far each section is from where it is at rest.
    pub fn displacements(&self) -> impl Iterator<Item = Vector3<f64>> {
        (0..LANES).map(|lane| self.position.of_lane(lane) - self.at_rest.of_lane(lane))
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
    fn rows<T>(&self, all: impl Iterator<Item = T>) -> impl Iterator<Item = (&[Eight; 6], T)> {
        self.row_of.iter().zip(all).filter_map(|(row, own)| Some((&self.rows[(*row)?], own)))
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
    fn rows<T>(&self, all: impl Iterator<Item = T>) -> impl Iterator<Item = ([&Eight; 3], T)> {
        SectionsInSpace::rows(self, all).map(|([x, _, z, _, about_y, _], own)| ([x, z, about_y], own))
    }
}
