//! The inputs as functions of time, values and rates set at an instant, about the trim or absolute, and what acts by them.
//!
//! [theory: integration.inputs, gusts.field, actuators.command]

use nalgebra::Vector3;

use crate::devices::{Actuator, Command, EngineLag, Surface};
use crate::equations::Controls;
use crate::plant::{Course, Trim, TrimPoint};
use crate::structure::ReducedModel;

use super::acting::{Acting, ActuatorReading};
use super::error::SimulationError;
use super::inputs::Inputs;
use super::moment::Moment;
use super::settings::{InputReference, Settings};

/// How what acts follows what is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Following {
    /// It is that.
    Directly,
    /// It is that within limits.
    WithinLimits,
    /// Some of it lags.
    Later,
}

/// What the inputs add to: the trim, or nothing.
#[derive(Clone, Debug)]
struct Reference {
    /// rad per control.
    angles: Vec<f64>,
    /// N, one per engine.
    thrusts: Vec<f64>,
}

/// What acts on the aircraft from the last setting of the inputs on.
#[derive(Clone, Debug)]
pub struct Steering {
    /// The trim, to which inputs may add.
    pub trim: TrimPoint,
    reference: Reference,
    /// The controls' wind is along it.
    course: Course,
    /// Along the course: the wind when it was set, m/s, its rate, m/s², and the rate of that, m/s³.
    winds: [Vector3<f64>; 3],
    /// Values at the time they were set.
    pub inputs: Inputs,
    /// Per second.
    pub rates: Inputs,
    /// When they were set.
    pub(super) since: Moment,
    /// Along the course: how far the air had gone then, m; of account in a gust alone.
    pub(super) air_travel: Vector3<f64>,
    /// Of a wind tunnel, along the course, m/s.
    tunnel_flow: Vector3<f64>,
    /// Whether what is frozen in the air blows in the mirror plane; none where nothing is.
    gust_is_in_plane: Option<bool>,
    following: Following,
    /// One per control.
    pub(super) actuators: Vec<Actuator>,
    /// One per engine.
    pub(super) engines: Vec<EngineLag>,
    /// At the trim.
    at_rest: Acting,
}

impl Following {
    fn of(actuators: &[Actuator], engines: &[EngineLag]) -> Self {
        if actuators.iter().any(Actuator::lags) || engines.iter().any(EngineLag::lags) {
            Following::Later
        } else if actuators.iter().all(Actuator::is_direct) && engines.iter().all(EngineLag::is_direct) {
            Following::Directly
        } else {
            Following::WithinLimits
        }
    }
}

impl Steering {
    /// Hands off, from the start on.
    pub fn new(trim: &Trim, settings: &Settings, model: &ReducedModel) -> Self {
        let (inputs, rates) = (Inputs::zero(model), Inputs::zero(model));
        let course = Course::new(settings.plant.heading);
        let share = match settings.input_reference {
            InputReference::Trim => 1.0,
            InputReference::Absolute => 0.0,
        };
        let angles: Vec<f64> = trim.point.angles(&model.controls).collect();
        let thrusts = &trim.controls.thrust;
        let part = |values: &[f64]| values.iter().map(|value| share * value).collect();
        let reference = Reference { angles: part(&angles), thrusts: part(thrusts) };
        let tunnel_flow = settings.plant.along_course().configuration(model.support).tunnel_flow;
        let surfaces = angles.iter().map(|&angle| Surface { angle, rate: 0.0 });
        let actuators: Vec<Actuator> =
            (0..model.controls.len()).map(|control| settings.actuators.get(control)).collect();
        let failed = settings.plant.condition.manoeuvre().failed_engine;
        let engine = |number: usize| match settings.engines.get(number) {
            // One that has failed gives nothing, whatever those that run must give.
            lag if failed == Some(number) => lag.with_zero(),
            lag => lag,
        };
        let engines: Vec<EngineLag> = (0..model.engines.len()).map(engine).collect();
        Steering {
            trim: trim.point,
            reference,
            course,
            winds: [Vector3::zeros(); 3],
            inputs,
            rates,
            since: Moment::START,
            air_travel: Vector3::zeros(),
            tunnel_flow,
            gust_is_in_plane: None,
            following: Following::of(&actuators, &engines),
            actuators,
            engines,
            at_rest: Acting { surfaces: surfaces.collect(), thrusts: thrusts.clone() },
        }
    }

