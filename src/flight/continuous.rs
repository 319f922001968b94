//! The motion as a function of states and inputs, for whoever integrates it by his own method or linearises it
//! [theory: continuous-model.states, continuous-model.devices].
//!
//! A thin map: states and inputs go to the whole plant, rates and outputs come back. Nothing is remembered but the last
//! evaluation, and nothing allocates after the beginning.

use nalgebra::Vector3;

use crate::equations::{Controls, Workspace};
use crate::math::euler_angle_rates;
use crate::plant::{Course, LimitExceeded, Plant, Trim, TrimPoint};
use crate::structure::ReducedModel;
use crate::symmetry::Plants;

use super::acting::Acting;
use super::continuous_settings;
use super::continuous_states::{ContinuousState, Place, StateMap};
use super::encounter::encounter;
use super::error::SimulationError;
use super::inputs::Inputs;
use super::instant::{Instant, Parts};
use super::moment::Moment;
use super::sensors::Sensors;
use super::settings::Settings;
use super::steering::Steering;

/// Cosine of a pitch angle at which roll and yaw can no longer be told apart.
const VERTICAL: f64 = 1e-6;

/// The motion of one aircraft from a trim on, at whatever states and inputs it is asked for.
///
/// ```
/// use flexible_aircraft::flight::{ContinuousModel, ContinuousState, Settings};
/// # use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?;
/// let mut motion = ContinuousModel::new(&jet, &Settings::of(&jet))?;
/// let place = |state| motion.states().iter().position(|other| *other == state).ok_or("no such state");
/// let (pitch, climb) = (place(ContinuousState::Attitude(1))?, place(ContinuousState::Position(2))?);
/// let mut x = motion.values().to_vec();
/// x[pitch] += 0.01; // rad: the nose goes up
/// motion.set_values(&x);
/// let rates = motion.rates(0.0)?;
/// assert!(rates[climb] < -1.2); // m/s: so does the aircraft
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct ContinuousModel {
    plant: Plant,
    course: Course,
    /// What the inputs add to; it has no past.
    steering: Steering,
    sensors: Sensors,
    trimmed: Trim,
    limits_exceeded: Vec<LimitExceeded>,
    states: Vec<ContinuousState>,
    map: StateMap,
    inputs: Inputs,
    /// Rates of the inputs: none.
    held: Inputs,
    /// x.
    values: Vec<f64>,
    /// What it is to the plant.
    state: Vec<f64>,
    acting: Acting,
    controls: Controls,
    workspace: Workspace,
    /// Of the plant's state.
    plant_rates: Vec<f64>,
    /// ẋ.
    rates: Vec<f64>,
    /// Whether rates and workspace are those of x and the inputs.
    is_evaluated: bool,
    instant: Instant,
    /// What of the instant is that of x and the inputs.
    written: Parts,
}

impl ContinuousModel {
    /// Trims the aircraft; x is that of the trim, inputs are zero.
    ///
    /// # Errors
    /// When a setting is out of range or not continuous, or no trim exists.
    pub fn new(model: &ReducedModel, settings: &Settings) -> Result<Self, SimulationError> {
        settings.check(model)?;
        continuous_settings::check(settings, model)?;
        let settings = &continuous_settings::in_use(settings, model);
        let along_course = settings.plant.along_course();
        let plants = Plants::under(model, &along_course)?;
        let found = plants.trim(&along_course.trim_condition())?;
        let (plant, trimmed) = (plants.whole().clone(), found.trims.whole().clone());
        let gust = encounter(model, settings, &plant, &trimmed);
        // The rest of a flight asks for the way of the air in a gust alone; here it is a state.
        let steering = Steering::new(&trimmed, settings, model);
        steering.check_trim(model)?;
        let plant = match gust {
            Some(gust) => plant.in_gust(&gust),
            None => plant,
        };
        let attitude = &trimmed.state[plant.layout().attitude()];
        let course = Course::new(settings.plant.heading).from(attitude);
        let sensors = Sensors::unsampled(model);
        let states = ContinuousState::all(model);
        let lags = |control| settings.actuators.get(control).lags();
        let map = StateMap::new(&states, &plant, (course, course.yaw_beyond(attitude)), lags);
        let acting = steering.at_rest().clone();
        let values = map.read((&trimmed.state, plant.layout()), &acting);
        let inputs = Inputs::zero(model);
        Ok(ContinuousModel {
            limits_exceeded: LimitExceeded::find(&model.limits, &plant, &trimmed),
            state: trimmed.state.clone(),
            controls: plant.neutral_controls(),
            workspace: plant.workspace(),
            plant_rates: vec![0.0; trimmed.state.len()],
            rates: vec![0.0; states.len()],
            instant: Instant::new(plant.room_for_outputs(), trimmed.point, sensors.count()),
            held: inputs.clone(),
            is_evaluated: false,
            written: Parts::default(),
            plant,
            course,
            steering,
            sensors,
            trimmed,
            states,
            map,
            inputs,
            values,
            acting,
        })
    }

    /// The trim.
    pub fn trim(&self) -> &TrimPoint {
        &self.trimmed.point
    }

    /// Where the trim is beyond the aircraft's limits.
    pub fn limits_exceeded(&self) -> &[LimitExceeded] {
        &self.limits_exceeded
    }

    /// What each number of x is.
    pub fn states(&self) -> &[ContinuousState] {
        &self.states
    }

