//! Modes of the clamped structure by family [theory: structure.modes, structure.families, load-modes.shapes; thesis §3.1].

use nalgebra::{Cholesky, DMatrix, DVector, DVectorView, SymmetricEigen};

use crate::aircraft::ModeBasis;

use super::assembly::Structure;
use super::load_modes::{MAX_ITERATIONS, Metric, load_modes};
use super::mirror::{self, Reflection};
use super::mode_count::ModeCount;
use super::pairs::Pairs;
use super::shared_unknowns::SharedUnknowns;
use super::static_loads::{StaticLoad, static_loads};
use super::{Mode, ModeFamily, ModeKind, StructureError};

/// Frequencies closer than this (relative) count as equal: symmetric before antisymmetric.
const DEGENERATE: f64 = 1e-9;

/// A smaller part of a load than this does not act in a family.
const PART_OF_A_LOAD: f64 = 1e-9;

/// Modes with their shapes.
#[derive(Debug)]
pub struct ModalBasis {
    /// Natural modes, lowest frequency first; then load modes, if there are any, by family and frequency.
    pub modes: Vec<Mode>,
    /// One column per mode, mass-normalised, on all nodal unknowns.
    pub shapes: DMatrix<f64>,
    /// What the load modes are the strains of.
    pub static_loads: Vec<StaticLoad>,
    /// The mirror of the structure, if it has one.
    pub(super) mirror: Option<Reflection>,
}

impl ModalBasis {
    /// Modes of one's own: with a column of mass-normalised shapes for each, orthogonal in mass and stiffness.
    pub fn of_shapes(modes: Vec<Mode>, shapes: DMatrix<f64>) -> Self {
        ModalBasis { modes, shapes, static_loads: Vec::new(), mirror: None }
    }

    /// The lowest modes of all families together; more where they would cut a pair in half.
    ///
    /// # Errors
    /// As [`with`](Self::with).
    pub fn new(structure: &Structure, count: impl Into<ModeCount>) -> Result<Self, StructureError> {
        Self::with(structure, count.into(), ModeKind::All)
    }

    /// The lowest modes of all families together, as many as it takes to have `count` of a kind among them.
    ///
    /// # Errors
    /// When the stiffness matrix is not positive definite, or the structure has no such modes.
    pub fn with(structure: &Structure, count: ModeCount, kind: ModeKind) -> Result<Self, StructureError> {
        let aircraft = structure.aircraft;
        let stiffness = structure.stiffness(aircraft.mode_basis == ModeBasis::BendingTorsion);
        let mass = structure.mass();
        // Axially rigid beams would hide a difference in bending.
        let mirror = Reflection::find(aircraft, &structure.stiffness(false), &mass);
        let shared = SharedUnknowns::of(aircraft);
        let family = |family, basis| Subspace::new(family, &stiffness, &mass, basis);
        let subspaces = match &mirror {
            Some(mirror) => [ModeFamily::Symmetric, ModeFamily::Antisymmetric]
                .map(|name| family(name, mirror.subspace(name, &shared)))
                .into_iter()
                .collect::<Result<Vec<_>, _>>()?,
            None => vec![family(ModeFamily::Unsymmetric, shared.columns())?],
        };
        let families = subspaces.iter().map(Subspace::natural_modes).collect::<Result<Vec<_>, _>>()?;
        let mut modes = families.into_iter().reduce(merge).unwrap_or_default();
        let count = count.lowest(kind, modes.iter().map(|(mode, _)| mode.family))?;
        if mirror.is_none() {
            Pairs::new(aircraft, &mass).mark(&mut modes, count);
        }
        let completed = modes[count..].iter().take_while(|(mode, _)| mode.completes_a_pair).count();
        modes.truncate(count + completed);
        let loads = if aircraft.load_modes { static_loads(structure, mirror.as_ref()) } else { Vec::new() };
        let further = subspaces.iter().map(|subspace| subspace.load_modes(&loads, &modes));
        modes.extend(further.collect::<Result<Vec<_>, _>>()?.into_iter().flatten());
        let (modes, shapes): (Vec<_>, Vec<_>) = modes.into_iter().unzip();
        let shapes = if shapes.is_empty() {
            DMatrix::zeros(structure.unknowns(), 0)
        } else {
            DMatrix::from_columns(&shapes)
        };
        let of_families = subspaces.iter().flat_map(|subspace| {
            let parts = loads.iter().filter_map(|load| subspace.part(load));
            parts.map(|part| subspace.static_load(&part, &modes, &shapes))
        });
        let static_loads = of_families.collect();
        Ok(ModalBasis { modes, shapes, static_loads, mirror })
    }
}

/// A mode with its shape on all nodal unknowns.
type Shaped = (Mode, DVector<f64>);

/// The motion of one family: a subspace of that of all nodal unknowns.
struct Subspace<'m> {
    family: ModeFamily,
    stiffness: &'m DMatrix<f64>,
    mass: &'m DMatrix<f64>,
    basis: Vec<Vec<(usize, f64)>>,
    /// L of K = L Lᵀ in the subspace.
    lower: DMatrix<f64>,
}

impl<'m> Subspace<'m> {
    fn new(
        family: ModeFamily,
        stiffness: &'m DMatrix<f64>,
        mass: &'m DMatrix<f64>,
        basis: Vec<Vec<(usize, f64)>>,
    ) -> Result<Self, StructureError> {
        let factor = Cholesky::new(mirror::restrict(stiffness, &basis)).ok_or(StructureError::Mechanism)?;
        Ok(Subspace { family, stiffness, mass, basis, lower: factor.l() })
    }

