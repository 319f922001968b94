//! A zip archive whose bytes depend on its contents alone: fixed order, fixed times, fixed permissions.

use std::io::{Cursor, Read, Write};

use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipArchive, ZipWriter};

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

/// Where importers look first.
pub(crate) const MODEL_DESCRIPTION: &str = "modelDescription.xml";

/// The archive with `entries`, the model description first and the others by their paths, all of them dated
/// 1 January 1980, the beginning of time of the zip format.
pub(crate) fn to_bytes(mut entries: Vec<Entry>) -> Result<Vec<u8>, ZipError> {
    entries.sort_by(|a, b| {
        let order = |entry: &Entry| entry.path != MODEL_DESCRIPTION;
        order(a).cmp(&order(b)).then_with(|| a.path.cmp(&b.path))
    });
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .compression_level(Some(9))
        .last_modified_time(DateTime::DEFAULT);
    for entry in &entries {
        let permissions = if entry.path.starts_with("binaries/") { 0o755 } else { 0o644 };
        archive.start_file(entry.path.as_str(), options.unix_permissions(permissions))?;
        archive.write_all(&entry.bytes)?;
    }
    Ok(archive.finish()?.into_inner())
}

/// The files of an archive, in its order.
pub(crate) fn from_bytes(bytes: &[u8]) -> Result<Vec<Entry>, ZipError> {
    let mut archive = ZipArchive::new(Cursor::new(bytes))?;
    let mut entries = Vec::new();
    for index in 0..archive.len() {
        let mut file = archive.by_index(index)?;
        if file.is_file() {
            let mut content = Vec::new();
            file.read_to_end(&mut content)?;
            entries.push(Entry::new(file.name()?, content));
        }
    }
    Ok(entries)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_model_description_is_first_and_the_others_are_sorted() {
        let paths = ["resources/a", "modelDescription.xml", "binaries/a.so", "resources/B"];
        let entries = paths.map(|path| Entry::new(path, path.repeat(100)));
        let bytes = to_bytes(entries.to_vec()).unwrap();
        let [resource, description, library, other] = entries;
        assert_eq!(from_bytes(&bytes).unwrap(), [description, library, other, resource]);
        let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
        for index in 0..archive.len() {
            assert_eq!(archive.by_index(index).unwrap().last_modified(), Some(DateTime::DEFAULT));
        }
    }
}
