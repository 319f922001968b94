//! What comes out with one number of modes.

use flexible_aircraft::plant::{LimitExceeded, Outputs, Plant, PlantSettings, SettingError, TrimPoint};
use flexible_aircraft::stability::{Complex, Crossing, CrossingKind, Onset, UnstableRange};
use flexible_aircraft::structure::ReducedModel;

use super::quantity::Value;
use crate::analysis::Analysis;
use crate::analysis::motion::{is_of_flight, oscillates, oscillates_at};
use crate::condition::Airspeeds;
use crate::numbers::Plain;
use crate::progress::Progress;

/// What comes out with one number of modes.
pub struct Row {
    /// How many natural modes take part.
    pub natural: usize,
    /// How many load modes beside them.
    pub loads: usize,
    /// The trim; or why there is none.
    pub trim: Result<Trimmed, String>,
    /// The oscillations at the trim that the air has time to follow, slowest first, 1/s.
    pub roots: Vec<Complex<f64>>,
    pub flutter: Critical,
    pub divergence: Critical,
    /// What the search for flutter has to say, for people.
    pub remarks: Vec<String>,
    /// Over the airspeeds of the search.
    pub analysis: Analysis,
}

/// A trim as it is compared.
pub struct Trimmed {
    pub point: TrimPoint,
    /// At the stations, in the order of the model.
    pub outputs: Outputs,
    /// The greatest displacement of any strip, m.
    pub farthest: f64,
    /// That nobody could fly it, if so.
    pub warning: Option<String>,
}

/// Where a kind of instability begins.
#[derive(Clone, Debug, PartialEq)]
pub struct Critical {
    /// Airspeed, m/s.
    pub airspeed: Value,
    /// Of the oscillation there, rad/s.
    pub frequency: Option<f64>,
}

impl Row {
    /// With the modes of these settings: their trim, and flutter and divergence over some airspeeds.
    ///
    /// # Errors
    /// When a setting is out of range.
    pub fn new(
        model: &ReducedModel,
        settings: PlantSettings,
        airspeeds: Airspeeds,
        progress: &Progress,
    ) -> Result<Self, SettingError> {
        let at = Analysis::new(model, settings, Airspeeds::one(settings.airspeed), progress)?;
        let analysis = Analysis::new(model, settings, airspeeds, progress)?;
        let natural = at.model.natural_modes();
        let trim = Trimmed::new(&at.model, &settings);
        Ok(Row {
            natural,
            loads: at.model.modes.len() - natural,
            roots: oscillations(&at),
            flutter: Critical::first(CrossingKind::Flutter, &analysis),
            divergence: Critical::first(CrossingKind::Divergence, &analysis),
            remarks: remarks(&analysis, trim.is_ok()),
            trim,
            analysis,
        })
    }

    /// The number of modes for people: natural ones, and load modes beside them.
    pub fn label(&self) -> String {
        if self.loads == 0 { self.natural.to_string() } else { format!("{} + {}", self.natural, self.loads) }
    }
}

impl Trimmed {
    /// Of a model all of whose modes take part.
    fn new(model: &ReducedModel, settings: &PlantSettings) -> Result<Self, String> {
        let plant =
            Plant::new(model, &settings.configuration(model.support)).map_err(|error| error.to_string())?;
        let trim = plant.trim(&settings.trim_condition()).map_err(|error| error.to_string())?;
        let outputs = plant.outputs_at(&trim.state, &trim.controls, &mut plant.workspace());
        let displacements = plant.strip_displacements(&trim.state);
        let exceeded = LimitExceeded::find(&model.limits, &plant, &trim);
        Ok(Trimmed {
            point: trim.point,
            outputs,
            farthest: displacements.iter().fold(0.0, |most, place| place.norm().max(most)),
            warning: LimitExceeded::warning(&exceeded, model, settings),
        })
    }
}

/// The roots of an analysis of one airspeed that oscillate, slowest first, 1/s: no faster than by 1 rad while the air passes the
/// greatest chord, beyond which strip theory says less and less of them.
fn oscillations(analysis: &Analysis) -> Vec<Complex<f64>> {
    let chord = analysis.model.strips.iter().map(|strip| 2.0 * strip.semichord).fold(0.0, f64::max);
    let roots = analysis.sweep.branches.iter().flat_map(|branch| branch.roots.iter().flatten());
    let mut roots: Vec<Complex<f64>> =
        roots.filter(|root| oscillates(root)).map(|root| root.eigenvalue).collect();
    roots.retain(|root| root.im.abs() * chord <= analysis.settings.airspeed);
    roots.sort_by(|a, b| a.im.abs().total_cmp(&b.im.abs()));
    roots
}

impl Critical {
    /// The lowest airspeed at which a kind of instability begins; those of flight are no flutter and no divergence.
    fn first(kind: CrossingKind, analysis: &Analysis) -> Critical {
        let sweep = &analysis.sweep;
        let is_wanted = |crossing: &&Crossing| {
            crossing.is_onset && crossing.kind == kind && !is_of_flight(&crossing.root, analysis)
        };
        let crossing = sweep.crossings.iter().find(is_wanted);
        let range = sweep.unstable.iter().find(|range| is_seen(range, kind, analysis));
        let from = analysis.airspeeds.from;
        match (crossing, range) {
            (_, Some(range)) if crossing.is_none_or(|crossing| range.first < crossing.airspeed) => {
                let is_first = range.onset == Onset::FirstAnalysed;
                let finding =
                    if is_first { format!("< {}", Plain(from)) } else { format!("≤ {:.2}", range.first) };
                Critical { airspeed: Value::Outside(finding), frequency: None }
            }
            (Some(crossing), _) => {
                let frequency = (kind == CrossingKind::Flutter).then(|| crossing.root.eigenvalue.im.abs());
                Critical { airspeed: Value::Number(crossing.airspeed), frequency }
            }
            _ if sweep.airspeeds.is_empty() => {
                Critical { airspeed: Value::Unknown("no trim"), frequency: None }
            }
            _ => Critical { airspeed: Value::Outside("none".to_owned()), frequency: None },
        }
    }
}

/// Whether a root of a kind is unstable over a range of airspeeds to which no crossing leads.
fn is_seen(range: &UnstableRange, kind: CrossingKind, analysis: &Analysis) -> bool {
    let sweep = &analysis.sweep;
    let at = sweep.airspeeds.iter().position(|airspeed| *airspeed == range.first);
    let root = range.branch.zip(at).and_then(|(branch, at)| sweep.branches[branch].roots[at].as_ref());
    oscillates_at(range.at_first) == (kind == CrossingKind::Flutter)
        && !matches!(range.onset, Onset::Crossing(_))
        && root.is_none_or(|root| !is_of_flight(root, analysis))
}

/// Airspeeds that could not be analysed, with the reason where it is not that of the trim, and where the equilibrium is lost.
fn remarks(analysis: &Analysis, with_reason: bool) -> Vec<String> {
    let sweep = &analysis.sweep;
    let mut remarks = Vec::new();
    if let (Some(first), Some(last)) = (sweep.skipped.first(), sweep.skipped.last()) {
        let count = sweep.skipped.len();
        let reason =
            if with_reason { format!(", the first because: {}", first.reason) } else { String::new() };
        remarks.push(format!(
            "{count} of {} airspeeds of the search, {:.2} to {:.2} m/s, could not be analysed{reason}",
            count + sweep.airspeeds.len(),
            first.airspeed,
            last.airspeed
        ));
    }
    if let Some(loss) = sweep.losses.first() {
        remarks.push(format!("the equilibrium is lost at {:.2} m/s", loss.between[0]));
    }
    remarks
}
