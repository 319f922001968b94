//! The numbers: comma-separated values, a row for each number of modes.

use super::quantity::{Quantity, Value};
use super::study::Study;
use crate::numbers::Plain;

/// The whole table; cells are empty where there is no number.
pub fn table(study: &Study) -> String {
    let mut names = vec!["natural_modes".to_owned(), "load_modes".to_owned()];
    names.extend(study.quantities.iter().flat_map(names_of));
    let mut text = names.join(",") + "\n";
    for (place, row) in study.rows.iter().enumerate() {
        let mut cells = vec![row.natural.to_string(), row.loads.to_string()];
        cells.extend(study.quantities.iter().flat_map(|quantity| cells_of(quantity, place)));
        text += &(cells.join(",") + "\n");
    }
    text
}

/// Names of the columns of a quantity, with their units.
fn names_of(quantity: &Quantity) -> Vec<String> {
    let name = quantity.name.replace(' ', "_");
    let unit = quantity.unit.replace('/', "_");
    if quantity.is_root() {
        vec![format!("{name}_real_1_s"), format!("{name}_imaginary_rad_s")]
    } else {
        vec![format!("{name}_{unit}")]
    }
}

fn cells_of(quantity: &Quantity, row: usize) -> Vec<String> {
    match &quantity.values[row] {
        Value::Number(number) => vec![Plain(*number).to_string()],
        Value::Root(root) => [root.re, root.im].map(|part| Plain(part).to_string()).to_vec(),
        _ if quantity.is_root() => vec![String::new(); 2],
        _ => vec![String::new()],
    }
}
