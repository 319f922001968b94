//! From O outward: where all sections are, how they move, and their twists by each generalised coordinate.
//!
//! [theory: geometrically-exact.recursion, geometrically-exact.rates, geometrically-exact.biases, geometrically-exact.twists]
//!
//! Velocities and biases add up without what the motion of the section before does at a distance if they are taken about O,
//! as twists.

use nalgebra::Vector3;

use crate::math::{Arithmetic, EightVectors, LANES, LaneVector, Window};
use crate::structure::{BeamSection, ModeShapes};

use super::super::kind::Coordinates;
use super::helix::{EightConstants, EightHelices};
use super::in_plane;
use super::moving::{EightMoving, Moving, add_up};
use super::strands::{Part, Strands};
use super::twists::{self, EightTwists, write_steps};

/// What of the sections is constant.
#[derive(Clone, Debug)]
pub struct Tree {
    order: Strands,
    constants: Vec<EightConstants>,
}

/// All sections at an instant.
#[derive(Clone, Debug)]
pub struct MovingTree {
    /// Of the eight at work.
    helices: EightHelices,
    /// Eight by eight.
    pub eights: Vec<EightMoving>,
    /// By each coordinate that moves them.
    pub twists: Vec<EightTwists>,
}

impl Tree {
    /// Of sections, each after its parent, with the shapes of so many modes.
    pub fn new(sections: &[&BeamSection], parents: &[usize], modes: usize) -> Self {
        let order = Strands::new(sections, parents, modes);
        let with_arm = |section: &Option<usize>| {
            let section = (*section)?;
            // O's own section is reached from the origin.
            let before = if section == 0 { Vector3::zeros() } else { sections[parents[section]].position };
            Some((sections[section], sections[section].position - before))
        };
        let placed: Vec<_> = order.sections.iter().map(with_arm).collect();
        let constants = placed.chunks(LANES).enumerate().map(|(eight, sections)| {
            let moves = |mode: usize, lane: usize| {
                order.modes_at(eight * LANES + lane).iter().any(|(moved, _)| *moved == mode)
            };
            EightConstants::new(sections, order.modes_of_eight(eight), moves)
        });
        Tree { constants: constants.collect(), order }
    }

    /// In which order sections are evaluated.
    pub fn order(&self) -> &Strands {
        &self.order
    }

    /// Room for an evaluation.
    pub fn at_rest(&self) -> MovingTree {
        MovingTree {
            helices: EightHelices::resting(),
            eights: vec![EightMoving::resting(); self.order.eights()],
            twists: self.constants.iter().map(|constants| twists::none(&constants.steps)).collect(),
        }
    }

    /// Writes all sections at some q and q̇.
    #[inline(always)]
    pub fn write<S: Arithmetic>(&self, simd: S, at: Coordinates, moving: &mut MovingTree) {
        for index in 0..self.constants.len() {
            if index < self.order.in_plane {
                self.write_eight_in_plane(simd, at, index, moving);
            } else {
                self.write_eight(simd, at, index, moving);
            }
        }
    }

    /// Writes a group of eight sections, all at once, so that what is between stays close at hand.
    #[inline(always)]
    fn write_eight<S: Arithmetic>(&self, simd: S, at: Coordinates, index: usize, moving: &mut MovingTree) {
        let MovingTree { helices, eights, twists } = moving;
        let (constants, parts) = (&self.constants[index], &self.order.parts[index]);
        constants.write(simd, at, helices, &mut eights[index].quaternion);
        for part in parts {
            turn_along(part, eights, index, helices);
        }
        helices.unroll(simd, &mut eights[index]);
        for part in parts {
            add_up(part, eights, index, |EightMoving { position: x, spin, .. }| {
                [&mut x.x, &mut x.y, &mut x.z, &mut spin.x, &mut spin.y, &mut spin.z]
            });
        }
        eights[index].carry(simd, (constants, helices), &mut twists[index]);
        for part in parts {
            twists::add_up(part, [0, 1, 2, 3, 4, 5], twists, index);
            add_up(part, eights, index, |moving| {
                let EightMoving {
                    velocity_about_origin: w,
                    acceleration_about_origin: a,
                    angular_acceleration: alpha,
                    ..
                } = moving;
                let [[w_x, w_y, w_z], [a_x, a_y, a_z]] = [w, a].map(|EightVectors { x, y, z }| [x, y, z]);
                [w_x, w_y, w_z, a_x, a_y, a_z, &mut alpha.x, &mut alpha.y, &mut alpha.z]
            });
        }
        eights[index].settle(simd);
    }

