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
    /// X: two rows per group, padded to whole blocks.
    distribution: Vec<Lanes>,
    /// Y, where it differs from X.
    acceleration: Vec<Lanes>,
    /// The first lifting strip in reverse flow, if any.
    pub reversed: Option<usize>,
}

/// The rows of one group of strips on ν.
pub struct GroupRows<'a> {
    /// √(πρb²Δy) (G_w − dG_Ω).
    pub heave: &'a mut [Lanes],
    /// √(πρb⁴Δy/8) G_Ω.
    pub pitch: &'a mut [Lanes],
    /// √(πρb²Δy) (G_m − dG_Ω), where it differs from `heave`, and `pitch` again.
    pub acceleration: Option<(&'a mut [Lanes], &'a mut [Lanes])>,
}

impl StripSums {
    /// Room for groups of four strips and `modes` generalised coordinates.
    pub fn new(groups: usize, modes: usize, symmetric: bool) -> Self {
        let size = 6 + modes;
        let rows = vec![Lanes::splat(0.0); 2 * groups * size.next_multiple_of(BLOCK)];
        StripSums {
            size,
            symmetric,
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

    /// The forces, and the rows of one group, to be filled.
    pub fn group(&mut self, group: usize) -> (&mut [Lanes], GroupRows<'_>) {
        let width = self.size.next_multiple_of(BLOCK);
        let size = self.size;
        let range = 2 * group * width..2 * (group + 1) * width;
        let (heave, pitch) = pair(&mut self.distribution[range.clone()], size);
        let acceleration =
            if self.symmetric { None } else { Some(pair(&mut self.acceleration[range], size)) };
        (&mut self.force, GroupRows { heave, pitch, acceleration })
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
        let width = self.size.next_multiple_of(BLOCK);
        let mut sums = [[Lanes::splat(0.0); BLOCK]; BLOCK];
        for (x, y) in self.distribution.chunks_exact(width).zip(acceleration.chunks_exact(width)) {
            let (x, y) = (&x[row..row + BLOCK], &y[column..column + BLOCK]);
            for (sums, x) in sums.iter_mut().zip(x) {
                for (sum, y) in sums.iter_mut().zip(y) {
                    *sum += *x * *y;
                }
            }
        }
        sums
    }
}

/// Cuts two padded rows apart, to `size` entries each.
fn pair(rows: &mut [Lanes], size: usize) -> (&mut [Lanes], &mut [Lanes]) {
    let (first, second) = rows.split_at_mut(rows.len() / 2);
    (&mut first[..size], &mut second[..size])
}
