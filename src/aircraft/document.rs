//! A TOML document as values that know their place and complain by themselves.
//!
//! Reading the parsed document directly, rather than through serde's derive, lets one pass collect every
//! mistake of a file and keeps the place of every value until it is used.

use nalgebra::Vector3;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::{Place, Problem, Report, join};
use super::format::{self, Absent, Allowed, Field, Kind, LEAST_COMPONENT, Word};
use super::toml_value::{toml_found, toml_number};

/// A value that was read, with its place for later complaints.
#[derive(Clone, Debug)]
pub(super) struct Located<T> {
    pub(super) value: T,
    pub(super) place: Place,
}

/// A TOML value, and what the format says that it may be.
pub(super) struct Value<'r, 't> {
    value: &'r DeValue<'t>,
    /// That of its field; entries of a list have that of the list.
    pub(super) kind: Kind,
    pub(super) place: Place,
    pub(super) report: &'r Report<'t>,
}

impl<'r, 't> Value<'r, 't> {
    fn new(value: &'r Spanned<DeValue<'t>>, kind: Kind, field: String, report: &'r Report<'t>) -> Self {
        Value { value: value.get_ref(), kind, place: Place { span: value.span(), field }, report }
    }

    /// The same of other numbers: those of the law in a form of which it stands.
    pub(super) fn within(self, allowed: &'static Allowed) -> Self {
        Value { kind: Kind::Numbers(allowed), ..self }
    }

    /// Complains that the value is of the wrong kind; `what` is allowed.
    pub(super) fn wrong<T>(&self, what: &str) -> Option<T> {
        self.report.add(
            Problem::WrongType,
            &self.place,
            toml_found(self.value),
            format!("{what} is allowed"),
        );
        None
    }

    pub(super) fn located<T>(&self, read: impl FnOnce(&Self) -> Option<T>) -> Option<Located<T>> {
        read(self).map(|value| Located { value, place: self.place.clone() })
    }

    pub(super) fn is_number(&self) -> bool {
        matches!(self.value, DeValue::Integer(_) | DeValue::Float(_))
    }

    pub(super) fn is_empty_list(&self) -> bool {
        matches!(self.value, DeValue::Array(list) if list.is_empty())
    }

    pub(super) fn has_field(&self, field: &Field) -> bool {
        matches!(self.value, DeValue::Table(table) if table.contains_key(field.name))
    }

    pub(super) fn number(&self) -> Option<f64> {
        match toml_number(self.value) {
            Some(number) => self.kind.allowed().check(number, &self.place, self.report).then_some(number),
            None => self.wrong("a number"),
        }
    }

    /// A whole number in the range.
    pub(super) fn integer(&self) -> Option<usize> {
        let (least, most) = self.kind.whole();
        let text = if least == most {
            format!("the number {least}")
        } else {
            format!("a whole number from {least} to {most}")
        };
        let DeValue::Integer(number) = self.value else { return self.wrong(&text) };
        match usize::from_str_radix(number.as_str(), number.radix()) {
            Ok(number) if (least..=most).contains(&number) => Some(number),
            _ => {
                let (found, allowed) = (format!("found {number}"), format!("{text} is allowed"));
                self.report.add(Problem::OutOfRange, &self.place, found, allowed);
                None
            }
        }
    }

    pub(super) fn flag(&self) -> Option<bool> {
        match self.value {
            DeValue::Boolean(flag) => Some(*flag),
            _ => self.wrong("true or false"),
        }
    }

    /// A text on one line, of characters that XML can hold.
    pub(super) fn text(&self) -> Option<String> {
        match self.value {
            DeValue::String(text) if text.contains(is_unprintable) => {
                self.wrong("a text without control characters")
            }
            DeValue::String(text) => Some(text.to_string()),
            _ => self.wrong("a text"),
        }
    }

    /// A text that becomes part of a sentence: not empty, and without a full stop.
    pub(super) fn phrase(&self) -> Option<String> {
        let text = self.text()?;
        let phrase = text.trim().trim_end_matches('.').trim_end();
        if phrase.is_empty() { self.wrong("a text that is not empty") } else { Some(phrase.to_owned()) }
    }

    /// A name that can be part of an FMI variable name: letters, digits and underscores.
    pub(super) fn name(&self) -> Option<String> {
        let name = self.text()?;
        if is_name(&name) {
            return Some(name);
        }
        self.wrong("a name of letters, digits and underscores that does not begin with a digit")
    }

