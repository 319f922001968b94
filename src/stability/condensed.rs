//! The linearised motion with its wake eliminated: a small nonlinear eigenvalue problem.
//!
//! [theory: stability.condensed, stability.inverse-iteration, stability.modes]
//!
//! With x the rigid motion, q and q̇ and η the inflow, ẋ = F x + B η and η̇ = C x + D η. D is diagonal but for
//! the 2 × 2 blocks of complex inflow states, so that η = (λ − D)⁻¹ C x is cheap and
//!
//! ```text
//! T(λ) x = [λ − F − κ B (λ − D)⁻¹ C] x = 0,
//! ```
//!
//! with κ = 1; κ = 0 freezes the wake and leaves the eigenvalues of F. A root near a known one is found by
//! inverse iteration (Ruhe, *Algorithms for the nonlinear eigenvalue problem*, SIAM J. Numer. Anal. 10, 1973):
//! u = T⁻¹ T′ x, λ ← λ − 1/(xᴴu), x ← u/|u|; it is Newton's method, and converges quadratically.

use nalgebra::{Complex, DMatrix, DVector, Schur};

use crate::plant::{StateMatrix, Unknown, WakeBlocks, product};

/// Iterations in which a near root is found, or none.
const MAX_ITERATIONS: usize = 12;

/// Inverse iterations for a left shape, each of which gains nine digits.
const LEFT_ITERATIONS: usize = 2;

/// Change of an eigenvalue that no longer counts, relative to it and to the size of F.
const CONVERGED: (f64, f64) = (1e-10, 1e-14);

/// Relative size at which the eigensolver drops a subdiagonal entry; its eigenvalues are refined afterwards.
const DEFLATION: f64 = 1e-13;

/// Relative distance within which eigenvalues count as equal.
const EQUAL: f64 = 1e-6;

/// What a metre of height counts where shapes are compared, as metres a second: about g/V, by which height and speed exchange their energy. In
/// slow motions height would else be so much more than all the rest, in its own unit, that they seemed to be alike.
const HEIGHT: f64 = 0.1;

/// A root of the linearised motion: e^(λt) times a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Root {
    /// λ, 1/s.
    pub eigenvalue: Complex<f64>,
    /// Rigid motion, q and q̇ of the motion, of unit length; the wake is left out.
    pub shape: DVector<Complex<f64>>,
}

impl Root {
    /// The same root, or the upper one of its pair; real where it is that but for rounding.
    pub(super) fn upper(self) -> Self {
        let Root { mut eigenvalue, shape } = self;
        if eigenvalue.im.abs() <= EQUAL * eigenvalue.norm() {
            eigenvalue.im = 0.0;
        }
        if eigenvalue.im < 0.0 {
            return Root { eigenvalue: eigenvalue.conj(), shape: shape.map(|x| x.conj()) };
        }
        Root { eigenvalue, shape }
    }

    /// Whether the eigenvalues are the same but for rounding.
    pub fn is_at(&self, eigenvalue: Complex<f64>) -> bool {
        (self.eigenvalue - eigenvalue).norm() <= EQUAL * (1.0 + eigenvalue.norm())
    }
}

/// F, B, C, D and κ.
#[derive(Clone, Debug)]
pub(super) struct Condensed {
    motion: DMatrix<f64>,
    wake_on_motion: DMatrix<f64>,
    motion_on_wake: DMatrix<f64>,
    wake: WakeBlocks,
    coupling: f64,
    /// Place of the height among the unknowns, if it is one of them.
    height: Option<usize>,
}

impl Condensed {
    /// Of the whole linearised motion.
    pub fn new(state_matrix: &StateMatrix) -> Self {
        let StateMatrix { unknowns, matrix } = state_matrix;
        let motion = state_matrix.motion_count();
        let wake = unknowns.len() - motion;
        let part = |from: (usize, usize), size: (usize, usize)| matrix.view(from, size).into_owned();
        Condensed {
            motion: part((0, 0), (motion, motion)),
            wake_on_motion: part((0, motion), (motion, wake)),
            motion_on_wake: part((motion, 0), (wake, motion)),
            wake: WakeBlocks::of(&part((motion, motion), (wake, wake))),
            coupling: 1.0,
            height: unknowns.iter().position(|unknown| *unknown == Unknown::Down),
        }
    }

