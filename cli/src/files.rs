//! Files that commands write: whole or not at all, and never over what was read.

use std::fs::File;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::builder::{PathBufValueParser, TypedValueParser};
use flexible_aircraft_packaging::{Draft, FileError, is_stream, open_stream, replaced_by};
use same_file::Handle;

/// The path that stands for standard input or standard output.
pub const STANDARD: &str = "-";

/// Reads the option of a picture, which standard output does not take: reports and tables go there.
pub fn picture() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new()
        .try_map(|path| if path == Path::new(STANDARD) { Err(PictureOnStandard) } else { Ok(path) })
}

/// A picture that is to go to standard output.
#[derive(Debug, thiserror::Error)]
#[error("allowed is the path of a file: pictures do not go to standard output; a file called `-` is `./-`")]
struct PictureOnStandard;

/// A path for people.
pub fn named(path: &Path, standard: &str) -> String {
    if path == Path::new(STANDARD) { standard.to_owned() } else { path.display().to_string() }
}

/// An output that would destroy something.
#[derive(Debug, thiserror::Error)]
pub enum Overwriting {
    #[error(
        "the output {} is the same file as the input {}, which would be lost: name another file",
        named(output, "standard output"),
        named(input, "standard input")
    )]
    Input { output: PathBuf, input: PathBuf },
    #[error("found {} twice among the outputs, each needs a file of its own", .0.display())]
    Output(PathBuf),
}

/// Makes sure that no output is an input or another output, by whatever path. What is no file, such as a device, may be
/// any number of them.
///
/// # Errors
/// At the first one that is.
pub fn refuse_overwriting<'p>(
    outputs: &[&Path],
    inputs: impl IntoIterator<Item = &'p Path>,
) -> Result<(), Overwriting> {
    // The path alone does not tell: the folders above it may be yet missing.
    let places: Vec<Option<PathBuf>> = outputs.iter().map(|output| replaced_by(output)).collect();
    let opened: Vec<Option<Handle>> = std::iter::zip(outputs, &places)
        .map(|(output, place)| match place {
            Some(place) if *output != Path::new(STANDARD) => file(place, Handle::stdout),
            _ => file(output, Handle::stdout),
        })
        .collect();
    for input in inputs {
        let Some(read) = file(input, Handle::stdin) else { continue };
        let mut written = outputs.iter().zip(&opened);
        if let Some((output, _)) = written.find(|(_, written)| written.as_ref() == Some(&read)) {
            let [output, input] = [output, &input].map(|path| path.to_path_buf());
            return Err(Overwriting::Input { output, input });
        }
    }
    for (index, output) in outputs.iter().enumerate() {
        let is_same = |other: usize| {
            places[other].is_some() && places[other] == places[index]
                || opened[other].is_some() && opened[other] == opened[index]
        };
        if (0..index).any(is_same) {
            return Err(Overwriting::Output(output.to_path_buf()));
        }
    }
    Ok(())
}

/// The file with this path, or behind standard input or output; none where there is no file or something else.
fn file(path: &Path, standard: fn() -> io::Result<Handle>) -> Option<Handle> {
    if path == Path::new(STANDARD) {
        let handle = standard().ok()?;
        return handle.as_file().metadata().ok()?.is_file().then_some(handle);
    }
    // Asked first: to open a named pipe is to wait for its other end.
    std::fs::metadata(path).ok()?.is_file().then(|| Handle::from_path(path).ok())?
}

/// Files that are written together at the end of long work: what cannot be written shows before it.
pub struct Drafts(Vec<Draft>);

impl Drafts {
    /// Drafts of these outputs, and the folders above them where they do not exist; all of that goes when they do.
    ///
    /// # Errors
    /// At the first that cannot be written.
    pub fn new<'p>(outputs: impl IntoIterator<Item = &'p Path>) -> Result<Self, FileError> {
        let mut drafts = Drafts(Vec::new());
        for output in outputs {
            drafts.0.push(Draft::new(output)?);
        }
        Ok(drafts)
    }

    /// None yet.
    pub fn none() -> Self {
        Drafts(Vec::new())
    }

    /// One more, which is written already.
    pub fn add(&mut self, draft: Draft) {
        self.0.push(draft);
    }

    /// Puts all that are written into their places.
    ///
    /// # Errors
    /// When one cannot be moved; what was there then stays.
    pub fn keep_written(mut self) -> Result<(), FileError> {
        while let Some(draft) = self.0.pop() {
            draft.keep()?;
        }
        Ok(())
    }

    /// Puts each content, in the order of the outputs, into its place, once all are written. Where there is none for the
    /// last outputs, what an earlier run has left there goes.
    ///
    /// # Errors
    /// When one cannot be written; what was there then stays.
    pub fn keep(mut self, contents: impl IntoIterator<Item = impl AsRef<[u8]>>) -> Result<(), FileError> {
        let mut written = 0;
        for (draft, content) in self.0.iter_mut().zip(contents) {
            let output = draft.output().to_owned();
            let failed = |source| FileError { action: "write", path: output, source };
            draft.write_all(content.as_ref()).map_err(failed)?;
            written += 1;
        }
        for draft in self.0.drain(written..) {
            draft.clear()?;
        }
        self.keep_written()
    }
}

