//! The line of names at the head of a table of inputs: what its columns are.

use flexible_aircraft::variables::probably_meant;
use flexible_aircraft::variables::{InputSlot, Slot, Unit, VariableTable};

use super::schedule::Mistake;
use flexible_aircraft_packaging::assignment::did_you_mean;

/// What the numbers of a column are, other than times.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    pub name: String,
    pub meaning: Meaning,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meaning {
    /// Of an input; a surface's is an angle.
    Value { slot: InputSlot, is_surface: bool },
    /// Of change of an input, per second.
    Rate(InputSlot),
}

/// What is between the columns, if it is not commas.
pub fn other_separator(line: &str) -> Option<&'static str> {
    let separators =
        [(';', "semicolons"), ('\t', "tabs"), ('|', "vertical bars"), (' ', "spaces"), (':', "colons")];
    let found = separators.iter().find(|(separator, _)| line.trim().contains(*separator));
    found.filter(|_| !line.contains(',')).map(|(_, name)| *name)
}

/// What the names say behind the first, which is that of the time.
pub fn columns(names: &[&str], line: usize, variables: &VariableTable) -> Result<Vec<Column>, Mistake> {
    let text = names.join(",");
    if text.starts_with('#') {
        let (found, allowed) = ("`#`", "a line of names, `time` and inputs: there are no comments");
        return Err(Mistake::new(line, "the line of names", found, allowed));
    }
    let separator = other_separator(&text).filter(|found| *found != "spaces" || !has_unit(&text));
    if let Some(separator) = separator {
        let (found, allowed) =
            (format!("{separator} between the names"), "commas between columns, and points in numbers");
        return Err(Mistake::new(line, "the line of names", found, allowed));
    }
    let mut columns = Vec::new();
    for (index, name) in names.iter().enumerate() {
        let mistake = |allowed: String| {
            Mistake::new(line, &format!("column {}", index + 1), format!("`{name}`"), allowed)
        };
        if names[..index].contains(name) {
            return Err(mistake("each name once".to_owned()));
        }
        match index {
            0 if *name == "time" => {}
            0 if is_time(name) => {
                return Err(mistake(format!("`time`, in small letters, in s{}", bare(name))));
            }
            0 => return Err(mistake(format!("`time`, in s{}", bare(name)))),
            _ => {
                let meaning = meaning(name, names, variables).map_err(mistake)?;
                columns.push(Column { name: (*name).to_owned(), meaning });
            }
        }
    }
    Ok(columns)
}

/// Whether a name is another way to write the time's.
fn is_time(name: &str) -> bool {
    without_unit(name) != "time"
        && ["time", "t"].iter().any(|time| time.eq_ignore_ascii_case(without_unit(name)))
}

/// What the numbers under a name are, or what is allowed instead.
fn meaning(name: &str, names: &[&str], variables: &VariableTable) -> Result<Meaning, String> {
    let rate_of = name.strip_prefix("der(").and_then(|rest| rest.strip_suffix(')'));
    let wanted = rate_of.unwrap_or(name);
    let (slot, is_surface) = input(wanted, variables).map_err(|allowed| match variables.named(wanted) {
        Some(_) => allowed,
        None => format!("{allowed}, and der(…) of each"),
    })?;
    match rate_of {
        None => Ok(Meaning::Value { slot, is_surface }),
        Some(_) if names.contains(&wanted) => Ok(Meaning::Rate(slot)),
        Some(_) => Err(format!("a derivative beside the column of its input, `{wanted}`")),
    }
}

/// The place of the input of a name, and whether it is the angle of a surface; or what is allowed instead.
pub fn input(name: &str, variables: &VariableTable) -> Result<(InputSlot, bool), String> {
    match variables.named(name).map(|variable| (variable.slot, variable.unit)) {
        Some((Slot::Input(slot), unit)) => Ok((slot, unit == Some(Unit::Radian))),
        Some((Slot::Parameter(_), _)) => Err(format!("an input; it is a parameter: --set {name}=VALUE")),
        Some((Slot::Output(_), _)) => Err("an input; it is an output, which is computed".to_owned()),
        None => {
            let inputs = variables.iter().filter(|(_, variable)| matches!(variable.slot, Slot::Input(_)));
            let inputs: Vec<&str> = inputs.map(|(_, variable)| variable.name.as_str()).collect();
            let meant = probably_meant(without_unit(name), inputs.iter().copied()).map(str::to_owned);
            let (meant, bare) = (did_you_mean(&meant), bare(name));
            Err(format!("an input{meant}{bare}; there are {}", inputs.join(", ")))
        }
    }
}

/// Whether a name carries a unit in brackets, as in `time (s)`.
fn has_unit(name: &str) -> bool {
    without_unit(name) != name
}

/// A name without a unit in brackets, or quotes.
fn without_unit(name: &str) -> &str {
    let brackets = if name.starts_with("der(") { None } else { name.find(['(', '[']) };
    name[..brackets.unwrap_or(name.len())].trim_matches([' ', '_', '\''])
}

/// What to do about units or quotes in a name, to be put behind a message.
fn bare(name: &str) -> &'static str {
    if has_unit(name) {
        "; names stand alone, without units or quotes: they are in SI units and rad"
    } else {
        ""
    }
}
