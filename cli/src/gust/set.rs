//! Which gusts are flown: the options that `flexair gust` and `flexair loads` share.

use clap::{Args, ValueEnum};
use flexible_aircraft::air::{CS25_GRADIENTS, GustCriterion, GustSettings, GustShape};
use flexible_aircraft::flight::Settings;

use super::alleviation::{Weights, weights};
use super::case::{Case, Sense};
use super::gradients::{Gradients, gradients};
use crate::numbers::{Plain, rounded};

mod of_turbulence;

pub use of_turbulence::refuse_times;

/// A set of gusts.
#[derive(Args)]
pub struct GustSetOptions {
    /// Gradients H of the gusts, m: the least, the greatest and how many, equally far apart; or a list, as in 15,30,60
    /// [default: 9.144:106.68:37]
    #[arg(long, value_name = "FROM:TO:N|M,M,…", value_parser = gradients, allow_hyphen_values = true)]
    gradients: Option<Gradients>,

    /// What the peak follows from
    #[arg(long, value_enum, default_value_t = Criterion::Cs25Vc)]
    criterion: Criterion,

    /// Peak of every gust, m/s of true airspeed, in place of a criterion
    #[arg(long, value_name = "M/S", value_parser = peak, conflicts_with = "criterion")]
    peak: Option<f64>,

    /// Directions of the gusts across the track, degrees: 0 upwards, 90 to the right. May be repeated or a list; the opposite
    /// of each is flown too, and is the same continuous turbulence
    #[arg(
        long,
        value_name = "DEG",
        value_delimiter = ',',
        value_parser = degrees,
        default_value = "0",
        allow_hyphen_values = true
    )]
    direction: Vec<f64>,

    /// Maximum take-off, landing and zero-fuel weight, of any unit: F_g of CS-25 at sea level follows from them and from
    /// `gust.maximum_operating_altitude`
    #[arg(
        long,
        value_name = "MTOW,MLW,MZFW",
        value_parser = weights,
        conflicts_with = "peak",
        allow_hyphen_values = true
    )]
    weights: Option<Weights>,
}

/// What the peak of a gust follows from, under the names of the FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Criterion {
    /// CS 25.341(a) at the design cruising speed
    #[value(name = "cs25_vc")]
    Cs25Vc,
    /// CS 25.341(a) at the design dive speed: half of it
    #[value(name = "cs25_vd")]
    Cs25Vd,
}

/// Why no such gusts are flown.
#[derive(Debug, PartialEq, thiserror::Error)]
pub enum Error {
    #[error("--set {0}: the gusts of a set have their own, by {1}")]
    OwnParameter(String, &'static str),
    #[error(
        "--gradients: found {} m, allowed with CS-25 is {} to {} m; --peak flies others",
        Plain(*.0),
        CS25_GRADIENTS.start(),
        CS25_GRADIENTS.end()
    )]
    Cs25Gradient(f64),
    #[error(
        "found a flight of {} s, but the gusts begin at {} s (`gust.start`): allowed is a longer one",
        Plain(*duration),
        Plain(*start)
    )]
    Late { duration: f64, start: f64 },
    #[error(
        "{option}: found with --continuous, where {why}: meant is {meant}, or {option} without --continuous"
    )]
    OfSingleGusts { option: &'static str, why: &'static str, meant: &'static str },
    #[error(
        "--set {assignment}: continuous turbulence has an rms of 1 m/s everywhere{meant}; allowed of gust.* and turbulence.* \
         are {}",
        of_turbulence::ALLOWED.join(", ")
    )]
    NotOfTurbulence { assignment: String, meant: String },
}

fn peak(text: &str) -> Result<f64, String> {
    let peak = text.parse().ok().filter(|peak: &f64| peak.is_finite() && *peak > 0.0);
    peak.ok_or_else(|| "allowed is a number of m/s, greater than 0: both senses are flown".to_owned())
}

fn degrees(text: &str) -> Result<f64, String> {
    let degrees = text.trim().parse().ok().filter(|degrees: &f64| degrees.is_finite());
    degrees.ok_or_else(|| {
        "allowed is a finite number of degrees, or several with commas between them".to_owned()
    })
}

