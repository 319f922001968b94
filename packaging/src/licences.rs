//! The licences of everything that is linked into the shared library, as `documentation/licenses/`.
//!
//! cargo knows what is linked: the packages that the library needs at run time on the packaged platforms,
//! without procedural macros, build scripts and what only tests and tools use.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde::Deserialize;

use crate::archive::Entry;
use crate::{PackageError, Platform, read};

/// What `cargo metadata` prints, as far as it matters here.
#[derive(Deserialize)]
struct Metadata {
    packages: Vec<LinkedPackage>,
    resolve: Resolve,
}

#[derive(Deserialize)]
struct LinkedPackage {
    id: String,
    name: String,
    version: String,
    license: Option<String>,
    manifest_path: PathBuf,
    targets: Vec<Target>,
}

#[derive(Deserialize)]
struct Target {
    kind: Vec<String>,
}

#[derive(Deserialize)]
struct Resolve {
    nodes: Vec<Node>,
}

#[derive(Deserialize)]
struct Node {
    id: String,
    deps: Vec<Dependency>,
}

#[derive(Deserialize)]
struct Dependency {
    pkg: String,
    dep_kinds: Vec<DependencyKind>,
}

/// A normal dependency has the kind `None`; others are "dev" and "build".
#[derive(Deserialize)]
struct DependencyKind {
    kind: Option<String>,
}

/// The licence files of `flexible-aircraft` and of all it is linked with, and a list of them.
pub(crate) fn gather(workspace: &Path, platforms: &BTreeSet<Platform>) -> Result<Vec<Entry>, PackageError> {
    let metadata = cargo_metadata(workspace, platforms)?;
    let mut list = String::from(LIST_HEAD);
    let mut entries = Vec::new();
    for package in linked_packages(&metadata)? {
        let licence = package.license.as_deref().unwrap_or("see its licence file");
        list.push_str(&format!("{} {}: {licence}\n", package.name, package.version));
        for file in licence_files(package)? {
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
contributors, MIT OR Apache-2.0: the texts are those of flexible-aircraft).

";

fn cargo_metadata(workspace: &Path, platforms: &BTreeSet<Platform>) -> Result<Metadata, PackageError> {
    let failed = |reason: String| PackageError::Licences { reason };
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut command = Command::new(cargo);
    command.current_dir(workspace).args(["metadata", "--locked", "--format-version", "1"]);
    for platform in platforms {
        command.args(["--filter-platform", platform.target_triple()]);
    }
    let output = command.output().map_err(|error| failed(format!("could not be started: {error}")))?;
    if !output.status.success() {
        return Err(failed(format!("failed: {}", String::from_utf8_lossy(&output.stderr).trim())));
    }
    serde_json::from_slice(&output.stdout).map_err(|error| failed(format!("cannot be understood: {error}")))
}

/// Everything reachable from the library by normal dependencies, by name and version.
fn linked_packages(metadata: &Metadata) -> Result<Vec<&LinkedPackage>, PackageError> {
    let packages: BTreeMap<_, _> = metadata.packages.iter().map(|package| (&package.id, package)).collect();
    let nodes: BTreeMap<_, _> = metadata.resolve.nodes.iter().map(|node| (&node.id, node)).collect();
    let library = metadata.packages.iter().find(|package| package.name == "flexible-aircraft");
    let mut waiting: Vec<_> = library.into_iter().collect();
    let mut linked = BTreeMap::new();
    while let Some(package) = waiting.pop() {
        if linked.insert((&package.name, &package.version), package).is_some() {
            continue;
        }
        let dependencies = nodes.get(&package.id).map_or(&[][..], |node| &node.deps);
        let normal = dependencies.iter().filter(|dep| dep.dep_kinds.iter().any(|kind| kind.kind.is_none()));
        waiting.extend(normal.filter_map(|dep| packages.get(&dep.pkg)).filter(|package| !is_macro(package)));
    }
    if linked.is_empty() {
        return Err(PackageError::Licences { reason: "does not know the package flexible-aircraft".into() });
    }
    Ok(linked.into_values().collect())
}

fn is_macro(package: &LinkedPackage) -> bool {
    package.targets.iter().any(|target| target.kind.iter().any(|kind| kind == "proc-macro"))
}

/// The files beside the manifest that are named like a licence, in alphabetical order.
fn licence_files(package: &LinkedPackage) -> Result<Vec<PathBuf>, PackageError> {
    let folder = package.manifest_path.parent().unwrap_or(Path::new("."));
    let unreadable = |source| PackageError::File { action: "list", path: folder.to_owned(), source };
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
        let entries = gather(&workspace, &BTreeSet::from([Platform::Linux64])).unwrap();
        let list = std::str::from_utf8(&entries[0].bytes).unwrap();
        for linked in ["flexible-aircraft 0", "nalgebra 0", "libm 0"] {
            assert!(list.contains(linked), "{linked} is missing in\n{list}");
        }
        for absent in ["clap", "zip ", "serde_derive", "tempfile"] {
            assert!(!list.contains(absent), "{absent} is not linked, but in\n{list}");
        }
        assert!(entries.iter().any(|entry| entry.path.ends_with("/LICENSE-MIT")));
    }
}
