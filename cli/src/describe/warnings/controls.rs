//! What controls do against what the file says of them.

use flexible_aircraft::aircraft::Control;
use nalgebra::Vector3;

use crate::numbers::short;

/// What a control does about an axis beside what it is for, as adverse yaw or the roll of a high fin, is not judged below this share of all it does.
const LEAST_SHARE: f64 = 1e-3;

/// A turn that words of a file speak of.
struct Turn {
    /// Without hyphens.
    words: [&'static str; 3],
    axis: usize,
    sense: f64,
    /// For people.
    opposite: &'static str,
}

const TURNS: [Turn; 6] = [
    Turn { words: ["nose up", "pitches up", "pitch up"], axis: 1, sense: 1.0, opposite: "nose-down" },
    Turn { words: ["nose down", "pitches down", "pitch down"], axis: 1, sense: -1.0, opposite: "nose-up" },
    Turn {
        words: ["rolls right", "roll right", "right wing down"],
        axis: 0,
        sense: 1.0,
        opposite: "rolls left",
    },
    Turn {
        words: ["rolls left", "roll left", "left wing down"],
        axis: 0,
        sense: -1.0,
        opposite: "rolls right",
    },
    Turn { words: ["nose right", "yaws right", "yaw right"], axis: 2, sense: 1.0, opposite: "nose left" },
    Turn { words: ["nose left", "yaws left", "yaw left"], axis: 2, sense: -1.0, opposite: "nose right" },
];

/// A control that turns the aircraft against what its `positive` says, by what it does at once, rad/s² per rad about body axes.
pub fn contradiction(control: &Control, does: &Vector3<f64>) -> Option<String> {
    let Control { name, positive, .. } = control;
    let said = positive.to_lowercase().replace(['-', '\u{2010}', '\u{2011}'], " ");
    let is_said = |turn: &&Turn| turn.words.iter().any(|words| said.contains(words));
    let is_opposite = |turn: &&Turn| turn.sense * does[turn.axis] < -LEAST_SHARE * does.norm();
    let Turn { axis, opposite, .. } = TURNS.iter().filter(is_said).find(is_opposite)?;
    Some(format!(
        "{name} says positive = \"{positive}\", and its positive angle does the opposite ({opposite}, {} rad/s² per rad at once), usual is what is \
         said: has a gain the wrong sign?",
        short(does[*axis])
    ))
}