    /// The same in a gust that blows in the mirror plane, or not, if there is one.
    pub(super) fn in_gust(self, gust_is_in_plane: Option<bool>) -> Self {
        Steering { gust_is_in_plane, ..self }
    }

    /// That the trim is within what actuators and engines can give [theory: actuators.trim].
    ///
    /// # Errors
    /// Names the first limit that it is beyond.
    pub(super) fn check_trim(&self, model: &ReducedModel) -> Result<(), SimulationError> {
        let surfaces = self.at_rest.surfaces.iter().map(|surface| surface.angle);
        let controls = model.controls.iter().map(|control| ("actuator", &control.name, "rad"));
        let surfaces = controls.zip(surfaces).zip(self.actuators.iter().map(Actuator::stops));
        let engines = model.engines.iter().map(|engine| ("engine", &engine.name, "N"));
        let thrusts = self.at_rest.thrusts.iter().copied();
        let engines = engines.zip(thrusts).zip(self.engines.iter().map(EngineLag::limits));
        for (((kind, name, unit), needed), [minimum, maximum]) in surfaces.chain(engines) {
            let (which, found) = if needed < minimum { ("minimum", minimum) } else { ("maximum", maximum) };
            if !(minimum..=maximum).contains(&needed) {
                let (part, limit) = (format!("{kind} {name}"), format!("{kind}.{name}.{which}"));
                return Err(SimulationError::BeyondLimit { part, needed, limit, found, unit });
            }
        }
        Ok(())
    }

    /// How actuators and engines stand at the trim.
    pub(super) fn at_rest(&self) -> &Acting {
        &self.at_rest
    }

    /// Sets inputs and rates at a time; returns whether that changes anything.
    pub(super) fn set(&mut self, inputs: &Inputs, rates: &Inputs, time: Moment) -> bool {
        let is_steady = self.rates.is_zero() && rates.is_zero() && inputs.wind_rate == Vector3::zeros();
        if is_steady && self.inputs == *inputs {
            return false;
        }
        self.air_travel = self.air_travel_after(time.since(self.since));
        self.inputs.clone_from(inputs);
        self.rates.clone_from(rates);
        self.since = time;
        self.know_winds();
        true
    }

    /// Finds the winds along the course from the inputs.
    pub(super) fn know_winds(&mut self) {
        let Steering { inputs, rates, course, .. } = self;
        // Each by itself, for the rounding of a sum may be more than a part of the sum.
        let [wind, given, input, change] =
            [inputs.wind, rates.wind, inputs.wind_rate, rates.wind_rate].map(|wind| course.along(&wind));
        self.winds = [wind, given + input, change];
    }

    /// Writes the inputs as they stand at a time: what was set, and what its rates have made of it.
    pub(super) fn write_inputs(&self, time: Moment, inputs: &mut Inputs) {
        inputs.clone_from(&self.inputs);
        inputs.ramp(time.since(self.since), &self.rates);
    }

    /// Whether all inputs are numbers until a time.
    pub(super) fn is_finite_until(&self, time: Moment) -> bool {
        let elapsed = time.since(self.since);
        let mut values = self.inputs.values().zip(self.rates.values());
        values.all(|(value, rate)| (value + elapsed * rate).is_finite())
            && self.winds_after(elapsed).iter().all(|wind| wind.iter().all(|number| number.is_finite()))
    }

    /// Along the course: the wind a time (s) after it was set, m/s, and its rate, m/s².
    fn winds_after(&self, elapsed: f64) -> [Vector3<f64>; 2] {
        let [wind, rate, change] = self.winds;
        [wind + (rate + change * (0.5 * elapsed)) * elapsed, rate + change * elapsed]
    }

