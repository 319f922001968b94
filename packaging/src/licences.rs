//! The licences of everything that is linked into the shared library, as `documentation/licenses/`.
//!
//! cargo knows what is linked: the packages that the library needs at run time, without procedural macros, build
//! scripts and what only tests and tools use. Those of all platforms are listed, whichever are packaged, so that
//! FMUs packaged on different machines have the same list.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde::Deserialize;

use crate::archive::Entry;
use crate::{FileError, PackageError, Platform, read};

/// What `cargo metadata` prints, as far as it matters here.
#[derive(Deserialize)]
struct Metadata {
    packages: Vec<LibraryPackage>,
}

#[derive(Deserialize)]
struct LibraryPackage {
    name: String,
    version: String,
    license: Option<String>,
    manifest_path: PathBuf,
}

/// The licence files of `flexible-aircraft` and of all it is linked with, and a list of them.
pub(crate) fn gather(workspace: &Path) -> Result<Vec<Entry>, PackageError> {
    let mut list = String::from(LIST_HEAD);
    let mut entries = Vec::new();
    for package in linked_packages(workspace)? {
        let licence = package.license.as_deref().unwrap_or("see its licence file");
        list.push_str(&format!("{} {}: {licence}\n", package.name, package.version));
        for file in licence_files(&package)? {
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            let path = format!("documentation/licenses/{}-{}/{name}", package.name, package.version);
            entries.push(Entry::new(path, read(&file)?));
        }
    }
    entries.insert(0, Entry::new("documentation/licenses/README.txt", list));
    Ok(entries)
}

const LIST_HEAD: &str = "\
Linked into the shared library, with the licences that their authors chose. The texts are in the folders
beside this file. The library also contains parts of the Rust standard library (The Rust Project
contributors, MIT OR Apache-2.0: the texts are those of flexible-aircraft). What packaging/build-platforms.sh
links also contains parts of LLVM's libunwind (Apache-2.0 WITH LLVM-exception) and of zig's compiler_rt (MIT), for
Windows instead of mingw-w64's run-time library (public domain) and of GCC's (GPL-3.0-or-later WITH GCC-exception-3.1).

";

/// What the library needs at run time on any platform, by name and version.
///
/// `cargo tree` knows which features are on; `cargo metadata` knows where the sources are.
fn linked_packages(workspace: &Path) -> Result<Vec<LibraryPackage>, PackageError> {
    let mut tree = vec!["tree", "--locked", "--package", "flexible-aircraft"];
    tree.extend(["--edges", "normal,no-proc-macro", "--prefix", "none", "--format", "{p}"]);
    for platform in Platform::ALL {
        tree.extend(["--target", platform.target_triple()]);
    }
    let tree = cargo(workspace, &tree)?;
    let tree = String::from_utf8_lossy(&tree);
    // A line is a name and a version with a v, perhaps followed by remarks.
    let linked: BTreeSet<(&str, &str)> = tree
        .lines()
        .filter_map(|line| {
            let mut words = line.split(' ');
            Some((words.next()?, words.next()?.strip_prefix('v')?))
        })
        .collect();

    let metadata = cargo(workspace, &["metadata", "--locked", "--format-version", "1"])?;
    let metadata: Metadata = serde_json::from_slice(&metadata)
        .map_err(|error| PackageError::Licences { reason: error.to_string() })?;
    let mut packages = metadata.packages;
    packages.retain(|package| linked.contains(&(package.name.as_str(), package.version.as_str())));
    packages.sort_by(|a, b| (&a.name, &a.version).cmp(&(&b.name, &b.version)));
    Ok(packages)
}

/// What cargo prints.
fn cargo(workspace: &Path, arguments: &[&str]) -> Result<Vec<u8>, PackageError> {
    let failed = |reason: String| PackageError::Licences { reason };
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let output = Command::new(cargo).current_dir(workspace).args(arguments).output();
    let output = output.map_err(|error| failed(format!("cargo does not start: {error}")))?;
    if output.status.success() {
        Ok(output.stdout)
    } else {
        Err(failed(String::from_utf8_lossy(&output.stderr).trim().to_owned()))
    }
}

/// The files beside the manifest that are named like a licence, in alphabetical order.
fn licence_files(package: &LibraryPackage) -> Result<Vec<PathBuf>, PackageError> {
    let folder = package.manifest_path.parent().unwrap_or(Path::new("."));
    let unreadable = |source| FileError { action: "list", path: folder.to_owned(), source };
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_ascii_uppercase();
        let is_licence = ["LICENSE", "LICENCE", "COPYING", "COPYRIGHT", "NOTICE", "UNLICENSE"]
            .iter()
            .any(|beginning| name.starts_with(beginning));
        if is_licence && path.is_file() {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linked_libraries_are_listed_and_tools_and_macros_are_not() {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let entries = gather(&workspace).unwrap();
        let list = std::str::from_utf8(&entries[0].bytes).unwrap();
        for linked in ["flexible-aircraft 0", "nalgebra 0", "libm 0"] {
            assert!(list.contains(linked), "{linked} is missing in\n{list}");
        }
        for absent in ["clap", "zip ", "serde_derive", "tempfile", "glam"] {
            assert!(!list.contains(absent), "{absent} is not linked, but in\n{list}");
        }
        assert!(entries.iter().any(|entry| entry.path.ends_with("/LICENSE-MIT")));
    }
}
