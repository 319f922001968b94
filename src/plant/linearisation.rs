//! The equations of motion linearised at a trim: ẋ = A x for small departures from steady flight.
//!
//! [theory: linearisation.state-matrix, linearisation.differences]
//!
//! The derivatives are central differences of fourth order. Their steps are a thousandth of what each unknown
//! is measured by, where the truncation error (∝ step⁴) and rounding (∝ 1/step) are both near 1e-12 of an
//! entry; strain energy and inertia are polynomials of q for which the formula is exact.
//!
//! **Which unknowns.** Nothing depends on position north and east or on heading: they would only add zero
//! eigenvalues, and are left out unless they are asked for. Height stays, for the air thins with it. Roll and pitch angle stand for the
//! attitude, since the length of a quaternion is no motion. What support or symmetry hold of the rigid motion is no unknown:
//! of half an aircraft height, pitch angle and motion in the plane remain, of a clamped one only q, q̇ and the inflow.
//!
//! [theory: linearisation.unknowns, symmetry.freedom]

use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Complex, DMatrix, Schur, Vector3};

use crate::kinematics::RigidFreedom;
use crate::math::{Attitude, derivative, euler_angle_rates, quaternion_of_euler_angles};

use super::system::Plant;
use super::trim::Trim;

/// Step of the differences, as a share of the magnitude of the unknown.
const STEP: f64 = 1e-3;

/// The height over which the air changes noticeably, m.
const ATMOSPHERIC_HEIGHT: f64 = 1e3;

/// Airspeed that velocities are measured by at least, m/s: a wind tunnel may be off.
const SLOWEST: f64 = 1.0;

/// Relative size at which the eigensolver drops a subdiagonal entry, and larger ones where it does not come to an
/// end: where many strips are alike, nalgebra's iteration does not at the machine's rounding (2.2e-16).
const DEFLATIONS: [f64; 4] = [1e-13, 1e-12, 1e-11, 1e-10];

/// Cap on the iterations of the eigensolver, per unknown.
const MAX_ITERATIONS: usize = 30;

/// Which unknowns of the rigid motion there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UnknownsKept {
    /// Those on which something depends.
    Felt,
    /// Horizontal position and yaw angle too.
    All,
}

/// An unknown of the linearised motion: a departure from the trim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Unknown {
    /// Position along the course (0) or to its right (1), m.
    Horizontal(usize),
    /// Position down, m.
    Down,
    /// Roll angle, rad.
    Roll,
    /// Pitch angle, rad.
    Pitch,
    /// Yaw angle from the course, rad.
    Yaw,
    /// A component of v along body axis 0 (x), 1 (y) or 2 (z), m/s.
    Velocity(usize),
    /// A component of ω about body axis 0, 1 or 2, rad/s.
    Rate(usize),
    /// q of a mode.
    Coordinate(usize),
    /// q̇ of a mode.
    CoordinateRate(usize),
    /// An inflow state of a strip, m/s.
    Inflow {
        /// Index of the strip.
        strip: usize,
        /// Its place in the vector of the flight's states.
        place: usize,
    },
}

/// A of ẋ = A x.
///
/// ```
/// use flexible_aircraft::plant::{Plant, PlantSettings};
/// use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let wing = ReducedModel::new(&Aircraft::read("aircraft/goland-wing.toml")?, 2)?;
/// let is_stable = |airspeed: f64| -> Result<bool, Box<dyn std::error::Error>> {
///     let settings = PlantSettings { airspeed, inflow_states: 4, ..PlantSettings::of(&wing) };
///     let plant = Plant::under(&wing, &settings)?;
///     let trim = plant.trim(&settings.trim_condition())?;
///     let eigenvalues = plant.linearise(&trim).eigenvalues()?; // 1/s
///     Ok(eigenvalues.iter().all(|eigenvalue| eigenvalue.re < 1e-6))
/// };
/// assert!(is_stable(120.0)? && !is_stable(150.0)?); // m/s; it flutters at 137
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StateMatrix {
    /// The unknown of each row and column: rigid motion, q, q̇, then the inflow strip by strip, the real and
    /// the imaginary part of a complex state side by side.
    pub unknowns: Vec<Unknown>,
    /// A: row by row the rate of an unknown, SI units.
    pub matrix: DMatrix<f64>,
}

