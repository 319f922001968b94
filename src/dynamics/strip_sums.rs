//! Sums over all strips: their generalised forces and their apparent mass [4.1; physics.md §4].
//!
//! The apparent mass πρb²Δy [(G_w − dG_Ω)ᵀ(G_m − dG_Ω) + (b²/8) G_ΩᵀG_Ω], summed over strips, is a product
//! ρXᵀY of two rows per strip, each scaled by the root of its mass in air of unit density. Each entry is summed lane by lane over
//! the groups of strips, then over the lanes: always in the same order.

use pulp::Simd;

use crate::lanes::{Eight, Lanes, Place};

use super::controls::SURFACES;
use super::forces::GeneralisedForces;
use super::freedom::RigidFreedom;
use super::strips::Strips;

/// Rows and columns of the product that are summed together.
const BLOCK: usize = 3;

/// Generalised forces and apparent mass of the strips, as they are being summed; rows are the components of ν that
/// move.
#[derive(Clone, Debug)]
pub struct StripSums {
    /// Places in ν of the components that move.
    moving: Vec<usize>,
    /// How many of them, the first, are translations of the whole aircraft.
    translations: usize,
    /// Whether X and Y are the same.
    symmetric: bool,
    /// Generalised forces with the flaps neutral, per lane.
    force: Vec<Eight>,
    /// Generalised forces per radian of each kind of surfaces, per lane; empty for those that move no flap.
    effects: [Vec<Eight>; SURFACES],
    /// Groups of strips.
    groups: usize,
    /// X row by row (padded to whole blocks): heave of every group, then pitch of every group.
    distribution: Vec<Eight>,
    /// Y, where it differs from X.
    acceleration: Vec<Eight>,
    /// The first lifting strip in reverse flow, if any; those edge-on count after all others.
    pub reversed: Option<usize>,
}

/// One component of ν of the rows of some strips, and the force along it.
#[derive(Clone, Copy, Debug)]
pub struct RowEntry<S: Simd> {
    /// √(πb²Δy) (G_w − dG_Ω).
    pub heave: Lanes<S>,
    /// √(πb⁴Δy/8) G_Ω.
    pub pitch: Lanes<S>,
    /// √(πb²Δy) (G_m − dG_Ω); read only where it differs from `heave`.
    pub acceleration: Lanes<S>,
    /// Generalised force, flaps neutral.
    pub force: Lanes<S>,
}

impl StripSums {
    /// Room for the sums of some strips; of the generalised forces and masses those of the components of ν that move.
    pub fn new(strips: &Strips, freedom: RigidFreedom, modes: usize, symmetric: bool) -> Self {
        let (moving, groups) = (freedom.moving(modes), strips.groups());
        let size = moving.len();
        let rows = vec![Eight::ZERO; 2 * groups * size.next_multiple_of(BLOCK)];
        let effect = |surface| vec![Eight::ZERO; if strips.has_surface(surface) { size } else { 0 }];
        StripSums {
            moving,
            translations: freedom.translations(),
            symmetric,
            groups,
            force: vec![Eight::ZERO; size],
            effects: std::array::from_fn(effect),
            acceleration: if symmetric { Vec::new() } else { rows.clone() },
            distribution: rows,
            reversed: None,
        }
    }

    /// Places in ν of the rows.
    pub fn moving(&self) -> &[usize] {
        &self.moving
    }

    /// Whether accelerations are distributed as loads are.
    pub fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    /// Forgets the forces of the last evaluation; its rows are overwritten.
    pub fn clear(&mut self) {
        for force in self.effects.iter_mut().chain([&mut self.force]) {
            force.fill(Eight::ZERO);
        }
        self.reversed = None;
    }

    /// Adds a row of the strips at a place of a group.
    #[inline(always)]
    pub fn add<S: Simd>(&mut self, place: Place<S>, group: usize, row: usize, entry: &RowEntry<S>) {
        let heave = 2 * self.groups * row + group;
        let pitch = heave + self.groups;
        add_to(place, &mut self.force[row], entry.force);
        place.store(&mut self.distribution[heave], entry.heave);
        place.store(&mut self.distribution[pitch], entry.pitch);
        if !self.symmetric {
            place.store(&mut self.acceleration[heave], entry.acceleration);
            place.store(&mut self.acceleration[pitch], entry.pitch);
        }
    }

