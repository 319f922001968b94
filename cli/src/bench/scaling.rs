//! How the right-hand side and the flight grow with modes, strips, inflow states and fidelity.

use std::sync::Arc;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::{ModeCount, ReducedModel, ReducedStrip};
use flexible_aircraft::symmetry::Plants;

use crate::progress::Progress;

use super::equations::{pitch_control, time_of};
use super::{BenchError, least_time};

/// Seconds flown for each point.
const SECONDS: f64 = 2.0;

/// Numbers of modes, parts that strips are cut into, and inflow states.
const MODES: [usize; 7] = [0, 4, 8, 12, 20, 30, 40];
const PARTS: [usize; 3] = [1, 2, 4];
const INFLOW_STATES: [usize; 9] = [0, 1, 2, 3, 4, 5, 6, 7, 8];

/// One aircraft.
pub struct Point {
    pub label: String,
    /// What varies, as a number.
    pub size: usize,
    /// Of half and of all of the aircraft.
    pub half: Costs,
    pub whole: Costs,
}

/// What flying by one set of equations costs.
pub struct Costs {
    /// Of the right-hand side, s.
    pub right_hand_side: f64,
    /// Processor time for a second of flight in steps of 10 ms with a moving elevator, s.
    pub time_per_second: f64,
}

/// All aircraft.
pub struct Scaling {
    pub modes: Vec<Point>,
    pub strips: Vec<Point>,
    pub inflow_states: Vec<Point>,
    pub fidelity: Vec<Point>,
    /// Of one simulation, bytes.
    pub memory: Option<usize>,
}

impl Scaling {
    /// Measures about the trim of the standard flight.
    pub fn measure(aircraft: &Aircraft, model: &Arc<ReducedModel>) -> Result<Self, BenchError> {
        let most = Arc::new(ReducedModel::new(aircraft, ModeCount::Usual(40))?);
        let standard = Settings::of(model);
        let counts: Vec<usize> = MODES.into_iter().filter(|&count| count <= most.natural_modes()).collect();
        let points = counts.len() + PARTS.len() + INFLOW_STATES.len() + Fidelity::ALL.len();
        let progress = Progress::new(points, "aircraft");
        let point = |model: &Arc<ReducedModel>, settings: &Settings, label: String, size: usize| {
            let measured = point(model, settings, label, size);
            progress.advance();
            measured
        };
        let modes = counts.into_iter().map(|mode_count| {
            let settings = Settings::from(PlantSettings { mode_count, ..standard.plant });
            point(&most, &settings, format!("{mode_count} modes"), mode_count)
        });
        let strips = PARTS.map(|parts| {
            let model = Arc::new(with_strips_in_parts(model, parts));
            point(&model, &standard, format!("{} strips", model.strips.len()), model.strips.len())
        });
        let inflow_states = INFLOW_STATES.map(|inflow_states| {
            let settings = Settings::from(PlantSettings { inflow_states, ..standard.plant });
            point(model, &settings, format!("{inflow_states} inflow states"), inflow_states)
        });
        let fidelity = Fidelity::ALL.map(|fidelity| {
            let settings = Settings::from(PlantSettings { fidelity, ..standard.plant });
            point(
                model,
                &settings,
                format!("{}, {}", fidelity.symbol(), fidelity.in_words()),
                fidelity as usize,
            )
        });
        Ok(Scaling {
            modes: modes.collect::<Result<_, _>>()?,
            strips: strips.into_iter().collect::<Result<_, _>>()?,
            inflow_states: inflow_states.into_iter().collect::<Result<_, _>>()?,
            fidelity: fidelity.into_iter().collect::<Result<_, _>>()?,
            memory: memory(model)?,
        })
    }
}

