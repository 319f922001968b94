//! A TOML document as values that know their place and complain by themselves, all of them.

use std::cell::RefCell;
use std::ops::Range;

use flexible_aircraft::aircraft::{toml_found, toml_number};
use flexible_aircraft::variables::probably_meant;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::marked::{Mistake, Rejected};
use crate::numbers::Plain;

/// Where something stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    pub span: Range<usize>,
    pub field: String,
}

/// What is wrong with a file, as far as it has been read.
#[derive(Debug, Default)]
pub struct Mistakes(RefCell<Vec<Mistake>>);

impl Mistakes {
    pub fn add(&self, place: &Place, found: impl Into<String>, allowed: impl Into<String>) {
        let Place { span, field } = place.clone();
        self.0.borrow_mut().push(Mistake { span, field, found: found.into(), allowed: allowed.into() });
    }

    /// What other commands say of an option or an assignment: `--input x=y: found …, allowed is …`.
    pub fn add_said(&self, place: &Place, said: &str) {
        let said = said.find("found ").map_or(said, |begin| &said[begin..]);
        match said.split_once(", allowed ") {
            Some((found, allowed)) => self.add(place, found, format!("allowed {allowed}")),
            None => self.add(place, said, ""),
        }
    }

    /// What was read, unless there are mistakes.
    pub fn conclude<T>(self, read: Option<T>, file_name: &str, text: &str) -> Result<T, Rejected> {
        let mut mistakes = self.0.into_inner();
        mistakes.sort_by_key(|mistake| mistake.span.start);
        match read {
            Some(read) if mistakes.is_empty() => Ok(read),
            _ => Err(Rejected { file_name: file_name.to_owned(), text: text.to_owned(), mistakes }),
        }
    }
}

/// A value.
pub struct Item<'r, 't> {
    value: &'r DeValue<'t>,
    pub place: Place,
    mistakes: &'r Mistakes,
}

impl<'r, 't> Item<'r, 't> {
    fn new(value: &'r Spanned<DeValue<'t>>, field: String, mistakes: &'r Mistakes) -> Self {
        Item { value: value.get_ref(), place: Place { span: value.span(), field }, mistakes }
    }

    /// Complains; `allowed` is what may stand here.
    pub fn wrong<T>(&self, allowed: &str) -> Option<T> {
        self.mistakes.add(&self.place, toml_found(self.value), format!("allowed is {allowed}"));
        None
    }

    fn as_number(&self) -> Option<f64> {
        toml_number(self.value).filter(|number| number.is_finite())
    }

    /// A finite number.
    pub fn number(&self) -> Option<f64> {
        self.as_number().or_else(|| self.wrong("a finite number"))
    }

    /// A finite number of seconds greater than 0.
    pub fn seconds(&self) -> Option<f64> {
        let seconds = self.as_number().filter(|seconds| *seconds > 0.0);
        seconds.or_else(|| self.wrong("a finite number of seconds, greater than 0"))
    }

    /// A whole number within a range.
    pub fn count(&self, range: std::ops::RangeInclusive<u64>) -> Option<u64> {
        let count = match self.value {
            DeValue::Integer(number) => u64::from_str_radix(number.as_str(), number.radix()).ok(),
            _ => None,
        };
        let allowed = || format!("a whole number from {} to {}", range.start(), range.end());
        count.filter(|count| range.contains(count)).or_else(|| self.wrong(&allowed()))
    }

    pub fn flag(&self) -> Option<bool> {
        match self.value {
            DeValue::Boolean(flag) => Some(*flag),
            _ => self.wrong("true or false"),
        }
    }

