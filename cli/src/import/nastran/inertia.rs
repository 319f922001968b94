//! Inertias that no body has, mended by the least that can be added [theory: structure.particles].
//!
//! A body has moments that are not negative and of which none is greater than the sum of the others. Decks often give the moment about the
//! beam alone. What is given is kept: of the moments that are too small, their sum grows by what the greatest exceeds it, in whatever
//! direction. Of all directions the one is taken in which aircraft have their masses: along x, as chords and bodies are. So (0, I, 0),
//! of a wing, becomes (0, I, I), which leaves bending of the wing out of its plane as it was; (I, 0, 0), of a body's frame, (I, I/2, I/2).

use nalgebra::{Matrix3, SymmetricEigen, Vector3};

/// Share of the greatest moment by which a body may miss it, for rounding.
const SLACK: f64 = 1e-10;

/// Axes with a smaller share of x than this, the cosine of 60°, are those of chords.
const ACROSS_X: f64 = 0.5;

/// An inertia about the centre of mass as a body has it, or what had to be added to which principal moments.
#[derive(Clone, Debug, PartialEq)]
pub struct Mended {
    pub inertia: Matrix3<f64>,
    /// Principal moments before, ascending; none where nothing was changed.
    pub from: Option<[f64; 3]>,
    pub to: [f64; 3],
}

/// Mends an inertia in body axes; `None` where it has no principal moments, for its numbers are too far apart.
pub fn mend(inertia: &Matrix3<f64>) -> Option<Mended> {
    let (before, axes) = principal(inertia)?;
    let [least, middle, greatest] = before.map(|moment| moment.max(0.0));
    let missing = (greatest - least - middle).max(0.0);
    if missing.max(-before[0]) <= SLACK * before[2].abs() {
        return Some(Mended { inertia: *inertia, from: None, to: before });
    }
    let moments = Matrix3::from_diagonal(&Vector3::new(least, middle, greatest));
    let mended = axes * moments * axes.transpose() + spread(&axes.column(2).into_owned()) * missing;
    let (to, _) = principal(&mended)?;
    Some(Mended { inertia: 0.5 * (mended + mended.transpose()), from: Some(before), to })
}

/// Principal moments, ascending, and their axes as columns.
fn principal(inertia: &Matrix3<f64>) -> Option<([f64; 3], Matrix3<f64>)> {
    let eigen = SymmetricEigen::try_new(*inertia, f64::EPSILON, 1000)?;
    let mut order = [0, 1, 2];
    order.sort_by(|&one, &other| eigen.eigenvalues[one].total_cmp(&eigen.eigenvalues[other]));
    let axes = order.map(|place| eigen.eigenvectors.column(place).into_owned());
    Some((order.map(|place| eigen.eigenvalues[place]), Matrix3::from_columns(&axes)))
}

/// What is added across the axis of the greatest moment, with a trace of 1: about the direction across x too, else about both alike.
fn spread(axis: &Vector3<f64>) -> Matrix3<f64> {
    if axis.x.abs() < ACROSS_X {
        let about = axis.cross(&Vector3::x()).normalize();
        return about * about.transpose();
    }
    0.5 * (Matrix3::identity() - axis * axis.transpose())
}

#[cfg(test)]
mod tests {
    use nalgebra::Rotation3;

    use super::*;

    fn mended(moments: [f64; 3]) -> Matrix3<f64> {
        mend(&Matrix3::from_diagonal(&Vector3::from(moments))).unwrap().inertia
    }

    #[track_caller]
    fn is(found: Matrix3<f64>, moments: [f64; 3]) {
        assert!((found - Matrix3::from_diagonal(&Vector3::from(moments))).norm() < 1e-12, "{found}");
    }

    #[test]
    fn the_moment_that_is_given_is_kept_and_mass_lies_along_x() {
        is(mended([0.0, 8.0, 0.0]), [0.0, 8.0, 8.0]);
        is(mended([0.0, 0.0, 8.0]), [0.0, 8.0, 8.0]);
        is(mended([8.0, 0.0, 0.0]), [8.0, 4.0, 4.0]);
        is(mended([1.0, 2.0, 4.0]), [1.0, 3.0, 4.0]);
        is(mended([-1.0, 3.0, 3.0]), [0.0, 3.0, 3.0]);
    }

    #[test]
    fn what_a_body_has_keeps_its_bits() {
        let inertia = Matrix3::new(3.0, 0.2, 0.1, 0.2, 4.0, 0.3, 0.1, 0.3, 5.0);
        assert_eq!(mend(&inertia).unwrap(), Mended { inertia, from: None, to: mend(&inertia).unwrap().to });
        assert_eq!(mended([0.0; 3]), Matrix3::zeros());
        assert_eq!(mended([1.0, 1.0, 2.0]), Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 2.0)));
    }

    /// However it is turned: a body has it, no moment about any axis is less than it was, and the sum grows by what is missing, without
    /// which no body has it: its second moment along the axis of the greatest moment is less than 0.
    #[test]
    fn the_sum_of_what_is_added_is_the_least_however_the_axes_are_turned() {
        for turn in 0..50 {
            let turned = Rotation3::from_euler_angles(
                0.7 * f64::from(turn),
                0.3 * f64::from(turn),
                1.1 * f64::from(turn),
            );
            let before = turned * Matrix3::from_diagonal(&Vector3::new(0.5, 1.5, 4.0)) * turned.transpose();
            let found = mend(&before).unwrap();
            let added = found.inertia - before;
            assert!((added.trace() - 2.0).abs() < 1e-12, "{added}");
            assert!(added.symmetric_eigenvalues().min() > -1e-12, "{added}");
            let along = Matrix3::identity() * (0.5 * found.inertia.trace()) - found.inertia;
            assert!(along.symmetric_eigenvalues().min() > -1e-12, "{along}");
            assert!((found.to[2] - 4.0).abs() < 1e-12 && (found.to[0] + found.to[1] - 4.0).abs() < 1e-12);
        }
    }
}
