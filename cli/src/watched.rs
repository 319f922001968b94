//! The outputs that a command watches, chosen by their names or by the first parts of them.

use flexible_aircraft::variables::{
    OutputSlot, Slot, Type, Unit, Variability, Variable, VariableTable, probably_meant,
};

/// A name that no output has.
#[derive(Debug, PartialEq, thiserror::Error)]
#[error("{option} {found}: there is no such output; {instead}")]
pub struct NoSuchOutput {
    option: &'static str,
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
    /// All outputs that change in flight.
    pub fn all(variables: &VariableTable) -> impl Iterator<Item = Self> {
        variables.iter().filter_map(|(_, variable)| Watched::of(variable))
    }

    /// Those whose names an option gives, whole or their first parts, each once.
    ///
    /// # Errors
    /// At the first name that no output has or begins with.
    pub fn choose(
        option: &'static str,
        names: &[String],
        variables: &VariableTable,
    ) -> Result<Vec<Self>, NoSuchOutput> {
        let all: Vec<Watched> = Watched::all(variables).collect();
        let mut chosen: Vec<Watched> = Vec::new();
        for name in names {
            let found: Vec<&Watched> = all.iter().filter(|output| is_part(name, &output.name)).collect();
            if found.is_empty() {
                let known = all.iter().map(|output| output.name.as_str());
                let instead = match probably_meant(name, known) {
                    Some(meant) => format!("did you mean `{meant}`?"),
                    None => "the page in the FMU lists them all".to_owned(),
                };
                return Err(NoSuchOutput { option, found: name.clone(), instead });
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
pub fn is_part(part: &str, name: &str) -> bool {
    name.strip_prefix(part).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}
