//! The flight that shows that a packaged FMU works: loaded and stepped through the C interface, as any
//! importing tool would.
//!
//! A free aircraft flies the elevator 2-3-1-1 [theory: thesis-runs.inputs] by whichever control it has for pitch. One that is
//! clamped in a wind tunnel may have no control and bends all the same when the wind does: a vertical gust goes up and down
//! past it.
//!
//! For model exchange it is only the beginning of that, which this program integrates.

mod motion;
#[cfg(test)]
mod tests;
mod trim;

use std::fmt;
use std::ops::RangeInclusive;
use std::time::{Duration, Instant};

use flexible_aircraft::aircraft::{Aircraft, Control, Support, TrimRole};
use flexible_aircraft::fmi::Kind;
use flexible_aircraft_packaging::FmuError;
use flexible_aircraft_packaging::c_abi::Fmu;

use crate::diagnostics;
use crate::manoeuvre::Manoeuvre;
use motion::{Motion, Moved, STEP};
use trim::{Trim, with_role};

/// Time constant of the actuator, s.
const LAG: f64 = 0.05;

/// What the flight showed.
#[derive(Clone, Debug, PartialEq)]
pub struct ProofFlight {
    kind: Kind,
    support: Support,
    /// What moved the aircraft.
    input: String,
    trim: Trim,
    deflection: Option<PeakDeflection>,
    /// rad.
    pitch: RangeInclusive<f64>,
    load_factor: RangeInclusive<f64>,
    /// Spent in setting inputs, stepping and getting outputs.
    computing: Duration,
}

/// The largest deflection of any station, up or down.
#[derive(Clone, Debug, PartialEq)]
struct PeakDeflection {
    station: String,
    /// m.
    up: f64,
    /// m, at the beginning.
    trimmed: f64,
    /// s.
    time: f64,
}

impl ProofFlight {
    /// How long one is, s.
    pub fn duration(kind: Kind) -> f64 {
        STEP * f64::from(steps(kind))
    }

    /// Flies a new instance of the FMU of an aircraft with the default parameters.
    ///
    /// # Errors
    /// When the FMU refuses a call.
    pub fn fly(fmu: &Fmu, aircraft: &Aircraft) -> Result<Self, FmuError> {
        let (support, controls) = (aircraft.support, &aircraft.controls);
        let kind = fmu.interface().kind;
        let (name, manoeuvre) = excitation(kind, support, controls);
        let moved = Moved { input: fmu.variable(name)?, manoeuvre };
        let stations: Vec<&str> = fmu.variable_names().filter_map(station).collect();
        let mut watched = fmu.variables(&["attitude.pitch", "load_factor.z"])?;
        for station in &stations {
            watched.push(fmu.variable(&format!("deflection.{station}.up"))?);
        }

        let mut aircraft = fmu.instantiate("check")?;
        aircraft.initialise(0.0, None)?;
        for line in aircraft.take_log().lines() {
            if let Some(warning) = warning_of_trim(line) {
                diagnostics::warn(warning);
            }
        }
        let trim = Trim::read(fmu, &mut aircraft, controls)?;
        let mut history = vec![vec![0.0; watched.len()]; steps(kind) as usize + 1];
        aircraft.get_real(&watched, &mut history[0])?;

        let beginning = Instant::now();
        let mut motion = Motion::of(kind, &mut aircraft)?;
        for (step, outputs) in (0..steps(kind)).zip(&mut history[1..]) {
            motion.advance(&mut aircraft, &moved, f64::from(step) * STEP)?;
            aircraft.get_real(&watched, outputs)?;
        }
        let computing = beginning.elapsed();
        aircraft.terminate()?;

        Ok(ProofFlight {
            kind,
            support,
            input: name.to_owned(),
            trim,
            deflection: peak_deflection(&stations, &history),
            pitch: range(history.iter().map(|outputs| outputs[0])),
            load_factor: range(history.iter().map(|outputs| outputs[1])),
            computing,
        })
    }
}

/// How often the outputs are looked at.
fn steps(kind: Kind) -> u32 {
    match kind {
        Kind::CoSimulation => 1500,
        Kind::ModelExchange => 100,
    }
}

