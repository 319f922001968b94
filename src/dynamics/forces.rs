//! Generalised forces on ν = [v; ω; q̇], linear in surface angles and thrusts [4.1, 4.2; physics.md §4, §5].
//!
//! Loads of flaps and engines are linear in δ and thrust at a given state. Kept apart, the forces under other
//! controls cost next to nothing.

use super::controls::{Controls, SURFACES};

/// Generalised forces at one state. Those on components of ν that cannot move are not all complete.
#[derive(Clone, Debug)]
pub struct GeneralisedForces {
    /// With all surfaces neutral and no thrust.
    pub passive: Vec<f64>,
    /// Per radian of each kind of surfaces, then per newton of each engine's thrust.
    pub effects: Vec<Vec<f64>>,
    /// Under the controls of the last evaluation.
    pub total: Vec<f64>,
}

impl GeneralisedForces {
    /// Nothing acts yet on so many components of ν.
    pub fn new(components: usize, engines: usize) -> Self {
        let zeros = vec![0.0; components];
        GeneralisedForces {
            passive: zeros.clone(),
            effects: vec![zeros.clone(); SURFACES + engines],
            total: zeros,
        }
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        for forces in self.effects.iter_mut().chain([&mut self.passive]) {
            forces.fill(0.0);
        }
    }

    /// Those per newton of each engine's thrust.
    pub fn of_thrust(&mut self) -> &mut [Vec<f64>] {
        &mut self.effects[SURFACES..]
    }

    /// Sums what acts under the given controls.
    pub fn sum(&mut self, controls: &Controls) {
        self.total.copy_from_slice(&self.passive);
        for (effect, value) in self.effects.iter().zip(controls.values()).filter(|(_, value)| *value != 0.0) {
            for (total, effect) in self.total.iter_mut().zip(effect) {
                *total += effect * value;
            }
        }
    }
}
