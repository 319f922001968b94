//! What `flexair flutter` prints.

use std::fmt::Write;

use flexible_aircraft::aircraft::Support;
use flexible_aircraft::stability::{Crossing, CrossingKind, EquilibriumLoss, LossKind, Onset, UnstableRange};

use crate::analysis::Analysis;
use crate::analysis::motion::{composition, frequency, name, oscillates_at};
use crate::condition::Airspeeds;
use crate::numbers::Plain;

/// Airspeeds that were not analysed are named up to this number.
const MOST_NAMED: usize = 20;

/// The whole report.
pub fn text(analysis: &Analysis) -> String {
    let mut text = heading(analysis);
    let sweep = &analysis.sweep;
    let crossings = sweep.crossings.iter().map(|crossing| (crossing.airspeed, line(crossing, analysis)));
    let losses = sweep.losses.iter().map(|loss| (loss.between[0], lost(loss)));
    let mut events: Vec<(f64, String)> = crossings.chain(losses).collect();
    events.sort_by(|a, b| a.0.total_cmp(&b.0));
    text.extend(events.into_iter().map(|(_, line)| line));
    text += &unstable(analysis);
    if !sweep.airspeeds.is_empty() {
        text += &absent(CrossingKind::Flutter, "flutter", analysis);
        text += &absent(CrossingKind::Divergence, "divergence", analysis);
    }
    text += &skipped(analysis);
    text
}

fn heading(analysis: &Analysis) -> String {
    let Analysis { model, airspeeds: Airspeeds { from, to, points }, .. } = analysis;
    let at = if model.support == Support::Free { " at each airspeed" } else { "" };
    let natural = model.natural_modes();
    let modes = match model.modes.len() - natural {
        0 => format!("{natural} modes"),
        loads => format!("{natural} natural and {loads} load modes"),
    };
    format!(
        "{}, {}{at}\n{}{points} airspeeds from {} to {} m/s\n\n",
        model.name,
        analysis.support(),
        analysis.condition(&modes),
        Plain(*from),
        Plain(*to),
    )
}

/// Every analysed airspeed with an unstable root.
fn unstable(analysis: &Analysis) -> String {
    let ranges = &analysis.sweep.unstable;
    if ranges.is_empty() {
        return String::new();
    }
    let mut text = String::from("\n  unstable at these of the airspeeds analysed:\n");
    for range in ranges {
        let UnstableRange { first, last, branch, at_first, fastest, onset } = range;
        let motion = if oscillates_at(*at_first) {
            format!("{:.3} Hz", at_first.im / std::f64::consts::TAU)
        } else {
            "aperiodic".to_owned()
        };
        let onset = match onset {
            Onset::FirstAnalysed => "already at the first airspeed".to_owned(),
            Onset::AfterGap(airspeed) => format!("not analysed from {airspeed:.2} m/s to there"),
            Onset::Crossing(airspeed) => format!("since it crossed at {airspeed:.2} m/s"),
            Onset::Loss(airspeed) => format!("since the equilibrium was lost at {airspeed:.2} m/s"),
            Onset::Begins(airspeed) => format!("since it left another root at {airspeed:.2} m/s"),
            Onset::Unseen(airspeed) => format!("appears after {airspeed:.2} m/s, no crossing was found"),
        };
        let at = analysis.sweep.airspeeds.iter().position(|airspeed| airspeed == first);
        let root = branch.zip(at).and_then(|(branch, at)| analysis.sweep.branches[branch].roots[at].as_ref());
        let shares = root.map_or(String::new(), |root| format!(" ({})", composition(root, analysis)));
        let to = if last > first { format!(" to {last:.2}") } else { String::new() };
        let doubling = std::f64::consts::LN_2 / fastest.re;
        let _ = writeln!(
            text,
            "{first:8.2}{to} m/s  {motion}, doubles in {doubling:.3} s at the fastest, {onset}{shares}"
        );
    }
    text + "\n"
}

/// That a kind of instability does not begin in the range, or that one is there whose beginning was not found.
fn absent(kind: CrossingKind, word: &str, analysis: &Analysis) -> String {
    let Analysis { airspeeds: Airspeeds { from, to, .. }, sweep, .. } = analysis;
    let [from, to] = [from, to].map(|end| Plain(*end));
    if sweep.crossings.iter().any(|crossing| crossing.kind == kind && crossing.is_onset) {
        return String::new();
    }
    let is_of_kind = |range: &&UnstableRange| {
        oscillates_at(range.at_first) == (kind == CrossingKind::Flutter)
            && matches!(
                range.onset,
                Onset::AfterGap(_) | Onset::Loss(_) | Onset::Begins(_) | Onset::Unseen(_)
            )
    };
    if sweep.unstable.iter().any(|range| is_of_kind(&range)) {
        format!("  no crossing into {word} from {from} to {to} m/s, but see what is unstable above\n")
    } else {
        format!("  no {word} begins from {from} to {to} m/s\n")
    }
}

/// Where an equilibrium is lost.
fn lost(loss: &EquilibriumLoss) -> String {
    let [below, above] = loss.between;
    match &loss.kind {
        LossKind::Jump { component, displacement } => format!(
            "{below:8.2} m/s  the equilibrium is lost: the trim above is another one ({component} moves by \
             {displacement:.3} m)\n"
        ),
        LossKind::NoneAbove(_) => {
            format!("{below:8.2} m/s  the equilibrium is lost: above no trim is found\n")
        }
        LossKind::NoneBelow(_) => {
            format!("{above:8.2} m/s  from here on a trim is found, below none\n")
        }
    }
}

fn line(crossing: &Crossing, analysis: &Analysis) -> String {
    let Crossing { airspeed, root, kind, is_onset, branch } = crossing;
    let what = match (kind, is_onset) {
        (CrossingKind::Flutter, true) => "flutter",
        (CrossingKind::Flutter, false) => "flutter ends",
        (CrossingKind::Divergence, true) => "divergence",
        (CrossingKind::Divergence, false) => "divergence ends",
    };
    let oscillation = match kind {
        CrossingKind::Flutter => {
            format!("{:.2} rad/s ({:.3} Hz)", root.eigenvalue.im.abs(), frequency(root))
        }
        CrossingKind::Divergence => "static".to_owned(),
    };
    let name = name(&analysis.sweep.branches[*branch], analysis);
    let composition = composition(root, analysis);
    format!("{airspeed:8.2} m/s  {what:15} {oscillation:26} {composition} (begins as {name})\n")
}

fn skipped(analysis: &Analysis) -> String {
    let skipped = &analysis.sweep.skipped;
    let Some(first) = skipped.first() else { return String::new() };
    let named = skipped.iter().take(MOST_NAMED).map(|skipped| format!("{:.2}", skipped.airspeed));
    let mut speeds = named.collect::<Vec<_>>().join(", ");
    if let Some(last) = skipped.get(MOST_NAMED..).and_then(<[_]>::last) {
        let _ = write!(speeds, " … {:.2} ({} airspeeds)", last.airspeed, skipped.len());
    }
    format!("  not analysed: {speeds} m/s\n  the first of these because: {}\n", first.reason)
}
