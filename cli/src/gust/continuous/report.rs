//! What is printed of continuous turbulence.

use flexible_aircraft::flight::Settings;
use flexible_aircraft::structure::ReducedModel;

use super::{Direction, Found, Row};
use crate::flown::condition;
use crate::gust::case::across;
use crate::gust::set::by_criterion;
use crate::numbers::{rounded, short};

/// The turbulence, how long it took, and every output in each direction.
pub fn text(model: &ReducedModel, settings: &Settings, found: &Found, seconds: f64) -> String {
    let mut text = format!(
        "{}: continuous turbulence of 1 m/s at {}\n{}\n",
        model.name,
        condition(model, settings),
        found.spectrum()
    );
    let why = by_criterion(&settings.gust, "b", settings.plant.altitude).unwrap_or_default();
    text += &format!("limits: trim ± U_σ Ā, U_σ {} m/s of true airspeed {why}\n", rounded(found.velocity));
    for Direction { outputs, .. } in &found.directions {
        let ends = [outputs.frequencies.first(), outputs.frequencies.last()];
        let [first, last] = ends.map(|end| short(end.copied().unwrap_or(0.0)));
        text += &format!(
            "{} frequencies from {first} to {last} rad/s; the last halving of their steps moved no Ā by more than {:.0e} of it\n",
            outputs.frequencies.len(),
            outputs.moved
        );
    }
    text += &format!("found in {seconds:.2} s\n");
    let width = found.watched.iter().map(|output| output.name.len()).max().unwrap_or(0).max(6);
    for direction in &found.directions {
        text += &format!(
            "\n{:width$}  {:>12}  {:>14}  {:>9}  {:>12}  {:>12}\n",
            across(direction.degrees),
            "trim",
            "Ā (per m/s)",
            "N0 (Hz)",
            "least",
            "greatest"
        );
        for Row { output, trim, rms, crossings, limits } in found.rows(direction) {
            let [trim, rms, least, greatest] = [trim, rms, limits[0], limits[1]].map(rounded);
            let row = format!(
                "{:width$}  {trim:>12}  {rms:>14}  {crossings:>9.3}  {least:>12}  {greatest:>12}  {}",
                output.name, output.unit
            );
            text += row.trim_end();
            text.push('\n');
        }
    }
    text.push('\n');
    text
}
