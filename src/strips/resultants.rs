//! What acts on each strip by itself: force and moment at its elastic axis, all of it, one strip after the other.
//!
//! [theory: section-loads.pieces, air-loads.lift, air-loads.moment, air-loads.apparent-mass, air-loads.flap-products]
//!
//! In the equations of motion the accelerations stand on the left-hand side, as apparent mass. Here they are known, and their
//! parts of ẇ and Ω̇ are added to the drifts: the formulas of the aerofoil then give the whole of lift and moment.

use nalgebra::Vector3;
use pulp::Scalar;

use crate::air::MetAir;
use crate::kinematics::{GeneralisedVector, Sections, SectionsInSpace};
use crate::math::{Arrow, Eight, LANES, LaneVector, Lanes, Window};

use super::all_strips::Strips;
use super::flap_factor::FlapFactor;
use super::group::{Group, MovingSections};
use super::in_space::SpaceMotion;
use super::inflow_layout::InflowLayout;
use super::surroundings::Surroundings;

/// What acts at a place of the aircraft, body axes.
#[derive(Clone, Copy, Debug)]
pub struct Resultant {
    /// m.
    pub position: Vector3<f64>,
    /// N.
    pub force: Vector3<f64>,
    /// About the place, N·m.
    pub moment: Vector3<f64>,
}

/// The state of the aircraft in which the resultants are asked for.
pub struct Accelerated<'a> {
    /// All states.
    pub state: &'a [f64],
    /// Where the inflow states stand.
    pub layout: &'a InflowLayout,
    /// ν̇.
    pub accelerations: GeneralisedVector<'a>,
    /// Of the controls, rad.
    pub angles: &'a [f64],
}

impl Strips {
    /// Tells what acts on each strip, in their order, those edge-on left out.
    pub fn tell_resultants(
        &self,
        sections: &impl Sections,
        around: &Surroundings<impl MetAir>,
        at: &Accelerated,
        mut tell: impl FnMut(usize, Resultant),
    ) {
        for (index, group) in self.groups.iter().enumerate() {
            let hung_on = sections.of_strips(index);
            for window in Window::all(Scalar::new()) {
                let strip = index * LANES + window.lane(0);
                if strip < self.count {
                    tell(strip, group.resultant(window, (index, &hung_on), around, at, &self.factors));
                }
            }
        }
    }
}

impl Group {
    /// What acts on the strip in a window.
    fn resultant(
        &self,
        window: Window<Scalar>,
        (index, sections): (usize, &impl SectionsInSpace),
        around: &Surroundings<impl MetAir>,
        at: &Accelerated,
        factors: &[FlapFactor],
    ) -> Resultant {
        let MovingSections { motion, mut flow } =
            self.deform::<Scalar, false>(window, (index, sections), around);
        let states = at.layout.of_group(index).read(at.state);
        flow.induced = around.inflow.induced_velocity(window, &states, flow.w3);
        let SpaceMotion { forward, span, normal, zero_lift_normal, position } = &motion;
        let [acceleration, angular] = accelerations(window, sections, position, &at.accelerations);
        flow.upwash_drift += zero_lift_normal.dot(&acceleration);
        flow.pitch_drift += span.dot(&angular);

        let aerofoil = self.aerofoil.at(window);
        let loads = self.section_loads(window, &aerofoil, &flow);
        let flaps = self.section_flap_loads(window, &aerofoil, &flow);
        let sum = |gains: &[(usize, Eight)]| {
            gains.iter().fold(window.splat(0.0), |sum, (factor, gain)| {
                sum + window.load(gain) * factors[*factor].value(at.angles)
            })
        };
        let (angle, squared) = (sum(&self.gains), sum(&self.squared_gains));
        let width = window.load(&self.width);
        let along = (loads.forward + flaps.forward * angle - flaps.drag * squared) * width;
        let mut down = loads.down + flaps.down * angle;
        if let Some(across) = flaps.drag_across {
            down = down - across * squared;
        }
        let down = down * width;
        let pitching = (loads.pitching + flaps.pitching * angle) * width;
        Resultant {
            position: position.vector(),
            force: (*forward * along + *normal * down).vector(),
            moment: (*span * pitching).vector(),
        }
    }
}

/// v̇ + ω̇×X + J q̈ and ω̇ + S q̈: how G_m and G_Ω are accelerated, before m and s are applied.
fn accelerations(
    window: Window<Scalar>,
    sections: &impl SectionsInSpace,
    position: &LaneVector<Scalar>,
    GeneralisedVector { translation, rotation, modal }: &GeneralisedVector,
) -> [LaneVector<Scalar>; 2] {
    let mut angular = LaneVector::splat(window, rotation);
    let mut acceleration = LaneVector::splat(window, translation) + angular.cross(position);
    for (rows, q_ddot) in sections.rows(modal.iter()) {
        let [jx, jy, jz, sx, sy, sz]: [Lanes<Scalar>; 6] =
            std::array::from_fn(|row| window.load(&rows[row]) * *q_ddot);
        acceleration = acceleration + LaneVector { x: jx, y: jy, z: jz };
        angular = angular + LaneVector { x: sx, y: sy, z: sz };
    }
    [acceleration, angular]
}
