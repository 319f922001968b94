//! A flight, linear models of one and what gusts do to them, by the names of variables: the face of the library for those who want neither an FMU nor its types.
//!
//! Names, units, signs and starts are those of the FMU; [`Flight::variables`] lists them.

mod all_states;
mod at_trim;
mod flying_qualities;
mod frequency_grid;
mod gust_planes;
mod harmonic_gusts;
mod in_turbulence;
mod lags;
mod linear_model;
mod linear_names;
mod linearising;
mod resolvent;
mod setting;

use std::sync::Arc;

use crate::flight::{Inputs, LONGEST_STEP, Settings, Simulation, SimulationError};
use crate::plant::LimitExceeded;
use crate::structure::ReducedModel;
use crate::variables::{Slot, Value, Variable, VariableTable, nearest};

pub use flying_qualities::flight_modes;
pub use harmonic_gusts::{HarmonicColumn, HarmonicGusts};
pub use in_turbulence::{InTurbulence, OutputInTurbulence};
pub use linear_model::{Inflow, LinearContents, LinearModel};
pub use linear_names::Name as LinearName;
pub use setting::Setting;

use setting::{degrees, item_meant, value};

/// One flight of one aircraft, read and steered by the names of variables.
///
/// Parameters such as `airspeed` are set before the flight begins, which is when it is first flown or an output first
/// read; it is trimmed then. Inputs are set at any time and hold until they are set again. SI units and radians.
///
/// ```
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use flexible_aircraft::{Aircraft, Flight};
///
/// let aircraft = Aircraft::read("aircraft/generic-business-jet.toml")?;
/// let mut flight = Flight::new(aircraft.reduce()?);
/// flight.set("elevator", -0.02)?;
/// flight.advance(2.0)?;
/// println!("pitch {} rad after {} s", flight.get("attitude.pitch")?, flight.time());
/// # assert!(flight.get("attitude.pitch")? > flight.get("trim.pitch")?);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Flight {
    model: Arc<ReducedModel>,
    variables: VariableTable,
    settings: Settings,
    inputs: Inputs,
    rates: Inputs,
    /// Once the flight has begun.
    simulation: Option<Simulation>,
}

/// Why a variable could not be read or set, or a flight not be flown.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FlightError {
    /// There is no variable of that name.
    #[error("`{name}`: there is no such variable; {instead}; Flight::variables lists them all")]
    Unknown {
        /// As given.
        name: String,
        /// What there is, for people.
        instead: String,
    },
    /// Outputs are computed.
    #[error("`{0}` is an output and cannot be set")]
    Output(String),
    /// A parameter once the flight has begun.
    #[error("`{0}` is a parameter: it is set before the flight is first flown or an output first read")]
    Begun(String),
    /// A value that the variable cannot take.
    #[error("`{name}`: found {found}, allowed is {allowed}")]
    Value {
        /// Of the variable.
        name: String,
        /// As given.
        found: String,
        /// For people, with the unit.
        allowed: String,
    },
    /// A time that nobody can fly on for.
    #[error("duration: found {0} s, allowed is 0 to {LONGEST_STEP} s, a day, at once")]
    Duration(f64),
    /// There is no trim, or the flight cannot go on.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
}

impl Flight {
    /// Of an aircraft, all variables at their starts; the flight begins at time 0.
    pub fn new(model: impl Into<Arc<ReducedModel>>) -> Self {
        let model = model.into();
        let inputs = Inputs::zero(&model);
        Flight {
            variables: VariableTable::new(&model),
            settings: Settings::of(&model),
            rates: inputs.clone(),
            inputs,
            simulation: None,
            model,
        }
    }

    /// All variables with units, ranges and descriptions.
    pub fn variables(&self) -> &VariableTable {
        &self.variables
    }

