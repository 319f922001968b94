//! The loads and the apparent mass of all strips, and how their wakes change.
//!
//! [theory: air-loads.distribution, air-loads.apparent-mass, inflow.state; thesis §4.1]

use crate::air::MetAir;
use crate::kinematics::Sections;
use crate::math::{Arithmetic, LANES, SquareMatrix, Window, Work};

use super::aerofoil::first_reversed;
use super::all_strips::Strips;
use super::group::{Group, MovingSections};
use super::inflow::{InflowStates, WakeFlow};
use super::inflow_layout::InflowLayout;
use super::sums::StripSums;
use super::surroundings::Surroundings;

/// What the loads of all strips are computed from, and where they go.
pub struct SumLoads<'a, K, A> {
    /// The strips.
    pub strips: &'a Strips,
    /// Where their sections are and how they move.
    pub sections: K,
    /// The state of the aircraft and of the air.
    pub around: &'a Surroundings<'a, A>,
    /// Where the inflow states stand.
    pub layout: &'a InflowLayout,
    /// All states.
    pub state: &'a [f64],
    /// The rates of the inflow states are written here.
    pub rates: &'a mut [f64],
    /// Scratch memory.
    pub sums: &'a mut StripSums,
    /// The forces on ν with all flaps neutral are added to these.
    pub passive: &'a mut [f64],
    /// Those per unit of each factor of the flaps' loads, one row on ν after the other, are added to these.
    pub effects: &'a mut [f64],
    /// The apparent mass is added to this mass matrix of the components that move; of a self-adjoint one only the upper
    /// triangle.
    pub mass: &'a mut SquareMatrix,
}

impl<K: Sections, A: MetAir> Work for SumLoads<'_, K, A> {
    type Output = ();

    #[inline(always)]
    fn with<S: Arithmetic>(self, simd: S) {
        if self.sums.has_equal_rows() { self.sum::<S, true>(simd) } else { self.sum::<S, false>(simd) }
    }
}

impl<K: Sections, A: MetAir> SumLoads<'_, K, A> {
    /// `EQUAL_ROWS` where accelerations are distributed as loads are.
    #[inline(always)]
    fn sum<S: Arithmetic, const EQUAL_ROWS: bool>(self, simd: S) {
        let SumLoads { strips, sections, around, layout, state, rates, sums, passive, effects, mass } = self;
        sums.clear();
        for (index, group) in strips.groups.iter().enumerate() {
            let inflow = layout.of_group(index);
            let (states, mut rates) = (inflow.read(state), inflow.write(rates));
            let hung_on = sections.of_strips(index);
            for window in Window::all(simd) {
                if group.in_plane {
                    let mut moving =
                        group.deform_in_plane::<S, EQUAL_ROWS>(window, (index, &hung_on), around);
                    follow_wake(window, (index, group), around, &mut moving, (&states, &mut rates), sums);
                    group.distribute_in_plane::<S, EQUAL_ROWS>(
                        window,
                        (index, &hung_on),
                        around,
                        &moving,
                        sums,
                    );
                } else {
                    let mut moving = group.deform::<S, EQUAL_ROWS>(window, (index, &hung_on), around);
                    follow_wake(window, (index, group), around, &mut moving, (&states, &mut rates), sums);
                    group.distribute::<S, EQUAL_ROWS>(window, (index, &hung_on), around, &moving, sums);
                }
            }
        }
        let edge_on = strips.edge_on.add_drag(simd, &sections, around, sums);
        sums.reversed = sums.reversed.or(edge_on.map(|strip| strips.count + strip));
        sums.add_to(simd, around.density, (passive, effects), mass);
    }
}

/// Finds the induced velocity of strips and writes the rates of their inflow states; notes reverse flow.
///
/// [theory: inflow.state, air-loads.reverse-flow]
#[inline(always)]
fn follow_wake<S: Arithmetic, Motion>(
    window: Window<S>,
    (index, group): (usize, &Group),
    around: &Surroundings<impl MetAir>,
    MovingSections { flow, .. }: &mut MovingSections<S, Motion>,
    (states, rates): (&InflowStates<&[f64]>, &mut InflowStates<&mut [f64]>),
    sums: &mut StripSums,
) {
    if flow.chordwise.least() <= 0.0 && sums.reversed.is_none() {
        let lane = first_reversed(flow.chordwise, window.load(&group.aerofoil.lift_slope));
        sums.reversed = lane.map(|lane| index * LANES + window.lane(lane));
    }
    let passing = flow.chordwise * window.load(&group.per_semichord);
    let wake = WakeFlow { w3: flow.w3, passing };
    flow.induced = around.inflow.induced_velocity(window, states, flow.w3);
    around.inflow.write_rates(window, states, &wake, rates);
}
