//! Sums over all strips: their generalised forces and their apparent mass [4.1; physics.md §4].
//!
//! The apparent mass πρb²Δy [(G_w − dG_Ω)ᵀ(G_m − dG_Ω) + (b²/8) G_ΩᵀG_Ω], summed over strips, is a product
//! XᵀY of two rows per strip, each scaled by the root of its mass. Each entry is summed lane by lane over
//! the groups of strips, then over the lanes: always in the same order.

use crate::lanes::{Lanes, sum};

/// Rows and columns of the product that are summed together.
const BLOCK: usize = 2;

/// Generalised forces and apparent mass of the strips, as they are being summed.
#[derive(Clone, Debug)]
pub struct StripSums {
    /// Length of ν.
    size: usize,
    /// Whether X and Y are the same.
    symmetric: bool,
    /// Generalised forces on ν, per lane.
    pub force: Vec<Lanes>,
    /// Groups of strips.
    groups: usize,
    /// X by component of ν (padded to whole blocks): heave of every group, then pitch of every group.
    distribution: Vec<Lanes>,
    /// Y, where it differs from X.
    acceleration: Vec<Lanes>,
    /// The first lifting strip in reverse flow, if any.
    pub reversed: Option<usize>,
}

/// One component of ν of the rows of one group of strips.
#[derive(Clone, Copy, Debug)]
pub struct RowEntry {
    /// √(πρb²Δy) (G_w − dG_Ω).
    pub heave: Lanes,
    /// √(πρb⁴Δy/8) G_Ω.
    pub pitch: Lanes,
    /// √(πρb²Δy) (G_m − dG_Ω); read only where it differs from `heave`.
    pub acceleration: Lanes,
}

impl StripSums {
    /// Room for groups of four strips and `modes` generalised coordinates.
    pub fn new(groups: usize, modes: usize, symmetric: bool) -> Self {
        let size = 6 + modes;
        let rows = vec![Lanes::splat(0.0); 2 * groups * size.next_multiple_of(BLOCK)];
        StripSums {
            size,
            symmetric,
            groups,
            force: vec![Lanes::splat(0.0); size],
            acceleration: if symmetric { Vec::new() } else { rows.clone() },
            distribution: rows,
            reversed: None,
        }
    }

    /// Forgets the forces of the last evaluation; its rows are overwritten.
    pub fn clear(&mut self) {
        self.force.fill(Lanes::splat(0.0));
        self.reversed = None;
    }

    /// Writes one component of ν of a group's rows.
    pub fn write(&mut self, group: usize, component: usize, entry: &RowEntry) {
        let heave = 2 * self.groups * component + group;
        let pitch = heave + self.groups;
        self.distribution[heave] = entry.heave;
        self.distribution[pitch] = entry.pitch;
        if !self.symmetric {
            self.acceleration[heave] = entry.acceleration;
            self.acceleration[pitch] = entry.pitch;
        }
    }

    /// Adds the forces, and XᵀY to a row-major mass matrix; of a symmetric one only the lower triangle.
    pub fn add_to(&self, force: &mut [f64], mass: &mut [f64]) {
        for (force, lanes) in force.iter_mut().zip(&self.force) {
            *force += sum(*lanes);
        }
        let acceleration = if self.symmetric { &self.distribution } else { &self.acceleration };
        let blocks = self.size.div_ceil(BLOCK);
        for row in 0..blocks {
            let columns = if self.symmetric { row + 1 } else { blocks };
            for column in 0..columns {
                let block = self.block(acceleration, row * BLOCK, column * BLOCK);
                for (i, sums) in block.iter().enumerate().take(self.size - row * BLOCK) {
                    for (j, lanes) in sums.iter().enumerate().take(self.size - column * BLOCK) {
                        mass[(row * BLOCK + i) * self.size + column * BLOCK + j] += sum(*lanes);
                    }
                }
            }
        }
    }

    /// One block of XᵀY, per lane.
    fn block(&self, acceleration: &[Lanes], row: usize, column: usize) -> [[Lanes; BLOCK]; BLOCK] {
        let length = 2 * self.groups;
        let (x0, x1) = self.distribution[row * length..(row + BLOCK) * length].split_at(length);
        let (y0, y1) = acceleration[column * length..(column + BLOCK) * length].split_at(length);
        let mut sums = [[Lanes::splat(0.0); BLOCK]; BLOCK];
        for (((x0, x1), y0), y1) in x0.iter().zip(x1).zip(y0).zip(y1) {
            sums[0][0] += *x0 * *y0;
            sums[0][1] += *x0 * *y1;
            sums[1][0] += *x1 * *y0;
            sums[1][1] += *x1 * *y1;
        }
        sums
    }
}
