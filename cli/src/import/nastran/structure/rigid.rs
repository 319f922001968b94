//! Rigid links as elements: how much stiffer they are than what is beside them.

use super::super::members::Member;
use super::super::stiffness::Stiffness;
use super::tree::Tree;

/// How much stiffer rigid links are than the stiffest element beside them, as stiffness by length.
pub const RIGID: f64 = 1e5;

/// The stiffest that the format takes.
pub const STIFFEST: f64 = 1e15;

/// Of each body the greatest stiffness by length of the elements on it.
pub fn stiffest(members: &[Member], tree: &Tree) -> Vec<Stiffness> {
    let mut stiffest = vec![Stiffness::default(); tree.outward.len()];
    for (member, ends) in members.iter().zip(&tree.ends) {
        for &body in ends {
            stiffest[body] = stiffer(&stiffest[body], &member.stiffness, member.length());
        }
    }
    for closing in &tree.closings {
        let both = stiffer(&stiffest[closing.joined_to], &stiffest[closing.own], 1.0);
        (stiffest[closing.joined_to], stiffest[closing.own]) = (both, both);
    }
    stiffest
}

/// The greater of stiffnesses by length and those of an element.
fn stiffer(most: &Stiffness, of: &Stiffness, length: f64) -> Stiffness {
    Stiffness {
        ea: most.ea.max(of.ea / length),
        gj: most.gj.max(of.gj / length),
        ei_y: most.ei_y.max(of.ei_y / length),
        ei_z: most.ei_z.max(of.ei_z / length),
        ..Stiffness::default()
    }
}

/// Of a link of a length, m, among elements with a greatest stiffness by length.
pub fn rigid(stiffest: &Stiffness, length: f64) -> Stiffness {
    let times = |by_length: f64| (RIGID * by_length * length).clamp(1e-6, STIFFEST);
    let bending = stiffest.ei_y.max(stiffest.ei_z).max(stiffest.gj);
    Stiffness {
        ea: times(stiffest.ea),
        gj: times(bending),
        ei_y: times(bending),
        ei_z: times(bending),
        ..Stiffness::default()
    }
}