    /// Adds a generalised force in a row.
    #[inline(always)]
    pub fn add_force<S: Simd>(&mut self, place: Place<S>, row: usize, force: Lanes<S>) {
        add_to(place, &mut self.force[row], force);
    }

    /// Adds the generalised force in a row per radian of one kind of surfaces.
    #[inline(always)]
    pub fn add_effect<S: Simd>(&mut self, place: Place<S>, surface: usize, row: usize, effect: Lanes<S>) {
        add_to(place, &mut self.effects[surface][row], effect);
    }

    /// Adds the forces to those on ν and to those per radian of each kind of surfaces, and ρXᵀY to the row-major mass
    /// matrix of the components that move; of a symmetric one only the upper triangle.
    #[inline(always)]
    pub fn add_to<S: Simd>(&self, simd: S, density: f64, forces: &mut GeneralisedForces, mass: &mut [f64]) {
        let passive = std::iter::once((&mut forces.passive, &self.force));
        for (force, rows) in passive.chain(forces.effects.iter_mut().zip(&self.effects)) {
            for (&component, lanes) in self.moving.iter().zip(rows) {
                force[component] += lanes.sum();
            }
        }
        let size = self.moving.len();
        let acceleration = if self.symmetric { &self.distribution } else { &self.acceleration };
        let blocks = size.div_ceil(BLOCK);
        for row in 0..blocks {
            for column in if self.symmetric { row } else { 0 }..blocks {
                let block = self.block(simd, acceleration, row * BLOCK, column * BLOCK);
                let on_diagonal = self.symmetric && row == column;
                for (i, sums) in block.iter().enumerate().take(size - row * BLOCK) {
                    let first = if on_diagonal { i } else { 0 };
                    let mass = &mut mass[(row * BLOCK + i) * size + column * BLOCK..];
                    for (mass, lanes) in mass.iter_mut().zip(sums).take(size - column * BLOCK).skip(first) {
                        *mass += density * lanes.sum();
                    }
                }
            }
        }
    }

    /// One block of XᵀY, per lane.
    #[inline(always)]
    fn block<S: Simd>(
        &self,
        simd: S,
        acceleration: &[Eight],
        row: usize,
        column: usize,
    ) -> [[Eight; BLOCK]; BLOCK] {
        // Translations turn nothing: their pitch is zero.
        let turns_nothing = |first: usize| first + BLOCK <= self.translations;
        let used = if turns_nothing(row) || turns_nothing(column) { self.groups } else { 2 * self.groups };
        let [x0, x1, x2] = self.rows(&self.distribution, row, used);
        let [y0, y1, y2] = self.rows(acceleration, column, used);
        let mut block = [[Eight::ZERO; BLOCK]; BLOCK];
        for place in Place::all(simd) {
            let mut sums = [[place.splat(0.0); BLOCK]; BLOCK];
            let pairs = x0.iter().zip(x1).zip(x2).zip(y0.iter().zip(y1).zip(y2));
            for (((x0, x1), x2), ((y0, y1), y2)) in pairs {
                let x = [place.load(x0), place.load(x1), place.load(x2)];
                let y = [place.load(y0), place.load(y1), place.load(y2)];
                for i in 0..BLOCK {
                    for j in 0..BLOCK {
                        sums[i][j] += x[i] * y[j];
                    }
                }
            }
            for i in 0..BLOCK {
                for j in 0..BLOCK {
                    place.store(&mut block[i][j], sums[i][j]);
                }
            }
        }
        block
    }

    /// The rows of a block, each as far as it is used.
    fn rows<'a>(&self, matrix: &'a [Eight], first: usize, used: usize) -> [&'a [Eight]; BLOCK] {
        let length = 2 * self.groups;
        std::array::from_fn(|i| &matrix[(first + i) * length..][..used])
    }
}

#[inline(always)]
fn add_to<S: Simd>(place: Place<S>, sum: &mut Eight, lanes: Lanes<S>) {
    place.store(sum, place.load(sum) + lanes);
}