fn point(
    model: &Arc<ReducedModel>,
    settings: &Settings,
    label: String,
    size: usize,
) -> Result<Point, BenchError> {
    let plants = Plants::under(model, &settings.plant)?;
    let half = plants.half().ok_or_else(|| BenchError::NoMirrorPlane(model.name.clone()))?;
    let trimmed = Simulation::new(Arc::clone(model), settings, 0.0)?;
    Ok(Point {
        label,
        size,
        half: Costs {
            right_hand_side: time_of(half, &settings.plant)?,
            time_per_second: flight_time(&trimmed, model, 0.0)?,
        },
        whole: Costs {
            right_hand_side: time_of(plants.whole(), &settings.plant)?,
            time_per_second: flight_time(&trimmed, model, UNNOTICEABLE)?,
        },
    })
}

/// A wind from the side, m/s, that moves nothing but has the whole aircraft fly.
const UNNOTICEABLE: f64 = 1e-12;

/// Processor time for a second of flight, s.
fn flight_time(trimmed: &Simulation, model: &ReducedModel, side_wind: f64) -> Result<f64, BenchError> {
    let (moved, steady) = (pitch_control(model)?, Inputs::zero(model));
    let time = least_time(3, || {
        let (mut flight, mut inputs) = (trimmed.clone(), steady.clone());
        inputs.wind.y = side_wind;
        for step in 0..(SECONDS * 100.0) as u32 {
            inputs.controls[moved] = -0.01 * f64::from(step % 2);
            flight.set_inputs(&inputs, &steady);
            flight.advance_to(0.01 * f64::from(step + 1))?;
            if flight.is_symmetric() != (side_wind == 0.0) {
                return Err(BenchError::OtherPart { side_wind });
            }
            std::hint::black_box(flight.outputs());
        }
        Ok(())
    })?;
    Ok(time / SECONDS)
}

/// The same aircraft with every strip cut into strips of a share of its width, at the same place.
fn with_strips_in_parts(model: &ReducedModel, parts: usize) -> ReducedModel {
    let cut = |strip: &ReducedStrip| ReducedStrip { width: strip.width / parts as f64, ..strip.clone() };
    let strips = model.strips.iter().flat_map(|strip| std::iter::repeat_n(cut(strip), parts)).collect();
    ReducedModel { strips, ..model.clone() }
}

/// What a simulation takes, bytes: the growth of the process over many; `None` where the system does not tell.
fn memory(model: &Arc<ReducedModel>) -> Result<Option<usize>, BenchError> {
    const MANY: usize = 50;
    let standard = Settings::of(model);
    let Some(before) = resident() else { return Ok(None) };
    let flights = (0..MANY)
        .map(|_| Simulation::new(Arc::clone(model), &standard, 0.0))
        .collect::<Result<Vec<_>, _>>()?;
    let after = resident();
    drop(std::hint::black_box(flights));
    Ok(after.map(|after| after.saturating_sub(before) / MANY))
}

/// Memory of this process that is resident, bytes (Linux).
fn resident() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    Some(1024 * line.trim().trim_end_matches("kB").trim().parse::<usize>().ok()?)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn half_and_whole_of_the_aircraft_are_what_is_timed() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/generic-business-jet.toml");
        let model = Arc::new(ReducedModel::new(&Aircraft::read(&path).unwrap(), 2).unwrap());
        let settings = Settings::of(&model);
        let trimmed = Simulation::new(Arc::clone(&model), &settings, 0.0).unwrap();
        for side_wind in [0.0, UNNOTICEABLE] {
            flight_time(&trimmed, &model, side_wind).unwrap();
        }
        // Of an aircraft that has already left symmetry, what would be timed is all of it.
        let (mut aside, mut wind) = (trimmed.clone(), Inputs::zero(&model));
        wind.wind.y = 1.0;
        aside.set_inputs(&wind, &Inputs::zero(&model));
        aside.advance_to(0.01).unwrap();
        let refused = flight_time(&aside, &model, 0.0).unwrap_err().to_string();
        assert!(
            refused.contains("the whole of the aircraft flew where the half was to be timed"),
            "{refused}"
        );
    }
}
