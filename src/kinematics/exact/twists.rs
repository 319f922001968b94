//! The twists of eight sections side by side by unit rates of the generalised coordinates.
//!
//! [theory: geometrically-exact.jacobians]

use crate::math::{Arithmetic, Eight, LANES, LaneVector, Window};

use super::strands::Part;

/// Of each mode that moves any of the sections J° and S.
pub type EightTwists = Vec<(usize, [Eight; 6])>;

/// Dλ and Dφ of each mode that moves any of eight sections.
pub type Steps = Vec<(usize, [Eight; 6])>;

/// None yet.
pub fn none(steps: &Steps) -> EightTwists {
    steps.iter().map(|(mode, _)| (*mode, [Eight::ZERO; 6])).collect()
}

/// Columns of a matrix for each section in a register.
pub type LaneMatrix<S> = [LaneVector<S>; 3];

/// A matrix times vectors.
#[inline(always)]
pub fn times<S: Arithmetic>([x, y, z]: &LaneMatrix<S>, vectors: &LaneVector<S>) -> LaneVector<S> {
    *x * vectors.x + *y * vectors.y + *z * vectors.z
}

/// Writes what each section adds to the twists of that before it: A Dφ, and C Dφ + A Dλ.
#[inline(always)]
pub fn write_steps<S: Arithmetic>(
    window: Window<S>,
    steps: &Steps,
    [tangent, bend]: [&LaneMatrix<S>; 2],
    twists: &mut EightTwists,
) {
    for ((_, step), (_, twist)) in steps.iter().zip(twists) {
        let [slide_x, slide_y, slide_z, turn_x, turn_y, turn_z] = step.each_ref().map(|row| window.load(row));
        let turn = LaneVector { x: turn_x, y: turn_y, z: turn_z };
        let slide = LaneVector { x: slide_x, y: slide_y, z: slide_z };
        let (along, about) = (times(bend, &turn) + times(tangent, &slide), times(tangent, &turn));
        for (row, lanes) in twist.iter_mut().zip([along.x, along.y, along.z, about.x, about.y, about.z]) {
            window.store(row, lanes);
        }
    }
}

/// Sums some rows of the twists along a part of a group, in their place.
#[inline(always)]
pub fn add_up<const N: usize>(part: &Part, rows: [usize; N], twists: &mut [EightTwists], index: usize) {
    let [eight, lane] = part.parent;
    for &(own, before) in &part.rows {
        let before = before.map(|before| &twists[eight][before].1);
        let mut sums = before.map_or([0.0; N], |before| rows.map(|row| before[row].0[lane]));
        let (_, own) = &mut twists[index][own];
        for lane in part.lanes.clone().map(|lane| lane % LANES) {
            for (sum, row) in sums.iter_mut().zip(rows) {
                *sum += own[row].0[lane];
                own[row].0[lane] = *sum;
            }
        }
    }
}
