//! Thrust along axes that turn with the deformed structure [4.2; physics.md §5].

use nalgebra::Vector3;

use crate::kinematics::{GeneralisedVectorMut, combine};
use crate::math::turned;
use crate::structure::{ModeShapes, ReducedEngine, ReducedModel};

/// All engines of an aircraft.
#[derive(Clone, Debug)]
pub struct Engines {
    engines: Vec<ReducedEngine>,
}

impl Engines {
    /// The engines of a model.
    pub fn new(model: &ReducedModel) -> Self {
        Engines { engines: model.engines.clone() }
    }

    /// Number of engines.
    pub fn len(&self) -> usize {
        self.engines.len()
    }

    /// Writes the generalised forces of a newton of each engine's thrust at q; with `deformed_arms` it acts at the
    /// deformed place.
    pub fn write_effects<'a>(
        &self,
        q: &[f64],
        deformed_arms: bool,
        effects: impl Iterator<Item = &'a mut [f64]>,
    ) {
        for (engine, effect) in self.engines.iter().zip(effects) {
            let ModeShapes { translation, rotation } = &engine.shapes;
            let axis = turned(&combine(rotation, q), &engine.direction);
            let displacement = if deformed_arms { combine(translation, q) } else { Vector3::zeros() };
            let mut effect = GeneralisedVectorMut::of(effect);
            effect.set_rigid(&axis, &(engine.position + displacement).cross(&axis));
            let n = q.len();
            for (mode, effect) in effect.modal.iter_mut().enumerate() {
                *effect = (0..3).map(|i| translation[i * n + mode] * axis[i]).sum();
            }
        }
    }
}
