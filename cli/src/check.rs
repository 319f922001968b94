//! The flight that shows that a packaged FMU works: loaded and stepped through the C interface, as any
//! importing tool would.
//!
//! A free aircraft flies the elevator 2-3-1-1 [theory: thesis-runs.inputs] by whichever control it has for pitch. One that is
//! clamped in a wind tunnel may have no control and bends all the same when the wind does: a vertical gust goes up and down
//! past it.

use std::fmt;
use std::ops::RangeInclusive;
use std::time::{Duration, Instant};

use flexible_aircraft::aircraft::{Aircraft, Control, Support, TrimRole};
use flexible_aircraft_packaging::FmuError;
use flexible_aircraft_packaging::c_abi::{Fmu, Instance};

use crate::diagnostics;
use crate::manoeuvre::Manoeuvre;

/// Time constant of the actuator, s.
const LAG: f64 = 0.05;
/// Communication step, s, and their number.
const STEP: f64 = 0.01;
const STEPS: u32 = 1500;

/// What the flight showed.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckFlight {
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

#[derive(Clone, Debug, PartialEq)]
struct Trim {
    angles: Vec<TrimAngle>,
    along: Along,
}

/// An angle of a trim.
#[derive(Clone, Debug, PartialEq)]
struct TrimAngle {
    /// For people.
    name: String,
    /// rad.
    angle: f64,
    /// Whether it is told though it is 0.
    is_in_plane: bool,
}

/// Smaller angles, rad, would be told as 0.
const NO_ANGLE: f64 = 5e-6;

/// What balances an aircraft along its path.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Along {
    /// N per engine.
    Thrust(f64),
    /// The path of a glider, rad above the horizon.
    ClimbAngle(f64),
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

impl CheckFlight {
    /// s.
    pub const DURATION: f64 = STEP * STEPS as f64;

    /// Flies a new instance of the FMU of an aircraft with the default parameters.
    ///
    /// # Errors
    /// When the FMU refuses a call.
    pub fn fly(fmu: &Fmu, aircraft: &Aircraft) -> Result<Self, FmuError> {
        let (support, controls) = (aircraft.support, &aircraft.controls);
        let (moved, manoeuvre) = excitation(support, controls);
        let input = [fmu.variable(moved)?];
        let stations: Vec<&str> = fmu.variable_names().filter_map(station).collect();
        let mut watched = fmu.variables(&["attitude.pitch", "load_factor.z"])?;
        for station in &stations {
            watched.push(fmu.variable(&format!("deflection.{station}.up"))?);
        }

        let mut aircraft = fmu.instantiate("check")?;
        aircraft.initialise(0.0, None)?;
        for line in aircraft.take_log().lines() {
            if let Some(warning) = line.strip_prefix("[logStatusWarning] fmi2ExitInitializationMode: ") {
                diagnostics::warn(warning);
            }
        }
        let trim = Trim::read(fmu, &mut aircraft, controls)?;
        let mut history = vec![vec![0.0; watched.len()]; STEPS as usize + 1];
        aircraft.get_real(&watched, &mut history[0])?;

        let beginning = Instant::now();
        for (step, outputs) in (0..STEPS).zip(&mut history[1..]) {
            let time = f64::from(step) * STEP;
            aircraft.set_real(&input, &[manoeuvre.value(time)])?;
            aircraft.do_step(time, STEP)?;
            aircraft.get_real(&watched, outputs)?;
        }
        let computing = beginning.elapsed();
        aircraft.terminate()?;

        Ok(CheckFlight {
            support,
            input: moved.to_owned(),
            trim,
            deflection: peak_deflection(&stations, &history),
            pitch: range(history.iter().map(|outputs| outputs[0])),
            load_factor: range(history.iter().map(|outputs| outputs[1])),
            computing,
        })
    }
}

