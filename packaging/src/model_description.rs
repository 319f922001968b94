//! Reads an FMU's `modelDescription.xml`: what the calling side and a system of several FMUs need of it.

use std::fmt;

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

/// The part of a model description that is needed to load an FMU, to address its variables, to list and to connect
/// them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ModelDescription {
    /// Identifies the content.
    pub guid: String,
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
}

/// How a unit is made of SI base units; without, it is known by its name only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BaseUnit {
    /// Of kg, m, s, A, K, mol, cd, rad.
    exponents: [i32; 8],
    factor: f64,
    offset: f64,
}

/// The element that holds a variable's value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum VariableType {
    #[default]
    Real,
    Integer,
    Boolean,
    String,
    Enumeration,
}

/// A scalar variable; texts are empty where the file says nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Variable {
    pub name: String,
    pub value_reference: u32,
    pub causality: String,
    pub description: String,
    pub kind: VariableType,
    pub unit: String,
    pub start: String,
    /// Smallest value.
    pub min: String,
    /// Largest value.
    pub max: String,
    /// Of an enumeration: names and values, in the order of the file.
    pub items: Vec<(String, String)>,
}

/// A type that variables are declared with; texts are empty where the file says nothing.
#[derive(Clone, Debug, Default)]
struct DeclaredType {
    name: String,
    unit: String,
    min: String,
    max: String,
    items: Vec<(String, String)>,
}

/// What has been read so far.
#[derive(Default)]
struct Found {
    guid: Option<String>,
    version: String,
    description: String,
    model_identifier: Option<String>,
    units: Vec<(String, Option<BaseUnit>)>,
    types: Vec<DeclaredType>,
    variables: Vec<Variable>,
}

impl Found {
    /// Takes what the next element says.
    fn take(&mut self, element: &BytesStart<'_>) -> Result<(), String> {
        match element.local_name().as_ref() {
            "fmiModelDescription" => self.take_root(element)?,
            "CoSimulation" => self.model_identifier = Some(required(element, "modelIdentifier")?),
            "Unit" => self.units.push((required(element, "name")?, None)),
            "BaseUnit" => {
                if let Some((_, base)) = self.units.last_mut() {
                    *base = Some(base_unit(element)?);
                }
            }
            "SimpleType" => {
                self.types.push(DeclaredType { name: required(element, "name")?, ..DeclaredType::default() });
            }
            "Item" => {
                let item = (required(element, "name")?, required(element, "value")?);
                self.types.last_mut().ok_or("an Item outside of a type")?.items.push(item);
            }
            "ScalarVariable" => self.variables.push(scalar_variable(element)?),
            name => {
                if let Some(kind) = VariableType::of_element(name) {
                    self.take_values(kind, element)?;
                }
            }
        }
        Ok(())
    }

    fn take_root(&mut self, element: &BytesStart<'_>) -> Result<(), String> {
        let standard = optional(element, "fmiVersion")?.unwrap_or_else(|| "2.0".into());
        if standard != "2.0" {
            return Err(format!("found FMI version {standard}, allowed is 2.0"));
        }
        self.guid = Some(required(element, "guid")?);
        self.version = optional(element, "version")?.unwrap_or_default();
        self.description = optional(element, "description")?.unwrap_or_default();
        Ok(())
    }

    /// An element that says which values are allowed: before the first variable it defines a type.
    fn take_values(&mut self, kind: VariableType, element: &BytesStart<'_>) -> Result<(), String> {
        if let Some(variable) = self.variables.last_mut() {
            return complete(variable, kind, element, &self.types);
        }
        if let Some(declared) = self.types.last_mut() {
            declared.unit = optional(element, "unit")?.unwrap_or_default();
            declared.min = optional(element, "min")?.unwrap_or_default();
            declared.max = optional(element, "max")?.unwrap_or_default();
        }
        Ok(())
    }
}

impl ModelDescription {
    /// Reads the text of a `modelDescription.xml`; the error says what is wrong with it.
    pub fn parse(xml: &str) -> Result<Self, String> {
        let mut reader = Reader::from_str(xml);
        let mut found = Found::default();
        loop {
            match reader.read_event().map_err(|error| error.to_string())? {
                Event::Start(element) | Event::Empty(element) => found.take(&element)?,
                Event::Eof => break,
                _ => {}
            }
        }
        Ok(ModelDescription {
            guid: found.guid.ok_or("no element fmiModelDescription")?,
            version: found.version,
            description: found.description,
            model_identifier: found.model_identifier.ok_or("no element CoSimulation")?,
            units: found.units,
            variables: found.variables,
        })
    }

