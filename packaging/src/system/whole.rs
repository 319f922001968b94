//! Components, connections and settings that fit together.

use flexible_aircraft::fmi::Interface;

use super::component::Component;
use super::connection::Connection;
use super::endpoint::Endpoint;
use super::error::SystemError;
use super::experiment::Experiment;
use super::setting::Setting;
use super::{check, setting};
use crate::model_description::VariableType;

/// FMUs that fit together, and how long they are to be run.
#[derive(Clone, Debug)]
pub struct System {
    pub(super) components: Vec<Component>,
    pub(super) connections: Vec<Connection>,
    pub(super) settings: Vec<Setting>,
    pub(super) experiment: Experiment,
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
    pub(super) fn settings_of(&self, component: &Component) -> Vec<&Setting> {
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
}
