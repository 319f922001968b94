//! The equations of motion at a state: rates, accelerations, forces.
//!
//! [theory: equations-of-motion.rows, equations-of-motion.solution; thesis eq. 2.3, 2.4]
//!
//! One Cholesky factor of the mass matrix with apparent mass gives the accelerations (LU where the apparent
//! mass is not self-adjoint: RL, or zero-lift lines off the chord); the inflow rates need none. Components of ν that
//! support or symmetry hold are left out of the matrix.

use std::cell::Cell;

use nalgebra::DMatrix;

use crate::kinematics::{GeneralisedVector, OfKind, by_kind};
use crate::math::{Attitude, Counting, Machine, quaternion_rate};

use super::assembly::{Assembly, Situation};
use super::controls::Controls;
use super::of_motion::EquationsOfMotion;
use super::workspace::Workspace;

impl EquationsOfMotion {
    /// Rates of all states; accelerations stay in the workspace. States beyond the model's validity give NaN.
    pub fn rates(&self, state: &[f64], controls: &Controls, rates: &mut [f64], workspace: &mut Workspace) {
        self.rates_by(self.arch, state, controls, rates, workspace);
    }

    /// How many multiplications of numbers in registers [`rates`](Self::rates) takes at a state.
    pub fn multiplications(&self, state: &[f64], controls: &Controls) -> usize {
        let multiplications = Cell::new(0);
        let counting = Counting { multiplications: &multiplications };
        let (mut rates, mut workspace) = (vec![0.0; state.len()], Workspace::new(self));
        self.rates_by(counting, state, controls, &mut rates, &mut workspace);
        multiplications.get()
    }

    /// The rates as a machine computes them.
    #[inline(always)]
    fn rates_by(
        &self,
        machine: impl Machine,
        state: &[f64],
        controls: &Controls,
        rates: &mut [f64],
        workspace: &mut Workspace,
    ) {
        #[cfg(test)]
        super::evaluations::count();
        let layout = &self.layout;
        let attitude = Attitude::from_quaternion(&state[layout.attitude()]);
        self.assemble(machine, Situation { state, attitude: &attitude, controls }, rates, workspace);
        workspace.collect_forces(controls);
        workspace.regular = workspace.system.solve(machine, &mut workspace.solution);
        self.write_accelerations(rates, workspace);

        let motion = self.motion(state);
        let velocity = attitude.body_from_inertial.tr_mul(&motion.velocity);
        rates[layout.position()].copy_from_slice(velocity.as_slice());
        let quaternion = quaternion_rate(&state[layout.attitude()], &motion.rate);
        rates[layout.attitude()].copy_from_slice(&quaternion);
        rates[layout.coordinates()].copy_from_slice(&state[layout.coordinate_rates()]);
    }

    /// Writes the accelerations under given angles of controls and thrusts at the state and in the wind of the last
    /// evaluation into its rates: the same bits as a new evaluation, for next to nothing.
    pub fn steer(&self, controls: &Controls, rates: &mut [f64], workspace: &mut Workspace) {
        workspace.collect_forces(controls);
        if workspace.regular {
            workspace.system.solve_again(&mut workspace.solution);
        }
        self.write_accelerations(rates, workspace);
    }

    /// Writes what was solved for into the accelerations and the rates.
    fn write_accelerations(&self, rates: &mut [f64], workspace: &mut Workspace) {
        let Workspace { regular, solution, strip_sums, accelerations, .. } = workspace;
        for (&component, &acceleration) in strip_sums.moving().iter().zip(&*solution) {
            accelerations[component] = if *regular { acceleration } else { f64::NAN };
        }
        let layout = &self.layout;
        let GeneralisedVector { translation, rotation, modal } = GeneralisedVector::of(accelerations);
        rates[layout.velocity()].copy_from_slice(translation.as_slice());
        rates[layout.rate()].copy_from_slice(rotation.as_slice());
        rates[layout.coordinate_rates()].copy_from_slice(modal);
    }

    /// (A⁻¹)_qq: how the generalised coordinates answer forces on themselves, made self-adjoint. Allocates.
    pub(crate) fn elastic_mobility(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &mut Workspace,
    ) -> Option<DMatrix<f64>> {
        let rigid = self.freedom.components().len();
        let inverse = self.mass_matrix(state, controls, workspace).try_inverse()?;
        let elastic = inverse.view_range(rigid.., rigid..);
        Some((elastic + elastic.transpose()) * 0.5)
    }

    /// The mass matrix of the components of ν that move, as the fidelity level has it, with apparent mass. Allocates.
    pub(crate) fn mass_matrix(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &mut Workspace,
    ) -> DMatrix<f64> {
        let attitude = Attitude::from_quaternion(&state[self.layout.attitude()]);
        let situation = Situation { state, attitude: &attitude, controls };
        self.assemble(self.arch, situation, &mut vec![0.0; state.len()], workspace);
        let (size, matrix) = (self.moving().len(), &workspace.system.matrix);
        let mut mass = DMatrix::from_fn(size, size, |row, column| matrix[(row, column)]);
        if self.self_adjoint {
            mass.fill_lower_triangle_with_upper_triangle();
        }
        mass
    }

    /// Writes the mass matrix and the generalised forces into the workspace, the inflow rates into `rates`.
    #[inline(always)]
    fn assemble(
        &self,
        machine: impl Machine,
        situation: Situation,
        rates: &mut [f64],
        workspace: &mut Workspace,
    ) {
        let Workspace {
            memory,
            inertia,
            forces,
            elastic_force,
            elastic_scratch,
            system,
            gust,
            strip_sums,
            ..
        } = workspace;
        let written = memory.as_mut().with(inertia.as_mut());
        by_kind!(self.kinematics.as_ref().with(written), |(kinematics, (memory, inertia))| {
            let assembly = Assembly {
                equations: self,
                kinematics,
                memory,
                inertia,
                forces,
                elastic_force,
                elastic_scratch,
                mass: &mut system.matrix,
                gust,
                strip_sums,
            };
            assembly.write(machine, situation, rates);
        });
    }
}
