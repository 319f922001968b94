//! Ends of elements that are free: what a joint or a hinge holds of them, and what is said of the others.

use std::collections::BTreeSet;

use nalgebra::Vector3;

use super::super::members::Member;
use super::super::mistakes::Remarks;
use super::super::stiffness::ALIGNED;
use super::tree::{Closing, Tree};

/// Rotations about body axes that a joint shares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shared {
    pub rotations: [bool; 3],
    /// Whether these are those that the deck's ends share.
    pub is_held: bool,
}

/// Local x, y and z of an element.
pub fn axes(member: &Member) -> [Vector3<f64>; 3] {
    let x = member.span().normalize();
    [x, member.y_axis, x.cross(&member.y_axis)]
}

/// About which of its axes an end may turn.
pub fn free_rotations(member: &Member, end: usize) -> [bool; 3] {
    member.pins[end].as_ref().map_or([false; 3], |pin| [pin.free[3], pin.free[4], pin.free[5]])
}

/// What the joint of a loop shares, as its ends are pinned.
pub fn joint(members: &[Member], closing: &Closing) -> Shared {
    let ends = std::iter::once(closing.tip).chain(closing.opposite);
    let free = |(element, end): (usize, usize)| {
        let member = &members[element];
        let about = std::iter::zip(axes(member), free_rotations(member, end));
        about.filter(|(_, free)| *free).map(|(axis, _)| axis).collect::<Vec<_>>()
    };
    shared(&ends.flat_map(free).collect::<Vec<_>>())
}

/// Whether the joint of a loop holds the element that ends there from turning about itself.
pub fn holds_twist(members: &[Member], closing: &Closing) -> bool {
    let (element, end) = closing.tip;
    let Shared { rotations, is_held } = joint(members, closing);
    rotations == [true; 3] || (is_held && !free_rotations(&members[element], end)[0])
}

/// Rotations that remain where those about some axes are free.
fn shared(free: &[Vector3<f64>]) -> Shared {
    let body = [Vector3::x(), Vector3::y(), Vector3::z()];
    let along = |axis: &Vector3<f64>| body.map(|other| other.cross(axis).norm() < ALIGNED);
    let Some(first) = free.first() else { return Shared { rotations: [true; 3], is_held: true } };
    let normals = free.iter().map(|axis| first.cross(axis));
    let Some(normal) = normals.into_iter().find(|normal| normal.norm() > ALIGNED) else {
        let free = along(first);
        return Shared { rotations: free.map(|free| !free), is_held: free.contains(&true) };
    };
    let normal = normal.normalize();
    if free.iter().any(|axis| axis.dot(&normal).abs() > ALIGNED) {
        return Shared { rotations: [false; 3], is_held: true };
    }
    let rotations = along(&normal);
    Shared { rotations, is_held: rotations.contains(&true) }
}

/// Says what is not held of pinned ends.
pub fn tell(tree: &Tree, members: &[Member], remarks: &mut Remarks) {
    let mut held = BTreeSet::new();
    for closing in &tree.closings {
        let joined = std::iter::once(closing.tip).chain(closing.opposite);
        let is_held = joint(members, closing).is_held;
        for (element, end) in joined.clone().chain(closing.roots.iter().copied()) {
            held.insert((element, end));
            let Some(pin) = &members[element].pins[end] else { continue };
            let Some(field) = &pin.field else {
                if members[element].resists_twist {
                    let said =
                        "it closes a loop and is pinned at both ends: its torsional stiffness is not held";
                    remarks.card_once(&members[element].origin, "torsion", said);
                }
                continue;
            };
            let found = &field.found;
            if pin.free[..3].contains(&true) {
                remarks.of_field(
                    field,
                    format!("found {found}: displacements are not free, rotations alone are"),
                );
            }
            if !is_held && joined.clone().any(|other| other == (element, end)) {
                let all = if joint(members, closing).rotations[0] { "shared" } else { "free" };
                let said = format!(
                    "found {found}: a joint turns about body axes, so that all rotations are {all} here"
                );
                remarks.of_field(field, said);
            }
        }
    }
    for (element, member) in members.iter().enumerate() {
        for (end, pin) in member.pins.iter().enumerate() {
            let field = pin.as_ref().and_then(|pin| pin.field.as_ref());
            if let Some(field) = field.filter(|_| !held.contains(&(element, end))) {
                let found = &field.found;
                remarks.of_field(field, format!("found {found}: pin flags are held where a loop begins or ends, this end is fixed in all six"));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_joint_shares_what_is_not_free_if_that_is_about_body_axes() {
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let turned = Vector3::new(0.6, 0.8, 0.0);
        for (free, rotations, is_held) in [
            (vec![], [true; 3], true),
            (vec![-y], [true, false, true], true),
            (vec![x, z], [false, true, false], true),
            (vec![turned, z, turned.cross(&z)], [false; 3], true),
            (vec![turned, turned.cross(&z)], [false, false, true], true),
            (vec![turned], [true; 3], false),
            (vec![turned, z], [false; 3], false),
        ] {
            assert_eq!(shared(&free), Shared { rotations, is_held }, "{free:?}");
        }
    }
}
