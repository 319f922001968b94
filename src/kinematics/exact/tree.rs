//! From O outward: where all sections are, how they move, and their twists by each generalised coordinate.
//!
//! [theory: geometrically-exact.recursion, geometrically-exact.rates, geometrically-exact.biases, geometrically-exact.jacobians]

use nalgebra::Vector3;

use crate::math::{Arithmetic, Eight, EightVectors, LANES};
use crate::structure::{BeamSection, ModeShapes};

use super::super::kind::Coordinates;
use super::helix::{EightConstants, EightHelices};
use super::in_plane;
use super::moving::{EightMoving, Moving};
use super::strands::{Part, Strand, Strands};
use super::twists::{self, EightTwists};

/// What of the sections is constant.
#[derive(Clone, Debug)]
pub struct Tree {
    order: Strands,
    constants: Vec<EightConstants>,
}

/// All sections at an instant.
#[derive(Clone, Debug)]
pub struct MovingTree {
    helices: Vec<EightHelices>,
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
            helices: vec![EightHelices::resting(); self.order.eights()],
            eights: vec![EightMoving::resting(); self.order.eights()],
            twists: self.constants.iter().map(twists::none).collect(),
        }
    }

    /// Writes all sections at some q and q̇.
    #[inline(always)]
    pub fn write<S: Arithmetic>(&self, simd: S, at: Coordinates, moving: &mut MovingTree) {
        let MovingTree { helices, eights, twists } = moving;
        let Strands { strands, in_plane: plane, .. } = &self.order;
        for (constants, helices) in self.constants[..*plane].iter().zip(&mut *helices) {
            constants.write_in_plane(simd, at, helices);
        }
        for (constants, helices) in self.constants[*plane..].iter().zip(&mut helices[*plane..]) {
            constants.write(simd, at, helices);
        }
        for strand in strands {
            if strand.in_plane {
                in_plane::turn_along(strand, helices);
            } else {
                turn_along(strand, helices);
            }
        }
        for (helices, moving) in helices[..*plane].iter().zip(&mut *eights) {
            helices.unroll_in_plane(simd, moving);
        }
        for (helices, moving) in helices[*plane..].iter().zip(&mut eights[*plane..]) {
            helices.unroll(simd, moving);
        }
        for strand in strands {
            if strand.in_plane {
                in_plane::add_positions(strand, eights);
            } else {
                add_up(strand, eights, |EightMoving { position: x, spin, .. }| {
                    [&mut x.x, &mut x.y, &mut x.z, &mut spin.x, &mut spin.y, &mut spin.z]
                });
            }
        }
        let carried = eights.iter_mut().zip(&self.constants).zip(&mut *twists).enumerate();
        for (index, ((moving, constants), twists)) in carried {
            if index < *plane {
                moving.carry_in_plane(simd, constants, twists);
            } else {
                moving.carry(simd, constants, twists);
            }
        }
        for strand in strands {
            if strand.in_plane {
                in_plane::add_motion(strand, eights);
                twists::add_up(strand, ModeShapes::IN_PLANE, twists);
            } else {
                twists::add_up(strand, [0, 1, 2, 3, 4, 5], twists);
                add_up(strand, eights, |moving| {
                    let EightMoving { velocity: w, acceleration: a, angular_acceleration: alpha, .. } =
                        moving;
                    let [w, a] = [w, a].map(|EightVectors { x, y, z }| [x, y, z]);
                    let ([w_x, w_y, w_z], [a_x, a_y, a_z]) = (w, a);
                    [w_x, w_y, w_z, a_x, a_y, a_z, &mut alpha.x, &mut alpha.y, &mut alpha.z]
                });
            }
        }
        eights[..*plane].iter_mut().for_each(|moving| moving.settle_in_plane(simd));
        eights[*plane..].iter_mut().for_each(|moving| moving.settle(simd));
    }
}

/// Turns each section by all turns before it.
#[inline(always)]
fn turn_along(strand: &Strand, helices: &mut [EightHelices]) {
    let [eight, lane] = strand.parent;
    let mut before = helices[eight].turn.each_ref().map(|part| part.0[lane]);
    for Part { eight, lanes, .. } in &strand.parts {
        let EightHelices { turn, turn_before, .. } = &mut helices[*eight];
        for lane in lanes.clone().map(|lane| lane % LANES) {
            let [w, x, y, z] = before;
            let [own_w, own_x, own_y, own_z] = turn.each_ref().map(|part| part.0[lane]);
            let turned = [
                (w * own_w - x * own_x) - (y * own_y + z * own_z),
                (w * own_x + x * own_w) + (y * own_z - z * own_y),
                (w * own_y + y * own_w) + (z * own_x - x * own_z),
                (w * own_z + z * own_w) + (x * own_y - y * own_x),
            ];
            for part in 0..4 {
                turn_before[part].0[lane] = before[part];
                turn[part].0[lane] = turned[part];
            }
            before = turned;
        }
    }
}

/// Sums what each section adds along a strand, in its place.
#[inline(always)]
pub fn add_up<const N: usize>(
    strand: &Strand,
    eights: &mut [EightMoving],
    summed: impl Fn(&mut EightMoving) -> [&mut Eight; N],
) {
    let [eight, lane] = strand.parent;
    let mut sums = summed(&mut eights[eight]).map(|own| own.0[lane]);
    for Part { eight, lanes, .. } in &strand.parts {
        let mut own = summed(&mut eights[*eight]);
        for lane in lanes.clone().map(|lane| lane % LANES) {
            for (own, sum) in own.iter_mut().zip(&mut sums) {
                *sum += own.0[lane];
                own.0[lane] = *sum;
            }
        }
    }
}

impl MovingTree {
    /// The section at a place.
    pub fn section(&self, place: usize) -> Moving {
        self.eights[place / LANES].single(place % LANES)
    }
}
