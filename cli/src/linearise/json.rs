//! A linear model as JSON: a matrix is an array of its rows, each on a line.

use serde_json::{Value, json};

use super::arrays::Array;

/// An object with all keys, and those of another object.
pub fn text(arrays: &[(&'static str, Array)], others: &Value) -> String {
    let arrays = arrays.iter().map(|(key, array)| format!("{}: {}", json!(key), value(array)));
    let others =
        others.as_object().into_iter().flatten().map(|(key, value)| format!("{}: {value}", json!(key)));
    let members: Vec<String> = arrays.chain(others).collect();
    format!("{{\n{}\n}}\n", members.join(",\n"))
}

fn value(array: &Array) -> String {
    match array {
        Array::Matrix { rows, columns, values } => {
            let row = |row: usize| json!(values[row * columns..(row + 1) * columns]).to_string();
            let rows: Vec<String> = (0..*rows).map(row).collect();
            format!("[\n{}\n]", rows.join(",\n"))
        }
        Array::Vector(values) => json!(values).to_string(),
        Array::Texts(texts) => json!(texts).to_string(),
    }
}
