//! Envelopes in words and as a table of comma-separated values.

use std::fmt::Write as _;
use std::ops::Range;

use flexible_aircraft::air::GustShape;
use flexible_aircraft::variables::LoadComponent;

use super::Analysis;
use super::envelope::{Envelope, Extreme};
use crate::flown::condition;
use crate::gust::set::peaks;
use crate::numbers::{Plain, rounded};

/// For people: each component's least and most at the cuts of the file, and when.
pub fn text(analysis: &Analysis) -> String {
    let Analysis { model, settings, cases, flights, .. } = analysis;
    let flown = match flights.len() {
        1 => String::new(),
        many => format!(" in {many} flights"),
    };
    let mut text = format!("{}: section loads{flown} at {}\n", model.name, condition(model, settings));
    // The gusts of a set have one criterion.
    if let Some(gust) = cases.gusts.first().filter(|gust| gust.shape != GustShape::None) {
        let peaks = peaks(gust, settings.plant.altitude, flights.iter().map(|flight| flight.peak));
        text += &format!("{peaks}\n");
    }
    for (cut, envelope) in named(analysis) {
        // PROOF: a string takes every text.
        let _ = writeln!(text, "\n{cut}");
        for (place, component) in LoadComponent::ALL.into_iter().enumerate() {
            let extreme = |extreme: &Extreme| {
                let case = if analysis.cases.names.len() > 1 {
                    format!(", {}", analysis.cases.names[extreme.case])
                } else {
                    String::new()
                };
                let load = extreme.loads[place];
                let load = if load.abs() < nothing(envelope) { 0.0 } else { load };
                format!("{:>12} at {:.3} s{case}", rounded(load), extreme.time)
            };
            let (least, most) = (extreme(&envelope.least[place]), extreme(&envelope.most[place]));
            let unit = component.unit().name();
            let name = component.name();
            let _ = writeln!(text, "  {name:<18} {unit:<4} least {least:<36} most {most}");
        }
    }
    text
}

/// Less than this is rounding beside what a cut carries.
fn nothing(envelope: &Envelope) -> f64 {
    let extremes = envelope.least.iter().chain(&envelope.most);
    let most = extremes.flat_map(|extreme| extreme.loads).fold(0.0, |most: f64, load| most.max(load.abs()));
    1e-9 * most
}

/// The cuts of the file with their envelopes.
fn named(analysis: &Analysis) -> impl Iterator<Item = (&str, &Envelope)> {
    let cuts = analysis.model.cuts.iter().enumerate().take(analysis.named);
    cuts.filter_map(|(index, cut)| Some((cut.name.as_str(), analysis.envelopes.of(index)?)))
}

/// A row for each extreme: what, where, when, in which flight, and the six components at that moment.
pub fn table(analysis: &Analysis, cuts: Range<usize>) -> String {
    let mut text = "cut,component,at,load,extreme,value,time,case".to_owned();
    for component in LoadComponent::ALL {
        text += &format!(",{}", component.name());
    }
    text.push('\n');
    for index in cuts {
        let (cut, Some(envelope)) = (&analysis.model.cuts[index], analysis.envelopes.of(index)) else {
            continue;
        };
        for (place, component) in LoadComponent::ALL.into_iter().enumerate() {
            for (word, extreme) in [("max", &envelope.most[place]), ("min", &envelope.least[place])] {
                text += &format!(
                    "{},{},{},{},{word},{},{},{}",
                    cut.name,
                    cut.component,
                    Plain(cut.at),
                    component.name(),
                    Plain(extreme.loads[place]),
                    Plain(extreme.time),
                    analysis.cases.names[extreme.case],
                );
                for load in extreme.loads {
                    text += &format!(",{}", Plain(load));
                }
                text.push('\n');
            }
        }
    }
    text
}
