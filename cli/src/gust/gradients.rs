//! Gradients of gusts as they are written on the command line.

/// More gusts than this are a slip of the pen.
const MOST_GRADIENTS: usize = 10_000;

/// Of each gust H, m: from where it begins to where it peaks.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradients(pub Vec<f64>);

/// A range, both ends of which count, or a list.
pub fn gradients(text: &str) -> Result<Gradients, String> {
    let found = if text.contains(':') { range(text) } else { text.split(',').map(length).collect() };
    found.map(Gradients).ok_or_else(|| {
        format!(
            "allowed is FROM:TO:N in m with 0 < FROM ≤ TO and 1 to {MOST_GRADIENTS} gradients, or M,M,… with each greater \
             than 0"
        )
    })
}

fn length(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|length: &f64| *length > 0.0 && length.is_finite())
}

/// Equally far apart.
fn range(text: &str) -> Option<Vec<f64>> {
    let mut parts = text.split(':');
    let (from, to) = (length(parts.next()?)?, length(parts.next()?)?);
    let count: usize = parts.next()?.parse().ok()?;
    if parts.next().is_some() || from > to || !(1..=MOST_GRADIENTS).contains(&count) {
        return None;
    }
    let last = count - 1;
    let gradient = |place: usize| match place {
        0 => from,
        place if place == last => to,
        place => from + (to - from) * place as f64 / last as f64,
    };
    Some((0..count).map(gradient).collect())
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
