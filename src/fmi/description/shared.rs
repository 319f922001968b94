//! What the model descriptions of all versions of FMI say in the same words.

use std::io;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

use crate::flight::Settings;
use crate::fmi::interface::{Interface, Kind};
use crate::fmi::log::Category;
use crate::structure::ReducedModel;
use crate::variables::{
    ArchiveTable, DisplayUnit, EnumerationType, Place, Slot, Type, Unit, Value, Variability, Variable,
};

use super::source::Source;

/// `modelName` and `modelIdentifier`; the shared libraries of the archive are named after it.
pub const MODEL_IDENTIFIER: &str = "FlexibleAircraft";

/// Length of the default experiment, s: the flights of the thesis.
const STOP_TIME: f64 = 15.0;
/// Communication step of the default experiment, s.
const STEP_SIZE: f64 = 0.01;

/// Where a description is written to.
pub type Xml = Writer<Vec<u8>>;

/// Of the whole FMU, for people.
fn description(model: &ReducedModel) -> String {
    format!("Nonlinear flight dynamics of the flexible aircraft {}", model.name)
}

/// A document, indented.
pub fn document(write: impl FnOnce(&mut Xml) -> io::Result<()>) -> String {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    let written = xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)));
    // PROOF: memory takes every byte, and the writer only passes UTF-8 on.
    written.and_then(|()| write(&mut xml)).expect("writing to memory succeeds");
    let mut text = String::from_utf8(xml.into_inner()).expect("strings are UTF-8");
    text.push('\n');
    text
}

/// Those of all tables, and of rates of states where there are any.
pub fn unit_definitions(xml: &mut Xml, table: &ArchiveTable) -> io::Result<()> {
    let is_of_rates_alone = |unit: Unit| unit == Unit::NewtonPerSecond;
    let is_there = |unit: Unit| table.iter().any(|(_, variable)| variable.unit == Some(unit));
    let mut units = Unit::ALL.into_iter().filter(|unit| !is_of_rates_alone(*unit) || is_there(*unit));
    xml.create_element("UnitDefinitions")
        .write_inner_content(|xml| units.try_for_each(|unit| define(xml, unit)))?;
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

/// The root of a description, with what is in it. Versions call the token differently, and some say more.
pub fn root(
    xml: &mut Xml,
    Source { interface, model, token, .. }: Source,
    (name_of_token, further): (&str, Option<(&str, &str)>),
    contents: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<()> {
    xml.create_element("fmiModelDescription")
        .with_attributes([
            ("fmiVersion", interface.version.number()),
            ("modelName", MODEL_IDENTIFIER),
            (name_of_token, token),
            ("description", &description(model)),
            ("version", env!("CARGO_PKG_VERSION")),
            ("license", env!("CARGO_PKG_LICENSE")),
            ("generationTool", concat!("flexible-aircraft ", env!("CARGO_PKG_VERSION"))),
            ("variableNamingConvention", "structured"),
        ])
        .with_attributes(further)
        .write_inner_content(contents)?;
    Ok(())
}

/// The categories of the log, and what falls into each: reasons of statuses, whose names begin with a prefix.
pub fn log_categories(xml: &mut Xml, prefix: &str) -> io::Result<()> {
    let contents = |category| match category {
        Category::Events => "Instantiation, initialisation, trim, reset and termination".to_owned(),
        Category::StatusWarning => format!("Reasons of {prefix}Warning and {prefix}Discard"),
        Category::StatusError => format!("Reasons of {prefix}Error"),
        Category::StatusFatal => format!("Reasons of {prefix}Fatal"),
        Category::All => "All messages".to_owned(),
    };
    xml.create_element("LogCategories").write_inner_content(|xml| {
        for category in Category::ALL {
            xml.create_element("Category")
                .with_attributes([("name", category.name()), ("description", &contents(category))])
                .write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}

/// How it is flown unless someone says otherwise; an importer that integrates chooses its own steps.
pub fn default_experiment(xml: &mut Xml, interface: Interface, starts: &Settings) -> io::Result<()> {
    let tolerance = starts.tolerance.to_string();
    let step = (interface.kind == Kind::CoSimulation).then(|| STEP_SIZE.to_string());
    xml.create_element("DefaultExperiment")
        .with_attributes([
            ("startTime", "0"),
            ("stopTime", &STOP_TIME.to_string()),
            ("tolerance", &tolerance),
        ])
        .with_attributes(step.as_deref().map(|step| ("stepSize", step)))
        .write_empty()?;
    Ok(())
}

/// Causality of a variable, and how its initial value comes about where that is said.
pub fn causality(variable: &Variable<Place>) -> (&'static str, Option<&'static str>) {
    match variable.slot {
        Place::Common(Slot::Input(_)) => ("input", None),
        Place::Common(Slot::Parameter(_)) => ("parameter", Some("exact")),
        Place::Common(Slot::Output(_)) => ("output", Some("calculated")),
        Place::State(_) | Place::Rate(_) => ("local", Some("calculated")),
        Place::Time => ("independent", None),
    }
}

/// The references of all outputs.
pub fn outputs_of(table: &ArchiveTable) -> impl Iterator<Item = u32> {
    let is_output = |variable: &Variable<Place>| matches!(variable.slot, Place::Common(Slot::Output(_)));
    table.iter().filter(move |(_, variable)| is_output(variable)).map(|(reference, _)| reference)
}

/// Of the initialisation, in the order of the variables: outputs, states, rates.
pub fn initial_unknowns(table: &ArchiveTable) -> impl Iterator<Item = u32> {
    let is_unknown = |variable: &Variable<Place>| {
        matches!(variable.slot, Place::Common(Slot::Output(_)) | Place::State(_) | Place::Rate(_))
    };
    table.iter().filter(move |(_, variable)| is_unknown(variable)).map(|(reference, _)| reference)
}

/// Numbers in a list.
pub fn list(numbers: impl IntoIterator<Item = u32>) -> String {
    numbers.into_iter().map(|number| number.to_string()).collect::<Vec<_>>().join(" ")
}

/// When the value of a variable may change.
pub fn variability(variable: &Variable<Place>) -> &'static str {
    match variable.variability {
        Variability::Fixed => "fixed",
        Variability::Discrete => "discrete",
        Variability::Continuous => "continuous",
    }
}

/// What is said of the values that a variable may have.
pub fn value_attributes(variable: &Variable<Place>) -> Vec<(&'static str, String)> {
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
