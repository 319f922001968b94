//! Inertia of an aircraft that deforms by superposition: mass matrix and inertial forcing.
//!
//! [theory: kinematics.inertia, equations-of-motion.deformed-integrals, equations-of-motion.rows; thesis eq. 2.3]
//!
//! Constant shapes make every integral over the mass a polynomial of q, found once (`ModalIntegrals`): no bay is asked at an
//! instant.
//!
//! Γ̂_α and ĥ_α are linear in q, and both are needed along the axes about which the aircraft spins. They are kept
//! component by component, each for all modes, and come from one product of a constant matrix with q.

use nalgebra::{Matrix3, Vector3};

use crate::math::{AlignedNumbers, Arithmetic, Columns, LANES, SquareMatrix, zeros};
use crate::structure::ModalIntegrals;

use super::super::freedom::RigidFreedom;
use super::super::kind::{Coordinates, Inertia};
use super::super::rigid_motion::RigidMotion;
use super::super::velocities::GeneralisedVectorMut;
use super::superposition::{Instant, Superposition};

/// The deformation-dependent integrals ĉ, Ĵ, Γ̂, ĥ at one q [theory: equations-of-motion.deformed-integrals].
#[derive(Clone, Debug)]
pub struct SuperposedInertia {
    constant: ConstantIntegrals,
    /// ĉ = c₀ + p_α q_α, kg·m.
    first_moment: Vector3<f64>,
    /// Ĵ = J₀ + (Γᵀ + Γ)q + Πqq, kg·m².
    inertia: Matrix3<f64>,
    freedom: RigidFreedom,
    /// ĥ_α = h_α + υ_αβ q_β, then Γ̂_α = Γ_α + Π_αβ q_β: a block for each component, with a number for each mode.
    deformed: AlignedNumbers,
    /// The same undeformed.
    undeformed: AlignedNumbers,
    /// The mass matrix of the undeformed aircraft, of the components of ν that move.
    undeformed_mass_matrix: SquareMatrix,
    /// Their derivatives υ and Π by q.
    slopes: Columns,
    /// υ alone.
    upsilon: Columns,
    /// υ q̇.
    coriolis: AlignedNumbers,
}

/// What of the integrals does not go with each component.
#[derive(Clone, Debug)]
struct ConstantIntegrals {
    /// m, kg.
    mass: f64,
    /// c₀, kg·m.
    first_moment: Vector3<f64>,
    /// J₀, kg·m².
    inertia: Matrix3<f64>,
    /// p_α.
    momentum: Vec<Vector3<f64>>,
}

impl SuperposedInertia {
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
        let mut undeformed = zeros(rows);
        for (row, value) in undeformed.iter_mut().enumerate() {
            let h = |a: usize, i: usize| integrals.angular_momentum[a][i];
            *value = number(row, &h, &|a, [i, j]| integrals.gamma[a][(i, j)]);
        }
        let slope = |row: usize, b: usize| {
            number(row, &|a, i| integrals.upsilon[a * n + b][i], &|a, [i, j]| integrals.pi[a * n + b][(i, j)])
        };
        let mut inertia = SuperposedInertia {
            constant: ConstantIntegrals {
                mass: integrals.mass,
                first_moment: integrals.first_moment,
                inertia: integrals.inertia,
                momentum: integrals.momentum.clone(),
            },
            first_moment: integrals.first_moment,
            inertia: integrals.inertia,
            undeformed_mass_matrix: constant_mass_matrix(integrals, freedom),
            freedom,
            deformed: undeformed.clone(),
            slopes: Columns::new(rows, n, slope),
            upsilon: Columns::new(vectors * block, n, slope),
            coriolis: zeros(vectors * block),
            undeformed,
        };
        let mut matrix = inertia.undeformed_mass_matrix.clone();
        inertia.write_deformed_entries(&mut matrix);
        inertia.undeformed_mass_matrix = matrix;
        inertia
    }

    /// Writes those blocks of the mass matrix that depend on q.
    #[inline(always)]
    fn write_deformed_entries(&self, matrix: &mut SquareMatrix) {
        let [along, about] = self.freedom.motions();
        let first = along.len() + about.len();
        for (column, &axis) in (along.len()..first).zip(about) {
            let unit = Vector3::ith(axis, 1.0);
            let momentum = unit.cross(&self.first_moment);
            for (row, &along) in along.iter().enumerate() {
                matrix[(row, column)] = momentum[along];
                matrix[(column, row)] = momentum[along];
            }
            for (row, &other) in (along.len()..first).zip(about) {
                matrix[(row, column)] = self.inertia[(other, axis)];
            }
            let h = &self.deformed[self.freedom.place(axis) * block_length(matrix.size() - first)..];
            for (row, &h) in (first..matrix.size()).zip(h) {
                matrix[(row, column)] = h;
                matrix[(column, row)] = h;
            }
        }
    }

    /// Adds the inertial forcing of the rigid motion: −mω×v + ω×cω… without the δ terms in q̇.
    ///
    /// [theory: equations-of-motion.rows]
    #[inline(always)]
    fn add_forcing(&self, motion: &RigidMotion, force: &mut [f64]) {
        let ConstantIntegrals { mass, momentum, .. } = &self.constant;
        let RigidMotion { velocity, rate } = motion;
        let transport = rate.cross(velocity);
        let c = &self.first_moment;
        let mut force = GeneralisedVectorMut::of(force);
        force.add_rigid(
            &(-transport * *mass + rate.cross(&c.cross(rate))),
            &(-c.cross(&transport) - rate.cross(&(self.inertia * rate))),
        );
        for (force, p) in force.modal.iter_mut().zip(momentum) {
            *force -= p.dot(&transport);
        }
        let axes = self.freedom.axes();
        for (i, &axis) in axes.iter().enumerate() {
            for (j, &other) in axes.iter().enumerate() {
                let squares = rate[axis] * rate[other];
                let gamma = gamma(&self.deformed, axes, [i, j], momentum.len());
                for (force, gamma) in force.modal.iter_mut().zip(gamma) {
                    *force += gamma * squares;
                }
            }
        }
    }

    /// Adds the δ terms −2ω×p_αq̇_α, −2Γ̂_αᵀωq̇_α, −2υ_αβᵀωq̇_β.
    ///
    /// [theory: equations-of-motion.delta-terms; thesis §2.3]
    #[inline(always)]
    fn add_coriolis<S: Arithmetic>(
        &mut self,
        simd: S,
        rate: &Vector3<f64>,
        q_dot: &[f64],
        force: &mut [f64],
    ) {
        let n = q_dot.len();
        let mut momentum = Vector3::zeros();
        for (p, &q_dot) in self.constant.momentum.iter().zip(q_dot) {
            momentum += p * q_dot;
        }
        let mut force = GeneralisedVectorMut::of(force);
        force.add_translation(&(rate.cross(&momentum) * -2.0));
        let axes = self.freedom.axes();
        self.upsilon.times(simd, q_dot, &mut self.coriolis);
        for (i, &axis) in axes.iter().enumerate() {
            for (j, &other) in axes.iter().enumerate() {
                let turned = dot(gamma(&self.deformed, axes, [i, j], n), q_dot);
                force.rotation[other] -= 2.0 * rate[axis] * turned;
            }
            let upsilon = &self.coriolis[i * block_length(n)..][..n];
            for (force, upsilon) in force.modal.iter_mut().zip(upsilon) {
                *force -= 2.0 * rate[axis] * upsilon;
            }
        }
    }
}

