//! A TOML value as messages name it and as a number, for every file that the program reads.

use toml::de::DeValue;

/// What stands there, as the beginning of a message: `found the text "a"`.
pub fn toml_found(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => format!("found the text \"{}\"", text.escape_debug()),
        DeValue::Integer(number) => format!("found {number}"),
        DeValue::Float(number) => format!("found {number}"),
        DeValue::Boolean(flag) => format!("found {flag}"),
        DeValue::Datetime(date) => format!("found the date {date}"),
        DeValue::Array(list) => format!("found a list of {}", list.len()),
        DeValue::Table(_) => "found a table".to_owned(),
    }
}

/// A whole number or any other, infinite ones and those that are none among them.
pub fn toml_number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Integer(number) => {
            i64::from_str_radix(number.as_str(), number.radix()).ok().map(|number| number as f64)
        }
        DeValue::Float(number) => number.as_str().parse().ok(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use toml::de::DeTable;

    use super::*;

    #[test]
    fn every_kind_of_value_is_named_and_numbers_are_read() {
        for (text, found, number) in [
            ("\"a\\n\"", "found the text \"a\\n\"", None),
            ("0x10", "found 0x10", Some(16.0)),
            ("-3", "found -3", Some(-3.0)),
            ("1.5e3", "found 1.5e3", Some(1500.0)),
            ("inf", "found inf", Some(f64::INFINITY)),
            ("true", "found true", None),
            ("1979-05-27", "found the date 1979-05-27", None),
            ("[1, 2]", "found a list of 2", None),
            ("{ a = 1 }", "found a table", None),
        ] {
            let text = format!("key = {text}");
            let table = DeTable::parse(&text).unwrap();
            let value = table.get_ref().get("key").unwrap().get_ref();
            assert_eq!((toml_found(value).as_str(), toml_number(value)), (found, number));
        }
    }
}
