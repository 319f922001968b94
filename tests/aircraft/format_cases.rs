//! What the schema refuses the reader refuses, field by field: the cases stand in `tests/data/format-cases.json`, from which
//! `tests/fmpy/test_schema.py` asks the schema. They are changes of a file that has every field, each just outside or just
//! inside of what the table of the format says.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use flexible_aircraft::aircraft::format::{Absent, Allowed, FILE, Field, Kind, Rule, Table};
use flexible_aircraft::aircraft::{Aircraft, Diagnostic, Problem};
use serde_json::{Value, json};

use super::format_edits::{Edit, edited, text_of};
use super::format_samples::{all_forms, at_the_ends, form_with, middle, sample};

const BASE: &str = include_str!("../data/every-field.toml");

/// A change of the file.
struct Case {
    edits: Vec<Edit>,
    is_refused: bool,
    /// Fields that it is about: at least one of them is complained about.
    about: Vec<&'static str>,
    /// What the complaint says is allowed, if the table says it.
    allowed: Option<String>,
}

impl Case {
    fn of(at: &[Value], value: Option<Value>, is_refused: bool, about: &'static str) -> Self {
        let edits = vec![Edit { at: at.to_vec(), value }];
        Case { edits, is_refused, about: vec![about], allowed: None }
    }

    fn json(&self) -> Value {
        let edits = self.edits.iter().map(|edit| match &edit.value {
            Some(value) => json!({ "at": edit.at, "value": value }),
            None => json!({ "at": edit.at }),
        });
        json!({ "edits": edits.collect::<Vec<_>>(), "refused": self.is_refused })
    }

    /// What the reader says where that is not what it should.
    fn mistake(&self) -> Option<String> {
        let text = text_of(&edited(BASE, &self.edits));
        let found = Aircraft::parse(&text, "case.toml");
        let found = found.as_ref().err().map_or(&[][..], |error| error.diagnostics());
        let is_refused = found.iter().any(|diagnostic| self.is_about(diagnostic));
        (is_refused != self.is_refused).then(|| format!("{}: {found:?}", self.json()))
    }

    /// Whether a message says what the table says. Those on whole aircraft are others' business.
    fn is_about(&self, diagnostic: &Diagnostic) -> bool {
        let is_here = self.about.iter().any(|name| diagnostic.field.contains(name));
        is_here
            && match &self.allowed {
                Some(allowed) => diagnostic.allowed.starts_with(allowed.as_str()),
                None => {
                    self.is_refused || matches!(diagnostic.problem, Problem::WrongType | Problem::OutOfRange)
                }
            }
    }
}

/// Collects the cases of all tables.
#[derive(Default)]
struct Cases {
    cases: Vec<Case>,
    /// Fields that have theirs, by table and name.
    seen: BTreeSet<(&'static str, &'static str)>,
}

impl Cases {
    /// Those of a table that stands at some place in the file.
    fn of_table(&mut self, table: &'static Table, value: &Value, at: &[Value]) {
        if self.seen.insert((table.path, "")) {
            self.cases.push(Case::of(&within(at, "odd_field"), Some(json!(1)), true, "odd_field"));
        }
        for rule in table.rules {
            self.of_rule(rule, table, value, at);
        }
        for field in table.fields {
            let (Some(held), at) = (value.get(field.name), within(at, field.name)) else { continue };
            let is_new = self.seen.insert((table.path, field.name));
            if is_new && field.absent == Absent::Needed {
                self.cases.push(Case::of(&at, None, true, field.name));
            }
            if is_new {
                self.of_field(field, held, &at);
            }
            // Words on which other fields depend are tried with these.
            let decides =
                |rule: &Rule| matches!(rule, Rule::OnlyWhere(_, other, _) if other.name == field.name);
            if table.rules.iter().any(decides) {
                self.cases.retain(|case| case.is_refused || case.about != [field.name]);
            }
            match (field.kind, held) {
                (Kind::Tables(inner, _), Value::Array(entries)) => {
                    for (index, entry) in entries.iter().enumerate() {
                        self.of_table(inner, entry, &within(&at, index));
                    }
                }
                (Kind::Table(inner) | Kind::WordOrTable(_, inner), Value::Object(_)) => {
                    self.of_table(inner, held, &at);
                }
                _ => {}
            }
        }
    }

