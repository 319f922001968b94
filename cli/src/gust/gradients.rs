//! Gradients of gusts as they are written on the command line.

use flexible_aircraft::air::CS25_GRADIENTS;

use crate::axis;

/// More gusts than this are a slip of the pen.
const MOST_GRADIENTS: usize = 10_000;

/// Of each gust H, m: from where it begins to where it peaks.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradients(pub Vec<f64>);

/// How many of CS-25 are flown where none are asked for.
const USUAL_COUNT: usize = 37;

impl Gradients {
    /// Those of CS-25.
    pub fn usual() -> Self {
        Gradients(axis::even(*CS25_GRADIENTS.start(), *CS25_GRADIENTS.end(), USUAL_COUNT))
    }
}

/// A range, both ends of which count, or a list.
pub fn gradients(text: &str) -> Result<Gradients, String> {
    let found = axis::numbers(text, MOST_GRADIENTS);
    found.filter(|lengths| lengths.iter().all(|length| *length > 0.0)).map(Gradients).ok_or_else(|| {
        format!(
            "allowed is FROM:TO:N in m with 0 < FROM ≤ TO and 1 to {MOST_GRADIENTS} gradients, or M,M,… with each greater \
             than 0"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gradients_are_equally_far_apart_with_both_ends_or_listed() {
        let found = |text: &str| gradients(text).unwrap().0;
        assert_eq!(found("10:30:5"), [10.0, 15.0, 20.0, 25.0, 30.0]);
        assert_eq!(found("10:30:1"), [10.0]);
        assert_eq!(found("15,30,60"), [15.0, 30.0, 60.0]);
        let usual = found("9.144:106.68:37");
        assert_eq!((usual.len(), usual[0], usual[36]), (37, 9.144, 106.68));
        assert_eq!(Gradients::usual().0, usual);
        let wrong = [
            "10:30",
            "10:30:5:1",
            "30:10:5",
            "0:30:5",
            "10:30:0",
            "10:inf:3",
            "a:b:c",
            "1:2:10001",
            "",
            "15,",
            "15,-3",
            "NaN",
        ];
        for wrong in wrong {
            assert!(gradients(wrong).unwrap_err().contains("0 < FROM"), "{wrong}");
        }
    }
}
