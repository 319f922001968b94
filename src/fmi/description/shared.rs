//! What the model descriptions of all versions of FMI say in the same words.

use std::io;

use quick_xml::Writer;

use crate::flight::Settings;
use crate::fmi::log::Category;
use crate::structure::ReducedModel;
use crate::variables::{DisplayUnit, EnumerationType, Type, Unit, Value, Variability, Variable};

/// `modelName` and `modelIdentifier`; the shared libraries of the archive are named after it.
pub const MODEL_IDENTIFIER: &str = "FlexibleAircraft";

/// Length of the default experiment, s: the flights of the thesis.
const STOP_TIME: f64 = 15.0;
/// Communication step of the default experiment, s.
const STEP_SIZE: f64 = 0.01;

/// Where a description is written to.
pub type Xml = Writer<Vec<u8>>;

/// Of the whole FMU, for people.
pub fn description(model: &ReducedModel) -> String {
    format!("Nonlinear flight dynamics of the flexible aircraft {}", model.name)
}

pub fn unit_definitions(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("UnitDefinitions")
        .write_inner_content(|xml| Unit::ALL.into_iter().try_for_each(|unit| define(xml, unit)))?;
    Ok(())
}

fn define(xml: &mut Xml, unit: Unit) -> io::Result<()> {
    let base = unit.base();
    xml.create_element("Unit").with_attribute(("name", unit.name())).write_inner_content(|xml| {
        let exponents = [
            ("kg", base.kilogram),
            ("m", base.metre),
            ("s", base.second),
            ("rad", base.radian),
            ("K", base.kelvin),
        ];
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

pub fn items(xml: &mut Xml, enumeration: EnumerationType) -> io::Result<()> {
    for (value, (name, description)) in (1..).zip(enumeration.items()) {
        let value: i32 = value;
        xml.create_element("Item")
            .with_attributes([("name", *name), ("value", &value.to_string()), ("description", description)])
            .write_empty()?;
    }
    Ok(())
}

/// The categories of the log; what falls into each, in words of the version.
pub fn log_categories(xml: &mut Xml, contents: impl Fn(Category) -> &'static str) -> io::Result<()> {
    xml.create_element("LogCategories").write_inner_content(|xml| {
        for category in Category::ALL {
            xml.create_element("Category")
                .with_attributes([("name", category.name()), ("description", contents(category))])
                .write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}

pub fn default_experiment(xml: &mut Xml, starts: &Settings) -> io::Result<()> {
    xml.create_element("DefaultExperiment")
        .with_attributes([
            ("startTime", "0"),
            ("stopTime", &STOP_TIME.to_string()),
            ("tolerance", &starts.tolerance.to_string()),
            ("stepSize", &STEP_SIZE.to_string()),
        ])
        .write_empty()?;
    Ok(())
}

/// When the value of a variable may change.
pub fn variability(variable: &Variable) -> &'static str {
    match variable.variability {
        Variability::Fixed => "fixed",
        Variability::Discrete => "discrete",
        Variability::Continuous => "continuous",
    }
}

/// What is said of the values that a variable may have.
pub fn value_attributes(variable: &Variable) -> Vec<(&'static str, String)> {
    let mut attributes: Vec<(&'static str, String)> = Vec::new();
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
        Some(Value::Boolean(flag)) => attributes.push(("start", flag.to_string())),
        None => {}
    }
    attributes
}
