//! Sums over all strips: their generalised forces and their apparent mass [4.1; physics.md §4].
//!
//! The apparent mass πρb²Δy [(G_w − dG_Ω)ᵀ(G_m − dG_Ω) + (b²/8) G_ΩᵀG_Ω], summed over strips, is a product
//! ρXᵀY of two rows per strip, each scaled by the root of its mass in air of unit density. Each entry is summed lane
//! by lane over the groups of strips, then over the lanes: always in the same order.

use pulp::Simd;

use crate::lanes::{Eight, Lanes, Place};

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
    /// Kinds of surfaces that move any flap.
    surfaces: Vec<usize>,
    places: RowPlaces,
    /// Row by row, padded to whole blocks.
    rows: Vec<Eight>,
    /// XᵀY, row-major, padded to whole blocks; of a symmetric one only the upper triangle.
    product: Vec<f64>,
    /// The first lifting strip in reverse flow, if any; those edge-on count after all others.
    pub reversed: Option<usize>,
}

/// What a row consists of: the generalised force with the flaps neutral, that per radian of each kind of surfaces
/// that moves any, then X (heave of every group, pitch of every group) and, where it differs, heave of every group
/// in Y.
#[derive(Clone, Copy, Debug)]
struct RowPlaces {
    surfaces: usize,
    groups: usize,
    /// Whether X and Y are the same.
    symmetric: bool,
}

/// One row.
pub struct Row<'a> {
    numbers: &'a mut [Eight],
    places: RowPlaces,
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
        let moving = freedom.moving(modes);
        let width = moving.len().next_multiple_of(BLOCK);
        let surfaces = strips.surfaces.clone();
        let places = RowPlaces { surfaces: surfaces.len(), groups: strips.groups(), symmetric };
        StripSums {
            moving,
            translations: freedom.translations(),
            surfaces,
            places,
            rows: vec![Eight::ZERO; width * places.length()],
            product: vec![0.0; width * width],
            reversed: None,
        }
    }

    /// Places in ν of the rows.
    pub fn moving(&self) -> &[usize] {
        &self.moving
    }

    /// Whether accelerations are distributed as loads are.
    pub fn is_symmetric(&self) -> bool {
        self.places.symmetric
    }

    /// Forgets the forces of the last evaluation; X and Y are overwritten.
    #[inline(always)]
    pub fn clear(&mut self) {
        let forces = 1 + self.places.surfaces;
        for row in self.rows.chunks_exact_mut(self.places.length()) {
            row[..forces].fill(Eight::ZERO);
        }
        self.reversed = None;
    }

    /// One row after the other.
    #[inline(always)]
    pub fn rows(&mut self) -> impl Iterator<Item = Row<'_>> {
        let places = self.places;
        let rows = self.rows.chunks_exact_mut(places.length()).take(self.moving.len());
        rows.map(move |numbers| Row { numbers, places })
    }

    /// Adds the forces to those on ν and to those per radian of each kind of surfaces, and ρXᵀY to the row-major mass
    /// matrix of the components that move; of a symmetric one only the upper triangle.
    #[inline(always)]
    pub fn add_to<S: Simd>(
        &mut self,
        simd: S,
        density: f64,
        forces: &mut GeneralisedForces,
        mass: &mut [f64],
    ) {
        for (&component, row) in self.moving.iter().zip(self.rows.chunks_exact(self.places.length())) {
            forces.passive[component] += row[0].sum();
            for (&surface, effect) in self.surfaces.iter().zip(&row[1..]) {
                forces.effects[surface][component] += effect.sum();
            }
        }
        let size = self.moving.len();
        for row in (0..size).step_by(BLOCK) {
            for column in (if self.places.symmetric { row } else { 0 }..size).step_by(BLOCK) {
                self.multiply(simd, row, column);
            }
        }
        let padded = self.product.chunks_exact(size.next_multiple_of(BLOCK).max(1));
        for (mass, product) in mass.chunks_exact_mut(size.max(1)).zip(padded) {
            for (mass, product) in mass.iter_mut().zip(product) {
                *mass += density * product;
            }
        }
    }

    /// Writes the block of XᵀY that begins at a row and a column.
    #[inline(always)]
    fn multiply<S: Simd>(&mut self, simd: S, row: usize, column: usize) {
        let (places, length) = (self.places, self.places.length());
        let [x, y] = [row, column].map(|first| -> [&[Eight]; BLOCK] {
            std::array::from_fn(|i| &self.rows[(first + i) * length..][..length])
        });
        let heave = x.map(|row| &row[places.heave(0)..][..places.groups]);
        let acceleration = y.map(|row| &row[places.acceleration(0)..][..places.groups]);
        let [pitch, turn] = [x, y].map(|rows| rows.map(|row| &row[places.pitch(0)..][..places.groups]));
        let on_diagonal = places.symmetric && row == column;
        // Translations turn nothing: their pitch is zero.
        let [turning_rows, turning_columns] =
            [row, column].map(|first| BLOCK - self.translations.saturating_sub(first).min(BLOCK));
        let mut block = [[Eight::ZERO; BLOCK]; BLOCK];
        for place in Place::all(simd) {
            let mut sums = [[place.splat(0.0); BLOCK]; BLOCK];
            add_products::<S, BLOCK>(place, on_diagonal, heave, acceleration, &mut sums);
            match turning_rows.min(if turning_columns == 0 { 0 } else { BLOCK }) {
                0 => {}
                1 => add_products::<S, 1>(place, on_diagonal, pitch, turn, &mut sums),
                _ => add_products::<S, BLOCK>(place, on_diagonal, pitch, turn, &mut sums),
            }
            for i in 0..BLOCK {
                for j in 0..BLOCK {
                    place.store(&mut block[i][j], sums[i][j]);
                }
            }
        }
        let width = self.moving.len().next_multiple_of(BLOCK);
        for (i, sums) in block.iter().enumerate() {
            let product = &mut self.product[(row + i) * width + column..][..BLOCK];
            for (product, lanes) in product.iter_mut().zip(sums) {
                *product = lanes.sum();
            }
        }
    }
}