    /// What one of the words means.
    pub(super) fn one_of<T: Copy>(&self, meanings: &[(&str, T)]) -> Option<T> {
        let words = self.kind.words();
        let chosen = match self.value {
            DeValue::String(text) => words.iter().find(|word| word.word == text),
            _ => None,
        };
        let list = || words.iter().map(|word| format!("\"{}\"", word.word)).collect::<Vec<_>>().join(" or ");
        let meaning = |word: &Word| meanings.iter().find(|(other, _)| *other == word.word);
        chosen.and_then(meaning).map(|(_, meaning)| *meaning).or_else(|| self.wrong(&list()))
    }

    /// What some of the other words of the field mean, each once.
    pub(super) fn several_of<T: Copy>(&self, meanings: &[(&str, T)]) -> Option<Vec<T>> {
        let names = || meanings.iter().map(|(word, _)| format!("\"{word}\"")).collect::<Vec<_>>().join(", ");
        let what = || format!("a list of at least one of {}, each once,", names());
        let list = self.list(&what())?;
        let mut chosen: Vec<usize> = Vec::new();
        for entry in &list {
            let DeValue::String(text) = entry.value else { return entry.wrong(&names()) };
            match meanings.iter().position(|(word, _)| word == text) {
                Some(place) if !chosen.contains(&place) => chosen.push(place),
                Some(_) => return self.wrong(&what()),
                None => return entry.wrong(&names()),
            }
        }
        if chosen.is_empty() {
            self.wrong(&what())
        } else {
            Some(chosen.iter().map(|&place| meanings[place].1).collect())
        }
    }

    pub(super) fn is_list(&self) -> bool {
        matches!(self.value, DeValue::Array(_))
    }

    pub(super) fn list(&self, what: &str) -> Option<Vec<Value<'r, 't>>> {
        let DeValue::Array(list) = self.value else { return self.wrong(what) };
        let entry = |(i, value)| {
            Value::new(value, self.kind, format!("{}[{}]", self.place.field, i + 1), self.report)
        };
        Some(list.iter().enumerate().map(entry).collect())
    }

    /// At least one number.
    pub(super) fn numbers(&self) -> Option<Vec<f64>> {
        let list = self.list("a list of numbers")?;
        if list.is_empty() {
            return self.wrong("a list of at least one number");
        }
        let numbers: Vec<Option<f64>> = list.iter().map(Value::number).collect();
        numbers.into_iter().collect()
    }

    /// A number or a list of numbers, each with its own place.
    pub(super) fn one_or_more_numbers(&self) -> Option<Vec<Located<f64>>> {
        if self.is_number() {
            return Some(vec![self.located(Value::number)?]);
        }
        let list = self.list("a number or a list of numbers")?;
        if list.is_empty() {
            return self.wrong("a number or a list of at least one number");
        }
        let numbers: Vec<_> = list.iter().map(|value| value.located(Value::number)).collect();
        numbers.into_iter().collect()
    }

    /// Three numbers.
    pub(super) fn vector(&self) -> Option<Vector3<f64>> {
        match self.list("a list of three numbers")?.as_slice() {
            [x, y, z] => {
                let (x, y, z) = (x.number(), y.number(), z.number());
                Some(Vector3::new(x?, y?, z?))
            }
            _ => self.wrong("a list of three numbers"),
        }
    }

    /// Three numbers of which at least one is not 0, scaled to length 1.
    pub(super) fn direction(&self) -> Option<Vector3<f64>> {
        let vector = self.vector()?;
        let greatest = vector.amax();
        if greatest >= LEAST_COMPONENT {
            return Some((vector / greatest).normalize());
        }
        let (found, allowed) = ("found a vector of length 0", "a vector with a direction is allowed");
        self.report.add(Problem::NoDirection, &self.place, found, allowed);
        None
    }

    /// The entries of a table of any fields.
    pub(super) fn entries(&self) -> Option<Vec<(String, Value<'r, 't>)>> {
        let DeValue::Table(table) = self.value else { return self.wrong("a table") };
        let entry = |(key, value): (&'r Spanned<_>, &'r Spanned<DeValue<'t>>)| {
            let name = ToString::to_string(key.get_ref());
            let mut value = Value::new(value, self.kind, join(&self.place.field, &name), self.report);
            value.place.span = key.span();
            (name, value)
        };
        Some(table.iter().map(entry).collect())
    }

    /// The table that the format has there.
    pub(super) fn table(&self) -> Option<Table<'r, 't>> {
        self.table_of(self.kind.table()?)
    }

    /// A table of some format.
    pub(super) fn table_of(&self, format: &'static format::Table) -> Option<Table<'r, 't>> {
        let DeValue::Table(table) = self.value else { return self.wrong("a table") };
        Some(Table::new(table, self.place.clone(), format, self.report))
    }
}

