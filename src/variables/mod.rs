//! The table of FMI variables: declared once, here, for a given aircraft.
//!
//! The model description, the value references, the get and set functions and the documentation all come
//! from this table; nothing else lists a variable. A value reference is the row's index, one numbering for
//! all types, so that a reference used with the wrong type is noticed.

mod air_quantity;
mod archive_table;
mod axis;
mod condition_slot;
mod conditions;
mod dependence;
mod devices;
mod enumeration;
mod gust_slot;
mod gusts;
mod load_component;
mod nearest;
mod output_slot;
mod parameters;
mod placements;
mod row;
mod section_loads;
mod slot;
mod state_dependence;
mod states;
mod surface_angle;
mod table;
mod unit;
mod value;
mod variable;

pub use air_quantity::AirQuantity;
pub use archive_table::{ArchiveTable, Extent, Place, usual_starts};
pub use axis::Axis;
pub use condition_slot::ConditionSetting;
pub use enumeration::EnumerationType;
pub use gust_slot::{GustSetting, TurbulenceSetting};
pub use load_component::LoadComponent;
pub use nearest::{nearest, probably_meant};
pub use output_slot::{DeflectionComponent, OutputSlot, PathQuantity, PlacementComponent};
pub use slot::{InputSlot, ParameterSlot, SensorSetting, Slot};
pub use surface_angle::instead_of_degrees;
pub use unit::{BaseUnit, DisplayUnit, Unit};
pub use value::Value;
pub use variable::{Type, Variability, Variable};

use crate::aircraft::TrimRole;
use crate::flight::Settings;
use crate::structure::ReducedModel;

/// All variables of the FMU of one aircraft; the index is the value reference.
///
/// ```
/// use flexible_aircraft::variables::{Unit, VariableTable};
/// # use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?;
/// let table = VariableTable::new(&jet);
/// let airspeed = table.named("airspeed").ok_or("no such variable")?;
/// assert_eq!((airspeed.unit, airspeed.allowed()), (Some(Unit::MetrePerSecond), "1 to 400 m/s".to_owned()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct VariableTable {
    rows: Vec<Variable>,
    /// Of each control.
    roles: Vec<Option<TrimRole>>,
}

impl VariableTable {
    /// The variables for this aircraft: controls, engines, stations and packaged modes each bring their own.
    pub fn new(model: &ReducedModel) -> Self {
        VariableTable::starting(model, &Settings::of(model))
    }

    /// The same where the parameters start elsewhere.
    pub fn starting(model: &ReducedModel, starts: &Settings) -> Self {
        let roles = model.controls.iter().map(|control| control.role).collect();
        let mut rows = table::rows(model, starts);
        rows.extend(placements::of_aircraft());
        rows.extend(placements::of_stations(model));
        rows.extend(section_loads::rows(model));
        VariableTable { rows, roles }
    }

    /// The variable with a value reference.
    pub fn get(&self, reference: u32) -> Option<&Variable> {
        self.rows.get(usize::try_from(reference).ok()?)
    }

    /// All variables with their value references, in order.
    pub fn iter(&self) -> impl Iterator<Item = (u32, &Variable)> {
        (0u32..).zip(&self.rows)
    }

    /// The variable of a name.
    pub fn named(&self, name: &str) -> Option<&Variable> {
        self.rows.iter().find(|variable| variable.name == name)
    }

    /// The value reference of a name.
    pub fn reference(&self, name: &str) -> Option<u32> {
        self.iter().find(|(_, variable)| variable.name == name).map(|(reference, _)| reference)
    }

    /// The variables on whose values an output depends at an instant of the flight: inputs that act on it
    /// without integration in between.
    pub fn dependencies(&self, output: OutputSlot) -> Vec<u32> {
        let output = self.mirrored(output);
        self.knowns(|known| matches!(known, Slot::Input(input) if dependence::direct(output, input)))
    }

    /// The variables on whose values an output depends at initialisation.
    pub fn initial_dependencies(&self, output: OutputSlot) -> Vec<u32> {
        let source = self.mirrored(output);
        self.knowns(|known| match known {
            Slot::Input(input) => dependence::direct(source, input),
            Slot::Parameter(ParameterSlot::Sensor(setting)) => dependence::sampled(output, setting),
            Slot::Parameter(parameter) => dependence::initial(source, parameter, &self.roles),
            Slot::Output(_) => false,
        })
    }

    /// The output that a channel of a sensor mirrors; any other is itself.
    pub(crate) fn mirrored(&self, output: OutputSlot) -> OutputSlot {
        let slot_of = |name: &str| self.named(name).map(|variable| variable.slot);
        let row = match output {
            OutputSlot::Sensor(_) => self.rows.iter().find(|row| row.slot == Slot::Output(output)),
            _ => None,
        };
        match row.and_then(|row| slot_of(row.name.strip_prefix("sensor.")?)) {
            Some(Slot::Output(mirrored)) => mirrored,
            _ => output,
        }
    }

    fn knowns(&self, wanted: impl Fn(Slot) -> bool) -> Vec<u32> {
        self.iter().filter(|(_, variable)| wanted(variable.slot)).map(|(reference, _)| reference).collect()
    }
}

#[cfg(test)]
mod tests;
