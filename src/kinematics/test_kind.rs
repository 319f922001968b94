//! A kind of kinematics for tests that is all that the thesis' is not: its rows depend on q, accelerations remain at q̈ = 0, and
//! an evaluation writes it all to memory.
//!
//! X = r + Ψᵘq + ½ (q·q) a, with a of the place, and sections turn about y by θ = Ψᵠ_y q + ½ (q·q) c: S q̇ is their spin.

mod masses;

use nalgebra::{Matrix3, Vector3};
use pulp::Scalar;

use crate::math::{
    Arithmetic, Eight, EightVectors, LANES, LaneVector, Lanes, PlaneRotation, PlaneVector, Rotation, Window,
};
use crate::structure::{ModalIntegrals, ModeShapes, ReducedModel, ReducedStrip};

use super::freedom::RigidFreedom;
use super::kind::{Coordinates, Kinematics};
use super::sections::{
    Bias, Carried, CarriesMass, Pose, Section, SectionMotion, Sections, SectionsInPlane, SectionsInSpace,
};
use masses::Masses;

/// c.
const TURN: f64 = 2e-4;

/// The places of an aircraft's sections.
#[derive(Clone, Debug)]
pub struct Curved {
    pub strips: Vec<Place>,
    pub edge_on: Vec<Place>,
    pub engines: Vec<Place>,
    pub stations: Vec<Place>,
}

/// A place on the undeformed aircraft.
#[derive(Clone, Debug)]
pub struct Place {
    at_rest: Vector3<f64>,
    shapes: ModeShapes,
}

/// What an evaluation writes.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    strips: Vec<Written>,
    groups: Vec<EightWritten>,
    edge_on: Vec<EightWritten>,
    engines: Vec<Written>,
    stations: Vec<Written>,
}

/// Of a section.
#[derive(Clone, Debug)]
struct Written {
    at_rest: Vector3<f64>,
    position: Vector3<f64>,
    velocity: Vector3<f64>,
    /// ẇ and the rate of θ̇ at q̈ = 0.
    acceleration: Vector3<f64>,
    angular_acceleration: f64,
    angle: f64,
    spin: f64,
    /// J_x, J_y, J_z, S_x, S_y, S_z of each mode.
    rows: Vec<[f64; 6]>,
}

/// Of eight of them.
#[derive(Clone, Debug)]
struct EightWritten {
    at_rest: EightVectors,
    position: EightVectors,
    velocity: EightVectors,
    acceleration: EightVectors,
    angular_acceleration: Eight,
    angle: Eight,
    spin: Eight,
    rows: Vec<[Eight; 6]>,
}

impl Place {
    /// a, m: zero along y in the mirror plane.
    fn bend(&self) -> Vector3<f64> {
        Vector3::new(0.003, -0.0005 * self.at_rest.y, -0.002)
    }

    /// X.
    pub fn position(&self, q: &[f64]) -> Vector3<f64> {
        let displacement = |mode: usize| self.shapes.of_mode(mode)[0] * q[mode];
        let linear: Vector3<f64> = (0..q.len()).map(displacement).sum();
        self.at_rest + linear + self.bend() * (0.5 * dot(q, q))
    }

    /// θ.
    pub fn angle(&self, q: &[f64]) -> f64 {
        dot(self.shapes.row(4), q) + 0.5 * TURN * dot(q, q)
    }

    /// The rigid motion about O, v above ω, by which a unit rate of each coordinate moves this section: by differences.
    pub fn twists(&self, q: &[f64]) -> Vec<[f64; 6]> {
        let twist = |mode: usize| {
            let at = |step: f64| {
                let mut q = q.to_vec();
                q[mode] += step;
                (self.position(&q), self.angle(&q))
            };
            // Exact for squares, but for rounding.
            let step = 0.5;
            let [(ahead, turned), (behind, was_turned)] = [at(step), at(-step)];
            let [velocity, rate] = [(ahead - behind) / (2.0 * step), Vector3::y() * (turned - was_turned)];
            let at_origin = velocity - rate.cross(&self.position(q));
            std::array::from_fn(|axis| if axis < 3 { at_origin[axis] } else { rate[axis - 3] })
        };
        (0..q.len()).map(twist).collect()
    }

