//! What an axis shows of its quantity.

/// A closed range of numbers, `min` < `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Lower end.
    pub min: f64,
    /// Upper end.
    pub max: f64,
}

impl Window {
    /// From `min` to `max`.
    pub const fn new(min: f64, max: f64) -> Self {
        Window { min, max }
    }

    /// Around some values, and a little more; around 0 where there is none, or nothing but rounding.
    pub fn around(values: impl Iterator<Item = f64>) -> Self {
        let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| {
            (least.min(value), most.max(value))
        });
        // Of what is nothing but rounding there is nothing to see.
        let size = least.abs().max(most.abs());
        if !size.is_finite() || size < 1e-9 {
            return Window::new(-1.0, 1.0);
        }
        let margin = (0.08 * (most - least)).max(1e-3 * size);
        Window::new(least - margin, most + margin)
    }

    /// max − min.
    pub fn width(&self) -> f64 {
        self.max - self.min
    }

    /// Whether a value is inside.
    pub fn contains(&self, value: f64) -> bool {
        (self.min..=self.max).contains(&value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_holds_its_values_and_has_a_width_where_they_are_all_the_same() {
        let around = |values: &[f64]| Window::around(values.iter().copied());
        assert_eq!(around(&[-100.0, 100.0, 0.0]), Window::new(-116.0, 116.0));
        assert_eq!(around(&[1000.0, 1000.0]), Window::new(999.0, 1001.0));
        for nothing in [&[][..], &[1e-15, -1e-15], &[f64::INFINITY]] {
            assert_eq!(around(nothing), Window::new(-1.0, 1.0));
        }
    }
}
