//! libcosim's own description of a system, `OspSystemStructure.xml`; the FMUs are beside it.

use std::io;

use quick_xml::events::BytesText;

use super::component::Component;
use super::connection::Connection;
use super::whole::System;
use super::xml::{Xml, document, element, leaf};

const NAMESPACE: (&str, &str) = ("xmlns", "http://opensimulationplatform.com/MSMI/OSPSystemStructure");

/// The bytes of `OspSystemStructure.xml`.
pub(super) fn structure(system: &System) -> Vec<u8> {
    document(|xml| {
        element(xml, "OspSystemStructure", &[NAMESPACE, ("version", "0.1")], |xml| content(xml, system))
    })
}

fn content(xml: &mut Xml, system: &System) -> io::Result<()> {
    text(xml, "StartTime", "0")?;
    text(xml, "BaseStepSize", &system.experiment.step.to_string())?;
    text(xml, "Algorithm", "fixedStep")?;
    element(xml, "Simulators", &[], |xml| {
        system.components.iter().try_for_each(|component| simulator(xml, component, system))
    })?;
    if system.connections.is_empty() {
        return Ok(());
    }
    element(xml, "Connections", &[], |xml| system.connections.iter().try_for_each(|one| connection(xml, one)))
}

fn text(xml: &mut Xml, name: &str, text: &str) -> io::Result<()> {
    xml.create_element(name).write_text_content(BytesText::new(text)).map(|_| ())
}

fn simulator(xml: &mut Xml, component: &Component, system: &System) -> io::Result<()> {
    let source = format!("{}.fmu", component.name);
    let attributes = [("name", component.name.as_str()), ("source", &source)];
    let settings = system.settings_of(component);
    if settings.is_empty() {
        return leaf(xml, "Simulator", &attributes);
    }
    element(xml, "Simulator", &attributes, |xml| {
        element(xml, "InitialValues", &[], |xml| {
            settings.iter().try_for_each(|setting| {
                element(xml, "InitialValue", &[("variable", &setting.at.variable)], |xml| {
                    leaf(xml, &setting.kind.to_string(), &[("value", &setting.value)])
                })
            })
        })
    })
}

fn connection(xml: &mut Xml, Connection { output, input, .. }: &Connection) -> io::Result<()> {
    element(xml, "VariableConnection", &[], |xml| {
        [output, input].into_iter().try_for_each(|end| {
            leaf(xml, "Variable", &[("simulator", &end.component), ("name", &end.variable)])
        })
    })
}
