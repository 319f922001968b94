//! Names that an aircraft file takes: letters, digits, underscores, not a digit first; none twice.

use std::collections::{HashMap, HashSet};

use flexible_aircraft::aircraft::{TAKEN, TAKEN_BY_TRIM};

/// The longest that is made.
const LONGEST: usize = 40;

/// Names that are taken, and of each that was asked for the number that is next.
#[derive(Default)]
pub struct Names {
    taken: HashSet<String>,
    next: HashMap<String, usize>,
}

impl Names {
    /// A name from what a deck calls something, with a number where others have it.
    pub fn free(&mut self, label: &str, otherwise: &str) -> String {
        let base = plain(label, otherwise);
        self.numbered(&base, |base, number| format!("{base}_{number}"))
    }

    /// A name with a side behind it: `wing_right`, `wing_2_right`.
    pub fn on_side(&mut self, base: &str, side: &str) -> String {
        let whole = format!("{base}_{side}");
        self.numbered(&whole, |_, number| format!("{base}_{number}_{side}"))
    }

    fn numbered(&mut self, base: &str, with_number: impl Fn(&str, usize) -> String) -> String {
        let next = self.next.entry(base.to_owned()).or_insert(1);
        loop {
            let name = if *next == 1 { base.to_owned() } else { with_number(base, *next) };
            *next += 1;
            if !is_reserved(&name) && self.taken.insert(name.clone()) {
                return name;
            }
        }
    }
}

fn plain(label: &str, otherwise: &str) -> String {
    let letters = label
        .chars()
        .map(|letter| if letter.is_ascii_alphanumeric() { letter.to_ascii_lowercase() } else { '_' });
    let plain: String = letters.take(LONGEST).collect();
    let plain = plain.trim_matches('_');
    let begins_well = plain.starts_with(|first: char| first.is_ascii_alphabetic());
    match (plain.is_empty(), begins_well) {
        (true, _) => otherwise.to_owned(),
        (false, true) => plain.to_owned(),
        (false, false) => format!("{otherwise}_{plain}"),
    }
}

/// What other variables are called, some of them behind `trim.`: a control with such a name gets a number.
fn is_reserved(name: &str) -> bool {
    const OF_FILES: [&str; 2] = ["origin", "trim"];
    TAKEN.contains(&name)
        || TAKEN_BY_TRIM.contains(&name)
        || OF_FILES.contains(&name)
        || name.starts_with("thrust_")
        || name.starts_with("wind_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_plain_and_each_there_once() {
        let mut names = Names::default();
        let mut free = |label: &str| names.free(label, "control");
        assert_eq!(["ELEV", "ail_r", "ail-R"].map(&mut free), ["elev", "ail_r", "ail_r_2"]);
        assert_eq!(
            ["1A", "--", "TRIM", "temperature_offset"].map(&mut free),
            ["control_1a", "control", "trim_2", "temperature_offset_2"]
        );
        // What another one would have got as a number.
        assert_eq!(["a_2", "a", "a"].map(free), ["a_2", "a", "a_3"]);
        assert_eq!(
            [names.on_side("wing", "left"), names.on_side("wing", "left")],
            ["wing_left", "wing_2_left"]
        );
    }
}
