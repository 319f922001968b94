//! The right-hand side, and the plain method that all gains are compared with: the classical Runge–Kutta method in
//! steps of 1 ms, one strip at a time.

use flexible_aircraft::dynamics::{Controls, EquationsOfMotion, Workspace};
use flexible_aircraft::simulation::Settings;
use flexible_aircraft::structure::ReducedModel;

use super::standard_flight::DURATION;
use super::{BenchError, least_time};
use crate::manoeuvre::Manoeuvre;

/// Evaluations that are timed together.
const EVALUATIONS: usize = 2000;

/// s.
const PLAIN_STEP: f64 = 1e-3;

/// Times of the right-hand side of the standard flight.
pub struct RightHandSide {
    pub strips: usize,
    /// s.
    pub time: f64,
    /// One strip at a time, s.
    pub narrow_time: f64,
    /// The plain method: processor time for a second of flight, s.
    pub plain_time_per_second: f64,
    /// Multiplications that the formulas ask for, see [`multiplications`].
    pub multiplications: usize,
}

impl RightHandSide {
    /// Measures about the trim.
    pub fn measure(model: &ReducedModel) -> Result<Self, BenchError> {
        let settings = Settings::default();
        let equations = settings.equations(model)?;
        let narrow = equations.clone().one_strip_at_a_time();
        Ok(RightHandSide {
            strips: equations.strip_count(),
            time: time_of(&equations, &settings)?,
            narrow_time: time_of(&narrow, &settings)?,
            plain_time_per_second: least_time(1, || fly_plainly(&narrow, &settings))? / DURATION,
            multiplications: multiplications(
                equations.strip_count(),
                settings.mode_count,
                settings.inflow_states,
            ),
        })
    }
}

/// s for one evaluation at the trim.
pub fn time_of(equations: &EquationsOfMotion, settings: &Settings) -> Result<f64, BenchError> {
    let trim = equations
        .trim(&settings.trim_condition())
        .map_err(flexible_aircraft::simulation::SimulationError::from)?;
    let mut controls = Controls::neutral(equations.engine_count());
    controls.elevator = trim.elevator;
    controls.thrust.fill(trim.thrust);
    let (mut rates, mut workspace) = (vec![0.0; trim.state.len()], Workspace::new(equations));
    let time = least_time(20, || {
        for _ in 0..EVALUATIONS {
            equations.rates(std::hint::black_box(&trim.state), &controls, &mut rates, &mut workspace);
        }
        Ok(())
    })?;
    Ok(time / EVALUATIONS as f64)
}

/// The standard flight by the classical Runge–Kutta method.
fn fly_plainly(equations: &EquationsOfMotion, settings: &Settings) -> Result<Vec<f64>, BenchError> {
    let trim = equations
        .trim(&settings.trim_condition())
        .map_err(flexible_aircraft::simulation::SimulationError::from)?;
    let manoeuvre = Manoeuvre::two_three_one_one(-0.05, 0.7, 1.0, 0.05);
    let mut controls = Controls::neutral(equations.engine_count());
    controls.thrust.fill(trim.thrust);
    let mut workspace = Workspace::new(equations);
    let n = trim.state.len();
    let (mut y, mut stage, mut k, mut sum) = (trim.state, vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    for step in 0..(DURATION / PLAIN_STEP) as usize {
        controls.elevator = trim.elevator + manoeuvre.value(0.01 * (step / 10) as f64);
        stage.copy_from_slice(&y);
        sum.fill(0.0);
        for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
            equations.rates(&stage, &controls, &mut k, &mut workspace);
            for i in 0..n {
                sum[i] += weight / 6.0 * k[i];
                stage[i] = y[i] + next * PLAIN_STEP * k[i];
            }
        }
        y.iter_mut().zip(&sum).for_each(|(y, slope)| *y += PLAIN_STEP * slope);
    }
    Ok(y)
}

/// Multiplications of the formulas for one right-hand side, as they are written in `src/dynamics` and
/// `src/structure`: of each strip 12 for every mode's displacement and rotation and their rates, 14 for its row of
/// forces and of apparent mass, 270 for triad, flow and loads, 2 for every inflow state, and 2 for each entry of the upper triangle
/// of the apparent mass; of the aircraft the strain energy's distinct monomials (each in value and gradient), the
/// inertia's tensors, and the solution.
pub fn multiplications(strips: usize, modes: usize, inflow_states: usize) -> usize {
    let size = 6 + modes;
    let strip = 12 * modes + 14 * size + 270 + 2 * inflow_states + size * (size + 1);
    let monomials = modes * (modes + 1) * (modes + 2) * (modes + 7) / 24;
    let inertia = 15 * modes * modes + 60 * modes;
    strips * strip + 2 * monomials + inertia + size * size * size / 6 + 2 * size * size
}
