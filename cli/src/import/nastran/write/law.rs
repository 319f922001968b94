//! Laws: numbers where they are equal, lists where they are not, places between which they are straight.

use super::{list, number};

/// Numbers that differ by less than this share are one.
const EQUAL: f64 = 1e-11;

/// One for each element.
pub fn per_element(values: &[f64]) -> String {
    let first = values.first().copied().unwrap_or(0.0);
    if values.iter().all(|value| (value - first).abs() <= EQUAL * first.abs()) {
        return number(first);
    }
    format!("{{ per_element = {} }}", list(values))
}

/// Between places; those on the line between their neighbours are left out.
pub fn straight(at: &[f64], values: &[f64], slack: f64) -> String {
    let first = values.first().copied().unwrap_or(0.0);
    if values.iter().all(|value| (value - first).abs() <= slack) {
        return number(first);
    }
    let mut kept = vec![0];
    for place in 1..at.len() {
        let is_last = place + 1 == at.len();
        let from = kept[kept.len() - 1];
        let next = (place + 1).min(at.len() - 1);
        let share = (at[place] - at[from]) / (at[next] - at[from]);
        let on_line = values[from] + share * (values[next] - values[from]);
        if is_last || (values[place] - on_line).abs() > slack {
            kept.push(place);
        }
    }
    let of = |numbers: &[f64]| list(&kept.iter().map(|&place| numbers[place]).collect::<Vec<_>>());
    format!("{{ at = {}, values = {} }}", of(at), of(values))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laws_are_as_short_as_they_can_be() {
        assert_eq!(per_element(&[2.0, 2.0]), "2");
        assert_eq!(per_element(&[2.0, 3.0]), "{ per_element = [2, 3] }");
        assert_eq!(straight(&[0.0, 0.5, 1.0], &[2.0, 1.5, 1.0], 1e-9), "{ at = [0, 1], values = [2, 1] }");
        assert_eq!(
            straight(&[0.0, 0.5, 1.0], &[2.0, 1.0, 1.0], 1e-9),
            "{ at = [0, 0.5, 1], values = [2, 1, 1] }"
        );
        assert_eq!(straight(&[0.2, 0.7], &[1.0, 1.0], 1e-9), "1");
    }
}
