//! Energy, momentum and the mass matrix from the modal integrals p, h, Γ, Π, υ, M are those of the particles,
//! summed one by one, at random states of large amplitude.
//!
//! [theory: structure.integrals, equations-of-motion.deformed-integrals; thesis §2.2]

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::{EquationsOfMotion, Fidelity, Mechanics};
use flexible_aircraft::structure::{ModalBasis, ReducedModel, Structure};
use nalgebra::{DMatrix, Matrix3xX, Vector3};

use crate::support::{random, soft};

use super::record::Record;

/// The jet's particles: mass, place and mode shapes there.
pub struct Particles(Vec<(f64, Vector3<f64>, Matrix3xX<f64>)>);

impl Particles {
    /// Sum of kinetic energy over all particles at q, ν = [v; ω; q̇].
    pub fn kinetic_energy(&self, q: &[f64], nu: &[f64]) -> f64 {
        self.moving(q, nu).map(|(mass, _, velocity)| 0.5 * mass * velocity.norm_squared()).sum()
    }

    /// Mass, place and velocity of each, body axes.
    fn moving<'a>(
        &'a self,
        q: &[f64],
        nu: &[f64],
    ) -> impl Iterator<Item = (f64, Vector3<f64>, Vector3<f64>)> + 'a {
        let (q, q_dot) = (nalgebra::DVector::from_row_slice(q), nalgebra::DVector::from_row_slice(&nu[6..]));
        let (v, omega) = (Vector3::from_column_slice(&nu[0..3]), Vector3::from_column_slice(&nu[3..6]));
        self.0.iter().map(move |(mass, place, psi)| {
            let place = place + psi * &q;
            (*mass, place, v + omega.cross(&place) + psi * &q_dot)
        })
    }
}

/// The jet in vacuum with its twelve lowest modes, as equations and as particles.
pub fn jet_and_particles(fidelity: Fidelity) -> (EquationsOfMotion, Particles) {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
    let aircraft = Aircraft { gravity: 0.0, strips: Vec::new(), ..Aircraft::read(&path).unwrap() };
    let structure = Structure::new(&aircraft).unwrap();
    let shapes = ModalBasis::new(&structure, 12).unwrap().shapes;
    let particles = structure.particles.iter().map(|particle| {
        let geometry = &structure.geometry[particle.attachment.beam];
        let rows = structure.apply_map(particle.attachment.beam, &particle.displacement(geometry), &shapes);
        let place = geometry.position(particle.attachment.fraction) + particle.offset;
        (particle.mass, place, Matrix3xX::from_row_slice(&rows))
    });
    let particles = Particles(particles.collect());
    let model = ReducedModel::new(&aircraft, 12).unwrap();
    (EquationsOfMotion::new(&model, &soft(fidelity)).unwrap(), particles)
}

/// A state of large amplitude: tip motions of metres, all rates up to 1 rad/s, in any attitude.
pub fn random_state(equations: &EquationsOfMotion, seed: u64) -> Vec<f64> {
    let layout = equations.layout();
    let mut next = random(seed);
    let mut state: Vec<f64> = (0..layout.len()).map(|_| next()).collect();
    for (range, scale) in [
        (layout.position(), 1000.0),
        (layout.velocity(), 100.0),
        (layout.coordinates(), 40.0),
        (layout.coordinate_rates(), 100.0),
    ] {
        state[range].iter_mut().for_each(|x| *x *= scale);
    }
    state
}

/// ν of a state.
pub fn velocities(equations: &EquationsOfMotion, state: &[f64]) -> Vec<f64> {
    let layout = equations.layout();
    [layout.velocity(), layout.rate(), layout.coordinate_rates()]
        .into_iter()
        .flat_map(|r| state[r].to_vec())
        .collect()
}

