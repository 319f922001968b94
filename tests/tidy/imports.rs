//! Which way data flows: the modules of the library from left to right, the files of a module without circles.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use super::modules::{Crate, ItemPath};
use super::{Source, sources};

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
    let pictured = ["aircraft", "structure", "equations", "flight", "fmi", "fmi2", "fmi3"];
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
fn unit_tests_look_no_higher_than_what_they_test() {
    let sources = sources(&["src"]);
    let krate = Crate::with_tests("src", sources.iter());
    let found = against_the_order(&krate, &order_of_the_modules());
    super::assert_none(&found, "a unit test uses only what stands left of it; others are in tests/");
}

#[test]
fn what_a_module_hands_on_has_a_name() {
    let sources = sources(&["src"]);
    let krate = Crate::new("src", sources.iter());
    let whole = krate.0.iter().filter(|(_, module)| !module.handed_on_whole.is_empty());
    let whole: Vec<String> = whole.map(|(path, _)| path.join("/")).collect();
    super::assert_none(&whole, "`pub use …::*` hides from where names come");
}

#[test]
fn the_files_of_a_module_form_no_circles() {
    for root in ["src", "packaging/src"] {
        let sources = sources(&[root]);
        let uses = Crate::new(root, sources.iter()).uses();
        let in_circles = uses.keys().filter(|module| is_in_a_circle(module, &uses));
        let in_circles: Vec<String> =
            in_circles.map(|module| format!("{root}/{}", module.join("/"))).collect();
        super::assert_none(&in_circles, "files that lead back to themselves within their module");
    }
}

/// A crate of two rooms, `left` and `right`, of which `left` has two files, `part` with a given text and `other`.
fn two_rooms(part: &str) -> [Source; 5] {
    let other = "use super::{Thing, Renamed};\npub struct X;\npub struct Y;\n";
    [
        ("src/lib.rs", "mod left;\nmod right;\n"),
        (
            "src/left/mod.rs",
            "mod part;\nmod other;\npub use other::Y;\npub use part::{Thing, Else as Renamed};\n",
        ),
        ("src/left/part.rs", part),
        ("src/left/other.rs", other),
        ("src/right.rs", "pub struct R;\nfn f() -> crate::left::Thing {}\n"),
    ]
    .map(|(path, text)| Source { path: path.into(), text: text.into() })
}

/// What is against the order, and whether `part` leads back to itself.
fn found_in(krate: &Crate) -> (Vec<String>, bool) {
    let order = ["left", "right"].map(str::to_owned);
    let circle = is_in_a_circle(&vec!["left".into(), "part".into()], &krate.uses());
    (against_the_order(krate, &order), circle)
}

#[test]
fn what_one_module_uses_of_another_is_seen_however_it_is_written() {
    let all = |text: &str| found_in(&Crate::new("src", two_rooms(text).iter()));
    assert_eq!(all("fn f() {}\n"), (vec![], false));
    let wrong = vec!["left/part uses right".to_owned()];
    for text in [
        "use crate::right::R;\n",
        "use crate::{\n    a::B,\n    right::{self, R},\n};\n",
        "use crate::right::{self};\n",
        "use crate::right::*;\n",
        "fn f<'a>(c: char) { if c == '\"' { crate::right::R } }\n",
        "use super::super::right::R;\n",
        "fn f() { format!(\"{}\", crate::right::R) }\n",
        "mod inner {\n    fn f() { super::super::super::right::R }\n}\n",
        "mod inner {}\nuse super::super::right::R;\n",
        "pub use crate::right::R;\n",
        "pub(super) use crate::right::R as Renamed;\n",
        "pub use crate::right::*;\n",
    ] {
        assert_eq!(all(text), (wrong.clone(), false), "{text}");
    }
    for text in
        ["// crate::right::R\n", "fn f() { \"crate::right::R\" }\n", "#[cfg(test)]\nuse crate::right::R;\n"]
    {
        assert_eq!(all(text), (vec![], false), "{text}");
    }
    for text in [
        "use super::other::X;\n",
        "fn f() { super::other::g() }\n",
        "use super::Y;\n",
        "pub(super) use super::other::X;\n",
        "pub use super::other::X as Else;\n",
    ] {
        assert_eq!(all(text), (vec![], true), "{text}");
    }
}

#[test]
fn a_name_is_followed_to_where_it_was_given() {
    let [root, parent, part, _, right] = two_rooms("use super::other::X;\n");
    for (text, leads_to_part) in [("use super::Renamed;\n", true), ("use super::Else;\n", false)] {
        let other = Source { path: "src/left/other.rs".into(), text: text.into() };
        let krate = Crate::new("src", [&root, &parent, &part, &other, &right].into_iter());
        assert_eq!(found_in(&krate).1, leads_to_part, "{text}");
    }
    let krate = Crate::new("src", two_rooms("pub use super::other::*;\n").iter());
    assert_eq!(krate.0[&["left", "part"].map(str::to_owned)[..]].handed_on_whole.len(), 1);
}

#[test]
fn what_unit_tests_use_is_seen_too() {
    let all = |text: &str| found_in(&Crate::with_tests("src", two_rooms(text).iter())).0;
    for text in [
        "#[cfg(test)]\nuse crate::right::R;\n",
        "#[cfg(test)]\nmod tests {\n    use crate::right::R;\n}\n",
        "#[cfg(test)]\nmod tests {\n    use super::super::super::right::R;\n}\n",
    ] {
        assert_eq!(all(text), ["left/part uses right"], "{text}");
    }
    assert_eq!(
        all("#[cfg(test)]\nmod tests {\n    use super::*;\n    use super::super::other::X;\n}\n"),
        [""; 0]
    );
}