    fn evaluate(&self, Coordinates { q, q_dot }: Coordinates) -> Written {
        let row = |mode: usize| {
            let j = self.shapes.of_mode(mode)[0] + self.bend() * q[mode];
            [j.x, j.y, j.z, 0.0, self.shapes.row(4)[mode] + TURN * q[mode], 0.0]
        };
        let rows: Vec<_> = (0..q.len()).map(row).collect();
        Written {
            at_rest: self.at_rest,
            position: self.position(q),
            velocity: along(&rows, q_dot),
            acceleration: self.bend() * dot(q_dot, q_dot),
            angular_acceleration: TURN * dot(q_dot, q_dot),
            angle: self.angle(q),
            spin: rows.iter().zip(q_dot).map(|(row, q_dot)| row[4] * q_dot).sum(),
            rows,
        }
    }
}

/// J times rates.
fn along(rows: &[[f64; 6]], rates: &[f64]) -> Vector3<f64> {
    rows.iter().zip(rates).map(|([x, y, z, ..], rate)| Vector3::new(*x, *y, *z) * *rate).sum()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl EightWritten {
    fn of(sections: &[Written], modes: usize) -> Self {
        let vectors =
            |value: fn(&Written) -> Vector3<f64>| EightVectors::of(sections, value, Vector3::zeros());
        let numbers = |value: fn(&Written) -> f64| Eight::of(sections, value, 0.0);
        let row = |mode: usize, row: usize| Eight::of(sections, |section| section.rows[mode][row], 0.0);
        EightWritten {
            at_rest: vectors(|section| section.at_rest),
            position: vectors(|section| section.position),
            velocity: vectors(|section| section.velocity),
            acceleration: vectors(|section| section.acceleration),
            angular_acceleration: numbers(|section| section.angular_acceleration),
            angle: numbers(|section| section.angle),
            spin: numbers(|section| section.spin),
            rows: (0..modes).map(|mode| std::array::from_fn(|axis| row(mode, axis))).collect(),
        }
    }
}

impl Kinematics for Curved {
    type Memory = Memory;
    type Instant<'a> = &'a Memory;
    type Inertia = Masses;

    fn new(model: &ReducedModel, edge_on: &[ReducedStrip]) -> Self {
        let place = |at_rest, shapes: &ModeShapes| Place { at_rest, shapes: shapes.clone() };
        let strips = |strips: &[ReducedStrip]| {
            strips.iter().map(|strip| place(strip.position, &strip.shapes)).collect()
        };
        Curved {
            strips: strips(&model.strips),
            edge_on: strips(edge_on),
            engines: model.engines.iter().map(|engine| place(engine.position, &engine.shapes)).collect(),
            stations: model.stations.iter().map(|station| place(station.position, &station.shapes)).collect(),
        }
    }

    fn memory(&self) -> Memory {
        Memory::default()
    }

    fn inertia(&self, _: &ModalIntegrals, freedom: RigidFreedom) -> Masses {
        Masses::new(freedom)
    }

    fn evaluate<S: Arithmetic>(&self, _: S, at: Coordinates, memory: &mut Memory) {
        let written = |places: &[Place]| places.iter().map(|place| place.evaluate(at)).collect();
        let groups = |sections: &[Written]| {
            sections.chunks(LANES).map(|eight| EightWritten::of(eight, at.q.len())).collect()
        };
        let (strips, edge_on): (Vec<_>, Vec<_>) = (written(&self.strips), written(&self.edge_on));
        *memory = Memory {
            groups: groups(&strips),
            strips,
            edge_on: groups(&edge_on),
            engines: written(&self.engines),
            stations: written(&self.stations),
        };
    }

    fn sections<'a>(&'a self, _: Coordinates<'a>, memory: &'a Memory) -> &'a Memory {
        memory
    }

    fn largest_displacement(&self) -> f64 {
        1.0
    }

    fn largest_shape(&self) -> f64 {
        1.0
    }
}

impl Sections for &Memory {
    fn of_strips(&self, group: usize) -> impl SectionsInSpace + SectionsInPlane {
        &self.groups[group]
    }

    fn edge_on(&self, group: usize) -> impl SectionsInPlane {
        &self.edge_on[group]
    }

    fn engines(&self) -> impl Iterator<Item = impl Section> {
        self.engines.iter()
    }

    fn stations(&self) -> impl Iterator<Item = impl Section> {
        self.stations.iter()
    }

    fn masses(&self) -> impl Iterator<Item = impl CarriesMass> {
        self.stations.iter()
    }

    fn cuts(&self, _: &[f64]) -> impl Iterator<Item = Pose> {
        self.stations.iter().map(|at| Pose { position: at.position, turn: at.matrix() })
    }

    fn strip_displacements(&self) -> impl Iterator<Item = Vector3<f64>> {
        self.strips.iter().map(|section| section.position - section.at_rest)
    }
}

