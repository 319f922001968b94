//! Static stability in pitch: how lift and moment answer a change of the angle of attack when everything elastic has come to
//! rest; from them the static margin and the neutral point [theory: linearisation.static-margin].

use nalgebra::{DMatrix, DVector, Vector3, Vector6};

use crate::aircraft::Support;
use crate::equations::Workspace;
use crate::kinematics::RigidFreedom;

use super::linearisation::{StateMatrix, Unknown};
use super::system::Plant;
use super::trim::Trim;

/// How lift and moment change with the angle of attack at a constant airspeed, structure and wake at rest.
///
/// ```
/// # use flexible_aircraft::Aircraft;
/// # use flexible_aircraft::plant::{Plant, PlantSettings};
/// let aircraft = Aircraft::read("aircraft/generic-business-jet.toml")?;
/// let jet = aircraft.reduce()?;
/// let settings = PlantSettings::of(&jet);
/// let plant = Plant::under(&jet, &settings)?;
/// let stability = plant.static_stability(&plant.trim(&settings.trim_condition())?)?;
/// let chord = aircraft.reference_lengths().ok_or("the jet has strips")?.chord; // m
/// assert!((stability.margin(chord) - 0.1029).abs() < 1e-4);
/// assert!(stability.neutral_point() < stability.centre_of_mass.x); // x is forward
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticStability {
    /// dL/dα across the path, N/rad.
    pub lift_slope: f64,
    /// dM/dα about the centre of mass, nose-up, N·m/rad.
    pub moment_slope: f64,
    /// Of the deformed aircraft in its trim, body axes, m.
    pub centre_of_mass: Vector3<f64>,
    /// ½ρV² of the trim, Pa.
    pub dynamic_pressure: f64,
}

/// Why there is no static stability to speak of.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum NoStaticStability {
    /// Nothing can turn.
    #[error("the aircraft is clamped")]
    Clamped,
    /// In a turn or a pull-up.
    #[error("the path bends, and a static margin is that of a straight flight")]
    CurvedPath,
    /// Structure and wake find no rest, as where the air comes from behind or the wing is about to diverge.
    #[error("structure and wake find no rest beside the trim")]
    Restless,
    /// A greater angle of attack gives no more lift, as where a soft wing gives way.
    #[error(
        "the lift changes by {lift_slope:.5e} N per rad of the angle of attack, and a static margin needs more than 0"
    )]
    Liftless {
        /// dL/dα, N/rad.
        lift_slope: f64,
    },
}

impl StaticStability {
    /// K = −dM/dL in parts of a chord, m: positive where the aircraft turns back.
    pub fn margin(&self, chord: f64) -> f64 {
        -self.moment_slope / self.lift_slope / chord
    }

    /// Body x of the neutral point, m, forward of O: the place of a centre of mass about which the moment would not change.
    pub fn neutral_point(&self) -> f64 {
        self.centre_of_mass.x + self.moment_slope / self.lift_slope
    }

    /// dC_L/dα on a reference area, m², 1/rad.
    pub fn lift_slope_coefficient(&self, area: f64) -> f64 {
        self.lift_slope / (self.dynamic_pressure * area)
    }
}

impl Plant {
    /// Static stability in pitch of a straight flight in its trim. Allocates.
    ///
    /// # Errors
    /// When there is none to speak of.
    pub fn static_stability(&self, trim: &Trim) -> Result<StaticStability, NoStaticStability> {
        if self.support() == Support::Clamped {
            return Err(NoStaticStability::Clamped);
        }
        if trim.point.turn_rate != 0.0 || trim.point.pitch_rate != 0.0 {
            return Err(NoStaticStability::CurvedPath);
        }
        let (sin, cos) = libm::sincos(trim.point.angle_of_attack());
        let departure = Vector3::new(-sin, 0.0, cos) * (self.speed_at(trim) * libm::cos(trim.point.sideslip));
        let accelerations =
            accelerations(&self.linearise(trim), departure).ok_or(NoStaticStability::Restless)?;
        let mut workspace = Workspace::new(&self.equations);
        let moving = self.equations.mass_matrix(&trim.state, &trim.controls, &mut workspace);
        let [force, about_origin] = forces(&moving, self.equations.freedom, &accelerations);
        let mass = self.equations.exact_mass_matrix(&trim.state);
        // m c× is the lower left block. Half an aircraft may know its sections on the right alone: what is across the plane cancels.
        let across = if self.equations.freedom == RigidFreedom::InPlane { 0.0 } else { mass[(3, 2)] };
        let centre_of_mass = Vector3::new(mass[(5, 1)], across, mass[(4, 0)]) / mass[(0, 0)];
        let moment = about_origin - centre_of_mass.cross(&force);
        let lift_slope = force.dot(&Vector3::new(sin, 0.0, -cos));
        if !(lift_slope.is_normal() && lift_slope > 0.0) {
            return Err(NoStaticStability::Liftless { lift_slope });
        }
        let dynamic_pressure = self.air_data(&trim.state, &trim.controls).dynamic_pressure;
        Ok(StaticStability { lift_slope, moment_slope: moment.y, centre_of_mass, dynamic_pressure })
    }
}

/// Force and moment about O that give the rigid motion these accelerations, q̈ being 0, by the mass matrix of what moves.
fn forces(moving: &DMatrix<f64>, freedom: RigidFreedom, accelerations: &Vector6<f64>) -> [Vector3<f64>; 2] {
    let components = freedom.components();
    let mut forces = Vector6::zeros();
    for (row, &component) in components.iter().enumerate() {
        let along = components
            .iter()
            .enumerate()
            .map(|(column, &other)| moving[(row, column)] * accelerations[other]);
        forces[component] = along.sum();
    }
    [forces.fixed_rows::<3>(0).into_owned(), forces.fixed_rows::<3>(3).into_owned()]
}

