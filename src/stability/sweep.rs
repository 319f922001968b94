//! All roots of an aircraft over a range of airspeeds, and where they become unstable.
//!
//! [theory: stability.branches, stability.crossings]
//!
//! **Caveat.** A root that is unstable only between two neighbouring speeds of the range is not noticed.

use nalgebra::Complex;

use crate::equations::StationLoads;
use crate::plant::{LimitExceeded, PlantSettings, PointLoad, PointLoadError, SettingError, Unknown};
use crate::structure::ReducedModel;

use super::losses::{At, EquilibriumLoss};
use super::points::{Motions, SkipReason, Skipped, workers};
use super::tracks::{Branch, Crossing, Tracks};
use super::unstable::{Findings, UnstableRange};

/// Airspeeds that each worker analyses before the branches are followed over them.
const SHARE: usize = 8;

/// The roots of an aircraft over a range of airspeeds.
///
/// ```
/// use flexible_aircraft::plant::PlantSettings;
/// use flexible_aircraft::stability::{CrossingKind, Sweep};
/// use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let wing = ReducedModel::new(&Aircraft::read("aircraft/goland-wing.toml")?, 3)?;
/// let sweep = Sweep::new(&wing, &PlantSettings::of(&wing), &[120.0, 130.0, 140.0])?; // m/s
/// let flutter = sweep.crossings.iter().find(|crossing| crossing.kind == CrossingKind::Flutter).ok_or("none")?;
/// assert!((flutter.airspeed - 137.0).abs() < 1.0, "{flutter:?}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sweep {
    /// Ascending airspeeds at which the aircraft is trimmed, m/s.
    pub airspeeds: Vec<f64>,
    /// The speeds of the range that are missing there.
    pub skipped: Vec<Skipped>,
    /// What each component of a root's shape is.
    pub unknowns: Vec<Unknown>,
    /// The roots, each followed over the range.
    pub branches: Vec<Branch>,
    /// Where branches become unstable or stable again, by airspeed.
    pub crossings: Vec<Crossing>,
    /// Where the equilibrium is lost, by airspeed.
    pub losses: Vec<EquilibriumLoss>,
    /// Every analysed airspeed with an unstable root, by the first of each range.
    pub unstable: Vec<UnstableRange>,
    /// Unstable eigenvalues, 1/s, that no branch has reached, and their airspeeds, m/s.
    pub unreached: Vec<(f64, Complex<f64>)>,
    /// Trims beyond the aircraft's limits, and their airspeeds, m/s.
    pub limits_exceeded: Vec<(f64, LimitExceeded)>,
}

impl Sweep {
    /// Follows the roots of a model under the settings over ascending airspeeds, which replace the settings'.
    ///
    /// # Errors
    /// When a setting is out of range. Speeds without trim are skipped.
    pub fn new(
        model: &ReducedModel,
        settings: &PlantSettings,
        airspeeds: &[f64],
    ) -> Result<Self, SettingError> {
        Sweep::watched(model, settings, airspeeds, &|| {})
    }

    /// The same; `analysed` is called after each airspeed, from any thread.
    ///
    /// # Errors
    /// When a setting is out of range. Speeds without trim are skipped.
    pub fn watched(
        model: &ReducedModel,
        settings: &PlantSettings,
        airspeeds: &[f64],
        analysed: &(dyn Fn() + Sync),
    ) -> Result<Self, SettingError> {
        Sweep::of(model, settings, airspeeds, &StationLoads::default(), analysed)
    }

    /// The same under point loads.
    ///
    /// # Errors
    /// When a setting is out of range or a load cannot act. Speeds without trim are skipped.
    pub fn under_loads(
        model: &ReducedModel,
        settings: &PlantSettings,
        airspeeds: &[f64],
        loads: &[PointLoad],
    ) -> Result<Self, SweepError> {
        let loads = PointLoad::on_stations(loads, &model.stations)?;
        Ok(Sweep::of(model, settings, airspeeds, &loads, &|| {})?)
    }

