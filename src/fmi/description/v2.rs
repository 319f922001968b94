//! The model description of FMI 2.0.

use std::io;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

use crate::flight::Settings;
use crate::fmi::log::Category;
use crate::structure::ReducedModel;
use crate::variables::{EnumerationType, OutputSlot, Slot, Type, Variable, VariableTable};

use super::shared::{
    MODEL_IDENTIFIER, Xml, default_experiment, description, items, log_categories, unit_definitions,
    value_attributes, variability,
};

/// The model description with any guid; the real one is a hash of this with none.
pub fn with_guid(model: &ReducedModel, starts: &Settings, guid: &str) -> String {
    let table = VariableTable::starting(model, starts);
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    // PROOF: memory takes every byte, and the writer only passes UTF-8 on.
    document(&mut xml, (model, starts), &table, guid).expect("writing to memory succeeds");
    let mut text = String::from_utf8(xml.into_inner()).expect("strings are UTF-8");
    text.push('\n');
    text
}

fn document(
    xml: &mut Xml,
    (model, starts): (&ReducedModel, &Settings),
    table: &VariableTable,
    guid: &str,
) -> io::Result<()> {
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    xml.create_element("fmiModelDescription")
        .with_attributes([
            ("fmiVersion", "2.0"),
            ("modelName", MODEL_IDENTIFIER),
            ("guid", guid),
            ("description", &description(model)),
            ("version", env!("CARGO_PKG_VERSION")),
            ("license", env!("CARGO_PKG_LICENSE")),
            ("generationTool", concat!("flexible-aircraft ", env!("CARGO_PKG_VERSION"))),
            ("variableNamingConvention", "structured"),
        ])
        .write_inner_content(|xml| {
            co_simulation(xml)?;
            unit_definitions(xml)?;
            type_definitions(xml)?;
            log_categories(xml, log_contents)?;
            default_experiment(xml, starts)?;
            xml.create_element("ModelVariables").write_inner_content(|xml| {
                table.iter().try_for_each(|(reference, variable)| scalar_variable(xml, reference, variable))
            })?;
            model_structure(xml, table)
        })?;
    Ok(())
}

/// What falls into a category of the log.
fn log_contents(category: Category) -> &'static str {
    match category {
        Category::Events => "Instantiation, initialisation, trim, reset and termination",
        Category::StatusWarning => "Reasons of fmi2Warning and fmi2Discard",
        Category::StatusError => "Reasons of fmi2Error",
        Category::StatusFatal => "Reasons of fmi2Fatal",
        Category::All => "All messages",
    }
}

/// Only what is true is said; what is left out is false.
fn co_simulation(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("CoSimulation")
        .with_attributes([
            ("modelIdentifier", MODEL_IDENTIFIER),
            ("canHandleVariableCommunicationStepSize", "true"),
            ("canInterpolateInputs", "true"),
            ("maxOutputDerivativeOrder", "0"),
            ("canNotUseMemoryManagementFunctions", "true"),
            ("canGetAndSetFMUstate", "true"),
            ("canSerializeFMUstate", "true"),
            ("providesDirectionalDerivative", "true"),
        ])
        .write_empty()?;
    Ok(())
}

fn type_definitions(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("TypeDefinitions").write_inner_content(|xml| {
        for enumeration in EnumerationType::ALL {
            xml.create_element("SimpleType")
                .with_attributes([("name", enumeration.name()), ("description", enumeration.description())])
                .write_inner_content(|xml| {
                    xml.create_element("Enumeration").write_inner_content(|xml| items(xml, enumeration))?;
                    Ok(())
                })?;
        }
        Ok(())
    })?;
    Ok(())
}

fn scalar_variable(xml: &mut Xml, reference: u32, variable: &Variable) -> io::Result<()> {
    let (causality, initial) = match variable.slot {
        Slot::Input(_) => ("input", None),
        Slot::Parameter(_) => ("parameter", Some("exact")),
        Slot::Output(_) => ("output", Some("calculated")),
    };
    let reference = reference.to_string();
    xml.create_element("ScalarVariable")
        .with_attributes([
            ("name", variable.name.as_str()),
            ("valueReference", &reference),
            ("description", &variable.description),
            ("causality", causality),
            ("variability", variability(variable)),
        ])
        .with_attributes(initial.map(|initial| ("initial", initial)))
        .write_inner_content(|xml| typed_element(xml, variable))?;
    Ok(())
}

fn typed_element(xml: &mut Xml, variable: &Variable) -> io::Result<()> {
    let name = match variable.kind {
        Type::Real => "Real",
        Type::Integer => "Integer",
        Type::Boolean => "Boolean",
        Type::Enumeration(_) => "Enumeration",
    };
    let attributes = value_attributes(variable);
    let attributes = attributes.iter().map(|(name, value)| (*name, value.as_str()));
    xml.create_element(name).with_attributes(attributes).write_empty()?;
    Ok(())
}

/// Every output, once with what it depends on during the flight and once at initialisation.
fn model_structure(xml: &mut Xml, table: &VariableTable) -> io::Result<()> {
    xml.create_element("ModelStructure").write_inner_content(|xml| {
        unknowns(xml, table, "Outputs", VariableTable::dependencies)?;
        unknowns(xml, table, "InitialUnknowns", VariableTable::initial_dependencies)
    })?;
    Ok(())
}

fn unknowns(
    xml: &mut Xml,
    table: &VariableTable,
    list: &str,
    dependencies: fn(&VariableTable, OutputSlot) -> Vec<u32>,
) -> io::Result<()> {
    // The schema counts variables from 1 in the order of ModelVariables.
    let index = |reference: u32| (reference + 1).to_string();
    xml.create_element(list).write_inner_content(|xml| {
        for (reference, variable) in table.iter() {
            let Slot::Output(slot) = variable.slot else { continue };
            let on = dependencies(table, slot).into_iter().map(index).collect::<Vec<_>>().join(" ");
            xml.create_element("Unknown")
                .with_attributes([("index", index(reference).as_str()), ("dependencies", &on)])
                .write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}
