//! The roots of a linear model for people: those that show in flight [theory: linearisation.eigenvalues].

use std::f64::consts::{LN_2, TAU};

use flexible_aircraft::LinearModel;
use flexible_aircraft::aircraft::Support;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::structure::ReducedModel;

use crate::diagnostics;
use crate::flown::condition;
use crate::numbers::{aligned, fixed};

/// Roots that are damped more than this share of critically and decay faster than this (1/s) are counted only: most are the wake's.
const WELL_DAMPED: f64 = 0.5;
const FAST: f64 = 5.0;

/// A root: real, or the upper one of a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Root {
    re: f64,
    im: f64,
}

impl Root {
    /// rad/s.
    fn frequency(self) -> f64 {
        self.re.hypot(self.im)
    }

    /// Of critical damping; of a root at rest 0.
    fn damping_ratio(self) -> f64 {
        let frequency = self.frequency();
        if frequency > 0.0 { -self.re / frequency } else { 0.0 }
    }

    fn is_shown(self) -> bool {
        self.damping_ratio() < WELL_DAMPED || self.frequency() < FAST
    }

    /// Eigenvalue, frequency, damping ratio, period, time to half or double.
    fn cells(self) -> [String; 5] {
        let Root { re, im } = self;
        let none = || "–".to_owned();
        let [eigenvalue, period, damping] = if im > 0.0 {
            let eigenvalue = format!("{} ± {}i", fixed(re, 5), fixed(im, 5));
            [eigenvalue, fixed(TAU / im, 3), fixed(self.damping_ratio(), 4)]
        } else {
            [fixed(re, 5), none(), none()]
        };
        let time = LN_2 / re.abs();
        let time = match re {
            _ if time > 1e6 => none(),
            re if re < 0.0 => format!("{} to half", fixed(time, 3)),
            _ => format!("{} to double", fixed(time, 3)),
        };
        [eigenvalue, fixed(self.frequency(), 4), damping, period, time]
    }
}

/// What was linearised, and the slow and the lightly damped roots, slowest first; a warning where they are not found.
pub fn text(model: &ReducedModel, settings: &Settings, linear: &LinearModel) -> String {
    let eigenvalues = linear.eigenvalues().unwrap_or_else(|error| {
        diagnostics::warn(&error.to_string());
        Vec::new()
    });
    let upper =
        eigenvalues.iter().filter(|root| root.im >= 0.0).map(|root| Root { re: root.re, im: root.im });
    let (mut shown, others): (Vec<Root>, Vec<Root>) = upper.partition(|root| root.is_shown());
    shown.sort_by(|a, b| a.frequency().total_cmp(&b.frequency()));
    let heads = ["eigenvalue (1/s)", "frequency (rad/s)", "damping ratio", "period (s)", "time (s)"];
    let mut lines = vec![heads.map(str::to_owned).to_vec()];
    lines.extend(shown.into_iter().map(|root| root.cells().to_vec()));
    let manoeuvre = match model.support {
        Support::Free => settings.plant.condition.manoeuvre().name(!model.engines.is_empty()),
        Support::Clamped => "rest in the tunnel",
    };
    let [states, inputs, outputs] = [&linear.states, &linear.inputs, &linear.outputs].map(Vec::len);
    let mut text = format!(
        "{}: {manoeuvre}, {}\n{states} states, {inputs} inputs, {outputs} outputs\n{}\n{}",
        model.name,
        condition(model, settings),
        planes(&linear.gust_planes),
        aligned(&lines)
    );
    if !others.is_empty() {
        text += &format!(
            "\nand {} roots with a damping ratio above {WELL_DAMPED} and a frequency above {FAST} rad/s, most of them the wake's\n",
            others.len()
        );
    }
    text + "\n"
}

/// Where a gust is given to the model, if it is.
fn planes(places: &[f64]) -> String {
    let [first, second, ..] = places else { return String::new() };
    let last = places[places.len() - 1];
    let (count, apart) = (places.len(), first - second);
    let [first, last, apart] = [*first, last, apart].map(|number| fixed(number, 4));
    format!("{count} gust planes, {first} to {last} m ahead of O, {apart} m apart\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_is_told_as_people_know_it() {
        let pair = Root { re: -0.5, im: 1.2 };
        assert_eq!(pair.cells(), ["−0.50000 ± 1.20000i", "1.3000", "0.3846", "5.236", "1.386 to half"]);
        let growing = Root { re: 0.1, im: 0.0 };
        assert_eq!(growing.cells(), ["0.10000", "0.1000", "–", "–", "6.931 to double"]);
        assert_eq!(Root { re: 0.0, im: 0.0 }.cells()[4], "–");
        assert!(pair.is_shown() && growing.is_shown() && Root { re: -4.0, im: 0.0 }.is_shown());
        assert!(!Root { re: -40.0, im: 10.0 }.is_shown());
    }
}
