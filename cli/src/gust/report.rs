//! What is printed of gusts.

use flexible_aircraft::air::GustCriterion;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::structure::ReducedModel;

use super::sweep::{Flown, Sweep};
use super::table::Worst;
use super::watched::Watched;
use crate::numbers::{Plain, rounded};

/// What was flown, how long that took, and the worst of each output.
pub fn text(
    model: &ReducedModel,
    settings: &Settings,
    watched: &[Watched],
    sweep: &Sweep,
    seconds: f64,
) -> String {
    let plant = &settings.plant;
    let mut text = format!(
        "{}: {} gusts at {} m/s, {} m, model = {}, {} modes\n{}\n",
        model.name,
        sweep.flights.len(),
        Plain(plant.airspeed),
        Plain(plant.altitude),
        plant.fidelity.name(),
        plant.mode_count,
        peaks(settings, sweep)
    );
    let cores = rayon::current_num_threads();
    let strips = model.strips.len();
    text += &format!("flown in {seconds:.2} s on {cores} cores, {strips} strips each\n\n");
    let width = watched.iter().map(|output| output.name.len()).max().unwrap_or(0).max(6);
    text += &format!(
        "{:width$}  {:>12}  {:>34}  {:>34}\n",
        "output", "trim", "least (at s, H m, sense)", "greatest"
    );
    for (place, (output, trim)) in watched.iter().zip(&sweep.trim).enumerate() {
        let Some(Worst { greatest, least }) = Worst::of(sweep, place) else { continue };
        let [least, greatest] = [least, greatest].map(side);
        let unit = &output.unit;
        let row =
            format!("{:width$}  {:>12}  {least:>34}  {greatest:>34}  {unit}", output.name, rounded(*trim));
        text += row.trim_end();
        text.push('\n');
    }
    text.push('\n');
    text
}

/// From which peak to which, and why.
fn peaks(settings: &Settings, sweep: &Sweep) -> String {
    let peaks = || sweep.flights.iter().map(|flown| flown.peak);
    let [least, greatest] = [peaks().fold(f64::INFINITY, f64::min), peaks().fold(0.0, f64::max)];
    let range = if least == greatest {
        rounded(least)
    } else {
        format!("{} to {}", rounded(least), rounded(greatest))
    };
    let alleviation = || {
        let gust = &settings.gust;
        let here = gust.alleviation_at(settings.plant.altitude);
        format!("F_g {:.5} at sea level, {here:.5} here", gust.alleviation)
    };
    match settings.gust.criterion {
        GustCriterion::Peak => format!("peak {range} m/s of true airspeed, as given"),
        GustCriterion::Cs25Vc => {
            format!("peak {range} m/s of true airspeed by CS 25.341(a) at VC, {}", alleviation())
        }
        GustCriterion::Cs25Vd => {
            format!("peak {range} m/s of true airspeed by CS 25.341(a) at VD, {}", alleviation())
        }
    }
}

fn side((flown, (value, time)): (&Flown, (f64, f64))) -> String {
    let sense = if flown.case.sense == "positive" { "+" } else { "−" };
    format!("{} ({time:.3}, {:.1} {sense})", rounded(value), flown.case.gradient)
}
