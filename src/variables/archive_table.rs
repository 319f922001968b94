//! The variables of one kind of FMU: the table that all have, and beside it the time, states and their rates where an importer
//! is to know them.
//!
//! References: rows that all kinds have keep theirs; [`TIME`], states that are no outputs from [`STATES`] on and rates from
//! [`RATES`] on, each by its place in x.

use crate::flight::{ContinuousState, Settings, continuous_settings};
use crate::plant::Plant;
use crate::structure::ReducedModel;

use super::dependence;
use super::output_slot::OutputSlot;
use super::row::real;
use super::slot::{InputSlot, ParameterSlot, Slot};
use super::state_dependence;
use super::states::{StateVariable, variable};
use super::unit::Unit;
use super::variable::{Type, Variable};
use super::{VariableTable, table::NORTH_EAST_DOWN};

/// Reference of the time.
const TIME: u32 = 1_000_000;
/// Of the first state that is no output, were it one.
const STATES: u32 = 2_000_000;
/// Of the rate of the first state.
const RATES: u32 = 3_000_000;

/// What an importer is to know beside the common rows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extent {
    /// States and their rates; then nothing is said of how they are integrated.
    pub states: bool,
    /// The time.
    pub time: bool,
}

/// Where the value of a variable lives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Where that of a common row does; an output may be a state.
    Common(Slot),
    /// In x, at this place.
    State(usize),
    /// In ẋ, at this place.
    Rate(usize),
    /// It is the time.
    Time,
}

/// All variables of one kind of FMU of one aircraft.
///
/// ```
/// # use flexible_aircraft::{Aircraft, ReducedModel, flight::Settings};
/// use flexible_aircraft::variables::{ArchiveTable, Extent};
///
/// let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 26)?;
/// let table = ArchiveTable::new(&jet, &Settings::of(&jet), Extent { states: true, time: false });
/// assert_eq!(table.states().len(), 572);
/// assert_eq!(table.get(3_000_000).map(|row| row.name.as_str()), Some("der(position.north)"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ArchiveTable {
    common: VariableTable,
    rows: Vec<(u32, Variable<Place>)>,
    /// What each number of x is, and the reference of its variable.
    states: Vec<(ContinuousState, u32)>,
}

impl ArchiveTable {
    /// Of an aircraft whose parameters start somewhere.
    pub fn new(model: &ReducedModel, starts: &Settings, extent: Extent) -> Self {
        let common = VariableTable::starting(model, starts);
        let mut table = ArchiveTable { rows: Vec::new(), states: Vec::new(), common };
        table.rows = table.common.iter().map(|(reference, row)| (reference, placed(row))).collect();
        if extent.time {
            let text = "Time".to_owned();
            table.rows.push((TIME, real("time".to_owned(), Some(Unit::Second), Place::Time, text)));
        }
        if extent.states {
            table.leave_to_the_importer(model);
            table.add_states(model, starts);
        }
        table
    }

    /// The rows that all kinds have.
    pub fn common(&self) -> &VariableTable {
        &self.common
    }

    /// The variable with a value reference.
    pub fn get(&self, reference: u32) -> Option<&Variable<Place>> {
        let direct = usize::try_from(reference).ok().and_then(|place| self.rows.get(place));
        match direct {
            Some((found, row)) if *found == reference => Some(row),
            _ => self.place(reference).map(|place| &self.rows[place].1),
        }
    }

    /// All variables with their value references, in order.
    pub fn iter(&self) -> impl Iterator<Item = (u32, &Variable<Place>)> {
        self.rows.iter().map(|(reference, row)| (*reference, row))
    }

    /// Which of all variables in their order the one with a reference is.
    pub fn place(&self, reference: u32) -> Option<usize> {
        self.rows.binary_search_by_key(&reference, |(own, _)| *own).ok()
    }

    /// What each number of x is, and the reference of its variable; none where the importer knows no states.
    pub fn states(&self) -> &[(ContinuousState, u32)] {
        &self.states
    }