    /// How many numbers it holds.
    pub fn numbers(&self) -> usize {
        self.motion.len() + self.wake_on_motion.len() + self.motion_on_wake.len()
    }

    /// The same with another κ.
    pub fn with_coupling(&self, coupling: f64) -> Self {
        Condensed { coupling, ..self.clone() }
    }

    /// A share of the way from here to another motion of the same unknowns, in each entry [theory: stability.between].
    pub fn towards(&self, other: &Condensed, share: f64) -> Self {
        let between = |one: &DMatrix<f64>, other: &DMatrix<f64>| one * (1.0 - share) + other * share;
        Condensed {
            motion: between(&self.motion, &other.motion),
            wake_on_motion: between(&self.wake_on_motion, &other.wake_on_motion),
            motion_on_wake: between(&self.motion_on_wake, &other.motion_on_wake),
            wake: self.wake.towards(&other.wake, share),
            coupling: self.coupling,
            height: self.height,
        }
    }

    /// The same with an inflow that follows the motion ε > 0 times as slowly [theory: stability.modes].
    pub fn with_lag(&self, lag: f64) -> Self {
        let faster = 1.0 / lag;
        let inflow = self.wake.divide(&self.motion_on_wake);
        Condensed {
            motion: &self.motion + &self.wake_on_motion * inflow * (faster - 1.0),
            wake: self.wake.scaled(faster),
            coupling: faster * faster,
            ..self.clone()
        }
    }

    /// The roots with the wake frozen (κ = 0), one of each complex pair, slowest first.
    pub fn frozen_roots(&self) -> Vec<Root> {
        if self.motion.is_empty() {
            return Vec::new();
        }
        let frozen = self.with_coupling(0.0);
        let cap = 1000 * self.motion.nrows();
        let Some(schur) = Schur::try_new(self.motion.clone(), DEFLATION, cap) else {
            return Vec::new();
        };
        let mut eigenvalues: Vec<_> = schur.complex_eigenvalues().iter().copied().collect();
        eigenvalues.retain(|eigenvalue| eigenvalue.im >= 0.0);
        eigenvalues.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        let mut roots: Vec<Root> = Vec::new();
        for eigenvalue in eigenvalues {
            let found = frozen.root_at(eigenvalue, &roots);
            roots.extend(found);
        }
        roots
    }

    /// The root at a known eigenvalue, with a shape other than those of the known roots that share it.
    pub fn root_at(&self, eigenvalue: Complex<f64>, known: &[Root]) -> Option<Root> {
        let beside = eigenvalue + Complex::from(1e-9 * (1.0 + eigenvalue.norm()));
        let inverse = self.characteristic(beside).try_inverse()?;
        let sharing: Vec<&Root> = known.iter().filter(|root| root.is_at(eigenvalue)).collect();
        let shapes = inverse.column_iter().map(|column| {
            let mut shape = column.into_owned();
            for root in &sharing {
                let share = root.shape.dotc(&shape);
                shape.axpy(-share, &root.shape, Complex::from(1.0));
            }
            shape
        });
        let mut shape = shapes.max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
        shape /= Complex::from(shape.norm());
        self.refine(&Root { eigenvalue: beside, shape }).filter(|root| root.is_at(eigenvalue))
    }

    /// How much the shapes of two roots agree, 0 to 1 (the modal assurance criterion) [theory: stability.agreement].
    pub fn agreement(&self, one: &Root, other: &Root) -> f64 {
        // The whole product, and what is too much of it.
        let product = |one: &Root, other: &Root| {
            let of_height = |at: usize| one.shape[at].conj() * other.shape[at] * (1.0 - HEIGHT * HEIGHT);
            one.shape.dotc(&other.shape) - self.height.map_or(Complex::from(0.0), of_height)
        };
        product(one, other).norm_sqr() / (product(one, one).re * product(other, other).re)
    }

