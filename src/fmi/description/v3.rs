//! The model description of FMI 3.0.

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
    document(|xml| {
        root(xml, source, ("instantiationToken", None), |xml| {
            kind(xml, interface.kind)?;
            unit_definitions(xml, table)?;
            type_definitions(xml)?;
            log_categories(xml, "fmi3")?;
            default_experiment(xml, interface, starts)?;
            xml.create_element("ModelVariables")
                .write_inner_content(|xml| table.iter().try_for_each(|row| variable(xml, table, row)))?;
            model_structure(xml, table)
        })
    })
}

/// Only what is true is said; what is left out is false.
fn kind(xml: &mut Xml, kind: Kind) -> io::Result<()> {
    let (element, own): (_, &[(&str, &str)]) = match kind {
        Kind::CoSimulation => (
            "CoSimulation",
            &[("canHandleVariableCommunicationStepSize", "true"), ("maxOutputDerivativeOrder", "0")],
        ),
        Kind::ModelExchange => ("ModelExchange", &[("needsCompletedIntegratorStep", "false")]),
    };
    xml.create_element(element)
        .with_attributes([
            ("modelIdentifier", MODEL_IDENTIFIER),
            ("canGetAndSetFMUState", "true"),
            ("canSerializeFMUState", "true"),
            ("providesDirectionalDerivatives", "true"),
        ])
        .with_attributes(own.iter().copied())
        .write_empty()?;
    Ok(())
}

fn type_definitions(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("TypeDefinitions").write_inner_content(|xml| {
        for enumeration in EnumerationType::ALL {
            xml.create_element("EnumerationType")
                .with_attributes([("name", enumeration.name()), ("description", enumeration.description())])
                .write_inner_content(|xml| items(xml, enumeration))?;
        }
        Ok(())
    })?;
    Ok(())
}

fn variable(
    xml: &mut Xml,
    table: &ArchiveTable,
    (reference, variable): (u32, &Variable<Place>),
) -> io::Result<()> {
    let name = match variable.kind {
        Type::Real => "Float64",
        Type::Integer => "Int32",
        Type::Boolean => "Boolean",
        Type::Enumeration(_) => "Enumeration",
    };
    let (causality, initial) = causality(variable);
    let reference = reference.to_string();
    let mut attributes = value_attributes(variable);
    if let Place::Rate(place) = variable.slot {
        let (_, state) = table.states()[place];
        attributes.push(("derivative", state.to_string()));
    }
    xml.create_element(name)
        .with_attributes([
            ("name", variable.name.as_str()),
            ("valueReference", &reference),
            ("description", &variable.description),
            ("causality", causality),
            ("variability", variability(variable)),
        ])
        .with_attributes(initial.map(|initial| ("initial", initial)))
        .with_attributes(attributes.iter().map(|(name, value)| (*name, value.as_str())))
        .write_empty()?;
    Ok(())
}

/// Every unknown, once with what it depends on during the flight, parameters among it, and once at initialisation.
fn model_structure(xml: &mut Xml, table: &ArchiveTable) -> io::Result<()> {
    let now = |unknown| table.dependencies(unknown, true);
    xml.create_element("ModelStructure").write_inner_content(|xml| {
        unknowns(xml, "Output", outputs_of(table), now)?;
        unknowns(xml, "ContinuousStateDerivative", table.rates(), now)?;
        unknowns(xml, "InitialUnknown", initial_unknowns(table), |unknown| {
            table.initial_dependencies(unknown)
        })
    })?;
    Ok(())
}

fn unknowns(
    xml: &mut Xml,
    name: &str,
    mut unknowns: impl Iterator<Item = u32>,
    dependencies: impl Fn(u32) -> Vec<u32>,
) -> io::Result<()> {
    unknowns.try_for_each(|unknown| {
        xml.create_element(name)
            .with_attributes([
                ("valueReference", unknown.to_string().as_str()),
                ("dependencies", &list(dependencies(unknown))),
            ])
            .write_empty()?;
        Ok(())
    })
}
