//! The tables `[[cut]]` of the aircraft file.

use super::allowed::FRACTION;
use super::document::{Table, Value};
use super::schema::CutSpec;

const CUT: &[&str] = &["name", "component", "at"];

/// All of them that could be read.
pub(super) fn read_cuts(file: &Table) -> Vec<CutSpec> {
    file.tables("cut", CUT).iter().filter_map(read_cut).collect()
}

fn read_cut(table: &Table) -> Option<CutSpec> {
    let name = |field| table.required(field).and_then(|v| v.located(Value::name));
    let (name, component) = (name("name"), name("component"));
    let at = table.required("at").and_then(|v| v.number(&FRACTION));
    Some(CutSpec { name: name?, component: component?, at: at? })
}
