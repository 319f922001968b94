//! ẋ = A x + B u, y = C x.

use nalgebra::DMatrix;

/// A, B and C.
#[derive(Clone)]
pub struct System(pub [DMatrix<f64>; 3]);

impl System {
    /// With inputs and outputs measured by these.
    pub fn scaled(&self, inputs: &[f64], outputs: &[f64]) -> System {
        let System([a, mut b, mut c]) = self.clone();
        for (mut column, scale) in b.column_iter_mut().zip(inputs) {
            column *= *scale;
        }
        for (mut row, scale) in c.row_iter_mut().zip(outputs) {
            row /= *scale;
        }
        System([a, b, c])
    }
}
