//! Reads an FMU's `modelDescription.xml`: what the calling side and the documentation page need of it.

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

/// The part of a model description that is needed to load an FMU, to address its variables and to list them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ModelDescription {
    /// Identifies the content.
    pub guid: String,
    /// Of flexible-aircraft; empty where the file says nothing.
    pub version: String,
    /// What is modelled; empty where the file says nothing.
    pub description: String,
    /// Name of the shared library, without extension.
    pub model_identifier: String,
    /// In the order of the file.
    pub variables: Vec<Variable>,
}

/// A scalar variable; texts are empty where the file says nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Variable {
    pub name: String,
    pub value_reference: u32,
    pub causality: String,
    pub description: String,
    pub unit: String,
    pub start: String,
}

impl ModelDescription {
    /// Reads the text of a `modelDescription.xml`; the error says what is wrong with it.
    pub fn parse(xml: &str) -> Result<Self, String> {
        let mut reader = Reader::from_str(xml);
        let (mut guid, mut version, mut description) = (None, String::new(), String::new());
        let mut model_identifier = None;
        let mut variables: Vec<Variable> = Vec::new();
        loop {
            match reader.read_event().map_err(|error| error.to_string())? {
                Event::Start(element) | Event::Empty(element) => match element.local_name().as_ref() {
                    "fmiModelDescription" => {
                        guid = Some(required(&element, "guid")?);
                        version = optional(&element, "version")?.unwrap_or_default();
                        description = optional(&element, "description")?.unwrap_or_default();
                    }
                    "CoSimulation" => model_identifier = Some(required(&element, "modelIdentifier")?),
                    "ScalarVariable" => variables.push(scalar_variable(&element)?),
                    "Real" | "Integer" | "Enumeration" => {
                        // Outside of a variable these elements define types.
                        if let Some(variable) = variables.last_mut() {
                            variable.unit = optional(&element, "unit")?.unwrap_or_default();
                            variable.start = optional(&element, "start")?.unwrap_or_default();
                        }
                    }
                    _ => {}
                },
                Event::Eof => break,
                _ => {}
            }
        }
        Ok(ModelDescription {
            guid: guid.ok_or("no element fmiModelDescription")?,
            version,
            description,
            model_identifier: model_identifier.ok_or("no element CoSimulation")?,
            variables,
        })
    }

    /// The variable of this name.
    pub fn variable(&self, name: &str) -> Option<&Variable> {
        self.variables.iter().find(|variable| variable.name == name)
    }
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
    fn a_variable_without_value_reference_is_refused() {
        let error = ModelDescription::parse(r#"<ScalarVariable name="x"/>"#).unwrap_err();
        assert_eq!(error, "<ScalarVariable> has no attribute valueReference");
    }

    #[test]
    fn a_model_exchange_fmu_is_refused() {
        let error = ModelDescription::parse(r#"<fmiModelDescription guid="g"/>"#).unwrap_err();
        assert_eq!(error, "no element CoSimulation");
    }
}