    fn add(&mut self, at: &[Value], value: Value, is_refused: bool, about: &'static str) {
        self.cases.push(Case::of(at, Some(value), is_refused, about));
    }

    /// Something of another kind, and what is just outside and inside of what the field may hold.
    fn of_field(&mut self, field: &'static Field, held: &Value, at: &[Value]) {
        let name = field.name;
        let odd = if matches!(field.kind, Kind::Flag) { json!("yes") } else { json!(true) };
        self.add(at, odd, true, name);
        match field.kind {
            Kind::Number(allowed) => self.of_numbers(allowed, at, name, &|number| json!(number)),
            Kind::NumberOrMore(allowed) | Kind::Numbers(allowed) => {
                if matches!(field.kind, Kind::NumberOrMore(_)) {
                    self.beyond(allowed, at, name, &|number| json!(number));
                }
                self.of_numbers(allowed, at, name, &|number| json!([number]));
                self.add(at, json!([]), true, name);
            }
            Kind::Whole(least, most) => self.of_whole(least, most, at, name),
            Kind::WholeOrMore(least, most) => {
                self.add(at, json!(most + 1), true, name);
                self.of_whole(least, most, &within(at, 0), name);
            }
            Kind::Text => self.add(at, json!("a\u{1}b"), true, name),
            Kind::Phrase => self.add(at, json!(" . "), true, name),
            Kind::Name => {
                ["left tip", "9a", ""].iter().for_each(|word| self.add(at, json!(word), true, name));
            }
            Kind::OneOf(words) => {
                words.iter().for_each(|word| self.add(at, json!(word.word), false, name));
                self.add(at, json!("no such word"), true, name);
            }
            Kind::WordOrWords(words, others) => {
                words.iter().for_each(|word| self.add(at, json!(word.word), false, name));
                others.iter().for_each(|word| self.add(at, json!([word.word]), false, name));
                let [one, next] = [others[0].word, others[1].word];
                self.add(at, json!([one, next]), false, name);
                let wrong = json!(["no such word", one, [words[0].word], [], [one, one]]);
                wrong.as_array().unwrap().iter().for_each(|value| self.add(at, value.clone(), true, name));
            }
            Kind::WordOrTable(word, _) => {
                self.add(at, json!(word.word), false, name);
                self.add(at, json!("no such word"), true, name);
            }
            Kind::Vector(allowed) => self.of_vector(allowed, held, at, name),
            Kind::Attitude(turn, pitch) => {
                self.of_vector(turn, held, at, name);
                self.of_numbers(pitch, &within(at, 1), name, &|number| json!(number));
            }
            Kind::Direction => {
                self.add(at, json!([0, 0, 0]), true, name);
                self.add(at, json!([1, 0]), true, name);
            }
            Kind::Corners(allowed) => {
                self.add(at, json!([[0, 0, 0]]), true, name);
                self.add(at, json!([[0, 0, 0], [1, 2]]), true, name);
                self.of_numbers(allowed, &within(&within(at, 1), 0), name, &|number| json!(number));
            }
            Kind::Matrix(allowed) => {
                self.add(at, json!([[1, 2], [2, 1]]), true, name);
                self.add(at, json!([[1], [1], [1], [1], [1], [1]]), true, name);
                self.of_numbers(allowed, &within(&within(at, 1), 0), name, &|number| json!(number));
            }
            Kind::Law(allowed, forms) => self.of_law(allowed, forms, at, name),
            Kind::Laws(allowed, forms) => {
                self.add(at, json!([0, 0]), true, name);
                self.of_law(allowed, forms, &within(at, 1), name);
            }
            // What such tables would have used may be complained about in their place.
            Kind::Tables(_, 1) => self.add(at, json!([]), true, ""),
            _ => {}
        }
    }

    fn of_whole(&mut self, least: usize, most: usize, at: &[Value], name: &'static str) {
        [least, most].iter().for_each(|inside| self.add(at, json!(inside), false, name));
        self.add(at, json!(least as i64 - 1), true, name);
        self.add(at, json!(most + 1), true, name);
        self.add(at, json!(least as f64 + 0.5), true, name);
    }

