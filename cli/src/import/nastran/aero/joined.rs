//! Two controls of one side each, joined by a third that moves both alike: trims need one that pitches and does nothing else.

use nalgebra::Vector3;

use super::super::names::Names;
use super::controls::Control;
use super::strip::Surface;

/// Moments of images that differ by more than this share are none of each other.
const ALIKE: f64 = 0.02;

/// Adds a control that moves the two which pitch most, if two are images of each other; says which.
pub fn join_for_pitch(
    controls: &mut Vec<Control>,
    surfaces: &mut [Surface],
    moments: &[Vector3<f64>],
) -> Option<String> {
    let pairs = (0..moments.len()).flat_map(|one| (one + 1..moments.len()).map(move |other| [one, other]));
    let is_pair = |[one, other]: &[usize; 2]| {
        let [one, other] = [moments[*one], moments[*other]];
        let image = Vector3::new(-one.x, one.y, -one.z);
        one.y != 0.0 && (image - other).norm() <= ALIKE * one.norm()
    };
    let pitch = |pair: &[usize; 2]| moments[pair[0]].y.abs();
    let most = pairs.filter(is_pair).max_by(|one, other| pitch(one).total_cmp(&pitch(other)))?;
    let joined = controls.len();
    for flap in surfaces.iter_mut().filter_map(|surface| surface.flap.as_mut()) {
        let gain: f64 =
            flap.moves.iter().filter(|(control, _)| most.contains(control)).map(|(_, gain)| gain).sum();
        if gain != 0.0 {
            flap.moves.push((joined, gain));
        }
    }
    let [one, other] = most.map(|control| &controls[control]);
    let label = format!("{} and {}", one.label, other.label);
    let parts = one.parts.iter().chain(&other.parts).cloned().collect();
    let name = free(controls);
    let origin = one.origin.clone();
    let said = format!(
        "{label} are images of each other: {name} moves both alike, so that a trim has a control for pitch"
    );
    let limits = one.limits;
    controls.push(Control { origin, name, label, limits, parts });
    Some(said)
}

/// A name that none has.
fn free(controls: &[Control]) -> String {
    let mut names = Names::default();
    controls.iter().for_each(|control| drop(names.free(&control.name, "control")));
    names.free("both_elevators", "control")
}
