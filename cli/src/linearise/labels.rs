//! Names for tools in which a signal's name is a word, as in python-control: letters, digits and underscores.

use std::collections::BTreeSet;

use flexible_aircraft::{LinearModel, LinearName};

/// A label for each name.
pub struct Labels {
    pub states: Vec<String>,
    /// None of which is that of an output.
    pub inputs: Vec<String>,
    pub outputs: Vec<String>,
}

impl Labels {
    /// Of a model: outputs whose label an input has get `_out`.
    pub fn of(model: &LinearModel) -> Self {
        let mut signals = BTreeSet::new();
        Labels {
            states: unique(&model.states, &mut BTreeSet::new(), ""),
            inputs: unique(&model.inputs, &mut signals, ""),
            outputs: unique(&model.outputs, &mut signals, "_out"),
        }
    }
}

/// Labels that are not taken, each only once: those that are get an ending, and a number where that is not enough.
fn unique(names: &[LinearName], taken: &mut BTreeSet<String>, ending: &str) -> Vec<String> {
    let label = |name: &LinearName| {
        let word = word(&name.name);
        let ended = format!("{word}{ending}");
        let numbered = (2_u64..).map(|number| format!("{ended}_{number}"));
        let mut candidates = [word.clone(), ended.clone()].into_iter().chain(numbered);
        candidates.find(|label| taken.insert(label.clone())).unwrap_or(word)
    };
    names.iter().map(label).collect()
}

/// A name with everything but letters, digits and underscores replaced by these.
fn word(name: &str) -> String {
    name.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_words_and_each_is_there_once() {
        let names = |names: &[&str]| -> Vec<LinearName> {
            names.iter().map(|name| LinearName { name: (*name).to_owned(), unit: "m/s" }).collect()
        };
        let mut taken = BTreeSet::new();
        let inputs = unique(&names(&["elevator", "wind_down"]), &mut taken, "");
        let outputs =
            unique(&names(&["wind.down", "modal.q[1]", "modal_q[1]", "modal.q.1."]), &mut taken, "_out");
        assert_eq!(inputs, ["elevator", "wind_down"]);
        assert_eq!(outputs, ["wind_down_out", "modal_q_1_", "modal_q_1__out", "modal_q_1__out_2"]);
    }
}
