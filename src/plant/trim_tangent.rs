//! How a trim moves with what it depends on: flight condition, the tunnel's flow, stiffness [theory: trim.tangent].
//!
//! A trim is a root x of a residual F(x, p). While p moves along a direction p′, x moves along a tangent x′ on which F does
//! not change: D(x′) = d/dε F(x + εx′, p + εp′) = 0. From x′ = 0 on, x′ is corrected by −J⁻¹ D(x′) with J = ∂F/∂x. D is a
//! central difference of fourth order, exact to rounding over the small changes that are asked for, and the errors of J only
//! leave the next correction something to do.

use std::array::from_fn;

use crate::math::{WIDTHS, slope, solve};

use super::system::Plant;
use super::trim::{Trim, TrimCondition};
use super::trim_search::Search;

/// Corrections of the tangent: each leaves as small a part of the error as J is wrong by, about 1e-8.
const CORRECTIONS: usize = 3;

/// A trim, and J there.
#[derive(Clone, Debug)]
pub struct TrimTangents {
    /// x.
    trim: Vec<f64>,
    /// J, row-major.
    jacobian: Vec<f64>,
}

impl TrimTangents {
    /// At a trim that this plant has found under this condition. Allocates.
    pub fn new(plant: &Plant, condition: &TrimCondition, trim: &Trim) -> Self {
        let mut jacobian = vec![0.0; trim.unknowns.len() * trim.unknowns.len()];
        let steady = plant.with_steady_inflow();
        Search::resume(&steady, *condition, &trim.unknowns).jacobian(&mut jacobian);
        TrimTangents { trim: trim.unknowns.clone(), jacobian }
    }

    /// The trims where plant and condition have changed along some direction, by [`WIDTHS`] of the change, up to errors
    /// of second order. Allocates. `None` where J is singular.
    pub fn neighbours(&self, changed: &[(Plant, TrimCondition); 4]) -> Option<[Trim; 4]> {
        let origin = &self.trim;
        let steady = changed.each_ref().map(|(plant, _)| plant.with_steady_inflow());
        let mut searches: [_; 4] = from_fn(|place| Search::resume(&steady[place], changed[place].1, origin));
        let mut tangent = vec![0.0; origin.len()];
        let mut residuals = [(); 4].map(|()| vec![0.0; origin.len()]);
        let mut evaluate = |tangent: &[f64]| {
            for ((search, residual), width) in searches.iter_mut().zip(&mut residuals).zip(WIDTHS) {
                let unknowns = origin.iter().zip(tangent).map(|(origin, tangent)| origin + width * tangent);
                search.set_unknowns(unknowns);
                search.residual(residual);
            }
            let along = |row: usize| slope(residuals.each_ref().map(|residual| residual[row]));
            (0..tangent.len()).map(along).collect::<Vec<f64>>()
        };
        for _ in 0..CORRECTIONS {
            let mut correction = evaluate(&tangent);
            if !solve(&self.jacobian, &mut correction) {
                return None;
            }
            for (tangent, correction) in tangent.iter_mut().zip(correction) {
                *tangent -= correction;
            }
        }
        evaluate(&tangent);
        Some(from_fn(|place| searches[place].trim_of(&changed[place].0)))
    }
}
