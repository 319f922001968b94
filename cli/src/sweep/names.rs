//! What a sweep file may set or vary: parameters of the FMU, and factors by names of the aircraft file.

use flexible_aircraft::aircraft::Factor;
use flexible_aircraft::variables::{Slot, Type, Unit, Variable, VariableTable, nearest, probably_meant};

use super::document::{Mistakes, Place};

/// A name that was found.
pub enum Named<'n> {
    Parameter(&'n Variable),
    /// On a stiffness or a mass.
    Factor,
}

/// All names that there are.
pub struct Names<'n> {
    pub variables: &'n VariableTable,
    pub factors: &'n [Factor],
}

impl<'n> Names<'n> {
    /// What a name stands for; complains where that cannot be set.
    pub fn find(&self, name: &str, place: &Place, mistakes: &Mistakes) -> Option<Named<'n>> {
        if self.factors.iter().any(|factor| factor.name == name) {
            return Some(Named::Factor);
        }
        let variable = self.variables.named(name);
        let (found, allowed) = match variable.map(|variable| (variable, variable.slot)) {
            Some((variable, Slot::Parameter(_))) => return Some(Named::Parameter(variable)),
            Some((_, Slot::Input(_))) => (
                format!("found the input `{name}`"),
                "allowed is a parameter; inputs are given by `input` under [run], where kind = \"simulate\""
                    .to_owned(),
            ),
            Some((_, Slot::Output(_))) => (
                format!("found the output `{name}`"),
                "allowed is a parameter; outputs are computed".to_owned(),
            ),
            None => (format!("there is no `{name}` that could be set"), self.instead_of(name)),
        };
        mistakes.add(place, found, allowed);
        None
    }

    fn instead_of(&self, name: &str) -> String {
        let known = || {
            let parameters = self.variables.iter().map(|(_, variable)| variable);
            let parameters = parameters.filter(|variable| matches!(variable.slot, Slot::Parameter(_)));
            let parameters = parameters.map(|variable| variable.name.as_str());
            parameters.chain(self.factors.iter().map(|factor| factor.name.as_str()))
        };
        match probably_meant(name, known()) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => format!(
                "allowed are parameters of the FMU and `component.<name>.stiffness` and `mass.<name>` of the aircraft file: nearest are {}",
                nearest(name, known())
            ),
        }
    }
}

/// As tables write it: 1 of what has none.
pub fn unit(variable: &Variable) -> String {
    match variable.kind {
        Type::Real => variable.unit.map_or("", Unit::name).to_owned(),
        Type::Integer | Type::Boolean | Type::Enumeration(_) => Unit::One.name().to_owned(),
    }
}