impl GustSetOptions {
    /// Every gradient in every direction in both senses, of a flight with some settings, whose assignments were these, and
    /// which lasts so long, s.
    ///
    /// # Errors
    /// When the assignments contradict the options, or there is no such gust.
    pub fn cases(
        &self,
        settings: &Settings,
        assignments: &[String],
        duration: f64,
    ) -> Result<Vec<Case>, Error> {
        self.refuse_own(assignments)?;
        let is_within = |gradient: &&f64| CS25_GRADIENTS.contains(*gradient);
        let Gradients(gradients) = self.gradients.clone().unwrap_or_else(Gradients::usual);
        if let Some(outside) = gradients.iter().find(|gradient| self.peak.is_none() && !is_within(gradient)) {
            return Err(Error::Cs25Gradient(*outside));
        }
        let start = settings.gust.start;
        if duration <= start {
            return Err(Error::Late { duration, start });
        }
        let every = self.every(&settings.gust);
        let mut cases: Vec<Case> = Vec::new();
        for &degrees in &self.direction {
            for sense in Sense::BOTH {
                cases.extend(gradients.iter().map(|gradient| Case::new(&every, *gradient, degrees, sense)));
            }
        }
        Ok(without_repetitions(cases))
    }

    /// What each gust has, but for its gradient and direction.
    fn every(&self, of_flight: &GustSettings) -> GustSettings {
        let criterion = match (self.peak, self.criterion) {
            (Some(_), _) => GustCriterion::Peak,
            (None, Criterion::Cs25Vc) => GustCriterion::Cs25Vc,
            (None, Criterion::Cs25Vd) => GustCriterion::Cs25Vd,
        };
        let at_sea_level =
            |weights: Weights| weights.alleviation_at_sea_level(of_flight.maximum_operating_altitude);
        GustSettings {
            shape: GustShape::OneMinusCosine,
            criterion,
            peak: self.peak.unwrap_or(of_flight.peak),
            alleviation: self.weights.map_or(of_flight.alleviation, at_sea_level),
            ..*of_flight
        }
    }

    /// What an option says is not said again by `--set`.
    fn refuse_own(&self, assignments: &[String]) -> Result<(), Error> {
        let always = [
            ("gust.gradient", "--gradients"),
            ("gust.shape", "--gradients"),
            ("gust.criterion", "--criterion or --peak"),
            ("gust.peak", "--peak"),
            ("gust.direction", "--direction"),
        ];
        let weights = self.weights.map(|_| ("gust.alleviation", "--weights"));
        for (name, instead) in always.into_iter().chain(weights) {
            if let Some(set) = assignments.iter().find(|set| set.split('=').next() == Some(name)) {
                return Err(Error::OwnParameter(set.clone(), instead));
            }
        }
        Ok(())
    }
}

/// The first of each.
fn without_repetitions(cases: Vec<Case>) -> Vec<Case> {
    let mut seen = std::collections::HashSet::new();
    cases.into_iter().filter(|case| seen.insert(case.identity())).collect()
}

/// A warning where the longest gusts are not over when a flight of so many seconds ends, if there are such.
pub fn cut_off(cases: &[Case], settings: &Settings, duration: f64) -> Option<String> {
    let longest = cases.iter().map(|case| case.gust.gradient).reduce(f64::max)?;
    let (start, airspeed) = (settings.gust.start, settings.plant.airspeed);
    let end = start + 2.0 * longest / airspeed;
    (end > duration).then(|| {
        format!(
            "the gust with a gradient of {} m, met at {} s (`gust.start`), passes the nose until {end:.3} s at {} m/s: it is not \
             over when the flight ends, at {} s",
            Plain(longest),
            Plain(start),
            Plain(airspeed),
            Plain(duration)
        )
    })
}

/// Why gusts or turbulence have their strength, where a criterion gives it: the paragraph, the speed, and F_g.
pub fn by_criterion(gust: &GustSettings, paragraph: &str, altitude: f64) -> Option<String> {
    let speed = match gust.criterion {
        GustCriterion::Peak => return None,
        GustCriterion::Cs25Vc => "VC",
        GustCriterion::Cs25Vd => "VD",
    };
    let here = gust.alleviation_at(altitude);
    Some(format!(
        "by CS 25.341({paragraph}) at {speed}, F_g {:.5} at sea level, {here:.5} here",
        gust.alleviation
    ))
}

/// From which peak to which, and why: a line of a report on gusts with such settings.
pub fn peaks(gust: &GustSettings, altitude: f64, peaks: impl Iterator<Item = f64> + Clone) -> String {
    let [least, greatest] = [peaks.clone().fold(f64::INFINITY, f64::min), peaks.fold(0.0, f64::max)];
    let range = if least == greatest {
        rounded(least)
    } else {
        format!("{} to {}", rounded(least), rounded(greatest))
    };
    match by_criterion(gust, "a", altitude) {
        None => format!("peak {range} m/s of true airspeed, as given"),
        Some(why) => format!("peak {range} m/s of true airspeed {why}"),
    }
}

#[cfg(test)]
mod tests;
