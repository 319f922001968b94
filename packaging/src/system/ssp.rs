//! The SSP archive: `SystemStructure.ssd` and the FMUs under `resources/`.
//!
//! Every component shows its connected variables, and all its outputs of a type that every master takes, so that
//! a master records them. Inputs that nobody feeds are left out: FMPy would set them to 0 instead of their start.
//! libcosim finds its step in an annotation of its own. It wants the prefixes `ssd:`, `ssc:`, `ssv:`, `osp:` just so,
//! and no attribute at `osp:Algorithm`: all namespaces are declared at the root. OMSimulator's command line aborts where
//! the system does not end with an annotation of its own; the tolerances in it are OMSimulator's own defaults.

use std::io;

use flexible_aircraft::fmi::{Kind, Version};

use super::component::Component;
use super::connection::Connection;
use super::setting::Setting;
use super::whole::System;
use super::xml::{Xml, document, element, leaf};
use crate::PackageError;
use crate::archive::{self, Entry};
use crate::model_description::{Variable, VariableType};

const NAMESPACES: [(&str, &str); 4] = [
    ("xmlns:ssc", "http://ssp-standard.org/SSP1/SystemStructureCommon"),
    ("xmlns:ssd", "http://ssp-standard.org/SSP1/SystemStructureDescription"),
    ("xmlns:ssv", "http://ssp-standard.org/SSP1/SystemStructureParameterValues"),
    ("xmlns:osp", "http://opensimulationplatform.com/SSP/OSPAnnotations"),
];
const NAME: (&str, &str) = ("name", "System");

const OMSIMULATOR: (&str, &str) =
    ("xmlns:oms", "https://raw.githubusercontent.com/OpenModelica/OMSimulator/master/schema/oms.xsd");

/// The bytes of the `.ssp`.
pub(super) fn to_bytes(system: &System) -> Result<Vec<u8>, PackageError> {
    let mut entries = vec![Entry::new("SystemStructure.ssd", structure(system))];
    let fmus = system.components.iter();
    entries.extend(fmus.map(|component| Entry::new(source(component), component.fmu.as_slice())));
    Ok(archive::to_bytes(entries)?)
}

/// The bytes of `SystemStructure.ssd`.
pub(super) fn structure(system: &System) -> Vec<u8> {
    let root = [&NAMESPACES[..], &[version(system), NAME]].concat();
    document(|xml| {
        element(xml, "ssd:SystemStructureDescription", &root, |xml| {
            element(xml, "ssd:System", &[NAME], |xml| {
                elements_and_connections(xml, system)?;
                omsimulator_settings(xml, &system.experiment.step.to_string())
            })?;
            experiment(xml, system)
        })
    })
}

/// Of SSP. Components of FMI 3.0, and types of theirs, came with 2.0, which has the namespaces of 1.0; fewer masters read it.
fn version(system: &System) -> (&'static str, &'static str) {
    let is_third = |component: &Component| component.description.interface.version == Version::V3;
    ("version", if system.components.iter().any(is_third) { "2.0" } else { "1.0" })
}

/// Where a component's FMU is in the archive.
fn source(component: &Component) -> String {
    format!("resources/{}.fmu", component.name)
}

fn elements_and_connections(xml: &mut Xml, system: &System) -> io::Result<()> {
    element(xml, "ssd:Elements", &[], |xml| {
        system.components.iter().try_for_each(|one| component(xml, one, system))
    })?;
    if system.connections.is_empty() {
        return Ok(());
    }
    element(xml, "ssd:Connections", &[], |xml| {
        system.connections.iter().try_for_each(|one| connection(xml, one))
    })
}

