//! The linear model about a trim: ẋ = A x + B u + B′ u̇, y = C x + D u + D′ u̇ for small departures of states, inputs and
//! outputs.
//!
//! [theory: linearisation.inputs, linearisation.outputs, linearisation.wind-rates, linearisation.differences, linearisation.gusts]
//!
//! States are the unknowns of the [`StateMatrix`](super::StateMatrix), whose A it is, or those on which nothing depends too. Inputs are what acts on the aircraft:
//! angles of its controls, thrusts, the velocity of the air. Of these the air alone acts by its rate, too, for it drags the
//! apparent mass along. Which numbers are outputs is for who asks to say.

use std::borrow::Cow;
use std::sync::Arc;

use nalgebra::{DMatrix, Vector3};

use crate::air::{FrozenGust, ImposedGust, Track};
use crate::equations::{Controls, Workspace};

use super::course::Course;
use super::linearisation::{Unknown, UnknownsKept, derivatives};
use super::outputs::Outputs;
use super::system::Plant;
use super::trim::Trim;

/// Steps of the differences by inputs [theory: linearisation.differences]: of angles, rad.
const CONTROL_STEP: f64 = 1e-2;
/// Of thrusts, N.
const THRUST_STEP: f64 = 1e3;
/// Of the wind, parts of the airspeed.
const WIND_STEP: f64 = 1e-3;
/// Of its rate, m/s².
const WIND_RATE_STEP: f64 = 1.0;

/// An input of a linear model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum LinearInput {
    /// The angle of the control with this index, rad.
    Control(usize),
    /// Of the engine with this index, N.
    Thrust(usize),
    /// Velocity of the air, the same everywhere, towards north (0), east (1) or down (2), m/s.
    Wind(usize),
}

/// Matrices and trim values of a linear model, SI units.
///
/// ```
/// # use flexible_aircraft::equations::Fidelity;
/// # use flexible_aircraft::{Aircraft, plant::{Course, LinearInput, Plant, PlantSettings}};
/// # let jet = Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?;
/// let settings = PlantSettings { fidelity: Fidelity::Rigid, inflow_states: 0, ..PlantSettings::of(&jet) };
/// let plant = Plant::under(&jet, &settings)?;
/// let trim = plant.trim(&settings.trim_condition())?;
/// let model = plant.linear_model(&trim, Course::NORTH, |outputs| vec![outputs.load_factor.z, outputs.air.speed]);
/// let column = |input| model.inputs.iter().position(|other| *other == input).ok_or("no such input");
/// assert!(model.d[(0, column(LinearInput::Wind(2))?)] < -0.02); // air that sinks takes lift away, 1/(m/s)
/// assert!((model.d[(1, column(LinearInput::Wind(0))?)] + 1.0).abs() < 1e-6); // a tail wind takes airspeed away
/// assert_eq!(model.a, plant.linearise(&trim).matrix);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Linearisation {
    /// x: n of them.
    pub unknowns: Vec<Unknown>,
    /// u: controls, engines, then the air; m of them.
    pub inputs: Vec<LinearInput>,
    /// A, n × n.
    pub a: DMatrix<f64>,
    /// B, n × m.
    pub b: DMatrix<f64>,
    /// C, a row for each output.
    pub c: DMatrix<f64>,
    /// D, a row for each output.
    pub d: DMatrix<f64>,
    /// B′, n × m, zero but for the air.
    pub bd: DMatrix<f64>,
    /// D′, a row for each output, zero but for the air.
    pub dd: DMatrix<f64>,
    /// x of the trim.
    pub x0: Vec<f64>,
    /// u of the trim: what acts, in still air.
    pub u0: Vec<f64>,
    /// y of the trim.
    pub y0: Vec<f64>,
}

/// What the strengths of gusts do, SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct GustColumns {
    /// To the rates of the unknowns, a column for each gust.
    pub b: DMatrix<f64>,
    /// To the outputs, a column for each gust.
    pub d: DMatrix<f64>,
}

impl Plant {
    /// Linearises motion and outputs about a trim of this plant, which is of a whole aircraft, the axes of its states along a
    /// course. `read` gives the outputs: as many numbers each time, which do not jump; section loads are known. Allocates.
    pub fn linear_model(
        &self,
        trim: &Trim,
        course: Course,
        read: impl FnMut(&Outputs) -> Vec<f64>,
    ) -> Linearisation {
        self.linear_model_with(UnknownsKept::Felt, trim, course, read)
    }

    /// The same with the horizontal position and the yaw angle among the states, if all are to be kept.
    pub fn linear_model_with(
        &self,
        kept: UnknownsKept,
        trim: &Trim,
        course: Course,
        read: impl FnMut(&Outputs) -> Vec<f64>,
    ) -> Linearisation {
        let (unknowns, inputs) = (self.unknowns(kept), self.linear_inputs());
        let mut about = About::new(self, trim, course, &unknowns, read);
        let at_trim = about.rates_and_outputs(|_, _| {});
        let (states, rows) = (unknowns.len(), at_trim.len());
        let by_states = derivatives(rows, &self.steps(&unknowns, trim), |column, departure| {
            about.rates_and_outputs(|state, _| self.displace(unknowns[column], departure, state))
        });
        let speed = self.speed_at(trim);
        let steps: Vec<f64> = inputs.iter().map(|input| input.step(speed)).collect();
        let by_inputs = derivatives(rows, &steps, |column, departure| {
            about.rates_and_outputs(|_, controls| inputs[column].add(departure, course, controls))
        });
        let steps = vec![WIND_RATE_STEP; inputs.len()];
        let by_input_rates = derivatives(rows, &steps, |column, departure| {
            about.rates_and_outputs(|_, controls| inputs[column].add_rate(departure, course, controls))
        });
        let parts = |matrix: DMatrix<f64>| {
            (matrix.rows(0, states).into_owned(), matrix.rows(states, rows - states).into_owned())
        };
        let [(a, c), (b, d), (bd, dd)] = [by_states, by_inputs, by_input_rates].map(parts);
        Linearisation {
            a,
            b,
            c,
            d,
            bd,
            dd,
            x0: unknowns.iter().map(|&unknown| self.value_of(unknown, &trim.state)).collect(),
            u0: inputs.iter().map(|input| input.value(&trim.controls)).collect(),
            y0: at_trim[states..].to_vec(),
            unknowns,
            inputs,
        }
    }

