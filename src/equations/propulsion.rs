//! Thrust along axes that turn with the deformed structure [theory: gravity-and-thrust.thrust, kinematics.rows; thesis §4.2].

use nalgebra::Vector3;

use crate::kinematics::{GeneralisedVectorMut, Section, Sections};
use crate::strips::Resultant;
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

    /// What a newton of each engine's thrust does at its deformed place.
    pub fn per_newton(&self, sections: &impl Sections) -> impl Iterator<Item = Resultant> {
        sections.engines().zip(&self.directions).map(|(section, direction)| Resultant {
            position: section.at_rest() + section.displacement(),
            force: section.turned(direction),
            moment: Vector3::zeros(),
        })
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

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::Scalar;

    use crate::kinematics::test_kind::Curved;
    use crate::kinematics::{Coordinates, Kinematics};
    use crate::structure::test_jet::jet;

    #[test]
    fn thrust_acts_on_coordinates_as_on_the_rigid_motion_by_which_they_move_its_engine() {
        let model = jet().select(&[0, 1, 2, 3, 4]);
        let (engines, kinematics) = (Engines::new(&model), Curved::new(&model, &[]));
        let [q, q_dot] = [[20.0, -15.0, 30.0, 10.0, -25.0], [0.0; 5]];
        let at = Coordinates { q: &q, q_dot: &q_dot };
        let mut memory = kinematics.memory();
        kinematics.evaluate(Scalar::new(), at, &mut memory);
        let mut effects = vec![0.0; engines.len() * (6 + q.len())];
        let sections = kinematics.sections(at, &memory);
        engines.write_effects(&sections, true, effects.chunks_exact_mut(6 + q.len()));
        assert_eq!(engines.len(), 2);
        for (effect, place) in effects.chunks_exact(6 + q.len()).zip(&kinematics.engines) {
            let (rigid, modal) = effect.split_at(6);
            for (twist, found) in place.twists(&q).iter().zip(modal) {
                let expected: f64 = twist.iter().zip(rigid).map(|(twist, effect)| twist * effect).sum();
                assert!((found - expected).abs() < 1e-13, "{found} {expected}");
            }
        }
    }
}