/// What a line of the log warns of the trim.
fn warning_of_trim(line: &str) -> Option<&str> {
    let said = line.strip_prefix("[logStatusWarning] ")?;
    ["fmi2", "fmi3"].iter().find_map(|version| {
        said.strip_prefix(version).and_then(|said| said.strip_prefix("ExitInitializationMode: "))
    })
}

/// The input that moves the aircraft, and how; soon in a short flight.
fn excitation(kind: Kind, support: Support, controls: &[Control]) -> (&str, Manoeuvre) {
    let start = match kind {
        Kind::CoSimulation => 1.0,
        Kind::ModelExchange => 0.1,
    };
    match (support, with_role(controls, TrimRole::Pitch)) {
        // Of an elevator that is positive nose-down, nose-up first.
        (Support::Free, Some(control)) => (control, Manoeuvre::two_three_one_one(-0.05, 0.7, start, LAG)),
        _ => ("wind_down", Manoeuvre::doublet(-1.0, 2.0, start, LAG)),
    }
}

/// The station, if the variable is its upward deflection.
fn station(variable: &str) -> Option<&str> {
    variable.strip_prefix("deflection.")?.strip_suffix(".up")
}

/// None when nothing deflects, as without modes. Over a history of outputs whose third and following columns are the deflections of the stations.
fn peak_deflection(stations: &[&str], history: &[Vec<f64>]) -> Option<PeakDeflection> {
    let peak = |column: usize| {
        let steps = 0..history.len();
        steps.max_by(|&a, &b| history[a][column].abs().total_cmp(&history[b][column].abs()))
    };
    let deflects = |peak: &PeakDeflection| peak.up != 0.0;
    let peaks = stations.iter().enumerate().filter_map(|(index, station)| {
        let (column, step) = (index + 2, peak(index + 2)?);
        Some(PeakDeflection {
            station: (*station).to_owned(),
            up: history[step][column],
            trimmed: history[0][column],
            time: step as f64 * STEP,
        })
    });
    peaks.filter(deflects).max_by(|a, b| a.up.abs().total_cmp(&b.up.abs()))
}

fn up_or_down(up: f64) -> String {
    format!("{:.3} m {}", up.abs(), if up < 0.0 { "down" } else { "up" })
}

fn range(values: impl Iterator<Item = f64>) -> RangeInclusive<f64> {
    let (low, high) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (value.min(low), value.max(high)));
    low..=high
}

impl fmt::Display for ProofFlight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let duration = Self::duration(self.kind);
        let part = match self.kind {
            Kind::CoSimulation => "",
            Kind::ModelExchange => "the first ",
        };
        match self.support {
            Support::Free => {
                write!(f, "Trimmed:\n{}", self.trim)?;
                writeln!(f, "2-3-1-1 of 0.05 rad of {}, {part}{duration} s:", self.input)?;
            }
            Support::Clamped => {
                writeln!(
                    f,
                    "Clamped in a wind tunnel, vertical gust of 1 m/s, 2 s up, 2 s down, {part}{duration} s:"
                )?;
            }
        }
        if let Some(PeakDeflection { station, up, trimmed, time }) = &self.deflection {
            let [peak, trimmed] = [*up, *trimmed].map(up_or_down);
            writeln!(f, "  peak deflection {peak:>13} at {time:.2} s, {station} ({trimmed} at first)")?;
        }
        if self.support == Support::Free {
            let [low, high] = [self.pitch.start(), self.pitch.end()].map(|angle| angle.to_degrees());
            writeln!(f, "  pitch           {low:8.3}° to {high:.3}°")?;
            writeln!(
                f,
                "  load factor     {:8.3} to {:.3}",
                self.load_factor.start(),
                self.load_factor.end()
            )?;
        }
        let seconds = self.computing.as_secs_f64();
        match self.kind {
            Kind::CoSimulation => {
                let times = duration / seconds;
                write!(f, "  computed in     {seconds:8.3} s: {times:.0} times faster than real time")
            }
            Kind::ModelExchange => {
                write!(f, "  integrated in   {seconds:8.3} s, by Runge-Kutta steps of 1 ms")
            }
        }
    }
}
