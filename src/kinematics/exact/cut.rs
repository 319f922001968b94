//! Where a cut is that no section need stand at: some helices beyond one that is evaluated.
//!
//! [theory: geometrically-exact.recursion]

use nalgebra::{Matrix3, Vector3};
use pulp::Scalar;

use crate::math::{LANES, LaneVector, Rotation};
use crate::structure::{ModeShapes, ReducedCut, ReducedModel};

use super::super::sections::Pose;
use super::tree::MovingTree;

/// A cut, and the way to it.
#[derive(Clone, Debug)]
pub struct CutBeyond {
    /// The section from which the way leads.
    section: usize,
    /// From that outward.
    helices: Vec<Helix>,
}

/// What leads from a section to the next.
#[derive(Clone, Debug)]
struct Helix {
    /// L, m.
    arm: Vector3<f64>,
    /// Dλ and Dφ.
    steps: ModeShapes,
}

impl CutBeyond {
    /// Of a model's cut; `evaluated` says where a section stands among those that are evaluated, if it does.
    pub fn new(model: &ReducedModel, cut: &ReducedCut, evaluated: impl Fn(usize) -> Option<usize>) -> Self {
        let sections = &model.sections;
        let arm = cut.position - sections[cut.section].position;
        let mut helices = vec![Helix { arm, steps: cut.steps.clone() }];
        let mut at = cut.section;
        let section = loop {
            match evaluated(at) {
                Some(place) => break place,
                None => {
                    let parent = sections[at].parent;
                    let arm = sections[at].position - sections[parent].position;
                    helices.push(Helix { arm, steps: sections[at].steps.clone() });
                    at = parent;
                }
            }
        };
        helices.reverse();
        CutBeyond { section, helices }
    }

    /// At an instant.
    pub fn now(&self, tree: &MovingTree, q: &[f64]) -> Pose {
        let from = tree.eights[self.section / LANES].single(self.section % LANES);
        let mut pose = Pose { position: from.position, turn: from.turn };
        for helix in &self.helices {
            helix.lead(q, &mut pose);
        }
        pose
    }
}

impl Helix {
    /// From one pose to the next.
    fn lead(&self, q: &[f64], pose: &mut Pose) {
        let (mut phi, mut lambda) = (Vector3::zeros(), self.arm);
        for (mode, q) in q.iter().enumerate() {
            let [slide, turn] = self.steps.of_mode(mode);
            phi += turn * *q;
            lambda += slide * *q;
        }
        let rotation = Rotation::<Scalar>::new(LaneVector::single(&phi));
        let lambda = LaneVector::single(&lambda);
        // T λ, as a spin follows from a rate.
        let tangent = (lambda + rotation.excess_spin(&lambda)).vector();
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let turn = axes.map(|axis| rotation.apply(&LaneVector::single(&axis)).vector());
        pose.position += pose.turn * tangent;
        pose.turn *= Matrix3::from_columns(&turn);
    }
}
