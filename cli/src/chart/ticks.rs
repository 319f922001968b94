//! What is written at the ticks of an axis.

use std::sync::Arc;

use kuva::render::layout::TickFormat;

/// What the numbers of an axis stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Themselves.
    Plain,
    /// Powers of ten, with grid lines at whole ones.
    Decades,
}

impl Scale {
    /// How its numbers are written.
    pub fn format(self) -> TickFormat {
        TickFormat::Custom(Arc::new(match self {
            Scale::Plain => plain,
            Scale::Decades => decade,
        }))
    }
}

/// A number as one would write it on an axis: no superfluous zeros, a true minus.
fn plain(value: f64) -> String {
    // Ticks are sums of steps: rounding errors of that size mean zero.
    let value = if value.abs() < 1e-12 { 0.0 } else { value };
    let text = if value != 0.0 && (value.abs() < 1e-3 || value.abs() >= 1e5) {
        format!("{value:.1e}")
    } else {
        let text = format!("{value:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    text.replace('-', "−")
}

/// A power of ten by its exponent.
fn decade(exponent: f64) -> String {
    let exponent = exponent.round() as i32;
    if (-2..=4).contains(&exponent) {
        return plain(10_f64.powi(exponent));
    }
    let raised = |letter: char| match letter {
        '-' => '⁻',
        digit => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit.to_digit(10).unwrap_or(0) as usize],
    };
    format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_have_no_superfluous_digits() {
        for (value, label) in [(0.1 + 0.2, "0.3"), (-15.0, "−15"), (1e-17, "0"), (-2e-4, "−2.0e−4")] {
            assert_eq!(plain(value), label);
        }
    }

    #[test]
    fn powers_of_ten_are_written_plainly_where_they_are_short() {
        let labels = [-12.0, -2.0, 0.0, 2.0, 5.0].map(decade);
        assert_eq!(labels, ["10⁻¹²", "0.01", "1", "100", "10⁵"]);
    }
}
