//! Tables of gusts, as comma-separated values.

use super::case::Case;
use super::found::{Extremes, Flown, Found};
use crate::answer::Answer;
use crate::gust_flights::Failures;
use crate::numbers::Plain;
use crate::watched::Watched;

/// The gust that has made the most, and the least, of an output.
pub struct Worst<'s> {
    pub greatest: (&'s Flown, (f64, f64)),
    pub least: (&'s Flown, (f64, f64)),
}

impl<'s> Worst<'s> {
    /// Of the watched output with a number; `None` where nothing was flown.
    pub fn of(all: &'s Found, output: usize) -> Option<Self> {
        let of = |value: fn(&Extremes) -> (f64, f64), sign: f64| {
            let values = all.flights.iter().map(move |flown| (flown, value(&flown.extremes[output])));
            values.reduce(|worst, other| if sign * other.1.0 > sign * worst.1.0 { other } else { worst })
        };
        Some(Worst { greatest: of(|e| e.greatest, 1.0)?, least: of(|e| e.least, -1.0)? })
    }
}

/// Every gust and every output: least and greatest, with times.
pub fn all(watched: &[Watched], found: &Found) -> String {
    let mut text =
        "gradient_m,direction_deg,sense,peak_m_s,output,unit,trim,least,least_time_s,greatest,greatest_time_s\n"
            .to_owned();
    for Flown { case, peak, extremes } in &found.flights {
        for ((output, trim), Extremes { least, greatest }) in watched.iter().zip(&found.trim).zip(extremes) {
            let numbers =
                [*trim, least.0, least.1, greatest.0, greatest.1].map(|number| Plain(number).to_string());
            let gust = format!("{},{}", columns(case), Plain(*peak));
            text += &format!("{gust},{},{},{}\n", output.name, output.unit, numbers.join(","));
        }
    }
    text
}

/// Every output: the least and the greatest of all gusts, and the gusts that made them.
pub fn worst(watched: &[Watched], found: &Found) -> String {
    let mut text = "output,unit,trim,least,least_time_s,least_gradient_m,least_direction_deg,least_sense,\
                    greatest,greatest_time_s,greatest_gradient_m,greatest_direction_deg,greatest_sense\n"
        .to_owned();
    for (place, (output, trim)) in watched.iter().zip(&found.trim).enumerate() {
        let Some(Worst { greatest, least }) = Worst::of(found, place) else { continue };
        let side = |(flown, (value, time)): (&Flown, (f64, f64))| {
            format!("{},{},{}", Plain(value), Plain(time), columns(&flown.case))
        };
        text +=
            &format!("{},{},{},{},{}\n", output.name, output.unit, Plain(*trim), side(least), side(greatest));
    }
    text
}

/// A row for each gust, a column for each output; and which gusts could not be flown.
pub fn answer(watched: &[Watched], found: &Found, failures: Option<&Failures>) -> Answer {
    let flights = &found.flights;
    let of_gusts = |number: fn(&Flown) -> f64| Answer::Numbers(flights.iter().map(number).collect());
    let of_outputs = |number: fn(&Extremes) -> f64| Answer::Matrix {
        rows: flights.len(),
        columns: watched.len(),
        values: flights.iter().flat_map(|flown| flown.extremes.iter().map(number)).collect(),
    };
    let failed = failures.map_or(Vec::new(), |failures| failures.lines().collect());
    Answer::named([
        ("names", Answer::Texts(watched.iter().map(|output| output.name.clone()).collect())),
        ("units", Answer::Texts(watched.iter().map(|output| output.unit.clone()).collect())),
        ("trim", Answer::Numbers(found.trim.clone())),
        ("gradient", of_gusts(|flown| flown.case.gust.gradient)),
        ("direction", of_gusts(|flown| flown.case.degrees)),
        ("peak", of_gusts(|flown| flown.peak)),
        ("least", of_outputs(|extremes| extremes.least.0)),
        ("least_time", of_outputs(|extremes| extremes.least.1)),
        ("greatest", of_outputs(|extremes| extremes.greatest.0)),
        ("greatest_time", of_outputs(|extremes| extremes.greatest.1)),
        ("failures", Answer::Texts(failed)),
    ])
}

/// Gradient, direction and sense.
fn columns(case: &Case) -> String {
    format!("{},{},{}", Plain(case.gust.gradient), Plain(case.degrees), case.sense.name())
}
