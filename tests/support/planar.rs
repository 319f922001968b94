//! Cantilevers along x in bases that bend them in one plane, with a station at the tip.

use flexible_aircraft::aircraft::{Aircraft, Attachment, Station};
use flexible_aircraft::equations::{Configuration, Fidelity};
use flexible_aircraft::plant::Plant;
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
    Plant::new(model, &configuration)
}
