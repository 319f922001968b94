//! The right-hand side, and the plain method that all gains are compared with: the classical Runge–Kutta method in
//! steps of 1 ms, one strip at a time.

use flexible_aircraft::dynamics::{EquationsOfMotion, Workspace};
use flexible_aircraft::simulation::Settings;
use flexible_aircraft::structure::{ModeFamily, ReducedModel, SymmetricHalf};

use super::standard_flight::DURATION;
use super::{BenchError, least_time};
use crate::manoeuvre::Manoeuvre;

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
    /// Multiplications that the formulas ask for.
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
        let settings = Settings::of(model);
        let whole = settings.equations(model)?;
        let half = settings.symmetric_equations(model)?.ok_or(BenchError::NoMirrorPlane)?;
        let narrow = whole.clone().one_strip_at_a_time();
        let reduced = model.select(&settings.choose_modes(model)?);
        let count = |families: &[ModeFamily]| {
            let modes = reduced.modes.iter().filter(|mode| families.contains(&mode.family));
            modes.count()
        };
        let (symmetric, antisymmetric) =
            (count(&[ModeFamily::Symmetric]), count(&[ModeFamily::Antisymmetric]));
        let symmetric_half = SymmetricHalf::find(&reduced);
        let [in_plane, edge_on] = symmetric_half.map_or([0; 2], |half| {
            [half.model.strips.iter().filter(|strip| strip.stays_in_plane()).count(), half.edge_on.len()]
        });
        let size =
            |equations: &EquationsOfMotion, [in_plane, edge_on]: [usize; 2], rigid, antisymmetric| Size {
                strips: equations.strip_count() - in_plane,
                in_plane,
                edge_on,
                rigid,
                symmetric,
                antisymmetric,
                inflow_states: settings.inflow_states,
            };
        Ok(EquationCosts {
            half: RightHandSide::measure(&half, &settings, &size(&half, [in_plane, edge_on], 3, 0))?,
            whole: RightHandSide::measure(&whole, &settings, &size(&whole, [0; 2], 6, antisymmetric))?,
            plain_time_per_second: least_time(1, || fly_plainly(&narrow, &settings))? / DURATION,
            most_multiplications: most_multiplications()?,
        })
    }
}

impl RightHandSide {
    fn measure(equations: &EquationsOfMotion, settings: &Settings, size: &Size) -> Result<Self, BenchError> {
        Ok(RightHandSide {
            time: time_of(equations, settings)?,
            narrow_time: time_of(&equations.clone().one_strip_at_a_time(), settings)?,
            multiplications: multiplications(size),
        })
    }
}

/// s for one evaluation at the trim.
pub fn time_of(equations: &EquationsOfMotion, settings: &Settings) -> Result<f64, BenchError> {
    let trim = equations
        .trim(&settings.trim_condition())
        .map_err(flexible_aircraft::simulation::SimulationError::from)?;
    let controls = trim.controls(equations.engine_count());
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
    let mut controls = trim.controls(equations.engine_count());
    let mut workspace = Workspace::new(equations);
    let n = trim.state.len();
    let (mut y, mut stage, mut k, mut sum) = (trim.state, vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    for step in 0..(DURATION / PLAIN_STEP) as usize {
        controls.elevator = trim.point.elevator + manoeuvre.value(0.01 * (step / 10) as f64);
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

/// What decides how many multiplications a right-hand side takes.
pub struct Size {
    /// In space.
    pub strips: usize,
    /// Lifting ones in the mirror plane while motion is in it.
    pub in_plane: usize,
    pub edge_on: usize,
    /// Components of v and ω that move.
    pub rigid: usize,
    pub symmetric: usize,
    pub antisymmetric: usize,
    pub inflow_states: usize,
}

/// Multiplications of the formulas for one right-hand side, as they are written in `src/dynamics` and `src/structure`,
/// with zero-lift lines along the chords. Of each strip 12 for every mode's displacement and rotation and their rates,
/// 12 for its rows of forces and of apparent mass, 3 for those of each rigid component, 4 for moments about each axis, 184
/// for triad, flow, loads and resultants; in the mirror plane 6, 8, 3, 4 and 91. Of both, 4 for every inflow state, and 2
/// for each entry of the upper triangle of the apparent mass, 1 where translations turn nothing. Of each strip edge-on 7
/// for every mode and 33. Of the aircraft: the products of constant matrices with [q; p], where symmetry leaves half of the
/// entries, and what makes vectors of them; the inertia's tensors about the axes that turn; the solution.
pub fn multiplications(size: &Size) -> usize {
    let Size { strips, in_plane, edge_on, rigid, symmetric, antisymmetric, inflow_states } = *size;
    let (modes, axes) = (symmetric + antisymmetric, rigid / 3 * 2 - 1);
    let (unknowns, translations) = (rigid + modes, rigid - axes);
    let without_turn = translations * unknowns - translations * (translations - 1) / 2;
    let either = 3 * rigid + 4 * axes + 4 * inflow_states + unknowns * (unknowns + 1) - without_turn;
    let (strip, strip_in_plane) = (24 * modes + 184 + either, 14 * modes + 91 + either);
    let pairs = |n: usize| n * (n + 1) / 2;
    let (even, odd) = (pairs(symmetric) + pairs(antisymmetric), symmetric * antisymmetric);
    let linear = symmetric * symmetric + antisymmetric * antisymmetric;
    let elastic =
        linear + symmetric * even + antisymmetric * odd + even * even + odd * odd + 3 * (even + odd);
    let inertia = axes * (2 + axes) * modes * modes + 30 * modes;
    let solution = unknowns * unknowns * unknowns / 6 + unknowns * unknowns;
    strips * strip + in_plane * strip_in_plane + edge_on * (7 * modes + 33) + elastic + inertia + solution
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