    /// Along the course: how far the air has gone a time (s) after the inputs were set, m.
    fn air_travel_after(&self, elapsed: f64) -> Vector3<f64> {
        if self.gust_is_in_plane.is_none() {
            return self.air_travel;
        }
        let [wind, rate, change] = self.winds;
        let mean = self.tunnel_flow + wind + (rate * 0.5 + change * (elapsed / 6.0)) * elapsed;
        self.air_travel + mean * elapsed
    }

    /// What is asked of a control a time (s) after the inputs were set.
    pub(super) fn angle_asked(&self, control: usize, elapsed: f64) -> Command {
        let Steering { inputs, rates, reference, .. } = self;
        let rate = rates.controls[control];
        Command { value: reference.angles[control] + inputs.controls[control] + elapsed * rate, rate }
    }

    /// What is asked of an engine a time (s) after the inputs were set.
    pub(super) fn thrust_asked(&self, engine: usize, elapsed: f64) -> Command {
        let Steering { inputs, rates, reference, .. } = self;
        let rate = rates.thrust[engine];
        Command { value: reference.thrusts[engine] + inputs.thrust[engine] + elapsed * rate, rate }
    }

    /// Along the course, m/s, m/s², m/s³.
    pub(super) fn winds(&self) -> [Vector3<f64>; 3] {
        self.winds
    }

    /// Whether any actuator or engine lags.
    pub(super) fn lags(&self) -> bool {
        self.following == Following::Later
    }

    /// Whether what acts is what is asked for.
    pub(super) fn is_direct(&self) -> bool {
        self.following == Following::Directly
    }

    /// Whether what is frozen in the air, if anything is, blows in the mirror plane.
    pub(super) fn gust_is_in_plane(&self) -> bool {
        self.gust_is_in_plane != Some(false)
    }

    /// What acts at a time at which what lags is there.
    pub(super) fn write_at(&self, time: Moment, acting: &Acting, controls: &mut Controls) {
        let elapsed = time.since(self.since);
        self.write(
            elapsed,
            controls,
            |control| acting.surfaces[control].angle,
            |engine| acting.thrusts[engine],
        );
    }

    /// What acts a time (s) after a point, where what lags was there; both times (s) are counted from when the inputs were set,
    /// too.
    pub(super) fn write_after(
        &self,
        (time, set_before, elapsed): (f64, f64, f64),
        from: &Acting,
        controls: &mut Controls,
    ) {
        let surface = |control| self.surface_after(control, (time, set_before), from).angle;
        let thrust = |engine| self.thrust_after(engine, (time, set_before), from);
        self.write(elapsed, controls, surface, thrust);
    }

    /// What acts a time (s) after the inputs were set: what lags is where it is, the rest what is asked for.
    fn write(
        &self,
        elapsed: f64,
        controls: &mut Controls,
        lagging_angle: impl Fn(usize) -> f64,
        lagging_thrust: impl Fn(usize) -> f64,
    ) {
        [controls.wind, controls.wind_rate] = self.winds_after(elapsed);
        controls.air_travel = self.air_travel_after(elapsed);
        if self.is_direct() {
            for (control, angle) in controls.angles.iter_mut().enumerate() {
                *angle = self.angle_asked(control, elapsed).value;
            }
            for (engine, thrust) in controls.thrust.iter_mut().enumerate() {
                *thrust = self.thrust_asked(engine, elapsed).value;
            }
            return;
        }
        for (control, (angle, actuator)) in controls.angles.iter_mut().zip(&self.actuators).enumerate() {
            *angle = if actuator.lags() {
                lagging_angle(control)
            } else {
                actuator.at_once(self.angle_asked(control, elapsed)).angle
            };
        }
        for (engine, (thrust, lag)) in controls.thrust.iter_mut().zip(&self.engines).enumerate() {
            *thrust = if lag.lags() {
                lagging_thrust(engine)
            } else {
                lag.at_once(self.thrust_asked(engine, elapsed)).value
            };
        }
    }

