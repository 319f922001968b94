//! Tables of the format as objects of JSON Schema.

use flexible_aircraft::aircraft::format::{Absent, FILE, Field, Kind, Rule, Table};
use serde_json::{Map, Value, json};

use super::fields::{field, number, sentence};

/// The draft that editors of TOML take.
const DRAFT: &str = "http://json-schema.org/draft-07/schema#";

/// What the schema is called, wherever it lies.
const NAME: &str = "urn:flexible-aircraft:aircraft-file:1";

/// The whole format.
pub fn file() -> Value {
    let mut schema = table(&FILE);
    schema["$schema"] = DRAFT.into();
    schema["$id"] = NAME.into();
    schema["title"] = "Aircraft file of flexible-aircraft".into();
    schema
}

/// An object of its fields and no others.
pub fn table(table: &Table) -> Value {
    let properties: Map<String, Value> =
        table.fields.iter().map(|part| (part.name.to_owned(), field(table, part))).collect();
    let needed = table.fields.iter().filter(|field| field.absent == Absent::Needed);
    let needed: Vec<&str> = needed.map(|field| field.name).collect();
    let mut schema = json!({
        "type": "object",
        "description": sentence(table.sentence),
        "properties": properties,
        "required": needed,
        "additionalProperties": false,
    });
    let rules: Vec<Value> = table.rules.iter().filter_map(rule).collect();
    if !rules.is_empty() {
        schema["allOf"] = rules.into();
    }
    schema
}

/// What holds between fields.
fn rule(rule: &Rule) -> Option<Value> {
    let rule = match rule {
        Rule::ExactlyOne(fields) => {
            json!({ "oneOf": fields.iter().map(|field| is_there(field)).collect::<Vec<_>>() })
        }
        Rule::AtMostOne(fields) => {
            let names: Vec<&str> = fields.iter().map(|field| field.name).collect();
            let pairs = names.iter().enumerate().flat_map(|(place, one)| {
                names[..place].iter().map(move |other| json!({ "required": [other, one] }))
            });
            json!({ "not": { "anyOf": pairs.collect::<Vec<_>>() } })
        }
        Rule::Needs(field, needed) => json!({ "if": is_there(field), "then": is_there(needed) }),
        Rule::OnlyWhere(field, other, word) => json!({ "if": is_there(field), "then": is_word(other, word) }),
        Rule::Narrower(field, allowed, other, word) => json!({
            "if": is_word(other, word),
            "then": { "properties": { field.name: number(allowed) } },
        }),
        _ => return None,
    };
    Some(rule)
}

/// That a field is there, a list of tables with any.
fn is_there(field: &Field) -> Value {
    match field.kind {
        Kind::Tables(..) => {
            json!({ "required": [field.name], "properties": { field.name: { "minItems": 1 } } })
        }
        _ => json!({ "required": [field.name] }),
    }
}

fn is_word(field: &Field, word: &str) -> Value {
    json!({ "required": [field.name], "properties": { field.name: { "const": word } } })
}