    /// The root near a guess [theory: stability.inverse-iteration].
    pub fn refine(&self, guess: &Root) -> Option<Root> {
        let Root { mut eigenvalue, mut shape } = guess.clone();
        let (relative, absolute) = CONVERGED;
        let floor = absolute * self.motion.norm();
        for _ in 0..MAX_ITERATIONS {
            let slope = self.slope(eigenvalue, &shape);
            // A singular T says that the eigenvalue is exact.
            let Some(next) = self.characteristic(eigenvalue).lu().solve(&slope) else {
                return Some(Root { eigenvalue, shape });
            };
            let correction = shape.dotc(&next).inv();
            let size = next.norm();
            if !(correction.norm().is_finite() && size.is_finite()) {
                return None;
            }
            eigenvalue -= correction;
            shape = next / Complex::from(size);
            if correction.norm() <= relative * eigenvalue.norm() + floor {
                return Some(Root { eigenvalue, shape });
            }
        }
        None
    }

    /// The shape of the left eigenvector at a root, of unit length: wᵀ T(λ) = 0.
    pub fn left_shape(&self, root: &Root) -> Option<DVector<Complex<f64>>> {
        let beside = root.eigenvalue + Complex::from(1e-9 * (1.0 + root.eigenvalue.norm()));
        let transposed = self.characteristic(beside).transpose().lu();
        let mut shape = root.shape.map(|x| x.conj());
        for _ in 0..LEFT_ITERATIONS {
            shape = transposed.solve(&shape)?;
            shape /= Complex::from(shape.norm());
        }
        Some(shape)
    }

    /// How much each unknown of the motion takes part in a root: |w_i v_i| of its left and right eigenvector, which are 1 in
    /// sum with those of the inflow η + D⁻¹ C x.
    pub fn participations(&self, root: &Root, left: &DVector<Complex<f64>>) -> Vec<f64> {
        let (at, rest) = (root.eigenvalue, Complex::from(0.0));
        let transposed = self.wake.transposed();
        let forcing = product(&self.motion_on_wake, &root.shape);
        let inflow = self.wake.answered(at, forcing.clone()) - self.wake.answered(rest, forcing);
        let left_forcing = product(&self.wake_on_motion.transpose(), left) * Complex::from(self.coupling);
        let left_inflow = transposed.answered(at, left_forcing);
        let at_rest = transposed.answered(rest, left_inflow.clone());
        let left_motion = left + product(&self.motion_on_wake.transpose(), &at_rest);
        let motion = products(&left_motion, &root.shape);
        let all: f64 = motion.iter().chain(&products(&left_inflow, &inflow)).sum();
        motion.into_iter().map(|share| share / all).collect()
    }

    /// T(λ).
    fn characteristic(&self, eigenvalue: Complex<f64>) -> DMatrix<Complex<f64>> {
        let by_wake = self.wake.eliminated(eigenvalue, &self.wake_on_motion, &self.motion_on_wake);
        DMatrix::from_fn(self.motion.nrows(), self.motion.nrows(), |i, j| {
            let diagonal = if i == j { eigenvalue } else { Complex::from(0.0) };
            diagonal - self.motion[(i, j)] - by_wake[(i, j)] * self.coupling
        })
    }

    /// T′(λ) x = x + κ B (λ − D)⁻² C x.
    fn slope(&self, eigenvalue: Complex<f64>, shape: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
        let once = self.wake.answered(eigenvalue, product(&self.motion_on_wake, shape));
        let twice = self.wake.answered(eigenvalue, once);
        shape + product(&self.wake_on_motion, &twice) * Complex::from(self.coupling)
    }
}

/// |w_i v_i|.
fn products(left: &DVector<Complex<f64>>, right: &DVector<Complex<f64>>) -> Vec<f64> {
    left.iter().zip(right.iter()).map(|(w, v)| (w * v).norm()).collect()
}