    /// x.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Takes as many states as there are; what does not take part stays 0.
    pub fn set_values(&mut self, values: &[f64]) {
        for ((present, &value), place) in self.values.iter_mut().zip(values).zip(self.map.places()) {
            let value = if *place == Place::Resting { 0.0 } else { value };
            if present.to_bits() != value.to_bits() {
                *present = value;
                self.is_evaluated = false;
            }
        }
    }

    /// Takes inputs; the wind is what acts with its rate, and does not move on by it.
    pub fn set_inputs(&mut self, inputs: &Inputs) {
        if self.inputs != *inputs {
            self.inputs.clone_from(inputs);
            self.is_evaluated = false;
        }
    }

    /// By how much a number of x may depart for a difference that is exact to rounding.
    pub fn widths(&self) -> Vec<f64> {
        let speed = self.plant.speed_at(&self.trimmed);
        self.states.iter().map(|state| state.step(&self.plant, speed)).collect()
    }

    /// ẋ, per second; the time (s) stands in messages alone.
    ///
    /// # Errors
    /// When x is beyond the model's validity or has no finite rates.
    pub fn rates(&mut self, time: f64) -> Result<&[f64], SimulationError> {
        self.find_rates(time)?;
        Ok(&self.rates)
    }

    /// Finds ẋ and some parts of what is read there; the time (s) stands in messages alone.
    ///
    /// # Errors
    /// As of [`rates`](Self::rates).
    pub fn evaluate(&mut self, parts: Parts, time: f64) -> Result<(), SimulationError> {
        self.find_rates(time)?;
        self.write_instant(parts);
        Ok(())
    }

    /// What has been found last, ẋ, and x.
    pub fn latest(&self) -> (&Instant, &[f64], &[f64]) {
        (&self.instant, &self.rates, &self.values)
    }

    fn find_rates(&mut self, time: f64) -> Result<(), SimulationError> {
        if self.is_evaluated {
            return Ok(());
        }
        let pitch = self.states.iter().position(|state| *state == ContinuousState::Attitude(1));
        if !self.values.iter().all(|number| number.is_finite()) {
            return Err(SimulationError::NotFinite { time });
        }
        if let Some(pitch) = pitch.map(|place| self.values[place]).filter(|x| libm::cos(*x).abs() < VERTICAL)
        {
            return Err(SimulationError::Vertical { time, pitch });
        }
        let ContinuousModel { plant, map, state, acting, controls, steering, .. } = self;
        let drift = map.apply((&self.values, plant.layout()), state, acting);
        steering.set(&self.inputs, &self.held, Moment::START);
        steering.write_at(Moment::START, acting, controls);
        controls.air_travel = self.course.along(&drift);
        plant.rates(state, controls, &mut self.plant_rates, &mut self.workspace);
        if let Some(strip) = plant.reversed_strip(state, controls, &self.workspace) {
            let (strip, component) = (strip.number, strip.component.clone());
            return Err(SimulationError::ReverseFlow { time, strip, component });
        }
        self.write_rates();
        if !self.rates.iter().all(|rate| rate.is_finite()) {
            return Err(SimulationError::NotFinite { time });
        }
        (self.is_evaluated, self.written) = (true, Parts::default());
        Ok(())
    }

    /// ẋ from the plant's, and of what lags.
    fn write_rates(&mut self) {
        let ContinuousModel { plant, course, map, steering, acting, values, plant_rates, controls, .. } =
            self;
        let layout = plant.layout();
        let velocity = course.north_east_down(&Vector3::from_column_slice(&plant_rates[layout.position()]));
        let air = course.north_east_down(&plant.air_mass_velocity(controls));
        let mut angles = Vector3::zeros();
        for (place, &value) in map.places().iter().zip(values.iter()) {
            if let Place::Attitude(axis) = *place {
                angles[axis] = value;
            }
        }
        let turning = Vector3::from_column_slice(&self.state[layout.rate()]);
        let angle_rates = euler_angle_rates(&angles, &turning);
        for (rate, place) in self.rates.iter_mut().zip(map.places()) {
            *rate = match *place {
                Place::Position(axis) => velocity[axis],
                Place::Attitude(axis) => angle_rates[axis],
                Place::Plant(place) => plant_rates[place],
                Place::Drift(axis) => air[axis],
                Place::SurfaceAngle(control) => steering.linear_surface_rates(control, acting)[0],
                Place::SurfaceRate(control) => steering.linear_surface_rates(control, acting)[1],
                Place::Thrust(engine) => steering.linear_thrust_rate(engine, acting),
                Place::Resting => 0.0,
            };
        }
    }

    /// Writes what is not yet of the last evaluation.
    fn write_instant(&mut self, parts: Parts) {
        let ContinuousModel { plant, course, state, controls, workspace, instant, written, .. } = self;
        if parts.needs_outputs() && !written.usual {
            plant.write_usual_outputs(state, controls, workspace, *course, &mut instant.outputs);
            self.steering.write_actuators(Moment::START, &self.acting, &mut instant.actuators);
            for (state, &value) in self.states.iter().zip(&self.values) {
                match *state {
                    ContinuousState::Position(axis) => instant.outputs.position[axis] = value,
                    ContinuousState::Attitude(axis) => instant.outputs.attitude[axis] = value,
                    _ => {}
                }
            }
            written.usual = true;
        }
        if parts.further && !written.further {
            plant.write_further_outputs(state, workspace, *course, &mut instant.outputs);
            written.further = true;
        }
        if parts.section_loads && !written.section_loads {
            plant.write_loads(state, controls, workspace, &mut instant.outputs);
            written.section_loads = true;
        }
        if parts.sensors && !written.sensors {
            instant.write_sensors(Moment::START, &self.sensors);
            written.sensors = true;
        }
    }
}
