//! The model description of FMI 2.0.

use std::io;

use crate::fmi::interface::Kind;
use crate::variables::{ArchiveTable, EnumerationType, Place, Type, Variable};

use super::shared::{
    MODEL_IDENTIFIER, Xml, causality, default_experiment, document, initial_unknowns, items, list,
    log_categories, outputs_of, root, unit_definitions, value_attributes, variability,
};
use super::source::Source;

/// The description with a token; the real one is a hash of this with none.
pub fn text(source: Source) -> String {
    let Source { interface, starts, table, .. } = source;
    let indicators = (interface.kind == Kind::ModelExchange).then_some(("numberOfEventIndicators", "0"));
    document(|xml| {
        root(xml, source, ("guid", indicators), |xml| {
            match interface.kind {
                Kind::CoSimulation => co_simulation(xml)?,
                Kind::ModelExchange => model_exchange(xml)?,
            }
            unit_definitions(xml, table)?;
            type_definitions(xml)?;
            log_categories(xml, "fmi2")?;
            default_experiment(xml, interface, starts)?;
            xml.create_element("ModelVariables").write_inner_content(|xml| {
                table.iter().try_for_each(|row| scalar_variable(xml, table, row))
            })?;
            model_structure(xml, table)
        })
    })
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

fn model_exchange(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("ModelExchange")
        .with_attributes([
            ("modelIdentifier", MODEL_IDENTIFIER),
            ("completedIntegratorStepNotNeeded", "true"),
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

fn scalar_variable(
    xml: &mut Xml,
    table: &ArchiveTable,
    (reference, variable): (u32, &Variable<Place>),
) -> io::Result<()> {
    let (causality, initial) = causality(variable);
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
        .write_inner_content(|xml| typed_element(xml, table, variable))?;
    Ok(())
}

fn typed_element(xml: &mut Xml, table: &ArchiveTable, variable: &Variable<Place>) -> io::Result<()> {
    let name = match variable.kind {
        Type::Real => "Real",
        Type::Integer => "Integer",
        Type::Boolean => "Boolean",
        Type::Enumeration(_) => "Enumeration",
    };
    let mut attributes = value_attributes(variable);
    if let Place::Rate(place) = variable.slot {
        let (_, state) = table.states()[place];
        attributes.push(("derivative", list([index(table, state)])));
    }
    let attributes = attributes.iter().map(|(name, value)| (*name, value.as_str()));
    xml.create_element(name).with_attributes(attributes).write_empty()?;
    Ok(())
}

/// The schema counts variables from 1 in the order of ModelVariables.
fn index(table: &ArchiveTable, reference: u32) -> u32 {
    let place = table.place(reference).and_then(|place| u32::try_from(place).ok());
    // Who asks has found the reference in the table, which has fewer rows.
    place.map_or(0, |place| place + 1)
}

/// Every unknown, once with what it depends on during the flight and once at initialisation.
fn model_structure(xml: &mut Xml, table: &ArchiveTable) -> io::Result<()> {
    let now = |unknown| table.dependencies(unknown, false);
    xml.create_element("ModelStructure").write_inner_content(|xml| {
        unknowns(xml, table, ("Outputs", outputs_of(table)), now)?;
        if !table.states().is_empty() {
            unknowns(xml, table, ("Derivatives", table.rates()), now)?;
        }
        let initially = |unknown| table.initial_dependencies(unknown);
        unknowns(xml, table, ("InitialUnknowns", initial_unknowns(table)), initially)
    })?;
    Ok(())
}

fn unknowns(
    xml: &mut Xml,
    table: &ArchiveTable,
    (name, mut unknowns): (&str, impl Iterator<Item = u32>),
    dependencies: impl Fn(u32) -> Vec<u32>,
) -> io::Result<()> {
    xml.create_element(name).write_inner_content(|xml| {
        unknowns.try_for_each(|unknown| {
            let on = list(dependencies(unknown).into_iter().map(|reference| index(table, reference)));
            xml.create_element("Unknown")
                .with_attributes([("index", list([index(table, unknown)]).as_str()), ("dependencies", &on)])
                .write_empty()?;
            Ok(())
        })
    })?;
    Ok(())
}
