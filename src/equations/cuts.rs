//! Cuts through the airframe and the loads there: who has what outboard, and along which axes loads are counted.
//!
//! [theory: section-loads.outboard, section-loads.axes, section-loads.components]

use nalgebra::Vector3;

use crate::kinematics::Pose;
use crate::strips::Resultant;
use crate::structure::{Outboard, ReducedCut, ReducedMass, ReducedModel, RigidBody};

/// What all that acts outboard of a cut does there [theory: section-loads.components].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SectionLoads {
    /// Where the cut is on the deformed aircraft, body axes, m.
    pub position: Vector3<f64>,
    /// Body axes, N.
    pub force: Vector3<f64>,
    /// About the cut's deformed place, body axes, N·m.
    pub moment: Vector3<f64>,
    /// Upwards; on a fin to the left, on an upright body forwards, N.
    pub shear: f64,
    /// Forwards; on a lengthwise or upright body to the right, N.
    pub shear_chordwise: f64,
    /// Outboard along the beam, N.
    pub axial: f64,
    /// Nose-up; on a fin or an upright body nose-left; of a lengthwise body about its forward axis, N·m.
    pub torsion: f64,
    /// Moves the tip as positive shear does: raises it, N·m.
    pub bending: f64,
    /// Moves the tip as positive chordwise shear does: forwards, N·m.
    pub bending_chordwise: f64,
}

/// The cuts of an aircraft, and its masses.
#[derive(Clone, Debug)]
pub struct Cuts {
    cuts: Vec<CutAxes>,
    bodies: Vec<RigidBody>,
}

/// A cut's axes on the undeformed aircraft, and what is outboard of it.
#[derive(Clone, Debug)]
struct CutAxes {
    along: Vector3<f64>,
    up: Vector3<f64>,
    chordwise: Vector3<f64>,
    torsion: Vector3<f64>,
    outboard: Outboard,
}

impl Cuts {
    /// Of a model.
    pub fn new(model: &ReducedModel) -> Self {
        let axes = |cut: &ReducedCut| {
            let ReducedCut { along, up, chordwise, torsion, ref outboard, .. } = *cut;
            CutAxes { along, up, chordwise, torsion, outboard: outboard.clone() }
        };
        Cuts {
            cuts: model.cuts.iter().map(axes).collect(),
            bodies: model.masses.iter().map(|ReducedMass { body, .. }| *body).collect(),
        }
    }

    /// What all masses weigh, and where.
    pub fn bodies(&self) -> &[RigidBody] {
        &self.bodies
    }

    /// Number of cuts.
    pub fn len(&self) -> usize {
        self.cuts.len()
    }

    /// Takes the moments, which are about O, about the cuts where they are now, and resolves all along their axes.
    pub fn resolve(&self, poses: impl Iterator<Item = Pose>, loads: &mut [SectionLoads]) {
        for ((cut, pose), load) in self.cuts.iter().zip(poses).zip(loads) {
            load.resolve(cut, &pose);
        }
    }

    /// Adds what acts on something to the loads of all cuts that have it outboard, moments about O.
    pub fn add(
        &self,
        loads: &mut [SectionLoads],
        of: fn(&Outboard) -> &[usize],
        number: usize,
        Resultant { position, force, moment }: &Resultant,
    ) {
        for (cut, load) in self.cuts.iter().zip(loads) {
            if of(&cut.outboard).binary_search(&number).is_ok() {
                load.force += force;
                load.moment += position.cross(force) + moment;
            }
        }
    }
}

impl SectionLoads {
    fn resolve(&mut self, cut: &CutAxes, Pose { position, turn }: &Pose) {
        self.position = *position;
        self.moment -= position.cross(&self.force);
        let [along, up, chordwise, torsion] =
            [&cut.along, &cut.up, &cut.chordwise, &cut.torsion].map(|axis| turn * axis);
        self.shear = up.dot(&self.force);
        self.shear_chordwise = chordwise.dot(&self.force);
        self.axial = along.dot(&self.force);
        self.torsion = torsion.dot(&self.moment);
        self.bending = along.cross(&up).dot(&self.moment);
        self.bending_chordwise = along.cross(&chordwise).dot(&self.moment);
    }
}
