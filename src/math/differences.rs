//! Derivatives from differences of a function's values on both sides of a place [theory: linearisation.differences, trim.tangent].

/// Where along a change of something, in parts of it, functions are evaluated for their [`slope`].
pub const WIDTHS: [f64; 4] = [-1.0, -0.5, 0.5, 1.0];

/// The derivative by the width at 0 of a function with these values at [`WIDTHS`]: exact for polynomials of the fourth degree.
pub fn slope(values: [f64; 4]) -> f64 {
    fourth_order(values, 6.0)
}

/// The derivative of a function with these values two steps and a step behind, a step and two ahead: exact for polynomials
/// of the fourth degree.
pub fn derivative(values: [f64; 4], step: f64) -> f64 {
    fourth_order(values, 12.0 * step)
}

/// The derivative of a function with these values a step behind and a step ahead: exact for those of the second degree.
pub fn central([behind, ahead]: [f64; 2], step: f64) -> f64 {
    (ahead - behind) / (2.0 * step)
}

fn fourth_order([far_behind, behind, ahead, far_ahead]: [f64; 4], steps: f64) -> f64 {
    (8.0 * (ahead - behind) - (far_ahead - far_behind)) / steps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_exact_for_polynomials_of_their_degree_and_no_other() {
        // (1 + x)^n has the slope n at 0.
        let power = |degree: i32| move |x: f64| (1.0 + x).powi(degree);
        for degree in 0..=4 {
            let slope_there = f64::from(degree);
            assert!((slope(WIDTHS.map(power(degree))) - slope_there).abs() < 1e-14);
            let values = [-0.5, -0.25, 0.25, 0.5].map(power(degree));
            assert!((derivative(values, 0.25) - slope_there).abs() < 1e-14);
        }
        for degree in 0..=2 {
            assert!((central([-0.5, 0.5].map(power(degree)), 0.5) - f64::from(degree)).abs() < 1e-15);
        }
        assert!((slope(WIDTHS.map(power(5))) - 5.0).abs() > 0.1);
        assert!((central([-0.5, 0.5].map(power(3)), 0.5) - 3.0).abs() > 0.1);
    }
}
