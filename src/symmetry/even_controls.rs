//! Under which angles of its controls an aircraft with a mirror plane stays its own mirror image.
//!
//! [theory: symmetry.controls]
//!
//! Two flaps that are images of each other turn alike where (g_right − s g_left)·u = 0, with u the angles of the controls, g
//! the gains of the flaps, and s = −1 where positive angles mirror into negative ones. A flap on a strip edge-on in the plane is
//! its own image with s = −1. Most flaps say the same; what is left are a few independent conditions on u.

use crate::aircraft::{Flap, FlapEffect};
use crate::math::{are_alike, largest};
use crate::structure::ReducedStrip;

/// Gains that differ by less than this share of the greatest are equal.
const EQUAL: f64 = 1e-9;

/// Independent conditions on the angles of the controls.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EvenControls {
    conditions: Vec<Condition>,
}

/// Σ factor · angle = 0, over controls and their factors.
#[derive(Clone, Debug, PartialEq)]
struct Condition(Vec<(usize, f64)>);

impl EvenControls {
    /// Of strips and their images, with s for each.
    pub fn new<'a>(images: impl Iterator<Item = (&'a ReducedStrip, &'a ReducedStrip, f64)>) -> Self {
        EvenControls::of_rows(images.flat_map(|(strip, image, sign)| rows(strip, image, sign)).collect())
    }

    /// That each row of factors, one for each control, times the angles is 0.
    pub(super) fn of_rows(rows: Vec<Vec<f64>>) -> Self {
        let least = EQUAL * largest(rows.iter().flatten().copied());
        EvenControls { conditions: independent(rows, least) }
    }

    /// Whether there is none: the controls act alike on both sides whatever their angles.
    pub fn are_met_by_all(&self) -> bool {
        self.conditions.is_empty()
    }

    /// Whether the conditions hold a control at 0, whatever the others do.
    pub fn hold_at_zero(&self, control: usize) -> bool {
        self.conditions.iter().any(|Condition(terms)| matches!(terms[..], [(only, _)] if only == control))
    }

    /// Whether a control alone acts alike on both sides.
    pub fn leave_free(&self, control: usize) -> bool {
        self.conditions.iter().all(|Condition(terms)| terms.iter().all(|(other, _)| *other != control))
    }

    /// The terms of each condition: controls and their factors.
    pub fn terms(&self) -> impl Iterator<Item = &[(usize, f64)]> {
        self.conditions.iter().map(|Condition(terms)| &terms[..])
    }

    /// For each condition the sum of its terms, and that of their magnitudes, at given angles.
    pub fn sums(&self, angle: impl Fn(usize) -> f64) -> impl Iterator<Item = [f64; 2]> {
        self.conditions.iter().map(move |Condition(terms)| {
            terms.iter().fold([0.0; 2], |[sum, size], &(control, factor)| {
                let term = factor * angle(control);
                [sum + term, size + term.abs()]
            })
        })
    }
}

/// What two strips that are images of each other, or one that is its own, ask of the controls.
fn rows(strip: &ReducedStrip, image: &ReducedStrip, sign: f64) -> Vec<Vec<f64>> {
    match (&strip.flap, &image.flap) {
        (Some(flap), Some(other)) if do_alike(flap, other) => {
            vec![flap.gains.iter().zip(&other.gains).map(|(gain, other)| gain - sign * other).collect()]
        }
        // Flaps that do not mirror each other have to rest.
        (flap, other) => [flap, other].into_iter().flatten().map(|flap| flap.gains.clone()).collect(),
    }
}

/// Whether two flaps make the same of an angle.
fn do_alike(flap: &Flap, other: &Flap) -> bool {
    let [one, other] = [flap, other].map(|flap| {
        let FlapEffect { moment, .. } = FlapEffect::new(flap);
        [flap.lift_slope, flap.hinge, moment, flap.drag]
    });
    one.into_iter().zip(other).all(|(one, other)| are_alike(one, other, EQUAL))
}

/// Conditions that say the same as some rows of factors, each with a control of its own whose factor is 1; factors up to
/// `least` are 0.
fn independent(mut rows: Vec<Vec<f64>>, least: f64) -> Vec<Condition> {
    let mut reduced: Vec<(usize, Vec<f64>)> = Vec::new();
    while let Some((index, pivot)) = greatest_factor(&rows, least) {
        let mut row = rows.swap_remove(index);
        let scale = row[pivot];
        row.iter_mut().for_each(|factor| *factor /= scale);
        let others = rows.iter_mut().map(|other| (other, least));
        for (other, least) in others.chain(reduced.iter_mut().map(|(_, other)| (other, EQUAL))) {
            let multiple = other[pivot];
            for (factor, part) in other.iter_mut().zip(&row) {
                *factor -= multiple * part;
                *factor = if factor.abs() <= least { 0.0 } else { *factor };
            }
        }
        reduced.push((pivot, row));
    }
    reduced.sort_by_key(|(pivot, _)| *pivot);
    let terms = |(_, row): (usize, Vec<f64>)| {
        Condition(row.into_iter().enumerate().filter(|(_, factor)| factor.abs() > EQUAL).collect())
    };
    reduced.into_iter().map(terms).collect()
}

/// Row and place of the first greatest factor above `least`.
fn greatest_factor(rows: &[Vec<f64>], least: f64) -> Option<(usize, usize)> {
    let (mut place, mut greatest) = (None, least);
    for (index, row) in rows.iter().enumerate() {
        for (control, factor) in row.iter().enumerate().filter(|(_, factor)| factor.is_finite()) {
            if factor.abs() > greatest {
                (place, greatest) = (Some((index, control)), factor.abs());
            }
        }
    }
    place
}

#[cfg(test)]
mod tests {
    use super::*;

    fn even(rows: &[&[f64]]) -> EvenControls {
        EvenControls::of_rows(rows.iter().map(|row| row.to_vec()).collect())
    }

    #[test]
    fn flaps_that_say_the_same_make_one_condition() {
        let found = even(&[&[0.0, -2.0, 0.0], &[0.0, 0.5, 0.0], &[0.0, 0.0, 0.0], &[0.0, -2.0, 1e-12]]);
        assert_eq!(found.conditions, [Condition(vec![(1, 1.0)])]);
        assert!(found.hold_at_zero(1) && found.leave_free(0) && found.leave_free(2));
    }

    #[test]
    fn a_pair_is_free_to_move_together_and_not_alone() {
        let found = even(&[&[1.0, -1.0, 0.0], &[0.3, -0.3, 0.0]]);
        assert_eq!(found.conditions, [Condition(vec![(0, 1.0), (1, -1.0)])]);
        assert!(!found.hold_at_zero(0) && !found.leave_free(0) && found.leave_free(2));
        let sum = |angles: [f64; 3]| found.sums(|control| angles[control]).map(|[sum, _]| sum).next();
        assert_eq!(sum([0.2, 0.2, 5.0]), Some(0.0));
        assert_eq!(sum([0.2, -0.2, 5.0]), Some(0.4));
    }

    #[test]
    fn conditions_that_together_leave_nothing_hold_each_control() {
        let found = even(&[&[1.0, -1.0], &[1.0, 1.0]]);
        assert!(found.hold_at_zero(0) && found.hold_at_zero(1));
        assert!(even(&[]).are_met_by_all() && even(&[&[], &[]]).are_met_by_all());
    }
}
