//! One beam described in other axes: with local y and z turned about x, or with its reference axis elsewhere.
//!
//! Nothing of the structure is asked; places and moments of second order are those of a vector and of a tensor in the plane.

use flexible_aircraft::aircraft::{Beam, Coupling};
use nalgebra::{Matrix2, Vector2, Vector3};

/// With another local y axis, across the same beam, whose direction this is.
pub fn turned(beam: &Beam, along: &Vector3<f64>, y_axis: Vector3<f64>) -> Beam {
    let z_axis = along.cross(&beam.y_axis);
    let (cos, sin) = (y_axis.dot(&beam.y_axis), y_axis.dot(&z_axis));
    // From components along y and z to those along the others.
    let turn = Matrix2::new(cos, sin, -sin, cos);
    let place = |[y, z]: [f64; 2]| (turn * Vector2::new(y, z)).into();
    let Coupling { bending, bend_twist: [k_w, k_v], stretch_by_twist, tension_axis, shear_centre } =
        beam.coupling;
    // The tensor ∫E r rᵀ dA: with y y, y z and z z.
    let second = Matrix2::new(beam.bending_stiffness_z, bending, bending, beam.bending_stiffness_y);
    let second = turn * second * turn.transpose();
    // Torsion goes with the vector of the curvatures v″ and w″.
    let [k_v, k_w] = place([k_v, k_w]);
    Beam {
        y_axis,
        bending_stiffness_z: second[(0, 0)],
        bending_stiffness_y: second[(1, 1)],
        coupling: Coupling {
            bending: second[(0, 1)],
            bend_twist: [k_w, k_v],
            stretch_by_twist,
            tension_axis: place(tension_axis),
            shear_centre: place(shear_centre),
        },
        ..beam.clone()
    }
}

/// Of the same section about a reference axis that runs at (y, z) of the one before.
pub fn about(coupling: &Coupling, [y, z]: [f64; 2]) -> Coupling {
    let place = |[y_of, z_of]: [f64; 2]| [y_of - y, z_of - z];
    Coupling {
        tension_axis: place(coupling.tension_axis),
        shear_centre: place(coupling.shear_centre),
        ..*coupling
    }
}
