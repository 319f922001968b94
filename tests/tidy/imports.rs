//! Which way data flows: the modules of the library from left to right, the files of a module without circles.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use super::{Source, sources};

/// Where an item is: the names from the root of the crate to it.
type ItemPath = Vec<String>;

/// A file as a module that uses others.
#[derive(Debug, Default)]
struct Module {
    /// All paths in its code but those that it only hands on.
    used: Vec<ItemPath>,
    /// `pub use`: the name here, the path there.
    handed_on: BTreeMap<String, ItemPath>,
}

/// The modules of a crate by their paths.
struct Crate(BTreeMap<ItemPath, Module>);

impl Crate {
    /// Of the files below a folder.
    fn new<'s>(folder: &str, sources: impl Iterator<Item = &'s Source>) -> Self {
        let modules = sources.filter(|source| !source.is_tests()).map(|source| {
            let name = source.path.strip_prefix(folder).unwrap().strip_suffix(".rs").unwrap();
            let mut path: ItemPath =
                name.split('/').filter(|part| !part.is_empty()).map(str::to_owned).collect();
            path.pop_if(|last| ["mod", "lib", "main"].contains(&last.as_str()));
            let code: String = source.code().flat_map(|(_, line)| [line, "\n"]).collect();
            (path, Module::of(&tokens(&code)))
        });
        Crate(modules.collect())
    }

    /// The module in which an item that another one names is written.
    fn home(&self, from: &[String], path: &[String], hops: usize) -> Option<ItemPath> {
        let mut here = from.to_vec();
        let mut rest = path;
        match rest.first()?.as_str() {
            "crate" => {
                here.clear();
                rest = &rest[1..];
            }
            "self" => rest = &rest[1..],
            "super" => {
                while rest.first().is_some_and(|part| part == "super") {
                    here.pop();
                    rest = &rest[1..];
                }
            }
            // The name of a child, or of something from elsewhere.
            name => drop(self.child(&here, name)?),
        }
        while let Some(name) = rest.first() {
            match self.child(&here, name) {
                Some(child) => here = child,
                None => {
                    let handed_on = self.0.get(&here).and_then(|module| module.handed_on.get(name));
                    return match handed_on {
                        Some(there) if hops > 0 => self.home(&here, there, hops - 1),
                        _ => Some(here),
                    };
                }
            }
            rest = &rest[1..];
        }
        Some(here)
    }

    fn child(&self, parent: &[String], name: &str) -> Option<ItemPath> {
        let path = [parent, &[name.to_owned()]].concat();
        self.0.contains_key(&path).then_some(path)
    }

    /// Which modules each one uses, itself and the root of the crate left out.
    fn uses(&self) -> BTreeMap<ItemPath, BTreeSet<ItemPath>> {
        let uses = self.0.iter().map(|(path, module)| {
            let homes = module.used.iter().filter_map(|used| self.home(path, used, 8));
            (path.clone(), homes.filter(|home| home != path && !home.is_empty()).collect())
        });
        uses.collect()
    }
}

impl Module {
    fn of(tokens: &[&str]) -> Self {
        let mut module = Module::default();
        let mut at = 0;
        while at < tokens.len() {
            let token = tokens[at];
            let before = at.checked_sub(1).map(|before| tokens[before]);
            if token == "use" {
                let mut paths = Vec::new();
                at = use_tree(tokens, at + 1, &[], &mut paths);
                if matches!(before, Some("pub" | ")")) {
                    let named = paths.into_iter().filter_map(|path| Some((path.last()?.clone(), path)));
                    module.handed_on.extend(named);
                } else {
                    module.used.extend(paths);
                }
            } else if is_name(token) && before != Some("::") {
                let mut path = vec![token.to_owned()];
                while tokens.get(at + 1) == Some(&"::")
                    && tokens.get(at + 2).is_some_and(|next| is_name(next))
                {
                    path.push(tokens[at + 2].to_owned());
                    at += 2;
                }
                if path.len() > 1 {
                    module.used.push(path);
                }
            }
            at += 1;
        }
        module
    }
}

/// Reads `a::{b, c::d as e}` from a place on, and says where it ends.
fn use_tree(tokens: &[&str], mut at: usize, prefix: &[String], paths: &mut Vec<ItemPath>) -> usize {
    let mut path = prefix.to_vec();
    while let Some(&token) = tokens.get(at) {
        match token {
            "{" => {
                while tokens.get(at).is_some_and(|token| *token != "}") {
                    at = use_tree(tokens, at + 1, &path, paths);
                }
                return at + 1;
            }
            "," | "}" | ";" => break,
            "as" => at += 1,
            "::" | "*" => {}
            name => path.push(name.to_owned()),
        }
        at += 1;
    }
    if path.len() > prefix.len() {
        paths.push(path);
    }
    at
}

