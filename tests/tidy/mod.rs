//! The rules of the house that no compiler checks.

mod documents;
mod imports;
mod modules;
mod theory;

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
        let mut test_item = None;
        let lines = self.text.lines().enumerate().map(|(index, line)| (index + 1, line));
        lines.filter(move |(_, line)| {
            if test_item.is_none() && line.trim() == "#[cfg(test)]" {
                test_item = Some(indentation(line));
                return false;
            }
            if let Some(depth) = test_item {
                // rustfmt puts the end of an item below its beginning: `}`, or the `;` of an item of one line.
                let is_end = indentation(line) == depth && (line.ends_with('}') || line.ends_with(';'));
                test_item = test_item.filter(|_| !is_end);
                return false;
            }
            !self.is_tests() && !line.trim_start().starts_with("//")
        })
    }

    /// Whether the file has nothing but unit tests.
    fn is_tests(&self) -> bool {
        self.path.contains("/tests/") || self.path.ends_with("/tests.rs") || self.path.contains("/test_")
    }

    fn is_under(&self, folders: &[&str]) -> bool {
        folders.iter().any(|folder| self.path.starts_with(folder))
    }
}

fn indentation(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

/// Whether a word stands in a line other than as the end of a longer one: `assert!` is not in `debug_assert!`.
fn has_word(line: &str, word: &str) -> bool {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let begins_word = word.starts_with(is_part);
    line.match_indices(word).any(|(at, _)| !(begins_word && line[..at].ends_with(is_part)))
}

/// All Rust sources below the given folders of the workspace.
fn sources(folders: &[&str]) -> Vec<Source> {
    files(folders, &["rs"])
}

/// All files with such extensions below the given folders of the workspace, without what was built there.
fn files(folders: &[&str], extensions: &[&str]) -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut waiting: Vec<PathBuf> = folders.iter().map(|folder| root.join(folder)).collect();
    let mut found = Vec::new();
    while let Some(path) = waiting.pop() {
        if path.is_dir() {
            let inside = fs::read_dir(&path).unwrap().map(|entry| entry.unwrap());
            let written = inside.filter(|entry| {
                let name = entry.file_name();
                name != "target" && !name.to_string_lossy().starts_with('.')
            });
            waiting.extend(written.map(|entry| entry.path()));
        } else if path.extension().and_then(|it| it.to_str()).is_some_and(|it| extensions.contains(&it)) {
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
        let lines = source.code().filter(|(_, line)| words.iter().any(|word| has_word(line, word)));
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
    let sources = sources(&["src", "packaging/src", "cli/src", "python/src"]);
    let speaking = ["src/fmi/pointers.rs", "src/fmi2/", "src/fmi3/", "packaging/src/c_abi"];
    let elsewhere = sources.iter().filter(|s| !s.is_under(&speaking));
    let words = ["unsafe ", "extern \"C\"", "no_mangle", "libc::"];
    assert_none(&places(elsewhere, &words), &format!("only {} speak C", speaking.join(", ")));
}

#[test]
fn the_physics_does_not_know_of_fmi() {
    let sources = sources(&["src"]);
    let rooms = ["src/fmi/", "src/fmi2/", "src/fmi3/", "src/lib.rs"];
    let physics = sources.iter().filter(|s| !s.is_under(&rooms));
    assert_none(&places(physics, &["fmi::", "fmi2", "fmi3"]), "FMI is known in src/fmi, fmi2 and fmi3 alone");
}

#[test]
fn what_an_fmu_does_whatever_the_version_names_no_function_of_one() {
    let sources = sources(&["src/fmi"]);
    let named = ["src/fmi/operation.rs", "src/fmi/description/v2.rs", "src/fmi/description/v3.rs"];
    let neutral = sources.iter().filter(|s| !s.is_under(&named));
    assert_none(&places(neutral, &["fmi2", "fmi3"]), "names of functions are in src/fmi/operation.rs");
}

#[test]
fn only_the_aircraft_and_fmu_resources_are_read_from_files() {
    let sources = sources(&["src"]);
    let others = sources.iter().filter(|s| !s.is_under(&["src/aircraft/", "src/fmi/"]));
    let words = ["std::fs", "fs::", "File::open", "std::env", "std::net", "std::process"];
    assert_none(&places(others, &words), "simulation does not depend on files or the environment");
}

#[test]
fn a_source_file_is_short_enough_to_be_read() {
    const LINES: usize = 400;
    let sources = sources(&["src", "tests", "packaging", "cli", "python", "examples", "benches"]);
    let long = sources.iter().filter(|source| source.text.lines().count() > LINES);
    let long: Vec<String> = long.map(|s| format!("{}: {}", s.path, s.text.lines().count())).collect();
    assert_none(&long, &format!("a module is one idea of at most {LINES} lines"));
}

#[test]
fn nothing_in_the_library_panics_on_purpose() {
    let sources = sources(&["src", "packaging/src", "cli/src", "python/src"]);
    let words =
        ["todo!", "unimplemented!", "panic!", "unreachable!", "assert!", "assert_eq!", "assert_ne!", "dbg!"];
    assert_none(&places(sources.iter(), &words), "errors are values");
}

/// `println!` panics when nobody reads; `File::create` and `fs::write` leave half a file where a good one was.
#[test]
fn the_command_line_prints_and_writes_through_what_cannot_lose_anything() {
    let sources = sources(&["packaging/src", "cli/src", "python/src"]);
    let words = ["println!", "print!", "eprintln!", "eprint!"];
    assert_none(&places(sources.iter(), &words), "cli/src/terminal.rs prints");
    let words = ["File::create", "fs::write", "create_dir_all"];
    assert_none(&places(sources.iter(), &words), "packaging/src/draft.rs writes");
}

/// A comment `PROOF:` in the three lines above has to say why it cannot happen.
#[test]
fn every_unwrap_is_proved_by_a_comment() {
    let mut unproved = Vec::new();
    for source in sources(&["src", "packaging/src", "cli/src", "python/src"]) {
        let lines: Vec<&str> = source.text.lines().collect();
        let unwraps =
            source.code().filter(|(_, line)| line.contains(".unwrap()") || line.contains(".expect("));
        for (number, line) in unwraps {
            if !lines[number.saturating_sub(4)..number].iter().any(|line| line.contains("PROOF:")) {
                unproved.push(format!("{}:{number}: {}", source.path, line.trim()));
            }
        }
    }
    assert_none(&unproved, "unwrap or expect without a comment `PROOF:` in the three lines above");
}

#[test]
fn only_unit_tests_are_left_out_of_the_code() {
    let text = "#[cfg(test)]\npub(super) use {a, b};\nfn code() {}\n#[cfg(test)]\nmod tests {\n    fn test() {\n    }\n}\n\
                // comment\nfn more() {}\n#[cfg(test)]\nmod elsewhere;\nfn last() {}\n";
    let source = Source { path: "src/example.rs".into(), text: text.into() };
    let code: Vec<_> = source.code().collect();
    assert_eq!(code, [(3, "fn code() {}"), (10, "fn more() {}"), (13, "fn last() {}")]);
    assert!(has_word("assert!(x)", "assert!") && !has_word("debug_assert!(x)", "assert!"));
}
