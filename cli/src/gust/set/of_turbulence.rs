//! Continuous turbulence as the options of gusts and assignments ask for it, and what of them it does not have.

use flexible_aircraft::air::GustSettings;
use flexible_aircraft::flight::Settings;

use super::{Error, GustSetOptions};

/// The parameters of gusts and turbulence that continuous turbulence has.
pub const ALLOWED: [&str; 4] =
    ["turbulence.spectrum", "turbulence.scale", "gust.alleviation", "gust.maximum_operating_altitude"];

/// What is probably meant by what continuous turbulence does not have.
const SCALE: &str = "`--set turbulence.scale=…` (m)";
const CRITERION: &str = "--criterion, from which U_σ follows";
const FLIGHT: &str = "`flexair simulate --set turbulence.spectrum=von_karman`, which flies";

impl GustSetOptions {
    /// Its directions, degrees, each once, and the gust whose U_σ it has by the criterion, under settings whose assignments were these.
    ///
    /// # Errors
    /// When options or assignments say what no such turbulence has.
    pub fn continuous(
        &self,
        settings: &Settings,
        assignments: &[String],
    ) -> Result<(Vec<f64>, GustSettings), Error> {
        let own = [
            ("--gradients", self.gradients.is_some(), "no gust has a gradient", SCALE),
            ("--peak", self.peak.is_some(), "no gust has a peak", CRITERION),
        ];
        refuse_of_flights(&own)?;
        for assignment in assignments {
            let name = assignment.split('=').next().unwrap_or_default();
            let is_alleviated_twice = name == "gust.alleviation" && self.weights.is_some();
            if is_alleviated_twice {
                return Err(Error::OwnParameter(assignment.clone(), "--weights"));
            }
            let is_of_air = ["gust.", "turbulence."].iter().any(|of| name.starts_with(of));
            if is_of_air && !ALLOWED.contains(&name) {
                let meant = meant_by(name).map_or(String::new(), |meant| format!(": meant is {meant}"));
                return Err(Error::NotOfTurbulence { assignment: assignment.clone(), meant });
            }
        }
        let mut directions: Vec<f64> = Vec::new();
        for direction in self.direction.iter().map(|&degrees| without_sense(degrees)) {
            if !directions.contains(&direction) {
                directions.push(direction);
            }
        }
        Ok((directions, self.every(&settings.gust)))
    }
}

/// Refuses how long and how finely flights are flown, where these are given.
///
/// # Errors
/// At the first that is.
pub fn refuse_times(duration: Option<f64>, step: Option<f64>) -> Result<(), Error> {
    let times = [("--duration", duration), ("--step", step)];
    refuse_of_flights(&times.map(|(option, time)| (option, time.is_some(), "nothing is flown", FLIGHT)))
}

/// Options, whether they are given, why they are of single gusts alone, and what is meant.
fn refuse_of_flights(options: &[(&'static str, bool, &'static str, &'static str)]) -> Result<(), Error> {
    match options.iter().find(|(_, is_given, ..)| *is_given) {
        Some(&(option, _, why, meant)) => Err(Error::OfSingleGusts { option, why, meant }),
        None => Ok(()),
    }
}

/// A parameter's option or other parameter, if there is any.
fn meant_by(name: &str) -> Option<&'static str> {
    match name {
        "gust.gradient" => Some(SCALE),
        "gust.shape" => Some("`--set turbulence.spectrum=…`"),
        "gust.peak" | "gust.criterion" | "turbulence.intensity" => Some(CRITERION),
        "gust.direction" | "turbulence.components" => Some("--direction"),
        "gust.start" | "turbulence.start" | "turbulence.seed" => Some(FLIGHT),
        _ => None,
    }
}

/// A direction, degrees, from 0 to less than 180: turbulence has no sense.
fn without_sense(degrees: f64) -> f64 {
    // Rounded: of -149.9 additions leave 30.099999999999994. Plus 0: of both zeros there is one.
    ((1e9 * degrees.rem_euclid(180.0)).round() / 1e9).rem_euclid(180.0) + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opposite_directions_of_turbulence_are_one() {
        let same = [(270.0, 90.0), (-90.0, 90.0), (180.0, 0.0), (-149.9, 30.1), (-1e-12, 0.0), (-0.0, 0.0)];
        for (given, expected) in same {
            assert_eq!(without_sense(given).to_bits(), f64::to_bits(expected), "{given}");
        }
        assert!((0.0..180.0).contains(&without_sense(-1e300)));
    }
}
