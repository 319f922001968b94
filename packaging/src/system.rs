//! Several FMUs and the connections between them, checked, and written as masters read them: an SSP archive
//! (System Structure and Parameterization 1.0, or 2.0 where a component is of FMI 3.0) or a folder for libcosim (OSP system
//! structure 0.1).

use std::path::{Path, PathBuf};

mod check;
mod endpoint;
mod error;
mod osp;
mod setting;
mod ssp;
#[cfg(test)]
mod tests;
mod xml;

pub use endpoint::Endpoint;
pub use error::{ConnectionError, Misfit, SystemError};

use flexible_aircraft::fmi::Interface;

use crate::model_description::{ModelDescription, VariableType};
use crate::{Draft, PackageError, read};
use setting::Setting;

/// Name of libcosim's own description of a system.
const OSP_STRUCTURE: &str = "OspSystemStructure.xml";

/// FMUs that fit together, and how long they are to be run.
#[derive(Clone, Debug)]
pub struct System {
    components: Vec<Component>,
    connections: Vec<Connection>,
    settings: Vec<Setting>,
    experiment: Experiment,
}

/// An FMU with a name in the system.
#[derive(Clone, Debug)]
pub struct Component {
    name: String,
    fmu: Vec<u8>,
    description: ModelDescription,
}

/// What a master does with the system when nobody says otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Experiment {
    /// Communication step, s, greater than zero.
    pub step: f64,
    /// End, s; the beginning is 0.
    pub stop_time: f64,
}

/// An output and the input that it feeds, of the same type and unit.
#[derive(Clone, Debug, PartialEq)]
struct Connection {
    output: Endpoint,
    input: Endpoint,
    /// The end that does not say its unit, where the other one does.
    without_unit: Option<Endpoint>,
}

impl Component {
    /// Reads an FMU. Names are of letters, digits, underscores and hyphens.
    ///
    /// # Errors
    /// When the name is of something else, or the file is no FMU of FMI 2.0 or 3.0.
    pub fn read(name: &str, path: &Path) -> Result<Self, SystemError> {
        let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        if name.is_empty() || !name.chars().all(is_plain) {
            return Err(SystemError::ComponentName(name.to_owned()));
        }
        let failed = |reason: String| SystemError::Fmu { path: path.to_owned(), reason };
        let fmu = read(path)?;
        let xml = model_description_of(&fmu).map_err(failed)?;
        let description = ModelDescription::parse(&xml)
            .map_err(|reason| failed(format!("modelDescription.xml: {reason}")))?;
        Ok(Component { name: name.to_owned(), fmu, description })
    }
}

fn model_description_of(fmu: &[u8]) -> Result<String, String> {
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(fmu)).map_err(|error| error.to_string())?;
    let file = archive.by_name("modelDescription.xml");
    let file = file.map_err(|error| format!("modelDescription.xml: {error}"))?;
    std::io::read_to_string(file).map_err(|error| format!("modelDescription.xml: {error}"))
}

impl System {
    /// Connects components. Both ends of a connection may come first: one of them is an output, the other an
    /// input. Settings are start values of parameters and inputs, as texts.
    ///
    /// # Errors
    /// When two components have the same name, the experiment is not one, or a connection or setting does not fit
    /// the model descriptions: all of those that do not.
    pub fn new(
        components: Vec<Component>,
        connections: &[(Endpoint, Endpoint)],
        settings: &[(Endpoint, String)],
        experiment: Experiment,
    ) -> Result<Self, SystemError> {
        let Experiment { step, stop_time } = experiment;
        if !(step.is_finite() && step > 0.0 && stop_time.is_finite() && stop_time >= step) {
            return Err(SystemError::Experiment(experiment));
        }
        for (index, component) in components.iter().enumerate() {
            if components[..index].iter().any(|other| other.name == component.name) {
                return Err(SystemError::TwoComponents(component.name.clone()));
            }
        }
        let connections = check::connections(&components, connections)?;
        let settings = setting::settings(&components, settings, &connections)?;
        Ok(System { components, connections, settings, experiment })
    }

    /// The connected variables that do not say their unit, where the other end does.
    pub fn units_taken_on_trust(&self) -> impl Iterator<Item = &Endpoint> {
        self.connections.iter().filter_map(|connection| connection.without_unit.as_ref())
    }

    /// The settings of a component.
    fn settings_of(&self, component: &Component) -> Vec<&Setting> {
        self.settings.iter().filter(|setting| setting.at.component == component.name).collect()
    }

    /// The enumerations that are set. SSP has a place for them; libcosim does not load a system that does so, and
    /// OMSimulator leaves them at their start values.
    pub fn enumerations_set(&self) -> impl Iterator<Item = &Endpoint> {
        let settings = self.settings.iter().filter(|setting| setting.kind == VariableType::Enumeration);
        settings.map(|setting| &setting.at)
    }

    /// How many components and connections there are.
    pub fn size(&self) -> (usize, usize) {
        (self.components.len(), self.connections.len())
    }

    /// Writes the `.ssp`; equal systems give equal bytes.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_ssp(&self, output: &Path) -> Result<(), PackageError> {
        Ok(Draft::write(&ssp::to_bytes(self)?, output)?.keep()?)
    }

    /// Whether libcosim takes all components, and its own system structure can say all that is set.
    ///
    /// # Errors
    /// When a component is no FMU of FMI 2.0 for co-simulation, or an enumeration is set.
    pub fn check_for_osp(&self) -> Result<(), SystemError> {
        let is_other = |component: &&Component| component.description.interface != Interface::USUAL;
        if let Some(Component { name, description, .. }) = self.components.iter().find(is_other) {
            let found = description.interface;
            return Err(SystemError::InterfaceForOsp { component: name.clone(), found });
        }
        let mut enumerations = self.settings.iter().filter(|one| one.kind == VariableType::Enumeration);
        enumerations.next().map_or(Ok(()), |Setting { at, value, .. }| {
            Err(SystemError::EnumerationForOsp { given: format!("{at}={value}") })
        })
    }

    /// The files that [`write_osp`](Self::write_osp) writes.
    pub fn osp_files(&self, folder: &Path) -> Vec<PathBuf> {
        let fmus = self.components.iter().map(|component| format!("{}.fmu", component.name));
        fmus.chain([OSP_STRUCTURE.to_owned()]).map(|name| folder.join(name)).collect()
    }

    /// Writes `OspSystemStructure.xml` and the FMUs into a folder, which is made where it does not exist.
    ///
    /// # Errors
    /// As [`check_for_osp`](Self::check_for_osp), or when a file cannot be written.
    pub fn write_osp(&self, folder: &Path) -> Result<(), SystemError> {
        self.check_for_osp()?;
        let structure = osp::structure(self);
        let contents = self.components.iter().map(|component| component.fmu.as_slice());
        let drafts: Vec<Draft> = contents
            .chain([structure.as_slice()])
            .zip(self.osp_files(folder))
            .map(|(content, path)| Draft::write(content, &path))
            .collect::<Result<_, _>>()?;
        Ok(drafts.into_iter().try_for_each(Draft::keep)?)
    }
}
