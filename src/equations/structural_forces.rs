//! What the structure's mass and stiffness contribute to the equations of motion.
//!
//! [theory: equations-of-motion.rows, strain-energy.force; thesis eq. 2.4, 2.5]

use crate::kinematics::RigidMotion;
use crate::math::{Arithmetic, Work};

use super::of_motion::EquationsOfMotion;
use super::workspace::Workspace;

/// Mass matrix, inertial forcing and elastic forces of the fidelity level, on their way into the workspace.
pub struct StructuralForces<'a> {
    /// Their structure and fidelity.
    pub equations: &'a EquationsOfMotion,
    /// v and ω.
    pub motion: &'a RigidMotion,
    /// q.
    pub q: &'a [f64],
    /// q̇.
    pub q_dot: &'a [f64],
    /// Where the results go.
    pub workspace: &'a mut Workspace,
}

impl Work for StructuralForces<'_> {
    type Output = ();

    #[inline(always)]
    fn with<S: Arithmetic>(self, simd: S) {
        let StructuralForces { equations, motion, q, q_dot, workspace } = self;
        let EquationsOfMotion { terms, integrals, elastic_forces, .. } = equations;
        let Workspace { inertia, forces, elastic_force, elastic_scratch, system, .. } = workspace;
        // The workspace starts undeformed and stays so for the levels that never deform it.
        if terms.deformed_mass || terms.deformed_forcing {
            inertia.deform(simd, integrals, q);
        }
        inertia.write_mass_matrix(terms.deformed_mass, &mut system.matrix);
        let q_dot = terms.deformed_forcing.then_some(q_dot);
        inertia.add_forces(simd, integrals, motion, q_dot, forces.passive_mut());
        elastic_forces.write(simd, q, elastic_force, elastic_scratch);
    }
}