impl Inertia<Superposition> for SuperposedInertia {
    /// Evaluates all integrals at q.
    #[inline(always)]
    fn deform<S: Arithmetic>(&mut self, simd: S, sections: &Instant<'_>) {
        let Coordinates { q, .. } = sections.coordinates;
        let ConstantIntegrals { first_moment, inertia, momentum, .. } = &self.constant;
        self.slopes.times(simd, q, &mut self.deformed);
        for (deformed, undeformed) in self.deformed.iter_mut().zip(self.undeformed.iter()) {
            *deformed += undeformed;
        }
        self.first_moment = *first_moment;
        for (momentum, &q) in momentum.iter().zip(q) {
            self.first_moment += momentum * q;
        }
        self.inertia = *inertia;
        let axes = self.freedom.axes();
        for (i, &axis) in axes.iter().enumerate() {
            for (j, &other) in axes.iter().enumerate() {
                let sum = dot(gamma(&self.undeformed, axes, [j, i], q.len()), q)
                    + dot(gamma(&self.deformed, axes, [i, j], q.len()), q);
                self.inertia[(axis, other)] += sum;
            }
        }
    }

    #[inline(always)]
    fn write_mass_matrix(&self, _: &Instant<'_>, deformed: bool, matrix: &mut SquareMatrix) {
        matrix.copy_from(&self.undeformed_mass_matrix);
        if deformed {
            self.write_deformed_entries(matrix);
        }
    }

    #[inline(always)]
    fn add_forces<S: Arithmetic>(
        &mut self,
        simd: S,
        sections: &Instant<'_>,
        motion: &RigidMotion,
        with_rates: bool,
        force: &mut [f64],
    ) {
        self.add_forcing(motion, force);
        if with_rates {
            self.add_coriolis(simd, &motion.rate, sections.coordinates.q_dot, force);
        }
    }

    #[inline(always)]
    fn add_gravity(&self, _: &Instant<'_>, gravity: &Vector3<f64>, force: &mut [f64]) {
        let mut force = GeneralisedVectorMut::of(force);
        force.add_rigid(&(gravity * self.constant.mass), &self.first_moment.cross(gravity));
        for (force, momentum) in force.modal.iter_mut().zip(&self.constant.momentum) {
            *force += momentum.dot(gravity);
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

/// The blocks m1, p and M of the mass matrix, which do not depend on q, without the rows and columns that do not move.
fn constant_mass_matrix(integrals: &ModalIntegrals, freedom: RigidFreedom) -> SquareMatrix {
    let n = integrals.modes();
    let first = freedom.components().len();
    let mut matrix = SquareMatrix::new(first + n);
    for (row, &axis) in freedom.motions()[0].iter().enumerate() {
        matrix[(row, row)] = integrals.mass;
        for (column, momentum) in (first..).zip(&integrals.momentum) {
            matrix[(row, column)] = momentum[axis];
            matrix[(column, row)] = momentum[axis];
        }
    }
    for (a, b) in (0..n).flat_map(|a| (0..n).map(move |b| (a, b))) {
        matrix[(first + a, first + b)] = integrals.mass_matrix[a * n + b];
    }
    matrix
}