    /// The same of sections that stay in the mirror plane.
    #[inline(always)]
    fn write_eight_in_plane<S: Arithmetic>(
        &self,
        simd: S,
        at: Coordinates,
        index: usize,
        moving: &mut MovingTree,
    ) {
        let MovingTree { helices, eights, twists } = moving;
        let (constants, parts) = (&self.constants[index], &self.order.parts[index]);
        constants.write_in_plane(simd, at, helices, &mut eights[index].quaternion);
        for part in parts {
            in_plane::turn_along(part, eights, index, helices);
        }
        helices.unroll_in_plane(simd, &mut eights[index]);
        for part in parts {
            in_plane::add_positions(part, eights, index);
        }
        eights[index].carry_in_plane(simd, (constants, helices), &mut twists[index]);
        for part in parts {
            twists::add_up(part, ModeShapes::IN_PLANE, twists, index);
            in_plane::add_motion(part, eights, index);
        }
        eights[index].settle_in_plane(simd);
    }
}

/// Turns each section of a part by all turns before it.
#[inline(always)]
fn turn_along(part: &Part, eights: &mut [EightMoving], index: usize, helices: &mut EightHelices) {
    let [eight, lane] = part.parent;
    let mut before = eights[eight].quaternion.each_ref().map(|part| part.0[lane]);
    let turn = &mut eights[index].quaternion;
    for lane in part.lanes.clone().map(|lane| lane % LANES) {
        let [w, x, y, z] = before;
        let [own_w, own_x, own_y, own_z] = turn.each_ref().map(|part| part.0[lane]);
        let turned = [
            (w * own_w - x * own_x) - (y * own_y + z * own_z),
            (w * own_x + x * own_w) + (y * own_z - z * own_y),
            (w * own_y + y * own_w) + (z * own_x - x * own_z),
            (w * own_z + z * own_w) + (x * own_y - y * own_x),
        ];
        for part in 0..4 {
            helices.turn_before[part].0[lane] = before[part];
            turn[part].0[lane] = turned[part];
        }
        before = turned;
    }
}

impl EightMoving {
    /// As soon as x and σ are known: what each section adds to the twists by each coordinate, to those of w and a about O, and
    /// to α.
    #[inline(always)]
    pub fn carry<S: Arithmetic>(
        &mut self,
        simd: S,
        (constants, helices): (&EightConstants, &EightHelices),
        twists: &mut EightTwists,
    ) {
        for window in Window::all(simd) {
            let load = |vectors: &EightVectors| LaneVector::load(window, vectors);
            let (position, turning) = (load(&self.position), load(&helices.turning));
            let tangent = helices.tangent.each_ref().map(load);
            let bend = [
                load(&helices.bend[0]) + position.cross(&tangent[0]),
                load(&helices.bend[1]) + position.cross(&tangent[1]),
                load(&helices.bend[2]) + position.cross(&tangent[2]),
            ];
            write_steps(window, &constants.steps, [&tangent, &bend], twists);
            let stretching = load(&self.velocity);
            (stretching + position.cross(&turning)).store(window, &mut self.velocity_about_origin);
            let spin_before = load(&self.spin) - turning;
            let added = load(&self.angular_acceleration) + spin_before.cross(&turning);
            added.store(window, &mut self.angular_acceleration);
            let circling = spin_before.cross(&load(&helices.distance)) + stretching * window.splat(2.0);
            let bias = load(&self.acceleration) + position.cross(&added) + spin_before.cross(&circling);
            bias.store(window, &mut self.acceleration_about_origin);
        }
    }

    /// Turns twists about O into w and a at the sections.
    #[inline(always)]
    pub fn settle<S: Arithmetic>(&mut self, simd: S) {
        for window in Window::all(simd) {
            let load = |vectors: &EightVectors| LaneVector::load(window, vectors);
            let position = load(&self.position);
            let velocity = load(&self.velocity_about_origin) + load(&self.spin).cross(&position);
            velocity.store(window, &mut self.velocity);
            let acceleration =
                load(&self.acceleration_about_origin) + load(&self.angular_acceleration).cross(&position);
            acceleration.store(window, &mut self.acceleration);
        }
    }
}

impl MovingTree {
    /// The section at a place.
    pub fn section(&self, place: usize) -> Moving {
        self.eights[place / LANES].single(place % LANES)
    }
}
