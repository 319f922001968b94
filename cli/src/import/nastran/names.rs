//! Names that an aircraft file takes: letters, digits, underscores, not a digit first; none twice.

/// The longest that is made.
const LONGEST: usize = 40;

/// A name from what a deck calls something, with a number where others have it.
pub fn free(label: &str, otherwise: &str, taken: &[String]) -> String {
    let letters = label
        .chars()
        .map(|letter| if letter.is_ascii_alphanumeric() { letter.to_ascii_lowercase() } else { '_' });
    let plain: String = letters.take(LONGEST).collect();
    let plain = plain.trim_matches('_');
    let begins_well = plain.starts_with(|first: char| first.is_ascii_alphabetic());
    let base = match (plain.is_empty(), begins_well) {
        (true, _) => otherwise.to_owned(),
        (false, true) => plain.to_owned(),
        (false, false) => format!("{otherwise}_{plain}"),
    };
    let mut name = base.clone();
    let mut number = 1;
    while taken.contains(&name) || is_reserved(&name) {
        number += 1;
        name = format!("{base}_{number}");
    }
    name
}

/// What other variables are called, some of them behind `trim.`: a control with such a name gets a number.
fn is_reserved(name: &str) -> bool {
    const TAKEN: [&str; 25] = [
        "time",
        "input_reference",
        "model",
        "airspeed",
        "altitude",
        "temperature_offset",
        "heading",
        "stiffness_scale",
        "structural_damping",
        "mode_family",
        "mode_count",
        "load_modes",
        "inflow_states",
        "tolerance",
        "pitch",
        "roll",
        "beta",
        "thrust",
        "climb_angle",
        "alpha",
        "turn_rate",
        "pitch_rate",
        "load_factor",
        "origin",
        "trim",
    ];
    TAKEN.contains(&name) || name.starts_with("thrust_") || name.starts_with("wind_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_plain_and_each_there_once() {
        assert_eq!(free("ELEV", "control", &[]), "elev");
        assert_eq!(free("ail-R", "control", &["ail_r".to_owned()]), "ail_r_2");
        assert_eq!([free("1A", "control", &[]), free("--", "control", &[])], ["control_1a", "control"]);
        assert_eq!(free("TRIM", "control", &[]), "trim_2");
    }
}
