//! Thrust along axes that turn with the deformed structure [theory: gravity-and-thrust.thrust; thesis §4.2].

use nalgebra::Vector3;

use crate::kinematics::{GeneralisedVectorMut, Section, Sections};
use crate::structure::ReducedModel;

/// All engines of an aircraft.
#[derive(Clone, Debug)]
pub struct Engines {
    /// Unit vectors of positive thrust on the undeformed aircraft.
    directions: Vec<Vector3<f64>>,
}

impl Engines {
    /// The engines of a model.
    pub fn new(model: &ReducedModel) -> Self {
        Engines { directions: model.engines.iter().map(|engine| engine.direction).collect() }
    }

    /// Number of engines.
    pub fn len(&self) -> usize {
        self.directions.len()
    }

    /// Writes the generalised forces of a newton of each engine's thrust; with `deformed_arms` it acts at the deformed
    /// place.
    pub fn write_effects<'a>(
        &self,
        sections: &impl Sections,
        deformed_arms: bool,
        effects: impl Iterator<Item = &'a mut [f64]>,
    ) {
        for ((section, direction), effect) in sections.engines().zip(&self.directions).zip(effects) {
            let axis = section.turned(direction);
            let displacement = if deformed_arms { section.displacement() } else { Vector3::zeros() };
            let mut effect = GeneralisedVectorMut::of(effect);
            effect.set_rigid(&axis, &(section.at_rest() + displacement).cross(&axis));
            section.write_generalised_force(&axis, effect.modal);
        }
    }
}