fn is_name(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// Names, `::` and single marks; without comments, strings and characters.
fn tokens(code: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = code;
    while let Some(first) = rest.chars().next() {
        let is_part = |c: char| c.is_alphanumeric() || c == '_';
        let length = if is_part(first) {
            rest.find(|c| !is_part(c)).unwrap_or(rest.len())
        } else if rest.starts_with("::") {
            2
        } else if rest.starts_with("//") {
            rest = &rest[rest.find('\n').unwrap_or(rest.len())..];
            continue;
        } else if let Some(literal) = literal(rest) {
            rest = &rest[literal..];
            continue;
        } else {
            first.len_utf8()
        };
        if !first.is_whitespace() {
            tokens.push(&rest[..length]);
        }
        rest = &rest[length..];
    }
    tokens
}

/// Length of the string or character that begins here; a lifetime is neither.
fn literal(text: &str) -> Option<usize> {
    let quote = text.chars().next().filter(|c| ['"', '\''].contains(c))?;
    let mut is_escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        if c == quote && !is_escaped {
            return Some(at + 1);
        }
        is_escaped = c == '\\' && !is_escaped;
        let is_lifetime =
            quote == '\'' && at == 1 && c != '\\' && !text[1 + c.len_utf8()..].starts_with('\'');
        if is_lifetime {
            return None;
        }
    }
    None
}

/// Whether following `uses` from a module, within its room, leads back to it.
fn is_in_a_circle(module: &ItemPath, uses: &BTreeMap<ItemPath, BTreeSet<ItemPath>>) -> bool {
    let mut waiting: Vec<&ItemPath> = vec![module];
    let mut seen = BTreeSet::new();
    while let Some(next) = waiting.pop() {
        for used in uses.get(next).into_iter().flatten().filter(|used| used.first() == module.first()) {
            if used == module {
                return true;
            }
            if seen.insert(used) {
                waiting.push(used);
            }
        }
    }
    false
}

/// Uses that run from right to left, and modules that have no place in the order.
fn against_the_order(krate: &Crate, order: &[String]) -> Vec<String> {
    let place = |path: &ItemPath| order.iter().position(|room| Some(room) == path.first());
    let mut found = Vec::new();
    for (module, used) in krate.uses() {
        if module.is_empty() {
            continue;
        }
        let Some(here) = place(&module) else {
            found.push(format!("{} has no place in the order", module.join("/")));
            continue;
        };
        let wrong = used.iter().filter(|other| place(other).is_none_or(|there| there > here));
        found.extend(wrong.map(|other| format!("{} uses {}", module.join("/"), other.join("/"))));
    }
    found
}

/// The order in which ARCHITECTURE.md puts the modules of `src`, in the sentence that says which way data flows.
fn order_of_the_modules() -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("ARCHITECTURE.md");
    let text = fs::read_to_string(path).unwrap();
    let sentence = text.split("* Data flows one way: ").nth(1).unwrap().split(';').next().unwrap();
    sentence.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

#[test]
fn data_flows_one_way_between_the_modules_of_the_library() {
    let sources = sources(&["src"]);
    let krate = Crate::new("src", sources.iter());
    let order = order_of_the_modules();
    let pictured = ["aircraft", "structure", "equations", "flight", "fmi", "fmi2"];
    let places: Vec<_> = pictured.iter().map(|room| order.iter().position(|name| name == room)).collect();
    assert!(
        places.is_sorted() && places[0].is_some(),
        "the sentence contradicts the picture above it: {order:?}"
    );
    for room in &order {
        assert!(
            krate.0.keys().any(|path| path.first() == Some(room)),
            "ARCHITECTURE.md: there is no src/{room}"
        );
    }
    super::assert_none(&against_the_order(&krate, &order), "a module uses only what stands left of it");
}

#[test]
fn the_files_of_a_module_form_no_circles() {
    let sources = sources(&["src"]);
    let uses = Crate::new("src", sources.iter()).uses();
    let in_circles = uses.keys().filter(|module| is_in_a_circle(module, &uses));
    let in_circles: Vec<String> = in_circles.map(|module| module.join("/")).collect();
    super::assert_none(&in_circles, "files that lead back to themselves within their module");
}

#[test]
fn what_one_module_uses_of_another_is_seen_however_it_is_written() {
    let source = |path: &str, text: &str| Source { path: path.into(), text: text.into() };
    let all = |text: &str| {
        let sources = [
            source("src/lib.rs", "mod left;\nmod right;\n"),
            source("src/left/mod.rs", "mod part;\nmod other;\npub use part::{Thing, Else as Renamed};\n"),
            source("src/left/part.rs", text),
            source("src/left/other.rs", "use super::Thing;\n"),
            source("src/right.rs", "pub struct R;\nfn f() -> crate::left::Thing {}\n"),
        ];
        let krate = Crate::new("src", sources.iter());
        let order = ["left", "right"].map(str::to_owned);
        let circle = is_in_a_circle(&vec!["left".into(), "part".into()], &krate.uses());
        (against_the_order(&krate, &order), circle)
    };
    assert_eq!(all("fn f() {}\n"), (vec![], false));
    let wrong = vec!["left/part uses right".to_owned()];
    for text in [
        "use crate::right::R;\n",
        "use crate::{\n    a::B,\n    right::{self, R},\n};\n",
        "fn f<'a>(c: char) { if c == '\"' { crate::right::R } }\n",
        "use super::super::right::R;\n",
        "fn f() { format!(\"{}\", crate::right::R) }\n",
    ] {
        assert_eq!(all(text), (wrong.clone(), false), "{text}");
    }
    for text in
        ["// crate::right::R\n", "fn f() { \"crate::right::R\" }\n", "#[cfg(test)]\nuse crate::right::R;\n"]
    {
        assert_eq!(all(text), (vec![], false), "{text}");
    }
    for text in ["use super::other::X;\n", "fn f() { super::other::g() }\n"] {
        assert_eq!(all(text), (vec![], true), "{text}");
    }
}
