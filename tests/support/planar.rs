//! Cantilevers along x in bases that bend them in one plane, with a station at the tip.

use flexible_aircraft::aircraft::{Aircraft, Attachment, Station};
use flexible_aircraft::equations::{Configuration, Fidelity};
use flexible_aircraft::plant::{Plant, PointLoad};
use flexible_aircraft::structure::{ModalBasis, ReducedModel, Structure};
use nalgebra::{Cholesky, DMatrix, DVector, Vector3};

use super::ritz::ritz_modes;

/// The station's name.
pub const TIP: &str = "tip";

/// With a station at the end of its last element.
pub fn with_tip(mut aircraft: Aircraft) -> Aircraft {
    let attachment = Attachment { beam: aircraft.beams.len() - 1, fraction: 1.0 };
    aircraft.stations.push(Station { name: TIP.to_owned(), attachment, twist_axis: Vector3::x() });
    aircraft
}

/// In natural modes and the shapes that a force and a moment at the tip give the structure.
pub fn with_strains_of_tip_loads(aircraft: &Aircraft, natural: usize) -> ReducedModel {
    let structure = Structure::new(aircraft).unwrap();
    let modes = ModalBasis::new(&structure, natural).unwrap();
    let tip = structure.unknowns() - 6;
    let factor = Cholesky::new(structure.stiffness(true)).unwrap();
    let strain = |row: usize| {
        let load = DVector::from_fn(structure.unknowns(), |place, _| f64::from(u8::from(place == tip + row)));
        let shape = factor.solve(&load);
        &shape / shape.amax()
    };
    // Force along z, moment about y.
    let columns: Vec<DVector<f64>> = modes
        .shapes
        .column_iter()
        .map(|column| column / column.amax())
        .chain([strain(2), strain(4)])
        .collect();
    let (modes, shapes) = ritz_modes(&structure, &DMatrix::from_columns(&columns));
    ReducedModel::of_basis(&structure, ModalBasis::of_shapes(modes, shapes)).unwrap()
}

/// At a level, without air and damping.
pub fn plant(model: &ReducedModel, fidelity: Fidelity) -> Plant {
    let configuration = Configuration {
        fidelity,
        stiffness_scale: 1.0,
        structural_damping: 0.0,
        inflow_states: 0,
        temperature_offset: 0.0,
        tunnel_flow: Vector3::zeros(),
    };
    Plant::new(model, &configuration).unwrap()
}

/// Parts in which the load grows: Newton's method does not always lead from straight to far bent in one.
const PARTS: usize = 8;

/// Where the tip rests under a dead force and a moment that follows the section, both from nothing on.
pub fn tip(plant: &Plant, model: &ReducedModel, force: Vector3<f64>, moment: Vector3<f64>) -> Vector3<f64> {
    let mut state = vec![0.0; plant.layout().len()];
    state[plant.layout().attitude().start] = 1.0;
    for part in 1..=PARTS {
        let share = part as f64 / PARTS as f64;
        let load = PointLoad { station: TIP.to_owned(), force: force * share, moment: moment * share };
        come_to_rest(&plant.clone().under_loads(&[load]).unwrap(), &mut state);
    }
    let outputs = plant.outputs_at(&state, &plant.neutral_controls(), &mut plant.workspace());
    model.stations[0].position + outputs.deflections[0].displacement
}

/// Changes q until no force is left on it, by Newton's method.
fn come_to_rest(plant: &Plant, state: &mut [f64]) {
    const STEP: f64 = 1e-5;
    let (coordinates, controls) = (plant.layout().coordinates(), plant.neutral_controls());
    let (mut workspace, mut rates) = (plant.workspace(), vec![0.0; state.len()]);
    let mut force = |state: &[f64]| {
        plant.rates(state, &controls, &mut rates, &mut workspace);
        DVector::from_row_slice(&workspace.forces()[6..])
    };
    for _ in 0..20 {
        let columns: Vec<DVector<f64>> = coordinates
            .clone()
            .map(|place| {
                let [ahead, behind] = [STEP, -STEP].map(|step| {
                    let mut moved = state.to_vec();
                    moved[place] += step;
                    force(&moved)
                });
                (ahead - behind) / (2.0 * STEP)
            })
            .collect();
        let change = DMatrix::from_columns(&columns).lu().solve(&force(state)).unwrap();
        state[coordinates.clone()].iter_mut().zip(change.iter()).for_each(|(q, change)| *q -= change);
        if change.amax() < 1e-8 {
            return;
        }
    }
    panic!("no rest found");
}
