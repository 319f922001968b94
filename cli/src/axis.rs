//! Numbers along an axis as they are written on the command line or in a file: one, a list, or a range.

/// A number, N,N,… or FROM:TO:COUNT with both ends, FROM ≤ TO, of at most so many finite numbers; `None` of anything else.
pub fn numbers(text: &str, most: usize) -> Option<Vec<f64>> {
    if text.contains(':') { range(text, most) } else { text.split(',').map(number).collect() }
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|number: &f64| number.is_finite())
}

/// Equally far apart.
fn range(text: &str, most: usize) -> Option<Vec<f64>> {
    let mut parts = text.split(':');
    let (from, to) = (number(parts.next()?)?, number(parts.next()?)?);
    let count: usize = parts.next()?.trim().parse().ok()?;
    if parts.next().is_some() || from > to || !(1..=most).contains(&count) {
        return None;
    }
    Some(even(from, to, count))
}

/// So many numbers from one to another, both ends among them, equally far apart; one alone is the first end.
pub fn even(from: f64, to: f64, count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1);
    let value = |place: usize| match place {
        0 => from,
        place if place == last => to,
        place => from + (to - from) * place as f64 / last as f64,
    };
    (0..count).map(value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_is_a_number_a_list_or_a_range_with_both_ends() {
        let found = |text: &str| numbers(text, 1000).unwrap();
        assert_eq!(found("127"), [127.0]);
        assert_eq!(found("1.2,-1.5"), [1.2, -1.5]);
        assert_eq!(found("10:30:5"), [10.0, 15.0, 20.0, 25.0, 30.0]);
        assert_eq!(found("10:30:1"), [10.0]);
        for wrong in ["", "a", "1,", "1:2", "2:1:3", "1:2:0", "1:2:3:4", "inf", "NaN", "10:inf:3", "1:2:1001"]
        {
            assert_eq!(numbers(wrong, 1000), None, "{wrong}");
        }
    }
}
