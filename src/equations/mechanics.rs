//! Energy and momentum of the deformed aircraft, for checks of conservation.
//!
//! [theory: equations-of-motion.conservation]

use nalgebra::{DMatrix, Vector3};
use pulp::Scalar;

use crate::kinematics::{GeneralisedVector, Inertia, Kinematics, OfKind, RigidFreedom, by_kind};
use crate::math::{Attitude, SquareMatrix};

use super::of_motion::EquationsOfMotion;

/// Energy and momentum at one state, with exact inertia whatever the fidelity level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mechanics {
    /// ½ νᵀM̂ν, J.
    pub kinetic_energy: f64,
    /// The level's own U, J.
    pub strain_energy: f64,
    /// Inertial components, kg·m/s.
    pub linear_momentum: Vector3<f64>,
    /// About the inertial origin, inertial components, with that of what turns in engines, kg·m²/s.
    pub angular_momentum: Vector3<f64>,
}

impl EquationsOfMotion {
    /// M̂ over ν at a state, with exact inertia whatever the fidelity level, without apparent mass. Allocates.
    pub fn exact_mass_matrix(&self, state: &[f64]) -> DMatrix<f64> {
        let mut mass = SquareMatrix::new(self.layout().velocities());
        by_kind!(&self.kinematics, |kinematics| {
            let (at, memory) = self.evaluated(kinematics, state);
            let sections = kinematics.sections(at, &memory);
            let mut inertia = kinematics.inertia(self.integrals(), RigidFreedom::All);
            inertia.deform(Scalar::new(), &sections);
            inertia.write_mass_matrix(&sections, true, &mut mass);
        });
        DMatrix::from_fn(mass.size(), mass.size(), |row, column| mass[(row, column)])
    }

    /// Of what turns in the engines, body axes, kg·m²/s. Allocates.
    fn engines_momentum(&self, state: &[f64]) -> Vector3<f64> {
        by_kind!(&self.kinematics, |kinematics| {
            let (at, memory) = self.evaluated(kinematics, state);
            self.engines.momentum(&kinematics.sections(at, &memory))
        })
    }
}

impl Mechanics {
    /// At a state of the given equations. Allocates.
    pub fn new(equations: &EquationsOfMotion, state: &[f64]) -> Self {
        let layout = equations.layout();
        let mass = equations.exact_mass_matrix(state);
        let velocities = layout.velocities_of(state);
        let along = |row: usize| {
            let products =
                velocities.iter().enumerate().map(|(column, velocity)| mass[(row, column)] * velocity);
            products.sum::<f64>()
        };
        let momenta: Vec<f64> = (0..velocities.len()).map(along).collect();
        let to_inertial = Attitude::from_quaternion(&state[layout.attitude()]).body_from_inertial.transpose();
        let momentum = GeneralisedVector::of(&momenta);
        let linear_momentum = to_inertial * momentum.translation;
        let about_origin = to_inertial * (momentum.rotation + equations.engines_momentum(state));
        let position = Vector3::from_column_slice(&state[layout.position()]);
        Mechanics {
            kinetic_energy: 0.5 * momenta.iter().zip(&velocities).map(|(p, v)| p * v).sum::<f64>(),
            strain_energy: equations.strain_energy(&state[layout.coordinates()]),
            linear_momentum,
            angular_momentum: about_origin + position.cross(&linear_momentum),
        }
    }
}
