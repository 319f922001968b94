//! A file that is written but not yet in its place, so that what stands there is replaced by something whole, or by
//! nothing.

use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};

use crate::FileError;
use crate::temporary::{NewFolder, TemporaryFile};

/// A file beside its place; deleted when dropped, unless it is [kept](Self::keep).
///
/// Where a symbolic link stands, the place is where it leads. What is no file, such as a device or a named pipe,
/// cannot be replaced: the draft is then written to it.
#[derive(Debug)]
pub struct Draft {
    // In this order: a folder that was made for the file can be deleted once it is empty.
    file: TemporaryFile,
    _folders: Vec<NewFolder>,
    output: PathBuf,
    place: Place,
    size: u64,
}

/// What a draft becomes.
#[derive(Debug)]
enum Place {
    /// The file with this path, which is no link.
    File(PathBuf),
    /// Bytes that go there.
    Stream(PathBuf),
}

impl Draft {
    /// An empty draft of `output`, and the folders above it where they do not exist; these go when the draft does.
    ///
    /// # Errors
    /// When no file can be written there.
    pub fn new(output: &Path) -> Result<Self, FileError> {
        let failed = |source| FileError { action: "write", path: output.to_owned(), source };
        let place = place(output).map_err(failed)?;
        let (folder, permissions) = match &place {
            Place::File(path) => (folder_of(path), replaced(path).map_err(failed)?),
            Place::Stream(_) => (std::env::temp_dir(), None),
        };
        let folders = NewFolder::make(&folder).map_err(failed)?;
        let file = TemporaryFile::new(&folder).map_err(failed)?;
        if let Some(permissions) = permissions {
            file.file.as_file().set_permissions(permissions).map_err(failed)?;
        }
        Ok(Draft { file, _folders: folders, output: output.to_owned(), place, size: 0 })
    }

    /// A draft of `output` with these bytes.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(bytes: &[u8], output: &Path) -> Result<Self, FileError> {
        let mut draft = Draft::new(output)?;
        let failed = |source| FileError { action: "write", path: output.to_owned(), source };
        draft.write_all(bytes).map_err(failed)?;
        Ok(draft)
    }

    /// Where it is now.
    pub fn path(&self) -> &Path {
        self.file.file.path()
    }

    /// What it is a draft of.
    pub fn output(&self) -> &Path {
        &self.output
    }

    /// Bytes.
    pub fn size(&self) -> u64 {
        self.size
    }

    /// Moves it to its place, over what is there.
    ///
    /// # Errors
    /// When the file cannot be moved; what was there then stays.
    pub fn keep(self) -> Result<(), FileError> {
        let failed = |source| FileError { action: "write", path: self.output.clone(), source };
        match &self.place {
            Place::File(path) => self.file.file.persist(path).map(drop).map_err(|error| failed(error.error)),
            Place::Stream(path) => {
                let mut written = File::open(self.file.file.path()).map_err(failed)?;
                let mut stream = open_stream(path).map_err(failed)?;
                io::copy(&mut written, &mut stream).map(drop).map_err(failed)
            }
        }
    }

    /// Leaves its place empty: a file that stands there goes.
    ///
    /// # Errors
    /// When there is one that cannot be deleted.
    pub fn clear(self) -> Result<(), FileError> {
        let failed = |source| FileError { action: "delete", path: self.output.clone(), source };
        match &self.place {
            Place::File(path) if path.exists() => std::fs::remove_file(path).map_err(failed),
            Place::File(_) | Place::Stream(_) => Ok(()),
        }
    }

    /// As [`keep`](Self::keep), at another place.
    ///
    /// # Errors
    /// As [`keep`](Self::keep).
    pub fn keep_as(mut self, output: &Path) -> Result<(), FileError> {
        let failed = |source| FileError { action: "write", path: output.to_owned(), source };
        self.place = place(output).map_err(failed)?;
        self.output = output.to_owned();
        self.keep()
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.file.write(bytes)?;
        self.size += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.file.flush()
    }
}

/// Whether what stands at this path takes bytes as they come and cannot be replaced: a device, a named pipe, or a file
/// that another program has opened for this one (`/dev/stdout`).
pub fn is_stream(output: &Path) -> bool {
    let is_special = |metadata: std::fs::Metadata| !metadata.is_file() && !metadata.is_dir();
    let opened = ["/dev/stdout", "/dev/stderr", "/dev/fd", "/proc"];
    opened.iter().any(|opened| output.starts_with(opened)) || std::fs::metadata(output).is_ok_and(is_special)
}

/// Opens what [`is_stream`].
///
/// # Errors
/// When it cannot be opened.
pub fn open_stream(output: &Path) -> io::Result<File> {
    // Appended, because it may be a file that others write to as well.
    OpenOptions::new().append(true).open(output)
}

/// The path of the file that a draft of `output` replaces or makes, without links and without folders that are yet
/// missing; none where that is no file.
pub fn replaced_by(output: &Path) -> Option<PathBuf> {
    match place(output) {
        Ok(Place::File(path)) => Some(path),
        Ok(Place::Stream(_)) | Err(_) => None,
    }
}

