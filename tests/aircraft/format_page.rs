//! The format's page: its tables of fields are those that the reader asks.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use flexible_aircraft::aircraft::format::{Absent, FILE, Field, Kind, Table};

const PAGE: &str = "aircraft/README.md";

/// All tables but the forms of a law, which the page explains by examples, each once: as the file has them, from the top.
fn tables() -> Vec<&'static Table> {
    let mut tables: Vec<&'static Table> = vec![&FILE];
    let mut next = 0;
    while next < tables.len() {
        let inner: Vec<_> = tables[next].fields.iter().filter_map(|field| field.kind.table()).collect();
        tables.extend(inner);
        next += 1;
    }
    tables
}

/// What opens the part of the page that is written from a table.
fn opening(table: &Table) -> String {
    let path = if table.path.is_empty() { "file" } else { table.path };
    format!("<!-- fields: {path} -->\n")
}

const CLOSING: &str = "\n<!-- end of fields -->";

/// The rows of a table on the page.
fn rows(table: &Table) -> String {
    let rows = table.fields.iter().map(|field| {
        let absent = match table.alternatives(field) {
            Some(names) => format!("{names} needed"),
            None => field.absent.in_words(),
        };
        format!("\n| `{}` | {} | {} | {absent} |", field.name, meaning(field), field.allowed_in_words())
    });
    format!(
        "\n| field | meaning | allowed | default |\n| --- | --- | --- | --- |{}\n",
        rows.collect::<String>()
    )
}

/// What a field is, and what its words mean. The levels of fidelity have a part of the page.
fn meaning(field: &Field) -> String {
    let words = match field.kind {
        Kind::OneOf(words) if field.name != "model" => words,
        Kind::WordOrWords(words, _) => words,
        _ => &[],
    };
    let words = words.iter().map(|word| format!("{} {}", word.in_quotes(), word.sentence));
    let words = words.collect::<Vec<_>>().join("; ");
    if words.is_empty() { field.sentence.to_owned() } else { format!("{}: {words}", field.sentence) }
}

#[test]
fn the_tables_of_the_page_are_those_of_the_format() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(PAGE);
    let mut page = fs::read_to_string(&path).unwrap();
    assert_eq!(page.matches("<!-- fields: ").count(), tables().len(), "tables that the format no longer has");
    for table in tables() {
        let opening = opening(table);
        let (before, rest) =
            page.split_once(&opening).unwrap_or_else(|| panic!("{PAGE} has no line {opening}"));
        let (written, after) = rest.split_once(CLOSING).expect("an end of the fields");
        let rows = rows(table);
        let is_right = written == rows;
        page = format!("{before}{opening}{rows}{}{after}", &CLOSING);
        if std::env::var_os("UPDATE_GOLDEN").is_none() {
            assert!(is_right, "{PAGE} is stale; UPDATE_GOLDEN=1 rewrites it. It should be:\n{opening}{rows}");
        }
    }
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, page).unwrap();
    }
}

#[test]
fn a_field_has_the_unit_that_its_name_ends_in() {
    const ENDINGS: [(&str, &str); 17] = [
        ("_N_m_per_rad", "N m/rad"),
        ("_Pa", "Pa"),
        ("_chords", "chords"),
        ("_lengths", "lengths"),
        ("_kg_m3", "kg/m³"),
        ("_kg_m2", "kg m²"),
        ("_kg_m2_s", "kg m²/s"),
        ("_N_m2", "N m²"),
        ("_m_s2", "m/s²"),
        ("_m_s", "m/s"),
        ("_m2", "m²"),
        ("_per_rad", "per rad"),
        ("_deg", "deg"),
        ("_kg", "kg"),
        ("_K", "K"),
        ("_N", "N"),
        ("_m", "m"),
    ];
    for field in tables().iter().flat_map(|table| table.fields) {
        let expected = ENDINGS.iter().find(|(ending, _)| field.name.ends_with(ending));
        let expected = expected.map_or("", |(_, unit)| *unit);
        assert_eq!(field.unit, expected, "{}", field.name);
    }
}

#[test]
fn a_default_is_among_the_numbers_that_its_field_may_hold_and_names_are_there_once() {
    for table in tables() {
        let names: BTreeSet<&str> = table.fields.iter().map(|field| field.name).collect();
        assert_eq!(names.len(), table.fields.len(), "{}", table.path);
        for field in table.fields {
            let holds = match (field.absent, field.kind) {
                (Absent::Number(number), Kind::Number(allowed) | Kind::Law(allowed, _)) => {
                    allowed.range.contains(number)
                }
                (Absent::Whole(number), Kind::Whole(least, most)) => (least..=most).contains(&number),
                (Absent::Flag(_), Kind::Flag) => true,
                (Absent::Word(word), Kind::OneOf(words)) => words.iter().any(|other| other.word == word),
                (
                    Absent::Zeros,
                    Kind::Vector(allowed) | Kind::Attitude(allowed, _) | Kind::Laws(allowed, _),
                ) => allowed.range.contains(0.0),
                (Absent::Needed | Absent::Nothing | Absent::Found(_), _) => true,
                _ => false,
            };
            assert!(holds, "{}.{}: {:?}", table.path, field.name, field.absent);
        }
    }
}

#[test]
fn the_page_explains_every_form_of_a_law() {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(PAGE)).unwrap();
    let laws = page.split("\n## Laws\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let component = FILE.fields.iter().find(|field| field.name == "component").unwrap().kind.table().unwrap();
    let stiffness = component.fields.iter().find(|field| field.name == "EA_N").unwrap();
    let Kind::Law(_, forms) = stiffness.kind else { panic!("a stiffness is a law") };
    assert_eq!(forms.len(), 5);
    for field in forms.iter().flat_map(|form| form.fields) {
        assert!(laws.contains(&format!("{} = ", field.name)), "{}", field.name);
    }
}
