//! Drag of strips that symmetric flow meets edge-on: fins and the sides of the body.
//!
//! [theory: symmetry.edge-on, air-loads.drag; thesis §4.1]
//!
//! They lie in the mirror plane with their normals across it. While all motion is in the plane, w, Ω and λ₀ vanish,
//! V_s is (f·V) f, and of the loads only D₀ = CD0 ρ b |V_s| V_s remains. Everything here is in x and z.

use crate::kinematics::RigidFreedom;
use crate::math::{Arithmetic, Arrow, Eight, LANES, Lanes, Place, PlaneVector};
use crate::structure::ReducedStrip;

use super::group::{Surroundings, first_reversed};
use super::in_plane::PlaneMotion;
use super::sums::StripSums;

/// Eight strips.
#[derive(Clone, Debug)]
struct Group {
    /// x and z.
    position: [Eight; 2],
    /// f: x and z.
    forward: [Eight; 2],
    /// CD0 b Δy, m².
    drag_area: Eight,
    /// CLα of strips that would lift, were they not edge-on, 1/rad.
    lift_slope: Eight,
    /// Ψᵘ_x, Ψᵘ_z, Ψᵠ_y of each mode.
    shapes: Vec<[Eight; 3]>,
}

/// All strips edge-on.
#[derive(Clone, Debug, Default)]
pub struct EdgeOnStrips {
    groups: Vec<Group>,
}

impl EdgeOnStrips {
    /// Strips with the shapes of so many modes.
    pub fn new(strips: &[ReducedStrip], modes: usize) -> Self {
        EdgeOnStrips { groups: strips.chunks(LANES).map(|strips| Group::new(strips, modes)).collect() }
    }

    /// Adds the drag to the sums; returns the first strip that would lift and meets the air from behind.
    #[inline(always)]
    pub fn add_drag<S: Arithmetic>(
        &self,
        simd: S,
        around: &Surroundings,
        sums: &mut StripSums,
    ) -> Option<usize> {
        let mut reversed = None;
        for (index, group) in self.groups.iter().enumerate() {
            for place in Place::all(simd) {
                let chordwise = group.add_drag(place, around, sums);
                if chordwise.least() <= 0.0 && reversed.is_none() {
                    let lane = first_reversed(chordwise, place.load(&group.lift_slope));
                    reversed = lane.map(|lane| index * LANES + place.lane(lane));
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
            lift_slope: lanes(&|strip| strip.lift_slope),
            shapes: (0..modes).map(shape).collect(),
        }
    }

    /// Adds the drag of the strips at a place; returns U.
    #[inline(always)]
    fn add_drag<S: Arithmetic>(
        &self,
        place: Place<S>,
        around: &Surroundings,
        sums: &mut StripSums,
    ) -> Lanes<S> {
        let at_rest = PlaneVector::load(place, self.position.each_ref());
        let undeformed = PlaneVector::load(place, self.forward.each_ref());
        let shapes = self.shapes.iter().map(<[Eight; 3]>::each_ref);
        let PlaneMotion { position, forward, velocity, .. } =
            PlaneMotion::new(place, [at_rest, undeformed], shapes, around);
        let chordwise = forward.dot(&velocity);
        let drag = place.load(&self.drag_area) * around.density * chordwise.abs() * chordwise;
        let force = forward * -drag;

        let mut rows = sums.rows();
        if around.freedom == RigidFreedom::InPlane {
            let arm = if around.deformed_arms { position } else { at_rest };
            for (force, row) in [force.x, force.z, arm.cross(&force)].into_iter().zip(&mut rows) {
                row.add_force(place, force);
            }
        }
        for ([x, z, _], row) in self.shapes.iter().zip(rows) {
            row.add_force(place, PlaneVector::load(place, [x, z]).dot(&force));
        }
        chordwise
    }
}