#[test]
fn energy_and_momentum_are_those_of_the_particles() {
    let (equations, particles) = jet_and_particles(Fidelity::Exact);
    let mut largest = [0.0_f64; 3];
    for seed in 0..20 {
        let mut state = random_state(&equations, seed);
        // Level at the origin: inertial and body components are the same.
        state[equations.layout().position()].fill(0.0);
        state[equations.layout().attitude()].copy_from_slice(&[1.0, 0.0, 0.0, 0.0]);
        let (q, nu) = (&state[equations.layout().coordinates()], velocities(&equations, &state));
        let found = Mechanics::new(&equations, &state);
        let energy = particles.kinetic_energy(q, &nu);
        let (mut linear, mut angular) = (Vector3::zeros(), Vector3::zeros());
        for (mass, place, velocity) in particles.moving(q, &nu) {
            linear += velocity * mass;
            angular += place.cross(&velocity) * mass;
        }
        let errors = [
            (found.kinetic_energy / energy - 1.0).abs(),
            (found.linear_momentum - linear).norm() / linear.norm(),
            (found.angular_momentum - angular).norm() / angular.norm(),
        ];
        largest = std::array::from_fn(|i| largest[i].max(errors[i]));
    }
    let mut record = Record::new(
        "modal-integrals",
        "Jet with 12 modes, 20 random states: largest relative difference to the sum over 588 particles",
        "½ Σ m |v + ω×R + ψq̇|² and its momenta, particle by particle",
    );
    for (name, error) in ["kinetic energy", "linear momentum", "angular momentum"].iter().zip(largest) {
        record.rounding(name, 1e-12, error);
    }
    record.finish();
}

#[test]
fn the_mass_matrix_is_that_of_the_particles_and_positive_definite() {
    let (equations, particles) = jet_and_particles(Fidelity::Exact);
    let (mut difference, mut smallest) = (0.0_f64, f64::INFINITY);
    for seed in 0..20 {
        let state = random_state(&equations, seed);
        let q = state[equations.layout().coordinates()].to_vec();
        let expected = gram_matrix(&particles, &q);
        let found = polarised(&equations, &state);
        // Entries differ in unit: relative to the geometric mean of their diagonals.
        let scaled = |matrix: &DMatrix<f64>| {
            DMatrix::from_fn(18, 18, |i, j| matrix[(i, j)] / libm::sqrt(expected[(i, i)] * expected[(j, j)]))
        };
        difference = difference.max((scaled(&found) - scaled(&expected)).amax());
        smallest = smallest.min(scaled(&found).symmetric_eigenvalues().min());
    }
    let mut record = Record::new(
        "mass-matrix",
        "The mass matrix of the same jet and states, entries relative to their diagonals",
        "Σ m JᵀJ with J = [1, −R×, ψ], self-adjoint and positive definite by construction",
    );
    record.rounding("largest difference of an entry", 1e-12, difference);
    record.at_least("smallest eigenvalue", 1e-4, smallest);
    record.finish();
}

/// Σ m JᵀJ.
fn gram_matrix(particles: &Particles, q: &[f64]) -> DMatrix<f64> {
    let q = nalgebra::DVector::from_row_slice(q);
    let mut sum = DMatrix::zeros(18, 18);
    for (mass, place, psi) in &particles.0 {
        let mut j = Matrix3xX::zeros(18);
        j.fixed_columns_mut::<3>(0).fill_with_identity();
        j.fixed_columns_mut::<3>(3).copy_from(&-(place + psi * &q).cross_matrix());
        j.columns_mut(6, 12).copy_from(psi);
        sum += j.transpose() * j * *mass;
    }
    sum
}

/// The mass matrix that the kinetic energy ½νᵀM̂ν of the program belongs to.
fn polarised(equations: &EquationsOfMotion, state: &[f64]) -> DMatrix<f64> {
    let energy = |i: usize, j: usize| {
        let mut state = state.to_vec();
        let layout = equations.layout();
        let places: Vec<usize> =
            layout.velocity().chain(layout.rate()).chain(layout.coordinate_rates()).collect();
        places.iter().for_each(|&place| state[place] = 0.0);
        state[places[i]] += 1.0;
        state[places[j]] += 1.0;
        Mechanics::new(equations, &state).kinetic_energy
    };
    let diagonal: Vec<f64> = (0..18).map(|i| energy(i, i) / 2.0).collect();
    DMatrix::from_fn(18, 18, |i, j| energy(i, j) - (diagonal[i] + diagonal[j]) / 2.0)
}
