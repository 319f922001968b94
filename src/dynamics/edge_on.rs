//! Drag of strips that symmetric flow meets edge-on: fins and the sides of the body [4.1; physics.md §4].
//!
//! They lie in the mirror plane with their normals across it. While all motion is in the plane, w, Ω and λ₀ vanish,
//! V_s is (f·V) f, and of the loads only D₀ = CD0 ρ b |V_s| V_s remains. Everything here is in x and z.

use pulp::Simd;

use crate::lanes::{Eight, LANES, LaneVector, Lanes, Place};
use crate::structure::ReducedStrip;

use super::freedom::RigidFreedom;
use super::rotation::Rotation;
use super::strip_sums::StripSums;
use super::strips::Surroundings;

/// Eight strips.
#[derive(Clone, Debug)]
struct Group {
    /// x and z.
    position: [Eight; 2],
    /// f: x and z.
    forward: [Eight; 2],
    /// CD0 b Δy, m².
    drag_area: Eight,
    /// Ψᵘ_x, Ψᵘ_z, Ψᵠ_y of each mode.
    shapes: Vec<[Eight; 3]>,
}

/// All strips edge-on.
#[derive(Clone, Debug, Default)]
pub struct EdgeOnStrips {
    groups: Vec<Group>,
    /// Which strips would lift, were they not edge-on.
    lifting: Vec<bool>,
}

impl EdgeOnStrips {
    /// Strips with the shapes of so many modes.
    pub fn new(strips: &[ReducedStrip], modes: usize) -> Self {
        EdgeOnStrips {
            groups: strips.chunks(LANES).map(|strips| Group::new(strips, modes)).collect(),
            lifting: strips.iter().map(|strip| strip.lift_slope > 0.0).collect(),
        }
    }

    /// Adds the drag to the sums; returns the first strip that would lift and meets the air from behind.
    #[inline(always)]
    pub fn add_drag<S: Simd>(&self, simd: S, around: &Surroundings, sums: &mut StripSums) -> Option<usize> {
        let mut reversed = None;
        for (index, group) in self.groups.iter().enumerate() {
            for place in Place::all(simd) {
                let chordwise = group.add_drag(place, around, sums);
                if chordwise.least() <= 0.0 && reversed.is_none() {
                    let strip = |lane: usize| index * LANES + place.lane(lane);
                    let mut lanes = chordwise.numbers().iter().enumerate();
                    let lifts = |lane: usize| self.lifting.get(strip(lane)) == Some(&true);
                    reversed = lanes
                        .find(|(lane, along)| **along <= 0.0 && lifts(*lane))
                        .map(|(lane, _)| strip(lane));
                }
            }
        }
        reversed
    }
}

impl Group {
    fn new(strips: &[ReducedStrip], modes: usize) -> Self {
        let lanes_or = |value: &dyn Fn(&ReducedStrip) -> f64, empty: f64| {
            Eight(std::array::from_fn(|lane| strips.get(lane).map_or(empty, value)))
        };
        let lanes = |value: &dyn Fn(&ReducedStrip) -> f64| lanes_or(value, 0.0);
        let shape = |mode: usize| {
            [
                lanes(&|strip| strip.shapes.translation[mode]),
                lanes(&|strip| strip.shapes.translation[2 * modes + mode]),
                lanes(&|strip| strip.shapes.rotation[modes + mode]),
            ]
        };
        Group {
            position: [lanes(&|strip| strip.position.x), lanes(&|strip| strip.position.z)],
            // Forward, so that strips of no size do not meet the air from behind.
            forward: [lanes_or(&|strip| strip.forward.x, 1.0), lanes(&|strip| strip.forward.z)],
            drag_area: lanes(&|strip| strip.profile_drag * strip.semichord * strip.width),
            shapes: (0..modes).map(shape).collect(),
        }
    }

    /// Adds the drag of the strips at a place; returns U.
    #[inline(always)]
    fn add_drag<S: Simd>(&self, place: Place<S>, around: &Surroundings, sums: &mut StripSums) -> Lanes<S> {
        let zero = place.splat(0.0);
        let [mut x, mut z] = [place.load(&self.position[0]), place.load(&self.position[1])];
        let [at_rest_x, at_rest_z] = [x, z];
        let (mut turn, mut moving_x, mut moving_z) = (zero, zero, zero);
        for (shape, (&q, &q_dot)) in self.shapes.iter().zip(around.q.iter().zip(around.q_dot)) {
            let [along_x, along_z, about_y] =
                [place.load(&shape[0]), place.load(&shape[1]), place.load(&shape[2])];
            x += along_x * q;
            z += along_z * q;
            turn += about_y * q;
            moving_x += along_x * q_dot;
            moving_z += along_z * q_dot;
        }
        let undeformed =
            LaneVector { x: place.load(&self.forward[0]), y: zero, z: place.load(&self.forward[1]) };
        let forward = Rotation::new(LaneVector { x: zero, y: turn, z: zero }).apply(&undeformed);
        let (velocity, pitch_rate) = (around.airspeed, around.rate.y);
        let velocity_x = moving_x + z * pitch_rate + place.splat(velocity.x);
        let velocity_z = moving_z - x * pitch_rate + place.splat(velocity.z);
        let chordwise = forward.x * velocity_x + forward.z * velocity_z;
        let drag = place.load(&self.drag_area) * around.density * chordwise.abs() * chordwise;
        let (force_x, force_z) = (-(drag * forward.x), -(drag * forward.z));

        let [arm_x, arm_z] = if around.deformed_arms { [x, z] } else { [at_rest_x, at_rest_z] };
        let mut rows = sums.rows();
        if around.freedom == RigidFreedom::InPlane {
            let forces = [force_x, force_z, arm_z * force_x - arm_x * force_z];
            for (force, row) in forces.into_iter().zip(&mut rows) {
                row.add_force(place, force);
            }
        }
        for (shape, row) in self.shapes.iter().zip(rows) {
            row.add_force(place, place.load(&shape[0]) * force_x + place.load(&shape[1]) * force_z);
        }
        chordwise
    }
}
