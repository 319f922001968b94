//! The program, and what it works on.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A folder of the workspace or a file in it.
pub fn workspace(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

/// `flexair` with arguments, as on a command line without quotes, in a folder.
pub fn flexair(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_flexair"));
    command.current_dir(folder).args(arguments.split_whitespace()).stdin(Stdio::null());
    command
}

/// Runs it to the end.
pub fn run(folder: &Path, arguments: &str) -> Output {
    flexair(folder, arguments).output().unwrap()
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// The names of what is in a folder, in alphabetical order.
pub fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// `PLATFORM=FILE` of the library that cargo built beside this test, for `package --binary`.
pub fn library() -> String {
    let name = format!("{}flexible_aircraft{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let library = std::env::current_exe().unwrap().with_file_name(name);
    let platform = flexible_aircraft_packaging::Platform::host().unwrap();
    format!("{platform}={}", library.display())
}
