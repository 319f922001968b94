//! Generalised forces on ν = [v; ω; q̇] as sums of what each control does.
//!
//! [theory: gravity-and-thrust.by-control; thesis §4.1, §4.2]
//!
//! At a given state the loads of flaps are quadratic in δ, those of engines linear in thrust. Kept apart, the forces
//! under other controls cost next to nothing.

use crate::strips::FlapFactor;

use super::controls::Controls;

/// Generalised forces at one state. Those on components of ν that cannot move are not all complete.
#[derive(Clone, Debug)]
pub struct GeneralisedForces {
    /// How many components ν has.
    components: usize,
    /// What the loads of flaps are proportional to.
    factors: Vec<FlapFactor>,
    /// With all controls neutral and no thrust; then per unit of each factor, then per newton of each engine's thrust.
    rows: Vec<f64>,
    /// Under the controls of the last evaluation.
    total: Vec<f64>,
}

impl GeneralisedForces {
    /// Nothing acts yet on so many components of ν.
    pub(crate) fn new(components: usize, factors: &[FlapFactor], engines: usize) -> Self {
        GeneralisedForces {
            components,
            factors: factors.to_vec(),
            rows: vec![0.0; (1 + factors.len() + engines) * components],
            total: vec![0.0; components],
        }
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        self.rows.fill(0.0);
    }

    /// Those with all controls neutral and no thrust.
    pub fn passive_mut(&mut self) -> &mut [f64] {
        &mut self.rows[..self.components]
    }

    /// Those with all controls neutral and no thrust, and those per unit of each factor of the flaps' loads, rad or rad²,
    /// one row after the other.
    pub fn of_air_mut(&mut self) -> (&mut [f64], &mut [f64]) {
        let (passive, effects) = self.rows.split_at_mut(self.components);
        (passive, &mut effects[..self.factors.len() * self.components])
    }

    /// Those per newton of each engine's thrust.
    pub fn of_thrust_mut(&mut self) -> impl Iterator<Item = &mut [f64]> {
        self.rows.chunks_exact_mut(self.components).skip(1 + self.factors.len())
    }

    /// Sums what acts under the given controls.
    pub fn sum(&mut self, controls: &Controls) {
        let (passive, effects) = self.rows.split_at(self.components);
        self.total.copy_from_slice(passive);
        let effects = effects.chunks_exact(self.components);
        let flaps = self.factors.iter().map(|factor| factor.value(&controls.angles));
        let values = flaps.chain(controls.thrust.iter().copied());
        for (effect, value) in effects.zip(values).filter(|(_, value)| *value != 0.0) {
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