    /// The references of the rates of x.
    pub fn rates(&self) -> impl Iterator<Item = u32> {
        (RATES..).take(self.states.len())
    }

    /// The place in x of an output that is a state.
    pub fn state_of(&self, output: OutputSlot, reference: u32) -> Option<usize> {
        let may_be = matches!(
            output,
            OutputSlot::Position(_)
                | OutputSlot::Attitude(_)
                | OutputSlot::Velocity(_)
                | OutputSlot::Rate(_)
                | OutputSlot::ModalCoordinate(_)
                | OutputSlot::ModalRate(_)
                | OutputSlot::ActuatorRate(_)
        );
        if may_be { self.states.iter().position(|(_, own)| *own == reference) } else { None }
    }

    /// What an unknown, an output or a rate, depends on at an instant, inputs and states known, and `parameters` if these are
    /// known too.
    pub fn dependencies(&self, unknown: u32, parameters: bool) -> Vec<u32> {
        let dependent = match self.get(unknown).map(|row| row.slot) {
            Some(Place::Common(Slot::Output(output))) => match self.state_of(output, unknown) {
                Some(_) => return vec![unknown],
                None => Dependent::Output(self.common.mirrored(output)),
            },
            Some(Place::Rate(place)) => Dependent::Rate(self.states[place].0),
            _ => return Vec::new(),
        };
        let has_states = !self.states.is_empty();
        let mut known: Vec<u32> = self.inputs(|input| dependent.feels(input, has_states)).collect();
        let states = self.states.iter().filter(|(state, _)| dependent.shows(*state));
        known.extend(states.map(|(_, reference)| *reference));
        if parameters && dependent.has_parameters() {
            known.extend(self.real_parameters());
        }
        known.sort_unstable();
        known
    }

    /// What an unknown, an output, a state or a rate, depends on at initialisation: inputs and parameters.
    pub fn initial_dependencies(&self, unknown: u32) -> Vec<u32> {
        let Some(row) = self.get(unknown) else { return Vec::new() };
        match row.slot {
            Place::Common(Slot::Output(output)) => {
                let mut known = self.common.initial_dependencies(output);
                known.retain(|reference| self.place(*reference).is_some());
                known
            }
            Place::State(place) => {
                let (state, _) = self.states[place];
                self.parameters(|parameter| state_dependence::starts(state, parameter)).collect()
            }
            Place::Rate(place) => {
                let (rate_of, _) = self.states[place];
                let inputs = self.inputs(|input| state_dependence::pushes(rate_of, input));
                let starts = |parameter| state_dependence::starts_rate(rate_of, parameter);
                inputs.chain(self.parameters(starts)).collect()
            }
            Place::Common(_) | Place::Time => Vec::new(),
        }
    }

    fn inputs(&self, wanted: impl Fn(InputSlot) -> bool) -> impl Iterator<Item = u32> {
        self.iter().filter_map(move |(reference, row)| match row.slot {
            Place::Common(Slot::Input(input)) if wanted(input) => Some(reference),
            _ => None,
        })
    }

    fn parameters(&self, wanted: impl Fn(ParameterSlot) -> bool) -> impl Iterator<Item = u32> {
        self.iter().filter_map(move |(reference, row)| match row.slot {
            Place::Common(Slot::Parameter(parameter)) if wanted(parameter) => Some(reference),
            _ => None,
        })
    }

    /// The parameters that are Reals, but for the tolerance, on which nothing depends as long as it is met.
    fn real_parameters(&self) -> impl Iterator<Item = u32> {
        let is_real = |row: &Variable<Place>| {
            row.kind == Type::Real
                && matches!(row.slot, Place::Common(Slot::Parameter(slot)) if slot != ParameterSlot::Tolerance)
        };
        self.iter().filter(move |(_, row)| is_real(row)).map(|(reference, _)| reference)
    }

