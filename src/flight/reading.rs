//! What is read of a flight where it stands, by its user and by its sensors.

use crate::equations::Controls;
use crate::plant::Outputs;

use super::actions::Acts;
use super::evaluation::refresh;
use super::inputs::Inputs;
use super::instant::{Freshness, Instant};
use super::point::Point;
use super::simulation::Simulation;
use super::steering::Steering;

impl Simulation {
    /// The outputs at the present time under the present inputs, without allocating.
    pub fn outputs(&mut self) -> &Outputs {
        &self.instant().outputs
    }

    /// All that is read at the present time under the present inputs, without allocating.
    pub fn instant(&mut self) -> &Instant {
        self.usual_instant();
        if self.instant_is == Freshness::Usual {
            let Simulation { flying, path, course, sensors, instant, .. } = self;
            let (plant, _) = flying.active();
            plant.write_further_outputs(&path.present.state, *course, &mut instant.outputs);
            instant.write_sensors(path.present.time, sensors);
            self.instant_is = Freshness::Complete;
        }
        &self.instant
    }

    /// What control laws read of that at every step; path, placements of stations, quaternions, the load factor at the centre of
    /// mass, the calibrated airspeed and the channels of sensors are those of some instant before.
    pub(crate) fn usual_instant(&mut self) -> &Instant {
        if self.instant_is == Freshness::Stale {
            self.instant_is = self.write_outputs();
            let Simulation { path, steering, sensors, instant, .. } = self;
            instant.write_actuators(path.present.time, steering, &path.present.acting);
            if self.instant_is == Freshness::Complete {
                instant.write_sensors(path.present.time, sensors);
            }
        }
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
    fn write_outputs(&mut self) -> Freshness {
        let stays = self.plant_stays();
        let Simulation { flying, path, steering, controls, evaluated_in, course, instant, .. } = self;
        let outputs = &mut instant.outputs;
        if stays {
            let (mut plant, _) = flying.active();
            refresh(&mut path.present, &mut plant, steering, controls, evaluated_in);
            plant.write_usual_outputs(&path.present.state, controls, *course, outputs);
            Freshness::Usual
        } else {
            let Point { time, state, acting, .. } = &path.present;
            steering.write_at(*time, acting, controls);
            flying.write_outputs_under(&Acts::new(steering, acting), state, controls, *course, outputs);
            Freshness::Complete
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
