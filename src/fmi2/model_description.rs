//! `modelDescription.xml`, written from the variable table; the same model gives the same bytes.

use std::io;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

use crate::flight::Settings;
use crate::structure::ReducedModel;
use crate::variables::{
    DisplayUnit, EnumerationType, OutputSlot, Slot, Type, Unit, Value, Variability, Variable, VariableTable,
};

use super::logger::Category;
use super::{MODEL_IDENTIFIER, guid};

/// Length of the default experiment, s: the flights of the thesis.
const STOP_TIME: f64 = 15.0;
/// Communication step of the default experiment, s.
const STEP_SIZE: f64 = 0.01;

type Xml = Writer<Vec<u8>>;

/// The model description of the FMU of an aircraft.
pub fn write(model: &ReducedModel) -> String {
    with_guid(model, &guid(model))
}

/// The same with any guid; the real one is a hash of this with none.
pub(super) fn with_guid(model: &ReducedModel, guid: &str) -> String {
    let table = VariableTable::new(model);
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    // PROOF: memory takes every byte, and the writer only passes UTF-8 on.
    document(&mut xml, model, &table, guid).expect("writing to memory succeeds");
    let mut text = String::from_utf8(xml.into_inner()).expect("strings are UTF-8");
    text.push('\n');
    text
}

fn document(xml: &mut Xml, model: &ReducedModel, table: &VariableTable, guid: &str) -> io::Result<()> {
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let description = format!("Nonlinear flight dynamics of the flexible aircraft {}", model.name);
    xml.create_element("fmiModelDescription")
        .with_attributes([
            ("fmiVersion", "2.0"),
            ("modelName", MODEL_IDENTIFIER),
            ("guid", guid),
            ("description", &description),
            ("version", env!("CARGO_PKG_VERSION")),
            ("license", env!("CARGO_PKG_LICENSE")),
            ("generationTool", concat!("flexible-aircraft ", env!("CARGO_PKG_VERSION"))),
            ("variableNamingConvention", "structured"),
        ])
        .write_inner_content(|xml| {
            co_simulation(xml)?;
            unit_definitions(xml)?;
            type_definitions(xml)?;
            log_categories(xml)?;
            default_experiment(xml, model)?;
            xml.create_element("ModelVariables").write_inner_content(|xml| {
                table.iter().try_for_each(|(reference, variable)| scalar_variable(xml, reference, variable))
            })?;
            model_structure(xml, table)
        })?;
    Ok(())
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

fn unit_definitions(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("UnitDefinitions")
        .write_inner_content(|xml| Unit::ALL.into_iter().try_for_each(|unit| define(xml, unit)))?;
    Ok(())
}

fn define(xml: &mut Xml, unit: Unit) -> io::Result<()> {
    let base = unit.base();
    xml.create_element("Unit").with_attribute(("name", unit.name())).write_inner_content(|xml| {
        let exponents = [("kg", base.kilogram), ("m", base.metre), ("s", base.second), ("rad", base.radian)];
        let mut element = xml.create_element("BaseUnit");
        for (name, exponent) in exponents.into_iter().filter(|(_, exponent)| *exponent != 0) {
            element = element.with_attribute((name, exponent.to_string().as_str()));
        }
        element.write_empty()?;
        if let Some(DisplayUnit { name, factor }) = unit.display() {
            xml.create_element("DisplayUnit")
                .with_attributes([("name", name), ("factor", factor.to_string().as_str())])
                .write_empty()?;
        }
        Ok(())
    })?;
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

fn items(xml: &mut Xml, enumeration: EnumerationType) -> io::Result<()> {
    for (value, (name, description)) in (1..).zip(enumeration.items()) {
        let value: i32 = value;
        xml.create_element("Item")
            .with_attributes([("name", *name), ("value", &value.to_string()), ("description", description)])
            .write_empty()?;
    }
    Ok(())
}

fn log_categories(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("LogCategories").write_inner_content(|xml| {
        for category in Category::ALL {
            xml.create_element("Category")
                .with_attributes([("name", category.name()), ("description", category.description())])
                .write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}

fn default_experiment(xml: &mut Xml, model: &ReducedModel) -> io::Result<()> {
    xml.create_element("DefaultExperiment")
        .with_attributes([
            ("startTime", "0"),
            ("stopTime", &STOP_TIME.to_string()),
            ("tolerance", &Settings::of(model).tolerance.to_string()),
            ("stepSize", &STEP_SIZE.to_string()),
        ])
        .write_empty()?;
    Ok(())
}

fn scalar_variable(xml: &mut Xml, reference: u32, variable: &Variable) -> io::Result<()> {
    let (causality, initial) = match variable.slot {
        Slot::Input(_) => ("input", None),
        Slot::Parameter(_) => ("parameter", Some("exact")),
        Slot::Output(_) => ("output", Some("calculated")),
    };
    let variability = match variable.variability {
        Variability::Fixed => "fixed",
        Variability::Discrete => "discrete",
        Variability::Continuous => "continuous",
    };
    let reference = reference.to_string();
    xml.create_element("ScalarVariable")
        .with_attributes([
            ("name", variable.name.as_str()),
            ("valueReference", &reference),
            ("description", &variable.description),
            ("causality", causality),
            ("variability", variability),
        ])
        .with_attributes(initial.map(|initial| ("initial", initial)))
        .write_inner_content(|xml| typed_element(xml, variable))?;
    Ok(())
}

fn typed_element(xml: &mut Xml, variable: &Variable) -> io::Result<()> {
    let name = match variable.kind {
        Type::Real => "Real",
        Type::Integer => "Integer",
        Type::Enumeration(_) => "Enumeration",
    };
    let mut attributes: Vec<(&str, String)> = Vec::new();
    if let Type::Enumeration(enumeration) = variable.kind {
        attributes.push(("declaredType", enumeration.name().to_owned()));
    }
    if let Some(unit) = variable.unit {
        attributes.push(("unit", unit.name().to_owned()));
        attributes.extend(unit.display().map(|display| ("displayUnit", display.name.to_owned())));
    }
    let bounds = [("min", variable.min), ("max", variable.max), ("nominal", variable.nominal)];
    for (name, number) in bounds {
        attributes.extend(number.map(|number| (name, number.to_string())));
    }
    match variable.start {
        Some(Value::Real(x)) => attributes.push(("start", x.to_string())),
        Some(Value::Integer(i)) => attributes.push(("start", i.to_string())),
        None => {}
    }
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
