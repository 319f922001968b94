//! The tables `[[cut]]` of the aircraft file.

use super::document::{Table, Value};
use super::format::{Field, file, places};
use super::schema::CutSpec;

/// All of them that could be read.
pub(super) fn read_cuts(table: &Table) -> Vec<CutSpec> {
    table.tables(&file::CUTS).iter().filter_map(read_cut).collect()
}

fn read_cut(table: &Table) -> Option<CutSpec> {
    let name = |field: &Field| table.required(field).and_then(|v| v.located(Value::name));
    let (name, component) = (name(&places::CUT_NAME), name(&places::CUT_COMPONENT));
    let at = table.required(&places::CUT_AT).and_then(|v| v.number());
    Some(CutSpec { name: name?, component: component?, at: at? })
}