impl Drop for Drafts {
    fn drop(&mut self) {
        // The first has made the folders: it goes last, when they are empty.
        while self.0.pop().is_some() {}
    }
}

/// Where rows go while they are computed.
pub enum Sink {
    /// Into a file, once it is whole.
    File(Draft),
    /// To whoever reads, at once.
    Stream(Box<dyn Write>),
}

impl Sink {
    /// # Errors
    /// When it cannot be opened.
    pub fn open(output: &Path) -> Result<Self, FileError> {
        if output == Path::new(STANDARD) {
            return Ok(Sink::Stream(Box::new(io::stdout().lock())));
        }
        if is_stream(output) {
            let failed = |source| FileError { action: "write to", path: output.to_owned(), source };
            return open_stream(output).map(|file: File| Sink::Stream(Box::new(file))).map_err(failed);
        }
        Draft::new(output).map(Sink::File)
    }

    /// The same for work that goes on when nobody reads any more.
    pub fn unheard(self) -> Self {
        match self {
            Sink::Stream(stream) => Sink::Stream(Box::new(Unheard(stream))),
            file => file,
        }
    }
}

/// A stream that takes everything where nobody reads.
struct Unheard<W>(W);

impl<W: Write> Write for Unheard<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.0.write(bytes) {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(bytes.len()),
            written => written,
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self.0.flush() {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
            flushed => flushed,
        }
    }
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Sink::File(draft) => Write::write(draft, bytes),
            Sink::Stream(stream) => stream.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Sink::File(draft) => draft.flush(),
            Sink::Stream(stream) => stream.flush(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_output_that_is_an_input_is_refused_by_any_path() {
        let folder = tempfile::tempdir().unwrap();
        let input = folder.path().join("inputs.csv");
        std::fs::write(&input, "time\n0\n").unwrap();
        let roundabout = folder.path().join("missing/../inputs.csv");
        let far = folder.path().join("missing/deep/../other/../../inputs.csv");
        let hard = folder.path().join("hard.csv");
        std::fs::hard_link(&input, &hard).unwrap();
        let mut paths = vec![input.clone(), roundabout, far, hard];
        #[cfg(unix)]
        {
            let soft = folder.path().join("soft.csv");
            std::os::unix::fs::symlink("inputs.csv", &soft).unwrap();
            paths.push(soft);
            let soft = folder.path().join("soft-roundabout.csv");
            std::os::unix::fs::symlink("missing/../inputs.csv", &soft).unwrap();
            paths.push(soft);
        }
        for output in paths {
            let refused = refuse_overwriting(&[&output], [input.as_path()]).unwrap_err().to_string();
            assert!(refused.contains("which would be lost"), "{refused}");
        }
        let other = folder.path().join("other.csv");
        refuse_overwriting(&[&other], [input.as_path()]).unwrap();
        std::fs::write(&other, "time\n0\n").unwrap();
        refuse_overwriting(&[&other], [input.as_path(), Path::new("missing")]).unwrap();
    }

    #[test]
    fn drafts_that_are_not_kept_leave_no_file_and_no_folder() {
        let folder = tempfile::tempdir().unwrap();
        let outputs = ["new/a.csv", "new/deep/b.csv"].map(|name| folder.path().join(name));
        drop(Drafts::new(outputs.iter().map(PathBuf::as_path)).unwrap());
        assert!(!folder.path().join("new").exists());
        std::fs::create_dir_all(&outputs[1]).unwrap();
        assert!(Drafts::new(outputs.iter().map(PathBuf::as_path)).is_err());
        assert_eq!(std::fs::read_dir(folder.path().join("new")).unwrap().count(), 1);
        std::fs::remove_dir(&outputs[1]).unwrap();
        let drafts = Drafts::new(outputs.iter().map(PathBuf::as_path)).unwrap();
        drafts.keep(["one", "two"]).unwrap();
        assert_eq!(outputs.map(|output| std::fs::read_to_string(output).unwrap()), ["one", "two"]);
    }

    #[test]
    fn two_outputs_are_two_files() {
        let [one, two] = ["one.csv", "two.csv"].map(Path::new);
        refuse_overwriting(&[one, two], []).unwrap();
        let refused = refuse_overwriting(&[one, two, one], []).unwrap_err().to_string();
        assert!(refused.starts_with("found one.csv twice"), "{refused}");
        let refused =
            refuse_overwriting(&[one, Path::new("missing/../one.csv")], []).unwrap_err().to_string();
        assert!(refused.starts_with("found missing/../one.csv twice"), "{refused}");
    }

    #[cfg(unix)]
    #[test]
    fn a_device_may_be_input_and_output() {
        let null = Path::new("/dev/null");
        refuse_overwriting(&[null, null], [null]).unwrap();
    }
}
