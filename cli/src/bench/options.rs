//! What gusts, turbulence and actuators add to the standard flight.

use super::BenchError;
use super::standard_flight::{Accuracy, Flown, ParameterValue, fly};
use crate::progress::Progress;

/// Of the flights that count as exact.
const REFERENCE_TOLERANCE: f64 = 1e-9;

/// A flight with something switched on.
pub struct Optional {
    /// For people.
    pub name: &'static str,
    pub accuracy: Accuracy,
}

/// Parameters by which something is switched on; `{}` stands for the control that moves.
type Switches = &'static [(&'static str, ParameterValue)];

const GUST: (&str, ParameterValue) = ("gust.shape", ParameterValue::Item(2));
const LAG: (&str, ParameterValue) = ("actuator.{}.frequency", ParameterValue::Number(40.0));
const RATE: (&str, ParameterValue) = ("actuator.{}.rate_limit", ParameterValue::Number(0.7));
const VON_KARMAN: (&str, ParameterValue) = ("turbulence.spectrum", ParameterValue::Item(3));
const STRENGTH: (&str, ParameterValue) = ("turbulence.intensity", ParameterValue::Number(1.5));
const VERTICAL: (&str, ParameterValue) = ("turbulence.components", ParameterValue::Item(2));

/// What is switched on, and the tolerances.
const FLIGHTS: [(&str, Switches, &[f64]); 5] = [
    ("1-cosine gust of 10 m/s, 30 m", &[GUST], &[1e-5]),
    ("actuator of 40 rad/s and 0.7 rad/s", &[LAG, RATE], &[1e-5]),
    ("gust and actuator", &[GUST, LAG, RATE], &[1e-5]),
    ("vertical turbulence of von Kármán, 1.5 m/s", &[VON_KARMAN, STRENGTH, VERTICAL], &[1e-3, 1e-5]),
    ("turbulence of all three components", &[VON_KARMAN, STRENGTH], &[1e-3, 1e-5]),
];

/// Flies them all.
pub fn measure(flown: Flown) -> Result<Vec<Optional>, BenchError> {
    let count = FLIGHTS.iter().map(|(.., tolerances)| tolerances.len()).sum();
    let (mut found, progress) = (Vec::new(), Progress::new(count, "measurements"));
    for (name, switches, tolerances) in FLIGHTS {
        let named = |(name, value): &(&str, ParameterValue)| (name.replace("{}", flown.control), *value);
        let parameters: Vec<(String, ParameterValue)> = switches.iter().map(named).collect();
        let flown = Flown { parameters: &parameters, ..flown };
        let exact = fly(flown, REFERENCE_TOLERANCE, 1, |_| {})?;
        for &tolerance in tolerances {
            let accuracy = Accuracy::measure(flown, tolerance, &exact)?;
            found.push(Optional { name, accuracy });
            progress.advance();
        }
    }
    Ok(found)
}
