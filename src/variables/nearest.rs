//! Names like one that was not found.

/// At most this many are shown.
const SHOWN: usize = 3;

/// The nearest of the names, best first, as a list for people: those that contain the wanted one, then others.
pub fn nearest<'n>(wanted: &str, names: impl Iterator<Item = &'n str>) -> String {
    let mut ranked: Vec<&str> = names.collect();
    // Stable: what is equally near stays in the order of the model description.
    ranked.sort_by_cached_key(|name| (!name.contains(wanted), distance(wanted, name)));
    let shown: Vec<String> = ranked.iter().take(SHOWN).map(|name| format!("`{name}`")).collect();
    shown.join(", ")
}

/// The name that was probably meant; none where nothing is like the wanted one.
pub fn probably_meant<'n>(wanted: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    // A letter of three may be wrong, and two letters may have changed places.
    let likely = |distance: &usize| 3 * distance <= wanted.chars().count().max(3);
    let ranked = names.map(|name| (distance(wanted, name), name));
    ranked
        .filter(|(distance, _)| likely(distance))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}

/// How many letters have to be put in, left out, changed, or change places with their neighbours, after F. Damerau; the
/// case does not matter.
fn distance(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|name| name.to_lowercase().chars().collect::<Vec<char>>());
    // Rows of the table of distances between beginnings of both: the last but one, the last, the present.
    let (mut before, mut last) = (vec![0; b.len() + 1], (0..=b.len()).collect::<Vec<usize>>());
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let changed = last[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            row[j] = changed.min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && (a[i - 1], a[i - 2]) == (b[j - 2], b[j - 1]) {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        (before, last) = (last, row);
    }
    last[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_put_in_left_out_changed_or_exchanged_counts_once() {
        for (a, b, expected) in
            [("", "", 0), ("", "abc", 3), ("flap", "Flaps", 1), ("flpa", "flap", 1), ("kitten", "sitting", 3)]
        {
            assert_eq!([distance(a, b), distance(b, a)], [expected; 2], "{a} {b}");
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

    #[test]
    fn what_is_like_nothing_is_not_guessed() {
        let meant = |wanted| probably_meant(wanted, ["stiffness_scale", "model", "altitude"].into_iter());
        assert_eq!(meant("stifness_scale"), Some("stiffness_scale"));
        assert_eq!(meant("Model"), Some("model"));
        assert_eq!(meant("atlitude"), Some("altitude"));
        assert_eq!(meant("flap"), None);
    }
}