    /// What a unit is made of; none where that is not said.
    pub fn base_unit(&self, unit: &str) -> Option<BaseUnit> {
        self.units.iter().find(|(name, _)| name == unit).and_then(|(_, base)| *base)
    }

    /// The variable of this name.
    pub fn variable(&self, name: &str) -> Option<&Variable> {
        self.variables.iter().find(|variable| variable.name == name)
    }
}

impl VariableType {
    fn of_element(name: &str) -> Option<Self> {
        Some(match name {
            "Real" => VariableType::Real,
            "Integer" => VariableType::Integer,
            "Boolean" => VariableType::Boolean,
            "String" => VariableType::String,
            "Enumeration" => VariableType::Enumeration,
            _ => return None,
        })
    }
}

impl fmt::Display for VariableType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

/// Reads a variable's value element; unit and limits may come from its declared type.
fn complete(
    variable: &mut Variable,
    kind: VariableType,
    element: &BytesStart<'_>,
    types: &[DeclaredType],
) -> Result<(), String> {
    let declared = optional(element, "declaredType")?;
    let declared = declared.and_then(|name| types.iter().find(|known| known.name == name)).cloned();
    let DeclaredType { unit, min, max, items, .. } = declared.unwrap_or_default();
    variable.kind = kind;
    variable.unit = optional(element, "unit")?.unwrap_or(unit);
    variable.min = optional(element, "min")?.unwrap_or(min);
    variable.max = optional(element, "max")?.unwrap_or(max);
    variable.items = items;
    variable.start = optional(element, "start")?.unwrap_or_default();
    Ok(())
}

fn base_unit(element: &BytesStart<'_>) -> Result<BaseUnit, String> {
    fn number<T: std::str::FromStr>(element: &BytesStart<'_>, name: &str, default: T) -> Result<T, String> {
        let Some(text) = optional(element, name)? else { return Ok(default) };
        text.trim().parse().map_err(|_| format!("<BaseUnit {name}=\"{text}\">: not a number"))
    }
    let mut exponents = [0; 8];
    for (exponent, name) in exponents.iter_mut().zip(["kg", "m", "s", "A", "K", "mol", "cd", "rad"]) {
        *exponent = number(element, name, 0)?;
    }
    Ok(BaseUnit {
        exponents,
        factor: number(element, "factor", 1.0)?,
        offset: number(element, "offset", 0.0)?,
    })
}

fn scalar_variable(element: &BytesStart<'_>) -> Result<Variable, String> {
    let name = required(element, "name")?;
    let reference = required(element, "valueReference")?;
    Ok(Variable {
        value_reference: reference.parse().map_err(|_| format!("{name}: valueReference `{reference}`"))?,
        causality: optional(element, "causality")?.unwrap_or_default(),
        description: optional(element, "description")?.unwrap_or_default(),
        name,
        ..Variable::default()
    })
}

fn required(element: &BytesStart<'_>, name: &str) -> Result<String, String> {
    let value = optional(element, name)?;
    value.ok_or_else(|| format!("<{}> has no attribute {name}", element.local_name().as_ref()))
}

