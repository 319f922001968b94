//! What documents say of files, and words that mean one thing.

use std::path::Path;

use super::{Source, assert_none, files};

/// Has words and names that are made up.
const HERE: &str = "tests/tidy/documents.rs";

/// Where the path of a file may begin: names of the library's files go without `src`.
const ROOTS: [&str; 2] = ["", "src/"];

/// What else stands beside a matrix: not the motion of an aircraft.
const ALGEBRA: [&str; 6] = ["matrix", "matrices", "tensor", "tensors", "definite", "semidefinite"];

/// So many words may stand between.
const NEAR: usize = 2;

/// Words in back quotes that are paths of files or folders: with a slash or an ending, nothing to fill in.
fn paths(text: &str) -> impl Iterator<Item = &str> {
    let quoted = text.split('`').skip(1).step_by(2);
    quoted.filter(|word| {
        let is_name = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
        (word.contains('/') || word.ends_with(".rs"))
            && word.chars().all(is_name)
            && !word.starts_with("../")
            && !word.starts_with("target/")
    })
}

fn exists(path: &str) -> bool {
    ROOTS.iter().any(|root| Path::new(env!("CARGO_MANIFEST_DIR")).join(root).join(path).exists())
}

/// Places where `symmetric` is said of a matrix or a tensor.
fn symmetric_algebra(source: &Source) -> Vec<String> {
    let numbered = source.text.lines().enumerate();
    let words: Vec<(usize, String)> = numbered
        .flat_map(|(index, line)| {
            let words =
                line.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
            words.map(move |word| (index + 1, word.to_lowercase()))
        })
        .collect();
    let is_algebra = |(_, word): &&(usize, String)| ALGEBRA.contains(&word.as_str());
    let said = words.iter().enumerate().filter(|(_, (_, word))| word == "symmetric");
    said.filter(|(place, _)| {
        let around = &words[place.saturating_sub(NEAR + 1)..(place + NEAR + 2).min(words.len())];
        around.iter().any(|word| is_algebra(&word))
    })
    .map(|(_, (line, _))| format!("{}:{line}", source.path))
    .collect()
}

#[test]
fn files_that_the_documents_name_are_there() {
    let documents = files(&["ARCHITECTURE.md", "CONTRIBUTING.md"], &["md"]);
    let mut missing = Vec::new();
    for document in &documents {
        let lines = document.text.lines().filter(|line| !line.starts_with("```"));
        let text: String = lines.flat_map(|line| [line, "\n"]).collect();
        assert!(paths(&text).count() > 10, "{}", document.path);
        let gone = paths(&text).filter(|path| !exists(path));
        missing.extend(gone.map(|path| format!("{}: {path}", document.path)));
    }
    assert_none(&missing, "paths from the root of the repository or from src");
}

#[test]
fn motion_is_symmetric_and_a_matrix_is_self_adjoint() {
    let written = files(&[""], &["rs", "md", "toml", "py"]).into_iter().filter(|source| source.path != HERE);
    let said: Vec<String> = written.flat_map(|source| symmetric_algebra(&source)).collect();
    assert_none(
        &said,
        "a matrix is self-adjoint; the entries of a tensor do not depend on the order of indices",
    );
}

#[test]
fn a_symmetric_matrix_is_found_and_symmetric_motion_is_not() {
    let found = |text: &str| symmetric_algebra(&Source { path: "a.md".into(), text: text.into() }).len();
    for text in
        ["a symmetric matrix", "matrix\nis symmetric", "Symmetric, positive definite", "symmetric tensors"]
    {
        assert_eq!(found(text), 1, "{text}");
    }
    for text in
        ["symmetric modes have a matrix", "antisymmetric matrix", "symmetric_matrix", "symmetric motion"]
    {
        assert_eq!(found(text), 0, "{text}");
    }
}

#[test]
fn a_path_is_known_by_its_shape() {
    let text = "`flight/point.rs`, `a.rs`, `a::b`, `records/*.md`, `target/x.svg`, `cargo test`, `x + y/z`, `../a/b`";
    assert_eq!(paths(text).collect::<Vec<_>>(), ["flight/point.rs", "a.rs"]);
    assert!(exists("src/lib.rs") && exists("flight/mod.rs") && !exists("flight/airframe.rs"));
}
