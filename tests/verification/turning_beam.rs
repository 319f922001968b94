//! The spin-up of Kane's beam under geometrically exact kinematics, in bending modes alone.
//!
//! [theory: geometrically-exact.inertia, geometrically-exact.energy]
//!
//! Strains of bending stretch nothing, so that centrifugal force stiffens the beam without axial–bending coupling in the energy. Its
//! axial stiffness has a part only where an axial strain is among the shapes.

use flexible_aircraft::equations::{Fidelity, Workspace};
use flexible_aircraft::plant::Plant;
use flexible_aircraft::structure::{ModalBasis, ReducedModel, Structure};
use nalgebra::{Cholesky, DMatrix, DVector, Vector3};

use crate::support::kane::{
    Base, DENSITY, FROM_REST, History, LENGTH, SPIN_UP, YOUNG, beam, integrate, kane,
};
use crate::support::planar::{plant, with_tip};
use crate::support::ritz::ritz_modes;

use super::record::Record;

/// The beam along x, turning about z, in three bending modes and the strain that its own centrifugal force makes, if it is to stretch.
fn model(stretches: bool) -> ReducedModel {
    let aircraft = with_tip(beam(1e4).aircraft(80));
    let structure = Structure::new(&aircraft).unwrap();
    let bending = ModalBasis::new(&structure, 3).unwrap();
    if !stretches {
        return ReducedModel::of_basis(&structure, bending).unwrap();
    }
    let mut centrifugal = structure.mass() * along(&structure, |node| aircraft.nodes[node].x);
    centrifugal /= centrifugal.amax();
    let stretch = Cholesky::new(structure.stiffness(false)).unwrap().solve(&centrifugal);
    let columns: Vec<DVector<f64>> =
        bending.shapes.column_iter().map(|column| column / column.amax()).collect();
    let stretch = &stretch / stretch.amax();
    let (modes, shapes) = ritz_modes(&structure, &DMatrix::from_columns(&[columns, vec![stretch]].concat()));
    ReducedModel::of_basis(&structure, ModalBasis::of_shapes(modes, shapes)).unwrap()
}

/// Nodal displacements along x.
fn along(structure: &Structure, displacement: impl Fn(usize) -> f64) -> DVector<f64> {
    let mut column = DVector::zeros(structure.unknowns());
    (1..=structure.geometry.len()).for_each(|node| column[6 * (node - 1)] = displacement(node));
    column
}

/// Where the tip is at some q.
fn tip(plant: &Plant, q: &DVector<f64>) -> Vector3<f64> {
    let layout = plant.layout();
    let mut state = vec![0.0; layout.len()];
    state[layout.attitude().start] = 1.0;
    state[layout.coordinates()].copy_from_slice(q.as_slice());
    let outputs = plant.outputs_at(&state, &plant.neutral_controls(), &mut plant.workspace());
    Vector3::x() * LENGTH + outputs.deflections[0].displacement
}

/// The beam's equations with the motion of its base prescribed.
struct Turning {
    plant: Plant,
    workspace: Workspace,
    base: Base,
}

impl Turning {
    fn new(model: &ReducedModel, base: Base) -> Self {
        let plant = plant(model, Fidelity::GeometricallyExact);
        Turning { workspace: plant.workspace(), plant, base }
    }

    /// q̈: what the equations of the clamped beam say at ω held, less what ω̇ does to the generalised rows.
    fn acceleration(&mut self, time: f64, q: &DVector<f64>, q_dot: &DVector<f64>) -> DVector<f64> {
        let Turning { plant, workspace, base } = self;
        let (layout, n) = (plant.layout(), q.len());
        let (rate, rate_change) = base.turns(time);
        let mut state = vec![0.0; layout.len()];
        state[layout.attitude().start] = 1.0;
        state[layout.rate().end - 1] = rate;
        state[layout.coordinates()].copy_from_slice(q.as_slice());
        state[layout.coordinate_rates()].copy_from_slice(q_dot.as_slice());
        plant.rates(&state, &plant.neutral_controls(), &mut vec![0.0; state.len()], workspace);
        let held = DVector::from_row_slice(&workspace.accelerations()[6..]);
        if rate_change == 0.0 {
            return held;
        }
        let mass = plant.equations().exact_mass_matrix(&state);
        let forcing = mass.view((6, 5), (n, 1)) * rate_change;
        held - mass.view((6, 6), (n, n)).into_owned().lu().solve(&forcing).unwrap()
    }

    /// Where the beam rests while its base turns steadily.
    fn equilibrium(&mut self) -> DVector<f64> {
        let rest = DVector::zeros(self.plant.layout().modes());
        let mut q = rest.clone();
        for _ in 0..5 {
            let here = self.acceleration(SPIN_UP, &q, &rest);
            let column = |mode: usize| {
                let mut moved = q.clone();
                moved[mode] += 1e-6;
                (self.acceleration(SPIN_UP, &moved, &rest) - &here) / 1e-6
            };
            let columns: Vec<_> = (0..q.len()).map(column).collect();
            q -= DMatrix::from_columns(&columns).lu().solve(&here).unwrap();
        }
        q
    }
}

/// Flies 20 s of the manoeuvre; the stretch is that of the tip's distance from the root.
fn spin_up(model: &ReducedModel, base: Base) -> History {
    let plant = plant(model, Fidelity::GeometricallyExact);
    let mut beam = Turning::new(model, base);
    let start = DVector::zeros(model.modes.len());
    integrate(
        start,
        5e-3,
        |time, q, q_dot| beam.acceleration(time, q, q_dot),
        |q| {
            let tip = tip(&plant, q);
            [-tip.y, tip.norm() - LENGTH]
        },
    )
}

#[test]
fn the_geometrically_exact_beam_lags_as_in_kanes_theory_and_stretches_only_where_it_can() {
    let mut record = Record::new(
        "spin-up-geometrically-exact",
        "The same spin-up, GE: three bending modes, and with the axial strain of centrifugal force beside them, 80 elements",
        "theory: Kane's, in its continuous form; an independent computation with the same three modes; stretch: ρω²L³/3E",
    );
    let theory = kane().spin_up(FROM_REST);
    let bending = spin_up(&model(false), FROM_REST);
    record.absolute("largest lag of the tip, theory, m", theory.peak_lag, 1e-3, bending.peak_lag);
    record.absolute("largest lag of the tip, independent, m", 0.5739, 1e-3, bending.peak_lag);
    record.absolute("time of the largest lag, independent, s", 6.762, 5e-3, bending.peak_time);
    record.absolute("lateral motion in the last two seconds, m", theory.residual, 5e-4, bending.residual);
    record.error("stretch in the last two seconds without axial strain, m", 1e-6, bending.stretch);
    let model = model(true);
    let rest = Turning::new(&model, FROM_REST).equilibrium();
    let found = tip(&plant(&model, Fidelity::GeometricallyExact), &rest).norm() - LENGTH;
    let stretch = DENSITY * 36.0 * LENGTH.powi(3) / (3.0 * YOUNG);
    record.relative("with axial strain: stretch at rest at 6 rad/s, m", stretch, 2e-3, found);
    record.finish();
}
