//! Temporary files and folders, which an interrupted program takes with it.
//!
//! A destructor does not run where a signal ends the program. Each temporary path is therefore listed while it
//! exists, and [`remove_all`] deletes what is on the list: the one thing here that is known to the whole program.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tempfile::{NamedTempFile, TempDir};

/// What stands at a temporary path.
#[derive(Clone, Copy, Debug)]
enum Kind {
    File,
    /// With all that is in it.
    Folder,
    /// Others may have put something into it: it is deleted only while it is empty.
    EmptyFolder,
}

static PATHS: Mutex<BTreeMap<PathBuf, Kind>> = Mutex::new(BTreeMap::new());

fn paths() -> MutexGuard<'static, BTreeMap<PathBuf, Kind>> {
    // The list is whole after every statement that changes it.
    PATHS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Deletes all temporary files and folders of this program, and lets nobody make any more: for a program that is about
/// to end at once.
pub fn remove_all() {
    let paths = paths();
    // What is in a folder comes after it in the list.
    for (path, kind) in paths.iter().rev() {
        // There is nobody left to tell what could not be deleted.
        let _ = match kind {
            Kind::File => std::fs::remove_file(path),
            Kind::Folder => remove_folder(path),
            Kind::EmptyFolder => std::fs::remove_dir(path),
        };
    }
    std::mem::forget(paths);
}

/// Deletes a folder into which another thread may still be unpacking, until it stays away.
fn remove_folder(path: &Path) -> io::Result<()> {
    for _ in 0..100 {
        let _ = std::fs::remove_dir_all(path);
        std::thread::sleep(Duration::from_millis(2));
        if !path.exists() {
            break;
        }
    }
    std::fs::remove_dir_all(path)
}

/// A path on the list; no longer when dropped.
#[derive(Debug)]
struct Listed(PathBuf);

impl Listed {
    /// Makes something and lists its path, with nothing in between that `remove_all` could miss.
    fn new<T>(kind: Kind, make: impl FnOnce() -> io::Result<(T, PathBuf)>) -> io::Result<(T, Self)> {
        let mut paths = paths();
        let (made, path) = make()?;
        paths.insert(path.clone(), kind);
        Ok((made, Listed(path)))
    }
}

impl Drop for Listed {
    fn drop(&mut self) {
        paths().remove(&self.0);
    }
}

/// A file that is deleted when dropped, unless it is moved to its place.
#[derive(Debug)]
pub(crate) struct TemporaryFile {
    // In this order: first deleted, then off the list.
    pub(crate) file: NamedTempFile,
    _listed: Listed,
}

impl TemporaryFile {
    /// An empty file, readable and writable as new files of this user are.
    pub(crate) fn new(folder: &Path) -> io::Result<Self> {
        let (file, listed) = Listed::new(Kind::File, || {
            let mut builder = tempfile::Builder::new();
            builder.prefix(".flexair-").suffix(".draft");
            #[cfg(unix)]
            builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
            // Deleted by the path that is listed, even if the working folder changes.
            let file = builder.tempfile_in(std::path::absolute(folder)?)?;
            let path = file.path().to_owned();
            Ok((file, path))
        })?;
        Ok(TemporaryFile { file, _listed: listed })
    }
}

/// A folder that is deleted when dropped, with all that is in it.
#[derive(Debug)]
pub(crate) struct TemporaryFolder {
    folder: TempDir,
    _listed: Listed,
}

impl TemporaryFolder {
    /// Where the system keeps temporary files.
    pub(crate) fn new() -> io::Result<Self> {
        let (folder, listed) = Listed::new(Kind::Folder, || {
            let folder = tempfile::tempdir()?;
            let path = folder.path().to_owned();
            Ok((folder, path))
        })?;
        Ok(TemporaryFolder { folder, _listed: listed })
    }

    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }
}

/// A folder that is deleted when dropped, if nothing is in it then.
#[derive(Debug)]
pub(crate) struct NewFolder(Listed);

impl NewFolder {
    /// Makes a folder and those above it where they do not exist: those made, the deepest first.
    pub(crate) fn make(folder: &Path) -> io::Result<Vec<Self>> {
        let folder = std::path::absolute(folder)?;
        let missing: Vec<&Path> = folder.ancestors().take_while(|folder| !folder.exists()).collect();
        let mut made = Vec::new();
        for folder in missing.into_iter().rev() {
            let make = || match std::fs::create_dir(folder) {
                // Somebody else was faster.
                Err(_) if folder.is_dir() => Ok(((), folder.to_owned())),
                made => made.map(|()| ((), folder.to_owned())),
            };
            made.insert(0, NewFolder(Listed::new(Kind::EmptyFolder, make)?.1));
        }
        Ok(made)
    }
}

impl Drop for NewFolder {
    fn drop(&mut self) {
        // One that holds something stays.
        let _ = std::fs::remove_dir(&self.0.0);
    }
}