    /// Has what lags move on over a time (s) from a point, the inputs set so much (s) before it.
    pub(super) fn move_on(&self, times: (f64, f64), from: &Acting, to: &mut Acting) {
        if !self.lags() {
            return;
        }
        for (control, surface) in
            to.surfaces.iter_mut().enumerate().filter(|(c, _)| self.actuators[*c].lags())
        {
            *surface = self.surface_after(control, times, from);
        }
        for (engine, thrust) in to.thrusts.iter_mut().enumerate().filter(|(e, _)| self.engines[*e].lags()) {
            *thrust = self.thrust_after(engine, times, from);
        }
    }

    fn surface_after(&self, control: usize, (time, set_before): (f64, f64), from: &Acting) -> Surface {
        let asked = self.angle_asked(control, set_before);
        self.actuators[control].after(from.surfaces[control], asked, time)
    }

    fn thrust_after(&self, engine: usize, (time, set_before): (f64, f64), from: &Acting) -> f64 {
        self.engines[engine].after(from.thrusts[engine], self.thrust_asked(engine, set_before), time)
    }

    /// Writes what the actuators do at a time.
    pub(super) fn write_actuators(&self, time: Moment, acting: &Acting, readings: &mut [ActuatorReading]) {
        if self.is_direct() {
            for (reading, rate) in readings.iter_mut().zip(&self.rates.controls) {
                *reading = ActuatorReading { rate: *rate, ..ActuatorReading::AT_REST };
            }
            return;
        }
        let elapsed = time.since(self.since);
        for (control, (reading, actuator)) in readings.iter_mut().zip(&self.actuators).enumerate() {
            let (asked, surface) = (self.angle_asked(control, elapsed), acting.surfaces[control]);
            let rate = if actuator.lags() { surface.rate } else { actuator.at_once(asked).rate };
            *reading = ActuatorReading { rate, holding: actuator.holding(surface, asked) };
        }
    }

    /// Rates of angle and rate of a surface without limits, rad/s and rad/s², under what is asked of it when the inputs were set;
    /// 0 where it does not lag [theory: actuators.motion].
    pub(super) fn linear_surface_rates(&self, control: usize, acting: &Acting) -> [f64; 2] {
        let Actuator { frequency, damping, .. } = self.actuators[control];
        if !self.actuators[control].lags() {
            return [0.0; 2];
        }
        let Surface { angle, rate } = acting.surfaces[control];
        let asked = self.angle_asked(control, 0.0).value;
        [rate, frequency * (frequency * (asked - angle) - 2.0 * damping * rate)]
    }

    /// The same of a thrust, N/s [theory: actuators.engines].
    pub(super) fn linear_thrust_rate(&self, engine: usize, acting: &Acting) -> f64 {
        let lag = self.engines[engine];
        if !lag.lags() {
            return 0.0;
        }
        (self.thrust_asked(engine, 0.0).value - acting.thrusts[engine]) / lag.time_constant
    }

    /// The numbers of what lags, for a snapshot.
    pub(super) fn lagging<'a>(&'a self, acting: &'a Acting) -> impl Iterator<Item = f64> + 'a {
        let surfaces = acting.surfaces.iter().zip(&self.actuators).filter(|(_, actuator)| actuator.lags());
        let thrusts = acting.thrusts.iter().zip(&self.engines).filter(|(_, engine)| engine.lags());
        let surfaces = surfaces.flat_map(|(surface, _)| [surface.angle, surface.rate]);
        surfaces.chain(thrusts.map(|(thrust, _)| *thrust))
    }

    /// Takes numbers that [`lagging`](Self::lagging) has given.
    pub(super) fn take_lagging(&self, acting: &mut Acting, mut next: impl FnMut() -> f64) {
        let surfaces = acting.surfaces.iter_mut().zip(&self.actuators);
        for (surface, _) in surfaces.filter(|(_, actuator)| actuator.lags()) {
            *surface = Surface { angle: next(), rate: next() };
        }
        for (thrust, _) in acting.thrusts.iter_mut().zip(&self.engines).filter(|(_, engine)| engine.lags()) {
            *thrust = next();
        }
    }
}
