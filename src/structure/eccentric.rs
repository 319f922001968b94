//! What an element whose section couples bending, torsion and stretch, or has axes apart, does besides a plain one.
//!
//! [theory: coupled-sections.element]
//!
//! All of it in local axes. Symbols: (y_t, z_t) `tension`, (y_s, z_s) `shear`, k `stretch_by_twist`, c `bulge`.

use nalgebra::SMatrix;

use crate::aircraft::{Beam, Coupling};

use super::nodal::{NodalMap, NodalRow};

/// Six displacement gradients, each a linear form on twelve unknowns: u′, v′, w′, φ′, v″, w″.
pub(super) type GradientRows = SMatrix<f64, 6, 12>;

/// The arms from the reference axis to the lines that stretch and that twist, and the twist that bending makes within.
#[derive(Clone, Debug)]
pub(super) struct Eccentric {
    length: f64,
    tension: [f64; 2],
    shear: [f64; 2],
    stretch_by_twist: f64,
    /// What the lines do at both ends by what the nodes do.
    ends: SMatrix<f64, 12, 12>,
    /// c, by what the lines do at both ends.
    bulge: NodalRow,
}

impl Eccentric {
    /// Of a beam, if it departs from a plain one; `curvatures` are those of the lines at both ends of the element.
    pub fn of(beam: &Beam, length: f64, curvatures: [&GradientRows; 2]) -> Option<Self> {
        let Coupling { bend_twist: [along_w, along_v], stretch_by_twist, tension_axis, shear_centre, .. } =
            beam.coupling;
        if beam.coupling.is_none() {
            return None;
        }
        let linear_part = |row: usize| (curvatures[0].row(row) - curvatures[1].row(row)).transpose() * 0.5;
        let torque = linear_part(5) * along_w + linear_part(4) * along_v;
        let ([y_t, z_t], [y_s, z_s]) = (tension_axis, shear_centre);
        let mut ends = SMatrix::identity();
        for u in [0, 6] {
            let phi = u + 3;
            ends[(u, phi)] = stretch_by_twist;
            ends[(u, phi + 1)] = z_t;
            ends[(u, phi + 2)] = -y_t;
            ends[(u + 1, phi)] = -z_s;
            ends[(u + 2, phi)] = y_s;
        }
        Some(Eccentric {
            length,
            tension: tension_axis,
            shear: shear_centre,
            stretch_by_twist,
            ends,
            bulge: torque / -beam.torsional_stiffness,
        })
    }

    /// From displacement and rotation of the lines at a fraction of the length, by what they do at the ends, to those of the section at
    /// the reference axis, by what the nodes do.
    pub fn section(
        &self,
        fraction: f64,
        mut displacement: NodalMap,
        mut rotation: NodalMap,
    ) -> (NodalMap, NodalMap) {
        let height = self.length * fraction * (1.0 - fraction);
        let twist = rotation.row(0) + self.bulge.transpose() * height;
        rotation.row_mut(0).copy_from(&twist);
        let ([y_t, z_t], [y_s, z_s]) = (self.tension, self.shear);
        let along = rotation.row(2) * y_t - rotation.row(1) * z_t - rotation.row(0) * self.stretch_by_twist;
        let across = [rotation.row(0) * z_s, rotation.row(0) * -y_s];
        for (axis, back) in [along, across[0], across[1]].into_iter().enumerate() {
            let moved = displacement.row(axis) + back;
            displacement.row_mut(axis).copy_from(&moved);
        }
        (displacement * self.ends, rotation * self.ends)
    }

    /// The gradients of the lines by what the nodes do.
    pub fn gradients(&self, fraction: f64, mut rows: GradientRows) -> GradientRows {
        let twist = rows.row(3) + self.bulge.transpose() * (1.0 - 2.0 * fraction);
        rows.row_mut(3).copy_from(&twist);
        rows * self.ends
    }
}
