//! Thrust along axes that turn with the deformed structure, its torque, and what turns in the engines.
//!
//! [theory: gravity-and-thrust.thrust, gravity-and-thrust.torque, gravity-and-thrust.gyroscopic, kinematics.rows; thesis §4.2]

use nalgebra::Vector3;

use crate::kinematics::{GeneralisedVectorMut, Section, Sections};
use crate::strips::Resultant;
use crate::structure::{ModeShapes, ReducedModel};

/// All engines of an aircraft.
#[derive(Clone, Debug)]
pub struct Engines {
    /// What is fixed to the section of each.
    engines: Vec<Engine>,
    /// s: in what proportion each has the thrust of trims.
    trim_shares: Vec<f64>,
    /// Ψᵠ of each, where rotors are on the undeformed aircraft.
    undeformed: Option<Vec<ModeShapes>>,
    /// Whether anything turns in any.
    spins: bool,
}

/// An engine on the undeformed aircraft.
#[derive(Clone, Copy, Debug)]
struct Engine {
    /// a.
    direction: Vector3<f64>,
    /// τ, N·m per N.
    torque: f64,
    /// h, kg·m²/s.
    momentum: f64,
}

impl Engines {
    /// The engines of a model; what turns in them does so as on the deformed aircraft or, `undeformed`, as on the other.
    pub fn new(model: &ReducedModel, undeformed: bool) -> Self {
        let engines = model.engines.iter().map(|engine| Engine {
            direction: engine.direction,
            torque: engine.torque,
            momentum: engine.angular_momentum,
        });
        let engines: Vec<Engine> = engines.collect();
        let shapes = || model.engines.iter().map(|engine| engine.shapes.clone()).collect();
        Engines {
            trim_shares: model.engines.iter().map(|engine| engine.trim_share).collect(),
            undeformed: undeformed.then(shapes),
            spins: engines.iter().any(|engine| engine.momentum != 0.0),
            engines,
        }
    }

    /// Number of engines.
    pub fn len(&self) -> usize {
        self.engines.len()
    }

    /// In what proportion each has the thrust of trims.
    pub fn trim_shares(&self) -> &[f64] {
        &self.trim_shares
    }

