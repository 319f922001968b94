//! What a command finds, as names and arrays for programs that call it instead of reading its files.

/// A value of an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// A text.
    Text(String),
    /// A number.
    Number(f64),
    /// Texts in one dimension.
    Texts(Vec<String>),
    /// Truth values in one dimension.
    Truths(Vec<bool>),
    /// Whole numbers in one dimension.
    Counts(Vec<usize>),
    /// Numbers in one dimension.
    Numbers(Vec<f64>),
    /// Numbers in two dimensions, row by row.
    Matrix {
        /// How many rows there are.
        rows: usize,
        /// How many numbers there are in one.
        columns: usize,
        /// All of them.
        values: Vec<f64>,
    },
    /// Complex numbers in two dimensions, row by row, as real and imaginary parts.
    Complex {
        /// How many rows there are.
        rows: usize,
        /// How many numbers there are in one.
        columns: usize,
        /// All of them.
        values: Vec<[f64; 2]>,
    },
    /// Values by their names.
    Members(Vec<(String, Answer)>),
}

impl Answer {
    /// Values by their names.
    pub fn named(members: impl IntoIterator<Item = (&'static str, Answer)>) -> Self {
        Answer::Members(members.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
    }
}
