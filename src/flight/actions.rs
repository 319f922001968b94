//! What acts from an instant on, as it tells whether half the aircraft may fly [theory: actuators.symmetry].

use nalgebra::Vector3;

use crate::devices::{Actuator, Command};
use crate::symmetry::{Actions, Motion};

use super::acting::Acting;
use super::steering::Steering;

/// What is asked for, and how what lags stands at an instant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Acts<'a> {
    steering: &'a Steering,
    acting: &'a Acting,
}

impl<'a> Acts<'a> {
    pub fn new(steering: &'a Steering, acting: &'a Acting) -> Self {
        Acts { steering, acting }
    }

    /// What does not lag and will not change counts as its limits leave it.
    fn at_once(asked: Command, limited: f64) -> Motion {
        let value = if asked.rate == 0.0 { limited } else { asked.value };
        Motion { values: [value, value, 0.0], rate: asked.rate }
    }
}

impl Actions for Acts<'_> {
    fn are_direct(&self) -> bool {
        self.steering.is_direct()
    }

    fn angle(&self, control: usize) -> Motion {
        let (asked, actuator) = (self.steering.angle_asked(control, 0.0), self.steering.actuators[control]);
        if !actuator.lags() {
            return Acts::at_once(asked, actuator.at_once(asked).angle);
        }
        let surface = self.acting.surfaces[control];
        Motion { values: [surface.angle, asked.value, surface.rate / actuator.frequency], rate: asked.rate }
    }

    fn thrust(&self, engine: usize) -> Motion {
        let (asked, lag) = (self.steering.thrust_asked(engine, 0.0), self.steering.engines[engine]);
        if !lag.lags() {
            return Acts::at_once(asked, lag.at_once(asked).value);
        }
        Motion { values: [self.acting.thrusts[engine], asked.value, 0.0], rate: asked.rate }
    }

    fn lag(&self) -> bool {
        self.steering.lags()
    }

    fn controls_move_alike(&self, terms: &[(usize, f64)]) -> bool {
        let actuator = |control: usize| &self.steering.actuators[control];
        let are_equal = terms.windows(2).all(|pair| actuator(pair[0].0) == actuator(pair[1].0));
        // One that has to rest at 0, and whose command does, rests.
        are_equal && (terms.len() == 1 || limits_are_alike(terms, actuator(terms[0].0)))
    }

    fn engines_move_alike(&self, engine: usize, image: usize) -> bool {
        self.steering.engines[engine] == self.steering.engines[image]
    }

    fn winds(&self) -> [Vector3<f64>; 3] {
        self.steering.winds()
    }

    fn gust_is_in_plane(&self) -> bool {
        self.steering.gust_is_in_plane()
    }
}

/// Whether the limits of equal actuators never part controls whose angles, times factors, cancel.
fn limits_are_alike(terms: &[(usize, f64)], actuator: &Actuator) -> bool {
    let is_even = actuator.minimum == -actuator.maximum;
    actuator.is_unlimited()
        || matches!(*terms, [(_, one), (_, other)] if one == -other || (one == other && is_even))
}
