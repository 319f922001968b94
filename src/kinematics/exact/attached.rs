//! A point fixed to a section at a constant offset [theory: geometrically-exact.attached, geometrically-exact.half].
//!
//! Of an aircraft that is its own mirror image, one side alone is evaluated; what hangs on the other moves as its image.

use nalgebra::{Matrix3, Vector3};

use crate::math::LANES;
use crate::structure::Carrier;

use super::super::sections::{Carried, CarriesMass, Section};
use super::moving::Moving;
use super::tree::MovingTree;
use super::twists::EightTwists;

/// A point fixed to a section.
#[derive(Clone, Debug)]
pub struct Attached {
    carrier: Carrier,
    /// Undeformed, body axes, m.
    at_rest: Vector3<f64>,
    /// From the section that is evaluated to the point, or to its mirror image, m.
    offset: Vector3<f64>,
    /// The modes that move it, and their rows.
    modes: Vec<(usize, usize)>,
}

/// The same at an instant.
#[derive(Clone, Copy, Debug)]
pub struct AttachedNow<'a> {
    place: &'a Attached,
    /// The point, or its mirror image.
    moving: Moving,
    /// Of its section's group.
    twists: &'a EightTwists,
}

impl Attached {
    /// At a place of the undeformed aircraft, carried by a section that stands at another and is moved by some modes.
    pub fn new(
        at_rest: Vector3<f64>,
        carrier: Carrier,
        section: &Vector3<f64>,
        modes: Vec<(usize, usize)>,
    ) -> Self {
        let evaluated = if carrier.mirrored { mirror(&at_rest) } else { at_rest };
        Attached { carrier, at_rest, offset: evaluated - section, modes }
    }

    /// At an instant.
    pub fn now<'a>(&'a self, tree: &'a MovingTree) -> AttachedNow<'a> {
        let section = self.carrier.section;
        AttachedNow {
            place: self,
            moving: tree.section(section).with_offset(&self.offset),
            twists: &tree.twists[section / LANES],
        }
    }
}

/// An arrow's image in the plane y = 0.
fn mirror(arrow: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(arrow.x, -arrow.y, arrow.z)
}

impl AttachedNow<'_> {
    /// An arrow from the section that is evaluated to the one that it stands for, or back.
    fn arrow(&self, arrow: &Vector3<f64>) -> Vector3<f64> {
        if self.place.carrier.mirrored { mirror(arrow) } else { *arrow }
    }

    /// The same of an axis of rotation.
    fn axis(&self, axis: &Vector3<f64>) -> Vector3<f64> {
        if self.place.carrier.mirrored { -mirror(axis) } else { *axis }
    }

    /// Each mode that moves it with its J° and S, as they are evaluated.
    fn twists(&self) -> impl Iterator<Item = (usize, [Vector3<f64>; 2])> {
        self.place.modes.iter().map(|&(mode, row)| {
            let lane = self.place.carrier.section % LANES;
            let [x, y, z, about_x, about_y, about_z] = self.twists[row].1.each_ref().map(|row| row.0[lane]);
            (mode, [Vector3::new(x, y, z), Vector3::new(about_x, about_y, about_z)])
        })
    }

    /// Each of them with its J.
    fn rows(&self) -> impl Iterator<Item = (usize, Vector3<f64>)> {
        self.twists().map(|(mode, [slide, turn])| (mode, slide + turn.cross(&self.moving.position)))
    }
}

impl Section for AttachedNow<'_> {
    fn displacement(&self) -> Vector3<f64> {
        self.arrow(&self.moving.position) - self.place.at_rest
    }

    fn at_rest(&self) -> Vector3<f64> {
        self.place.at_rest
    }

    fn velocity(&self) -> Vector3<f64> {
        self.arrow(&self.moving.velocity)
    }

    fn acceleration(&self, q_ddot: &[f64]) -> Vector3<f64> {
        let mut sum = self.moving.acceleration;
        for (mode, row) in self.rows() {
            sum += row * q_ddot[mode];
        }
        self.arrow(&sum)
    }

    fn angular_velocity(&self, body_rate: &Vector3<f64>) -> Vector3<f64> {
        body_rate + self.axis(&self.moving.spin)
    }

    fn turned(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        self.arrow(&(self.moving.turn * self.arrow(vector)))
    }

    fn turned_back(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        self.arrow(&self.moving.turn.tr_mul(&self.arrow(vector)))
    }

    /// [theory: geometrically-exact.twist]
    fn twist(&self, axis: &Vector3<f64>) -> f64 {
        let along_x = axis.cross(&Vector3::x());
        let forward = if along_x.norm() > ALONG_X { Vector3::x() } else { Vector3::y() };
        let forward = (forward - axis * axis.dot(&forward)).normalize();
        let turned = self.turned(&forward);
        libm::atan2(-forward.cross(axis).dot(&turned), forward.dot(&turned))
    }

    fn write_generalised_force(&self, force: &Vector3<f64>, generalised: &mut [f64]) {
        let force = self.arrow(force);
        generalised.fill(0.0);
        for (mode, row) in self.rows() {
            generalised[mode] = row.dot(&force);
        }
    }

    /// By the twists about O [theory: kinematics.twist].
    fn add_generalised_load(&self, force: &Vector3<f64>, moment: &Vector3<f64>, generalised: &mut [f64]) {
        let (force, moment) = (self.arrow(force), self.axis(moment));
        let about_origin = self.moving.position.cross(&force) + moment;
        for (mode, [slide, turn]) in self.twists() {
            generalised[mode] += slide.dot(&force) + turn.dot(&about_origin);
        }
    }
}

impl CarriesMass for AttachedNow<'_> {
    fn carried(&self, q_ddot: &[f64]) -> Carried {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let turn = Matrix3::from_columns(&axes.map(|axis| self.turned(&axis)));
        let mut spin_rate = self.moving.angular_acceleration;
        for (mode, [_, turn]) in self.twists() {
            spin_rate += turn * q_ddot[mode];
        }
        Carried::rigidly(turn, &self.axis(&self.moving.spin), &self.axis(&spin_rate))
    }
}

/// Sine of the angle to the x axis below which an axis is along it.
const ALONG_X: f64 = 1e-6;