    /// What a newton of each engine's thrust does at its deformed place.
    pub fn per_newton(&self, sections: &impl Sections) -> impl Iterator<Item = Resultant> {
        sections.engines().zip(&self.engines).map(|(section, engine)| {
            let axis = section.turned(&engine.direction);
            Resultant {
                position: section.at_rest() + section.displacement(),
                force: axis,
                moment: axis * engine.torque,
            }
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
        for ((section, engine), effect) in sections.engines().zip(&self.engines).zip(effects) {
            let axis = section.turned(&engine.direction);
            let displacement = if deformed_arms { section.displacement() } else { Vector3::zeros() };
            let about_origin = (section.at_rest() + displacement).cross(&axis);
            let mut effect = GeneralisedVectorMut::of(effect);
            if engine.torque == 0.0 {
                effect.set_rigid(&axis, &about_origin);
                section.write_generalised_force(&axis, effect.modal);
            } else {
                let torque = axis * engine.torque;
                effect.set_rigid(&axis, &(about_origin + torque));
                effect.modal.fill(0.0);
                section.add_generalised_load(&axis, &torque, effect.modal);
            }
        }
    }

    /// The gyroscopic moment of each engine on its deformed section while the body axes turn at ω, N·m.
    pub fn gyroscopic_moments(
        &self,
        sections: &impl Sections,
        body_rate: &Vector3<f64>,
    ) -> impl Iterator<Item = Vector3<f64>> {
        sections
            .engines()
            .zip(&self.engines)
            .map(|(section, engine)| momentum(&section, engine).cross(&section.angular_velocity(body_rate)))
    }

    /// The angular momenta of all that turns in the engines, summed, body axes, kg·m²/s.
    pub fn momentum(&self, sections: &impl Sections) -> Vector3<f64> {
        sections.engines().zip(&self.engines).map(|(section, engine)| momentum(&section, engine)).sum()
    }

    /// Adds the generalised forces of all gyroscopic moments while the body axes turn at ω.
    pub fn add_gyroscopic_forces(
        &self,
        sections: &impl Sections,
        (body_rate, q_dot): (&Vector3<f64>, &[f64]),
        forces: &mut [f64],
    ) {
        if !self.spins {
            return;
        }
        let mut forces = GeneralisedVectorMut::of(forces);
        let nothing = Vector3::zeros();
        if let Some(shapes) = &self.undeformed {
            for (Engine { direction, momentum, .. }, shapes) in self.engines.iter().zip(shapes) {
                let turns = || (0..q_dot.len()).map(|mode| shapes.of_mode(mode)[1]);
                let spin: Vector3<f64> = turns().zip(q_dot).map(|(turn, q_dot)| turn * *q_dot).sum();
                let moment = (direction * *momentum).cross(&(body_rate + spin));
                forces.add_rigid(&nothing, &moment);
                for (force, turn) in forces.modal.iter_mut().zip(turns()) {
                    *force += turn.dot(&moment);
                }
            }
            return;
        }
        for (section, moment) in sections.engines().zip(self.gyroscopic_moments(sections, body_rate)) {
            forces.add_rigid(&nothing, &moment);
            section.add_generalised_load(&nothing, &moment, forces.modal);
        }
    }
}

/// h E a of an engine on its section.
fn momentum(section: &impl Section, engine: &Engine) -> Vector3<f64> {
    section.turned(&engine.direction) * engine.momentum
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::Scalar;

    use crate::kinematics::test_kind::Curved;
    use crate::kinematics::{Coordinates, GeometricallyExact, Kinematics, Superposition};
    use crate::structure::test_jet::jet;

    /// The jet with a few modes and propellers that turn as they like.
    fn propeller_driven() -> ReducedModel {
        let mut model = jet().select(&[0, 1, 2, 3, 4]);
        for (engine, sense) in model.engines.iter_mut().zip([1.0, 0.7]) {
            (engine.torque, engine.angular_momentum) = (-0.3 * sense, 900.0 * sense);
        }
        model
    }

    #[test]
    fn thrust_acts_on_coordinates_as_on_the_rigid_motion_by_which_they_move_its_engine() {
        for model in [jet().select(&[0, 1, 2, 3, 4]), propeller_driven()] {
            acts_on_coordinates_as_on_the_rigid_motion(&model);
        }
    }

    fn acts_on_coordinates_as_on_the_rigid_motion(model: &ReducedModel) {
        let (engines, kinematics) = (Engines::new(model, false), Curved::new(model, &[]));
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

    #[test]
    fn gyroscopic_forces_do_no_work_whatever_the_kinematics() {
        do_no_work::<Superposition>(false);
        do_no_work::<Superposition>(true);
        do_no_work::<GeometricallyExact>(false);
        do_no_work::<Curved>(false);
    }

    /// Whether the forces on ν have no power, and those of torques that of the moments on the turning sections.
    fn do_no_work<K: Kinematics>(undeformed: bool) {
        let model = propeller_driven();
        let (engines, kinematics) = (Engines::new(&model, undeformed), K::new(&model, &[]));
        let [q, q_dot] = [[20.0, -15.0, 30.0, 10.0, -25.0], [4.0, 3.0, -2.0, 1.0, 5.0]];
        let at = Coordinates { q: &q, q_dot: &q_dot };
        let mut memory = kinematics.memory();
        kinematics.evaluate(Scalar::new(), at, &mut memory);
        let sections = kinematics.sections(at, &memory);
        let (velocity, rate) = (Vector3::new(3.0, -1.0, 2.0), Vector3::new(0.3, -0.4, 0.7));
        let velocities: Vec<f64> = velocity.iter().chain(rate.iter()).chain(&q_dot).copied().collect();
        let power = |forces: &[f64]| -> [f64; 2] {
            let parts = forces.iter().zip(&velocities).map(|(force, velocity)| force * velocity);
            parts.fold([0.0, 0.0], |[sum, size], part| [sum + part, size + part.abs()])
        };
        let mut forces = vec![0.0; velocities.len()];
        engines.add_gyroscopic_forces(&sections, (&rate, &q_dot), &mut forces);
        let [sum, size] = power(&forces);
        assert!(size > 1.0 && sum.abs() < 1e-13 * size, "{sum} of {size}");

        let mut effects = vec![0.0; engines.len() * velocities.len()];
        engines.write_effects(&sections, true, effects.chunks_exact_mut(velocities.len()));
        for ((effect, section), acting) in
            effects.chunks_exact(velocities.len()).zip(sections.engines()).zip(engines.per_newton(&sections))
        {
            let motion = velocity + rate.cross(&acting.position) + section.velocity();
            let expected = acting.force.dot(&motion) + acting.moment.dot(&section.angular_velocity(&rate));
            let [found, size] = power(effect);
            assert!((found - expected).abs() < 1e-13 * size, "{found} {expected} of {size}");
        }
    }
}
