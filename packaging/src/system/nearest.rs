//! Names like one that was not found.

/// At most this many are shown.
const SHOWN: usize = 3;

/// The nearest of the names, best first, as a list for people: those that contain the wanted one, then others.
pub(super) fn nearest<'n>(wanted: &str, names: impl Iterator<Item = &'n str>) -> String {
    let mut ranked: Vec<&str> = names.collect();
    // Stable: what is equally near stays in the order of the model description.
    ranked.sort_by_cached_key(|name| (!name.contains(wanted), distance(wanted, name)));
    let shown: Vec<String> = ranked.iter().take(SHOWN).map(|name| format!("`{name}`")).collect();
    shown.join(", ")
}

/// How many letters have to be put in, left out or changed, after V. Levenshtein; the case does not matter.
fn distance(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|text| text.to_lowercase().chars().collect::<Vec<char>>());
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, from) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, to) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(from != to);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_the_textbook_ones() {
        for (a, b, expected) in
            [("kitten", "sitting", 3), ("", "abc", 3), ("Pitch", "pitch", 0), ("ab", "ba", 2)]
        {
            assert_eq!(distance(a, b), expected, "{a} {b}");
        }
    }

    #[test]
    fn the_nearest_names_come_first() {
        let names = ["rudder", "elevator", "aileron", "surface.elevator"];
        assert_eq!(nearest("elevatr", names.into_iter()), "`elevator`, `rudder`, `aileron`");
        assert_eq!(
            nearest("pitch", ["rate.y", "model", "trim.pitch"].into_iter()),
            "`trim.pitch`, `rate.y`, `model`"
        );
    }
}
