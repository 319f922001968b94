//! Thrust along axes that turn with the deformed structure [4.2; physics.md §5].

use nalgebra::Vector3;

use crate::structure::{ModeShapes, ReducedEngine, ReducedModel};

use super::inertia::add;
use super::rotation::turned;

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

    /// Adds the generalised forces of the thrusts (N, one per engine) at q; with `deformed_arms` they act at
    /// the deformed place.
    pub fn add_thrust(&self, thrust: &[f64], q: &[f64], deformed_arms: bool, force: &mut [f64]) {
        for (engine, &thrust) in self.engines.iter().zip(thrust) {
            let ModeShapes { translation, rotation } = &engine.shapes;
            let axis = turned(&combine(rotation, q), &engine.direction);
            let displacement = if deformed_arms { combine(translation, q) } else { Vector3::zeros() };
            let push = axis * thrust;
            add(&mut force[0..3], &push);
            add(&mut force[3..6], &(engine.position + displacement).cross(&push));
            let n = q.len();
            for (mode, force) in force[6..].iter_mut().enumerate() {
                *force += (0..3).map(|i| translation[i * n + mode] * push[i]).sum::<f64>();
            }
        }
    }
}

/// Row-major 3 × n times q.
pub fn combine(rows: &[f64], q: &[f64]) -> Vector3<f64> {
    let n = q.len();
    Vector3::from_fn(|axis, _| rows[axis * n..(axis + 1) * n].iter().zip(q).map(|(row, q)| row * q).sum())
}
