//! The linearised motion at one airspeed of a range [theory: linearisation.state-matrix, stability.branches].

use std::sync::Arc;
use std::thread;

use nalgebra::Complex;

use crate::equations::StationLoads;
use crate::plant::{
    EigenvaluesNotFound, LimitExceeded, Plant, PlantSettings, StateMatrix, Trim, TrimError, Unknown,
};
use crate::structure::ReducedModel;

use super::condensed::Condensed;
use super::equilibrium::Equilibrium;

/// Growth that counts as unstable, 1/s: above the rounding of eigenvalues that are zero. The height of a free
/// aircraft has one, for at the same dynamic pressure it is in trim at any height; so has an undamped mode.
pub(super) const UNSTABLE: f64 = 1e-6;

/// A speed of the range that could not be analysed.
#[derive(Clone, Debug, PartialEq)]
pub struct Skipped {
    /// m/s.
    pub airspeed: f64,
    /// Why.
    pub reason: SkipReason,
}

/// Why a speed could not be analysed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SkipReason {
    /// There is no trim.
    #[error(transparent)]
    Trim(#[from] Box<TrimError>),
    /// The eigensolver failed.
    #[error(transparent)]
    Eigenvalues(#[from] EigenvaluesNotFound),
}

/// The linearised motions of one aircraft, one for each airspeed.
#[derive(Clone, Copy)]
pub(super) struct Motions<'a> {
    /// With the modes that take part.
    pub model: &'a ReducedModel,
    /// All within their ranges; their airspeed is of no account.
    pub settings: &'a PlantSettings,
    /// On its stations.
    pub loads: &'a StationLoads,
}

/// The motion at one airspeed of the range.
pub(super) struct AnalysedSpeed {
    pub airspeed: f64,
    pub equilibrium: Equilibrium,
    pub limits_exceeded: Vec<LimitExceeded>,
    pub problem: Arc<Condensed>,
    pub unknowns: Vec<Unknown>,
    /// One of each unstable pair.
    pub unstable: Vec<Complex<f64>>,
}

impl Motions<'_> {
    fn trimmed(&self, airspeed: f64) -> Result<(Plant, Trim), Box<TrimError>> {
        let settings = PlantSettings { airspeed, ..*self.settings };
        let plant = Plant::of_chosen(self.model, &settings.configuration(self.model.support));
        let plant = plant.carrying(self.loads.clone());
        let trim = plant.trim(&settings.trim_condition())?;
        Ok((plant, trim))
    }

    /// The trim alone.
    pub fn equilibrium(&self, airspeed: f64) -> Result<Equilibrium, Box<TrimError>> {
        let (plant, trim) = self.trimmed(airspeed)?;
        Ok(Equilibrium::new(&plant, &trim))
    }

    /// The linearised motion alone; none without a trim.
    pub fn problem(&self, airspeed: f64) -> Option<Arc<Condensed>> {
        let (plant, trim) = self.trimmed(airspeed).ok()?;
        Some(Arc::new(Condensed::new(&plant.linearise(&trim))))
    }

    /// Some points of the range, computed side by side; `analysed` is called after each.
    pub fn points(
        &self,
        airspeeds: &[f64],
        analysed: &(dyn Fn() + Sync),
    ) -> Vec<Result<AnalysedSpeed, SkipReason>> {
        let share = airspeeds.len().div_ceil(workers()).max(1);
        let analyse = |&airspeed: &f64| {
            let point = self.point(airspeed);
            analysed();
            point
        };
        thread::scope(|scope| {
            let part = |part: &'_ [f64]| part.iter().map(analyse).collect::<Vec<_>>();
            let parts: Vec<_> =
                airspeeds.chunks(share).map(|speeds| scope.spawn(move || part(speeds))).collect();
            let join = |part: thread::ScopedJoinHandle<'_, _>| {
                part.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
            };
            parts.into_iter().flat_map(join).collect()
        })
    }

    fn point(&self, airspeed: f64) -> Result<AnalysedSpeed, SkipReason> {
        let (plant, trim) = self.trimmed(airspeed)?;
        let matrix: StateMatrix = plant.linearise(&trim);
        let mut unstable = matrix.eigenvalues()?;
        unstable.retain(|eigenvalue| eigenvalue.re > UNSTABLE && eigenvalue.im >= 0.0);
        let in_shape = |unknown: &&Unknown| !matches!(unknown, Unknown::Inflow { .. });
        Ok(AnalysedSpeed {
            airspeed,
            equilibrium: Equilibrium::new(&plant, &trim),
            limits_exceeded: LimitExceeded::find(&self.model.limits, &plant, &trim),
            problem: Arc::new(Condensed::new(&matrix)),
            unknowns: matrix.unknowns.iter().filter(in_shape).copied().collect(),
            unstable,
        })
    }
}

/// How many points are computed side by side.
pub(super) fn workers() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}
