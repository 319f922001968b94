//! What a component says of its sections, from the document to the schema: stiffnesses as laws, matrices or a box, what couples
//! them, masses per length, a hinge.

use nalgebra::Matrix6;

use super::document::{Table, Value};
use super::error::Problem;
use super::format::{Field, component, section};
use super::law::Law;
use super::schema::{BoxSpec, HingeSpec, MatrixSpec, SectionSpec, StiffnessSource};

/// Entries of a matrix and of its transpose differ by this share of the roots of their diagonals at most.
const ROUNDED: f64 = 1e-6;

/// The laws by name, where a component is as stiff as laws say.
type NamedLaws = Vec<(&'static str, Law)>;

/// The stiffnesses that are laws, none where matrices or a box stand in their place, and all else of the sections.
pub(super) fn read_sections(table: &Table) -> Option<(NamedLaws, SectionSpec)> {
    let matrices = read_matrices(table, &section::SECTION_STIFFNESS, &section::STIFFNESS_MATRIX);
    let tube = table.optional(&section::BOX_FIELD).map(|value| read_box(&value));
    let beside = section::BESIDE.map(|field| if_any(table.optional(field).map(|value| Law::read(&value))));
    let masses = read_matrices(table, &section::SECTION_MASS, &section::MASS_MATRIX);
    let hinge = if_any(table.optional(&section::HINGE_FIELD).map(|value| read_hinge(&value)));
    let (named, source) = match (matrices, tube) {
        (Some(matrices), _) => {
            let excluded =
                component::STIFFNESSES.into_iter().chain([&section::BOX_FIELD]).chain(section::BESIDE);
            exclude(table, &section::SECTION_STIFFNESS, excluded);
            (Some(Vec::new()), matrices.map(StiffnessSource::Matrices))
        }
        (None, Some(tube)) => {
            exclude(table, &section::BOX_FIELD, component::STIFFNESSES.into_iter());
            (Some(Vec::new()), tube.map(|tube| StiffnessSource::Box(Box::new(tube))))
        }
        (None, None) if component::STIFFNESSES.iter().all(|field| table.optional(field).is_none()) => {
            table.either(&component::SOURCES);
            (None, None)
        }
        (None, None) => {
            let law = |field: &Field| Some((field.name, table.required(field).and_then(|v| Law::read(&v))?));
            (component::STIFFNESSES.map(law).into_iter().collect(), Some(StiffnessSource::Laws))
        }
    };
    let beside = beside.into_iter().collect::<Option<_>>();
    let masses = masses.unwrap_or(Some(Vec::new()));
    Some((named?, SectionSpec { source: source?, beside: beside?, masses: masses?, hinge: hinge? }))
}

/// What was read of a field, if it is there: `None` where it could not be read.
fn if_any<T>(read: Option<Option<T>>) -> Option<Option<T>> {
    read.map_or(Some(None), |read| read.map(Some))
}

/// Complains about fields that something else stands in the place of.
fn exclude(table: &Table, source: &Field, excluded: impl Iterator<Item = &'static Field>) {
    for (field, value) in excluded.filter_map(|field| Some((field, table.optional(field)?))) {
        let found = format!("found \"{}\" and \"{}\"", source.name, field.name);
        let allowed = format!("\"{}\" says what the other does: one of the two is allowed", source.name);
        table.report.add(Problem::Contradiction, &value.place, found, allowed);
    }
}

/// Matrices at increasing places, if the field is there; within, `None` where they could not be read.
fn read_matrices(
    table: &Table,
    field: &'static Field,
    matrix: &'static Field,
) -> Option<Option<Vec<MatrixSpec>>> {
    let value = table.optional(field)?;
    if value.is_empty_list() {
        return Some(value.wrong("a list of at least one table"));
    }
    let read = |entry: &Table| {
        let place = entry.place.within(section::PLACE_OF_MATRIX.name);
        let at = entry.number(&section::PLACE_OF_MATRIX);
        let matrix = entry.required(matrix)?.located(read_matrix)?;
        Some((MatrixSpec { at, matrix }, place))
    };
    let all: Vec<Option<_>> = table.tables(field).iter().map(read).collect();
    let Some(all) = all.into_iter().collect::<Option<Vec<_>>>().filter(|all| !all.is_empty()) else {
        return Some(None);
    };
    for pair in all.windows(2) {
        let [(before, _), (after, place)] = [&pair[0], &pair[1]];
        if after.at <= before.at {
            let found = format!("found the place {} after {}", after.at, before.at);
            table.report.add(Problem::OutOfRange, place, found, "increasing places are allowed");
            return Some(None);
        }
    }
    Some(Some(all.into_iter().map(|(matrix, _)| matrix).collect()))
}

/// Six rows of six numbers that are those of the transpose too.
fn read_matrix(value: &Value) -> Option<Matrix6<f64>> {
    let what = "a list of six rows of six numbers";
    let rows = value.list(what)?;
    let rows: Vec<Option<Vec<f64>>> = rows.iter().map(Value::numbers).collect();
    let rows: Vec<Vec<f64>> = rows.into_iter().collect::<Option<_>>()?;
    if rows.len() != 6 || rows.iter().any(|row| row.len() != 6) {
        return value.wrong(what);
    }
    let matrix = Matrix6::from_fn(|i, j| rows[i][j]);
    for (i, j) in (0..6).flat_map(|i| (0..i).map(move |j| (i, j))) {
        let size = (matrix[(i, i)] * matrix[(j, j)]).abs().sqrt();
        let [one, other] = [matrix[(j, i)], matrix[(i, j)]];
        if (one - other).abs() > ROUNDED * size {
            let found = format!("found {one} in row {} and {other} in row {} in its place", j + 1, i + 1);
            let allowed = "a matrix that equals its transpose is allowed";
            value.report.add(Problem::Contradiction, &value.place, found, allowed);
            return None;
        }
    }
    Some((matrix + matrix.transpose()) * 0.5)
}

fn read_box(value: &Value) -> Option<BoxSpec> {
    let table = value.table()?;
    let needed = |field: &Field| table.required(field).and_then(|v| Law::read(&v));
    let (height, width, skin) = (needed(&section::HEIGHT), needed(&section::WIDTH), needed(&section::SKIN));
    let web = if_any(table.optional(&section::WEB).map(|v| Law::read(&v)));
    let number = |field: &Field| table.required(field).and_then(|v| v.number());
    let (young, shear) = (number(&section::YOUNG), number(&section::SHEAR_MODULUS));
    let density = if_any(table.optional(&section::BOX_DENSITY).map(|v| v.number()));
    Some(BoxSpec {
        place: table.place.clone(),
        height: height?,
        width: width?,
        skin: skin?,
        web: web?,
        young: young?,
        shear: shear?,
        density: density?,
    })
}

fn read_hinge(value: &Value) -> Option<HingeSpec> {
    let table = value.table()?;
    let has_one = table.optional(&section::HINGE_STIFFNESS).is_some();
    let axis = has_one.then(|| table.required(&section::HINGE_AXIS).and_then(|v| v.direction())).flatten();
    let (field, stiffness) = table.either(&section::HINGE_SPRINGS)?;
    if std::ptr::eq(field, &section::HINGE_STIFFNESS) {
        let stiffness = stiffness.number();
        return Some(HingeSpec::About { axis: axis?, stiffness: stiffness? });
    }
    if let Some(axis) = table.optional(&section::HINGE_AXIS) {
        let found = "found an axis and the springs about three others";
        let allowed = format!("an axis is allowed together with {}", section::HINGE_STIFFNESS.name);
        table.report.add(Problem::Contradiction, &axis.place, found, allowed);
    }
    stiffness.vector().map(HingeSpec::AboutLocalAxes)
}
