//! Which coordinates of a packaged model take part [theory: structure.mode-count, load-modes.in-use].
//!
//! Natural modes take part or rest. Load modes are those of the natural modes in use: where a model has been packaged with
//! more of these, they are combined anew from all that is packaged.

use nalgebra::{DMatrix, DVector};

use super::load_modes::{Metric, load_modes};
use super::{Mode, ModeFamily, StaticLoad, StructureError};

/// The coordinates of a model, each one packaged mode or a combination of several.
#[derive(Clone, Debug, PartialEq)]
pub struct ModesInUse {
    coordinates: Vec<Coordinate>,
}

/// A coordinate of a model in use.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Coordinate {
    /// That of a packaged mode.
    Packaged(usize),
    /// Of a load mode, by its shares in all packaged ones.
    Combined(Mode, Vec<f64>),
}

impl ModesInUse {
    /// A choice of packaged modes (ascending indices).
    pub fn chosen(modes: &[usize]) -> Self {
        ModesInUse { coordinates: modes.iter().map(|&mode| Coordinate::Packaged(mode)).collect() }
    }

    /// Natural ones of the packaged modes (ascending indices) and, of the families that are `watched`, the load modes that
    /// belong to them.
    ///
    /// # Errors
    /// When no eigenvalues of the load modes are found.
    pub fn beside_loads(
        (packaged, loads): (&[Mode], &[StaticLoad]),
        natural: &[usize],
        watched: impl Fn(ModeFamily) -> bool,
    ) -> Result<Self, StructureError> {
        let mut in_use = ModesInUse::chosen(natural);
        for family in [ModeFamily::Symmetric, ModeFamily::Antisymmetric, ModeFamily::Unsymmetric] {
            let rest = |mode: &usize| {
                let Mode { family: own, of_loads, .. } = packaged[*mode];
                own == family && (of_loads || !natural.contains(mode))
            };
            let rest: Vec<usize> = (0..packaged.len()).filter(rest).collect();
            if !watched(family) {
                continue;
            }
            if rest.iter().all(|&mode| packaged[mode].of_loads) {
                in_use.coordinates.extend(rest.into_iter().map(Coordinate::Packaged));
            } else {
                in_use.coordinates.extend(combined((packaged, loads), natural, family)?);
            }
        }
        Ok(in_use)
    }

    /// Some of these coordinates (ascending indices).
    pub fn among(&self, kept: &[usize]) -> Self {
        ModesInUse { coordinates: kept.iter().map(|&place| self.coordinates[place].clone()).collect() }
    }

    /// How many coordinates there are.
    pub fn len(&self) -> usize {
        self.coordinates.len()
    }

    /// Whether everything rests.
    pub fn is_empty(&self) -> bool {
        self.coordinates.is_empty()
    }

    /// The packaged mode that a coordinate is of, unless it combines several.
    pub fn packaged(&self, coordinate: usize) -> Option<usize> {
        match self.coordinates.get(coordinate)? {
            Coordinate::Packaged(mode) => Some(*mode),
            Coordinate::Combined(..) => None,
        }
    }

    /// Writes the coordinates of the packaged modes, of which those that do not take part are zero.
    pub fn write_packaged(&self, in_use: &[f64], packaged: &mut [f64]) {
        packaged.fill(0.0);
        for (coordinate, &value) in self.coordinates.iter().zip(in_use) {
            match coordinate {
                Coordinate::Packaged(mode) => packaged[*mode] = value,
                Coordinate::Combined(_, shares) => {
                    packaged.iter_mut().zip(shares).for_each(|(sum, share)| *sum += share * value);
                }
            }
        }
    }

    /// The packaged modes, if each coordinate is that of one.
    pub(super) fn plain(&self) -> Option<Vec<usize>> {
        let plain = |coordinate: &Coordinate| match coordinate {
            Coordinate::Packaged(mode) => Some(*mode),
            Coordinate::Combined(..) => None,
        };
        self.coordinates.iter().map(plain).collect()
    }

    /// What the coordinates are, and their shares in the packaged ones.
    pub(super) fn columns(&self, packaged: &[Mode]) -> (Vec<Mode>, DMatrix<f64>) {
        let column = |coordinate: &Coordinate| match coordinate {
            Coordinate::Packaged(mode) => {
                (packaged[*mode], DVector::from_fn(packaged.len(), |i, _| f64::from(u8::from(i == *mode))))
            }
            Coordinate::Combined(mode, shares) => (*mode, DVector::from_column_slice(shares)),
        };
        let (modes, columns): (Vec<_>, Vec<_>) = self.coordinates.iter().map(column).unzip();
        (modes, DMatrix::from_columns(&columns))
    }
}

/// The load modes of one family beside natural modes: in the packaged coordinates, the mass of which is 1 and the stiffness
/// diagonal, a static load strains each by its force over ω².
fn combined(
    (packaged, loads): (&[Mode], &[StaticLoad]),
    natural: &[usize],
    family: ModeFamily,
) -> Result<Vec<Coordinate>, StructureError> {
    let n = packaged.len();
    let squares = DVector::from_iterator(n, packaged.iter().map(|mode| mode.angular_frequency.powi(2)));
    let of_family = loads.iter().filter(|load| load.family == family);
    let strained = of_family.map(|load| DVector::from_column_slice(&load.forces).component_div(&squares));
    let unit = |&mode: &usize| DVector::from_fn(n, |i, _| f64::from(u8::from(i == mode)));
    let natural: Vec<_> = natural.iter().map(unit).collect();
    let metric = Metric { mass: &DMatrix::identity(n, n), stiffness: &DMatrix::from_diagonal(&squares) };
    let modes = load_modes(strained.collect(), &natural, &metric)?.into_iter();
    Ok(modes
        .map(|(angular_frequency, shares)| {
            let mode = Mode { family, angular_frequency, completes_a_pair: false, of_loads: true };
            Coordinate::Combined(mode, shares.as_slice().to_vec())
        })
        .collect())
}
