//! The rules of the house that no compiler checks.

use std::fs;
use std::path::{Path, PathBuf};

/// A Rust source file: its path from the root of the workspace, with forward slashes, and its text.
struct Source {
    path: String,
    text: String,
}

impl Source {
    /// Lines that are neither comments nor unit tests, with their numbers.
    fn code(&self) -> impl Iterator<Item = (usize, &str)> {
        let lines = self.text.lines().enumerate().map(|(index, line)| (index + 1, line));
        lines
            .take_while(|(_, line)| *line != "#[cfg(test)]" && !self.is_tests())
            .filter(|(_, line)| !line.trim_start().starts_with("//"))
    }

    /// Whether the file has nothing but unit tests.
    fn is_tests(&self) -> bool {
        self.path.contains("/tests/") || self.path.ends_with("/tests.rs") || self.path.contains("/test_")
    }

    fn is_under(&self, folders: &[&str]) -> bool {
        folders.iter().any(|folder| self.path.starts_with(folder))
    }
}

/// All sources below the given folders of the workspace.
fn sources(folders: &[&str]) -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut waiting: Vec<PathBuf> = folders.iter().map(|folder| root.join(folder)).collect();
    let mut found = Vec::new();
    while let Some(path) = waiting.pop() {
        if path.is_dir() {
            waiting.extend(fs::read_dir(&path).unwrap().map(|entry| entry.unwrap().path()));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let from_root = path.strip_prefix(root).unwrap().to_string_lossy().replace('\\', "/");
            found.push(Source { path: from_root, text: fs::read_to_string(&path).unwrap() });
        }
    }
    assert!(!found.is_empty(), "no sources in {folders:?}");
    found
}

/// Places of the code, as `path:line`, where one of the words stands.
fn places<'s>(sources: impl Iterator<Item = &'s Source>, words: &[&str]) -> Vec<String> {
    let mut places = Vec::new();
    for source in sources {
        let lines = source.code().filter(|(_, line)| words.iter().any(|word| line.contains(word)));
        places.extend(lines.map(|(number, line)| format!("{}:{number}: {}", source.path, line.trim())));
    }
    places
}

#[track_caller]
fn assert_none(places: &[String], rule: &str) {
    assert!(places.is_empty(), "{rule}:\n{}", places.join("\n"));
}

#[test]
fn unsafe_code_stays_at_the_two_sides_of_the_c_interface() {
    let sources = sources(&["src", "packaging/src", "cli/src"]);
    let elsewhere = sources.iter().filter(|s| !s.is_under(&["src/fmi2/", "packaging/src/c_abi.rs"]));
    let words = ["unsafe ", "extern \"C\"", "no_mangle"];
    assert_none(&places(elsewhere, &words), "only src/fmi2 and packaging/src/c_abi.rs speak C");
}

#[test]
fn the_physics_does_not_know_of_fmi() {
    let sources = sources(&["src"]);
    let physics = sources.iter().filter(|s| !s.is_under(&["src/fmi2/", "src/lib.rs"]));
    assert_none(&places(physics, &["fmi2", "libc::"]), "FMI is known in src/fmi2 alone");
}

#[test]
fn only_the_aircraft_and_fmu_resources_are_read_from_files() {
    let sources = sources(&["src"]);
    let others = sources.iter().filter(|s| !s.is_under(&["src/aircraft/", "src/fmi2/"]));
    let words = ["std::fs", "fs::", "File::open", "std::env", "std::net", "std::process"];
    assert_none(&places(others, &words), "simulation does not depend on files or the environment");
}

#[test]
fn a_source_file_is_short_enough_to_be_read() {
    const LINES: usize = 420;
    let sources = sources(&["src", "packaging/src", "cli/src"]);
    let long = sources.iter().filter(|source| source.text.lines().count() > LINES);
    let long: Vec<String> = long.map(|s| format!("{}: {}", s.path, s.text.lines().count())).collect();
    assert_none(&long, &format!("a module is one idea of at most {LINES} lines"));
}

#[test]
fn nothing_in_the_library_panics_on_purpose() {
    let sources = sources(&["src", "packaging/src", "cli/src"]);
    let words = ["todo!", "unimplemented!", "panic!", "dbg!"];
    assert_none(&places(sources.iter(), &words), "errors are values");
}

/// A comment on the line itself or in the three lines above has to say why it cannot happen.
#[test]
fn every_unwrap_is_proved_by_a_comment() {
    let mut unproved = Vec::new();
    for source in sources(&["src", "packaging/src", "cli/src"]) {
        let lines: Vec<&str> = source.text.lines().collect();
        let unwraps =
            source.code().filter(|(_, line)| line.contains(".unwrap()") || line.contains(".expect("));
        for (number, line) in unwraps {
            if !lines[number.saturating_sub(4)..number].iter().any(|line| line.contains("//")) {
                unproved.push(format!("{}:{number}: {}", source.path, line.trim()));
            }
        }
    }
    assert_none(&unproved, "unwrap or expect without a comment that proves it");
}