    fn of_vector(&mut self, allowed: &'static Allowed, held: &Value, at: &[Value], name: &'static str) {
        self.add(at, json!([0, 0]), true, name);
        let vector = held.clone();
        self.of_numbers(allowed, at, name, &|number| {
            let mut changed = vector.clone();
            changed[2] = json!(number);
            changed
        });
    }

    /// The ends of a range and what is just beyond them.
    fn of_numbers(
        &mut self,
        allowed: &'static Allowed,
        at: &[Value],
        name: &'static str,
        value: &dyn Fn(f64) -> Value,
    ) {
        for (number, is_inside) in at_the_ends(allowed.range) {
            let case = Case::of(at, Some(value(number)), !is_inside, name);
            self.cases.push(Case { allowed: Some(allowed.text()), ..case });
        }
    }

    /// What is just beyond the ends of a range, where more than the number decides whether it is taken within.
    fn beyond(
        &mut self,
        allowed: &'static Allowed,
        at: &[Value],
        name: &'static str,
        value: &dyn Fn(f64) -> Value,
    ) {
        let beyond = at_the_ends(allowed.range).into_iter().filter(|(_, is_inside)| !is_inside);
        for (number, _) in beyond {
            let case = Case::of(at, Some(value(number)), true, name);
            self.cases.push(Case { allowed: Some(allowed.text()), ..case });
        }
    }

