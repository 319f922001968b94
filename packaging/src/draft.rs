//! An FMU that is written but not yet in its place, so that it can be tried before it replaces a good one.

use std::path::{Path, PathBuf};

use crate::PackageError;

/// An FMU in a file beside its place; deleted when dropped, unless it is [kept](Self::keep).
#[derive(Debug)]
pub struct Draft {
    path: PathBuf,
    output: PathBuf,
    size: usize,
}

impl Draft {
    /// Writes the bytes of an FMU beside `output`, and the folders above it where they do not exist.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(bytes: &[u8], output: &Path) -> Result<Self, PackageError> {
        let failed = |action| move |source| PackageError::File { action, path: output.to_owned(), source };
        if let Some(folder) = output.parent() {
            std::fs::create_dir_all(folder).map_err(failed("make the folder of"))?;
        }
        let mut name = output.as_os_str().to_owned();
        name.push(format!(".{}.draft", std::process::id()));
        let draft = Draft { path: name.into(), output: output.to_owned(), size: bytes.len() };
        std::fs::write(&draft.path, bytes).map_err(failed("write"))?;
        Ok(draft)
    }

    /// Where it is now.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Bytes.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Moves it to its place, over what is there.
    ///
    /// # Errors
    /// When the file cannot be moved; what was there then stays.
    pub fn keep(self) -> Result<(), PackageError> {
        let failed = |source| PackageError::File { action: "write", path: self.output.clone(), source };
        std::fs::rename(&self.path, &self.output).map_err(failed)
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        // Where it was kept or could not be written, there is nothing to delete.
        let _ = std::fs::remove_file(&self.path);
    }
}
