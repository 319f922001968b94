//! What is printed of gusts.

use flexible_aircraft::flight::Settings;
use flexible_aircraft::structure::ReducedModel;

use super::found::{Flown, Found};
use super::set::peaks;
use super::table::Worst;
use crate::flown::condition;
use crate::numbers::rounded;
use crate::watched::Watched;

/// What was flown, how long that took, and the worst of each output.
pub fn text(
    model: &ReducedModel,
    settings: &Settings,
    watched: &[Watched],
    found: &Found,
    seconds: f64,
) -> String {
    let (flights, condition) = (&found.flights, condition(model, settings));
    let mut text = format!("{}: {} gusts at {condition}\n", model.name, flights.len());
    if let Some(Flown { case, .. }) = flights.first() {
        let peaks = peaks(&case.gust, settings.plant.altitude, flights.iter().map(|flown| flown.peak));
        text += &format!("{peaks}\n");
    }
    let cores = rayon::current_num_threads();
    let strips = model.strips.len();
    text += &format!("flown in {seconds:.2} s on {cores} cores, {strips} strips each\n\n");
    let width = watched.iter().map(|output| output.name.len()).max().unwrap_or(0).max(6);
    text += &format!(
        "{:width$}  {:>12}  {:>34}  {:>34}\n",
        "output", "trim", "least (at s, H m, way)", "greatest"
    );
    for (place, (output, trim)) in watched.iter().zip(&found.trim).enumerate() {
        let Some(Worst { greatest, least }) = Worst::of(found, place) else { continue };
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

fn side((flown, (value, time)): (&Flown, (f64, f64))) -> String {
    let Flown { case, .. } = flown;
    format!("{} ({time:.3}, {:.1} {})", rounded(value), case.gust.gradient, case.way())
}
