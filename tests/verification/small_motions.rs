//! Undeformed, geometrically exact kinematics has the mass of superposition, and small motions are the same.
//!
//! [theory: geometrically-exact.inertia, structure.integrals]

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::{EquationsOfMotion, Fidelity};
use flexible_aircraft::plant::{Plant, PlantSettings, Trim, TrimPoint};
use flexible_aircraft::structure::{ReducedModel, StrainEnergy};
use nalgebra::{DMatrix, Matrix3};

use crate::support::{jet, soft};

use super::record::Record;

#[test]
fn the_mass_matrix_of_the_undeformed_jet_is_that_of_the_modal_integrals() {
    let model = jet().select(&(0..12).collect::<Vec<_>>());
    let equations = EquationsOfMotion::new(&model, &soft(Fidelity::GeometricallyExact)).unwrap();
    let mass = equations.exact_mass_matrix(&vec![0.0; equations.layout().len()]);
    let integrals = &model.integrals;
    // Relative to the largest entry of each block.
    let apart = |[row, column]: [usize; 2], expected: DMatrix<f64>| {
        let block = mass.view((row, column), expected.shape());
        (block - &expected).amax() / expected.amax()
    };
    let rows = |vectors: &[nalgebra::Vector3<f64>]| DMatrix::from_fn(3, 12, |i, mode| vectors[mode][i]);
    let inertia: &Matrix3<f64> = &integrals.inertia;
    let mut record = Record::new(
        "undeformed-mass",
        "Jet with 12 modes, geometrically exact and undeformed: largest difference of an entry, over the largest of its block",
        "the modal integrals, of particles",
    );
    record.rounding("M − 1", 2e-14, apart([6, 6], DMatrix::identity(12, 12)));
    record.rounding("P − p", 2e-14, apart([0, 6], rows(&integrals.momentum)));
    record.rounding("H − h", 2e-14, apart([3, 6], rows(&integrals.angular_momentum)));
    record.rounding("Ĵ − J₀", 2e-14, apart([3, 3], DMatrix::from_fn(3, 3, |i, j| inertia[(i, j)])));
    record.finish();
}

/// The jet without weight, drag and incidence of the tail: flying along its axis it is not loaded.
fn unloaded() -> ReducedModel {
    let text = include_str!("../../aircraft/generic-business-jet.toml");
    assert_eq!(text.matches("incidence_deg = -1.5").count(), 1);
    let level = text.replace("incidence_deg = -1.5", "incidence_deg = 0");
    let mut aircraft = Aircraft { gravity: 0.0, ..Aircraft::parse(&level, "jet.toml").unwrap() };
    aircraft.strips.iter_mut().for_each(|strip| strip.profile_drag = 0.0);
    ReducedModel::new(&aircraft, 12).unwrap()
}

/// The state matrix of undeformed flight along the body axis.
fn state_matrix(model: &ReducedModel, fidelity: Fidelity) -> DMatrix<f64> {
    let settings = PlantSettings { fidelity, inflow_states: 2, ..PlantSettings::of(model) };
    let plant = Plant::under(model, &settings).unwrap();
    let layout = plant.layout();
    let mut state = vec![0.0; layout.len()];
    state[layout.position().end - 1] = -settings.altitude;
    state[layout.attitude().start] = 1.0;
    state[layout.velocity().start] = settings.airspeed;
    let trim =
        Trim { point: TrimPoint::default(), controls: plant.neutral_controls(), state, unknowns: Vec::new() };
    let mut rates = vec![0.0; trim.state.len()];
    plant.rates(&trim.state, &trim.controls, &mut rates, &mut plant.workspace());
    let loaded = plant.layout().coordinate_rates().map(|place| rates[place].abs()).fold(0.0, f64::max);
    assert!(loaded < 1e-9, "{loaded}");
    plant.linearise(&trim).matrix
}

#[test]
fn small_motions_about_the_unloaded_jet_are_those_of_superposition() {
    let model = unloaded();
    // Of the axially rigid beams, as the level has it.
    let frequencies = model.modes.iter().map(|mode| mode.angular_frequency);
    let superposed =
        ReducedModel { strain_energy: StrainEnergy::of_superposed_strains(frequencies), ..model.clone() };
    let exact = state_matrix(&model, Fidelity::GeometricallyExact);
    let expected = state_matrix(&superposed, Fidelity::Exact);
    let mut largest = 0.0_f64;
    for (row, expected) in exact.row_iter().zip(expected.row_iter()) {
        largest = largest.max((row - expected).amax() / expected.amax());
    }
    let mut record = Record::new(
        "unloaded-jacobian",
        "State matrix of the jet with 12 modes flying unloaded (no weight, no drag, incidence of the tail 0), N = 2: GE against E",
        "E with K₀ = diag ω², for its own K₀ has the real axial stiffness; largest difference of an entry, over the largest of its row",
    );
    record.rounding("largest difference", 1e-13, largest);
    record.finish();
}
