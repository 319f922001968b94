//! Generalised forces on ν = [v; ω; q̇], linear in surface angles and thrusts [4.1, 4.2; physics.md §4, §5].
//!
//! Loads of flaps and engines are linear in δ and thrust at a given state. Kept apart, the forces under other
//! controls cost next to nothing.

use super::controls::{Controls, SURFACES};

/// Generalised forces at one state. Those on components of ν that cannot move are not all complete.
#[derive(Clone, Debug)]
pub struct GeneralisedForces {
    /// How many components ν has.
    components: usize,
    /// With all surfaces neutral and no thrust; then per radian of each kind of surfaces, then per newton of each
    /// engine's thrust.
    rows: Vec<f64>,
    /// Under the controls of the last evaluation.
    total: Vec<f64>,
}

impl GeneralisedForces {
    /// Nothing acts yet on so many components of ν.
    pub fn new(components: usize, engines: usize) -> Self {
        GeneralisedForces {
            components,
            rows: vec![0.0; (1 + SURFACES + engines) * components],
            total: vec![0.0; components],
        }
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        self.rows.fill(0.0);
    }

    /// Those with all surfaces neutral and no thrust.
    pub fn passive_mut(&mut self) -> &mut [f64] {
        &mut self.rows[..self.components]
    }

    /// Those per radian of a kind of surfaces.
    pub fn of_surface_mut(&mut self, surface: usize) -> &mut [f64] {
        &mut self.rows[(1 + surface) * self.components..][..self.components]
    }

    /// Those per newton of each engine's thrust.
    pub fn of_thrust_mut(&mut self) -> impl Iterator<Item = &mut [f64]> {
        self.rows.chunks_exact_mut(self.components).skip(1 + SURFACES)
    }

    /// Sums what acts under the given controls.
    pub fn sum(&mut self, controls: &Controls) {
        let (passive, effects) = self.rows.split_at(self.components);
        self.total.copy_from_slice(passive);
        let effects = effects.chunks_exact(self.components);
        for (effect, value) in effects.zip(controls.values()).filter(|(_, value)| *value != 0.0) {
            for (total, effect) in self.total.iter_mut().zip(effect) {
                *total += effect * value;
            }
        }
    }

    /// Under the controls of the last evaluation.
    pub fn total(&self) -> &[f64] {
        &self.total
    }
}
