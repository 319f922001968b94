//! Values that fields may hold, and numbers at the ends of what they may.

use flexible_aircraft::aircraft::format::{FILE, Kind, Range, Table};
use serde_json::{Value, json};

/// Numbers just beyond and just within the ends of a range, and whether they are in it.
pub fn at_the_ends(range: Range) -> Vec<(f64, bool)> {
    let hair = |end: f64| if end == 0.0 { 1e-9 } else { 1e-9 * end.abs() };
    let (low, below) = match range {
        Range::All => return Vec::new(),
        Range::Closed(least, _) => (least, least - hair(least)),
        Range::Above(low, _) | Range::Between(low, _) => (low + hair(low), low),
    };
    let (high, above) = match range {
        Range::All => return Vec::new(),
        Range::Closed(_, most) | Range::Above(_, most) => (most, most + hair(most)),
        Range::Between(_, high) => (high - hair(high), high),
    };
    vec![(below, false), (low, true), (high, true), (above, false)]
}

/// A number of a range, and a usual one of all.
pub fn middle(range: Range) -> f64 {
    match range {
        Range::All => 1.0,
        Range::Closed(low, high) | Range::Above(low, high) | Range::Between(low, high) => 0.5 * (low + high),
    }
}

/// A form of a law whose numbers are all this one.
pub fn form_with(form: &Table, number: f64) -> Value {
    let fields = form.fields.iter().map(|field| {
        let value = match field.kind {
            Kind::LawNumbers => json!([number]),
            Kind::LawNumber => json!(number),
            kind => sample(kind),
        };
        (field.name.to_owned(), value)
    });
    Value::Object(fields.collect())
}

/// All forms of a law: those of a stiffness.
pub fn all_forms() -> &'static [&'static Table] {
    let component = FILE.fields.iter().find(|field| field.name == "component").unwrap().kind.table().unwrap();
    component.fields.iter().find(|field| field.name == "EA_N").unwrap().kind.forms()
}

/// Something that a field may hold.
pub fn sample(kind: Kind) -> Value {
    match kind {
        Kind::Numbers(_) => json!([1]),
        Kind::Vector(_) => json!([1, 1, 1]),
        Kind::OneOf(words) | Kind::WordOrWords(words, _) => json!(words[0].word),
        Kind::Tables(..) => json!([{ "input": "stick", "gain": 1 }]),
        _ => json!(1),
    }
}