/// Along y.
fn about_y<S: Arithmetic>(window: Window<S>, numbers: &Eight) -> LaneVector<S> {
    LaneVector { x: window.splat(0.0), y: window.load(numbers), z: window.splat(0.0) }
}

/// x and z.
fn in_plane<S: Arithmetic>(window: Window<S>, vectors: &EightVectors) -> PlaneVector<S> {
    PlaneVector::load(window, [&vectors.x, &vectors.z])
}

impl SectionsInSpace for &EightWritten {
    type Turn<S: Arithmetic> = Rotation<S>;

    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> LaneVector<S> {
        LaneVector::load(window, &self.at_rest)
    }

    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<LaneVector<S>, LaneVector<S>, Rotation<S>> {
        SectionMotion {
            position: LaneVector::load(window, &self.position),
            turn: Rotation::new(about_y(window, &self.angle)),
            velocity: LaneVector::load(window, &self.velocity),
            rate: about_y(window, &self.spin),
            spin: about_y(window, &self.spin),
            bias: Some(Bias {
                acceleration: LaneVector::load(window, &self.acceleration),
                angular_acceleration: about_y(window, &self.angular_acceleration),
            }),
        }
    }

    fn rows<T>(&self, all: impl Iterator<Item = T>) -> impl Iterator<Item = (&[Eight; 6], T)> {
        self.rows.iter().zip(all)
    }
}

impl SectionsInPlane for &EightWritten {
    type Turn<S: Arithmetic> = PlaneRotation<S>;

    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> PlaneVector<S> {
        in_plane(window, &self.at_rest)
    }

    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<PlaneVector<S>, Lanes<S>, PlaneRotation<S>> {
        SectionMotion {
            position: in_plane(window, &self.position),
            turn: PlaneRotation::new(window.load(&self.angle)),
            velocity: in_plane(window, &self.velocity),
            rate: window.load(&self.spin),
            spin: window.load(&self.spin),
            bias: Some(Bias {
                acceleration: in_plane(window, &self.acceleration),
                angular_acceleration: window.load(&self.angular_acceleration),
            }),
        }
    }

    fn rows<T>(&self, all: impl Iterator<Item = T>) -> impl Iterator<Item = ([&Eight; 3], T)> {
        self.rows.iter().map(|[x, _, z, _, about_y, _]| [x, z, about_y]).zip(all)
    }
}

impl Written {
    fn turn(&self) -> Rotation<Scalar> {
        Rotation::new(LaneVector::single(&(Vector3::y() * self.angle)))
    }
}

impl Written {
    fn matrix(&self) -> Matrix3<f64> {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        Matrix3::from_columns(&axes.map(|axis| self.turn().apply(&LaneVector::single(&axis)).vector()))
    }
}

impl CarriesMass for &Written {
    fn carried(&self, q_ddot: &[f64]) -> Carried {
        let by_rates: f64 = self.rows.iter().zip(q_ddot).map(|(row, q_ddot)| row[4] * q_ddot).sum();
        let spin_rate = Vector3::y() * (by_rates + self.angular_acceleration);
        Carried::rigidly(self.matrix(), &(Vector3::y() * self.spin), &spin_rate)
    }
}

impl Section for &Written {
    fn displacement(&self) -> Vector3<f64> {
        self.position - self.at_rest
    }

    fn at_rest(&self) -> Vector3<f64> {
        self.at_rest
    }

    fn velocity(&self) -> Vector3<f64> {
        self.velocity
    }

    fn acceleration(&self, q_ddot: &[f64]) -> Vector3<f64> {
        along(&self.rows, q_ddot) + self.acceleration
    }

    fn angular_velocity(&self, body_rate: &Vector3<f64>) -> Vector3<f64> {
        body_rate + Vector3::y() * self.spin
    }

    fn turned(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        self.turn().apply(&LaneVector::single(vector)).vector()
    }

    fn turned_back(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        self.turn().apply_inverse(&LaneVector::single(vector)).vector()
    }

    fn twist(&self, axis: &Vector3<f64>) -> f64 {
        axis.y * self.angle
    }

    fn write_generalised_force(&self, force: &Vector3<f64>, generalised: &mut [f64]) {
        for (generalised, [x, y, z, ..]) in generalised.iter_mut().zip(&self.rows) {
            *generalised = Vector3::new(*x, *y, *z).dot(force);
        }
    }

    fn add_generalised_load(&self, force: &Vector3<f64>, moment: &Vector3<f64>, generalised: &mut [f64]) {
        for (generalised, [x, y, z, _, about_y, _]) in generalised.iter_mut().zip(&self.rows) {
            *generalised += Vector3::new(*x, *y, *z).dot(force) + about_y * moment.y;
        }
    }
}
