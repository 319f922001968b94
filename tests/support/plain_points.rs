//! Points of the structure as the theory writes them, one after the other, from the state alone, by either kind of kinematics.
//!
//! [theory: kinematics.superposition, geometrically-exact.attached]

use flexible_aircraft::aircraft::Fidelity;
use flexible_aircraft::equations::EquationsOfMotion;
use flexible_aircraft::structure::{
    BeamSection, ModeShapes, ReducedEngine, ReducedModel, ReducedStation, ReducedStrip,
};
use nalgebra::{DVectorView, Matrix3, Matrix3xX, Rotation3, Vector3};

use super::plain_sections::{MovingPoint, moving_point};

/// How points of the structure move.
#[derive(Clone, Copy)]
pub enum Moving<'m> {
    /// By sums of mode shapes.
    Superposed,
    /// By sums of strains.
    Exactly(&'m [BeamSection]),
}

impl<'m> Moving<'m> {
    /// At a level of fidelity.
    pub fn at(model: &'m ReducedModel, fidelity: Fidelity) -> Self {
        match fidelity {
            Fidelity::GeometricallyExact => Moving::Exactly(&model.sections),
            _ => Moving::Superposed,
        }
    }
}

/// What is fixed to the structure, where it is undeformed.
#[derive(Clone, Copy)]
pub struct Fixed<'m> {
    position: &'m Vector3<f64>,
    shapes: &'m ModeShapes,
    section: usize,
}

impl<'m> From<&'m ReducedStrip> for Fixed<'m> {
    fn from(strip: &'m ReducedStrip) -> Self {
        Fixed { position: &strip.position, shapes: &strip.shapes, section: strip.section }
    }
}

impl<'m> From<&'m ReducedEngine> for Fixed<'m> {
    fn from(engine: &'m ReducedEngine) -> Self {
        Fixed { position: &engine.position, shapes: &engine.shapes, section: engine.carrier.section }
    }
}

impl<'m> From<&'m ReducedStation> for Fixed<'m> {
    fn from(station: &'m ReducedStation) -> Self {
        Fixed { position: &station.position, shapes: &station.shapes, section: station.carrier.section }
    }
}

/// A point of the structure in a state.
pub struct Point {
    /// How its section is turned.
    pub turn: Matrix3<f64>,
    /// X, m.
    pub place: Vector3<f64>,
    /// Body axes, m/s.
    pub velocity: Vector3<f64>,
    /// ω with the rate that the level gives the section: Ψᵠq̇, or σ; rad/s.
    pub spin: Vector3<f64>,
    /// The true spin of the section relative to the body axes, rad/s.
    pub true_spin: Vector3<f64>,
    /// w, m/s.
    pub relative_velocity: Vector3<f64>,
    /// What remains of ẇ and of the rate of the level's spin at q̈ = 0.
    pub biases: [Vector3<f64>; 2],
}

impl Fixed<'_> {
    /// The point of an aircraft in a state.
    pub fn point(&self, moving: Moving, equations: &EquationsOfMotion, state: &[f64]) -> Point {
        let layout = equations.layout();
        let motion = equations.motion(state);
        let (q, q_dot) = (&state[layout.coordinates()], &state[layout.coordinate_rates()]);
        let own = self.relative(moving, q, q_dot);
        let true_spin = match moving {
            Moving::Superposed => true_spin(&self.rotation(q), &own.spin),
            Moving::Exactly(_) => own.spin,
        };
        Point {
            turn: own.turn,
            place: own.place,
            velocity: motion.velocity + motion.rate.cross(&own.place) + own.velocity,
            spin: motion.rate + own.spin,
            true_spin,
            relative_velocity: own.velocity,
            biases: [own.acceleration, own.angular_acceleration],
        }
    }

    /// J x and S x: what coordinates that change at rates x do to its velocity and to the level's spin.
    pub fn rows_times(&self, moving: Moving, q: &[f64], x: &[f64]) -> [Vector3<f64>; 2] {
        let MovingPoint { velocity, spin, .. } = self.relative(moving, q, x);
        [velocity, spin]
    }

    fn rotation(&self, q: &[f64]) -> Vector3<f64> {
        Matrix3xX::from_row_slice(&self.shapes.rotation) * DVectorView::from_slice(q, q.len())
    }

    /// Relative to the body axes; of superposed displacements the spin is Ψᵠq̇.
    fn relative(&self, moving: Moving, q: &[f64], q_dot: &[f64]) -> MovingPoint {
        match moving {
            Moving::Superposed => {
                let shape = Matrix3xX::from_row_slice(&self.shapes.translation);
                let times = |numbers: &[f64]| &shape * DVectorView::from_slice(numbers, numbers.len());
                MovingPoint {
                    turn: Rotation3::new(self.rotation(q)).into_inner(),
                    place: self.position + times(q),
                    velocity: times(q_dot),
                    spin: self.rotation(q_dot),
                    acceleration: Vector3::zeros(),
                    angular_acceleration: Vector3::zeros(),
                }
            }
            Moving::Exactly(sections) => {
                let offset = self.position - sections[self.section].position;
                moving_point(sections, [q, q_dot], self.section, &offset)
            }
        }
    }
}

/// The spin of a section whose rotation vector is φ and changes at φ̇.
fn true_spin(phi: &Vector3<f64>, phi_dot: &Vector3<f64>) -> Vector3<f64> {
    let angle = phi.norm();
    if angle == 0.0 {
        return *phi_dot;
    }
    let (once, twice) = (phi.cross(phi_dot), phi.cross(&phi.cross(phi_dot)));
    let (sin, cos) = libm::sincos(angle);
    phi_dot + once * ((1.0 - cos) / angle.powi(2)) + twice * ((1.0 - sin / angle) / angle.powi(2))
}