impl Trim {
    fn read(fmu: &Fmu, aircraft: &mut Instance<'_>, controls: &[Control]) -> Result<Self, FmuError> {
        let has = |wanted: &str| fmu.variable_names().any(|name| name == wanted);
        let value = |name: &str| {
            let mut value = [0.0];
            aircraft.get_real(&[fmu.variable(name)?], &mut value).map(|()| value[0])
        };
        let with_role = |role| with_role(controls, role).map(|name| (name, name, role == TrimRole::Pitch));
        let outputs = [
            Some(("pitch", "pitch", true)),
            with_role(TrimRole::Pitch),
            Some(("roll", "bank angle", false)),
            Some(("beta", "sideslip", false)),
            with_role(TrimRole::Roll),
            with_role(TrimRole::Yaw),
        ];
        let angles = outputs.into_iter().flatten().map(|(output, name, is_in_plane)| {
            let angle = value(&format!("trim.{output}"))?;
            Ok(TrimAngle { name: name.to_owned(), angle, is_in_plane })
        });
        let angles = angles.collect::<Result<_, FmuError>>()?;
        let along = if has("trim.climb_angle") {
            Along::ClimbAngle(value("trim.climb_angle")?)
        } else {
            Along::Thrust(value("trim.thrust")?)
        };
        Ok(Trim { angles, along })
    }
}

impl fmt::Display for Trim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let angle = |f: &mut fmt::Formatter<'_>, name: &str, angle: f64| {
            writeln!(f, "  {name:<15} {:8.3}° ({angle:.5} rad)", angle.to_degrees())
        };
        for told in self.angles.iter().filter(|told| told.is_in_plane || told.angle.abs() >= NO_ANGLE) {
            angle(f, &told.name, told.angle)?;
        }
        match self.along {
            Along::Thrust(thrust) => writeln!(f, "  thrust          {thrust:8.0} N per engine"),
            Along::ClimbAngle(climb) => angle(f, "climb angle", climb),
        }
    }
}

/// The control with a role, by its name.
fn with_role(controls: &[Control], role: TrimRole) -> Option<&str> {
    controls.iter().find(|control| control.role == Some(role)).map(|control| control.name.as_str())
}

