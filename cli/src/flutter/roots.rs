//! The roots as numbers: a table of comma-separated values, a row for each root at each airspeed.

use std::fmt::Write;

use crate::analysis::Analysis;
use crate::analysis::motion::{damping, frequency, leading_motion, oscillates};
use crate::numbers::Plain;

/// Names with their units. `root` counts the curves of the plots; it is empty for an unstable eigenvalue that none of
/// them has reached. `damping_g` is empty where nothing oscillates.
pub const HEADER: &str = "airspeed_m_s,root,real_1_s,imaginary_rad_s,frequency_Hz,damping_g,mode";

/// The whole table.
pub fn table(analysis: &Analysis) -> String {
    let sweep = &analysis.sweep;
    let mut text = format!("{HEADER}\n");
    let mut unreached = sweep.unreached.iter().peekable();
    for (index, airspeed) in sweep.airspeeds.iter().enumerate() {
        let speed = Plain(*airspeed);
        for (number, branch) in sweep.branches.iter().enumerate() {
            let Some(root) = &branch.roots[index] else { continue };
            let (real, imaginary) = (Plain(root.eigenvalue.re), Plain(root.eigenvalue.im.abs()));
            let [frequency, damping] = if oscillates(root) {
                [frequency(root), damping(root)].map(|number| Plain(number).to_string())
            } else {
                ["0".to_owned(), String::new()]
            };
            let mode = leading_motion(root, analysis);
            // Writing to a String does not fail.
            let _ = writeln!(text, "{speed},{},{real},{imaginary},{frequency},{damping},{mode}", number + 1);
        }
        while let Some((_, eigenvalue)) = unreached.next_if(|(at, _)| at == airspeed) {
            let (real, imaginary) = (Plain(eigenvalue.re), Plain(eigenvalue.im));
            let frequency = Plain(eigenvalue.im / std::f64::consts::TAU);
            let _ = writeln!(text, "{speed},,{real},{imaginary},{frequency},,");
        }
    }
    text
}