    /// What gusts do that are frozen along a track, by their strength (m/s), at a trim of this plant, which is of a whole aircraft
    /// in still air; course and outputs as of [`linear_model`](Self::linear_model). Strengths are taken as directions. Allocates.
    ///
    /// [theory: linearisation.gusts]
    pub fn linear_gusts(
        &self,
        kept: UnknownsKept,
        trim: &Trim,
        course: Course,
        (track, gusts): (Track, &[ImposedGust]),
        read: impl FnMut(&Outputs) -> Vec<f64>,
    ) -> GustColumns {
        let unknowns = self.unknowns(kept);
        let mut about = About::new(self, trim, course, &unknowns, read);
        let (states, rows) = (unknowns.len(), about.rates_and_outputs(|_, _| {}).len());
        let steps = vec![WIND_STEP * self.speed_at(trim); gusts.len()];
        let columns = derivatives(rows, &steps, |column, departure| {
            let ImposedGust { wave, strength } = &gusts[column];
            let strength = strength.map(|strength| strength * departure);
            let gust = FrozenGust::imposed(track, ImposedGust { wave: wave.clone(), strength });
            about.plant.to_mut().equations.take_gust(Arc::new(gust));
            about.rates_and_outputs(|_, _| {})
        });
        GustColumns {
            b: columns.rows(0, states).into_owned(),
            d: columns.rows(states, rows - states).into_owned(),
        }
    }

    /// What acts.
    fn linear_inputs(&self) -> Vec<LinearInput> {
        let controls = (0..self.controls().len()).map(LinearInput::Control);
        let thrusts = (0..self.engine_count()).map(LinearInput::Thrust);
        controls.chain(thrusts).chain((0..3).map(LinearInput::Wind)).collect()
    }
}

impl LinearInput {
    /// Step of the differences at an airspeed, m/s.
    fn step(self, speed: f64) -> f64 {
        match self {
            LinearInput::Control(_) => CONTROL_STEP,
            LinearInput::Thrust(_) => THRUST_STEP,
            LinearInput::Wind(_) => WIND_STEP * speed,
        }
    }

    /// Adds a departure to what acts, in axes along a course.
    fn add(self, departure: f64, course: Course, controls: &mut Controls) {
        match self {
            LinearInput::Control(control) => controls.angles[control] += departure,
            LinearInput::Thrust(engine) => controls.thrust[engine] += departure,
            LinearInput::Wind(axis) => controls.wind += course.along(&Vector3::ith(axis, departure)),
        }
    }

    /// Adds a departure to its rate, where that acts.
    fn add_rate(self, departure: f64, course: Course, controls: &mut Controls) {
        if let LinearInput::Wind(axis) = self {
            controls.wind_rate += course.along(&Vector3::ith(axis, departure));
        }
    }

    /// What acts of it; still air of the wind.
    fn value(self, controls: &Controls) -> f64 {
        match self {
            LinearInput::Control(control) => controls.angles[control],
            LinearInput::Thrust(engine) => controls.thrust[engine],
            LinearInput::Wind(_) => 0.0,
        }
    }
}

/// A plant about a trim.
struct About<'p, R> {
    plant: Cow<'p, Plant>,
    trim: &'p Trim,
    course: Course,
    unknowns: &'p [Unknown],
    read: R,
    rates: Vec<f64>,
    outputs: Outputs,
    workspace: Workspace,
}

impl<'p, R: FnMut(&Outputs) -> Vec<f64>> About<'p, R> {
    fn new(plant: &'p Plant, trim: &'p Trim, course: Course, unknowns: &'p [Unknown], read: R) -> Self {
        let (rates, outputs) = (vec![0.0; trim.state.len()], plant.room_for_outputs());
        let workspace = plant.workspace();
        About { plant: Cow::Borrowed(plant), trim, course, unknowns, read, rates, outputs, workspace }
    }

    /// The rates of the unknowns, then the outputs, where state and controls depart from the trim.
    fn rates_and_outputs(&mut self, depart: impl FnOnce(&mut [f64], &mut Controls)) -> Vec<f64> {
        let About { plant, trim, course, unknowns, read, rates, outputs, workspace } = self;
        let (mut state, mut controls) = (trim.state.clone(), trim.controls.clone());
        depart(&mut state, &mut controls);
        plant.rates(&state, &controls, rates, workspace);
        plant.write_outputs(&state, &controls, workspace, *course, outputs);
        plant.write_loads(&state, &controls, workspace, outputs);
        let rates = unknowns.iter().map(|&unknown| plant.rate_of(unknown, &state, rates));
        rates.chain(read(outputs)).collect()
    }
}
