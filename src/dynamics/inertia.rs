//! Inertia of the deformed aircraft: mass matrix and inertial forcing [2.2–2.4; physics.md §2].
//!
//! Γ̂_α and ĥ_α are linear in q, and both are needed along the axes about which the aircraft spins. They are kept
//! component by component, each for all modes, and come from one product of a constant matrix with q.

use nalgebra::{Matrix3, Matrix6, Vector3};
use pulp::Simd;

use crate::columns::Columns;
use crate::lanes::LANES;
use crate::structure::ModalIntegrals;

use super::freedom::RigidFreedom;

/// The deformation-dependent integrals ĉ, Ĵ, Γ̂, ĥ at one q.
#[derive(Clone, Debug)]
pub struct DeformedInertia {
    /// ĉ = c₀ + p_α q_α, kg·m.
    pub first_moment: Vector3<f64>,
    /// Ĵ = J₀ + (Γᵀ + Γ)q + Πqq, kg·m².
    inertia: Matrix3<f64>,
    freedom: RigidFreedom,
    /// ĥ_α = h_α + υ_αβ q_β, then Γ̂_α = Γ_α + Π_αβ q_β: a block for each component, with a number for each mode.
    deformed: Vec<f64>,
    /// The same undeformed.
    undeformed: Vec<f64>,
    /// Their derivatives υ and Π by q.
    slopes: Columns,
    /// υ alone.
    upsilon: Columns,
    /// υ q̇.
    coriolis: Vec<f64>,
}

impl DeformedInertia {
    /// The undeformed values.
    pub fn undeformed(integrals: &ModalIntegrals, freedom: RigidFreedom) -> Self {
        let (n, axes) = (integrals.modes(), freedom.axes());
        let (block, vectors) = (block_length(n), axes.len());
        let number =
            |row: usize, of_h: &dyn Fn(usize, usize) -> f64, of_gamma: &dyn Fn(usize, [usize; 2]) -> f64| {
                let (component, mode) = (row / block.max(1), row % block.max(1));
                match component.checked_sub(vectors) {
                    _ if mode >= n => 0.0,
                    None => of_h(mode, axes[component]),
                    Some(pair) => of_gamma(mode, [axes[pair / vectors], axes[pair % vectors]]),
                }
            };
        let rows = (vectors + vectors * vectors) * block;
        let undeformed: Vec<f64> = (0..rows)
            .map(|row| {
                number(row, &|a, i| integrals.angular_momentum[a][i], &|a, [i, j]| integrals.gamma[a][(i, j)])
            })
            .collect();
        let slope = |row: usize, b: usize| {
            number(row, &|a, i| integrals.upsilon[a * n + b][i], &|a, [i, j]| integrals.pi[a * n + b][(i, j)])
        };
        DeformedInertia {
            first_moment: integrals.first_moment,
            inertia: integrals.inertia,
            freedom,
            deformed: undeformed.clone(),
            slopes: Columns::new(rows, n, slope),
            upsilon: Columns::new(vectors * block, n, slope),
            coriolis: vec![0.0; vectors * block],
            undeformed,
        }
    }

    /// Evaluates all integrals at q.
    #[inline(always)]
    pub fn deform<S: Simd>(&mut self, simd: S, integrals: &ModalIntegrals, q: &[f64]) {
        self.slopes.times(simd, q, &mut self.deformed);
        for (deformed, undeformed) in self.deformed.iter_mut().zip(&self.undeformed) {
            *deformed += undeformed;
        }
        self.first_moment = integrals.first_moment;
        for (momentum, &q) in integrals.momentum.iter().zip(q) {
            self.first_moment += momentum * q;
        }
        self.inertia = integrals.inertia;
        let axes = self.freedom.axes();
        for (i, &axis) in axes.iter().enumerate() {
            for (j, &other) in axes.iter().enumerate() {
                let sum = dot(gamma(&self.undeformed, axes, [j, i], q.len()), q)
                    + dot(gamma(&self.deformed, axes, [i, j], q.len()), q);
                self.inertia[(axis, other)] += sum;
            }
        }
    }

    /// Writes the mass matrix of the present deformation, row-major on the components of ν = [v; ω; q̇] that move.
    pub fn write_mass_matrix(&self, integrals: &ModalIntegrals, matrix: &mut [f64]) {
        let rigid = rigid_mass_matrix(integrals.mass, &self.first_moment, &self.inertia);
        write_mass_matrix(integrals, self.freedom, &rigid, &self.deformed, matrix);
    }

    /// Writes the mass matrix of the undeformed aircraft, row-major on the components of ν that move.
    pub fn write_undeformed_mass_matrix(&self, integrals: &ModalIntegrals, matrix: &mut [f64]) {
        let rigid = rigid_mass_matrix(integrals.mass, &integrals.first_moment, &integrals.inertia);
        write_mass_matrix(integrals, self.freedom, &rigid, &self.undeformed, matrix);
    }

