//! A part of a sweep's table: a Parquet file with the rows of some points.

use std::fs::File;
use std::io::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::column::reader::ColumnReader;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{WriterProperties, WriterPropertiesPtr};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{Type, TypePtr};
use serde_json::{Map, Value};

use super::columns::Column;
use super::job::{Failure, Status, Success};

/// The row of a point.
pub struct Row {
    pub point: u64,
    /// Of what varies.
    pub varied: Vec<f64>,
    pub outcome: Result<Success, Failure>,
}

/// How parts are written.
pub struct Format {
    schema: TypePtr,
    properties: WriterPropertiesPtr,
    varied: usize,
    kept: usize,
}

/// A file that is no part of a sweep.
#[derive(Debug, thiserror::Error)]
#[error("{}: {reason}; delete it, and its points are flown again", path.display())]
pub struct BrokenPart {
    path: PathBuf,
    reason: String,
}

/// How points came out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outcomes {
    /// How many how, in the order of [`Status::ALL`].
    pub tally: [u64; Status::ALL.len()],
    /// The first point that did not come out, and why.
    pub first_failure: Option<(u64, String)>,
}

impl Row {
    pub fn status(&self) -> Status {
        self.outcome.as_ref().map_or_else(|failure| failure.status, |_| Status::Ok)
    }

    fn message(&self) -> &str {
        self.outcome.as_ref().map_or_else(|failure| &failure.message, |success| &success.warning)
    }

    fn kept(&self, column: usize) -> Option<f64> {
        *self.outcome.as_ref().ok()?.numbers.get(column)?
    }
}

impl Format {
    /// Of a table with these columns of numbers, units by their names in the metadata of each file.
    ///
    /// # Errors
    /// When Parquet allows no such columns.
    pub fn new(varied: &[Column], kept: &[Column]) -> Result<Self, ParquetError> {
        let number = |column: &Column, repetition| field(&column.name, Physical::DOUBLE, None, repetition);
        let text =
            |name: &str| field(name, Physical::BYTE_ARRAY, Some(LogicalType::String), Repetition::REQUIRED);
        let mut fields = vec![field("point", Physical::INT64, None, Repetition::REQUIRED)?];
        for column in varied {
            fields.push(number(column, Repetition::REQUIRED)?);
        }
        fields.extend([text("status")?, text("message")?]);
        for column in kept {
            fields.push(number(column, Repetition::OPTIONAL)?);
        }
        let schema = Type::group_type_builder("sweep").with_fields(fields).build()?;
        let units = varied.iter().chain(kept).map(|column| (column.name.clone(), column.unit.clone().into()));
        let units = Value::Object(units.collect::<Map<String, Value>>()).to_string();
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            // Numbers rarely repeat; statuses and messages do.
            .set_dictionary_enabled(false)
            .set_column_dictionary_enabled("status".into(), true)
            .set_column_dictionary_enabled("message".into(), true)
            .set_key_value_metadata(Some(vec![KeyValue::new("units".to_owned(), units)]));
        Ok(Format {
            schema: Arc::new(schema),
            properties: Arc::new(properties.build()),
            varied: varied.len(),
            kept: kept.len(),
        })
    }

    /// A file with some rows, as bytes.
    ///
    /// # Errors
    /// When Parquet does not take them.
    pub fn bytes(&self, rows: &[Row]) -> Result<Vec<u8>, ParquetError> {
        let schema = Arc::clone(&self.schema);
        let mut file = SerializedFileWriter::new(Vec::new(), schema, Arc::clone(&self.properties))?;
        let mut group = file.next_row_group()?;
        let points: Vec<i64> = rows.iter().map(|row| row.point as i64).collect();
        write::<Int64Type, _>(&mut group, &points, None)?;
        for column in 0..self.varied {
            let numbers: Vec<f64> = rows.iter().map(|row| row.varied[column]).collect();
            write::<DoubleType, _>(&mut group, &numbers, None)?;
        }
        let texts =
            |text: fn(&Row) -> &str| rows.iter().map(|row| text(row).into()).collect::<Vec<ByteArray>>();
        write::<ByteArrayType, _>(&mut group, &texts(|row| row.status().name()), None)?;
        write::<ByteArrayType, _>(&mut group, &texts(Row::message), None)?;
        for column in 0..self.kept {
            let kept: Vec<Option<f64>> = rows.iter().map(|row| row.kept(column)).collect();
            let is_there: Vec<i16> = kept.iter().map(|number| i16::from(number.is_some())).collect();
            let numbers: Vec<f64> = kept.into_iter().flatten().collect();
            write::<DoubleType, _>(&mut group, &numbers, Some(&is_there))?;
        }
        group.close()?;
        file.into_inner()
    }
}