    pub fn as_text(&self) -> Option<&'r str> {
        match self.value {
            DeValue::String(text) => Some(text.as_ref()),
            _ => None,
        }
    }

    pub fn text(&self) -> Option<&'r str> {
        self.as_text().or_else(|| self.wrong("a text"))
    }

    /// One of a few words.
    pub fn one_of<T: Copy>(&self, words: &[(&str, T)]) -> Option<T> {
        let chosen = words.iter().find(|(word, _)| self.as_text() == Some(word)).map(|(_, meaning)| *meaning);
        let list = || words.iter().map(|(word, _)| format!("\"{word}\"")).collect::<Vec<_>>().join(", ");
        chosen.or_else(|| self.wrong(&list()))
    }

    /// What a parameter is set to, as `--set` would have it: a number, a truth value or the name of an item.
    pub fn setting(&self) -> Option<String> {
        match (self.value, self.as_number()) {
            (DeValue::String(text), _) => Some(text.to_string()),
            (DeValue::Boolean(flag), _) => Some(flag.to_string()),
            (_, Some(number)) => Some(Plain(number).to_string()),
            _ => self.wrong("a finite number, a text, true or false"),
        }
    }

    pub fn is_table(&self) -> bool {
        matches!(self.value, DeValue::Table(_))
    }

    /// One value, or those of a list.
    pub fn one_or_more(&self) -> Vec<Item<'r, 't>> {
        match self.value {
            DeValue::Array(_) => self.list("a list").unwrap_or_default(),
            _ => vec![Item { value: self.value, place: self.place.clone(), mistakes: self.mistakes }],
        }
    }

    /// The values of a list that is not empty.
    pub fn list(&self, allowed: &str) -> Option<Vec<Item<'r, 't>>> {
        match self.value {
            DeValue::Array(list) if !list.is_empty() => {
                let entry =
                    |(i, value)| Item::new(value, format!("{}[{}]", self.place.field, i + 1), self.mistakes);
                Some(list.iter().enumerate().map(entry).collect())
            }
            _ => self.wrong(allowed),
        }
    }

    /// Two finite numbers.
    pub fn pair(&self, allowed: &str) -> Option<[f64; 2]> {
        let list = self.list(allowed)?;
        match list.as_slice() {
            [one, other] => {
                let (one, other) = (one.number(), other.number());
                Some([one?, other?])
            }
            _ => self.wrong(allowed),
        }
    }

    /// A table of some keys.
    pub fn section(&self, keys: &'static [&'static str]) -> Option<Section<'r, 't>> {
        match self.value {
            DeValue::Table(table) => Some(Section::new(table, self.place.clone(), keys, self.mistakes)),
            _ => self.wrong("a table"),
        }
    }

    /// The entries of a table, whatever their keys, at the places of their keys.
    pub fn entries(&self) -> Option<Vec<(String, Item<'r, 't>)>> {
        let DeValue::Table(table) = self.value else { return self.wrong("a table") };
        let entry = |(key, value): (&'r Spanned<_>, &'r Spanned<DeValue<'t>>)| {
            let name = ToString::to_string(key.get_ref());
            let item = Item::new(value, format!("{}.{name}", self.place.field), self.mistakes);
            (name, item)
        };
        Some(table.iter().map(entry).collect())
    }
}

/// A table of known keys.
pub struct Section<'r, 't> {
    table: &'r DeTable<'t>,
    pub place: Place,
    mistakes: &'r Mistakes,
}

impl<'r, 't> Section<'r, 't> {
    /// Takes a table and complains about every key that is not among these.
    pub fn new(
        table: &'r DeTable<'t>,
        place: Place,
        keys: &'static [&'static str],
        mistakes: &'r Mistakes,
    ) -> Self {
        let section = Section { table, place, mistakes };
        for key in table.keys().filter(|key| !keys.contains(&key.get_ref().as_ref())) {
            let name = key.get_ref();
            let meant = match probably_meant(name, keys.iter().copied()) {
                Some(meant) => format!("did you mean `{meant}`? "),
                None => String::new(),
            };
            let place = Place { span: key.span(), field: section.field(name) };
            let allowed = format!("{meant}allowed here: {}", keys.join(", "));
            mistakes.add(&place, format!("found the unknown key \"{name}\""), allowed);
        }
        section
    }

    fn field(&self, key: &str) -> String {
        if self.place.field.is_empty() { key.to_owned() } else { format!("{}.{key}", self.place.field) }
    }

    pub fn optional(&self, key: &str) -> Option<Item<'r, 't>> {
        self.table.get(key).map(|value| Item::new(value, self.field(key), self.mistakes))
    }

    pub fn required(&self, key: &str, what: &str) -> Option<Item<'r, 't>> {
        let item = self.optional(key);
        if item.is_none() {
            let place = Place { span: self.place.span.clone(), field: self.field(key) };
            self.mistakes.add(&place, format!("the key \"{key}\" is missing"), format!("allowed is {what}"));
        }
        item
    }

    /// The tables of a list of tables; none where there is no such key.
    pub fn sections(&self, key: &str, keys: &'static [&'static str]) -> Vec<Section<'r, 't>> {
        let Some(item) = self.optional(key) else { return Vec::new() };
        let list = item.list(&format!("a list of tables, [[{key}]]")).unwrap_or_default();
        list.iter().filter_map(|entry| entry.section(keys)).collect()
    }
}
