//! Fields of the format as JSON Schema.

use flexible_aircraft::aircraft::format::{
    Absent, Allowed, Field, Kind, LEAST_COMPONENT, Range, Table, Word,
};
use serde_json::{Value, json};

use super::tables::table;

/// On one line, of characters that XML can hold.
const TEXT: &str = r"^[^\u0000-\u001f\u007f-\u009f\ufffe\uffff]*$";

/// With something besides spaces and full stops.
const PHRASE: &str = r"^[^\u0000-\u001f\u007f-\u009f\ufffe\uffff]*[^\u0000-\u001f\u007f-\u009f\ufffe\uffff\s.][^\u0000-\u001f\u007f-\u009f\ufffe\uffff]*$";

/// Part of a variable's name.
const NAME: &str = "^[A-Za-z_][A-Za-z0-9_]*$";

/// What a field of a table may hold, what it is for people, and what holds where it is left out.
pub fn field(table: &Table, field: &Field) -> Value {
    let mut schema = kind(&field.kind, None);
    let description = match description_of_words(field.kind.words()) {
        Some(words) => format!("{}\n\n{words}", sentence(field.sentence)),
        None => sentence(field.sentence),
    };
    let default = match (table.alternatives(field), field.absent) {
        (Some(names), _) => format!("{names} needed"),
        (None, Absent::Needed) => "Needed".to_owned(),
        (None, absent) => format!("Default: {}", absent.in_words()),
    };
    schema["title"] = field.name.into();
    schema["description"] =
        format!("{description}\n\nAllowed: {}. {default}.", field.allowed_in_words()).into();
    if let Some(default) = default_value(field.absent) {
        schema["default"] = default;
    }
    schema
}

/// A sentence that begins and ends like one; a symbol at its beginning, as c_mα, stays as it is.
pub fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    if text.chars().nth(1) == Some('_') {
        return format!("{text}.");
    }
    let first = letters.next().map(char::to_uppercase).into_iter().flatten();
    format!("{}.", first.chain(letters).collect::<String>())
}

/// A number in its range.
pub fn number(allowed: &Allowed) -> Value {
    match allowed.range {
        Range::All => json!({ "type": "number" }),
        Range::Closed(least, most) => json!({ "type": "number", "minimum": least, "maximum": most }),
        Range::Above(low, most) => json!({ "type": "number", "exclusiveMinimum": low, "maximum": most }),
        Range::Between(low, high) => {
            json!({ "type": "number", "exclusiveMinimum": low, "exclusiveMaximum": high })
        }
    }
}

/// What a kind of field may hold; in a form of a law, its numbers are those of the law.
fn kind(kind: &Kind, law: Option<&Allowed>) -> Value {
    let of_law = || law.map_or_else(|| json!({ "type": "number" }), number);
    match kind {
        Kind::Number(allowed) => number(allowed),
        Kind::Whole(least, most) => whole(*least, *most),
        Kind::WholeOrMore(least, most) => one_or_more(&whole(*least, *most)),
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Text => json!({ "type": "string", "pattern": TEXT }),
        Kind::Phrase => json!({ "type": "string", "pattern": PHRASE }),
        Kind::Name => json!({ "type": "string", "pattern": NAME }),
        Kind::OneOf(words) => one_of(words),
        Kind::WordOrWords(words, others) => {
            let mut several = list(&one_of(others), 1);
            several["uniqueItems"] = json!(true);
            json!({ "oneOf": [one_of(words), several] })
        }
        Kind::NumberOrMore(allowed) => one_or_more(&number(allowed)),
        Kind::Numbers(allowed) => list(&number(allowed), 1),
        Kind::Vector(allowed) => three(&number(allowed)),
        Kind::Direction => direction(),
        Kind::Attitude(turn, pitch) => json!({
            "type": "array", "items": [number(turn), number(pitch), number(turn)], "minItems": 3, "maxItems": 3,
        }),
        Kind::Corners(allowed) => list(&three(&number(allowed)), 2),
        Kind::Matrix(allowed) => six(&six(&number(allowed))),
        Kind::Law(allowed, forms) => law_of(allowed, forms),
        Kind::Laws(allowed, forms) => three(&law_of(allowed, forms)),
        Kind::LawNumber => of_law(),
        Kind::LawNumbers => list(&of_law(), 1),
        Kind::Table(of) => table(of),
        Kind::Tables(of, least) => list(&table(of), *least),
        Kind::WordOrTable(word, of) => json!({ "oneOf": [one_of(&[**word]), table(of)] }),
        // What this program does not know of is not told.
        _ => json!({}),
    }
}

fn whole(least: usize, most: usize) -> Value {
    json!({ "type": "integer", "minimum": least, "maximum": most })
}

fn list(entry: &Value, least: usize) -> Value {
    json!({ "type": "array", "items": entry, "minItems": least })
}

fn three(entry: &Value) -> Value {
    json!({ "type": "array", "items": entry, "minItems": 3, "maxItems": 3 })
}

fn six(entry: &Value) -> Value {
    json!({ "type": "array", "items": entry, "minItems": 6, "maxItems": 6 })
}

fn one_or_more(entry: &Value) -> Value {
    json!({ "oneOf": [entry, list(entry, 1)] })
}

fn direction() -> Value {
    let mut schema = three(&json!({ "type": "number" }));
    schema["contains"] =
        json!({ "anyOf": [{ "minimum": LEAST_COMPONENT }, { "maximum": -LEAST_COMPONENT }] });
    schema
}

/// Words, each with its meaning for editors that show it.
fn one_of(words: &[Word]) -> Value {
    let [names, meanings] = [|word: &Word| word.word, |word: &Word| word.sentence]
        .map(|part| words.iter().map(part).collect::<Vec<&str>>());
    json!({ "type": "string", "enum": names, "x-taplo": { "docs": { "enumValues": meanings } } })
}

fn description_of_words(words: &[Word]) -> Option<String> {
    let lines = words.iter().map(|word| format!("* {}: {}", word.in_quotes(), word.sentence));
    (!words.is_empty()).then(|| lines.collect::<Vec<_>>().join("\n"))
}

/// A number, or one of the forms, told apart by their first fields.
fn law_of(allowed: &Allowed, forms: &[&Table]) -> Value {
    let form = |form: &&Table| {
        let mut schema = table(form);
        for field in form.fields {
            let described = schema["properties"][field.name].take();
            let mut held = kind(&field.kind, Some(allowed));
            held["title"] = described["title"].clone();
            held["description"] = described["description"].clone();
            schema["properties"][field.name] = held;
        }
        schema
    };
    let all: Vec<Value> = std::iter::once(number(allowed)).chain(forms.iter().map(form)).collect();
    json!({ "oneOf": all })
}

fn default_value(absent: Absent) -> Option<Value> {
    match absent {
        Absent::Number(number) => Some(number.into()),
        Absent::Whole(number) => Some(number.into()),
        Absent::Flag(flag) => Some(flag.into()),
        Absent::Word(word) => Some(word.into()),
        Absent::Zeros => Some(json!([0, 0, 0])),
        _ => None,
    }
}
