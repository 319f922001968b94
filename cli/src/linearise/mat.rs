//! A linear model for MATLAB: a MAT-file of level 5, not compressed and without a date, so that the same model is the same bytes.
//!
//! Elements are tagged with type and size and padded to eight bytes (*MAT-File Format*, The MathWorks).

use super::arrays::Array;

/// Types of elements.
const INT8: u32 = 1;
const UINT16: u32 = 4;
const INT32: u32 = 5;
const UINT32: u32 = 6;
const DOUBLE: u32 = 9;
const MATRIX: u32 = 14;

/// Classes of arrays.
const CELLS: u32 = 1;
const LETTERS: u32 = 4;
const DOUBLES: u32 = 6;

/// The names under which `ss` of MATLAB takes names and units, and the keys of these.
const FOR_SS: [(&str, &str); 6] = [
    ("StateName", "x_names"),
    ("InputName", "u_names"),
    ("OutputName", "y_names"),
    ("StateUnit", "x_units"),
    ("InputUnit", "u_units"),
    ("OutputUnit", "y_units"),
];

/// Of the text before the first element, and of all before it.
const TEXT: usize = 116;

/// The file.
pub fn bytes(arrays: &[(&'static str, Array)]) -> Vec<u8> {
    let mut file = b"MATLAB 5.0 MAT-file, linear model of flexair".to_vec();
    file.resize(TEXT, b' ');
    // No further data; version 1.0, least significant bytes first.
    file.extend([0; 8]);
    file.extend(b"\x00\x01IM");
    for (key, array) in arrays {
        file.extend(variable(key, array));
    }
    for (name, of) in FOR_SS {
        let named = arrays.iter().find(|(key, _)| *key == of);
        file.extend(named.into_iter().flat_map(|(_, array)| variable(name, array)));
    }
    file
}

/// A variable: a matrix, a column of numbers, or a column of cells with texts.
fn variable(name: &str, array: &Array) -> Vec<u8> {
    match array {
        Array::Matrix { rows, columns, values } => {
            let by_columns = (0..*columns).flat_map(|j| (0..*rows).map(move |i| values[i * columns + j]));
            matrix(name, DOUBLES, [*rows, *columns], &doubles(by_columns))
        }
        Array::Vector(values) => matrix(name, DOUBLES, [values.len(), 1], &doubles(values.iter().copied())),
        Array::Texts(texts) => {
            let cells: Vec<u8> = texts.iter().flat_map(|text| letters(text)).collect();
            matrix(name, CELLS, [texts.len(), 1], &cells)
        }
    }
}

fn doubles(values: impl Iterator<Item = f64>) -> Vec<u8> {
    element(DOUBLE, &values.flat_map(f64::to_le_bytes).collect::<Vec<u8>>())
}

/// A text as a row of letters without a name.
fn letters(text: &str) -> Vec<u8> {
    let units: Vec<u16> = text.encode_utf16().collect();
    let bytes: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
    matrix("", LETTERS, [1, units.len()], &element(UINT16, &bytes))
}

/// An array: class, shape, name, content.
fn matrix(name: &str, class: u32, shape: [usize; 2], content: &[u8]) -> Vec<u8> {
    let flags = element(UINT32, &[class, 0].map(u32::to_le_bytes).concat());
    let shape = element(INT32, &shape.map(|size| (size as i32).to_le_bytes()).concat());
    let name = element(INT8, name.as_bytes());
    element(MATRIX, &[flags, shape, name, content.to_vec()].concat())
}

/// Content with its tag, padded.
fn element(kind: u32, content: &[u8]) -> Vec<u8> {
    let mut bytes = [kind, content.len() as u32].map(u32::to_le_bytes).concat();
    bytes.extend(content);
    bytes.resize(bytes.len().next_multiple_of(8), 0);
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_laid_out_as_matlab_reads_it() {
        let arrays = [
            ("A", Array::Matrix { rows: 1, columns: 2, values: vec![1.5, -2.0] }),
            ("x_names", Array::Texts(vec!["rate.y".to_owned()])),
        ];
        let file = bytes(&arrays);
        assert_eq!(file[124..128], *b"\x00\x01IM");
        let words = |range: std::ops::Range<usize>| -> Vec<u32> {
            file[range].chunks(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect()
        };
        // Tag; flags; shape; name; tag of the numbers.
        assert_eq!(words(128..136), [MATRIX, 16 + 16 + 16 + 24]);
        assert_eq!(words(136..152), [UINT32, 8, DOUBLES, 0]);
        assert_eq!(words(152..168), [INT32, 8, 1, 2]);
        assert_eq!((words(168..176), file[176]), (vec![INT8, 1], b'A'));
        assert_eq!(words(184..192), [DOUBLE, 16]);
        assert_eq!(file[192..200], 1.5_f64.to_le_bytes());
        // Cells hold unnamed rows of letters; the same stand under the name that `ss` takes.
        assert_eq!(words(208..212), [MATRIX]);
        for name in ["x_names", "StateName"] {
            assert_eq!(file.windows(name.len()).filter(|part| *part == name.as_bytes()).count(), 1, "{name}");
        }
        assert_eq!(file.windows(4).filter(|part| *part == b"r\0a\0").count(), 2);
        assert_eq!(file.len() % 8, 0);
    }
}