fn place(output: &Path) -> io::Result<Place> {
    // More links than systems follow.
    const LINKS: usize = 40;
    let is_folder = || Err(io::Error::new(io::ErrorKind::IsADirectory, "found a folder, expected a file"));
    if is_stream(output) {
        return Ok(Place::Stream(output.to_owned()));
    }
    // A separator at the end means a folder, also where none is yet.
    if output.to_string_lossy().ends_with(std::path::is_separator) {
        return is_folder();
    }
    let mut path = past_missing_folders(output)?;
    for _ in 0..LINKS {
        match std::fs::read_link(&path) {
            Ok(target) => path = past_missing_folders(&folder_of(&path).join(target))?,
            Err(_) if is_stream(&path) => return Ok(Place::Stream(path)),
            // It is no link, or does not exist.
            Err(_) if path.is_dir() || path.file_name().is_none() => return is_folder(),
            Err(_) => return Ok(Place::File(path)),
        }
    }
    Err(io::Error::other("too many symbolic links"))
}

/// The path as it would be read if all its folders were there: `missing/../a.csv` is `a.csv`, and not a file that is
/// first found once `missing` is made.
fn past_missing_folders(path: &Path) -> io::Result<PathBuf> {
    let mut past = PathBuf::new();
    for component in std::path::absolute(path)?.components() {
        if component == Component::ParentDir && !past.exists() {
            past.pop();
        } else {
            past.push(component);
        }
    }
    Ok(past)
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// The permissions of the file that is replaced, if there is one. It must be one that could be written to: renaming would
/// overcome its protection.
fn replaced(path: &Path) -> io::Result<Option<std::fs::Permissions>> {
    match OpenOptions::new().write(true).open(path) {
        Ok(file) => Ok(Some(file.metadata()?.permissions())),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let names = std::fs::read_dir(folder).unwrap();
        let mut names: Vec<String> =
            names.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_comes_into_its_place_when_it_is_whole() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("a.fmu");
        std::fs::write(&output, "old").unwrap();
        let draft = Draft::write(b"new", &output).unwrap();
        assert_eq!((draft.size(), std::fs::read(draft.path()).unwrap()), (3, b"new".to_vec()));
        assert_eq!(draft.path().parent(), output.parent());
        assert_eq!(std::fs::read_to_string(&output).unwrap(), "old");
        draft.keep().unwrap();
        assert_eq!(std::fs::read_to_string(&output).unwrap(), "new");
        assert_eq!(names(folder.path()), ["a.fmu"]);
    }

    #[test]
    fn a_draft_that_is_not_kept_leaves_no_file_and_no_folder() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("new/deep/a.csv");
        let draft = Draft::write(b"half of it", &output).unwrap();
        assert_eq!(names(folder.path()), ["new"]);
        drop(draft);
        assert_eq!(names(folder.path()), [""; 0]);
        Draft::write(b"all of it", &output).unwrap().keep().unwrap();
        assert_eq!(names(&folder.path().join("new/deep")), ["a.csv"]);
    }

    #[test]
    fn a_folder_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        for path in [folder.path().to_owned(), folder.path().join("new/")] {
            let error = Draft::new(&path).unwrap_err().to_string();
            assert!(error.contains("found a folder, expected a file"), "{error}");
        }
        assert!(Draft::new(Path::new("")).is_err());
    }

    #[test]
    fn a_folder_that_is_missing_and_left_again_is_not_made() {
        let folder = tempfile::tempdir().unwrap();
        let roundabout = folder.path().join("missing/deep/../../a.csv");
        assert_eq!(replaced_by(&roundabout), Some(std::path::absolute(folder.path().join("a.csv")).unwrap()));
        Draft::write(b"all of it", &roundabout).unwrap().keep().unwrap();
        assert_eq!(names(folder.path()), ["a.csv"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_device_is_no_file_by_any_path() {
        assert!(matches!(place(Path::new("/missing/../dev/null")).unwrap(), Place::Stream(_)));
    }

    #[cfg(unix)]
    #[test]
    fn the_target_of_a_link_is_replaced_and_not_the_link() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("elsewhere")).unwrap();
        let output = folder.path().join("link.csv");
        std::os::unix::fs::symlink("elsewhere/a.csv", &output).unwrap();
        // At first the link leads nowhere.
        for content in ["one", "two"] {
            Draft::write(content.as_bytes(), &output).unwrap().keep().unwrap();
            assert!(output.is_symlink());
            assert_eq!(std::fs::read_to_string(folder.path().join("elsewhere/a.csv")).unwrap(), content);
        }
        let round = folder.path().join("round");
        std::os::unix::fs::symlink("round", &round).unwrap();
        assert!(Draft::new(&round).unwrap_err().to_string().contains("symbolic links"));
    }

    #[cfg(unix)]
    #[test]
    fn a_device_is_written_to_and_stays() {
        let draft = Draft::write(b"something", Path::new("/dev/null")).unwrap();
        assert_eq!(std::fs::read(draft.path()).unwrap(), b"something");
        draft.keep().unwrap();
        let null = std::fs::metadata("/dev/null").unwrap();
        assert!(!null.is_file() && is_stream(Path::new("/dev/null")));
        assert!(is_stream(Path::new("/dev/stdout")) && !is_stream(Path::new("/dev/shm/new.csv")));
    }

    #[cfg(unix)]
    #[test]
    fn permissions_are_those_of_the_file_that_was_there() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let [old, new] = ["old", "new"].map(|name| folder.path().join(name));
        let mode = |path: &Path| std::fs::metadata(path).unwrap().permissions().mode() & 0o777;
        std::fs::write(&old, "").unwrap();
        std::fs::write(&new, "").unwrap();
        let usual = mode(&new);
        std::fs::remove_file(&new).unwrap();
        std::fs::set_permissions(&old, PermissionsExt::from_mode(0o640)).unwrap();
        for path in [&old, &new] {
            Draft::new(path).unwrap().keep().unwrap();
        }
        assert_eq!((mode(&old), mode(&new)), (0o640, usual));
    }
}
