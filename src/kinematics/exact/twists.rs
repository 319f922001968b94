//! The twists of eight sections side by side by unit rates of the generalised coordinates.
//!
//! [theory: geometrically-exact.jacobians]

use crate::math::{Arithmetic, Eight, LANES, LaneVector, Window};

use super::helix::{EightConstants, LaneMatrix, times};
use super::strands::{Part, Strand};

/// Of each mode that moves any of the sections J° and S.
pub type EightTwists = Vec<(usize, [Eight; 6])>;

/// None yet.
pub fn none(constants: &EightConstants) -> EightTwists {
    constants.steps.iter().map(|(mode, _)| (*mode, [Eight::ZERO; 6])).collect()
}

/// Writes what each section adds to the twists of that before it: A Dφ, and C Dφ + A Dλ.
#[inline(always)]
pub fn write_steps<S: Arithmetic>(
    window: Window<S>,
    constants: &EightConstants,
    [tangent, bend]: [&LaneMatrix<S>; 2],
    twists: &mut EightTwists,
) {
    for ((_, step), (_, twist)) in constants.steps.iter().zip(twists) {
        let [slide_x, slide_y, slide_z, turn_x, turn_y, turn_z] = step.each_ref().map(|row| window.load(row));
        let turn = LaneVector { x: turn_x, y: turn_y, z: turn_z };
        let slide = LaneVector { x: slide_x, y: slide_y, z: slide_z };
        let (along, about) = (times(bend, &turn) + times(tangent, &slide), times(tangent, &turn));
        for (row, lanes) in twist.iter_mut().zip([along.x, along.y, along.z, about.x, about.y, about.z]) {
            window.store(row, lanes);
        }
    }
}

/// Sums some rows of the twists along a strand, in their place.
#[inline(always)]
pub fn add_up<const N: usize>(strand: &Strand, rows: [usize; N], twists: &mut [EightTwists]) {
    let [eight, lane] = strand.parent;
    for mode in 0..strand.modes {
        let parent = strand.parent_rows.get(mode).map(|&row| &twists[eight][row].1);
        let mut sums = parent.map_or([0.0; N], |parent| rows.map(|row| parent[row].0[lane]));
        for Part { eight, lanes, rows: of_modes } in &strand.parts {
            let (_, own) = &mut twists[*eight][of_modes[mode]];
            for lane in lanes.clone() {
                for (sum, row) in sums.iter_mut().zip(rows) {
                    let own = &mut own[row].0[lane % LANES];
                    *sum += *own;
                    *own = *sum;
                }
            }
        }
    }
}
