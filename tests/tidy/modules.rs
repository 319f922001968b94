//! The modules of a crate and the paths in their code.

use std::collections::{BTreeMap, BTreeSet};

use super::Source;

/// Where an item is: the names from the root of the crate to it.
pub type ItemPath = Vec<String>;

/// A file as a module that uses others.
#[derive(Debug, Default)]
pub struct Module {
    /// All paths in its code but those that it only hands on.
    used: Vec<ItemPath>,
    /// `pub use`: the name here, the path there.
    handed_on: BTreeMap<String, ItemPath>,
    /// `pub use path::*`: nobody can tell from where a name comes.
    pub handed_on_whole: Vec<ItemPath>,
}

/// One name that a `use` brings.
#[derive(Debug)]
struct Import {
    /// As it is called here; `*` for all that is there.
    name: String,
    path: ItemPath,
}

/// The modules of a crate by their paths.
pub struct Crate(pub BTreeMap<ItemPath, Module>);

impl Crate {
    /// Of the files below a folder, without unit tests.
    pub fn new<'s>(folder: &str, sources: impl Iterator<Item = &'s Source>) -> Self {
        let modules = sources.filter(|source| !source.is_tests()).map(|source| {
            let code: String = source.code().flat_map(|(_, line)| [line, "\n"]).collect();
            (module_path(folder, source), Module::of(&tokens(&code)))
        });
        Crate(modules.collect())
    }

    /// Of the files below a folder, unit tests and all.
    pub fn with_tests<'s>(folder: &str, sources: impl Iterator<Item = &'s Source>) -> Self {
        Crate(
            sources.map(|source| (module_path(folder, source), Module::of(&tokens(&source.text)))).collect(),
        )
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

    /// Which modules each one uses, itself, the root of the crate and the children whose names it hands on left out.
    pub fn uses(&self) -> BTreeMap<ItemPath, BTreeSet<ItemPath>> {
        let uses = self.0.iter().map(|(path, module)| {
            let home = |used: &ItemPath| self.home(path, used, 8);
            let handed_on = module.handed_on.values().chain(&module.handed_on_whole).filter_map(home);
            let handed_on = handed_on.filter(|home| !home.starts_with(path));
            let homes = module.used.iter().filter_map(home).chain(handed_on);
            (path.clone(), homes.filter(|home| home != path && !home.is_empty()).collect())
        });
        uses.collect()
    }
}

/// The names from the root of the crate to the module of a file.
fn module_path(folder: &str, source: &Source) -> ItemPath {
    let name = source.path.strip_prefix(folder).unwrap().strip_suffix(".rs").unwrap();
    let mut path: ItemPath = name.split('/').filter(|part| !part.is_empty()).map(str::to_owned).collect();
    path.pop_if(|last| ["mod", "lib", "main"].contains(&last.as_str()));
    path
}

impl Module {
    fn of(tokens: &[&str]) -> Self {
        let mut module = Module::default();
        // Of each module within the file how many braces were open before it, and how many are now.
        let (mut inner, mut braces) = (Vec::new(), 0_usize);
        let mut at = 0;
        while at < tokens.len() {
            let token = tokens[at];
            let before = at.checked_sub(1).map(|before| tokens[before]);
            if token == "use" {
                let mut imports = Vec::new();
                at = use_tree(tokens, at + 1, &[], &mut imports);
                let is_handed_on = inner.is_empty() && matches!(before, Some("pub" | ")"));
                imports.into_iter().for_each(|import| module.add(import, is_handed_on, inner.len()));
            } else if token == "mod" && tokens.get(at + 2) == Some(&"{") {
                inner.push(braces);
                at += 1;
            } else if token == "{" {
                braces += 1;
            } else if token == "}" {
                braces = braces.saturating_sub(1);
                inner.pop_if(|before| *before == braces);
            } else if is_name(token) && before != Some("::") {
                let path = path_from(tokens, at);
                at += 2 * (path.len() - 1);
                if path.len() > 1 {
                    module.used.push(from_the_file(path, inner.len()));
                }
            }
            at += 1;
        }
        module
    }

    fn add(&mut self, Import { name, path }: Import, is_handed_on: bool, depth: usize) {
        match (is_handed_on, name.as_str()) {
            (false, _) => self.used.push(from_the_file(path, depth)),
            (true, "*") => self.handed_on_whole.push(path),
            (true, _) => drop(self.handed_on.insert(name, path)),
        }
    }
}

/// The path `a::b::c` that begins at a place.
fn path_from(tokens: &[&str], at: usize) -> ItemPath {
    let others = tokens[at + 1..].chunks_exact(2).take_while(|pair| pair[0] == "::" && is_name(pair[1]));
    [tokens[at]].into_iter().chain(others.map(|pair| pair[1])).map(str::to_owned).collect()
}

/// A path that stands in a module within modules of a file, as it would stand in the file: with a `super` less for each.
fn from_the_file(mut path: ItemPath, depth: usize) -> ItemPath {
    let supers = path.iter().take_while(|part| *part == "super").count();
    path.drain(..supers.min(depth));
    if supers > 0 && supers <= depth {
        path.insert(0, "self".to_owned());
    }
    path
}

/// Reads `a::{b, c::d as e, f::*}` from a place on, and says where it ends.
fn use_tree(tokens: &[&str], mut at: usize, prefix: &[String], imports: &mut Vec<Import>) -> usize {
    let mut path = prefix.to_vec();
    let mut name = None;
    while let Some(&token) = tokens.get(at) {
        match token {
            "{" => {
                while tokens.get(at).is_some_and(|token| *token != "}") {
                    at = use_tree(tokens, at + 1, &path, imports);
                }
                return at + 1;
            }
            "," | "}" | ";" => break,
            "as" => {
                at += 1;
                name = tokens.get(at).map(|&alias| alias.to_owned());
            }
            "::" => {}
            "*" => name = Some(token.to_owned()),
            part => path.push(part.to_owned()),
        }
        at += 1;
    }
    let is_empty = path.len() == prefix.len() && name.is_none();
    if path.len() > 1 {
        path.pop_if(|last| last == "self");
    }
    if let Some(name) = name.or_else(|| path.last().filter(|_| !is_empty).cloned()) {
        imports.push(Import { name, path });
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
