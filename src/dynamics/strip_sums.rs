//! Sums over all strips: their generalised forces and their apparent mass [4.1; physics.md §4].
//!
//! The apparent mass πρb²Δy [(G_w − dG_Ω)ᵀ(G_m − dG_Ω) + (b²/8) G_ΩᵀG_Ω], summed over strips, is a product
//! XᵀY of two rows per strip, each scaled by the root of its mass. Each entry is summed lane by lane over
//! the groups of strips, then over the lanes: always in the same order.

use pulp::Simd;

use crate::lanes::{Eight, Lanes, Place};

/// Rows and columns of the product that are summed together.
const BLOCK: usize = 3;

/// Generalised forces and apparent mass of the strips, as they are being summed.
#[derive(Clone, Debug)]
pub struct StripSums {
    /// Length of ν.
    size: usize,
    /// Whether X and Y are the same.
    symmetric: bool,
    /// Generalised forces on ν, per lane.
    force: Vec<Eight>,
    /// Groups of strips.
    groups: usize,
    /// X by component of ν (padded to whole blocks): heave of every group, then pitch of every group.
    distribution: Vec<Eight>,
    /// Y, where it differs from X.
    acceleration: Vec<Eight>,
    /// The first lifting strip in reverse flow, if any.
    pub reversed: Option<usize>,
}

/// One component of ν of the rows of some strips, and the force along it.
#[derive(Clone, Copy, Debug)]
pub struct RowEntry<S: Simd> {
    /// √(πρb²Δy) (G_w − dG_Ω).
    pub heave: Lanes<S>,
    /// √(πρb⁴Δy/8) G_Ω.
    pub pitch: Lanes<S>,
    /// √(πρb²Δy) (G_m − dG_Ω); read only where it differs from `heave`.
    pub acceleration: Lanes<S>,
    /// Generalised force.
    pub force: Lanes<S>,
}

impl StripSums {
    /// Room for groups of strips and `modes` generalised coordinates.
    pub fn new(groups: usize, modes: usize, symmetric: bool) -> Self {
        let size = 6 + modes;
        let rows = vec![Eight::ZERO; 2 * groups * size.next_multiple_of(BLOCK)];
        StripSums {
            size,
            symmetric,
            groups,
            force: vec![Eight::ZERO; size],
            acceleration: if symmetric { Vec::new() } else { rows.clone() },
            distribution: rows,
            reversed: None,
        }
    }

    /// Forgets the forces of the last evaluation; its rows are overwritten.
    pub fn clear(&mut self) {
        self.force.fill(Eight::ZERO);
        self.reversed = None;
    }

    /// Adds one component of ν of the strips at a place of a group.
    #[inline(always)]
    pub fn add<S: Simd>(&mut self, place: Place<S>, group: usize, component: usize, entry: &RowEntry<S>) {
        let heave = 2 * self.groups * component + group;
        let pitch = heave + self.groups;
        let force = &mut self.force[component];
        place.store(force, place.load(force) + entry.force);
        place.store(&mut self.distribution[heave], entry.heave);
        place.store(&mut self.distribution[pitch], entry.pitch);
        if !self.symmetric {
            place.store(&mut self.acceleration[heave], entry.acceleration);
            place.store(&mut self.acceleration[pitch], entry.pitch);
        }
    }

    /// Adds the forces, and XᵀY to a row-major mass matrix; of a symmetric one only the upper triangle.
    #[inline(always)]
    pub fn add_to<S: Simd>(&self, simd: S, force: &mut [f64], mass: &mut [f64]) {
        for (force, lanes) in force.iter_mut().zip(&self.force) {
            *force += lanes.sum();
        }
        let acceleration = if self.symmetric { &self.distribution } else { &self.acceleration };
        let blocks = self.size.div_ceil(BLOCK);
        for row in 0..blocks {
            for column in if self.symmetric { row } else { 0 }..blocks {
                let block = self.block(simd, acceleration, row * BLOCK, column * BLOCK);
                for (i, sums) in block.iter().enumerate().take(self.size - row * BLOCK) {
                    for (j, lanes) in sums.iter().enumerate().take(self.size - column * BLOCK) {
                        mass[(row * BLOCK + i) * self.size + column * BLOCK + j] += lanes.sum();
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
        // Translations, the first block, turn nothing: their pitch is zero.
        let used = if row == 0 || column == 0 { self.groups } else { 2 * self.groups };
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
