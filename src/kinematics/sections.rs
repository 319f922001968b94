//! What hangs on the deformed aircraft asks of its sections [theory: kinematics.sections, kinematics.rows; thesis eq. 2.1].
//!
//! Strips, engines, stations are attached to sections and read there where they are (X), how the section is turned from where it
//! was undeformed, and how it moves: its velocity w and spin σ relative to the body axes, and the rows J and S on q̇ by which
//! w = J q̇ and the section turns at the rate S q̇. All in body axes. How this follows from q and q̇ is a kind of kinematics; who
//! reads it does not know which, and pays for none but the one at hand: the rows may be constants or have been written for the
//! instant, biases may be absent.
//!
//! In exact kinematics S q̇ is σ. The thesis' superposition keeps S = Ψᵠ while its sections turn by exp((Ψᵠq)×).

use nalgebra::{Matrix3, Vector3};

use crate::math::{Arithmetic, Eight, LaneVector, Lanes, PlaneRotation, PlaneVector, Rotation, Window};

/// All sections of an aircraft at an instant.
pub trait Sections {
    /// Those of a group of strips.
    fn of_strips(&self, group: usize) -> impl SectionsInSpace + SectionsInPlane;

    /// Those of a group of strips that flow in the mirror plane meets edge-on.
    fn edge_on(&self, group: usize) -> impl SectionsInPlane;

    /// Those of the engines.
    fn engines(&self) -> impl Iterator<Item = impl Section>;

    /// Those of the stations.
    fn stations(&self) -> impl Iterator<Item = impl Section>;

    /// Those of the masses.
    fn masses(&self) -> impl Iterator<Item = impl CarriesMass>;

    /// Where the cuts are, at the q of the instant.
    fn cuts(&self, q: &[f64]) -> impl Iterator<Item = Pose>;

    /// How far each strip's section is from where it is on the undeformed aircraft, without those edge-on, m.
    fn strip_displacements(&self) -> impl Iterator<Item = Vector3<f64>>;
}

/// Eight sections side by side.
pub trait SectionsInSpace {
    /// How they turn vectors.
    type Turn<S: Arithmetic>: Turn<LaneVector<S>>;

    /// X on the undeformed aircraft.
    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> LaneVector<S>;

    /// Where they are and how they move.
    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<LaneVector<S>, LaneVector<S>, Self::Turn<S>>;

    /// J_x, J_y, J_z, S_x, S_y, S_z of the generalised coordinates that move them, each with what is its own of `all` coordinates.
    fn rows<T>(&self, all: impl Iterator<Item = T>) -> impl Iterator<Item = (&[Eight; 6], T)>;
}

/// Eight sections side by side that stay in the mirror plane: vectors have x and z components, turns are about y.
pub trait SectionsInPlane {
    /// How they turn vectors.
    type Turn<S: Arithmetic>: Turn<PlaneVector<S>>;

    /// X on the undeformed aircraft.
    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> PlaneVector<S>;

    /// Where they are and how they move.
    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<PlaneVector<S>, Lanes<S>, Self::Turn<S>>;

    /// J_x, J_z, S_y of the generalised coordinates that move them, each with what is its own of `all` coordinates.
    fn rows<T>(&self, all: impl Iterator<Item = T>) -> impl Iterator<Item = ([&Eight; 3], T)>;
}

/// A single section.
pub trait Section {
    /// From where it is on the undeformed aircraft, m.
    fn displacement(&self) -> Vector3<f64>;

    /// X on the undeformed aircraft, m.
    fn at_rest(&self) -> Vector3<f64>;

    /// w, m/s.
    fn velocity(&self) -> Vector3<f64>;

    /// ẇ under given q̈, m/s².
    fn acceleration(&self, q_ddot: &[f64]) -> Vector3<f64>;

    /// Its angular velocity in space while the body axes turn at ω, rad/s.
    fn angular_velocity(&self, body_rate: &Vector3<f64>) -> Vector3<f64>;

    /// A vector of the undeformed section, turned.
    fn turned(&self, vector: &Vector3<f64>) -> Vector3<f64>;

    /// A vector as the undeformed section had it.
    fn turned_back(&self, vector: &Vector3<f64>) -> Vector3<f64>;

    /// How far it has turned about an axis, rad.
    fn twist(&self, axis: &Vector3<f64>) -> f64;

    /// Writes the generalised force on each q of a force that acts here.
    fn write_generalised_force(&self, force: &Vector3<f64>, generalised: &mut [f64]);

    /// Adds the generalised forces on each q of a force and a moment that act here: by w and by the true spin σ.
    fn add_generalised_load(&self, force: &Vector3<f64>, moment: &Vector3<f64>, generalised: &mut [f64]);
}

/// A section with mass around it.
pub trait CarriesMass: Section {
    /// How what it carries moves under given q̈.
    fn carried(&self, q_ddot: &[f64]) -> Carried;
}

/// How what is fixed to a section at an offset o, m, is displaced relative to the body axes: it is at X + B o.
pub struct Carried {
    /// B.
    pub now: Matrix3<f64>,
    /// Ḃ, 1/s.
    pub rate: Matrix3<f64>,
    /// B̈, 1/s².
    pub acceleration: Matrix3<f64>,
}

impl Carried {
    /// By a section that turns as a rigid body, by E, at the spin σ, which changes at a rate.
    pub fn rigidly(turn: Matrix3<f64>, spin: &Vector3<f64>, spin_rate: &Vector3<f64>) -> Self {
        let (spin, spin_rate) = (spin.cross_matrix(), spin_rate.cross_matrix());
        Carried { now: turn, rate: spin * turn, acceleration: (spin_rate + spin * spin) * turn }
    }
}

/// Where a section is and how it is turned.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    /// X, m.
    pub position: Vector3<f64>,
    /// E.
    pub turn: Matrix3<f64>,
}

/// How sections turn vectors, of a kind `V`, that were fixed to them undeformed.
pub trait Turn<V> {
    /// The turned vectors.
    fn apply(&self, vectors: &V) -> V;
}

/// Where sections are and how they move, relative to the body axes: vectors `V`, axial vectors `A`, turns `T`.
pub struct SectionMotion<V, A, T> {
    /// X, m.
    pub position: V,
    /// From the undeformed section.
    pub turn: T,
    /// w, m/s.
    pub velocity: V,
    /// S q̇, rad/s.
    pub rate: A,
    /// σ: the true spin of the turn, rad/s.
    pub spin: A,
    /// What remains of the accelerations at q̈ = 0, where anything does [theory: kinematics.biases].
    pub bias: Option<Bias<V, A>>,
}

/// Accelerations relative to the body axes at q̈ = 0.
pub struct Bias<V, A> {
    /// Of ẇ, m/s².
    pub acceleration: V,
    /// Of the rate of S q̇, rad/s².
    pub angular_acceleration: A,
}

impl<S: Arithmetic> Turn<LaneVector<S>> for Rotation<S> {
    #[inline(always)]
    fn apply(&self, vectors: &LaneVector<S>) -> LaneVector<S> {
        Rotation::apply(self, vectors)
    }
}

impl<S: Arithmetic> Turn<PlaneVector<S>> for PlaneRotation<S> {
    #[inline(always)]
    fn apply(&self, vectors: &PlaneVector<S>) -> PlaneVector<S> {
        PlaneRotation::apply(self, vectors)
    }
}
