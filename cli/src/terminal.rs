//! What the program says, on standard output and standard error.
//!
//! `println!` panics when nobody reads any more, as behind `| head -1`: it is not used.

use std::io::{self, ErrorKind, Write};

use flexible_aircraft_packaging::FileError;

/// Prints results. That nobody reads them any more is no error, for the reader had enough.
///
/// # Errors
/// When standard output takes nothing, as on a full disk.
pub fn print(text: &str) -> Result<(), FileError> {
    let mut output = io::stdout().lock();
    match output.write_all(text.as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        Err(source) => Err(FileError { action: "write to", path: "standard output".into(), source }),
        Ok(()) => Ok(()),
    }
}

/// A line for the one who watches: what is being done, a warning, an error.
pub fn note(text: &str) {
    // Nobody is left who could be told that it failed.
    let _ = writeln!(io::stderr(), "{text}");
}
