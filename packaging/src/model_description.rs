//! What the calling side needs of an FMU's `modelDescription.xml`: its guid and where the values are.

use std::collections::BTreeMap;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

/// The part of a model description that is needed to load an FMU and to address its variables by name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ModelDescription {
    pub guid: String,
    /// Name of the shared library, without extension.
    pub model_identifier: String,
    /// Value references by variable name.
    pub value_references: BTreeMap<String, u32>,
}

impl ModelDescription {
    /// Reads the text of a `modelDescription.xml`; the error says what is wrong with it.
    pub fn parse(xml: &str) -> Result<Self, String> {
        let mut reader = Reader::from_str(xml);
        let mut guid = None;
        let mut model_identifier = None;
        let mut value_references = BTreeMap::new();
        loop {
            match reader.read_event().map_err(|error| error.to_string())? {
                Event::Start(element) | Event::Empty(element) => match element.local_name().as_ref() {
                    "fmiModelDescription" => guid = Some(attribute(&element, "guid")?),
                    "CoSimulation" => model_identifier = Some(attribute(&element, "modelIdentifier")?),
                    "ScalarVariable" => {
                        let name = attribute(&element, "name")?;
                        let reference = attribute(&element, "valueReference")?;
                        let reference =
                            reference.parse().map_err(|_| format!("{name}: valueReference `{reference}`"))?;
                        value_references.insert(name, reference);
                    }
                    _ => {}
                },
                Event::Eof => break,
                _ => {}
            }
        }
        Ok(ModelDescription {
            guid: guid.ok_or("no element fmiModelDescription")?,
            model_identifier: model_identifier.ok_or("no element CoSimulation")?,
            value_references,
        })
    }
}

fn attribute(element: &BytesStart<'_>, name: &str) -> Result<String, String> {
    let attribute = element.try_get_attribute(name).map_err(|error| error.to_string())?;
    let element_name = element.local_name();
    let element_name = element_name.as_ref();
    let attribute = attribute.ok_or_else(|| format!("<{element_name}> has no attribute {name}"))?;
    Ok(attribute.unescape_value().map_err(|error| error.to_string())?.into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn guid_library_and_value_references_are_found() {
        let xml = r#"<?xml version="1.0"?><fmiModelDescription fmiVersion="2.0" guid="{a&amp;b}">
            <CoSimulation modelIdentifier="Plane"/><ModelVariables>
            <ScalarVariable name="modal.q[1]" valueReference="7"><Real/></ScalarVariable>
            </ModelVariables></fmiModelDescription>"#;
        let description = ModelDescription::parse(xml).unwrap();
        assert_eq!(description.guid, "{a&b}");
        assert_eq!(description.model_identifier, "Plane");
        assert_eq!(description.value_references["modal.q[1]"], 7);
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
