//! How states, inputs and outputs of a linear model are named: as in the FMU, where it has them [theory: linearisation.outputs].

use crate::flight::Settings;
use crate::plant::{LinearInput, Plant, Unknown};
use crate::variables::{Axis, InputSlot, OutputSlot, Slot, Type, Unit, Variability, Variable, VariableTable};

/// Of a state, an input or an output of a linear model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// That of the FMU's variable, where there is one.
    pub name: String,
    /// As the FMU writes it; that of modes, which FMI cannot say, is made of kg^(1/2).
    pub unit: &'static str,
}

/// Units of modal coordinates and of their rates.
const MODAL: &str = "kg^(1/2).m";
const MODAL_RATE: &str = "kg^(1/2).m/s";

/// Of states, in their order; what no variable of the FMU is has a name of its own: the inflow, of strips and states from 1
/// on, and load modes that combine packaged ones, by their place among the coordinates.
pub(super) fn states(unknowns: &[Unknown], plant: &Plant, table: &VariableTable) -> Vec<Name> {
    let output = |slot| output_named(slot, table);
    let combined = |suffix: &str, mode: usize, unit| Name {
        name: format!("modal.combined_{suffix}[{}]", mode + 1),
        unit,
    };
    let mut strip_before = None;
    let mut count = 0;
    let mut inflow = |strip| {
        count = if strip_before == Some(strip) { count + 1 } else { 1 };
        strip_before = Some(strip);
        let number = plant.packaged_strip(strip).number + 1;
        Name { name: format!("inflow[{number},{count}]"), unit: Unit::MetrePerSecond.name() }
    };
    let name = |&unknown: &Unknown| match unknown {
        Unknown::Horizontal(axis) => output(OutputSlot::Position(Axis::ALL[axis])),
        Unknown::Down => output(OutputSlot::Position(Axis::Z)),
        Unknown::Roll => output(OutputSlot::Attitude(Axis::X)),
        Unknown::Pitch => output(OutputSlot::Attitude(Axis::Y)),
        Unknown::Yaw => output(OutputSlot::Attitude(Axis::Z)),
        Unknown::Velocity(axis) => output(OutputSlot::Velocity(Axis::ALL[axis])),
        Unknown::Rate(axis) => output(OutputSlot::Rate(Axis::ALL[axis])),
        Unknown::Coordinate(mode) => match plant.packaged_mode(mode) {
            Some(packaged) => output(OutputSlot::ModalCoordinate(packaged)),
            None => combined("q", mode, MODAL),
        },
        Unknown::CoordinateRate(mode) => match plant.packaged_mode(mode) {
            Some(packaged) => output(OutputSlot::ModalRate(packaged)),
            None => combined("q_dot", mode, MODAL_RATE),
        },
        Unknown::Inflow { strip, .. } => inflow(strip),
    };
    unknowns.iter().map(name).collect()
}

/// Of an output of the FMU.
pub(super) fn output_named(slot: OutputSlot, table: &VariableTable) -> Name {
    of_slot(Slot::Output(slot), table)
}

/// Of an input of the FMU.
pub(super) fn input_named(slot: InputSlot, table: &VariableTable) -> Name {
    of_slot(Slot::Input(slot), table)
}

/// Of an input.
pub(super) fn input(input: LinearInput, table: &VariableTable) -> Name {
    let slot = match input {
        LinearInput::Control(control) => InputSlot::Control(control),
        LinearInput::Thrust(engine) => InputSlot::Thrust(engine),
        LinearInput::Wind(axis) => InputSlot::Wind(Axis::ALL[axis]),
    };
    input_named(slot, table)
}

/// The outputs of a linear model under some settings: all that are Real and change with time, in the order of the FMU, but
/// for sensors, which sample, and for the rates of controls that do not lag, which are those of inputs.
pub(super) fn outputs(table: &VariableTable, settings: &Settings) -> Vec<(OutputSlot, Name)> {
    let is_smooth = |slot| match slot {
        OutputSlot::Sensor(_) => false,
        OutputSlot::ActuatorRate(control) => settings.actuators.get(control).lags(),
        _ => true,
    };
    let output = |variable: &Variable| match variable.slot {
        Slot::Output(slot) if is_smooth(slot) => Some((slot, of_variable(variable))),
        _ => None,
    };
    let changes =
        |variable: &&Variable| (variable.kind, variable.variability) == (Type::Real, Variability::Continuous);
    table.iter().map(|(_, variable)| variable).filter(changes).filter_map(output).collect()
}

fn of_slot(slot: Slot, table: &VariableTable) -> Name {
    let variable = table.iter().map(|(_, variable)| variable).find(|variable| variable.slot == slot);
    // PROOF: the table has motion, packaged modes, controls, engines and wind of the aircraft that it is of.
    of_variable(variable.expect("a variable of the aircraft"))
}

fn of_variable(variable: &Variable) -> Name {
    let unit = match (variable.unit, variable.slot) {
        (Some(unit), _) => unit.name(),
        (None, Slot::Output(OutputSlot::ModalRate(_))) => MODAL_RATE,
        // No others but coordinates of modes are without one.
        (None, _) => MODAL,
    };
    Name { name: variable.name.clone(), unit }
}
