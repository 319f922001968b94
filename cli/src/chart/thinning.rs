//! Curves with no more points than the eye needs.

/// Curves are thinned until they deviate by this share of the window, about a tenth of a pixel.
const FLATNESS: f64 = 2.5e-4;

/// The curve with fewer points, by the method of Ramer, Douglas and Peucker: no point of the old one is
/// farther than [`FLATNESS`] from the new one, in units of `scale`.
pub fn thinned(points: &[(f64, f64)], scale: (f64, f64)) -> Vec<(f64, f64)> {
    let mut kept = Vec::new();
    let mut open: Vec<(usize, usize)> =
        points.len().checked_sub(1).map(|last| (0, last)).into_iter().collect();
    kept.extend(points.first());
    while let Some((first, last)) = open.pop() {
        let deviations =
            (first + 1..last).map(|i| (i, deviation(points[i], points[first], points[last], scale)));
        match deviations.max_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((middle, deviation)) if deviation > FLATNESS => {
                open.extend([(middle, last), (first, middle)]);
            }
            _ => kept.push(points[last]),
        }
    }
    kept
}

/// Distance of `p` from the segment `a`–`b`, in units of `scale`.
fn deviation(p: (f64, f64), a: (f64, f64), b: (f64, f64), scale: (f64, f64)) -> f64 {
    let from_a = |q: (f64, f64)| ((q.0 - a.0) / scale.0, (q.1 - a.1) / scale.1);
    let ((px, py), (bx, by)) = (from_a(p), from_a(b));
    let length = bx * bx + by * by;
    let along = if length > 0.0 { ((px * bx + py * by) / length).clamp(0.0, 1.0) } else { 0.0 };
    (px - along * bx).hypot(py - along * by)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_the_ends_and_the_shape() {
        let wave = |i: u32| (0.01 * f64::from(i), (0.05 * f64::from(i)).sin());
        let points: Vec<(f64, f64)> = (0..=1500).map(wave).collect();
        let thin = thinned(&points, (15.0, 2.0));
        assert!(thin.len() < points.len() / 3);
        assert_eq!((thin.first(), thin.last()), (points.first(), points.last()));
        for &p in &points {
            let nearest = thin.windows(2).map(|ends| deviation(p, ends[0], ends[1], (15.0, 2.0)));
            assert!(nearest.fold(f64::INFINITY, f64::min) <= FLATNESS);
        }
    }
}