/// The input that moves the aircraft, and how.
fn excitation(support: Support, controls: &[Control]) -> (&str, Manoeuvre) {
    match (support, with_role(controls, TrimRole::Pitch)) {
        // Of an elevator that is positive nose-down, nose-up first.
        (Support::Free, Some(control)) => (control, Manoeuvre::two_three_one_one(-0.05, 0.7, 1.0, LAG)),
        _ => ("wind_down", Manoeuvre::doublet(-1.0, 2.0, 1.0, LAG)),
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

impl fmt::Display for CheckFlight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let duration = Self::DURATION;
        match self.support {
            Support::Free => {
                write!(f, "Trimmed:\n{}", self.trim)?;
                writeln!(f, "2-3-1-1 of 0.05 rad of {}, {duration} s:", self.input)?;
            }
            Support::Clamped => {
                writeln!(
                    f,
                    "Clamped in a wind tunnel, vertical gust of 1 m/s, 2 s up, 2 s down, {duration} s:"
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
        write!(f, "  computed in     {seconds:8.3} s: {:.0} times faster than real time", duration / seconds)
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use flexible_aircraft_packaging::{Licences, Package, Platform};

    use super::*;

    /// The check flight of the generic business jet, free or clamped, with the library that cargo built
    /// beside this test.
    fn jet(support: Support) -> CheckFlight {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let folder = tempfile::tempdir().unwrap();
        let [aircraft, fmu] = ["aircraft.toml", "aircraft.fmu"].map(|name| folder.path().join(name));
        let text = std::fs::read_to_string(workspace.join("aircraft/generic-business-jet.toml")).unwrap();
        let text = match support {
            Support::Free => text,
            Support::Clamped => text.replace("support = \"free\"", "support = \"clamped\""),
        };
        std::fs::write(&aircraft, text).unwrap();
        let read = Aircraft::read(&aircraft).unwrap();
        let name =
            format!("{}flexible_aircraft{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
        let library = std::env::current_exe().unwrap().with_file_name(name);
        let binaries = vec![(Platform::host().unwrap(), library)];
        Package {
            aircraft,
            mode_count: 12.into(),
            load_modes: false,
            starts: Vec::new(),
            stations_along: Vec::new(),
            binaries,
            licences: Licences::Workspace(workspace),
        }
        .write(&fmu)
        .unwrap();
        CheckFlight::fly(&Fmu::open(&fmu).unwrap(), &read).unwrap()
    }

    #[test]
    fn a_free_aircraft_is_trimmed_and_answers_the_elevator() {
        let flight = jet(Support::Free);
        assert!(flight.load_factor.contains(&0.9) && flight.load_factor.contains(&1.05), "{flight:?}");
        assert!(
            flight.pitch.contains(&flight.trim.angles[0].angle)
                && matches!(flight.trim.along, Along::Thrust(thrust) if thrust > 1e4)
        );
        let peak = flight.deflection.unwrap();
        assert!(peak.station.starts_with("wing_tip") && peak.up > peak.trimmed + 0.01, "{peak:?}");
    }

    #[test]
    fn a_trim_tells_what_is_out_of_symmetry_where_it_is() {
        let told = |lateral: f64| {
            let angles = [
                ("pitch", 0.1, true),
                ("elevator", -0.02, true),
                ("bank angle", lateral, false),
                ("sideslip", -lateral, false),
                ("aileron", 2.0 * lateral, false),
                ("rudder", -2.0 * lateral, false),
            ];
            let angles = angles.map(|(name, angle, is_in_plane)| TrimAngle {
                name: name.to_owned(),
                angle,
                is_in_plane,
            });
            let angles = angles.to_vec();
            Trim { angles, along: Along::ClimbAngle(-0.05) }.to_string()
        };
        assert_eq!(
            told(0.01),
            "  pitch              5.730° (0.10000 rad)\n  elevator          -1.146° (-0.02000 rad)\n  \
             bank angle         0.573° (0.01000 rad)\n  sideslip          -0.573° (-0.01000 rad)\n  \
             aileron            1.146° (0.02000 rad)\n  rudder            -1.146° (-0.02000 rad)\n  \
             climb angle       -2.865° (-0.05000 rad)\n"
        );
        assert_eq!(told(0.0).lines().count(), 3);
    }

    #[test]
    fn a_clamped_aircraft_holds_still_and_bends_in_the_gust() {
        let flight = jet(Support::Clamped);
        assert_eq!(flight.pitch.start(), flight.pitch.end());
        let peak = flight.deflection.unwrap();
        assert!((peak.up - peak.trimmed).abs() > 0.01 && peak.time > 1.0, "{peak:?}");
    }

    #[test]
    fn the_largest_deflection_is_found_with_its_station_and_time() {
        let history = [vec![0.1, 1.0, 0.5, 0.2], vec![0.1, 1.0, 0.7, -0.9], vec![0.1, 1.0, 0.6, 0.1]];
        let peak = peak_deflection(&["wing_tip", "htail_tip"], &history).unwrap();
        assert_eq!(peak, PeakDeflection { station: "htail_tip".into(), up: -0.9, trimmed: 0.2, time: 0.01 });
    }

    #[test]
    fn without_modes_no_deflection_is_told() {
        assert_eq!(peak_deflection(&["wing_tip"], &[vec![0.1, 1.0, 0.0], vec![0.1, 1.0, 0.0]]), None);
    }

    #[test]
    fn a_downward_peak_is_called_so() {
        let peak = PeakDeflection { station: "wing_tip".into(), up: -0.182, trimmed: 0.05, time: 3.5 };
        let flight = CheckFlight {
            support: Support::Clamped,
            input: "wind_down".to_owned(),
            trim: Trim { angles: Vec::new(), along: Along::Thrust(0.0) },
            deflection: Some(peak),
            pitch: 0.0..=0.0,
            load_factor: 0.0..=0.0,
            computing: Duration::from_secs(1),
        };
        let text = flight.to_string();
        assert!(text.contains(" 0.182 m down at 3.50 s, wing_tip (0.050 m up at first)"), "{text}");
    }

    #[test]
    fn only_upward_deflections_name_a_station() {
        assert_eq!(station("deflection.wing_tip_right.up"), Some("wing_tip_right"));
        assert_eq!(station("deflection.wing_tip_right.x"), None);
        assert_eq!(station("position.north"), None);
    }
}
