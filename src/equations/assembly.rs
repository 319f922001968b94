//! The mass matrix and the forces at a state, whatever the kind of kinematics.
//!
//! [theory: equations-of-motion.rows, kinematics.sections, strain-energy.force; thesis eq. 2.3–2.5]
//!
//! Kinematics is evaluated first; all that hangs on the structure, its mass, engines and strips, then reads it.

use nalgebra::Vector3;
use pulp::Scalar;

use crate::air::Field;
use crate::kinematics::{Coordinates, GeneralisedVectorMut, Inertia, Kinematics, RigidMotion};
use crate::math::{Arithmetic, Attitude, Machine, SquareMatrix, Work};
use crate::strips::{GustAtStrips, Penetrate, StripSums, SumLoads, Surroundings};
use crate::structure::ElasticScratch;

use super::controls::Controls;
use super::forces::GeneralisedForces;
use super::of_motion::EquationsOfMotion;

/// What the equations of motion are assembled from, and where they go.
pub struct Assembly<'a, K: Kinematics> {
    /// Their structure, strips, engines and fidelity.
    pub equations: &'a EquationsOfMotion,
    /// Where all that hangs on the structure is.
    pub kinematics: &'a K,
    /// What that writes for an instant.
    pub memory: &'a mut K::Memory,
    /// Of the mass that moves so.
    pub inertia: &'a mut K::Inertia,
    /// On ν.
    pub forces: &'a mut GeneralisedForces,
    /// ∂U/∂q.
    pub elastic_force: &'a mut [f64],
    /// For evaluating it.
    pub elastic_scratch: &'a mut ElasticScratch,
    /// The mass matrix with apparent mass of the components of ν that move.
    pub mass: &'a mut SquareMatrix,
    /// What a gust is at the strips.
    pub gust: &'a mut GustAtStrips,
    /// Loads and apparent mass of the strips.
    pub strip_sums: &'a mut StripSums,
}

/// The state of the aircraft, and the air around it.
#[derive(Clone, Copy)]
pub struct Situation<'a> {
    /// All states.
    pub state: &'a [f64],
    /// Of the body axes.
    pub attitude: &'a Attitude,
    /// Of which the wind counts here.
    pub controls: &'a Controls,
}

impl<K: Kinematics> Assembly<'_, K> {
    /// Writes the mass matrix and the generalised forces, and the rates of the inflow states into `rates`.
    #[inline(always)]
    pub fn write(self, machine: impl Machine, situation: Situation, rates: &mut [f64]) {
        let Assembly { equations, kinematics, memory, inertia, forces, gust, strip_sums: sums, mass, .. } =
            self;
        let Situation { state, attitude, controls } = situation;
        let at = equations.coordinates(state);
        machine.run(Evaluation { kinematics, at, memory });
        let sections = kinematics.sections(at, memory);

        forces.clear();
        machine.run(StructuralForces::<K> {
            equations,
            motion: &equations.motion(state),
            at,
            sections: &sections,
            inertia,
            passive: forces.passive_mut(),
            elastic_force: self.elastic_force,
            elastic_scratch: self.elastic_scratch,
            mass,
        });
        let gravity = attitude.body_from_inertial * Vector3::new(0.0, 0.0, equations.gravity);
        inertia.add_gravity(&sections, &gravity, forces.passive_mut());
        let deformed_arms = equations.terms.deformed_forcing;
        equations.engines.write_effects(&sections, deformed_arms, forces.of_thrust_mut());
        let turning = (&equations.motion(state).rate, at.q_dot);
        equations.engines.add_gyroscopic_forces(&sections, turning, forces.passive_mut());
        let to_body = &attitude.body_from_inertial;
        equations.station_loads.add(&sections, to_body, deformed_arms, forces.passive_mut());

        let (strips, layout) = (&equations.strips, equations.layout.inflow_layout());
        let gust = equations.gust_seen(state, attitude, controls).map(|(frozen, seen)| {
            let (seen, sections, at_strips) = (&seen, &sections, &mut *gust);
            match frozen.field() {
                Field::Ahead(gust) => machine.run(Penetrate { strips, sections, gust, seen, at_strips }),
                Field::Imposed(gust) => run_narrow(Penetrate { strips, sections, gust, seen, at_strips }),
            }
            &*gust
        });
        let around = &Surroundings { gust, ..equations.surroundings(state, attitude, controls) };
        let (passive, effects) = forces.of_air_mut();
        machine.run(SumLoads {
            strips,
            sections,
            around,
            layout,
            state,
            rates,
            sums,
            passive,
            effects,
            mass,
        });
    }
}

/// Without wide vectors, which would make more code than they save time where no flight comes by; the bits are the same.
#[cold]
#[inline(never)]
fn run_narrow<W: Work>(work: W) -> W::Output {
    work.with(Scalar::new())
}

/// The evaluation of a kind of kinematics.
struct Evaluation<'a, K: Kinematics> {
    kinematics: &'a K,
    at: Coordinates<'a>,
    memory: &'a mut K::Memory,
}

impl<K: Kinematics> Work for Evaluation<'_, K> {
    type Output = ();

    #[inline(always)]
    fn with<S: Arithmetic>(self, simd: S) {
        self.kinematics.evaluate(simd, self.at, self.memory);
    }
}