    /// All natural modes, lowest first: solves M φ = (1/ω²) K φ with the Cholesky factor of K, since M is singular
    /// [theory: structure.modes].
    fn natural_modes(&self) -> Result<Vec<Shaped>, StructureError> {
        if self.basis.is_empty() {
            return Ok(Vec::new());
        }
        let solve = |mut matrix: DMatrix<f64>| {
            self.lower.solve_lower_triangular_mut(&mut matrix);
            matrix
        };
        let flexibility = solve(solve(mirror::restrict(self.mass, &self.basis)).transpose());
        let self_adjoint = (&flexibility + flexibility.transpose()) * 0.5;
        let eigen = SymmetricEigen::try_new(self_adjoint, f64::EPSILON, MAX_ITERATIONS)
            .ok_or(StructureError::EigenvaluesNotFound)?;

        let mut order: Vec<usize> = (0..self.basis.len()).collect();
        order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
        let massless = 1e-12 * eigen.eigenvalues[order[0]];
        let mut modes = Vec::new();
        for index in order.into_iter().take_while(|&index| eigen.eigenvalues[index] > massless) {
            let angular_frequency = 1.0 / eigen.eigenvalues[index].sqrt();
            let mut shape = eigen.eigenvectors.column(index) * angular_frequency;
            self.lower.tr_solve_lower_triangular_mut(&mut shape);
            modes.push(self.mode(angular_frequency, self.expand(&shape), false));
        }
        Ok(modes)
    }

    /// The load modes beside natural ones [theory: load-modes.shapes].
    fn load_modes(&self, loads: &[DVector<f64>], natural: &[Shaped]) -> Result<Vec<Shaped>, StructureError> {
        let strained = loads.iter().filter_map(|load| self.strained(load)).collect();
        let of_family = natural.iter().filter(|(mode, _)| mode.family == self.family);
        let natural: Vec<_> = of_family.map(|(_, shape)| shape.clone()).collect();
        let metric = Metric { mass: self.mass, stiffness: self.stiffness };
        let modes = load_modes(strained, &natural, &metric)?.into_iter();
        Ok(modes.map(|(angular_frequency, shape)| self.mode(angular_frequency, shape, true)).collect())
    }

    /// K⁻¹f of the part of a load that belongs to the family, if there is one.
    fn strained(&self, load: &DVector<f64>) -> Option<DVector<f64>> {
        let mut part = self.part(load)?;
        self.lower.solve_lower_triangular_mut(&mut part);
        self.lower.tr_solve_lower_triangular_mut(&mut part);
        Some(self.expand(&part))
    }

    /// The part of a load that acts in the family, if there is one.
    fn part(&self, load: &DVector<f64>) -> Option<DVector<f64>> {
        let part = mirror::project(load, &self.basis);
        (part.norm() > PART_OF_A_LOAD * load.norm()).then_some(part)
    }

    /// What the part of a load that acts in the family does to the modes: nothing to those of other families.
    fn static_load(&self, part: &DVector<f64>, modes: &[Mode], shapes: &DMatrix<f64>) -> StaticLoad {
        let load = self.expand(part);
        let force = |(mode, shape): (&Mode, DVectorView<f64>)| {
            if mode.family == self.family { shape.dot(&load) } else { 0.0 }
        };
        StaticLoad {
            family: self.family,
            forces: modes.iter().zip(shapes.column_iter()).map(force).collect(),
        }
    }

    fn mode(&self, angular_frequency: f64, mut shape: DVector<f64>, of_loads: bool) -> Shaped {
        fix_sign(&mut shape);
        (Mode { family: self.family, angular_frequency, completes_a_pair: false, of_loads }, shape)
    }

    fn expand(&self, coordinates: &DVector<f64>) -> DVector<f64> {
        mirror::expand(coordinates.as_slice(), &self.basis, self.mass.nrows())
    }
}

/// Makes the largest nodal translation component positive: the first of equals in node order.
///
/// [theory: structure.modes]
fn fix_sign(shape: &mut DVector<f64>) {
    let translations = || (0..shape.len()).filter(|unknown| unknown % 6 < 3);
    let largest = translations().map(|unknown| shape[unknown].abs()).fold(0.0, f64::max);
    let first = translations().find(|&unknown| shape[unknown].abs() >= largest * (1.0 - DEGENERATE));
    if first.is_some_and(|unknown| shape[unknown] < 0.0) {
        shape.neg_mut();
    }
}

/// Merges two ascending families by frequency [theory: structure.families].
fn merge(symmetric: Vec<Shaped>, antisymmetric: Vec<Shaped>) -> Vec<Shaped> {
    let mut merged = Vec::with_capacity(symmetric.len() + antisymmetric.len());
    let (mut s, mut a) = (symmetric.into_iter().peekable(), antisymmetric.into_iter().peekable());
    loop {
        let symmetric_first = match (s.peek(), a.peek()) {
            (Some((left, _)), Some((right, _))) => {
                left.angular_frequency <= right.angular_frequency * (1.0 + DEGENERATE)
            }
            (left, _) => left.is_some(),
        };
        match if symmetric_first { s.next() } else { a.next() } {
            Some(mode) => merged.push(mode),
            None => return merged,
        }
    }
}
