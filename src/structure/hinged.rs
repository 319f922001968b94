//! An element that turns on springs against its first node: the angles follow from its unknowns [theory: coupled-sections.hinge].

use nalgebra::{Cholesky, DMatrix, SMatrix, SVector, Vector3};

use crate::aircraft::Hinge;

use super::nodal::NodalRow;

/// The hinge at the beginning of an element; all forms are on the nodal unknowns in body axes.
#[derive(Clone, Debug)]
pub(super) struct Hinged {
    /// What the ends of the element do by what the nodes do: 1 + B θ.
    pub ends: SMatrix<f64, 12, 12>,
    /// The angle of each spring, and its stiffness, N·m/rad.
    pub springs: Vec<(NodalRow, f64)>,
}

impl Hinged {
    /// Of a hinge and the stiffness of the element beyond it. `None` where there is none, or where no angle balances it: of no
    /// stiffness that is positive.
    pub fn of(hinge: &Hinge, stiffness: &SMatrix<f64, 12, 12>) -> Option<Self> {
        let axes: Vec<SVector<f64, 12>> =
            hinge.springs.iter().map(|spring| turn_of_the_root(&spring.axis)).collect();
        let moments: Vec<SVector<f64, 12>> = axes.iter().map(|axis| stiffness * axis).collect();
        let held = DMatrix::from_fn(axes.len(), axes.len(), |i, j| {
            let spring = if i == j { hinge.springs[i].stiffness } else { 0.0 };
            spring + axes[i].dot(&moments[j])
        });
        let flexibility = Cholesky::new(held)?.inverse();
        let mut ends = SMatrix::identity();
        let mut springs = Vec::with_capacity(axes.len());
        for (i, axis) in axes.iter().enumerate() {
            let mut angle = NodalRow::zeros();
            for (j, moment) in moments.iter().enumerate() {
                angle -= moment * flexibility[(i, j)];
            }
            ends += axis * angle.transpose();
            springs.push((angle, hinge.springs[i].stiffness));
        }
        Some(Hinged { ends, springs })
    }
}

/// A unit rotation of an element's first end.
fn turn_of_the_root(axis: &Vector3<f64>) -> SVector<f64, 12> {
    let mut turn = SVector::<f64, 12>::zeros();
    turn.fixed_rows_mut::<3>(3).copy_from(axis);
    turn
}
