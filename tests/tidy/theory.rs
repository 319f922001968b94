//! The theory in `docs/theory`: its labels, the citations of them, and the links between its pages.
//!
//! A label stands as `<a id="page.name"></a>**[page.name]**` before what it names. A citation is one line's
//! `theory: page.name, page.name; thesis eq. 2.3` in square brackets; what begins with the semicolon may be left out.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::{Source, assert_none, files, has_word};

/// Where the pages are.
const PAGES: &str = "docs/theory/";

/// Has citations, links and names that are made up.
const HERE: &str = "tests/tidy/theory.rs";

/// Documents that a reader of the repository does not have.
const ELSEWHERE: [&str; 6] =
    ["physics.md", "architecture.md", "analyses.md", "large-deflections.md", "fmi3-me.md", "fmu.md"];

/// Pages and the labels on them.
struct Theory {
    pages: Vec<Source>,
    /// The page of each label.
    labels: BTreeMap<String, String>,
    /// What is wrong with the labels.
    mistakes: Vec<String>,
}

impl Theory {
    /// That of the repository.
    fn of_repository() -> Self {
        Theory::of(files(&[PAGES], &["md"]))
    }

    fn of(pages: Vec<Source>) -> Self {
        let mut theory = Theory { pages: Vec::new(), labels: BTreeMap::new(), mistakes: Vec::new() };
        for page in &pages {
            for (number, line) in lines(page) {
                for label in starts(line, "<a id=\"").filter_map(|rest| rest.split('"').next()) {
                    theory.add(page, number, line, label);
                }
            }
        }
        Theory { pages, ..theory }
    }

    fn add(&mut self, page: &Source, number: usize, line: &str, label: &str) {
        let place = format!("{}:{number}: {label}", page.path);
        if !is_label(label) || Some(chapter(label)) != stem(&page.path) {
            self.mistakes
                .push(format!("{place}: is not <page>.<name> in lower-case letters, digits and dashes"));
        }
        if !line.contains(&format!("<a id=\"{label}\"></a>**[{label}]**")) {
            self.mistakes.push(format!("{place}: cannot be seen beside its anchor as **[{label}]**"));
        }
        if let Some(other) = self.labels.insert(label.to_owned(), page.path.clone()) {
            self.mistakes.push(format!("{place}: is in {other} too"));
        }
    }

    /// What is wrong with the citations of a file.
    fn wrong_citations(&self, source: &Source) -> Vec<String> {
        let mut wrong = Vec::new();
        for (number, line) in lines(source) {
            for rest in starts(line, "[theory:") {
                let place = format!("{}:{number}", source.path);
                let Some((citation, _)) = rest.split_once(']') else {
                    wrong.push(format!("{place}: the citation does not end on its line"));
                    continue;
                };
                let (labels, thesis) = citation.split_once(';').unwrap_or((citation, " thesis "));
                if !thesis.starts_with(" thesis ") {
                    wrong.push(format!("{place}: only the thesis may follow the semicolon, not{thesis}"));
                }
                let unknown =
                    labels.split(',').map(str::trim).filter(|label| !self.labels.contains_key(*label));
                wrong.extend(unknown.map(|label| format!("{place}: there is no label \"{label}\"")));
            }
        }
        wrong
    }

    /// What is wrong with the links of a document that lead to the pages, and with all links of a page.
    fn wrong_links(&self, document: &Source) -> Vec<String> {
        let mut wrong = Vec::new();
        for (number, line) in lines(document).filter(outside_of_code()) {
            for target in starts(line, "](").filter_map(|rest| rest.split(')').next()) {
                if target.contains("://") || target.contains(' ') {
                    continue;
                }
                let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
                let file = resolve(&document.path, file);
                let leads_somewhere = if file.starts_with(PAGES) {
                    self.has_page(&file) && (anchor.is_empty() || self.labels.get(anchor) == Some(&file))
                } else {
                    !document.path.starts_with(PAGES) || exists(&file)
                };
                if !leads_somewhere {
                    wrong.push(format!("{}:{number}: {target} leads nowhere", document.path));
                }
            }
        }
        wrong
    }

    fn has_page(&self, path: &str) -> bool {
        self.pages.iter().any(|page| page.path == path)
    }
}

/// Lines with their numbers.
fn lines(source: &Source) -> impl Iterator<Item = (usize, &str)> {
    source.text.lines().enumerate().map(|(index, line)| (index + 1, line))
}

/// What follows each place of a line where some text begins.
fn starts<'l>(line: &'l str, text: &'static str) -> impl Iterator<Item = &'l str> {
    line.match_indices(text).map(|(at, _)| &line[at + text.len()..])
}

