//! Reads an FMU's `modelDescription.xml`, of FMI 2.0 or 3.0: what the calling side and a system of several FMUs need of it.

use flexible_aircraft::fmi::{Interface, Kind, Version};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

mod attributes;
#[cfg(test)]
mod tests;
mod unit;
mod variable;

use attributes::{optional, required, text};
pub(crate) use unit::BaseUnit;
use variable::{DeclaredType, Dimension};
pub(crate) use variable::{Variable, VariableType};

/// The part of a model description that is needed to load an FMU, to address its variables, to list and to connect
/// them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ModelDescription {
    /// What importers take it as; of an FMU for both, co-simulation.
    pub interface: Interface,
    /// Identifies the content: guid or instantiation token.
    pub token: String,
    /// Of flexible-aircraft; empty where the file says nothing.
    pub version: String,
    /// What is modelled; empty where the file says nothing.
    pub description: String,
    /// Name of the shared library, without extension.
    pub model_identifier: String,
    /// By name.
    units: Vec<(String, Option<BaseUnit>)>,
    /// In the order of the file.
    pub variables: Vec<Variable>,
    /// How many states there are.
    pub states: usize,
}

/// What has been read so far.
#[derive(Default)]
struct Found {
    root: Option<Root>,
    /// Their model identifiers.
    co_simulation: Option<String>,
    model_exchange: Option<String>,
    units: Vec<(String, Option<BaseUnit>)>,
    types: Vec<DeclaredType>,
    variables: Vec<Variable>,
    /// Of FMI 3.0: the last one that is no alias.
    named: usize,
    /// The last list of unknowns that began, as FMI 2.0 has them.
    list: String,
    states: usize,
}

/// What the root says.
struct Root {
    fmi: Version,
    token: String,
    version: String,
    description: String,
}

impl Root {
    fn of(element: &BytesStart<'_>) -> Result<Self, String> {
        let standard = optional(element, "fmiVersion")?.unwrap_or_else(|| "2.0".into());
        let fmi = match standard.as_str() {
            "2.0" => Version::V2,
            // 3.0.1 and so on are corrections.
            number if number == "3.0" || number.starts_with("3.0.") => Version::V3,
            _ => return Err(format!("found FMI version {standard}, allowed are 2.0 and 3.0")),
        };
        let token = match fmi {
            Version::V2 => "guid",
            Version::V3 => "instantiationToken",
        };
        Ok(Root {
            fmi,
            token: required(element, token)?,
            version: text(element, "version")?,
            description: text(element, "description")?,
        })
    }
}

impl Found {
    /// Takes what the next element says.
    fn take(&mut self, element: &BytesStart<'_>) -> Result<(), String> {
        match element.local_name().as_ref() {
            "fmiModelDescription" => self.root = Some(Root::of(element)?),
            "CoSimulation" => self.co_simulation = Some(required(element, "modelIdentifier")?),
            "ModelExchange" => self.model_exchange = Some(required(element, "modelIdentifier")?),
            "Unit" => self.units.push((required(element, "name")?, None)),
            "BaseUnit" => {
                if let Some((_, base)) = self.units.last_mut() {
                    *base = Some(BaseUnit::of(element)?);
                }
            }
            "Item" => {
                let item = (required(element, "name")?, required(element, "value")?);
                self.types.last_mut().ok_or("an Item outside of a type")?.items.push(item);
            }
            name => match self.root.as_ref().map(|root| root.fmi) {
                Some(Version::V3) => self.take_of_third(name, element)?,
                Some(Version::V2) | None => self.take_of_second(name, element)?,
            },
        }
        Ok(())
    }

    /// A type, a variable or an unknown as FMI 2.0 writes them.
    fn take_of_second(&mut self, name: &str, element: &BytesStart<'_>) -> Result<(), String> {
        match name {
            "SimpleType" => self.types.push(DeclaredType::named(element)?),
            "ScalarVariable" => self.variables.push(Variable::named(element)?),
            "Outputs" | "Derivatives" | "InitialUnknowns" => self.list = name.to_owned(),
            "Unknown" if self.list == "Derivatives" => self.states += 1,
            name => {
                if let Some(kind) = VariableType::of_second(name) {
                    self.take_values(kind, element)?;
                }
            }
        }
        Ok(())
    }

