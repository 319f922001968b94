//! The inputs as functions of time: values and rates set at an instant, about the trim or absolute.
//!
//! [theory: integration.inputs, gusts.field]

use nalgebra::Vector3;

use crate::equations::Controls;
use crate::plant::{Course, TrimPoint};
use crate::structure::ReducedModel;
use crate::symmetry::Actions;

use super::inputs::Inputs;
use super::moment::Moment;
use super::settings::{InputReference, Settings};

/// What the inputs add to: the trim, or nothing.
#[derive(Clone, Debug)]
struct Reference {
    /// rad per control.
    angles: Vec<f64>,
    /// N per engine.
    thrust: f64,
}

/// What acts on the aircraft from the last setting of the inputs on.
#[derive(Clone, Debug)]
pub struct Steering {
    /// The trim, to which inputs may add.
    pub trim: TrimPoint,
    reference: Reference,
    /// The controls' wind is along it.
    course: Course,
    /// Values at the time they were set.
    pub inputs: Inputs,
    /// Per second.
    pub rates: Inputs,
    /// When they were set.
    pub(super) since: Moment,
    /// Along the course: how far the air had gone then, m.
    pub(super) air_travel: Vector3<f64>,
    /// Of a wind tunnel, along the course, m/s.
    tunnel_flow: Vector3<f64>,
    /// Whether what is frozen in the air blows in the mirror plane.
    gust_is_in_plane: bool,
}

impl Steering {
    /// Hands off, from the start on.
    pub fn new(trim: TrimPoint, settings: &Settings, model: &ReducedModel) -> Self {
        let (inputs, rates) = (Inputs::zero(model), Inputs::zero(model));
        let course = Course::new(settings.plant.heading);
        let point = match settings.input_reference {
            InputReference::Trim => trim,
            InputReference::Absolute => TrimPoint::default(),
        };
        let reference = Reference { angles: point.angles(&model.controls).collect(), thrust: point.thrust };
        let tunnel_flow = settings.plant.along_course().configuration(model.support).tunnel_flow;
        Steering {
            trim,
            reference,
            course,
            inputs,
            rates,
            since: Moment::START,
            air_travel: Vector3::zeros(),
            tunnel_flow,
            gust_is_in_plane: true,
        }
    }

    /// The same in a gust that blows in the mirror plane, or not.
    pub(super) fn in_gust(self, gust_is_in_plane: bool) -> Self {
        Steering { gust_is_in_plane, ..self }
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
        true
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
        let [wind, rate, change] = self.winds();
        [wind + (rate + change * (0.5 * elapsed)) * elapsed, rate + change * elapsed]
    }

    /// Along the course: how far the air has gone a time (s) after the inputs were set, m.
    fn air_travel_after(&self, elapsed: f64) -> Vector3<f64> {
        let [wind, rate, change] = self.winds();
        let mean = self.tunnel_flow + wind + (rate * 0.5 + change * (elapsed / 6.0)) * elapsed;
        self.air_travel + mean * elapsed
    }

    /// The absolute controls at a time.
    pub(super) fn write_at(&self, time: Moment, controls: &mut Controls) {
        self.write_after(time.since(self.since), controls);
    }

    /// The absolute controls a time (s) after the inputs were set.
    pub fn write_after(&self, elapsed: f64, controls: &mut Controls) {
        let Steering { inputs, rates, reference: Reference { angles, thrust }, .. } = self;
        let set = angles.iter().zip(&inputs.controls).zip(&rates.controls);
        for (acting, ((angle, input), rate)) in controls.angles.iter_mut().zip(set) {
            *acting = angle + input + elapsed * rate;
        }
        for ((acting, input), rate) in controls.thrust.iter_mut().zip(&inputs.thrust).zip(&rates.thrust) {
            *acting = thrust + input + elapsed * rate;
        }
        [controls.wind, controls.wind_rate] = self.winds_after(elapsed);
        controls.air_travel = self.air_travel_after(elapsed);
    }
}

impl Actions for Steering {
    fn angle(&self, control: usize) -> [f64; 2] {
        let Steering { inputs, rates, reference, .. } = self;
        [reference.angles[control] + inputs.controls[control], rates.controls[control]]
    }

    fn thrust(&self, engine: usize) -> [f64; 2] {
        let Steering { inputs, rates, reference, .. } = self;
        [reference.thrust + inputs.thrust[engine], rates.thrust[engine]]
    }

    fn winds(&self) -> [Vector3<f64>; 3] {
        let Steering { inputs, rates, course, .. } = self;
        // Each by itself, for the rounding of a sum may be more than a part of the sum.
        let [wind, given, input, change] =
            [inputs.wind, rates.wind, inputs.wind_rate, rates.wind_rate].map(|wind| course.along(&wind));
        [wind, given + input, change]
    }

    fn gust_is_in_plane(&self) -> bool {
        self.gust_is_in_plane
    }
}
