//! What the inputs do over time: a table of comma-separated values, a communication step from each row to the next.

use flexible_aircraft::simulation::Inputs;
use flexible_aircraft::variables::{InputSlot, Slot, VariableTable};

/// Inputs over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    columns: Vec<Column>,
    rows: Vec<Row>,
}

/// What the numbers of a column are.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Column {
    Value(InputSlot),
    Rate(InputSlot),
}

#[derive(Clone, Debug, PartialEq)]
struct Row {
    /// s.
    time: f64,
    /// One per column.
    numbers: Vec<f64>,
}

/// What is wrong with a table, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("line {line}, {column}: found {found}, allowed is {allowed}")]
pub struct Mistake {
    line: usize,
    column: String,
    found: String,
    allowed: String,
}

impl Schedule {
    /// Reads a table: a line of names, then a line of numbers for each step and one for the end of the last.
    ///
    /// # Errors
    /// At the first thing that is not as it must be.
    pub fn parse(text: &str, variables: &VariableTable) -> Result<Self, Mistake> {
        let text = text.trim_start_matches('\u{feff}');
        let mut lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
        let (line, header) = lines.next().unwrap_or((1, ""));
        let names: Vec<&str> = header.split(',').map(str::trim).collect();
        let columns = columns(&names, line, variables)?;
        let mut rows: Vec<Row> = Vec::new();
        for (line, text) in lines {
            let mut row = row(text, line, &names)?;
            let time = row.remove(0);
            if let Some(last) = rows.last().filter(|last| time <= last.time) {
                let allowed = format!("a time after that of the row before, {}", last.time);
                return Err(Mistake { line, column: "time".to_owned(), found: time.to_string(), allowed });
            }
            rows.push(Row { time, numbers: row });
        }
        if rows.is_empty() {
            let [column, found, allowed] =
                ["time", "no numbers", "a line of numbers for each step"].map(String::from);
            return Err(Mistake { line, column, found, allowed });
        }
        Ok(Schedule { columns, rows })
    }

    /// The first communication point, s.
    pub fn start(&self) -> f64 {
        self.rows[0].time
    }

    /// Communication points, s, ascending; there is at least one.
    pub fn times(&self) -> impl Iterator<Item = f64> {
        self.rows.iter().map(|row| row.time)
    }

    /// Writes the inputs that act from the communication point with this index on, and their rates.
    pub fn write(&self, point: usize, inputs: &mut Inputs, rates: &mut Inputs) {
        for (column, number) in self.columns.iter().zip(&self.rows[point].numbers) {
            match column {
                Column::Value(slot) => *slot.of(inputs) = *number,
                Column::Rate(slot) => *slot.of(rates) = *number,
            }
        }
    }
}

/// What the columns after the first, the time, are.
fn columns(names: &[&str], line: usize, variables: &VariableTable) -> Result<Vec<Column>, Mistake> {
    let mistake = |column: usize, allowed: String| {
        let found = format!("`{}`", names[column]);
        Mistake { line, column: format!("column {}", column + 1), found, allowed }
    };
    if names[0] != "time" {
        return Err(mistake(0, "`time`".to_owned()));
    }
    let inputs: Vec<(&str, InputSlot)> = variables
        .iter()
        .filter_map(|(_, variable)| match variable.slot {
            Slot::Input(slot) => Some((variable.name.as_str(), slot)),
            _ => None,
        })
        .collect();
    let mut columns = Vec::new();
    for (index, name) in names.iter().enumerate().skip(1) {
        let rate_of = name.strip_prefix("der(").and_then(|rest| rest.strip_suffix(')'));
        let Some((_, slot)) = inputs.iter().find(|(input, _)| *input == rate_of.unwrap_or(name)) else {
            let inputs: Vec<&str> = inputs.iter().map(|(input, _)| *input).collect();
            return Err(mistake(index, format!("an input, {}, or der(…) of one", inputs.join(", "))));
        };
        if names[..index].contains(name) {
            return Err(mistake(index, "each name once".to_owned()));
        }
        if let Some(input) = rate_of.filter(|input| !names.contains(input)) {
            return Err(mistake(index, format!("a derivative beside the column of its input, `{input}`")));
        }
        columns.push(if rate_of.is_some() { Column::Rate(*slot) } else { Column::Value(*slot) });
    }
    Ok(columns)
}

/// The finite numbers of a line, one per name.
fn row(text: &str, line: usize, names: &[&str]) -> Result<Vec<f64>, Mistake> {
    let cells: Vec<&str> = text.split(',').map(str::trim).collect();
    if cells.len() != names.len() {
        let found = format!("{} columns", cells.len());
        let allowed = format!("{}, as in the line of names", names.len());
        return Err(Mistake { line, column: "all of it".to_owned(), found, allowed });
    }
    let numbers = cells.iter().zip(names).map(|(cell, name)| {
        let number: Option<f64> = cell.parse().ok().filter(|number: &f64| number.is_finite());
        number.ok_or_else(|| Mistake {
            line,
            column: (*name).to_owned(),
            found: format!("`{cell}`"),
            allowed: "a finite number".to_owned(),
        })
    });
    numbers.collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use flexible_aircraft::aircraft::Aircraft;
    use flexible_aircraft::structure::ReducedModel;

    use super::*;

    fn variables() -> VariableTable {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/small-aircraft.toml");
        let aircraft = Aircraft::read(&path).unwrap();
        VariableTable::new(&ReducedModel::new(&aircraft, 0).unwrap())
    }

    #[test]
    fn values_and_rates_reach_the_inputs_that_the_columns_name() {
        let text = "\u{feff}time, der(elevator) ,wind_down,elevator\r\n0,1,2,3\r\n\r\n0.5,4,5,6\r\n";
        let schedule = Schedule::parse(text, &variables()).unwrap();
        assert_eq!(schedule.times().collect::<Vec<_>>(), [0.0, 0.5]);
        let (mut inputs, mut rates) = (Inputs::zero(0), Inputs::zero(0));
        schedule.write(1, &mut inputs, &mut rates);
        assert_eq!((inputs.elevator, inputs.wind.z, rates.elevator), (6.0, 5.0, 4.0));
    }

    #[test]
    fn a_mistake_is_told_with_its_place_and_what_is_allowed() {
        let variables = variables();
        let cases = [
            ("", "line 1, column 1: found ``, allowed is `time`"),
            ("elevator\n", "line 1, column 1: found `elevator`, allowed is `time`"),
            ("time,flap\n", "line 1, column 2: found `flap`, allowed is an input, elevator, aileron, "),
            ("time,elevator,elevator\n", "line 1, column 3: found `elevator`, allowed is each name once"),
            ("time,der(rudder)\n", "allowed is a derivative beside the column of its input, `rudder`"),
            ("time\n", "line 1, time: found no numbers, allowed is a line of numbers for each step"),
            (
                "time,rudder\n0,1\n1\n",
                "line 3, all of it: found 1 columns, allowed is 2, as in the line of names",
            ),
            ("time,rudder\n0,left\n", "line 2, rudder: found `left`, allowed is a finite number"),
            ("time\ninf\n", "line 2, time: found `inf`, allowed is a finite number"),
            ("time\n1\n\n1\n", "line 4, time: found 1, allowed is a time after that of the row before, 1"),
        ];
        for (text, expected) in cases {
            let mistake = Schedule::parse(text, &variables).unwrap_err().to_string();
            assert!(mistake.contains(expected), "{text:?}: {mistake}");
        }
    }
}