/// Whether a text has only letters, digits and underscores and does not begin with a digit.
fn is_name(text: &str) -> bool {
    let starts_well = text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    starts_well && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// Control characters, and the two that neither they are nor XML allows.
fn is_unprintable(character: char) -> bool {
    character.is_control() || matches!(character, '\u{fffe}' | '\u{ffff}')
}

/// A TOML table of known fields.
pub(super) struct Table<'r, 't> {
    table: &'r DeTable<'t>,
    pub(super) place: Place,
    format: &'static format::Table,
    pub(super) report: &'r Report<'t>,
}

impl<'r, 't> Table<'r, 't> {
    /// Takes a table and complains about every field that its format does not know.
    pub(super) fn new(
        table: &'r DeTable<'t>,
        place: Place,
        format: &'static format::Table,
        report: &'r Report<'t>,
    ) -> Self {
        for key in table.keys().filter(|key| !format.knows(key.get_ref())) {
            let field = join(&place.field, key.get_ref());
            let found = format!("found the unknown field \"{}\"", key.get_ref());
            let meant = format.with_unit(key.get_ref());
            let meant = meant.map_or(String::new(), |name| format!("did you mean \"{name}\"? "));
            let allowed = format!("{meant}allowed here: {}", format.names());
            report.add(Problem::UnknownField, &Place { span: key.span(), field }, found, allowed);
        }
        Table { table, place, format, report }
    }

    pub(super) fn optional(&self, field: &Field) -> Option<Value<'r, 't>> {
        let Field { name, kind, .. } = *field;
        debug_assert!(self.format.has(field), "{name} must be among the fields of the table");
        let value = self.table.get(name)?;
        Some(Value::new(value, kind, join(&self.place.field, name), self.report))
    }

    /// The number of a field, or that which holds where the field is left out.
    pub(super) fn number(&self, field: &Field) -> f64 {
        self.optional(field).and_then(|value| value.number()).unwrap_or(field.absent.number())
    }

    /// The same with its place: that of the table where the field is left out.
    pub(super) fn located_number(&self, field: &Field) -> Located<f64> {
        let place = self.optional(field).map(|value| value.place);
        Located { value: self.number(field), place: place.unwrap_or_else(|| self.place.within(field.name)) }
    }

    /// The whole number of a field, or that which holds where the field is left out.
    pub(super) fn integer(&self, field: &Field) -> usize {
        self.optional(field).and_then(|value| value.integer()).unwrap_or(field.absent.whole())
    }

    /// The flag of a field, or that which holds where the field is left out.
    pub(super) fn flag(&self, field: &Field) -> bool {
        let default = field.absent == Absent::Flag(true);
        self.optional(field).and_then(|value| value.flag()).unwrap_or(default)
    }

    /// The three numbers of a field, 0 where it is left out.
    pub(super) fn vector(&self, field: &Field) -> Vector3<f64> {
        self.optional(field).and_then(|value| value.vector()).unwrap_or_default()
    }

    pub(super) fn required(&self, field: &Field) -> Option<Value<'r, 't>> {
        let value = self.optional(field);
        if value.is_none() {
            let found = format!("the field \"{}\" is missing", field.name);
            let allowed = format!("it is needed; allowed here: {}", self.format.names());
            self.report.add(Problem::MissingField, &self.place.within(field.name), found, allowed);
        }
        value
    }

    /// Exactly one of some fields that stand for each other.
    pub(super) fn either(&self, fields: &[&'static Field]) -> Option<(&'static Field, Value<'r, 't>)> {
        let mut present = fields.iter().filter_map(|&field| Some((field, self.optional(field)?)));
        let first = present.next();
        let names = || fields.iter().map(|field| field.name).collect::<Vec<_>>().join(", ");
        let allowed = || format!("exactly one of {} is allowed", names());
        match (&first, present.next()) {
            (Some(_), None) => return first,
            (None, _) => {
                let found = format!("none of {} is there", names());
                self.report.add(Problem::MissingField, &self.place.within(fields[0].name), found, allowed());
            }
            (Some((one, _)), Some((two, value))) => {
                let found = format!("found \"{}\" and \"{}\"", one.name, two.name);
                self.report.add(Problem::Contradiction, &value.place, found, allowed());
            }
        }
        None
    }

    /// The tables of an array of tables, none when the field is absent. Those with a proper name are called by it.
    pub(super) fn tables(&self, field: &Field) -> Vec<Table<'r, 't>> {
        let Some(value) = self.optional(field) else { return Vec::new() };
        let list = value.list(&format!("a list of tables ([[{}]])", value.place.field)).unwrap_or_default();
        let named = |mut entry: Value<'r, 't>| {
            if let DeValue::Table(table) = entry.value
                && let Some(DeValue::String(name)) = table.get("name").map(Spanned::get_ref)
                && is_name(name)
            {
                entry.place.field = format!("{}.{name}", value.place.field);
            }
            entry.table()
        };
        list.into_iter().filter_map(named).collect()
    }
}
