//! A zip archive whose bytes depend on its contents alone: fixed order, fixed times, fixed permissions.

use std::io::{Cursor, Write};

use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// A file of the archive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Entry {
    /// Path inside the archive, with forward slashes.
    pub path: String,
    /// Content.
    pub bytes: Vec<u8>,
}

impl Entry {
    pub(crate) fn new(path: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        Entry { path: path.into(), bytes: bytes.into() }
    }
}

/// The archive with `entries` in the given order, all of them dated 1 January 1980, the beginning of
/// time of the zip format.
pub(crate) fn to_bytes(entries: &[Entry]) -> Result<Vec<u8>, ZipError> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .compression_level(Some(9))
        .last_modified_time(DateTime::DEFAULT);
    for entry in entries {
        let permissions = if entry.path.starts_with("binaries/") { 0o755 } else { 0o644 };
        archive.start_file(entry.path.as_str(), options.unix_permissions(permissions))?;
        archive.write_all(&entry.bytes)?;
    }
    Ok(archive.finish()?.into_inner())
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use super::*;

    #[test]
    fn entries_are_read_back_in_their_order_with_the_fixed_time() {
        let entries = [Entry::new("b.txt", "second letter"), Entry::new("binaries/a.so", vec![0; 1000])];
        let bytes = to_bytes(&entries).unwrap();
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
        assert_eq!(archive.len(), entries.len());
        for (index, entry) in entries.iter().enumerate() {
            let mut file = archive.by_index(index).unwrap();
            assert_eq!(file.name().unwrap(), entry.path);
            assert_eq!(file.last_modified(), Some(DateTime::DEFAULT));
            let mut content = Vec::new();
            file.read_to_end(&mut content).unwrap();
            assert_eq!(content, entry.bytes);
        }
    }
}
