//! A single section, displaced and turned by superposition.

use nalgebra::{Matrix3, Vector3};
use pulp::Scalar;

use crate::math::{LaneVector, Rotation};
use crate::structure::ModeShapes;

use super::super::kind::Coordinates;
use super::super::sections::{Carried, CarriesMass, Pose, Section};

/// A section and the mode shapes there.
#[derive(Clone, Debug)]
pub struct LinearSection {
    at_rest: Vector3<f64>,
    shapes: ModeShapes,
}

/// A section at an instant.
#[derive(Clone, Copy, Debug)]
pub struct SuperposedSection<'a> {
    section: &'a LinearSection,
    q_dot: &'a [f64],
    /// Ψᵘq.
    displacement: Vector3<f64>,
    /// φ = Ψᵠq.
    rotation: Vector3<f64>,
    /// exp(φ×).
    turn: Rotation<Scalar>,
}

impl LinearSection {
    /// At a place of the undeformed aircraft.
    pub fn new(at_rest: Vector3<f64>, shapes: ModeShapes) -> Self {
        LinearSection { at_rest, shapes }
    }

    /// At some q and q̇.
    pub fn at<'a>(&'a self, Coordinates { q, q_dot }: Coordinates<'a>) -> SuperposedSection<'a> {
        let rotation = combine(self.shapes.rotation_rows(), q);
        SuperposedSection {
            section: self,
            q_dot,
            displacement: combine(self.shapes.translation_rows(), q),
            rotation,
            turn: Rotation::new(LaneVector::single(&rotation)),
        }
    }
}

impl Section for SuperposedSection<'_> {
    fn displacement(&self) -> Vector3<f64> {
        self.displacement
    }

    fn at_rest(&self) -> Vector3<f64> {
        self.section.at_rest
    }

    fn velocity(&self) -> Vector3<f64> {
        combine(self.section.shapes.translation_rows(), self.q_dot)
    }

    fn acceleration(&self, q_ddot: &[f64]) -> Vector3<f64> {
        combine(self.section.shapes.translation_rows(), q_ddot)
    }

    fn angular_velocity(&self, body_rate: &Vector3<f64>) -> Vector3<f64> {
        let rate = LaneVector::single(&combine(self.section.shapes.rotation_rows(), self.q_dot));
        (LaneVector::single(body_rate) + rate + self.turn.excess_spin(&rate)).vector()
    }

    fn turned(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        self.turn.apply(&LaneVector::single(vector)).vector()
    }

    fn turned_back(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        self.turn.apply_inverse(&LaneVector::single(vector)).vector()
    }

    fn twist(&self, axis: &Vector3<f64>) -> f64 {
        axis.dot(&self.rotation)
    }

    fn write_generalised_force(&self, force: &Vector3<f64>, generalised: &mut [f64]) {
        let rows = self.section.shapes.translation_rows();
        for (mode, generalised) in generalised.iter_mut().enumerate() {
            *generalised = (0..3).map(|i| rows[i][mode] * force[i]).sum();
        }
    }

    /// σ = Tφ̇: what a moment does on φ̇ is Tᵀ times it, and Tᵀ belongs to −φ.
    fn add_generalised_load(&self, force: &Vector3<f64>, moment: &Vector3<f64>, generalised: &mut [f64]) {
        let back = Rotation::new(LaneVector::single(&-self.rotation));
        let moment = moment + back.excess_spin(&LaneVector::single(moment)).vector();
        for (mode, generalised) in generalised.iter_mut().enumerate() {
            let [displacement, turn] = self.section.shapes.of_mode(mode);
            *generalised += displacement.dot(force) + turn.dot(&moment);
        }
    }
}

/// Particles are displaced and do not turn: o by o + φ×o [theory: kinematics.superposition].
impl CarriesMass for SuperposedSection<'_> {
    fn carried(&self, q_ddot: &[f64]) -> Carried {
        let rows = self.section.shapes.rotation_rows();
        Carried {
            now: Matrix3::identity() + self.rotation.cross_matrix(),
            rate: combine(rows, self.q_dot).cross_matrix(),
            acceleration: combine(rows, q_ddot).cross_matrix(),
        }
    }
}

impl SuperposedSection<'_> {
    /// Where it is and how it is turned.
    pub fn pose(&self) -> Pose {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let turn = Matrix3::from_columns(&axes.map(|axis| self.turned(&axis)));
        Pose { position: self.section.at_rest + self.displacement, turn }
    }
}

/// Three rows times q.
fn combine([x, y, z]: [&[f64]; 3], q: &[f64]) -> Vector3<f64> {
    let mut sum = Vector3::zeros();
    for (((x, y), z), q) in x.iter().zip(y).zip(z).zip(q) {
        sum += Vector3::new(*x, *y, *z) * *q;
    }
    sum
}
