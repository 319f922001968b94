//! The licences of everything that is linked into the shared library, as `documentation/licenses/`, and of what is linked
//! into the command where that is installed.
//!
//! cargo knows what is linked: the packages that are needed at run time, without procedural macros, build
//! scripts and what only tests and tools use. Those of all platforms are listed, whichever are packaged, so that
//! FMUs packaged on different machines have the same list. Where there is no cargo, the list was made before.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use flexible_aircraft::fmi::Version;
use serde::Deserialize;

use crate::archive::Entry;
use crate::{FileError, PackageError, Platform, read};

/// Where an FMU keeps its licences, and a data folder those of the library.
const FOLDER: &str = "documentation/licenses";

/// The list of them, but in FMUs of FMI 3.0, where the standard has importers look for another name.
const LIST: &str = "README.txt";

/// What it is called there.
const ENTRY_POINT: &str = "license.txt";

/// Where the licences of an FMU come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Licences {
    /// cargo finds out what is linked, in this folder of flexible-aircraft's own workspace.
    Workspace(PathBuf),
    /// They were gathered when this data folder was written.
    Gathered(PathBuf),
}

impl Licences {
    /// The licence files of `flexible-aircraft` and of all it is linked with, and a list of them, as an FMU has them.
    pub(crate) fn entries(&self, version: Version) -> Result<Vec<Entry>, PackageError> {
        let mut entries = match self {
            Licences::Workspace(workspace) => of_library(workspace)?,
            Licences::Gathered(data) => gathered(data, FOLDER)?,
        };
        let list = format!("{FOLDER}/{LIST}");
        if let Some(list) = entries.iter_mut().find(|entry| entry.path == list && version == Version::V3) {
            list.path = format!("{FOLDER}/{ENTRY_POINT}");
            list.bytes.splice(..0, OF_THE_FMU.bytes());
        }
        Ok(entries)
    }
}

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

/// Those of the library.
pub(crate) fn of_library(workspace: &Path) -> Result<Vec<Entry>, PackageError> {
    gather(workspace, "flexible-aircraft", FOLDER, &format!("{LIBRARY_HEAD}{LINKED_BY_ZIG}"))
}

/// Those of a program of the workspace, a package of cargo, in a folder.
pub(crate) fn of_program(workspace: &Path, package: &str, folder: &str) -> Result<Vec<Entry>, PackageError> {
    gather(workspace, package, folder, PROGRAM_HEAD)
}

/// The licence files of a package and of all it is linked with, and a list of them.
fn gather(workspace: &Path, package: &str, folder: &str, head: &str) -> Result<Vec<Entry>, PackageError> {
    let mut list = head.to_owned();
    let mut entries = Vec::new();
    for package in linked_packages(workspace, package)? {
        let licence = package.license.as_deref().unwrap_or("see its licence file");
        list.push_str(&format!("{} {}: {licence}\n", package.name, package.version));
        for file in licence_files(&package)? {
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            let path = format!("{folder}/{}-{}/{name}", package.name, package.version);
            entries.push(Entry::new(path, read(&file)?));
        }
    }
    entries.insert(0, Entry::new(format!("{folder}/{LIST}"), list));
    Ok(entries)
}

/// All files of a folder of a data folder, under their paths in there.
fn gathered(data: &Path, folder: &str) -> Result<Vec<Entry>, FileError> {
    let mut entries = Vec::new();
    for (name, path) in listed(&data.join(folder))? {
        let inside = format!("{folder}/{name}");
        if path.is_dir() {
            entries.extend(gathered(data, &inside)?);
        } else {
            entries.push(Entry::new(inside, read(&path)?));
        }
    }
    Ok(entries)
}

/// What is in a folder, by its names.
pub(crate) fn listed(folder: &Path) -> Result<Vec<(String, PathBuf)>, FileError> {
    let failed = |source| FileError { action: "list", path: folder.to_owned(), source };
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        found.push((entry.file_name().to_string_lossy().into_owned(), entry.path()));
    }
    found.sort();
    Ok(found)
}

/// Before the list where it is the entry point.
const OF_THE_FMU: &str = "\
The library of this FMU, flexible-aircraft, may be used under the MIT licence or the Apache License 2.0, as you choose:
the texts are in its folder. Whose the aircraft is may be said in resources/aircraft.toml.

";

const LIBRARY_HEAD: &str = "\
Linked into the shared library, with the licences that their authors chose. The texts are in the folders
beside this file. The library also contains parts of the Rust standard library (The Rust Project
contributors, MIT OR Apache-2.0: the texts are those of flexible-aircraft). ";

const PROGRAM_HEAD: &str = "\
Linked into the command, with the licences that their authors chose. The texts are in the folders
beside this file. The command also contains parts of the Rust standard library (The Rust Project
contributors, MIT OR Apache-2.0: the texts are those of flexible-aircraft).

";

const LINKED_BY_ZIG: &str = "\
What packaging/build-platforms.sh
links also contains parts of LLVM's libunwind (Apache-2.0 WITH LLVM-exception) and of zig's compiler_rt (MIT), for
Windows instead of mingw-w64's run-time library (public domain) and of GCC's (GPL-3.0-or-later WITH GCC-exception-3.1).

";

/// What a package needs at run time on any platform, by name and version.
///
/// `cargo tree` knows which features are on; `cargo metadata` knows where the sources are.
fn linked_packages(workspace: &Path, package: &str) -> Result<Vec<LibraryPackage>, PackageError> {
    let mut tree = vec!["tree", "--locked", "--package", package];
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
    let files = listed(folder)?.into_iter().filter(|(name, path)| {
        let name = name.to_ascii_uppercase();
        let is_licence = ["LICENSE", "LICENCE", "COPYING", "COPYRIGHT", "NOTICE", "UNLICENSE"]
            .iter()
            .any(|beginning| name.starts_with(beginning));
        is_licence && path.is_file()
    });
    Ok(files.map(|(_, path)| path).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linked_libraries_are_listed_and_tools_and_macros_are_not() {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let entries = of_library(&workspace).unwrap();
        let list = std::str::from_utf8(&entries[0].bytes).unwrap();
        for linked in ["flexible-aircraft 0", "nalgebra 0", "libm 0"] {
            assert!(list.contains(linked), "{linked} is missing in\n{list}");
        }
        for absent in ["clap", "zip ", "serde_derive", "tempfile", "glam"] {
            assert!(!list.contains(absent), "{absent} is not linked, but in\n{list}");
        }
        assert!(entries.iter().any(|entry| entry.path.ends_with("/LICENSE-MIT")));
    }

    #[test]
    fn the_list_is_the_entry_point_of_fmi_3_and_all_else_is_as_in_fmi_2() {
        let licences = Licences::Workspace(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."));
        let [two, three] = [Version::V2, Version::V3].map(|version| licences.entries(version).unwrap());
        assert_eq!(two[1..], three[1..]);
        assert_eq!(two[0].path, "documentation/licenses/README.txt");
        assert_eq!(three[0].path, "documentation/licenses/license.txt");
        assert!(
            three[0].bytes.starts_with(b"The library of this FMU") && three[0].bytes.ends_with(&two[0].bytes)
        );
    }
}
