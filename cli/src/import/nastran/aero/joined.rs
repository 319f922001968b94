//! Two controls of one side each, joined by a third that moves both alike, or one against the other: trims need one that pitches and does
//! nothing else, one that rolls and one that yaws.

use nalgebra::Vector3;

use super::super::names::Names;
use super::controls::{Control, both};
use super::roles::{Role, roles};
use super::strip::Surface;

/// Moments of images that differ by more than this share are none of each other.
const ALIKE: f64 = 0.02;

/// Two controls that are images of each other, the other one turned as the first one or against it, and what both do together.
struct Pair {
    controls: [usize; 2],
    sense: f64,
    moment: f64,
}

/// What joins two controls.
struct Joint {
    role: Role,
    /// Whether they turn as images of each other do, or against that.
    sense: f64,
    name: &'static str,
    how: &'static str,
}

const JOINTS: [Joint; 3] = [
    Joint { role: Role::Pitch, sense: 1.0, name: "both_elevators", how: "moves both alike" },
    Joint { role: Role::Roll, sense: -1.0, name: "both_ailerons", how: "moves one against the other" },
    Joint { role: Role::Yaw, sense: -1.0, name: "both_rudders", how: "moves both to one side" },
];

/// Adds controls that move the two which pitch, roll or yaw most, if two are images of each other and do more of it than the one that does by
/// itself; says which. What each does is found anew in between.
pub fn join(
    (controls, surfaces): (&mut Vec<Control>, &mut [Surface]),
    moments: impl Fn(&[Surface], usize) -> Vec<Vector3<f64>>,
) -> Vec<String> {
    let mut said = Vec::new();
    for joint in JOINTS {
        let moments = moments(surfaces, controls.len());
        if let Some(pair) = most(&joint, &moments) {
            said.push(add(&joint, &pair, (controls, surfaces)));
        }
    }
    said
}

/// The pair that does most for a role, if it does more than what holds it.
fn most(joint: &Joint, moments: &[Vector3<f64>]) -> Option<Pair> {
    let axis = joint.role.axis();
    let holder = roles(moments).iter().position(|role| *role == Some(joint.role));
    let least = holder.map_or(0.0, |control| moments[control][axis].abs());
    let places = (0..moments.len()).flat_map(|one| (one + 1..moments.len()).map(move |other| [one, other]));
    let pairs = places.flat_map(|controls| [1.0, -1.0].map(|sense| (controls, sense)));
    let pair = |(controls, sense): ([usize; 2], f64)| {
        let [one, other] = [moments[controls[0]], moments[controls[1]] * sense];
        let image = Vector3::new(-one.x, one.y, -one.z);
        let sense = sense * joint.sense;
        let both = one + moments[controls[1]] * sense;
        let moment = both[axis].abs();
        let is_pair = both.iamax() == axis && (image - other).norm() <= ALIKE * one.norm();
        (is_pair && moment > least).then_some(Pair { controls, sense, moment })
    };
    pairs.filter_map(pair).max_by(|one, other| one.moment.total_cmp(&other.moment))
}

fn add(joint: &Joint, pair: &Pair, (controls, surfaces): (&mut Vec<Control>, &mut [Surface])) -> String {
    let senses = [(pair.controls[0], 1.0), (pair.controls[1], pair.sense)];
    let joined = controls.len();
    for flap in surfaces.iter_mut().filter_map(|surface| surface.flap.as_mut()) {
        let of = |(control, sense): (usize, f64)| {
            flap.moves.iter().filter(move |(moved, _)| *moved == control).map(move |(_, gain)| sense * gain)
        };
        let gain: f64 = senses.into_iter().flat_map(of).sum();
        if gain != 0.0 {
            flap.moves.push((joined, gain));
        }
    }
    let [one, other] = pair.controls.map(|control| &controls[control]);
    let label = format!("{} and {}", one.label, other.label);
    let parts = one.parts.iter().chain(&other.parts).cloned().collect();
    let name = free(controls, joint.name);
    let origin = one.origin.clone();
    let said = format!(
        "{label} are images of each other: {name} {}, so that a trim has a control for {}",
        joint.how,
        joint.role.name()
    );
    let turned = other.limits.map(|[low, high]| if pair.sense > 0.0 { [low, high] } else { [-high, -low] });
    let limits = both(one.limits, turned);
    controls.push(Control { origin, name, label, limits, parts });
    said
}

/// A name that none has.
fn free(controls: &[Control], name: &str) -> String {
    let mut names = Names::default();
    controls.iter().for_each(|control| drop(names.free(&control.name, "control")));
    names.free(name, "control")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elevons_pitch_and_roll_and_rudders_yaw_each_in_their_sense() {
        let elevons = [Vector3::new(-6.0, -4.0, 0.1), Vector3::new(6.0, -4.0, -0.1)];
        // Both turn inwards by a positive angle, so that one counts against the other.
        let rudders = [Vector3::new(0.4, 0.2, 7.0), Vector3::new(-0.4, 0.2, -7.0)];
        let moments = [elevons[0], rudders[0], elevons[1], rudders[1]];
        let found = JOINTS.each_ref().map(|joint| {
            let pair = most(joint, &moments).unwrap();
            (pair.controls, pair.sense, pair.moment)
        });
        assert_eq!(found, [([0, 2], 1.0, 8.0), ([0, 2], -1.0, 12.0), ([1, 3], -1.0, 14.0)]);
        // What does as much by itself stays alone.
        let both = elevons[0] - elevons[1];
        assert!(most(&JOINTS[1], &[elevons[0], elevons[1], both * 1.01]).is_none());
    }
}
