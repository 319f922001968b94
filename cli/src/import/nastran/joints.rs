//! Which joints are written: those of mirrored components once for both sides, as files have them.

use super::layout::{IN_PLANE, size};
use super::pairs::Side;
use super::structure::{Joint, Structure};

type Node = (usize, usize);

/// Components as pairs where their joints are pairs too: a joint of mirrored components is on both sides, so that where a deck has it on
/// one alone each side is written.
pub fn agreed(structure: &Structure, sides: Vec<Side>) -> Vec<Side> {
    if written(structure, &sides).is_some() { sides } else { vec![Side::Alone; sides.len()] }
}

/// The joints that a file needs for all to be there; none where mirrored components would get one that the deck does not have.
pub fn written<'s>(structure: &'s Structure, sides: &[Side]) -> Option<Vec<&'s Joint>> {
    let slack = IN_PLANE * size(structure);
    let image = |(component, node): Node| match sides[component] {
        Side::Written { image: other } | Side::Image { of: other } => Some((other, node)),
        Side::Alone => {
            let is_in_plane = structure.components[component].points[node].y.abs() <= slack;
            is_in_plane.then_some((component, node))
        }
    };
    let is_of =
        |joint: &Joint, [one, other]: [Node; 2]| joint.ends == [one, other] || joint.ends == [other, one];
    let is_image = |joint: &Joint| {
        joint.ends.iter().any(|(component, _)| matches!(sides[*component], Side::Image { .. }))
    };
    let mut written: Vec<&Joint> = Vec::new();
    let mut implied: Vec<[Node; 2]> = Vec::new();
    let (images, others): (Vec<&Joint>, Vec<&Joint>) =
        structure.joints.iter().partition(|joint| is_image(joint));
    for joint in others.into_iter().chain(images) {
        if implied.iter().any(|ends| is_of(joint, *ends)) {
            continue;
        }
        written.push(joint);
        let Some(ends) = image(joint.ends[0]).zip(image(joint.ends[1])).map(|(one, other)| [one, other])
        else {
            continue;
        };
        if is_of(joint, ends) {
            continue;
        }
        let has_image =
            structure.joints.iter().any(|other| is_of(other, ends) && other.rotations == joint.rotations);
        if !has_image {
            return None;
        }
        implied.push(ends);
    }
    Some(written)
}
