//! A linear model for NumPy: a zip archive of arrays in its format 1.0, not compressed and without times, so that the same
//! model is the same bytes.

use std::io::{Cursor, Write};

use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use super::arrays::Array;

/// Data of an array begin at a multiple of this.
const ALIGNMENT: usize = 64;

/// The archive.
///
/// # Errors
/// When the archive cannot hold them.
pub fn bytes(arrays: &[(&'static str, Array)]) -> Result<Vec<u8>, ZipError> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(DateTime::DEFAULT)
        .unix_permissions(0o644);
    for (key, array) in arrays {
        archive.start_file(format!("{key}.npy"), options)?;
        archive.write_all(&npy(array))?;
    }
    Ok(archive.finish()?.into_inner())
}

/// A file of one array: doubles, or texts of four bytes a letter, padded to the longest.
fn npy(array: &Array) -> Vec<u8> {
    let numbers = |values: &[f64]| values.iter().flat_map(|value| value.to_le_bytes()).collect();
    let (kind, shape, data): (String, String, Vec<u8>) = match array {
        Array::Matrix { rows, columns, values } => {
            ("<f8".to_owned(), format!("({rows}, {columns})"), numbers(values))
        }
        Array::Vector(values) => ("<f8".to_owned(), format!("({},)", values.len()), numbers(values)),
        Array::Texts(texts) => {
            let longest = texts.iter().map(|text| text.chars().count()).fold(1, usize::max);
            let letters = |text: &String| -> Vec<u8> {
                let padded = text.chars().map(u32::from).chain(std::iter::repeat(0)).take(longest);
                padded.flat_map(u32::to_le_bytes).collect()
            };
            (format!("<U{longest}"), format!("({},)", texts.len()), texts.iter().flat_map(letters).collect())
        }
    };
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    let before = MAGIC.len() + 2;
    let padding = ALIGNMENT - (before + header.len() + 1) % ALIGNMENT;
    header += &" ".repeat(padding % ALIGNMENT);
    header.push('\n');
    let mut file = MAGIC.to_vec();
    file.extend((header.len() as u16).to_le_bytes());
    file.extend(header.as_bytes());
    file.extend(data);
    file
}

/// With the version of the format.
const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_array_is_laid_out_as_numpy_reads_it() {
        let file = npy(&Array::Matrix { rows: 1, columns: 2, values: vec![1.5, -2.0] });
        assert_eq!(file[..10], *b"\x93NUMPY\x01\x00\x76\x00");
        assert!(file[10..].starts_with(b"{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), } "));
        assert_eq!((file[127], file.len()), (b'\n', 128 + 16));
        assert_eq!(file[128..136], 1.5_f64.to_le_bytes());
        let file = npy(&Array::Texts(vec!["ab".to_owned(), "c".to_owned()]));
        assert!(file[10..].starts_with(b"{'descr': '<U2', 'fortran_order': False, 'shape': (2,), } "));
        assert_eq!(file[128..], *b"a\0\0\0b\0\0\0c\0\0\0\0\0\0\0");
    }
}
