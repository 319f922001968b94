//! Sums over all strips: their generalised forces and their apparent mass.
//!
//! [theory: air-loads.apparent-mass; thesis §4.1]
//!
//! The apparent mass πρb²Δy [(G_w − dG_Ω)ᵀ(G_m − dG_Ω) + (b²/8) G_ΩᵀG_Ω], summed over strips, is a product
//! ρXᵀY of two rows per strip, each scaled by the root of its mass in air of unit density. Each entry is summed lane
//! by lane over the groups of strips, then over the lanes: always in the same order.

use crate::kinematics::RigidFreedom;
use crate::math::{Arithmetic, Eight, Lanes, SPARE, SquareMatrix, Window};

/// Rows and columns of the product that are summed together.
const BLOCK: usize = 1 + SPARE;

/// Generalised forces and apparent mass of the strips, as they are being summed; rows are the components of ν that
/// move.
#[derive(Clone, Debug)]
pub struct StripSums {
    /// Places in ν of the components that move.
    moving: Vec<usize>,
    /// How many of them, the first, are translations of the whole aircraft.
    translations: usize,
    /// Whether X and Y are the same, so that their product is self-adjoint.
    equal_rows: bool,
    /// Padded to whole blocks.
    rows: Vec<Row>,
    /// XᵀY, of a self-adjoint one only the upper triangle.
    product: SquareMatrix,
    /// The first lifting strip in reverse flow, if any; those edge-on count after all others.
    pub reversed: Option<usize>,
}

/// What belongs to one component of ν.
#[derive(Clone, Debug)]
pub struct Row {
    /// Generalised force with the flaps neutral, per lane.
    force: Eight,
    /// Generalised force per unit of each factor of the flaps' loads, per lane.
    effects: Vec<Eight>,
    /// Of X and Y, of every group.
    pitch: Vec<Eight>,
    /// Of X, of every group.
    heave: Vec<Eight>,
    /// Heave of Y, of every group; empty where it does not differ.
    acceleration: Vec<Eight>,
}

/// One component of ν of the rows of some strips, and the force along it.
#[derive(Clone, Copy, Debug)]
pub struct RowEntry<S: Arithmetic> {
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
    /// Room for the sums over so many groups of strips with so many factors of their flaps' loads; of the generalised forces and
    /// masses those of the components of ν that move.
    pub fn new([groups, factors]: [usize; 2], freedom: RigidFreedom, modes: usize, equal_rows: bool) -> Self {
        let moving = freedom.moving(modes);
        let row = Row::new(groups, factors, equal_rows);
        StripSums {
            rows: vec![row; moving.len().next_multiple_of(BLOCK)],
            product: SquareMatrix::new(moving.len()),
            moving,
            translations: freedom.translations(),
            equal_rows,
            reversed: None,
        }
    }

    /// Places in ν of the rows.
    pub fn moving(&self) -> &[usize] {
        &self.moving
    }

    /// Whether accelerations are distributed as loads are.
    pub fn has_equal_rows(&self) -> bool {
        self.equal_rows
    }

    /// Forgets the forces of the last evaluation; X and Y are overwritten.
    #[inline(always)]
    pub fn clear(&mut self) {
        for row in &mut self.rows {
            row.force = Eight::ZERO;
            row.effects.fill(Eight::ZERO);
        }
        self.reversed = None;
    }

    /// One row after the other.
    #[inline(always)]
    pub fn rows(&mut self) -> impl Iterator<Item = &mut Row> {
        self.rows[..self.moving.len()].iter_mut()
    }

    /// Adds the forces to those on ν and to those of the flaps, and ρXᵀY to the mass matrix of the components that move;
    /// of a self-adjoint one only the upper triangle.
    #[inline(always)]
    pub fn add_to<S: Arithmetic>(
        &mut self,
        simd: S,
        density: f64,
        (passive, effects): (&mut [f64], &mut [f64]),
        mass: &mut SquareMatrix,
    ) {
        let rows = || self.moving.iter().zip(&self.rows);
        for (&component, row) in rows() {
            passive[component] += row.force.sum();
        }
        for (&component, row) in rows() {
            for (effect, lanes) in effects.chunks_exact_mut(passive.len()).zip(&row.effects) {
                effect[component] += lanes.sum();
            }
        }
        let size = self.moving.len();
        for row in (0..size).step_by(BLOCK) {
            if self.equal_rows {
                self.multiply::<S, true>(simd, row, row);
            }
            for column in (if self.equal_rows { row + BLOCK } else { 0 }..size).step_by(BLOCK) {
                self.multiply::<S, false>(simd, row, column);
            }
        }
        mass.add_scaled(simd, density, &self.product);
    }