/// The eigenvalues of a state matrix did not converge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the eigenvalues of the linearised motion did not converge")]
pub struct EigenvaluesNotFound;

impl StateMatrix {
    /// All eigenvalues, 1/s, in no particular order [theory: linearisation.eigenvalues].
    ///
    /// # Errors
    /// When the iteration does not converge.
    pub fn eigenvalues(&self) -> Result<Vec<Complex<f64>>, EigenvaluesNotFound> {
        eigenvalues(&self.matrix)
    }
}

/// All eigenvalues of a square matrix, 1/s.
///
/// # Errors
/// When the iteration does not converge.
pub(crate) fn eigenvalues(matrix: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, EigenvaluesNotFound> {
    if matrix.is_empty() {
        return Ok(Vec::new());
    }
    let cap = MAX_ITERATIONS * matrix.nrows();
    let mut balanced = matrix.clone();
    balance_parlett_reinsch(&mut balanced);
    let schur = |deflation| Schur::try_new(balanced.clone(), deflation, cap);
    let schur = DEFLATIONS.into_iter().find_map(schur).ok_or(EigenvaluesNotFound)?;
    Ok(schur.complex_eigenvalues().iter().copied().collect())
}

/// The derivatives of so many numbers by departures, a column for each step, from their values at a departure of a column.
pub(super) fn derivatives(
    rows: usize,
    steps: &[f64],
    mut values: impl FnMut(usize, f64) -> Vec<f64>,
) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(rows, steps.len());
    for (place, (mut column, &step)) in matrix.column_iter_mut().zip(steps).enumerate() {
        let around = [-2.0, -1.0, 1.0, 2.0].map(|steps| values(place, steps * step));
        for (row, entry) in column.iter_mut().enumerate() {
            *entry = derivative(around.each_ref().map(|values| values[row]), step);
        }
    }
    matrix
}

impl Plant {
    /// Linearises the motion about a trim of this plant, controls and thrust held. Allocates.
    pub fn linearise(&self, trim: &Trim) -> StateMatrix {
        let unknowns = self.unknowns(UnknownsKept::Felt);
        let mut workspace = self.workspace();
        let mut rates = vec![0.0; trim.state.len()];
        let matrix = derivatives(unknowns.len(), &self.steps(&unknowns, trim), |column, departure| {
            let mut state = trim.state.clone();
            self.displace(unknowns[column], departure, &mut state);
            self.rates(&state, &trim.controls, &mut rates, &mut workspace);
            unknowns.iter().map(|&row| self.rate_of(row, &state, &rates)).collect()
        });
        StateMatrix { unknowns, matrix }
    }

    /// What moves.
    pub(crate) fn unknowns(&self, kept: UnknownsKept) -> Vec<Unknown> {
        let layout = self.layout();
        let freedom = self.equations.freedom;
        let [translations, rotations] = freedom.motions();
        let all = kept == UnknownsKept::All;
        let horizontal =
            translations.iter().copied().filter(|&axis| all && axis < 2).map(Unknown::Horizontal);
        // Height goes with what is not held at all.
        let down = (freedom != RigidFreedom::Held).then_some(Unknown::Down);
        let yaw = all.then_some(Unknown::Yaw);
        let tilt = |&axis: &usize| [Some(Unknown::Roll), Some(Unknown::Pitch), yaw][axis];
        let rigid = horizontal
            .chain(down)
            .chain(rotations.iter().filter_map(tilt))
            .chain(translations.iter().copied().map(Unknown::Velocity))
            .chain(rotations.iter().copied().map(Unknown::Rate));
        let inflow = (0..self.equations.strip_count()).flat_map(|strip| {
            layout
                .inflow_layout()
                .of_strip(strip)
                .into_iter()
                .map(move |place| Unknown::Inflow { strip, place })
        });
        rigid
            .chain((0..layout.modes()).map(Unknown::Coordinate))
            .chain((0..layout.modes()).map(Unknown::CoordinateRate))
            .chain(inflow)
            .collect()
    }

    /// Steps of the differences by some unknowns.
    pub(super) fn steps(&self, unknowns: &[Unknown], trim: &Trim) -> Vec<f64> {
        let airspeed = self.speed_at(trim);
        unknowns.iter().map(|&unknown| self.step(unknown, airspeed)).collect()
    }

