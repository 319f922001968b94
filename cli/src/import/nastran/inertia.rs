//! Inertias that no body has, mended by the least change [theory: structure.particles].
//!
//! A body has moments that are not negative and of which none is greater than the sum of the others. Decks often give the pitching
//! moment alone. What is given is kept: the moments that are too small grow, by as little as there is in the sum of squares.

use nalgebra::{Matrix3, SymmetricEigen, Vector3};

/// Share of the greatest moment by which a body may miss it, for rounding.
const SLACK: f64 = 1e-10;

/// An inertia about the centre of mass as a body has it, or what had to be added to which principal moments.
#[derive(Clone, Debug, PartialEq)]
pub struct Mended {
    pub inertia: Matrix3<f64>,
    /// Principal moments before, ascending; none where nothing was changed.
    pub from: Option<[f64; 3]>,
    pub to: [f64; 3],
}

/// Mends an inertia; `None` where it has no principal moments, for its numbers are too far apart.
pub fn mend(inertia: &Matrix3<f64>) -> Option<Mended> {
    let eigen = SymmetricEigen::try_new(*inertia, f64::EPSILON, 1000)?;
    let mut order = [0, 1, 2];
    order.sort_by(|&one, &other| eigen.eigenvalues[one].total_cmp(&eigen.eigenvalues[other]));
    let before = order.map(|place| eigen.eigenvalues[place]);
    let after = grown(before);
    let is_kept =
        std::iter::zip(before, after).all(|(one, other)| (other - one).abs() <= SLACK * before[2].abs());
    if is_kept {
        return Some(Mended { inertia: *inertia, from: None, to: before });
    }
    let mut moments = Vector3::zeros();
    for (place, moment) in order.into_iter().zip(after) {
        moments[place] = moment;
    }
    let axes = eigen.eigenvectors;
    let mended = axes * Matrix3::from_diagonal(&moments) * axes.transpose();
    Some(Mended { inertia: 0.5 * (mended + mended.transpose()), from: Some(before), to: after })
}

/// The nearest moments that a body has and of which none is less than it was; ascending ones.
fn grown(moments: [f64; 3]) -> [f64; 3] {
    let [least, middle, greatest] = moments.map(|moment| moment.max(0.0));
    let missing = (greatest - least - middle).max(0.0);
    // Both grow alike: the sum of squares of what is added to reach a sum is least then.
    [least + 0.5 * missing, middle + 0.5 * missing, greatest]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mended(moments: [f64; 3]) -> Matrix3<f64> {
        mend(&Matrix3::from_diagonal(&Vector3::from(moments))).unwrap().inertia
    }

    #[test]
    fn the_moment_that_is_given_is_kept() {
        let found = mended([0.0, 8.0, 0.0]);
        assert!((found - Matrix3::from_diagonal(&Vector3::new(4.0, 8.0, 4.0))).norm() < 1e-12, "{found}");
        let found = mended([1.0, 2.0, 4.0]);
        assert!((found - Matrix3::from_diagonal(&Vector3::new(1.5, 2.5, 4.0))).norm() < 1e-12, "{found}");
        let found = mended([-1.0, 3.0, 3.0]);
        assert!((found - Matrix3::from_diagonal(&Vector3::new(0.0, 3.0, 3.0))).norm() < 1e-12, "{found}");
    }

    #[test]
    fn what_a_body_has_keeps_its_bits() {
        let inertia = Matrix3::new(3.0, 0.2, 0.1, 0.2, 4.0, 0.3, 0.1, 0.3, 5.0);
        assert_eq!(mend(&inertia).unwrap(), Mended { inertia, from: None, to: mend(&inertia).unwrap().to });
        assert_eq!(mended([0.0; 3]), Matrix3::zeros());
        assert_eq!(mended([1.0, 1.0, 2.0]), Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 2.0)));
    }

    /// No smaller growth does: of all that lead to a body, tried on a grid, none has a smaller sum of squares.
    #[test]
    fn the_change_is_the_least() {
        let before: [f64; 3] = [0.5, 1.5, 4.0];
        let after = grown(before);
        let size =
            |to: [f64; 3]| std::iter::zip(before, to).map(|(one, other)| (other - one).powi(2)).sum::<f64>();
        for i in 0..200 {
            for j in 0..200 {
                let to = [before[0] + 0.02 * f64::from(i), before[1] + 0.02 * f64::from(j), before[2]];
                if to[0] + to[1] >= to[2] {
                    assert!(size(to) >= size(after) - 1e-12, "{to:?}");
                }
            }
        }
    }
}
