//! The roots as numbers: a table of comma-separated values, a row for each root at each airspeed.

use std::fmt::Write;

use flexible_aircraft::stability::{Crossing, CrossingKind};

use super::report;
use crate::analysis::Analysis;
use crate::analysis::motion::{composition, damping, frequency, leading_motion, name, oscillates};
use crate::answer::Answer;
use crate::limits;
use crate::numbers::Plain;

/// Names with their units. `root` counts the curves of the plots; it is empty for an unstable eigenvalue that none of
/// them has reached. `damping_g` is empty where nothing oscillates.
pub const HEADER: &str = "airspeed_m_s,root,real_1_s,imaginary_rad_s,frequency_Hz,damping_g,mode";

/// The whole table.
pub fn table(analysis: &Analysis) -> String {
    let sweep = &analysis.sweep;
    let mut text = format!("{HEADER}\n");
    let mut unreached = sweep.unreached.iter().peekable();
    for (index, airspeed) in sweep.airspeeds.iter().enumerate() {
        let speed = Plain(*airspeed);
        for (number, branch) in sweep.branches.iter().enumerate() {
            let Some(root) = &branch.roots[index] else { continue };
            let (real, imaginary) = (Plain(root.eigenvalue.re), Plain(root.eigenvalue.im.abs()));
            let [frequency, damping] = if oscillates(root) {
                [frequency(root), damping(root)].map(|number| Plain(number).to_string())
            } else {
                ["0".to_owned(), String::new()]
            };
            let mode = leading_motion(root, analysis);
            // Writing to a String does not fail.
            let _ = writeln!(text, "{speed},{},{real},{imaginary},{frequency},{damping},{mode}", number + 1);
        }
        while let Some((_, eigenvalue)) = unreached.next_if(|(at, _)| at == airspeed) {
            let (real, imaginary) = (Plain(eigenvalue.re), Plain(eigenvalue.im));
            let frequency = Plain(eigenvalue.im / std::f64::consts::TAU);
            let _ = writeln!(text, "{speed},,{real},{imaginary},{frequency},,");
        }
    }
    text
}

/// A row of eigenvalues for each root, a column for each airspeed, NaN where the root is not; where roots cross the imaginary
/// axis; what was not analysed; and the report.
pub fn answer(analysis: &Analysis) -> Answer {
    let sweep = &analysis.sweep;
    let eigenvalues = sweep.branches.iter().flat_map(|branch| &branch.roots).map(|root| {
        root.as_ref().map_or([f64::NAN; 2], |root| [root.eigenvalue.re, root.eigenvalue.im.abs()])
    });
    let numbers =
        |number: fn(&Crossing) -> f64| Answer::Numbers(sweep.crossings.iter().map(number).collect());
    let kind = |crossing: &Crossing| match crossing.kind {
        CrossingKind::Flutter => "flutter".to_owned(),
        CrossingKind::Divergence => "divergence".to_owned(),
    };
    let crossings = Answer::named([
        ("airspeed", numbers(|crossing| crossing.airspeed)),
        ("frequency", numbers(|crossing| crossing.root.eigenvalue.im.abs())),
        ("root", Answer::Counts(sweep.crossings.iter().map(|crossing| crossing.branch).collect())),
        ("kind", Answer::Texts(sweep.crossings.iter().map(kind).collect())),
        ("is_onset", Answer::Truths(sweep.crossings.iter().map(|crossing| crossing.is_onset).collect())),
        ("motion", Answer::Texts(sweep.crossings.iter().map(|c| composition(&c.root, analysis)).collect())),
    ]);
    Answer::named([
        ("airspeeds", Answer::Numbers(sweep.airspeeds.clone())),
        ("roots", Answer::Texts(sweep.branches.iter().map(|branch| name(branch, analysis)).collect())),
        (
            "eigenvalues",
            Answer::Complex {
                rows: sweep.branches.len(),
                columns: sweep.airspeeds.len(),
                values: eigenvalues.collect(),
            },
        ),
        ("crossings", crossings),
        ("skipped", Answer::Numbers(sweep.skipped.iter().map(|skipped| skipped.airspeed).collect())),
        ("skipped_because", Answer::Texts(sweep.skipped.iter().map(|s| s.reason.to_string()).collect())),
        ("warnings", Answer::Texts(limits::warnings(&analysis.sweep.limits_exceeded))),
        ("report", Answer::Text(report::text(analysis))),
    ])
}
