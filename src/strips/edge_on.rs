//! Drag of strips that symmetric flow meets edge-on: fins and the sides of the body.
//!
//! [theory: symmetry.edge-on, air-loads.drag; thesis §4.1]
//!
//! They lie in the mirror plane with their normals across it. While all motion is in the plane, w, Ω and λ₀ vanish,
//! V_s is (f·V) f, and of the loads only D₀ = CD0 ρ b |V_s| V_s remains. Everything here is in x and z.

use crate::air::MetAir;
use crate::kinematics::{RigidFreedom, Sections, SectionsInPlane, Turn};
use crate::math::{Arithmetic, Arrow, Eight, LANES, Lanes, PlaneVector, Window};
use crate::structure::ReducedStrip;

use super::aerofoil::first_reversed;
use super::in_plane::flow_past;
use super::sums::StripSums;
use super::surroundings::Surroundings;

/// Eight strips.
#[derive(Clone, Debug)]
pub struct EdgeOnGroup {
    /// f: x and z.
    forward: [Eight; 2],
    /// b and d, m.
    chords: [Eight; 2],
    /// CD0 b Δy, m².
    drag_area: Eight,
    /// CLα of strips that would lift, were they not edge-on, 1/rad.
    lift_slope: Eight,
}

/// All strips edge-on.
#[derive(Clone, Debug, Default)]
pub struct EdgeOnStrips {
    groups: Vec<EdgeOnGroup>,
}

impl EdgeOnStrips {
    /// Some strips.
    pub fn new(strips: &[ReducedStrip]) -> Self {
        EdgeOnStrips { groups: strips.chunks(LANES).map(EdgeOnGroup::new).collect() }
    }

    /// In groups of eight.
    pub fn groups(&self) -> impl Iterator<Item = &EdgeOnGroup> {
        self.groups.iter()
    }

    /// Adds the drag to the sums; returns the first strip that would lift and meets the air from behind.
    #[inline(always)]
    pub fn add_drag<S: Arithmetic>(
        &self,
        simd: S,
        sections: &impl Sections,
        around: &Surroundings<impl MetAir>,
        sums: &mut StripSums,
    ) -> Option<usize> {
        let mut reversed = None;
        for (index, group) in self.groups.iter().enumerate() {
            let sections = sections.edge_on(index);
            for window in Window::all(simd) {
                let chordwise = group.add_drag(window, (index, &sections), around, sums);
                if chordwise.least() <= 0.0 && reversed.is_none() {
                    let lane = first_reversed(chordwise, window.load(&group.lift_slope));
                    reversed = lane.map(|lane| index * LANES + window.lane(lane));
                }
            }
        }
        reversed
    }
}

impl EdgeOnGroup {
    fn new(strips: &[ReducedStrip]) -> Self {
        EdgeOnGroup {
            // Forward, so that strips of no size do not meet the air from behind.
            forward: [
                Eight::of(strips, |strip| strip.forward.x, 1.0),
                Eight::of(strips, |strip| strip.forward.z, 0.0),
            ],
            chords: [
                Eight::of(strips, |strip| strip.semichord, 1.0),
                Eight::of(strips, |strip| strip.elastic_axis_aft_of_midchord, 0.0),
            ],
            drag_area: Eight::of(strips, |strip| strip.profile_drag * strip.semichord * strip.width, 0.0),
            lift_slope: Eight::of(strips, |strip| strip.lift_slope, 0.0),
        }
    }

    /// f: x and z.
    pub fn forward(&self) -> [&Eight; 2] {
        self.forward.each_ref()
    }

    /// b and d, m.
    pub fn chords(&self) -> [&Eight; 2] {
        self.chords.each_ref()
    }

    /// Adds the drag of the strips in a window; returns U.
    #[inline(always)]
    fn add_drag<S: Arithmetic>(
        &self,
        window: Window<S>,
        (index, sections): (usize, &impl SectionsInPlane),
        around: &Surroundings<impl MetAir>,
        sums: &mut StripSums,
    ) -> Lanes<S> {
        let motion = sections.motion(window);
        let forward = motion.turn.apply(&PlaneVector::load(window, self.forward.each_ref()));
        let gust = around.gust.map(|gust| gust.edge_on(index));
        let chordwise = forward.dot(&flow_past(window, &motion, around, gust).velocity);
        let drag = window.load(&self.drag_area) * around.density * chordwise.abs() * chordwise;
        let force = forward * -drag;

        let mut rows = sums.rows();
        if around.freedom == RigidFreedom::InPlane {
            let arm = if around.deformed_arms { motion.position } else { sections.at_rest(window) };
            for (force, row) in [force.x, force.z, arm.cross(&force)].into_iter().zip(&mut rows) {
                row.add_force(window, force);
            }
        }
        for ([x, z, _], row) in sections.rows(rows) {
            row.add_force(window, PlaneVector::load(window, [x, z]).dot(&force));
        }
        chordwise
    }
}
