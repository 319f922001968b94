//! Numbers as text: for people, and tables of them as comma-separated values (RFC 4180), a line of names, then lines of
//! numbers.

use std::fmt::{self, Display, Write as _};
use std::io::{self, Write};

/// The shortest digits that give the same bits again; plainly from 1e-5 to 1e16, as people write them.
pub struct Plain(pub f64);

impl Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Plain(number) = self;
        let size = number.abs();
        if size == 0.0 || (1e-5..=1e16).contains(&size) {
            write!(f, "{number}")
        } else {
            write!(f, "{number:e}")
        }
    }
}

/// A number with so many places; what they do not show is 0, without a sign.
pub fn fixed(number: f64, places: usize) -> String {
    let text = format!("{number:.places$}");
    let is_zero = text.bytes().all(|letter| matches!(letter, b'-' | b'0' | b'.'));
    if is_zero { text.trim_start_matches('-').to_owned() } else { text.replace('-', "−") }
}

/// With six digits; what is less than nine places show is 0.
pub fn rounded(number: f64) -> String {
    if number.abs() < 5e-10 {
        return "0".to_owned();
    }
    fixed(number, (5.0 - number.abs().log10().floor()).clamp(0.0, 9.0) as usize)
}

/// Columns of equal widths, to the right.
pub fn aligned(lines: &[Vec<String>]) -> String {
    let columns = lines.first().map_or(0, Vec::len);
    let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let line = |line: &Vec<String>| {
        let cells = line.iter().zip(&widths).map(|(cell, width)| format!("{cell:>width$}"));
        cells.collect::<Vec<_>>().join("  ") + "\n"
    };
    lines.iter().map(line).collect()
}

/// The shortest digits that agree with a number to six: 19.572 of 19.572000000000003.
pub fn short(number: f64) -> Plain {
    // PROOF: what is written as a number is read as one; the number itself stands in for any doubt.
    Plain(format!("{number:.5e}").parse().unwrap_or(number))
}

/// A table on its way to where it is written.
pub struct NumberTable<W: Write> {
    writer: csv::Writer<W>,
    /// Of the number that is being written.
    digits: String,
}

impl<W: Write> NumberTable<W> {
    /// Begins with a line of names.
    ///
    /// # Errors
    /// When the sink takes nothing.
    pub fn new<'n>(sink: W, names: impl IntoIterator<Item = &'n str>) -> io::Result<Self> {
        let mut writer = csv::Writer::from_writer(sink);
        writer.write_record(names).map_err(io_error)?;
        Ok(NumberTable { writer, digits: String::new() })
    }

    /// A line with a number for each name.
    ///
    /// # Errors
    /// When the sink takes nothing, or there are more or fewer numbers than names.
    pub fn row(&mut self, numbers: impl IntoIterator<Item = f64>) -> io::Result<()> {
        for number in numbers {
            self.digits.clear();
            // PROOF: a string takes every text.
            let _ = write!(self.digits, "{}", Plain(number));
            self.writer.write_field(&self.digits).map_err(io_error)?;
        }
        self.writer.write_record(None::<&[u8]>).map_err(io_error)
    }

    /// What has been written to, with all rows.
    ///
    /// # Errors
    /// When the sink takes nothing.
    pub fn into_sink(mut self) -> io::Result<W> {
        self.writer.flush()?;
        self.writer.into_inner().map_err(|error| io::Error::other(error.to_string()))
    }
}

/// With its kind: a pipe that nobody reads is told from a full disk.
fn io_error(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_people_write_them_and_read_back_bit_for_bit() {
        let cases = [
            (127.0, "127"),
            (-0.05, "-0.05"),
            (0.0, "0"),
            (1e-5, "0.00001"),
            (9.9e-6, "9.9e-6"),
            (1e16, "10000000000000000"),
            (2.5e16, "2.5e16"),
            (0.1 + 0.2, "0.30000000000000004"),
        ];
        for (number, expected) in cases {
            let written = Plain(number).to_string();
            assert_eq!(written, expected);
            assert_eq!(written.parse::<f64>().unwrap().to_bits(), number.to_bits());
        }
    }

    #[test]
    fn what_the_places_do_not_show_has_no_sign() {
        assert_eq!([fixed(-1e-9, 4), fixed(-0.25, 4), fixed(12.0, 0)], ["0.0000", "−0.2500", "12"]);
    }

    #[test]
    fn rounding_of_what_was_computed_is_not_shown() {
        let shown = [19.572000000000003, 9.144, 106.68, -0.1 - 0.2].map(|number| short(number).to_string());
        assert_eq!(shown, ["19.572", "9.144", "106.68", "-0.3"]);
    }

    #[test]
    fn six_digits_are_enough_for_people() {
        let rounded = [123456.7, -12.34567, 1e-3, -1e-10].map(rounded);
        assert_eq!(rounded, ["123457", "−12.3457", "0.00100000", "0"]);
    }

    #[test]
    fn a_table_has_names_and_rows() {
        let mut table = NumberTable::new(Vec::new(), ["time", "a,b"]).unwrap();
        table.row([0.0, 127.0]).unwrap();
        assert_eq!(String::from_utf8(table.into_sink().unwrap()).unwrap(), "time,\"a,b\"\n0,127\n");
        let mut table = NumberTable::new(Vec::new(), ["time"]).unwrap();
        assert!(table.row([0.0, 127.0]).is_err());
    }
}
