//! The tables `[[joint]]` of the aircraft file.

use super::document::{Table, Value};
use super::format::{Field, file, joint};
use super::schema::{JointEndSpec, JointSpec};

/// All of them that could be read.
pub(super) fn read_joints(table: &Table) -> Vec<JointSpec> {
    table.tables(&file::JOINTS).iter().filter_map(read_joint).collect()
}

fn read_joint(table: &Table) -> Option<JointSpec> {
    let one = read_end(table, [&joint::COMPONENT, &joint::AT]);
    let other = table.required(&joint::JOINED_TO).and_then(|v| v.table());
    let other = other.and_then(|table| read_end(&table, [&joint::OTHER_COMPONENT, &joint::OTHER_AT]));
    let rotations = table.required(&joint::ROTATIONS).and_then(|v| read_rotations(&v));
    Some(JointSpec { place: table.place.clone(), ends: [one?, other?], rotations: rotations? })
}

fn read_end(table: &Table, [component, at]: [&Field; 2]) -> Option<JointEndSpec> {
    let component = table.required(component).and_then(|v| v.located(Value::name));
    let at = table.required(at).and_then(|v| v.located(Value::number));
    Some(JointEndSpec { component: component?, at: at? })
}

/// Whether it is about each of the body axes.
fn read_rotations(value: &Value) -> Option<[bool; 3]> {
    if !value.is_list() {
        return value.one_of(&[(joint::FREE.word, [false; 3]), (joint::FIXED.word, [true; 3])]);
    }
    let axes = [0, 1, 2].map(|axis| (joint::AXES[axis].word, axis));
    let mut rotations = [false; 3];
    value.several_of(&axes)?.into_iter().for_each(|axis| rotations[axis] = true);
    Some(rotations)
}
