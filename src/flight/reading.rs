//! What is read of a flight where it stands, by its user and by its sensors.

use crate::equations::Controls;
use crate::plant::Outputs;

use super::actions::Acts;
use super::evaluation::refresh;
use super::inputs::Inputs;
use super::instant::{Freshness, Instant, Parts};
use super::point::Point;
use super::simulation::Simulation;
use super::steering::Steering;

/// Which outputs have been written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Written {
    /// What control laws read at every step.
    Usual,
    /// All but section loads.
    All,
}

impl Simulation {
    /// The outputs at the present time under the present inputs, without allocating.
    pub fn outputs(&mut self) -> &Outputs {
        &self.instant_of(Parts::OUTPUTS).outputs
    }

    /// All that is read at the present time under the present inputs, without allocating.
    pub fn instant(&mut self) -> &Instant {
        self.instant_of(Parts::INSTANT)
    }

    /// The same of some parts, with no more work than they take; other parts may be those of some instant before, and the
    /// calibrated airspeed may be 0. Which part an output is in says [`OutputSlot::part`](crate::variables::OutputSlot::part).
    pub fn instant_of(&mut self, parts: Parts) -> &Instant {
        if parts.section_loads {
            return self.instant_with_loads();
        }
        let mut fresh = self.instant_is.parts();
        let mirrors_outputs = parts.sensors && !self.sensors.are_sampled();
        if (parts.usual || parts.further || mirrors_outputs) && !fresh.usual {
            (fresh.usual, fresh.further) = (true, self.write_outputs() == Written::All);
            let Simulation { path, steering, instant, .. } = self;
            instant.write_actuators(path.present.time, steering, &path.present.acting);
        }
        let Simulation { flying, path, course, sensors, instant, .. } = self;
        if parts.further && !fresh.further {
            let (plant, _) = flying.active();
            plant.write_further_outputs(&path.present.state, *course, &mut instant.outputs);
            fresh.further = true;
        }
        if parts.sensors && !fresh.sensors {
            instant.write_sensors(path.present.time, sensors);
            fresh.sensors = true;
        }
        self.instant_is = Freshness::Of(fresh);
        &self.instant
    }

    /// The outputs as they would be at the present time and state under other inputs. Allocates.
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use flexible_aircraft::flight::{Inputs, Settings, Simulation};
    /// # let jet = Arc::new(flexible_aircraft::Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?);
    /// let flight = Simulation::new(Arc::clone(&jet), &Settings::of(&jet), 0.0)?;
    /// let still = Inputs::zero(&jet);
    /// let mut gust = still.clone();
    /// gust.wind.z = -3.0; // m/s: the air rises
    /// let [now, then] = [&still, &gust].map(|inputs| flight.outputs_under(inputs, &still));
    /// assert!(then.load_factor.z > now.load_factor.z);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn outputs_under(&self, inputs: &Inputs, rates: &Inputs) -> Outputs {
        self.instant_under(inputs, rates).outputs
    }

    /// All that is read as it would be at the present time and state under other inputs. What lags is part of the state.
    /// Allocates.
    pub fn instant_under(&self, inputs: &Inputs, rates: &Inputs) -> Instant {
        let Simulation { flying, course, sensors, .. } = self;
        let Point { time, state, acting, .. } = &self.path.present;
        let (steering, controls) = self.acting_under(inputs, rates);
        let outputs = flying.outputs_under(&Acts::new(&steering, acting), state, &controls, *course);
        let mut instant = Instant::new(outputs, self.trimmed.point, sensors.count());
        instant.write_devices(*time, (&steering, acting), sensors);
        instant
    }

    /// What would act at the present time under other inputs.
    pub(super) fn acting_under(&self, inputs: &Inputs, rates: &Inputs) -> (Steering, Controls) {
        let Point { time, acting, .. } = &self.path.present;
        let (mut steering, mut controls) = (self.steering.clone(), self.controls.clone());
        steering.set(inputs, rates, *time);
        steering.write_at(*time, acting, &mut controls);
        (steering, controls)
    }

    /// Writes the outputs at the present under the present inputs; returns what has been written.
    fn write_outputs(&mut self) -> Written {
        let stays = self.plant_stays();
        let Simulation { flying, path, steering, controls, evaluated_in, course, instant, .. } = self;
        let outputs = &mut instant.outputs;
        if stays {
            let (mut plant, _) = flying.active();
            refresh(&mut path.present, &mut plant, steering, controls, evaluated_in);
            plant.write_usual_outputs(&path.present.state, controls, *course, outputs);
            Written::Usual
        } else {
            let Point { time, state, acting, .. } = &path.present;
            steering.write_at(*time, acting, controls);
            flying.write_outputs_under(&Acts::new(steering, acting), state, controls, *course, outputs);
            Written::All
        }
    }

    /// Samples the sensors where it is time, before an input that is set now acts.
    pub(super) fn take_samples(&mut self) {
        let now = self.path.present.time;
        if self.sensors.sample_at(now) {
            self.instant_is = Freshness::Stale;
            self.write_outputs();
            self.sensors.take(now, &self.instant.outputs);
        }
    }
}