fn component(xml: &mut Xml, component: &Component, system: &System) -> io::Result<()> {
    let source = source(component);
    let implementation = match component.description.interface.kind {
        Kind::CoSimulation => "CoSimulation",
        Kind::ModelExchange => "ModelExchange",
    };
    let attributes = [
        ("name", component.name.as_str()),
        ("type", "application/x-fmu-sharedlibrary"),
        ("source", &source),
        ("implementation", implementation),
    ];
    element(xml, "ssd:Component", &attributes, |xml| {
        let shown = component.description.variables.iter().filter(|v| is_shown(v, component, system));
        let shown: Vec<&Variable> = shown.collect();
        if !shown.is_empty() {
            element(xml, "ssd:Connectors", &[], |xml| {
                shown.into_iter().try_for_each(|variable| connector(xml, variable))
            })?;
        }
        let settings = system.settings_of(component);
        if settings.is_empty() { Ok(()) } else { parameters(xml, &settings, version(system)) }
    })
}

fn is_shown(variable: &Variable, component: &Component, system: &System) -> bool {
    let is_special = matches!(
        variable.kind,
        VariableType::String | VariableType::Binary | VariableType::Enumeration | VariableType::Clock
    );
    let common = !is_special && component.description.dimensions(variable).is_none();
    let ends = system.connections.iter().flat_map(|connection| [&connection.output, &connection.input]);
    let mut ends = ends.filter(|end| end.component == component.name);
    (common && variable.causality == "output") || ends.any(|end| end.variable == variable.name)
}

/// Without a unit: SSP then takes that of the FMU.
fn connector(xml: &mut Xml, variable: &Variable) -> io::Result<()> {
    let attributes = [("name", variable.name.as_str()), ("kind", &variable.causality)];
    element(xml, "ssd:Connector", &attributes, |xml| leaf(xml, &format!("ssc:{}", variable.kind), &[]))
}

/// The start values of a component, inline.
fn parameters(xml: &mut Xml, settings: &[&Setting], version: (&str, &str)) -> io::Result<()> {
    let parameter = |xml: &mut Xml, setting: &Setting| {
        element(xml, "ssv:Parameter", &[("name", &setting.at.variable)], |xml| {
            leaf(xml, &format!("ssv:{}", setting.kind), &[("value", &setting.value)])
        })
    };
    let set = |xml: &mut Xml| {
        element(xml, "ssv:ParameterSet", &[version, ("name", "start")], |xml| {
            element(xml, "ssv:Parameters", &[], |xml| {
                settings.iter().try_for_each(|setting| parameter(xml, setting))
            })
        })
    };
    element(xml, "ssd:ParameterBindings", &[], |xml| {
        element(xml, "ssd:ParameterBinding", &[], |xml| element(xml, "ssd:ParameterValues", &[], set))
    })
}

fn connection(xml: &mut Xml, Connection { output, input, .. }: &Connection) -> io::Result<()> {
    let start = [("startElement", output.component.as_str()), ("startConnector", &output.variable)];
    let end = [("endElement", input.component.as_str()), ("endConnector", &input.variable)];
    leaf(xml, "ssd:Connection", &[start, end].concat())
}

/// What OMSimulator looks for in a system.
fn omsimulator_settings(xml: &mut Xml, step: &str) -> io::Result<()> {
    let master = [
        ("description", "oms-ma"),
        ("stepSize", step),
        ("absoluteTolerance", "0.0001"),
        ("relativeTolerance", "0.0001"),
    ];
    element(xml, "ssd:Annotations", &[], |xml| {
        element(xml, "ssc:Annotation", &[("type", "org.openmodelica")], |xml| {
            element(xml, "oms:Annotations", &[OMSIMULATOR], |xml| {
                element(xml, "oms:SimulationInformation", &[], |xml| {
                    leaf(xml, "oms:FixedStepMaster", &master)
                })
            })
        })
    })
}

fn experiment(xml: &mut Xml, system: &System) -> io::Result<()> {
    let [step, stop] = [system.experiment.step, system.experiment.stop_time].map(|time| time.to_string());
    element(xml, "ssd:DefaultExperiment", &[("startTime", "0"), ("stopTime", &stop)], |xml| {
        element(xml, "ssd:Annotations", &[], |xml| {
            element(xml, "ssc:Annotation", &[("type", "com.opensimulationplatform")], |xml| {
                element(xml, "osp:Algorithm", &[], |xml| {
                    leaf(xml, "osp:FixedStepAlgorithm", &[("baseStepSize", &step)])
                })
            })
        })
    })
}