    /// Writes the block of XᵀY that begins at a row and a column; of one on the diagonal of a self-adjoint product, only
    /// the upper triangle counts.
    #[inline(always)]
    fn multiply<S: Arithmetic, const ON_DIAGONAL: bool>(&mut self, simd: S, row: usize, column: usize) {
        let (x, y) = (&self.rows[row..row + BLOCK], &self.rows[column..column + BLOCK]);
        // Translations turn nothing: their pitch is zero.
        let translations = |first: usize| self.translations.saturating_sub(first);
        let turning = if translations(column) >= BLOCK { 0 } else { BLOCK.saturating_sub(translations(row)) };
        let mut block = [[Eight::ZERO; BLOCK]; BLOCK];
        for window in Window::all(simd) {
            let mut sums = [[window.splat(0.0); BLOCK]; BLOCK];
            let [heave, acceleration, pitch] = [
                [&x[0].heave, &x[1].heave, &x[2].heave],
                [y[0].acceleration(), y[1].acceleration(), y[2].acceleration()],
                [&x[0].pitch, &x[1].pitch, &x[2].pitch],
            ];
            add_products::<S, BLOCK, ON_DIAGONAL>(window, heave, acceleration, &mut sums);
            let turn = [&y[0].pitch, &y[1].pitch, &y[2].pitch];
            match turning {
                0 => {}
                1 => add_products::<S, 1, ON_DIAGONAL>(window, pitch, turn, &mut sums),
                _ => add_products::<S, BLOCK, ON_DIAGONAL>(window, pitch, turn, &mut sums),
            }
            for i in 0..BLOCK {
                for j in 0..BLOCK {
                    window.store(&mut block[i][j], sums[i][j]);
                }
            }
        }
        for (i, sums) in block.iter().enumerate() {
            let product = &mut self.product.row_mut(row + i)[column..][..BLOCK];
            for (product, lanes) in product.iter_mut().zip(sums) {
                *product = lanes.sum();
            }
        }
    }
}

/// Adds the products of the last `ROWS` rows of a block of X with a block of Y, summed over the groups; on the diagonal
/// only the upper triangle.
#[inline(always)]
fn add_products<S: Arithmetic, const ROWS: usize, const ON_DIAGONAL: bool>(
    window: Window<S>,
    [x0, x1, x2]: [&Vec<Eight>; BLOCK],
    [y0, y1, y2]: [&Vec<Eight>; BLOCK],
    sums: &mut [[Lanes<S>; BLOCK]; BLOCK],
) {
    let pairs = x0.iter().zip(x1).zip(x2).zip(y0.iter().zip(y1).zip(y2));
    for (((x0, x1), x2), ((y0, y1), y2)) in pairs {
        let x = [window.load(x0), window.load(x1), window.load(x2)];
        let y = [window.load(y0), window.load(y1), window.load(y2)];
        for i in BLOCK - ROWS..BLOCK {
            for j in if ON_DIAGONAL { i } else { 0 }..BLOCK {
                sums[i][j] += x[i] * y[j];
            }
        }
    }
}

impl Row {
    /// Of so many groups, and factors of the flaps' loads; `equal_rows` where accelerations are distributed as loads are.
    fn new(groups: usize, factors: usize, equal_rows: bool) -> Self {
        let zeros = vec![Eight::ZERO; groups];
        Row {
            force: Eight::ZERO,
            effects: vec![Eight::ZERO; factors],
            pitch: zeros.clone(),
            heave: zeros.clone(),
            acceleration: if equal_rows { Vec::new() } else { zeros },
        }
    }

    /// Heave of Y.
    #[inline(always)]
    fn acceleration(&self) -> &Vec<Eight> {
        if self.acceleration.is_empty() { &self.heave } else { &self.acceleration }
    }

    /// Sets what a group's strips have in this row of X and Y, and adds their force.
    #[inline(always)]
    pub fn add<S: Arithmetic, const EQUAL_ROWS: bool>(
        &mut self,
        window: Window<S>,
        group: usize,
        entry: &RowEntry<S>,
    ) {
        self.add_force(window, entry.force);
        window.store(&mut self.heave[group], entry.heave);
        window.store(&mut self.pitch[group], entry.pitch);
        if !EQUAL_ROWS {
            window.store(&mut self.acceleration[group], entry.acceleration);
        }
    }

    /// Adds a generalised force.
    #[inline(always)]
    pub fn add_force<S: Arithmetic>(&mut self, window: Window<S>, force: Lanes<S>) {
        add_to(window, &mut self.force, force);
    }

    /// The generalised force per unit of each factor of the flaps' loads, to be [added to](add_to).
    #[inline(always)]
    pub fn effects(&mut self) -> &mut [Eight] {
        &mut self.effects
    }
}

/// Adds to one of the sums, per lane.
#[inline(always)]
pub fn add_to<S: Arithmetic>(window: Window<S>, sum: &mut Eight, lanes: Lanes<S>) {
    window.store(sum, window.load(sum) + lanes);
}
