//! What the reader asks of the format: whether a number is one that its quantity can take, which fields a table knows, what
//! holds where one is left out.

use super::error::{Place, Problem, Report};
use super::format::{Absent, Allowed, Field, Kind, Table};

impl Allowed {
    /// Complains about a number that is not finite or not allowed; true when it is in order.
    pub(super) fn check(&self, number: f64, place: &Place, report: &Report) -> bool {
        let problem = match number {
            _ if !number.is_finite() => Problem::NotFinite,
            _ if !self.range.contains(number) => Problem::OutOfRange,
            _ => return true,
        };
        report.add(problem, place, format!("found {}", in_digits(number)), self.text());
        false
    }
}

/// As people write it: with an exponent where there would be many digits otherwise.
fn in_digits(number: f64) -> String {
    let magnitude = number.abs();
    let is_plain = magnitude == 0.0 || (1e-6..1e10).contains(&magnitude) || !number.is_finite();
    if is_plain { format!("{number}") } else { format!("{number:e}") }
}

impl Table {
    /// The names of its fields, as messages list them.
    pub(super) fn names(&self) -> String {
        let names: Vec<&str> = self.fields.iter().map(|field| field.name).collect();
        names.join(", ")
    }

    /// Whether it has a field of this name, or had one.
    pub(super) fn knows(&self, name: &str) -> bool {
        self.fields.iter().chain(self.former).any(|field| field.name == name)
    }

    /// The field of which a name has all but the unit: `temperature_offset_K`.
    pub(super) fn with_unit(&self, name: &str) -> Option<&'static str> {
        let is_unit = |rest: &str| rest.starts_with('_') && rest.len() > 1;
        let names = self.fields.iter().map(|field| field.name);
        let meant = names.filter(|known| !name.is_empty() && known.strip_prefix(name).is_some_and(is_unit));
        meant.min_by_key(|known| known.len())
    }

    /// Whether it has this field, not just one of the same name, or had it.
    pub(super) fn has(&self, field: &Field) -> bool {
        self.fields.iter().chain(self.former).any(|known| std::ptr::eq(*known, field))
    }
}

impl Kind {
    /// The least and the greatest of its whole numbers.
    pub(super) fn whole(&self) -> (usize, usize) {
        match *self {
            Kind::Whole(least, most) | Kind::WholeOrMore(least, most) => (least, most),
            _ => (0, usize::MAX),
        }
    }
}

impl Absent {
    /// The number that holds; 0 where there is none.
    pub(super) fn number(&self) -> f64 {
        if let Absent::Number(number) = *self { number } else { 0.0 }
    }

    /// The whole number that holds; 0 where there is none.
    pub(super) fn whole(&self) -> usize {
        if let Absent::Whole(number) = *self { number } else { 0 }
    }
}
