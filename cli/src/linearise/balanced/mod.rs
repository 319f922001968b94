//! A linear model of lower order: what is slow or grows is split off and kept, the rest cut down by balanced truncation.
//!
//! [theory: linearisation.balanced]

use std::ops::{AddAssign, SubAssign};

use flexible_aircraft::{LinearModel, LinearName};
use nalgebra::DMatrix;
use nalgebra::linalg::balancing::balance_parlett_reinsch;

use crate::numbers::short;

mod gramians;
mod scales;
mod schur;
mod system;
#[cfg(test)]
mod tests;
mod truncation;

use schur::{Block, Schur};
use system::System;
use truncation::Balance;

/// Slower roots are split off, 1/s.
const SLOW: f64 = 0.25;

/// Roots that decay more slowly are split off too, 1/s: the rest must have an end.
const LEAST_DECAY: f64 = 1e-6;

/// A reduced model, and what of the whole one it has.
pub struct Balanced {
    /// Its states are `reduced[i]`, those that are split off first.
    pub model: LinearModel,
    /// Of the whole model.
    whole: usize,
    split: usize,
    /// By how much outputs are wrong at most, parts of their scales for inputs of theirs.
    pub bound: f64,
}

/// Why a model was not reduced.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    #[error(
        "--inflow balanced:{found}: allowed are {least} to {most} states: {split} of the {whole} roots are slow or do not decay and \
         are split off, and no more than {} other states are moved by the inputs and shown by the outputs", most - split
    )]
    Order { found: usize, least: usize, most: usize, split: usize, whole: usize },
    #[error(
        "--inflow balanced:{found}: no input moves any of the {whole} states that an output shows; allowed is a model of which one does"
    )]
    Still { found: usize, whole: usize },
    #[error("--inflow balanced:{found}: the roots of the {whole} states were not found")]
    NotFound { found: usize, whole: usize },
}

/// A model reduced to so many states.
///
/// # Errors
/// When it cannot have so many or so few.
pub fn reduce(model: &LinearModel, order: usize) -> Result<Balanced, Error> {
    let whole = model.states.len();
    let parts = Parts::of(model).ok_or(Error::NotFound { found: order, whole })?;
    let System([slow, ..]) = &parts.slow;
    let (split, rest) = (slow.nrows(), parts.balance.hankel.len());
    let (least, most) = (split.max(1), split + rest);
    if most == 0 {
        return Err(Error::Still { found: order, whole });
    }
    if !(least..=most).contains(&order) {
        return Err(Error::Order { found: order, least, most, split, whole });
    }
    let bound = parts.balance.bound(order - split);
    Ok(Balanced { model: parts.with_fast(model, order - split), whole, split, bound })
}

impl Balanced {
    /// For people.
    pub fn text(&self) -> String {
        let Balanced { model, whole, split, bound } = self;
        format!(
            "{} of {whole} states are left, {split} of which are split off and exact (slower than {SLOW} 1/s, or growing);\n\
             outputs are wrong by at most {} of their scales for inputs of theirs, at any frequency\n\
             ({}).\n",
            model.states.len(),
            short(*bound),
            scales::TEXT
        )
    }
}

/// A model whose state is z = x − B′ u, so that no rate of an input moves it, in two parts that do not act on each other.
struct Parts {
    /// What is slow or does not decay.
    slow: System,
    /// What decays.
    fast: System,
    /// Of the latter.
    balance: Balance,
    /// D of both.
    direct: DMatrix<f64>,
}

impl Parts {
    /// None where roots are not found.
    fn of(model: &LinearModel) -> Option<Self> {
        let LinearModel { a, b, c, d, bd, .. } = model;
        let mut even = a.clone();
        let measures = balance_parlett_reinsch(&mut even);
        let mut schur = Schur::of(&even)?;
        let split = schur.order(|root| root.norm() < SLOW || root.re > -LEAST_DECAY)?;
        let apart = schur.apart(split)?;
        // The state of the model from those of the parts, and these from it.
        let (mut from_parts, mut to_parts) = (schur.q.clone(), schur.q.transpose());
        for (index, measure) in measures.iter().enumerate() {
            from_parts.row_mut(index).scale_mut(*measure);
            to_parts.column_mut(index).unscale_mut(*measure);
        }
        let rest = a.nrows() - split;
        let moved = from_parts.columns(0, split) * &apart;
        from_parts.columns_mut(split, rest).add_assign(&moved);
        let moved = &apart * to_parts.rows(split, rest);
        to_parts.rows_mut(0, split).sub_assign(&moved);
        let (b, c) = (to_parts * (b + a * bd), c * from_parts);
        let part = |start, size| {
            let a = schur.t.view((start, start), (size, size)).into_owned();
            System([a, b.rows(start, size).into_owned(), c.columns(start, size).into_owned()])
        };
        let (slow, fast) = (part(0, split), part(split, rest));
        let blocks: Vec<Block> = schur.blocks_from(split).collect();
        let balance =
            Balance::of(&blocks, &fast.scaled(&scales::of_inputs(model), &scales::of_outputs(model)))?;
        Some(Parts { slow, fast, balance, direct: d + &model.c * bd })
    }

    /// The model with so many states of the part that decays.
    fn with_fast(&self, model: &LinearModel, states: usize) -> LinearModel {
        let System([slow_a, slow_b, slow_c]) = &self.slow;
        let System([fast_a, fast_b, fast_c]) = &self.balance.truncated(&self.fast, states);
        let (split, order) = (slow_a.nrows(), slow_a.nrows() + states);
        let (inputs, outputs) = (slow_b.ncols(), slow_c.nrows());
        let both = |shape: (usize, usize), slow: &DMatrix<f64>, place, fast: &DMatrix<f64>| {
            let mut both = DMatrix::zeros(shape.0, shape.1);
            both.view_mut((0, 0), slow.shape()).copy_from(slow);
            both.view_mut(place, fast.shape()).copy_from(fast);
            both
        };
        let name = |number| LinearName { name: format!("reduced[{number}]"), unit: "1" };
        LinearModel {
            a: both((order, order), slow_a, (split, split), fast_a),
            b: both((order, inputs), slow_b, (split, 0), fast_b),
            c: both((outputs, order), slow_c, (0, split), fast_c),
            d: self.direct.clone(),
            bd: DMatrix::zeros(order, inputs),
            x0: vec![0.0; order],
            states: (1..=order).map(name).collect(),
            ..model.clone()
        }
    }
}