    /// Step of the differences by an unknown at an airspeed (m/s).
    pub(crate) fn step(&self, unknown: Unknown, airspeed: f64) -> f64 {
        STEP * self.magnitude(unknown, airspeed)
    }

    /// What velocities at a trim are measured by, m/s.
    pub(crate) fn speed_at(&self, trim: &Trim) -> f64 {
        self.airspeed(&trim.state, &trim.controls).max(SLOWEST)
    }

    /// What an unknown is measured by: the airspeed, 1 rad, 1 rad/s, a deflection of some strip by 1 m or 1 rad.
    fn magnitude(&self, unknown: Unknown, airspeed: f64) -> f64 {
        match unknown {
            Unknown::Horizontal(_) | Unknown::Down => ATMOSPHERIC_HEIGHT,
            Unknown::Roll | Unknown::Pitch | Unknown::Yaw | Unknown::Rate(_) => 1.0,
            Unknown::Velocity(_) | Unknown::Inflow { .. } => airspeed,
            Unknown::Coordinate(_) => self.equations.coordinate_magnitude(),
            Unknown::CoordinateRate(_) => airspeed * self.equations.coordinate_magnitude(),
        }
    }

    /// Adds a departure to one unknown of a state.
    pub fn displace(&self, unknown: Unknown, departure: f64, state: &mut [f64]) {
        let layout = self.layout();
        let mut turn = |axis: usize| {
            let mut angles = Attitude::from_quaternion(&state[layout.attitude()]).euler_angles();
            angles[axis] += departure;
            state[layout.attitude()].copy_from_slice(&quaternion_of_euler_angles(&angles));
        };
        match unknown {
            Unknown::Roll => turn(0),
            Unknown::Pitch => turn(1),
            Unknown::Yaw => turn(2),
            Unknown::Horizontal(axis) => state[layout.position().start + axis] += departure,
            Unknown::Down => state[layout.position().end - 1] += departure,
            Unknown::Velocity(axis) => state[layout.velocity().start + axis] += departure,
            Unknown::Rate(axis) => state[layout.rate().start + axis] += departure,
            Unknown::Coordinate(mode) => state[layout.coordinates().start + mode] += departure,
            Unknown::CoordinateRate(mode) => state[layout.coordinate_rates().start + mode] += departure,
            Unknown::Inflow { place, .. } => state[place] += departure,
        }
    }

    /// The value of an unknown in a state.
    pub(super) fn value_of(&self, unknown: Unknown, state: &[f64]) -> f64 {
        let layout = self.layout();
        let angles = || Attitude::from_quaternion(&state[layout.attitude()]).euler_angles();
        match unknown {
            Unknown::Roll => angles().x,
            Unknown::Pitch => angles().y,
            Unknown::Yaw => angles().z,
            Unknown::Horizontal(axis) => state[layout.position().start + axis],
            Unknown::Down => state[layout.position().end - 1],
            Unknown::Velocity(axis) => state[layout.velocity().start + axis],
            Unknown::Rate(axis) => state[layout.rate().start + axis],
            Unknown::Coordinate(mode) => state[layout.coordinates().start + mode],
            Unknown::CoordinateRate(mode) => state[layout.coordinate_rates().start + mode],
            Unknown::Inflow { place, .. } => state[place],
        }
    }

    /// The rate of an unknown at a state with these rates.
    pub(super) fn rate_of(&self, unknown: Unknown, state: &[f64], rates: &[f64]) -> f64 {
        match unknown {
            Unknown::Roll => self.angle_rates(state)[0],
            Unknown::Pitch => self.angle_rates(state)[1],
            Unknown::Yaw => self.angle_rates(state)[2],
            // Rates have the layout of the state.
            other => self.value_of(other, rates),
        }
    }

    /// Rates of roll, pitch and yaw angle, rad/s.
    fn angle_rates(&self, state: &[f64]) -> Vector3<f64> {
        let angles = Attitude::from_quaternion(&state[self.layout().attitude()]).euler_angles();
        euler_angle_rates(&angles, &self.equations.motion(state).rate)
    }
}