fn optional(element: &BytesStart<'_>, name: &str) -> Result<Option<String>, String> {
    let Some(attribute) = element.try_get_attribute(name).map_err(|error| error.to_string())? else {
        return Ok(None);
    };
    let value = attribute.normalized_value(XmlVersion::Explicit1_0).map_err(|error| error.to_string())?;
    Ok(Some(value.into_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn guid_library_and_variables_are_found() {
        let xml = r#"<?xml version="1.0"?><fmiModelDescription fmiVersion="2.0" guid="{a&amp;b}" version="1.2">
            <CoSimulation modelIdentifier="Plane"/><ModelVariables>
            <ScalarVariable name="modal.q[1]" valueReference="7" causality="output" description="&lt;"><Real/>
            </ScalarVariable><ScalarVariable name="airspeed" valueReference="8" causality="parameter">
            <Real unit="m/s" start="127"/></ScalarVariable></ModelVariables></fmiModelDescription>"#;
        let description = ModelDescription::parse(xml).unwrap();
        assert_eq!(description.guid, "{a&b}");
        assert_eq!((description.version.as_str(), description.description.as_str()), ("1.2", ""));
        assert_eq!(description.model_identifier, "Plane");
        let mode = description.variable("modal.q[1]").unwrap();
        assert_eq!((mode.value_reference, mode.description.as_str()), (7, "<"));
        let airspeed = description.variable("airspeed").unwrap();
        assert_eq!((airspeed.unit.as_str(), airspeed.start.as_str()), ("m/s", "127"));
        assert_eq!(description.variable("altitude"), None);
    }

    #[test]
    fn units_are_known_by_what_they_are_made_of_and_inherited_from_types() {
        let xml = r#"<fmiModelDescription fmiVersion="2.0" guid="g"><CoSimulation modelIdentifier="M"/>
            <UnitDefinitions><Unit name="deg"><BaseUnit rad="1" factor="0.0174532925199433"/></Unit>
            <Unit name="rad"><BaseUnit rad="1"/></Unit><Unit name="Radiant"><BaseUnit rad="1"/></Unit>
            <Unit name="odd"/></UnitDefinitions>
            <TypeDefinitions><SimpleType name="Angle"><Real unit="rad"/></SimpleType></TypeDefinitions>
            <ModelVariables><ScalarVariable name="a" valueReference="1"><Real declaredType="Angle"/></ScalarVariable>
            <ScalarVariable name="b" valueReference="2"><Boolean/></ScalarVariable></ModelVariables>
            </fmiModelDescription>"#;
        let description = ModelDescription::parse(xml).unwrap();
        assert_eq!(description.variable("a").unwrap().unit, "rad");
        assert_eq!(description.variable("b").unwrap().kind, VariableType::Boolean);
        assert_eq!(description.variable("b").unwrap().items, []);
        assert_eq!(description.base_unit("rad"), description.base_unit("Radiant"));
        assert_ne!(description.base_unit("rad"), description.base_unit("deg"));
        assert_eq!((description.base_unit("odd"), description.base_unit("none")), (None, None));
    }

    #[test]
    fn limits_and_items_are_those_of_the_variable_or_its_type() {
        let xml = r#"<fmiModelDescription fmiVersion="2.0" guid="g"><CoSimulation modelIdentifier="M"/>
            <TypeDefinitions><SimpleType name="Speed"><Real unit="m/s" min="1" max="9"/></SimpleType>
            <SimpleType name="Level"><Enumeration><Item name="low" value="1"/><Item name="high" value="3"/>
            </Enumeration></SimpleType></TypeDefinitions>
            <ModelVariables><ScalarVariable name="a" valueReference="1"><Real declaredType="Speed" max="7"/></ScalarVariable>
            <ScalarVariable name="b" valueReference="2"><Enumeration declaredType="Level"/></ScalarVariable>
            </ModelVariables></fmiModelDescription>"#;
        let description = ModelDescription::parse(xml).unwrap();
        let speed = description.variable("a").unwrap();
        assert_eq!((speed.unit.as_str(), speed.min.as_str(), speed.max.as_str()), ("m/s", "1", "7"));
        let level = description.variable("b").unwrap();
        let items: Vec<(&str, &str)> = level.items.iter().map(|(name, value)| (&**name, &**value)).collect();
        assert_eq!(items, [("low", "1"), ("high", "3")]);
    }

    #[test]
    fn a_variable_without_value_reference_is_refused() {
        let error = ModelDescription::parse(r#"<ScalarVariable name="x"/>"#).unwrap_err();
        assert_eq!(error, "<ScalarVariable> has no attribute valueReference");
    }

    #[test]
    fn another_version_of_the_standard_is_refused() {
        let error = ModelDescription::parse(r#"<fmiModelDescription fmiVersion="3.0"/>"#).unwrap_err();
        assert_eq!(error, "found FMI version 3.0, allowed is 2.0");
    }

    #[test]
    fn a_model_exchange_fmu_is_refused() {
        let error = ModelDescription::parse(r#"<fmiModelDescription guid="g"/>"#).unwrap_err();
        assert_eq!(error, "no element CoSimulation");
    }
}