    /// Sets an input from now on, or a parameter of a flight that has not begun.
    ///
    /// ```
    /// # use flexible_aircraft::{Aircraft, Flight};
    /// let mut flight = Flight::new(Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?);
    /// flight.set("model", "rigid")?;
    /// flight.set("airspeed", 150.0)?; // m/s
    /// flight.set("inflow_states", 3)?;
    /// flight.set("wind_down", -5.0)?; // m/s
    /// assert!(flight.set("airspeed", -1.0).unwrap_err().to_string().contains("m/s"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When there is no such variable, it cannot be set, or not to this; nothing changes then.
    pub fn set<'a>(&mut self, name: &str, to: impl Into<Setting<'a>>) -> Result<(), FlightError> {
        let (to, variable) = (to.into(), self.variable(name)?);
        let (slot, name) = (variable.slot, name.to_owned());
        match slot {
            Slot::Output(_) => return Err(FlightError::Output(name)),
            Slot::Parameter(_) if self.simulation.is_some() => return Err(FlightError::Begun(name)),
            Slot::Parameter(_) | Slot::Input(_) => {}
        }
        let (found, allowed) = (to.to_string(), variable.allowed());
        let value = value(variable, to).filter(|value| variable.allows(*value));
        let value = match (value, degrees(slot, to)) {
            (Some(value), None) => value,
            (_, allowed_angle) => {
                let allowed = allowed_angle.unwrap_or(allowed) + &item_meant(variable, to);
                return Err(FlightError::Value { name, found, allowed });
            }
        };
        match (slot, value) {
            (Slot::Output(_), _) => {}
            (Slot::Parameter(slot), value) => slot.set(&mut self.settings, value),
            (Slot::Input(slot), Value::Real(number)) => *slot.of(&mut self.inputs) = number,
            // Inputs are Reals.
            (Slot::Input(_), Value::Integer(_) | Value::Boolean(_)) => {}
        }
        if let Some(simulation) = &mut self.simulation {
            simulation.set_inputs(&self.inputs, &self.rates);
        }
        Ok(())
    }

    /// The present value of any variable; of an enumeration the number of the item, from 1, of a Boolean 1 or 0. Begins the flight if it is an
    /// output.
    ///
    /// # Errors
    /// When there is no such variable, or the flight cannot begin.
    pub fn get(&mut self, name: &str) -> Result<f64, FlightError> {
        match self.variable(name)?.slot {
            Slot::Input(slot) => Ok(slot.get(&self.inputs)),
            Slot::Parameter(slot) => Ok(slot.get(&self.settings).number()),
            Slot::Output(slot) => Ok(slot.number(self.simulation()?.instant_of(slot.part().into()))),
        }
    }

    /// Flies on for a time, s, from 0 to a [day](crate::flight::LONGEST_STEP). Cells of 10 ms on a grid from the beginning are what is computed: how a flight is cut into
    /// steps of whole cells changes no bit.
    ///
    /// # Errors
    /// When the flight cannot begin, leaves the model's validity, or the time is none; it then stands where it was.
    pub fn advance(&mut self, duration: f64) -> Result<(), FlightError> {
        if !(0.0..=LONGEST_STEP).contains(&duration) {
            return Err(FlightError::Duration(duration));
        }
        let simulation = self.simulation()?;
        let now = simulation.time();
        simulation.step(now, duration)?;
        self.take_inputs();
        Ok(())
    }

    /// The complete state as bytes, from which [`restore`](Self::restore) goes on with the same bits. Begins the flight.
    ///
    /// # Errors
    /// When it cannot begin.
    pub fn snapshot(&mut self) -> Result<Vec<u8>, FlightError> {
        let simulation = self.simulation()?;
        let mut bytes = Vec::with_capacity(simulation.snapshot_size());
        simulation.snapshot(&mut bytes);
        Ok(bytes)
    }

    /// Goes back to a snapshot of a flight of the same aircraft with the same parameters. Begins the flight.
    ///
    /// ```
    /// # use flexible_aircraft::{Aircraft, Flight};
    /// let mut flight = Flight::new(Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?);
    /// let trimmed = flight.snapshot()?;
    /// let mut fly = |gust: f64| {
    ///     flight.restore(&trimmed)?;
    ///     flight.set("wind_down", gust)?;
    ///     flight.advance(1.0)?;
    ///     flight.get("load_factor.z")
    /// };
    /// assert!(fly(-3.0)? > fly(0.0)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When the bytes are damaged or of another aircraft, other parameters or another version; nothing changes then.
    pub fn restore(&mut self, snapshot: &[u8]) -> Result<(), FlightError> {
        self.simulation()?.restore(snapshot)?;
        self.take_inputs();
        Ok(())
    }

    /// Since the beginning, s.
    pub fn time(&self) -> f64 {
        self.simulation.as_ref().map_or(0.0, Simulation::time)
    }

    /// Where the trim is beyond the aircraft's limits. Begins the flight.
    ///
    /// # Errors
    /// When it cannot begin.
    pub fn limits_exceeded(&mut self) -> Result<&[LimitExceeded], FlightError> {
        Ok(self.simulation()?.limits_exceeded())
    }

    /// Reads the inputs as they stand in the flight.
    fn take_inputs(&mut self) {
        if let Some(simulation) = &self.simulation {
            simulation.write_inputs(&mut self.inputs);
            self.rates.clone_from(simulation.input_rates());
        }
    }

    /// The flight by its types, which begins if it has not.
    ///
    /// # Errors
    /// When there is no trim.
    fn simulation(&mut self) -> Result<&mut Simulation, FlightError> {
        match self.simulation {
            Some(ref mut simulation) => Ok(simulation),
            None => {
                let mut simulation = Simulation::new(Arc::clone(&self.model), &self.settings, 0.0)?;
                simulation.set_inputs(&self.inputs, &self.rates);
                Ok(self.simulation.insert(simulation))
            }
        }
    }

    fn variable(&self, name: &str) -> Result<&Variable, FlightError> {
        self.variables.named(name).ok_or_else(|| {
            let names = || self.variables.iter().map(|(_, variable)| variable.name.as_str());
            let instead = match name {
                "time" => "Flight::time has it".to_owned(),
                _ => format!("the nearest are {}", nearest(name, names())),
            };
            FlightError::Unknown { name: name.to_owned(), instead }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plant::PlantSettings;
    use crate::structure::test_jet::jet;

    fn rigid() -> Flight {
        let mut flight = Flight::new(jet().clone());
        flight.set("model", "rigid").unwrap();
        flight
    }

    #[test]
    fn a_flight_by_names_has_the_bits_of_one_by_types() {
        let mut named = rigid();
        let settings = Settings::from(PlantSettings {
            fidelity: crate::equations::Fidelity::Rigid,
            ..PlantSettings::of(jet())
        });
        let mut typed = Simulation::new(Arc::new(jet().clone()), &settings, 0.0).unwrap();
        let (still, mut inputs) = (Inputs::zero(jet()), Inputs::zero(jet()));
        for step in 0..30 {
            let down = 0.1 * f64::from(step);
            named.set("wind_down", down).unwrap();
            named.set("thrust_right", 100.0).unwrap();
            named.advance(0.01).unwrap();
            (inputs.wind.z, inputs.thrust[1]) = (down, 100.0);
            typed.set_inputs(&inputs, &still);
            typed.advance_to(0.01 * f64::from(step + 1)).unwrap();
        }
        let outputs = typed.outputs();
        for (name, expected) in
            [("attitude.pitch", outputs.attitude.y), ("load_factor.z", outputs.load_factor.z)]
        {
            assert_eq!(named.get(name).unwrap().to_bits(), expected.to_bits(), "{name}");
        }
        assert_eq!(named.time().to_bits(), typed.time().to_bits());
    }

    #[test]
    fn a_wind_goes_on_at_its_rate_and_is_read_so() {
        let mut flight = rigid();
        flight.set("wind_rate_down", 2.0).unwrap();
        flight.advance(0.5).unwrap();
        assert!((flight.get("wind_down").unwrap() - 1.0).abs() < 1e-15);
        let snapshot = flight.snapshot().unwrap();
        flight.advance(0.1).unwrap();
        let pitch = flight.get("attitude.pitch").unwrap();
        flight.restore(&snapshot).unwrap();
        flight.advance(0.1).unwrap();
        assert_eq!(flight.get("attitude.pitch").unwrap().to_bits(), pitch.to_bits());
    }

    #[test]
    fn what_cannot_be_set_is_refused_by_its_name_and_changes_nothing() {
        let mut flight = rigid();
        let mut refused = |name: &str, to: Setting, part: &str| {
            let before = flight.settings.clone();
            let error = flight.set(name, to).unwrap_err().to_string();
            assert!(error.contains(&format!("`{name}`")) && error.contains(part), "{error}");
            assert_eq!(flight.settings, before);
        };
        refused("elevatr", Setting::Number(0.0), "no such variable; the nearest are `elevator`, ");
        refused("elevator", Setting::Number(-20.0), "-20 looks like degrees");
        refused("model", Setting::Item("Rigid"), "did you mean `rigid`?");
        refused("attitude.pitch", Setting::Number(0.0), "output");
        refused("elevator", Setting::Number(f64::NAN), "found NaN, allowed is any finite number, in rad");
        refused("elevator", Setting::Item("full"), "found `full`");
        refused("airspeed", Setting::Number(-3.0), "found -3, allowed is 1 to 400 m/s");
        refused("mode_count", Setting::Number(2.5), "found 2.5");
        refused("mode_count", Setting::Flag(true), "found true");
        refused("model", Setting::Item("flexible"), "2 (consistently_linearised)");
        assert!(matches!(flight.get("nothing"), Err(FlightError::Unknown { .. })));
        assert!(flight.get("time").unwrap_err().to_string().contains("Flight::time has it"));
        let pitch = flight.get("trim.pitch").unwrap();
        assert_eq!(flight.set("airspeed", 90.0), Err(FlightError::Begun("airspeed".to_owned())));
        assert_eq!(flight.get("trim.pitch"), Ok(pitch));
    }

    #[test]
    fn a_flight_that_leaves_the_models_validity_stands_where_it_was() {
        let mut flight = rigid();
        flight.advance(0.1).unwrap();
        flight.set("wind_north", 1000.0).unwrap();
        assert!(matches!(flight.advance(1.0), Err(FlightError::Simulation(_))));
        assert!((flight.time() - 0.1).abs() < 1e-12);
        flight.set("wind_north", 0.0).unwrap();
        flight.advance(0.1).unwrap();
    }

    #[test]
    fn a_time_backwards_without_end_or_beyond_a_day_is_refused() {
        let mut flight = rigid();
        for duration in [-1.0, -1e-300, f64::NAN, f64::INFINITY, -f64::INFINITY, 86_401.0] {
            let refusal = format!("duration: found {duration} s, allowed is 0 to 86400 s, a day, at once");
            assert_eq!(flight.advance(duration).unwrap_err().to_string(), refusal);
        }
        assert_eq!((flight.advance(0.0), flight.time()), (Ok(()), 0.0));
    }

    #[test]
    fn parameters_and_inputs_read_as_they_were_set() {
        let mut flight = rigid();
        flight.set("inflow_states", 3).unwrap();
        flight.set("airspeed", 150.0).unwrap();
        flight.set("rudder", 0.01).unwrap();
        let values = ["model", "inflow_states", "airspeed", "rudder"].map(|name| flight.get(name).unwrap());
        assert_eq!(values, [5.0, 3.0, 150.0, 0.01]);
    }
}
