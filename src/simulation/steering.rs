//! The inputs as functions of time: values and rates set at an instant, about the trim or absolute.

use crate::dynamics::{Controls, TrimPoint};

use super::course::Course;
use super::{InputReference, Inputs, Settings};

/// What acts on the aircraft from the last setting of the inputs on.
#[derive(Clone, Debug)]
pub struct Steering {
    /// The trim, to which inputs may add.
    pub trim: TrimPoint,
    reference: InputReference,
    /// The controls' wind is along it.
    course: Course,
    /// Values at the time they were set.
    pub inputs: Inputs,
    /// Per second.
    pub rates: Inputs,
    /// When they were set, s.
    pub since: f64,
}

impl Steering {
    /// Hands off, from a time (s) on.
    pub fn new(trim: TrimPoint, settings: &Settings, engines: usize, since: f64) -> Self {
        let (inputs, rates) = (Inputs::zero(engines), Inputs::zero(engines));
        let course = Course::new(settings.heading);
        Steering { trim, reference: settings.input_reference, course, inputs, rates, since }
    }

    /// Sets inputs and rates at a time (s); returns whether that changes anything.
    pub fn set(&mut self, inputs: &Inputs, rates: &Inputs, time: f64) -> bool {
        if self.inputs == *inputs && self.rates.is_zero() && rates.is_zero() {
            return false;
        }
        self.inputs.clone_from(inputs);
        self.rates.clone_from(rates);
        self.since = time;
        true
    }

    /// Whether everything acts alike on both sides, and will; `images` has the mirror image of each engine.
    pub fn is_symmetric(&self, images: &[usize]) -> bool {
        [&self.inputs, &self.rates].into_iter().all(|inputs| {
            let mut engines = images.iter().enumerate();
            inputs.aileron == 0.0
                && inputs.rudder == 0.0
                && self.course.along(&inputs.wind).y == 0.0
                && engines.all(|(engine, &image)| inputs.thrust[engine] == inputs.thrust[image])
        })
    }

    /// The absolute controls at a time (s).
    pub fn write(&self, time: f64, controls: &mut Controls) {
        let Steering { trim, inputs, rates, course, .. } = self;
        let elapsed = time - self.since;
        let TrimPoint { elevator, aileron, rudder, thrust, .. } = match self.reference {
            InputReference::Trim => *trim,
            InputReference::Absolute => TrimPoint::default(),
        };
        controls.elevator = elevator + inputs.elevator + elapsed * rates.elevator;
        controls.aileron = aileron + inputs.aileron + elapsed * rates.aileron;
        controls.aileron_symmetric = inputs.aileron_symmetric + elapsed * rates.aileron_symmetric;
        controls.rudder = rudder + inputs.rudder + elapsed * rates.rudder;
        for ((acting, input), rate) in controls.thrust.iter_mut().zip(&inputs.thrust).zip(&rates.thrust) {
            *acting = thrust + input + elapsed * rate;
        }
        controls.wind = course.along(&(inputs.wind + rates.wind * elapsed));
        controls.wind_rate = course.along(&rates.wind);
    }
}
