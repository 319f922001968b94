//! Inertia of the deformed aircraft: mass matrix and inertial forcing [2.2–2.4; physics.md §2].

use nalgebra::{Matrix3, Matrix6, Vector3};

use crate::structure::ModalIntegrals;

use super::freedom::RigidFreedom;

/// The deformation-dependent integrals ĉ, Ĵ, Γ̂, ĥ at one q.
#[derive(Clone, Debug)]
pub struct DeformedInertia {
    /// ĉ = c₀ + p_α q_α, kg·m.
    pub first_moment: Vector3<f64>,
    /// Ĵ = J₀ + (Γᵀ + Γ)q + Πqq, kg·m².
    pub inertia: Matrix3<f64>,
    /// Γ̂_α = Γ_α + Π_αβ q_β.
    pub gamma: Vec<Matrix3<f64>>,
    /// ĥ_α = h_α + υ_αβ q_β.
    pub angular_momentum: Vec<Vector3<f64>>,
    /// For each β the numbers of h_α's slope υ_αβ of all α, then those of Γ_α's slope Π_αβ.
    slopes: Vec<Vec<f64>>,
    /// Room for a sum of slopes.
    sum: Vec<f64>,
}

impl DeformedInertia {
    /// The undeformed values.
    pub fn undeformed(integrals: &ModalIntegrals) -> Self {
        let n = integrals.modes();
        let slope = |b: usize| {
            let upsilon = (0..n).flat_map(|a| integrals.upsilon[a * n + b].iter());
            upsilon.chain((0..n).flat_map(|a| integrals.pi[a * n + b].iter())).copied().collect()
        };
        DeformedInertia {
            first_moment: integrals.first_moment,
            inertia: integrals.inertia,
            gamma: integrals.gamma.clone(),
            angular_momentum: integrals.angular_momentum.clone(),
            slopes: (0..n).map(slope).collect(),
            sum: vec![0.0; 12 * n],
        }
    }

    /// Evaluates all integrals at q.
    #[inline(always)]
    pub fn deform(&mut self, integrals: &ModalIntegrals, q: &[f64]) {
        let n = q.len();
        sum_slopes(&self.slopes, q, &mut self.sum);
        self.first_moment = integrals.first_moment;
        self.inertia = integrals.inertia;
        let (vectors, matrices) = self.sum.split_at(3 * n);
        for (a, (vector, matrix)) in vectors.chunks_exact(3).zip(matrices.chunks_exact(9)).enumerate() {
            self.angular_momentum[a] = integrals.angular_momentum[a] + Vector3::from_column_slice(vector);
            self.gamma[a] = integrals.gamma[a] + Matrix3::from_column_slice(matrix);
            self.first_moment += integrals.momentum[a] * q[a];
            self.inertia += (integrals.gamma[a].transpose() + self.gamma[a]) * q[a];
        }
    }

    /// Writes the mass matrix of the present deformation, row-major on the components of ν = [v; ω; q̇] that move.
    pub fn write_mass_matrix(&self, integrals: &ModalIntegrals, freedom: RigidFreedom, matrix: &mut [f64]) {
        let rigid = rigid_mass_matrix(integrals.mass, &self.first_moment, &self.inertia);
        write_mass_matrix(integrals, freedom, &rigid, &self.angular_momentum, matrix);
    }

    /// Adds the inertial forcing of the rigid motion: −mω×v + ω×cω… without the δ terms in q̇.
    pub fn add_forcing(&self, mass: f64, momentum: &[Vector3<f64>], motion: &RigidMotion, force: &mut [f64]) {
        let RigidMotion { velocity, rate } = motion;
        let transport = rate.cross(velocity);
        let c = &self.first_moment;
        add(&mut force[0..3], &(-transport * mass + rate.cross(&c.cross(rate))));
        add(&mut force[3..6], &(-c.cross(&transport) - rate.cross(&(self.inertia * rate))));
        for ((force, gamma), p) in force[6..].iter_mut().zip(&self.gamma).zip(momentum) {
            *force += rate.dot(&(gamma * rate)) - p.dot(&transport);
        }
    }

    /// Adds the δ terms −2ω×p_αq̇_α, −2Γ̂_αᵀωq̇_α, −2υ_αβᵀωq̇_β.
    #[inline(always)]
    pub fn add_coriolis(
        &mut self,
        integrals: &ModalIntegrals,
        rate: &Vector3<f64>,
        q_dot: &[f64],
        force: &mut [f64],
    ) {
        let (mut momentum, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for ((p, gamma), &q_dot) in integrals.momentum.iter().zip(&self.gamma).zip(q_dot) {
            momentum += p * q_dot;
            moment += gamma.tr_mul(rate) * q_dot;
        }
        add(&mut force[0..3], &(rate.cross(&momentum) * -2.0));
        add(&mut force[3..6], &(moment * -2.0));
        let coriolis = &mut self.sum[..3 * q_dot.len()];
        sum_slopes(&self.slopes, q_dot, coriolis);
        for (force, coriolis) in force[6..].iter_mut().zip(coriolis.chunks_exact(3)) {
            *force -= 2.0 * Vector3::from_column_slice(coriolis).dot(rate);
        }
    }
}

/// The first numbers of Σ slope_β x_β.
#[inline(always)]
fn sum_slopes(slopes: &[Vec<f64>], x: &[f64], sum: &mut [f64]) {
    sum.fill(0.0);
    for (slope, &x) in slopes.iter().zip(x) {
        for (sum, slope) in sum.iter_mut().zip(slope) {
            *sum += slope * x;
        }
    }
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

/// Writes the mass matrix of the undeformed aircraft, row-major on the components of ν = [v; ω; q̇] that move.
pub fn write_undeformed_mass_matrix(integrals: &ModalIntegrals, freedom: RigidFreedom, matrix: &mut [f64]) {
    let rigid = rigid_mass_matrix(integrals.mass, &integrals.first_moment, &integrals.inertia);
    write_mass_matrix(integrals, freedom, &rigid, &integrals.angular_momentum, matrix);
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

/// [[rigid, (p; h)], [(p; h)ᵀ, M]] without the rows and columns that do not move.
fn write_mass_matrix(
    integrals: &ModalIntegrals,
    freedom: RigidFreedom,
    rigid: &Matrix6<f64>,
    angular_momentum: &[Vector3<f64>],
    matrix: &mut [f64],
) {
    let (components, n) = (freedom.components(), angular_momentum.len());
    let first = components.len();
    let size = first + n;
    for (row, &i) in components.iter().enumerate() {
        for (column, &j) in components.iter().enumerate() {
            matrix[row * size + column] = rigid[(i, j)];
        }
        for a in 0..n {
            let coupling = if i < 3 { integrals.momentum[a][i] } else { angular_momentum[a][i - 3] };
            matrix[row * size + first + a] = coupling;
            matrix[(first + a) * size + row] = coupling;
        }
    }
    for a in 0..n {
        let row = (first + a) * size + first;
        matrix[row..row + n].copy_from_slice(&integrals.mass_matrix[a * n..(a + 1) * n]);
    }
}