    /// Adds the inertial forcing of the rigid motion: −mω×v + ω×cω… without the δ terms in q̇.
    #[inline(always)]
    pub fn add_forcing(&self, mass: f64, momentum: &[Vector3<f64>], motion: &RigidMotion, force: &mut [f64]) {
        let RigidMotion { velocity, rate } = motion;
        let transport = rate.cross(velocity);
        let c = &self.first_moment;
        add(&mut force[0..3], &(-transport * mass + rate.cross(&c.cross(rate))));
        add(&mut force[3..6], &(-c.cross(&transport) - rate.cross(&(self.inertia * rate))));
        for (force, p) in force[6..].iter_mut().zip(momentum) {
            *force -= p.dot(&transport);
        }
        let axes = self.freedom.axes();
        for (i, &axis) in axes.iter().enumerate() {
            for (j, &other) in axes.iter().enumerate() {
                let squares = rate[axis] * rate[other];
                for (force, gamma) in
                    force[6..].iter_mut().zip(gamma(&self.deformed, axes, [i, j], momentum.len()))
                {
                    *force += gamma * squares;
                }
            }
        }
    }

    /// Adds the δ terms −2ω×p_αq̇_α, −2Γ̂_αᵀωq̇_α, −2υ_αβᵀωq̇_β.
    #[inline(always)]
    pub fn add_coriolis<S: Simd>(
        &mut self,
        simd: S,
        integrals: &ModalIntegrals,
        rate: &Vector3<f64>,
        q_dot: &[f64],
        force: &mut [f64],
    ) {
        let n = q_dot.len();
        let mut momentum = Vector3::zeros();
        for (p, &q_dot) in integrals.momentum.iter().zip(q_dot) {
            momentum += p * q_dot;
        }
        add(&mut force[0..3], &(rate.cross(&momentum) * -2.0));
        let axes = self.freedom.axes();
        self.upsilon.times(simd, q_dot, &mut self.coriolis);
        for (i, &axis) in axes.iter().enumerate() {
            for (j, &other) in axes.iter().enumerate() {
                let turned = dot(gamma(&self.deformed, axes, [i, j], n), q_dot);
                force[3 + other] -= 2.0 * rate[axis] * turned;
            }
            let upsilon = &self.coriolis[i * block_length(n)..][..n];
            for (force, upsilon) in force[6..].iter_mut().zip(upsilon) {
                *force -= 2.0 * rate[axis] * upsilon;
            }
        }
    }
}

/// Length of the block of one component.
fn block_length(modes: usize) -> usize {
    modes.next_multiple_of(LANES)
}

/// The numbers Γ_ij of all modes, i and j counting the axes.
#[inline(always)]
fn gamma<'a>(numbers: &'a [f64], axes: &[usize], [i, j]: [usize; 2], modes: usize) -> &'a [f64] {
    &numbers[(axes.len() * (1 + i) + j) * block_length(modes)..][..modes]
}

#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// v and ω, body axes.
#[derive(Clone, Copy, Debug)]
pub struct RigidMotion {
    /// v, m/s.
    pub velocity: Vector3<f64>,
    /// ω, rad/s.
    pub rate: Vector3<f64>,
}

/// Adds a vector to three entries of a slice.
pub fn add(target: &mut [f64], vector: &Vector3<f64>) {
    for (target, value) in target.iter_mut().zip(vector.iter()) {
        *target += value;
    }
}

/// [[m1, −c×], [c×, J]].
fn rigid_mass_matrix(mass: f64, first_moment: &Vector3<f64>, inertia: &Matrix3<f64>) -> Matrix6<f64> {
    let cross = first_moment.cross_matrix();
    let mut matrix = Matrix6::zeros();
    matrix.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(mass);
    matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&-cross);
    matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&cross);
    matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(inertia);
    matrix
}

/// [[rigid, (p; h)], [(p; h)ᵀ, M]] without the rows and columns that do not move; `numbers` begin with those of h.
fn write_mass_matrix(
    integrals: &ModalIntegrals,
    freedom: RigidFreedom,
    rigid: &Matrix6<f64>,
    numbers: &[f64],
    matrix: &mut [f64],
) {
    let (components, n) = (freedom.components(), integrals.modes());
    let first = components.len();
    let size = first + n;
    for (row, &i) in components.iter().enumerate() {
        for (column, &j) in components.iter().enumerate() {
            matrix[row * size + column] = rigid[(i, j)];
        }
        for a in 0..n {
            let h = |axis: usize| numbers[freedom.place(axis) * block_length(n) + a];
            let coupling = if i < 3 { integrals.momentum[a][i] } else { h(i - 3) };
            matrix[row * size + first + a] = coupling;
            matrix[(first + a) * size + row] = coupling;
        }
    }
    for a in 0..n {
        let row = (first + a) * size + first;
        matrix[row..row + n].copy_from_slice(&integrals.mass_matrix[a * n..(a + 1) * n]);
    }
}
