//! Joints, and what they mean for the file.

use super::super::joints;
use super::{Written, beside, number};

/// Of a file that has joints.
pub const WHY_EXACT: &str = "Beams form loops (see [[joint]]), which the geometrically exact level does not fly. At \"exact\" displacements are \
    superposed, with the real EA of all beams: it is right where beams bend little, and too stiff where they bend visibly; \"inconsistent\" has linear elastic forces.";

const AXES: [&str; 3] = ["\"x\"", "\"y\"", "\"z\""];

/// Those of both sides once.
pub fn joints(written: &Written) -> String {
    // PROOF: components are paired only where their joints are.
    let joints = joints::written(written.structure, written.sides).unwrap_or_default();
    let one = |joint: &super::super::structure::Joint| {
        let [(name, at), (other, other_at)] = joint.ends.map(|(component, node)| {
            let distances = written.structure.components[component].distances();
            (&written.names[component], number(distances[node] / distances[distances.len() - 1]))
        });
        let rotations = match joint.rotations {
            [true, true, true] => "\"fixed\"".to_owned(),
            [false, false, false] => "\"free\"".to_owned(),
            some => {
                let held = std::iter::zip(AXES, some).filter(|(_, is_held)| *is_held).map(|(axis, _)| axis);
                format!("[{}]", held.collect::<Vec<_>>().join(", "))
            }
        };
        let source = format!("{}, GRID {} ({})", joint.origin, joint.grid, (written.shown)(&joint.origin));
        beside("[[joint]]", &source)
            + &format!(
                "component = \"{name}\"\nat = {at}\njoined_to = {{ component = \"{other}\", at = {other_at} }}\nrotations = {rotations}\n\n"
            )
    };
    joints.into_iter().map(one).collect()
}
