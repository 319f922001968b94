//! Section loads of a flight, for who asks for them [theory: section-loads.summation].

use crate::strips::Resultant;

use super::inputs::Inputs;
use super::instant::Instant;
use super::simulation::Simulation;

impl Simulation {
    /// All that is read at the present time under the present inputs, section loads among it, without allocating.
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use flexible_aircraft::flight::{Settings, Simulation};
    /// # let jet = Arc::new(flexible_aircraft::Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?);
    /// let mut flight = Simulation::new(Arc::clone(&jet), &Settings::of(&jet), 0.0)?;
    /// assert!(flight.outputs().loads.known().is_none());
    /// let loads = flight.instant_with_loads().outputs.loads.known().ok_or("asked for")?;
    /// let lift: f64 = jet.cuts.iter().zip(loads).filter(|(cut, _)| cut.name.starts_with("wing_root")).map(|(_, l)| l.shear).sum();
    /// let weight = jet.integrals.mass * jet.gravity;
    /// assert!((0.6..0.8).contains(&(lift / weight))); // of what flies, the wings carry all but themselves
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn instant_with_loads(&mut self) -> &Instant {
        if self.instant().outputs.loads.known().is_none() {
            // The controls are those of the outputs.
            let Simulation { flying, path, controls, instant, .. } = self;
            flying.write_loads(&path.present.state, controls, &mut instant.outputs);
        }
        &self.instant
    }

    /// What the air does to each strip at the present time under the present inputs, in the order of the model's strips. Allocates.
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use flexible_aircraft::flight::{Settings, Simulation};
    /// # let jet = Arc::new(flexible_aircraft::Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?);
    /// let mut flight = Simulation::new(Arc::clone(&jet), &Settings::of(&jet), 0.0)?;
    /// let lift: f64 = flight.strip_loads().iter().map(|load| -load.force.z).sum();
    /// assert!((lift / (jet.integrals.mass * jet.gravity) - 1.0).abs() < 0.02);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn strip_loads(&mut self) -> Vec<Resultant> {
        // The controls are those of the outputs.
        self.instant();
        let Simulation { flying, path, controls, .. } = self;
        flying.strip_loads(&path.present.state, controls)
    }

    /// What is read as it would be at the present time and state under other inputs, section loads among it. Allocates.
    pub fn instant_with_loads_under(&self, inputs: &Inputs, rates: &Inputs) -> Instant {
        let mut instant = self.instant_under(inputs, rates);
        let (_, controls) = self.acting_under(inputs, rates);
        self.flying.add_loads(&self.path.present.state, &controls, &mut instant.outputs);
        instant
    }
}