    /// Takes away what is of an integrator of our own, and says what else is.
    fn leave_to_the_importer(&mut self, model: &ReducedModel) {
        let is_tolerance =
            |row: &Variable<Place>| row.slot == Place::Common(Slot::Parameter(ParameterSlot::Tolerance));
        self.rows.retain(|(_, row)| !is_tolerance(row));
        let natural = model.natural_modes() as f64;
        for (_, row) in &mut self.rows {
            match row.slot {
                Place::Common(Slot::Parameter(ParameterSlot::InflowStates)) => {
                    row.max = Some(model.inflow_states as f64);
                }
                Place::Common(Slot::Parameter(ParameterSlot::ModeCount)) if model.has_load_modes() => {
                    (row.min, row.max) = (Some(natural), Some(natural));
                }
                Place::Common(Slot::Input(InputSlot::WindRate(axis))) => {
                    row.description = format!(
                        "Rate of wind_{}, which the apparent mass feels; the wind is what is set, whatever its rate",
                        NORTH_EAST_DOWN[axis.index()]
                    );
                }
                _ => {}
            }
        }
    }

    fn add_states(&mut self, model: &ReducedModel, starts: &Settings) {
        let magnitude = Plant::of_all_modes(model).coordinate_magnitude();
        let speed = starts.plant.airspeed.max(1.0);
        let (mut own, mut rates) = (Vec::new(), Vec::new());
        for (place, state) in ContinuousState::all(model).into_iter().enumerate() {
            let nominal = state.nominal(magnitude, speed);
            // No aircraft has a million states.
            let number = place as u32;
            let (reference, name, unit) = match variable(state, model) {
                StateVariable::Output(slot) => {
                    let slot = Place::Common(Slot::Output(slot));
                    // PROOF: the table has the motion, all packaged modes and all controls of its aircraft.
                    let row = self.rows.iter_mut().find(|(_, row)| row.slot == slot);
                    let (reference, row) = row.expect("an output of the aircraft");
                    row.nominal = Some(nominal);
                    (*reference, row.name.clone(), row.unit)
                }
                StateVariable::Own(of) => {
                    let row = real(of.name.clone(), Some(of.unit), Place::State(place), of.description);
                    own.push((STATES + number, row.nominal(nominal)));
                    (STATES + number, of.name, Some(of.unit))
                }
            };
            let unit = unit.and_then(Unit::per_second);
            let text = format!("Rate of change of {name}");
            rates.push((RATES + number, real(format!("der({name})"), unit, Place::Rate(place), text)));
            self.states.push((state, reference));
        }
        self.rows.extend(own);
        self.rows.extend(rates);
    }
}

/// What depends on others at an instant.
#[derive(Clone, Copy, Debug)]
enum Dependent {
    /// None of a sensor.
    Output(OutputSlot),
    Rate(ContinuousState),
}

impl Dependent {
    fn shows(self, state: ContinuousState) -> bool {
        match self {
            Dependent::Output(output) => state_dependence::shows(output, state),
            Dependent::Rate(rate_of) => state_dependence::moves(rate_of, state),
        }
    }

    fn feels(self, input: InputSlot, has_states: bool) -> bool {
        match self {
            Dependent::Output(output) if has_states => state_dependence::direct(output, input),
            Dependent::Output(output) => dependence::direct(output, input),
            Dependent::Rate(rate_of) => state_dependence::pushes(rate_of, input),
        }
    }

    fn has_parameters(self) -> bool {
        match self {
            Dependent::Output(output) => !state_dependence::is_of_states_alone(output),
            Dependent::Rate(rate_of) => !state_dependence::is_kinematic(rate_of),
        }
    }
}

/// Where the parameters of an aircraft start, of its model and whether the importer knows states, unless someone says otherwise.
pub fn usual_starts(model: &ReducedModel, extent: Extent) -> Settings {
    if extent.states { continuous_settings::usual(model) } else { Settings::of(model) }
}

/// A common row.
fn placed(row: &Variable) -> Variable<Place> {
    let Variable {
        name,
        description,
        kind,
        variability,
        unit,
        start,
        min,
        max,
        min_beside_none,
        nominal,
        slot,
    } = row.clone();
    let slot = Place::Common(slot);
    Variable { name, description, kind, variability, unit, start, min, max, min_beside_none, nominal, slot }
}
