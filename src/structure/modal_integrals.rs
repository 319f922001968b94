//! The integrals of the mode shapes over the mass [theory: structure.integrals; thesis §2.2, §3.1].
//!
//! Symbols: c₀ `first_moment`, J₀ `inertia`, p `momentum`, h `angular_momentum`, Γ `gamma`, Π `pi`,
//! υ `upsilon`, M `mass_matrix`. With particle positions r and mode shapes ψ there, each is one sum.

use nalgebra::{DMatrix, Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use super::assembly::Structure;

/// Integrals over the mass for n modes; pairs are stored at [α n + β].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ModalIntegrals {
    /// m, kg.
    pub mass: f64,
    /// c₀ = Σ m r, kg·m.
    pub first_moment: Vector3<f64>,
    /// J₀ = −Σ m r× r×, kg·m².
    pub inertia: Matrix3<f64>,
    /// p_α = Σ m ψ_α.
    pub momentum: Vec<Vector3<f64>>,
    /// h_α = Σ m r× ψ_α.
    pub angular_momentum: Vec<Vector3<f64>>,
    /// Γ_α = −Σ m ψ_α× r×.
    pub gamma: Vec<Matrix3<f64>>,
    /// Π_αβ = −Σ m ψ_α× ψ_β×.
    pub pi: Vec<Matrix3<f64>>,
    /// υ_αβ = −Σ m ψ_α× ψ_β.
    pub upsilon: Vec<Vector3<f64>>,
    /// M_αβ = Σ m ψ_αᵀ ψ_β.
    pub mass_matrix: Vec<f64>,
}

impl ModalIntegrals {
    /// Sums over all particles of a structure with the given mode shapes (one column per mode).
    pub fn new(structure: &Structure, shapes: &DMatrix<f64>) -> Self {
        let n = shapes.ncols();
        let mut sums = ModalIntegrals {
            mass: 0.0,
            first_moment: Vector3::zeros(),
            inertia: Matrix3::zeros(),
            momentum: vec![Vector3::zeros(); n],
            angular_momentum: vec![Vector3::zeros(); n],
            gamma: vec![Matrix3::zeros(); n],
            pi: vec![Matrix3::zeros(); n * n],
            upsilon: vec![Vector3::zeros(); n * n],
            mass_matrix: vec![0.0; n * n],
        };
        for particle in &structure.particles {
            let geometry = &structure.geometry[particle.attachment.beam];
            let position = geometry.position(particle.attachment.fraction) + particle.offset;
            let map = particle.displacement(geometry);
            let rows = structure.apply_map(particle.attachment.beam, &map, shapes);
            let psi: Vec<_> = (0..n).map(|a| Vector3::new(rows[a], rows[n + a], rows[2 * n + a])).collect();
            sums.add(particle.mass, &position, &psi);
        }
        sums
    }

    /// Number of modes.
    pub fn modes(&self) -> usize {
        self.momentum.len()
    }

    /// The integrals of a choice of modes.
    pub fn select(&self, chosen: &[usize]) -> Self {
        let n = self.modes();
        let pairs = || chosen.iter().flat_map(|&a| chosen.iter().map(move |&b| a * n + b));
        ModalIntegrals {
            mass: self.mass,
            first_moment: self.first_moment,
            inertia: self.inertia,
            momentum: chosen.iter().map(|&a| self.momentum[a]).collect(),
            angular_momentum: chosen.iter().map(|&a| self.angular_momentum[a]).collect(),
            gamma: chosen.iter().map(|&a| self.gamma[a]).collect(),
            pi: pairs().map(|ab| self.pi[ab]).collect(),
            upsilon: pairs().map(|ab| self.upsilon[ab]).collect(),
            mass_matrix: pairs().map(|ab| self.mass_matrix[ab]).collect(),
        }
    }

    /// The integrals of coordinates with such shares in these, a column each.
    pub fn combine(&self, shares: &DMatrix<f64>) -> Self {
        let n = self.modes();
        ModalIntegrals {
            mass: self.mass,
            first_moment: self.first_moment,
            inertia: self.inertia,
            momentum: combined(shares, &self.momentum),
            angular_momentum: combined(shares, &self.angular_momentum),
            gamma: combined(shares, &self.gamma),
            pi: combined_pairs(shares, n, &self.pi),
            upsilon: combined_pairs(shares, n, &self.upsilon),
            mass_matrix: combined_pairs(shares, n, &self.mass_matrix),
        }
    }

    /// Whether all arrays have the lengths that n modes ask for.
    pub fn is_consistent(&self, n: usize) -> bool {
        [self.momentum.len(), self.angular_momentum.len(), self.gamma.len()] == [n; 3]
            && [self.pi.len(), self.upsilon.len(), self.mass_matrix.len()] == [n * n; 3]
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let vectors = self.momentum.iter().chain(&self.angular_momentum).chain(&self.upsilon);
        let matrices = self.gamma.iter().chain(&self.pi).chain([&self.inertia]);
        self.mass.is_finite()
            && self.mass_matrix.iter().all(|x| x.is_finite())
            && vectors.chain([&self.first_moment]).flat_map(|vector| vector.iter()).all(|x| x.is_finite())
            && matrices.flat_map(|matrix| matrix.iter()).all(|x| x.is_finite())
    }

    fn add(&mut self, mass: f64, position: &Vector3<f64>, psi: &[Vector3<f64>]) {
        let n = psi.len();
        let r = position.cross_matrix();
        self.mass += mass;
        self.first_moment += position * mass;
        self.inertia -= r * r * mass;
        for (a, psi_a) in psi.iter().enumerate() {
            let cross_a = psi_a.cross_matrix();
            self.momentum[a] += psi_a * mass;
            self.angular_momentum[a] += position.cross(psi_a) * mass;
            self.gamma[a] -= cross_a * r * mass;
            for (b, psi_b) in psi.iter().enumerate() {
                self.pi[a * n + b] -= cross_a * psi_b.cross_matrix() * mass;
                self.upsilon[a * n + b] -= psi_a.cross(psi_b) * mass;
                self.mass_matrix[a * n + b] += psi_a.dot(psi_b) * mass;
            }
        }
    }
}

/// A number, vector or matrix for each coordinate, from those of the modes in which they have shares.
fn combined<T>(shares: &DMatrix<f64>, of_modes: &[T]) -> Vec<T>
where
    T: Copy + std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T>,
{
    let sum = |column: nalgebra::DVectorView<f64>| {
        column.iter().zip(of_modes).map(|(share, of_mode)| *of_mode * *share).reduce(|sum, next| sum + next)
    };
    shares.column_iter().filter_map(sum).collect()
}

/// The same for each pair, stored at [α n + β].
fn combined_pairs<T>(shares: &DMatrix<f64>, n: usize, of_pairs: &[T]) -> Vec<T>
where
    T: Copy + std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T>,
{
    let rows: Vec<Vec<T>> = of_pairs.chunks(n).map(|row| combined(shares, row)).collect();
    let columns = (0..shares.ncols()).map(|place| rows.iter().map(|row| row[place]).collect::<Vec<T>>());
    let by_columns: Vec<Vec<T>> = columns.map(|column| combined(shares, &column)).collect();
    (0..shares.ncols()).flat_map(|a| by_columns.iter().map(move |column| column[a])).collect()
}
