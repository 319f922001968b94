//! Displacements and rotations as sums of mode shapes [theory: frames.displacement; thesis eq. 2.2].

use nalgebra::Vector3;

/// Row-major 3 × n times q.
pub fn combine(rows: &[f64], q: &[f64]) -> Vector3<f64> {
    let (x, others) = rows.split_at(q.len());
    let (y, z) = others.split_at(q.len());
    let mut sum = Vector3::zeros();
    for (((x, y), z), q) in x.iter().zip(y).zip(z).zip(q) {
        sum += Vector3::new(*x, *y, *z) * *q;
    }
    sum
}