    /// Each form with numbers of the law's quantity, with what another form has, and without what it needs.
    fn of_law(
        &mut self,
        allowed: &'static Allowed,
        forms: &[&'static Table],
        at: &[Value],
        name: &'static str,
    ) {
        self.of_numbers(allowed, at, name, &|number| json!(number));
        self.add(at, json!({}), true, name);
        for form in forms {
            let whole = form_with(form, middle(allowed.range));
            for field in form.fields {
                let mut part = whole.clone();
                part.as_object_mut().unwrap().remove(field.name);
                self.add(at, part, true, name);
                match field.kind {
                    Kind::LawNumbers => self.of_numbers(allowed, at, name, &|number| form_with(form, number)),
                    Kind::LawNumber => self.beyond(allowed, at, name, &|number| form_with(form, number)),
                    Kind::Numbers(own) => {
                        let number = middle(allowed.range);
                        self.beyond(own, at, field.name, &|place| {
                            let mut changed = form_with(form, number);
                            changed[field.name] = json!([place]);
                            changed
                        });
                    }
                    _ => {}
                }
            }
            let mut more = whole;
            more["odd_field"] = json!(1);
            self.add(at, more, true, name);
        }
        for form in all_forms().iter().filter(|form| forms.iter().all(|own| own.path != form.path)) {
            self.add(at, form_with(form, middle(allowed.range)), true, name);
        }
    }

    fn of_rule(&mut self, rule: &'static Rule, table: &'static Table, value: &Value, at: &[Value]) {
        let is_there = |field: &Field| value.get(field.name).is_some();
        let edit = |field: &Field, value: Option<Value>| Edit { at: within(at, field.name), value };
        let mut refused = |edits: Vec<Edit>, fields: &[&'static Field]| {
            let about = fields.iter().map(|field| field.name).collect();
            self.cases.push(Case { edits, is_refused: true, about, allowed: None });
        };
        let mut more = Vec::new();
        match *rule {
            Rule::ExactlyOne(fields) | Rule::AtMostOne(fields) => {
                for field in fields {
                    if is_there(field) && matches!(rule, Rule::ExactlyOne(_)) {
                        refused(vec![edit(field, None)], fields);
                    }
                    if !is_there(field) && fields.iter().any(|other| is_there(other)) {
                        refused(vec![edit(field, Some(sample(field.kind)))], fields);
                    }
                    if let (false, Kind::Number(allowed), Rule::AtMostOne(_)) =
                        (is_there(field), field.kind, rule)
                    {
                        // In the place of the others, and of what needs these.
                        let needing = table.rules.iter().filter_map(|rule| match rule {
                            Rule::Needs(other, needed)
                                if fields.iter().any(|one| one.name == needed.name) =>
                            {
                                Some(*other)
                            }
                            _ => None,
                        });
                        let gone = fields.iter().copied().chain(needing);
                        let gone: Vec<Edit> =
                            gone.filter(|one| is_there(one)).map(|one| edit(one, None)).collect();
                        for (number, is_inside) in at_the_ends(allowed.range) {
                            let edits =
                                gone.iter().cloned().chain([edit(field, Some(json!(number)))]).collect();
                            let allowed = Some(allowed.text());
                            more.push(Case {
                                edits,
                                is_refused: !is_inside,
                                about: vec![field.name],
                                allowed,
                            });
                        }
                    }
                }
            }
            Rule::Needs(field, needed) if is_there(field) && is_there(needed) => {
                // Where something could stand in its place, that is said to be missing too.
                let others = table.rules.iter().filter_map(|rule| match rule {
                    Rule::ExactlyOne(fields) if fields.iter().any(|other| other.name == needed.name) => {
                        Some(*fields)
                    }
                    _ => None,
                });
                let about: Vec<&Field> = others.flatten().copied().chain([field, needed]).collect();
                refused(vec![edit(needed, None)], &about);
            }
            Rule::Needs(field, needed) if !is_there(field) && !is_there(needed) => {
                refused(vec![edit(field, Some(sample(field.kind)))], &[field, needed]);
            }
            Rule::OnlyWhere(field, other, word) => {
                let another = other.kind.words().iter().find(|another| another.word != word).unwrap();
                refused(vec![edit(other, Some(json!(another.word)))], &[field]);
            }
            Rule::Narrower(field, allowed, other, word) => {
                let excluded = table.rules.iter().filter_map(|rule| match rule {
                    Rule::OnlyWhere(field, ..) | Rule::Needs(field, _) => Some(edit(field, None)),
                    _ => None,
                });
                let excluded: Vec<Edit> = excluded.collect();
                // The upper end is the field's own.
                for (number, is_inside) in at_the_ends(allowed.range).into_iter().take(2) {
                    let mut edits = excluded.clone();
                    edits.push(edit(other, Some(json!(word))));
                    edits.push(edit(field, Some(json!(number))));
                    let allowed = Some(allowed.text());
                    more.push(Case { edits, is_refused: !is_inside, about: vec![field.name], allowed });
                }
            }
            _ => {}
        }
        self.cases.extend(more);
    }
}

/// The same path and one step more.
fn within(at: &[Value], step: impl Into<Value>) -> Vec<Value> {
    at.iter().cloned().chain([step.into()]).collect()
}

fn cases() -> Vec<Case> {
    let mut all = Cases::default();
    let base = edited(BASE, &[]);
    all.of_table(&FILE, &base, &[]);
    all.cases
}

/// Fields that a file with the others cannot have.
const EXCLUDED: [&str; 2] = ["altitude_m", "temperature_offset_K"];

#[test]
fn the_file_with_every_field_is_an_aircraft_and_has_every_field() {
    Aircraft::parse(BASE, "every-field.toml").unwrap_or_else(|error| panic!("{error}"));
    let mut all = Cases::default();
    all.of_table(&FILE, &edited(BASE, &[]), &[]);
    let mut tables = vec![&FILE];
    while let Some(table) = tables.pop() {
        for field in table.fields {
            let is_there = all.seen.contains(&(table.path, field.name));
            assert!(is_there || EXCLUDED.contains(&field.name), "{}.{}", table.path, field.name);
            tables.extend(field.kind.table());
        }
    }
}

#[test]
fn what_the_table_refuses_the_reader_refuses_and_the_ends_of_ranges_are_within() {
    let cases = cases();
    assert!(cases.iter().filter(|case| case.is_refused).count() > 200, "{}", cases.len());
    let mistakes: Vec<String> = cases.iter().filter_map(Case::mistake).collect();
    assert!(mistakes.is_empty(), "{}", mistakes.join("\n"));
    let lines: Vec<String> = cases.iter().map(|case| case.json().to_string()).collect();
    let text = format!("[\n{}\n]\n", lines.join(",\n"));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/format-cases.json");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, &text).unwrap();
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    assert!(found == text, "{} is stale; UPDATE_GOLDEN=1 rewrites it", path.display());
}