/// Leaves out lines within fences, and the fences.
fn outside_of_code() -> impl FnMut(&(usize, &str)) -> bool {
    let mut in_fence = false;
    move |(_, line)| {
        let is_fence = line.trim_start().starts_with("```");
        in_fence ^= is_fence;
        !in_fence && !is_fence
    }
}

/// `page.name`: lower-case letters, digits and dashes on both sides of one dot.
fn is_label(label: &str) -> bool {
    let is_name = |name: &str| {
        !name.is_empty() && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-')
    };
    label.split_once('.').is_some_and(|(page, name)| is_name(page) && is_name(name))
}

/// The page that a label says.
fn chapter(label: &str) -> &str {
    label.split('.').next().unwrap_or(label)
}

/// The name of a file without folder and extension.
fn stem(path: &str) -> Option<&str> {
    Path::new(path).file_stem()?.to_str()
}

/// The path from the root of a file that a document names.
fn resolve(document: &str, file: &str) -> String {
    if file.is_empty() {
        return document.to_owned();
    }
    let mut path: Vec<&str> = document.split('/').collect();
    path.pop();
    for part in file.split('/') {
        match part {
            "." => {}
            ".." => drop(path.pop()),
            part => path.push(part),
        }
    }
    path.join("/")
}

fn exists(path: &str) -> bool {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path).exists()
}

/// Everything that people wrote, but for this file.
fn everything() -> impl Iterator<Item = Source> {
    let kinds = ["rs", "md", "toml", "py", "sh", "h", "c", "txt", "html", "json", "yml"];
    files(&[""], &kinds).into_iter().filter(|source| source.path != HERE)
}

#[test]
fn every_label_of_the_theory_is_there_once_on_its_page_and_can_be_seen() {
    let theory = Theory::of_repository();
    assert_none(&theory.mistakes, "labels");
    assert!(theory.labels.len() > 100, "{}", theory.labels.len());
}

#[test]
fn what_is_cited_is_in_the_theory() {
    let theory = Theory::of_repository();
    // The index shows how to cite; what it shows must be there too.
    let wrong: Vec<String> = everything().flat_map(|source| theory.wrong_citations(&source)).collect();
    assert_none(&wrong, "citations");
}

#[test]
fn every_label_is_cited_or_linked_somewhere() {
    let theory = Theory::of_repository();
    let used: BTreeSet<String> = everything().flat_map(|source| used_labels(&source)).collect();
    let unused = theory.labels.iter().filter(|(label, _)| !used.contains(*label));
    let unused: Vec<String> = unused.map(|(label, page)| format!("{page}: {label}")).collect();
    assert_none(&unused, "labels that nothing needs");
}

/// What a file cites, and to what of the pages it links.
fn used_labels(source: &Source) -> Vec<String> {
    let mut used = Vec::new();
    for (_, line) in lines(source) {
        let citations = starts(line, "[theory:").filter_map(|rest| rest.split([']', ';']).next());
        let cited = citations.flat_map(|labels| labels.split(',')).map(str::trim);
        let links = starts(line, "](").filter_map(|rest| rest.split(')').next()?.split_once('#'));
        used.extend(cited.chain(links.map(|(_, anchor)| anchor)).map(str::to_owned));
    }
    used
}

#[test]
fn links_to_and_between_the_pages_of_the_theory_lead_somewhere() {
    let theory = Theory::of_repository();
    let documents = everything().filter(|source| source.path.ends_with(".md"));
    let wrong: Vec<String> = documents.flat_map(|document| theory.wrong_links(&document)).collect();
    assert_none(&wrong, "links");
    let index = theory.pages.iter().find(|page| page.path.ends_with("/README.md")).unwrap();
    let missing = theory.pages.iter().filter_map(|page| page.path.strip_prefix(PAGES));
    let missing = missing.filter(|name| *name != "README.md" && !index.text.contains(&format!("]({name})")));
    assert_none(&missing.map(str::to_owned).collect::<Vec<_>>(), "pages that the index does not name");
}

#[test]
fn nothing_names_documents_that_are_not_in_the_repository() {
    let mut places = Vec::new();
    for source in everything() {
        let named = lines(&source).filter(|(_, line)| ELSEWHERE.iter().any(|name| has_word(line, name)));
        places.extend(named.map(|(number, line)| format!("{}:{number}: {}", source.path, line.trim())));
    }
    assert_none(&places, "cite a label of docs/theory instead");
}

/// A theory of two pages: (path, text).
fn made_up(pages: [(&str, &str); 2]) -> Theory {
    Theory::of(pages.map(|(path, text)| source(path, text)).into())
}