fn field(
    name: &str,
    physical: Physical,
    logical: Option<LogicalType>,
    repetition: Repetition,
) -> Result<TypePtr, ParquetError> {
    let builder = Type::primitive_type_builder(name, physical).with_repetition(repetition);
    builder.with_logical_type(logical).build().map(Arc::new)
}

/// Writes the next column.
fn write<T: parquet::data_type::DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    values: &[T::T],
    is_there: Option<&[i16]>,
) -> Result<(), ParquetError> {
    let column = group.next_column()?;
    let mut column =
        column.ok_or_else(|| ParquetError::General("more columns than the schema has".to_owned()))?;
    column.typed::<T>().write_batch(values, is_there, None)?;
    column.close()
}

impl Outcomes {
    /// Of rows, in the order of their points.
    pub fn of(rows: &[Row]) -> Self {
        let mut outcomes = Outcomes::default();
        for row in rows {
            outcomes.count(row.status(), row.point, || row.message().to_owned());
        }
        outcomes
    }

    /// Of the part of some points.
    ///
    /// # Errors
    /// When it is not a whole part.
    pub fn read(path: &Path, points: &Range<u64>) -> Result<Self, BrokenPart> {
        let broken = |reason: String| BrokenPart { path: path.to_owned(), reason };
        let file = File::open(path).map_err(|error| broken(error.to_string()))?;
        let texts = texts(file, ["status", "message"]).map_err(|error| broken(error.to_string()))?;
        let [statuses, messages] = &texts;
        let expected = points.end - points.start;
        if [statuses, messages].iter().any(|column| column.len() as u64 != expected) {
            return Err(broken(format!("found {} points, expected {expected}", statuses.len())));
        }
        let mut outcomes = Outcomes::default();
        for (point, (status, message)) in points.clone().zip(statuses.iter().zip(messages)) {
            let status = Status::ALL.into_iter().find(|known| known.name().as_bytes() == status.data());
            let status = status.ok_or_else(|| broken("found a status that no sweep writes".to_owned()))?;
            outcomes.count(status, point, || String::from_utf8_lossy(message.data()).into_owned());
        }
        Ok(outcomes)
    }

    fn count(&mut self, status: Status, point: u64, message: impl FnOnce() -> String) {
        self.tally[Status::ALL.iter().position(|known| *known == status).unwrap_or(0)] += 1;
        if status != Status::Ok && self.first_failure.is_none() {
            self.first_failure = Some((point, message()));
        }
    }

    /// With those of other points.
    pub fn add(&mut self, others: Outcomes) {
        self.tally.iter_mut().zip(others.tally).for_each(|(sum, more)| *sum += more);
        let failures = [self.first_failure.take(), others.first_failure];
        self.first_failure = failures.into_iter().flatten().min();
    }
}

/// All texts of some columns.
fn texts<const N: usize>(file: File, names: [&str; N]) -> Result<[Vec<ByteArray>; N], ParquetError> {
    let reader = SerializedFileReader::new(file)?;
    let schema = reader.metadata().file_metadata().schema_descr();
    let mut found = names.map(|_| Vec::new());
    for (name, found) in names.iter().zip(&mut found) {
        let column = schema.columns().iter().position(|column| column.name() == *name);
        let column = column.ok_or_else(|| ParquetError::General(format!("found no column `{name}`")))?;
        for group in 0..reader.num_row_groups() {
            let group = reader.get_row_group(group)?;
            let rows = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
            if let ColumnReader::ByteArrayColumnReader(mut reader) = group.get_column_reader(column)? {
                reader.read_records(rows, None, None, found)?;
            }
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests;
