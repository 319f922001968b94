//! What `flexair flutter` prints.

use std::fmt::Write;

use flexible_aircraft::aircraft::Support;
use flexible_aircraft::stability::{Crossing, CrossingKind};

use super::Analysis;
use super::motion::{composition, frequency, name};

/// Growth below which a root counts as neutral, 1/s.
const NEUTRAL: f64 = 1e-6;

/// The whole report.
pub fn text(analysis: &Analysis) -> String {
    let mut text = heading(analysis);
    text += &unstable_from_the_start(analysis);
    let crossings = &analysis.sweep.crossings;
    for crossing in crossings {
        text += &line(crossing, analysis);
    }
    if !analysis.sweep.airspeeds.is_empty() {
        let [from, to] = analysis.range;
        let kinds = [(CrossingKind::Flutter, "flutter"), (CrossingKind::Divergence, "divergence")];
        for (kind, word) in kinds {
            if !crossings.iter().any(|crossing| crossing.kind == kind && crossing.is_onset) {
                text += &format!("  no {word} begins from {from} to {to} m/s\n");
            }
        }
    }
    text += &skipped(analysis);
    text
}

fn heading(analysis: &Analysis) -> String {
    let Analysis { model, level, settings, range: [from, to], sweep } = analysis;
    let support = match model.support {
        Support::Free => "free, trimmed at each airspeed",
        Support::Clamped => "clamped in a wind tunnel",
    };
    let altitude =
        if model.tunnel_air.is_some() { String::new() } else { format!("{} m, ", settings.altitude) };
    format!(
        "{}, {support}\n{level} model, stiffness × {}, {} modes, {} inflow states, {altitude}{:.4} kg/m³\n\
         {} airspeeds from {from} to {to} m/s\n\n",
        model.name,
        settings.stiffness_scale,
        model.modes.len(),
        settings.inflow_states,
        analysis.density(),
        sweep.airspeeds.len() + sweep.skipped.len(),
    )
}

/// Roots that do not become unstable in the range because they are from its beginning.
fn unstable_from_the_start(analysis: &Analysis) -> String {
    let Some(airspeed) = analysis.sweep.airspeeds.first() else { return String::new() };
    let first = analysis.sweep.branches.iter().filter_map(|branch| branch.roots[0].as_ref());
    let unstable = first.filter(|root| root.eigenvalue.re > NEUTRAL);
    unstable.fold(String::new(), |mut text, root| {
        let doubling = std::f64::consts::LN_2 / root.eigenvalue.re;
        let _ = writeln!(
            text,
            "{airspeed:8.2} m/s  already unstable here: {:.3} Hz, doubles in {doubling:.3} s ({})",
            frequency(root),
            composition(root, analysis)
        );
        text
    })
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
    let speeds: Vec<String> = skipped.iter().map(|skipped| format!("{:.2}", skipped.airspeed)).collect();
    format!("  not analysed: {} m/s\n  the first of these because: {}\n", speeds.join(", "), first.reason)
}
