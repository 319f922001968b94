//! Two controls of one side each, joined by a third that moves both alike: trims need one that pitches and does nothing else.

use nalgebra::Vector3;

use super::super::names::Names;
use super::controls::Control;
use super::strip::Surface;

/// Moments of images that differ by more than this share are none of each other.
const ALIKE: f64 = 0.02;

/// Two controls, the other one turned as the first one or against it, which together pitch the aircraft and do nothing else.
struct Pair {
    controls: [usize; 2],
    sense: f64,
    pitch: f64,
}

/// Adds a control that moves the two which pitch most, if two are images of each other and pitch more than the one that does by itself; says
/// which.
pub fn join_for_pitch(
    (controls, surfaces): (&mut Vec<Control>, &mut [Surface]),
    moments: &[Vector3<f64>],
    least: f64,
) -> Option<String> {
    let places = (0..moments.len()).flat_map(|one| (one + 1..moments.len()).map(move |other| [one, other]));
    let pairs = places.flat_map(|controls| [1.0, -1.0].map(|sense| (controls, sense)));
    let pair = |(controls, sense): ([usize; 2], f64)| {
        let [one, other] = [moments[controls[0]], moments[controls[1]] * sense];
        let image = Vector3::new(-one.x, one.y, -one.z);
        let pitch = (one.y + other.y).abs();
        let is_pair = one.y != 0.0 && (image - other).norm() <= ALIKE * one.norm();
        (is_pair && pitch > least).then_some(Pair { controls, sense, pitch })
    };
    let most = pairs.filter_map(pair).max_by(|one, other| one.pitch.total_cmp(&other.pitch))?;
    let senses = [(most.controls[0], 1.0), (most.controls[1], most.sense)];
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
    let [one, other] = most.controls.map(|control| &controls[control]);
    let label = format!("{} and {}", one.label, other.label);
    let parts = one.parts.iter().chain(&other.parts).cloned().collect();
    let name = free(controls);
    let origin = one.origin.clone();
    let said = format!(
        "{label} are images of each other: {name} moves both alike, so that a trim has a control for pitch"
    );
    let limits = both(
        one.limits,
        other.limits.map(|[low, high]| if most.sense > 0.0 { [low, high] } else { [-high, -low] }),
    );
    controls.push(Control { origin, name, label, limits, parts });
    Some(said)
}

/// Angles that both may have.
fn both(one: Option<[f64; 2]>, other: Option<[f64; 2]>) -> Option<[f64; 2]> {
    match (one, other) {
        (Some(one), Some(other)) => Some([one[0].max(other[0]), one[1].min(other[1])]),
        (one, other) => one.or(other),
    }
}

/// A name that none has.
fn free(controls: &[Control]) -> String {
    let mut names = Names::default();
    controls.iter().for_each(|control| drop(names.free(&control.name, "control")));
    names.free("both_elevators", "control")
}
