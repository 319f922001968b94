//! Numbers of a table's axis as they are written on the command line.

/// One or more, in the order in which they were given.
#[derive(Clone, Debug, PartialEq)]
pub struct Values(pub Vec<f64>);

/// More than this are a slip of the pen.
const MOST: usize = 100_000;

/// A number, a list, or a range of which both ends count.
pub fn values(text: &str) -> Result<Values, String> {
    let found = if text.contains(':') { range(text) } else { text.split(',').map(number).collect() };
    found.map(Values).ok_or_else(|| {
        format!(
            "allowed is a number, a list N,N,… or FROM:TO:COUNT with FROM < TO and a count of 2 to {MOST}"
        )
    })
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|number: &f64| number.is_finite())
}

fn range(text: &str) -> Option<Vec<f64>> {
    let mut parts = text.split(':');
    let (from, to) = (number(parts.next()?)?, number(parts.next()?)?);
    let count: usize = parts.next()?.trim().parse().ok()?;
    if parts.next().is_some() || from >= to || !(2..=MOST).contains(&count) {
        return None;
    }
    let last = count - 1;
    let value = |place: usize| {
        if place == last { to } else { from + (to - from) * place as f64 / last as f64 }
    };
    Some((0..count).map(value).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_is_a_number_a_list_or_a_range() {
        let found = |text: &str| values(text).unwrap().0;
        assert_eq!(found("127"), [127.0]);
        assert_eq!(found("1.2,-1.5"), [1.2, -1.5]);
        assert_eq!(found("100:200:3"), [100.0, 150.0, 200.0]);
        for wrong in ["", "a", "1,", "1:2", "2:1:3", "1:2:1", "1:2:3:4", "inf", "1:2:1000000"] {
            assert!(values(wrong).unwrap_err().starts_with("allowed is a number"), "{wrong}");
        }
    }
}
