//! A linear model as comma-separated values: a table for each matrix with names of rows and columns, and one each for states,
//! inputs and outputs at the trim.

use flexible_aircraft::{LinearModel, LinearName};

use crate::numbers::Plain;

use super::labels::Labels;

/// How the names of the files end, in the order of the tables.
pub const NAMES: [&str; 9] = ["A", "B", "C", "D", "Bd", "Dd", "x", "u", "y"];

/// All of them.
pub fn all(model: &LinearModel) -> impl Iterator<Item = String> {
    let LinearModel { a, b, c, d, bd, dd, x0, u0, y0, states, inputs, outputs, .. } = model;
    let matrices = [
        (a, states, states),
        (b, states, inputs),
        (c, outputs, states),
        (d, outputs, inputs),
        (bd, states, inputs),
        (dd, outputs, inputs),
    ];
    let matrices = matrices.map(|(matrix, rows, columns)| {
        let head = std::iter::once(String::new()).chain(columns.iter().map(|name| name.name.clone()));
        let row = |(row, name): (usize, &LinearName)| {
            let numbers = (0..columns.len()).map(move |column| Plain(matrix[(row, column)]).to_string());
            std::iter::once(name.name.clone()).chain(numbers).collect()
        };
        let rows = rows.iter().enumerate().map(row);
        table(std::iter::once(head.collect()).chain(rows))
    });
    let labels = Labels::of(model);
    let at_trim = [(states, labels.states, x0), (inputs, labels.inputs, u0), (outputs, labels.outputs, y0)];
    let at_trim = at_trim.map(|(names, labels, values)| {
        let head = ["name", "label", "unit", "value"].map(str::to_owned).to_vec();
        let rows = names.iter().zip(labels).zip(values).map(|((name, label), value)| {
            vec![name.name.clone(), label, name.unit.to_owned(), Plain(*value).to_string()]
        });
        table(std::iter::once(head).chain(rows))
    });
    matrices.into_iter().chain(at_trim)
}

fn table(records: impl Iterator<Item = Vec<String>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for record in records {
        // PROOF: a vector takes every record, and all of a table are of one length.
        let _ = writer.write_record(&record);
    }
    String::from_utf8_lossy(&writer.into_inner().unwrap_or_default()).into_owned()
}