/// Mass matrix, inertial, elastic and damping forces of the fidelity level.
struct StructuralForces<'a, 's, K: Kinematics + 's> {
    equations: &'a EquationsOfMotion,
    motion: &'a RigidMotion,
    at: Coordinates<'a>,
    sections: &'a K::Instant<'s>,
    inertia: &'a mut K::Inertia,
    passive: &'a mut [f64],
    elastic_force: &'a mut [f64],
    elastic_scratch: &'a mut ElasticScratch,
    mass: &'a mut SquareMatrix,
}

impl<K: Kinematics> Work for StructuralForces<'_, '_, K> {
    type Output = ();

    #[inline(always)]
    fn with<S: Arithmetic>(self, simd: S) {
        let StructuralForces { sections, inertia, passive, elastic_force, .. } = self;
        let EquationsOfMotion { terms, elastic_forces, damping, .. } = self.equations;
        // The workspace starts undeformed and stays so for the levels that never deform it.
        if terms.deformed_mass || terms.deformed_forcing {
            inertia.deform(simd, sections);
        }
        inertia.write_mass_matrix(sections, terms.deformed_mass, self.mass);
        inertia.add_forces(simd, sections, self.motion, terms.deformed_forcing, passive);
        elastic_forces.write(simd, self.at.q, elastic_force, self.elastic_scratch);
        let modal = GeneralisedVectorMut::of(passive).modal;
        for (((force, elastic), damping), q_dot) in
            modal.iter_mut().zip(elastic_force).zip(damping).zip(self.at.q_dot)
        {
            *force -= *elastic + damping * q_dot;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::Arch;

    use crate::equations::{Configuration, Fidelity, Workspace};
    use crate::kinematics::test_kind::Curved;
    use crate::kinematics::{GeometricallyExact, RigidFreedom};
    use crate::structure::ReducedModel;
    use crate::structure::test_jet::jet;

    /// Forces on ν and the mass matrix of masses on sections of another kind, with nothing else.
    fn assemble<K: Kinematics>(
        equations: &EquationsOfMotion,
        kinematics: &K,
        state: &[f64],
    ) -> (Vec<f64>, SquareMatrix) {
        let mut workspace = Workspace::new(equations);
        let controls = equations.neutral_controls();
        let assembly = Assembly {
            equations,
            kinematics,
            memory: &mut kinematics.memory(),
            inertia: &mut kinematics.inertia(equations.integrals(), RigidFreedom::All),
            forces: &mut workspace.forces,
            elastic_force: &mut workspace.elastic_force,
            elastic_scratch: &mut workspace.elastic_scratch,
            mass: &mut workspace.system.matrix,
            gust: &mut workspace.gust,
            strip_sums: &mut workspace.strip_sums,
        };
        let attitude = Attitude::from_quaternion(&state[equations.layout().attitude()]);
        let situation = Situation { state, attitude: &attitude, controls: &controls };
        assembly.write(Arch::new(), situation, &mut vec![0.0; state.len()]);
        workspace.forces.sum(&controls);
        (workspace.forces.total().to_vec(), workspace.system.matrix)
    }

    #[test]
    fn masses_on_sections_of_other_kinds_keep_their_energy() {
        keep_their_energy::<Curved>();
        keep_their_energy::<GeometricallyExact>();
    }

    /// Whether the masses of a kind do, on the jet without air and gravity.
    fn keep_their_energy<K: Kinematics>() {
        let jet = jet().select(&[0, 1, 2, 3, 4]);
        let model = ReducedModel { strips: Vec::new(), gravity: 0.0, ..jet };
        let configuration = Configuration {
            fidelity: Fidelity::Exact,
            stiffness_scale: 0.0,
            structural_damping: 0.0,
            inflow_states: 0,
            temperature_offset: 0.0,
            tunnel_flow: Vector3::zeros(),
        };
        let equations = EquationsOfMotion::new(&model, &configuration).unwrap();
        let (layout, kinematics) = (equations.layout(), K::new(&model, &[]));
        let mut state: Vec<f64> = (0..layout.len()).map(|place| 10.0 * libm::sin(place as f64)).collect();
        let velocities = layout.velocities_of(&state);
        let (forces, _) = assemble(&equations, &kinematics, &state);
        let power: f64 = forces.iter().zip(&velocities).map(|(force, velocity)| force * velocity).sum();

        let (coordinates, step) = (layout.coordinates(), 1e-4);
        let mut energy = |time: f64| {
            for (place, rate) in coordinates.clone().zip(layout.coordinate_rates()) {
                state[place] += state[rate] * time;
            }
            let (_, mass) = assemble(&equations, &kinematics, &state);
            let momentum =
                |row: usize| -> f64 { mass.row(row).iter().zip(&velocities).map(|(m, v)| m * v).sum() };
            0.5 * velocities.iter().enumerate().map(|(row, velocity)| velocity * momentum(row)).sum::<f64>()
        };
        // What the accelerations add to T, νᵀMν̇, and what the deformation adds, ½ νᵀṀν.
        let [behind, ahead] = [energy(-step), energy(2.0 * step)];
        let by_deformation = (ahead - behind) / (2.0 * step);
        assert!(by_deformation.abs() > 1e3 && ahead > 1e4, "{by_deformation} {ahead}");
        assert!((power + by_deformation).abs() < 1e-7 * ahead, "{power} {by_deformation} {ahead}");
    }
}
