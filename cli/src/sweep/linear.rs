//! What is kept of a linear model: roots and entries of matrices by names.

use flexible_aircraft::variables::{nearest, probably_meant};
use flexible_aircraft::{LinearModel, LinearName};

use super::file::Matrix;

/// A number of a linear model.
#[derive(Clone, Debug, PartialEq)]
pub enum LinearKept {
    /// A part of the root with this place, that of the greatest real part being 0; of pairs the upper one counts.
    Root {
        place: usize,
        part: Part,
    },
    Entry {
        matrix: Matrix,
        row: String,
        column: String,
    },
}

/// Of a complex number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    Real,
    Imaginary,
}

/// A name that the rows or columns of a matrix do not have.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("found `{found}` as a {side} of {matrix:?}, allowed is {allowed}")]
pub struct NoSuchEntry {
    found: String,
    side: &'static str,
    matrix: Matrix,
    allowed: String,
}

/// Names of rows and columns of a matrix.
fn names(linear: &LinearModel, matrix: Matrix) -> [&[LinearName]; 2] {
    let LinearModel { states, inputs, outputs, .. } = linear;
    match matrix {
        Matrix::A => [states, states],
        Matrix::B | Matrix::Bd => [states, inputs],
        Matrix::C => [outputs, states],
        Matrix::D | Matrix::Dd => [outputs, inputs],
    }
}

fn entry(linear: &LinearModel, matrix: Matrix, [row, column]: [usize; 2]) -> f64 {
    let matrix = match matrix {
        Matrix::A => &linear.a,
        Matrix::B => &linear.b,
        Matrix::C => &linear.c,
        Matrix::D => &linear.d,
        Matrix::Bd => &linear.bd,
        Matrix::Dd => &linear.dd,
    };
    matrix[(row, column)]
}

/// Row and column of an entry.
fn place(linear: &LinearModel, matrix: Matrix, [row, column]: [&str; 2]) -> Result<[usize; 2], NoSuchEntry> {
    let [rows, columns] = names(linear, matrix);
    let place = |names: &[LinearName], name: &str, side| {
        names.iter().position(|other| other.name == name).ok_or_else(|| {
            let known = || names.iter().map(|other| other.name.as_str());
            let allowed = match probably_meant(name, known()) {
                Some(meant) => format!("a name of the linear model: did you mean `{meant}`?"),
                None => format!("a name of the linear model: nearest are {}", nearest(name, known())),
            };
            NoSuchEntry { found: name.to_owned(), side, matrix, allowed }
        })
    };
    Ok([place(rows, row, "row")?, place(columns, column, "column")?])
}

/// The unit of an entry: of rates per second, of what acts by its rate by that.
///
/// # Errors
/// When a name is none of the matrix.
pub fn unit(linear: &LinearModel, matrix: Matrix, entry: [&str; 2]) -> Result<String, NoSuchEntry> {
    let [row, column] = place(linear, matrix, entry)?;
    let [rows, columns] = names(linear, matrix);
    let grouped = |unit: &str| if unit.contains('/') { format!("({unit})") } else { unit.to_owned() };
    let [row, column] = [rows[row].unit, columns[column].unit].map(grouped);
    Ok(match matrix {
        Matrix::A | Matrix::B => format!("{row}/s/{column}"),
        Matrix::C | Matrix::D | Matrix::Bd => format!("{row}/{column}"),
        Matrix::Dd => format!("{row}.s/{column}"),
    })
}

/// The numbers that are kept of a model; none of a root that is not there.
///
/// # Errors
/// When the roots are not found, or a name is none of a matrix.
pub fn numbers_of(linear: &LinearModel, kept: &[LinearKept]) -> Result<Vec<Option<f64>>, String> {
    let roots = if kept.iter().any(|kept| matches!(kept, LinearKept::Root { .. })) {
        let mut roots = linear.eigenvalues().map_err(|error| error.to_string())?;
        roots.retain(|root| root.im >= 0.0);
        roots.sort_by(|one, other| other.re.total_cmp(&one.re).then(one.im.total_cmp(&other.im)));
        roots
    } else {
        Vec::new()
    };
    let number = |kept: &LinearKept| match kept {
        LinearKept::Root { place, part: Part::Real } => Ok(roots.get(*place).map(|root| root.re)),
        LinearKept::Root { place, part: Part::Imaginary } => Ok(roots.get(*place).map(|root| root.im)),
        LinearKept::Entry { matrix, row, column } => {
            Ok(Some(entry(linear, *matrix, place(linear, *matrix, [row, column])?)))
        }
    };
    let found: Result<Vec<_>, NoSuchEntry> = kept.iter().map(number).collect();
    found.map_err(|error| error.to_string())
}
