//! The outputs that are watched in gusts.

use flexible_aircraft::variables::{
    OutputSlot, Slot, Type, Unit, Variability, Variable, VariableTable, probably_meant,
};

/// A name that no output has.
#[derive(Debug, PartialEq, thiserror::Error)]
#[error("--output-names {found}: there is no such output; {instead}")]
pub struct NoSuchOutput {
    found: String,
    instead: String,
}

/// An output.
#[derive(Clone, Debug, PartialEq)]
pub struct Watched {
    pub name: String,
    /// As people read it; empty where there is none.
    pub unit: String,
    pub slot: OutputSlot,
}

impl Watched {
    /// All outputs whose names are these or begin with them; the usual ones where none is named.
    ///
    /// # Errors
    /// At the first name that no output has or begins with.
    pub fn choose(names: &[String], variables: &VariableTable) -> Result<Vec<Self>, NoSuchOutput> {
        let all: Vec<Watched> = variables.iter().filter_map(|(_, variable)| Watched::of(variable)).collect();
        if names.is_empty() {
            return Ok(all.into_iter().filter(|output| is_usual(&output.name)).collect());
        }
        let mut chosen: Vec<Watched> = Vec::new();
        for name in names {
            let found: Vec<&Watched> = all.iter().filter(|output| is_part(name, &output.name)).collect();
            if found.is_empty() {
                let known = all.iter().map(|output| output.name.as_str());
                let instead = match probably_meant(name, known) {
                    Some(meant) => format!("did you mean `{meant}`?"),
                    None => "the page in the FMU lists them all".to_owned(),
                };
                return Err(NoSuchOutput { found: name.clone(), instead });
            }
            for output in found {
                if !chosen.contains(output) {
                    chosen.push(output.clone());
                }
            }
        }
        Ok(chosen)
    }

    /// A real output that changes in flight.
    fn of(variable: &Variable) -> Option<Self> {
        let Slot::Output(slot) = variable.slot else { return None };
        let is_watched = variable.kind == Type::Real && variable.variability == Variability::Continuous;
        let unit = variable.unit.filter(|unit| *unit != Unit::One).map_or("", Unit::name);
        is_watched.then(|| Watched { name: variable.name.clone(), unit: unit.to_owned(), slot })
    }
}

/// Whether a name is another or its first parts.
fn is_part(part: &str, name: &str) -> bool {
    name.strip_prefix(part).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

fn is_usual(name: &str) -> bool {
    let is_up = name.starts_with("deflection.") && name.ends_with(".up");
    is_up || ["loads", "load_factor"].iter().any(|part| is_part(part, name))
}