    fn of(
        model: &ReducedModel,
        settings: &PlantSettings,
        airspeeds: &[f64],
        loads: &StationLoads,
        analysed: &(dyn Fn() + Sync),
    ) -> Result<Self, SettingError> {
        for &airspeed in airspeeds {
            PlantSettings { airspeed, ..*settings }.check(model.support)?;
        }
        let airspeed = airspeeds.first().copied().unwrap_or(settings.airspeed);
        let settings = &PlantSettings { airspeed, ..*settings };
        let aircraft = Motions { model: &model.in_use(&settings.choose_modes(model)?), settings, loads };
        let mut gathered = Gathered::default();
        let mut tracks = Tracks::new(aircraft);
        for airspeeds in airspeeds.chunks(SHARE * workers()) {
            for (point, &airspeed) in aircraft.points(airspeeds, analysed).into_iter().zip(airspeeds) {
                let after_gap = !matches!(gathered.last, Last::Trimmed(_));
                let last = match point {
                    Ok(point) => {
                        tracks.add(&point, after_gap);
                        gathered
                            .limits_exceeded
                            .extend(point.limits_exceeded.iter().map(|e| (airspeed, e.clone())));
                        gathered.unknowns = point.unknowns;
                        Last::Trimmed((airspeed, point.equilibrium))
                    }
                    Err(reason) => {
                        gathered.skipped.push(Skipped { airspeed, reason: reason.clone() });
                        Last::Skipped(airspeed, reason)
                    }
                };
                gathered.go_on(aircraft, last);
            }
        }
        let Gathered { losses, skipped, unknowns, limits_exceeded, .. } = gathered;
        let crossings = tracks.crossings(&losses);
        let Tracks { branches, analysed, ends, .. } = tracks;
        let unreached = analysed.iter().flat_map(|at| at.unreached.iter().map(|&value| (at.airspeed, value)));
        let findings = Findings {
            analysed: &analysed,
            branches: &branches,
            ends: &ends,
            crossings: &crossings,
            losses: &losses,
        };
        Ok(Sweep {
            airspeeds: analysed.iter().map(|at| at.airspeed).collect(),
            skipped,
            unknowns,
            unstable: findings.ranges(),
            unreached: unreached.collect(),
            limits_exceeded,
            losses,
            crossings,
            branches,
        })
    }
}

/// Why a range of airspeeds cannot be analysed under loads.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SweepError {
    /// A setting is out of range.
    #[error(transparent)]
    Setting(#[from] SettingError),
    /// A load cannot act.
    #[error(transparent)]
    Load(#[from] PointLoadError),
}

/// What comes together from speed to speed, but for the branches.
#[derive(Default)]
struct Gathered {
    last: Last,
    losses: Vec<EquilibriumLoss>,
    skipped: Vec<Skipped>,
    unknowns: Vec<Unknown>,
    limits_exceeded: Vec<(f64, LimitExceeded)>,
}

/// How the last speed came out.
#[derive(Default)]
enum Last {
    /// There is none.
    #[default]
    None,
    Trimmed(At),
    Skipped(f64, SkipReason),
}

impl Gathered {
    /// Goes on to the next speed, and looks for a loss of equilibrium on the way.
    fn go_on(&mut self, aircraft: Motions, next: Last) {
        let loss = match (std::mem::take(&mut self.last), &next) {
            (Last::Trimmed(low), Last::Trimmed(high)) => aircraft.loss_between(low, high.clone()),
            (Last::Trimmed((with, _)), Last::Skipped(without, SkipReason::Trim(reason))) => {
                Some(aircraft.end_of_trims(with, *without, reason.clone()))
            }
            (Last::Skipped(without, SkipReason::Trim(reason)), Last::Trimmed((with, _))) => {
                Some(aircraft.end_of_trims(*with, without, reason))
            }
            _ => None,
        };
        self.losses.extend(loss);
        self.last = next;
    }
}
