//! How the right-hand side and the flight grow with modes, strips, inflow states, sections and fidelity.

use std::sync::Arc;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::{ModeCount, ReducedModel};
use flexible_aircraft::symmetry::Plants;

use crate::progress::Progress;

use super::equations::{pitch_control, time_of};
use super::larger::{with_bays_in_parts, with_strips_in_parts};
use super::{BenchError, least_time};

/// Seconds flown for each point.
const SECONDS: f64 = 2.0;

/// Numbers of modes, parts that strips or the bays of masses are cut into, and inflow states.
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
    pub geometrically_exact: GeometricallyExact,
    /// Of one simulation, bytes.
    pub memory: Option<usize>,
}

/// Aircraft that fly geometrically exact.
pub struct GeometricallyExact {
    pub modes: Vec<Point>,
    pub strips: Vec<Point>,
    /// With the same strips.
    pub sections: Vec<Point>,
}

impl Scaling {
    /// Measures about the trim of the standard flight.
    pub fn measure(aircraft: &Aircraft, model: &Arc<ReducedModel>) -> Result<Self, BenchError> {
        let most = Arc::new(ReducedModel::new(aircraft, ModeCount::Usual(40))?);
        let counts: Vec<usize> = MODES.into_iter().filter(|&count| count <= most.natural_modes()).collect();
        let at_both_levels = counts.len() + PARTS.len();
        let points = 2 * at_both_levels + PARTS.len() + INFLOW_STATES.len() + Fidelity::ALL.len();
        let standard = Settings::of(model).plant;
        let bending = PlantSettings { fidelity: Fidelity::GeometricallyExact, ..standard };
        let family =
            Family { aircraft, model, most: &most, counts, progress: Progress::new(points, "aircraft") };
        Ok(Scaling {
            modes: family.modes(standard)?,
            strips: family.strips(standard)?,
            inflow_states: family.inflow_states(standard)?,
            fidelity: family.levels(standard)?,
            geometrically_exact: GeometricallyExact {
                modes: family.modes(bending)?,
                strips: family.strips(bending)?,
                sections: family.sections(bending)?,
            },
            memory: memory(model)?,
        })
    }
}

/// The aircraft of a benchmark, of which others are made.
struct Family<'a> {
    aircraft: &'a Aircraft,
    model: &'a Arc<ReducedModel>,
    /// With the most modes that fly.
    most: &'a Arc<ReducedModel>,
    /// Numbers of modes that fly.
    counts: Vec<usize>,
    progress: Progress,
}

impl Family<'_> {
    fn modes(&self, settings: PlantSettings) -> Result<Vec<Point>, BenchError> {
        let points = self.counts.iter().map(|&mode_count| {
            let settings = PlantSettings { mode_count, ..settings };
            self.point(self.most, settings, format!("{mode_count} modes"), mode_count)
        });
        points.collect()
    }

    fn strips(&self, settings: PlantSettings) -> Result<Vec<Point>, BenchError> {
        let points = PARTS.into_iter().map(|parts| {
            let model = Arc::new(with_strips_in_parts(self.model, parts));
            let size = model.strips.len();
            self.point(&model, settings, format!("{size} strips"), size)
        });
        points.collect()
    }

    fn sections(&self, settings: PlantSettings) -> Result<Vec<Point>, BenchError> {
        let points = PARTS.into_iter().map(|parts| {
            let aircraft = with_bays_in_parts(self.aircraft, parts);
            let count = ModeCount::Usual(ReducedModel::USUAL_MODES);
            let model = Arc::new(ReducedModel::new(&aircraft, count)?);
            let size = model.sections.len();
            self.point(&model, settings, format!("{size} sections"), size)
        });
        points.collect()
    }

    fn inflow_states(&self, settings: PlantSettings) -> Result<Vec<Point>, BenchError> {
        let points = INFLOW_STATES.into_iter().map(|inflow_states| {
            let settings = PlantSettings { inflow_states, ..settings };
            self.point(self.model, settings, format!("{inflow_states} inflow states"), inflow_states)
        });
        points.collect()
    }

    fn levels(&self, settings: PlantSettings) -> Result<Vec<Point>, BenchError> {
        let points = Fidelity::ALL.into_iter().map(|fidelity| {
            let settings = PlantSettings { fidelity, ..settings };
            let label = format!("{}, {}", fidelity.symbol(), fidelity.in_words());
            self.point(self.model, settings, label, fidelity as usize)
        });
        points.collect()
    }

    fn point(
        &self,
        model: &Arc<ReducedModel>,
        settings: PlantSettings,
        label: String,
        size: usize,
    ) -> Result<Point, BenchError> {
        let measured = point(model, &Settings::from(settings), label, size);
        self.progress.advance();
        measured
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
