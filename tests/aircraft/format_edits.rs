//! Changes of aircraft files as data, so that others than Rust can make them too.

use serde_json::{Value, json};

/// One value of a file that is another.
#[derive(Clone)]
pub struct Edit {
    /// Names of fields and places in lists, from the top of the file.
    pub at: Vec<Value>,
    /// `None`: the field is left out.
    pub value: Option<Value>,
}

/// The content of a file after some changes.
pub fn edited(text: &str, edits: &[Edit]) -> Value {
    let mut content = json(toml::Value::Table(text.parse().unwrap()));
    for Edit { at, value } in edits {
        let (last, path) = at.split_last().unwrap();
        let holder = path.iter().fold(&mut content, |holder, step| match step {
            Value::String(name) => &mut holder[name],
            step => &mut holder[step.as_u64().unwrap() as usize],
        });
        match (holder, value) {
            (Value::Object(table), Some(value)) => {
                drop(table.insert(last.as_str().unwrap().into(), value.clone()));
            }
            (Value::Object(table), None) => drop(table.remove(last.as_str().unwrap())),
            (Value::Array(list), Some(value)) => list[last.as_u64().unwrap() as usize] = value.clone(),
            (other, _) => panic!("nothing can be changed in {other}"),
        }
    }
    content
}

fn json(value: toml::Value) -> Value {
    match value {
        toml::Value::String(text) => json!(text),
        toml::Value::Integer(number) => json!(number),
        toml::Value::Float(number) => json!(number),
        toml::Value::Boolean(flag) => json!(flag),
        toml::Value::Array(list) => list.into_iter().map(json).collect(),
        toml::Value::Table(table) => table.into_iter().map(|(name, value)| (name, json(value))).collect(),
        toml::Value::Datetime(date) => panic!("aircraft files have no date such as {date}"),
    }
}

/// A file with some content: one line for each field of its top, its tables in braces.
pub fn text_of(content: &Value) -> String {
    let fields = content.as_object().unwrap().iter();
    fields.map(|(name, value)| format!("{name} = {}\n", inline(value))).collect()
}

fn inline(value: &Value) -> String {
    match value {
        Value::Object(table) => {
            let fields = table.iter().map(|(name, value)| format!("{name} = {}", inline(value)));
            format!("{{ {} }}", fields.collect::<Vec<_>>().join(", "))
        }
        Value::Array(list) => format!("[{}]", list.iter().map(inline).collect::<Vec<_>>().join(", ")),
        // A number, a flag, a text: as JSON writes them.
        other => other.to_string(),
    }
}