impl RowPlaces {
    fn length(self) -> usize {
        self.pitch(self.groups) + if self.symmetric { 0 } else { self.groups }
    }

    fn heave(self, group: usize) -> usize {
        1 + self.surfaces + group
    }

    fn pitch(self, group: usize) -> usize {
        self.heave(self.groups) + group
    }

    /// Of the heave in Y.
    fn acceleration(self, group: usize) -> usize {
        if self.symmetric { self.heave(group) } else { self.pitch(self.groups) + group }
    }
}

/// Adds the products of the last `ROWS` rows of a block of X with a block of Y, summed over the groups; on the diagonal
/// only the upper triangle.
#[inline(always)]
fn add_products<S: Simd, const ROWS: usize>(
    place: Place<S>,
    on_diagonal: bool,
    [x0, x1, x2]: [&[Eight]; BLOCK],
    [y0, y1, y2]: [&[Eight]; BLOCK],
    sums: &mut [[Lanes<S>; BLOCK]; BLOCK],
) {
    let pairs = x0.iter().zip(x1).zip(x2).zip(y0.iter().zip(y1).zip(y2));
    for (((x0, x1), x2), ((y0, y1), y2)) in pairs {
        let x = [place.load(x0), place.load(x1), place.load(x2)];
        let y = [place.load(y0), place.load(y1), place.load(y2)];
        for i in BLOCK - ROWS..BLOCK {
            for j in 0..BLOCK {
                if j >= i || !on_diagonal {
                    sums[i][j] += x[i] * y[j];
                }
            }
        }
    }
}

impl Row<'_> {
    /// Sets what a group's strips have in this row of X and Y, and adds their force.
    #[inline(always)]
    pub fn add<S: Simd, const SYMMETRIC: bool>(
        &mut self,
        place: Place<S>,
        group: usize,
        entry: &RowEntry<S>,
    ) {
        let places = self.places;
        self.add_force(place, entry.force);
        place.store(&mut self.numbers[places.heave(group)], entry.heave);
        place.store(&mut self.numbers[places.pitch(group)], entry.pitch);
        if !SYMMETRIC {
            place.store(&mut self.numbers[places.acceleration(group)], entry.acceleration);
        }
    }

    /// Adds a generalised force.
    #[inline(always)]
    pub fn add_force<S: Simd>(&mut self, place: Place<S>, force: Lanes<S>) {
        add_to(place, &mut self.numbers[0], force);
    }

    /// Adds the generalised force per radian of surfaces, the kind counted among those that move any flap.
    #[inline(always)]
    pub fn add_effect<S: Simd>(&mut self, place: Place<S>, kind: usize, effect: Lanes<S>) {
        add_to(place, &mut self.numbers[1 + kind], effect);
    }
}

#[inline(always)]
fn add_to<S: Simd>(place: Place<S>, sum: &mut Eight, lanes: Lanes<S>) {
    place.store(sum, place.load(sum) + lanes);
}