    /// An element that says which values are allowed: before the first variable it defines a type.
    fn take_values(&mut self, kind: VariableType, element: &BytesStart<'_>) -> Result<(), String> {
        if let Some(variable) = self.variables.last_mut() {
            return variable.complete(kind, element, &self.types);
        }
        self.types.last_mut().map_or(Ok(()), |declared| declared.complete(element))
    }

    /// The same as FMI 3.0 writes them: elements are called after the type.
    fn take_of_third(&mut self, name: &str, element: &BytesStart<'_>) -> Result<(), String> {
        if name == "ContinuousStateDerivative" {
            self.states += 1;
        } else if let Some(kind) = VariableType::of_third(name) {
            let mut variable = Variable::named(element)?;
            variable.complete(kind, element, &self.types)?;
            self.named = self.variables.len();
            self.variables.push(variable);
        } else if name.strip_suffix("Type").and_then(VariableType::of_third).is_some() {
            let mut declared = DeclaredType::named(element)?;
            declared.complete(element)?;
            self.types.push(declared);
        } else if let Some(variable) = self.variables.get_mut(self.named) {
            match name {
                "Dimension" => variable.dimensions.push(Dimension::of(element)?),
                "Alias" => {
                    let alias = variable.alias(element)?;
                    self.variables.push(alias);
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn finish(self) -> Result<ModelDescription, String> {
        let root = self.root.ok_or("no element fmiModelDescription")?;
        let co_simulation = self.co_simulation.map(|identifier| (Kind::CoSimulation, identifier));
        let model_exchange = self.model_exchange.map(|identifier| (Kind::ModelExchange, identifier));
        let (kind, model_identifier) =
            co_simulation.or(model_exchange).ok_or("no element CoSimulation and none ModelExchange")?;
        Ok(ModelDescription {
            interface: Interface { version: root.fmi, kind },
            token: root.token,
            version: root.version,
            description: root.description,
            model_identifier,
            units: self.units,
            variables: self.variables,
            states: self.states,
        })
    }
}

impl ModelDescription {
    /// Reads the text of a `modelDescription.xml`; the error says what is wrong with it.
    pub fn parse(xml: &str) -> Result<Self, String> {
        let mut reader = Reader::from_str(xml);
        let mut found = Found::default();
        loop {
            match reader.read_event().map_err(|error| error.to_string())? {
                // What is in there is for others.
                Event::Start(element)
                    if ["Annotations", "VendorAnnotations"].contains(&element.local_name().as_ref()) =>
                {
                    reader.read_to_end(element.name()).map_err(|error| error.to_string())?;
                }
                Event::Start(element) | Event::Empty(element) => found.take(&element)?,
                Event::Eof => return found.finish(),
                _ => {}
            }
        }
    }

    /// What a unit is made of; none where that is not said.
    pub fn base_unit(&self, unit: &str) -> Option<BaseUnit> {
        self.units.iter().find(|(name, _)| name == unit).and_then(|(_, base)| *base)
    }

    /// The variable of this name.
    pub fn variable(&self, name: &str) -> Option<&Variable> {
        self.variables.iter().find(|variable| variable.name == name)
    }

    /// The size of an array, for people: numbers, or the names of the variables that have them. None of a scalar.
    pub fn dimensions(&self, variable: &Variable) -> Option<String> {
        let size = |dimension: &Dimension| match dimension {
            Dimension::Size(size) => size.to_string(),
            Dimension::By(reference) => {
                let mut all = self.variables.iter();
                let by = all.find(|other| other.value_reference == *reference);
                by.map_or_else(|| "?".to_owned(), |by| by.name.clone())
            }
        };
        let sizes: Vec<String> = variable.dimensions.iter().map(size).collect();
        (!sizes.is_empty()).then(|| sizes.join(" × "))
    }
}
