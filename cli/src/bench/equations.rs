//! The right-hand side, and the plain method that all gains are compared with: the classical Runge–Kutta method in
//! steps of 1 ms, one strip at a time.

use flexible_aircraft::aircraft::TrimRole;
use flexible_aircraft::equations::Controls;
use flexible_aircraft::plant::{Plant, PlantSettings};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::symmetry::Plants;

use crate::manoeuvre::Manoeuvre;

use super::standard_flight::DURATION;
use super::{BenchError, least_time};

/// Evaluations that are timed together.
const EVALUATIONS: usize = 2000;

/// s.
const PLAIN_STEP: f64 = 1e-3;

/// Times of a right-hand side about the trim of the standard flight.
pub struct RightHandSide {
    /// s.
    pub time: f64,
    /// One strip at a time, s.
    pub narrow_time: f64,
    /// Multiplications of numbers in registers, counted.
    pub multiplications: usize,
}

/// What was measured of the equations of motion.
pub struct EquationCosts {
    /// Of half the aircraft, which flies the standard flight.
    pub half: RightHandSide,
    /// Of the whole aircraft, as soon as something acts on one side alone.
    pub whole: RightHandSide,
    /// The plain method: processor time for a second of flight, s.
    pub plain_time_per_second: f64,
    /// How many multiplications, each with an addition, this machine does in a second at its best.
    pub most_multiplications: f64,
}

impl EquationCosts {
    /// Measures about the trim.
    pub fn measure(model: &ReducedModel) -> Result<Self, BenchError> {
        let moved = pitch_control(model)?;
        let settings = PlantSettings::of(model);
        let plants = Plants::under(model, &settings)?;
        let whole = plants.whole();
        let half = plants.half().ok_or_else(|| BenchError::NoMirrorPlane(model.name.clone()))?;
        let narrow = whole.clone().one_strip_at_a_time();
        Ok(EquationCosts {
            half: RightHandSide::measure(half, &settings)?,
            whole: RightHandSide::measure(whole, &settings)?,
            plain_time_per_second: least_time(1, || fly_plainly(&narrow, moved, &settings))? / DURATION,
            most_multiplications: most_multiplications()?,
        })
    }
}

impl RightHandSide {
    fn measure(plant: &Plant, settings: &PlantSettings) -> Result<Self, BenchError> {
        let (state, controls) = trimmed(plant, settings)?;
        Ok(RightHandSide {
            time: time_of(plant, settings)?,
            narrow_time: time_of(&plant.clone().one_strip_at_a_time(), settings)?,
            multiplications: plant.equations().multiplications(&state, &controls),
        })
    }
}

/// The place of the control that the standard flight moves.
pub fn pitch_control(model: &ReducedModel) -> Result<usize, BenchError> {
    model.control_for(TrimRole::Pitch).ok_or_else(|| BenchError::NoPitchControl(model.name.clone()))
}

/// The state of the trimmed flight and its controls.
fn trimmed(plant: &Plant, settings: &PlantSettings) -> Result<(Vec<f64>, Controls), BenchError> {
    let trim = plant.trim(&settings.trim_condition())?;
    Ok((trim.state, trim.controls))
}

/// s for one evaluation at the trim.
pub fn time_of(plant: &Plant, settings: &PlantSettings) -> Result<f64, BenchError> {
    let (state, controls) = trimmed(plant, settings)?;
    let (mut rates, mut workspace) = (vec![0.0; state.len()], plant.workspace());
    let time = least_time(20, || {
        for _ in 0..EVALUATIONS {
            plant.rates(std::hint::black_box(&state), &controls, &mut rates, &mut workspace);
        }
        Ok(())
    })?;
    Ok(time / EVALUATIONS as f64)
}

/// The standard flight by the classical Runge–Kutta method, one control moving.
fn fly_plainly(plant: &Plant, moved: usize, settings: &PlantSettings) -> Result<Vec<f64>, BenchError> {
    let (mut y, mut controls) = trimmed(plant, settings)?;
    let trimmed = controls.angles[moved];
    let manoeuvre = Manoeuvre::two_three_one_one(-0.05, 0.7, 1.0, 0.05);
    let mut workspace = plant.workspace();
    let n = y.len();
    let (mut stage, mut k, mut sum) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    for step in 0..(DURATION / PLAIN_STEP) as usize {
        controls.angles[moved] = trimmed + manoeuvre.value(0.01 * (step / 10) as f64);
        stage.copy_from_slice(&y);
        sum.fill(0.0);
        for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
            plant.rates(&stage, &controls, &mut k, &mut workspace);
            for i in 0..n {
                sum[i] += weight / 6.0 * k[i];
                stage[i] = y[i] + next * PLAIN_STEP * k[i];
            }
        }
        y.iter_mut().zip(&sum).for_each(|(y, slope)| *y += PLAIN_STEP * slope);
    }
    Ok(y)
}

/// Independent chains of multiplications and additions, enough to hide their latency.
const CHAINS: usize = 12;

/// Multiplications, each with an addition that is not fused with it, that this machine does in a second.
fn most_multiplications() -> Result<f64, BenchError> {
    const ROUNDS: usize = 200_000;
    let arch = pulp::Arch::new();
    let mut lanes = 0;
    let time = least_time(20, || {
        lanes = arch.dispatch(Multiply { rounds: ROUNDS });
        Ok(())
    })?;
    Ok((ROUNDS * CHAINS * lanes) as f64 / time)
}

/// x ← x·a + b in every chain; returns how many numbers a register holds.
struct Multiply {
    rounds: usize,
}

impl pulp::WithSimd for Multiply {
    type Output = usize;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, simd: S) -> usize {
        let (factor, term) = (simd.splat_f64s(std::hint::black_box(0.5)), simd.splat_f64s(1.0));
        let mut chains = [simd.splat_f64s(1.0); CHAINS];
        for _ in 0..self.rounds {
            for chain in &mut chains {
                *chain = simd.add_f64s(simd.mul_f64s(*chain, factor), term);
            }
        }
        std::hint::black_box(chains);
        S::F64_LANES
    }
}
