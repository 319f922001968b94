//! A linear model as arrays under the keys of its files.

use flexible_aircraft::{LinearModel, LinearName};

use super::labels::Labels;
use crate::answer::Answer;

/// An array.
pub enum Array {
    /// So many rows and columns, row by row.
    Matrix { rows: usize, columns: usize, values: Vec<f64> },
    /// Numbers in one dimension.
    Vector(Vec<f64>),
    /// Texts in one dimension.
    Texts(Vec<String>),
}

impl From<Array> for Answer {
    fn from(array: Array) -> Self {
        match array {
            Array::Matrix { rows, columns, values } => Answer::Matrix { rows, columns, values },
            Array::Vector(values) => Answer::Numbers(values),
            Array::Texts(texts) => Answer::Texts(texts),
        }
    }
}

/// All keys with their arrays, in the order of the files; of a reduced model with the bound of its error.
pub fn of(model: &LinearModel, error_bound: Option<f64>) -> Vec<(&'static str, Array)> {
    let LinearModel { a, b, c, d, bd, dd, x0, u0, y0, states, inputs, outputs, gust_planes } = model;
    let matrices = [("A", a), ("B", b), ("C", c), ("D", d), ("Bd", bd), ("Dd", dd)].map(|(key, matrix)| {
        let (rows, columns) = matrix.shape();
        // By rows: the transposed one by columns.
        (key, Array::Matrix { rows, columns, values: matrix.transpose().iter().copied().collect() })
    });
    let vectors = [("x0", x0), ("u0", u0), ("y0", y0)].map(|(key, v)| (key, Array::Vector(v.clone())));
    let labels = Labels::of(model);
    let texts = [
        ("x_names", names(states)),
        ("x_units", units(states)),
        ("u_names", names(inputs)),
        ("u_units", units(inputs)),
        ("y_names", names(outputs)),
        ("y_units", units(outputs)),
        ("x_labels", labels.states),
        ("u_labels", labels.inputs),
        ("y_labels", labels.outputs),
    ];
    let texts = texts.map(|(key, texts)| (key, Array::Texts(texts)));
    let planes = (!gust_planes.is_empty()).then(|| ("gust_planes", Array::Vector(gust_planes.clone())));
    let bound = error_bound.map(|bound| ("error_bound", Array::Vector(vec![bound])));
    matrices.into_iter().chain(vectors).chain(texts).chain(planes).chain(bound).collect()
}

fn names(of: &[LinearName]) -> Vec<String> {
    of.iter().map(|name| name.name.clone()).collect()
}

fn units(of: &[LinearName]) -> Vec<String> {
    of.iter().map(|name| name.unit.to_owned()).collect()
}