fn source(path: &str, text: &str) -> Source {
    Source { path: path.into(), text: text.into() }
}

const KITES: &str = "# Kites\n<a id=\"kites.lift\"></a>**[kites.lift]** See [tails](tails.md#tails.length).\n\
                     <a id=\"kites.drag\"></a>**[kites.drag]** Much; [kites.lift](#kites.lift) is less.\n";
const TAILS: &str = "<a id=\"tails.length\"></a>**[tails.length]** ℓ\n```text\n[no link](nowhere.md)\n```\n";

#[test]
fn a_label_twice_elsewhere_or_unseen_is_a_mistake() {
    let good = made_up([("docs/theory/kites.md", KITES), ("docs/theory/tails.md", TAILS)]);
    assert_eq!(good.labels.keys().collect::<Vec<_>>(), ["kites.drag", "kites.lift", "tails.length"]);
    assert_eq!(good.mistakes, Vec::<String>::new());
    for (text, mistakes) in [
        ("<a id=\"tails.a\"></a>**[tails.a]** <a id=\"tails.a\"></a>**[tails.a]**", 1),
        ("<a id=\"kites.lift\"></a>**[kites.lift]**", 2),
        ("<a id=\"tails.b\"></a> **[tails.c]**", 1),
        ("<a id=\"tails.Big\"></a>**[tails.Big]**", 1),
        ("<a id=\"tails\"></a>**[tails]**", 1),
        ("<a id=\"tails.a.b\"></a>**[tails.a.b]**", 1),
    ] {
        let theory = made_up([("docs/theory/kites.md", KITES), ("docs/theory/tails.md", text)]);
        assert_eq!(theory.mistakes.len(), mistakes, "{text}: {:?}", theory.mistakes);
    }
}

#[test]
fn a_citation_of_what_is_not_there_is_found_with_its_line() {
    let theory = made_up([("docs/theory/kites.md", KITES), ("docs/theory/tails.md", TAILS)]);
    let good =
        "//! [theory: kites.lift]\n/// Both [theory: kites.drag, tails.length; thesis eq. 2.3] and [1].\n";
    assert_eq!(theory.wrong_citations(&source("a.rs", good)), Vec::<String>::new());
    for (text, wrong) in [
        ("\n[theory: kites.string]", "a.rs:2: there is no label \"kites.string\""),
        ("[theory: kites.lift, ]", "a.rs:1: there is no label \"\""),
        ("[theory: kites.lift] [theory: lift; thesis 4.1]", "a.rs:1: there is no label \"lift\""),
        ("[theory: kites.lift,\n kites.drag]", "a.rs:1: the citation does not end on its line"),
        ("[theory: kites.lift; page 7]", "a.rs:1: only the thesis may follow the semicolon, not page 7"),
    ] {
        assert_eq!(theory.wrong_citations(&source("a.rs", text)), [wrong], "{text}");
    }
}

#[test]
fn a_label_is_used_by_citations_and_links_and_not_by_its_own_anchor() {
    let text = "[theory: kites.lift, tails.length; thesis 4.1] [x](docs/theory/kites.md#kites.drag)\n";
    assert_eq!(used_labels(&source("a.rs", text)), ["kites.lift", "tails.length", "kites.drag"]);
    assert_eq!(used_labels(&source("docs/theory/tails.md", TAILS)), [""; 0]);
}

#[test]
fn a_link_to_what_is_not_there_is_found_with_its_line() {
    let theory = made_up([("docs/theory/kites.md", KITES), ("docs/theory/tails.md", TAILS)]);
    for page in &theory.pages {
        assert_eq!(theory.wrong_links(page), Vec::<String>::new());
    }
    for (path, text, wrong) in [
        ("docs/theory/kites.md", "[x](tails.md#tails.colour)", 1),
        ("docs/theory/kites.md", "[x](tails.md#kites.lift)", 1),
        ("docs/theory/kites.md", "[x](#kites.lift) [y](#kites.string)", 1),
        ("docs/theory/kites.md", "[x](strings.md), [y](../../nowhere.md), [z](../../README.md)", 2),
        ("docs/theory/kites.md", "[x](https://example.org/strings.md)", 0),
        ("README.md", "[x](docs/theory/kites.md#kites.lift) [y](nowhere.md)", 0),
        ("aircraft/README.md", "\n[x](../docs/theory/kites.md#kites.string)", 1),
    ] {
        let found = theory.wrong_links(&source(path, text));
        assert_eq!(found.len(), wrong, "{text}: {found:?}");
    }
}