/// [v̇; ω̇] after a departure of v, with q̇ = q̈ = 0 and without inflow.
fn accelerations(state_matrix: &StateMatrix, departure: Vector3<f64>) -> Option<Vector6<f64>> {
    let StateMatrix { unknowns, matrix } = state_matrix.without_inflow()?;
    let places = |is_one: fn(&Unknown) -> bool| -> Vec<usize> {
        (0..unknowns.len()).filter(|&place| is_one(&unknowns[place])).collect()
    };
    let rigid = places(|unknown| matches!(unknown, Unknown::Velocity(_) | Unknown::Rate(_)));
    let coordinates = places(|unknown| matches!(unknown, Unknown::Coordinate(_)));
    let accelerated = places(|unknown| matches!(unknown, Unknown::CoordinateRate(_)));
    let part = |rows: &[usize], columns: &[usize]| matrix.select_rows(rows).select_columns(columns);
    let departures = DVector::from_iterator(
        rigid.len(),
        rigid.iter().map(|&place| match unknowns[place] {
            Unknown::Velocity(axis) => departure[axis],
            _ => 0.0,
        }),
    );
    let mut found = part(&rigid, &rigid) * &departures;
    if !coordinates.is_empty() {
        // 0 = q̈ = A_q q + A_v dv.
        let forced = part(&accelerated, &rigid) * departures;
        let deflected = part(&accelerated, &coordinates).lu().solve(&-forced)?;
        found += part(&rigid, &coordinates) * deflected;
    }
    let mut rates = Vector6::zeros();
    for (place, rate) in rigid.iter().zip(&found) {
        match unknowns[*place] {
            Unknown::Velocity(axis) => rates[axis] = *rate,
            Unknown::Rate(axis) => rates[3 + axis] = *rate,
            _ => {}
        }
    }
    rates.iter().all(|rate| rate.is_finite()).then_some(rates)
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::*;

    /// ẋ = A x of a velocity, a coordinate, its rate and a wake of two states on one strip.
    fn small() -> StateMatrix {
        let unknowns = vec![
            Unknown::Velocity(2),
            Unknown::Coordinate(0),
            Unknown::CoordinateRate(0),
            Unknown::Inflow { strip: 0, place: 3 },
            Unknown::Inflow { strip: 0, place: 4 },
        ];
        // The wake's rate is D (η + G x), G = (0.5, −0.25) for the velocity, (2, 1) for the coordinate.
        let own = nalgebra::Matrix2::new(-3.0, 1.0, -1.0, -3.0);
        let forcing = nalgebra::Matrix2::new(0.5, 2.0, -0.25, 1.0);
        let mut matrix = DMatrix::from_row_slice(
            5,
            5,
            &[
                -1.0, 0.5, 0.1, 0.3, 0.2, //
                0.0, 0.0, 1.0, 0.0, 0.0, //
                0.7, -9.0, -0.2, 0.4, -0.6, //
                0.0, 0.0, 0.0, 0.0, 0.0, //
                0.0, 0.0, 0.0, 0.0, 0.0,
            ],
        );
        matrix.fixed_view_mut::<2, 2>(3, 3).copy_from(&own);
        matrix.fixed_view_mut::<2, 2>(3, 0).copy_from(&(own * forcing));
        StateMatrix { unknowns, matrix }
    }

    #[test]
    fn structure_and_wake_rest_in_the_accelerations_that_are_found() {
        let found = accelerations(&small(), Vector3::z() * 2.0).unwrap();
        assert_eq!(found, Vector6::z() * found.z);
        // Anew, with all equations side by side: unknown are v̇, q, η; q̈ = 0, η̇ = 0.
        let StateMatrix { matrix: a, .. } = small();
        let all = DMatrix::from_row_slice(
            4,
            4,
            &[
                1.0,
                -a[(0, 1)],
                -a[(0, 3)],
                -a[(0, 4)], //
                0.0,
                -a[(2, 1)],
                -a[(2, 3)],
                -a[(2, 4)], //
                0.0,
                a[(3, 1)],
                a[(3, 3)],
                a[(3, 4)], //
                0.0,
                a[(4, 1)],
                a[(4, 3)],
                a[(4, 4)],
            ],
        );
        let right = DVector::from_column_slice(&[a[(0, 0)], a[(2, 0)], -a[(3, 0)], -a[(4, 0)]]) * 2.0;
        let expected = all.lu().solve(&right).unwrap()[0];
        assert!((found.z / expected - 1.0).abs() < 1e-13, "{} {expected}", found.z);
    }

    #[test]
    fn a_wake_that_does_not_move_on_finds_no_rest() {
        let mut still = small();
        still.matrix.rows_mut(3, 2).fill(0.0);
        assert_eq!(accelerations(&still, Vector3::z()), None);
    }

    #[test]
    fn margin_and_neutral_point_are_the_same_distance() {
        let stability = StaticStability {
            lift_slope: 2e6,
            moment_slope: -1e6,
            centre_of_mass: Vector3::new(0.3, 0.0, 0.1),
            dynamic_pressure: 5000.0,
        };
        assert_eq!(stability.margin(2.5), 0.2);
        assert_eq!(stability.neutral_point(), -0.2);
        assert_eq!(stability.lift_slope_coefficient(80.0), 5.0);
    }
}
