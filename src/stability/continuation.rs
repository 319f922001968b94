//! Following one root along a path of problems [theory: stability.continuation].

use std::sync::Arc;

use super::condensed::{Condensed, Root};

/// Shapes of neighbouring roots that agree less than this are not taken for one root.
const SAME_SHAPE: f64 = 0.95;

/// Steps smaller than this part of the path are not tried.
const SMALLEST_STEP: f64 = 1.0 / 1024.0;

/// How far a root could be followed that ends on the way.
pub(super) struct Ended {
    /// From 0 to 1.
    pub place: f64,
    /// There.
    pub root: Root,
}

/// Follows a root from the beginning (0) of a path to its end (1), in steps of at most `largest_step`; smaller
/// ones where the shape changes fast.
///
/// # Errors
/// When the path or the root ends on the way: two roots that meet, such as a pair that becomes real, have no continuation.
pub(super) fn follow(
    start: &Root,
    largest_step: f64,
    mut path: impl FnMut(f64) -> Option<Arc<Condensed>>,
) -> Result<Root, Ended> {
    let mut root = start.clone();
    let (mut place, mut step) = (0.0_f64, largest_step);
    while place < 1.0 {
        let target = (place + step).min(1.0);
        let next = path(target).and_then(|problem| {
            let next = problem.refine(&root)?;
            (problem.agreement(&root, &next) > SAME_SHAPE).then_some(next)
        });
        if let Some(next) = next {
            (root, place) = (next, target);
            step = (2.0 * step).min(largest_step);
        } else if step > SMALLEST_STEP {
            step *= 0.5;
        } else {
            return Err(Ended { place, root });
        }
    }
    Ok(root)
}
