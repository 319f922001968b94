//! The beam element: static deflections of a cantilever are those of Euler–Bernoulli beam theory, to rounding
//! where the element is exact and of second order where loads or masses are lumped in bays; natural frequencies
//! converge to the closed forms with second order; all of it in any orientation.

use flexible_aircraft::structure::{ModalBasis, Structure};
use nalgebra::{Cholesky, DMatrix, DVector, Vector3};

use super::record::Record;
use crate::support::beams::{Cantilever, MIDDLE};

/// Bending in local y is twice as stiff as in local z; all families mix in the frequency band.
fn cantilever(axis: Vector3<f64>, y_axis: Vector3<f64>) -> Cantilever {
    Cantilever {
        axis,
        y_axis,
        length: 6.0,
        axial: 1e5,
        torsional: 0.02,
        bending_y: 1e4,
        bending_z: 4e4,
        mass_per_length: 10.0,
        gyration: 1e-3,
        lumps: MIDDLE,
    }
}

/// Along x, along y with the section turned, and askew in all axes.
fn orientations() -> [(&'static str, Cantilever); 3] {
    let axis = Vector3::new(1.0, 2.0, -2.0) / 3.0;
    let y_axis = Vector3::new(2.0, 1.0, 2.0) / 3.0;
    let skew =
        (axis * libm::cos(0.4) + y_axis * libm::sin(0.4), y_axis * libm::cos(0.4) - axis * libm::sin(0.4));
    [
        ("along x", cantilever(Vector3::x(), Vector3::y())),
        ("along y", cantilever(Vector3::y(), Vector3::new(0.6, 0.0, 0.8))),
        ("askew", cantilever(skew.0, skew.1)),
    ]
}

/// Tip displacement and rotation in local axes under a tip force and a tip moment in local axes.
fn tip_under_load(
    beam: &Cantilever,
    elements: usize,
    force: Vector3<f64>,
    moment: Vector3<f64>,
) -> [Vector3<f64>; 2] {
    let aircraft = beam.aircraft(elements);
    let structure = Structure::new(&aircraft).unwrap();
    let last = structure.unknowns() - 6;
    let mut load = DVector::zeros(structure.unknowns());
    load.fixed_rows_mut::<3>(last).copy_from(&(beam.axes() * force));
    load.fixed_rows_mut::<3>(last + 3).copy_from(&(beam.axes() * moment));
    let solution = Cholesky::new(structure.stiffness(false)).unwrap().solve(&load);
    [last, last + 3].map(|row| beam.axes().transpose() * solution.fixed_rows::<3>(row))
}

#[test]
fn static_deflections_under_tip_loads_are_exact_in_every_direction() {
    let mut record = Record::new(
        "beam-static",
        "Cantilever under tip loads, 5 elements: deflections (m) and slopes (rad)",
        "Euler–Bernoulli: PL³/3EI, PL²/2EI, ML²/2EI, ML/EI, PL/EA, TL/GJ (Gere, Timoshenko, *Mechanics of Materials*, appendix G); \
         right-handed rotations φ_y = −w′, φ_z = v′",
    );
    for (name, beam) in orientations() {
        let beam = Cantilever { torsional: 5e3, ..beam };
        let l = beam.length;
        let (force, moment) = (Vector3::new(40.0, 7.0, -3.0), Vector3::new(12.0, 5.0, 9.0));
        let [u, phi] = tip_under_load(&beam, 5, force, moment);
        let (ei_y, ei_z) = (beam.bending_y, beam.bending_z);
        let expected = [
            ("stretch", u.x, force.x * l / beam.axial),
            ("v", u.y, force.y * l.powi(3) / (3.0 * ei_z) + moment.z * l * l / (2.0 * ei_z)),
            ("w", u.z, force.z * l.powi(3) / (3.0 * ei_y) - moment.y * l * l / (2.0 * ei_y)),
            ("twist", phi.x, moment.x * l / beam.torsional),
            ("−w′", phi.y, -force.z * l * l / (2.0 * ei_y) + moment.y * l / ei_y),
            ("v′", phi.z, force.y * l * l / (2.0 * ei_z) + moment.z * l / ei_z),
        ];
        for (quantity, found, expected) in expected {
            record.relative(&format!("{name}: {quantity}"), expected, 1e-9, found);
        }
    }
    record.finish();
}

/// Tip deflection w under a uniform load carried by the bays, relative error against qL⁴/8EI.
fn uniform_load_error(elements: usize) -> f64 {
    let beam = cantilever(Vector3::y(), Vector3::x());
    let aircraft = beam.aircraft(elements);
    let structure = Structure::new(&aircraft).unwrap();
    let mut load = DVector::zeros(structure.unknowns());
    let step = beam.length / elements as f64;
    for (element, geometry) in structure.geometry.iter().enumerate() {
        let (translation, _) = geometry.section(0.5);
        let nodal = translation.transpose() * (beam.axes() * Vector3::z() * step);
        for local in 0..12 {
            if let Some(unknown) = (6 * element + local).checked_sub(6) {
                load[unknown] += nodal[local];
            }
        }
    }
    let solution = Cholesky::new(structure.stiffness(false)).unwrap().solve(&load);
    let tip = solution.fixed_rows::<3>(structure.unknowns() - 6).into_owned();
    let expected = beam.length.powi(4) / (8.0 * beam.bending_y);
    (tip.dot(&(beam.axes() * Vector3::z())) / expected - 1.0).abs()
}

#[test]
fn a_uniform_load_lumped_in_bays_converges_with_second_order() {
    let mut record = Record::new(
        "beam-uniform-load",
        "Cantilever under a uniform load lumped at the middle of each element: error of the tip deflection",
        "qL⁴/8EI; a midpoint rule is of second order",
    );
    let errors = [8, 16, 32].map(uniform_load_error);
    record.error("32 elements, relative error", 1e-3, errors[2]);
    record.absolute("order of convergence, 16 to 32 elements", 2.0, 0.02, libm::log2(errors[1] / errors[2]));
    record.finish();
}

/// The kinds of motion of a straight beam.
const KINDS: [&str; 4] = ["axial", "bending in y", "bending in z", "torsion"];

/// The three lowest frequencies (rad/s) of each kind.
fn frequencies(beam: &Cantilever, elements: usize) -> [Vec<f64>; 4] {
    let aircraft = beam.aircraft(elements);
    let structure = Structure::new(&aircraft).unwrap();
    let basis = ModalBasis::new(&structure, 24).unwrap();
    let mut found = [const { Vec::new() }; 4];
    for (mode, shape) in basis.modes.iter().zip(basis.shapes.column_iter()) {
        let tip = structure.unknowns() - 6;
        let u = beam.axes().transpose() * shape.fixed_rows::<3>(tip);
        let phi = beam.axes().transpose() * shape.fixed_rows::<3>(tip + 3);
        let sizes = [u.x, u.y, u.z, phi.x * beam.gyration].map(f64::abs);
        let kind = (0..4).max_by(|&a, &b| sizes[a].total_cmp(&sizes[b])).unwrap();
        found[kind].push(mode.angular_frequency);
    }
    found.map(|kind| kind[..3].to_vec())
}

/// Closed forms for the same.
fn closed_forms(beam: &Cantilever) -> [Vec<f64>; 4] {
    // Roots of cos βL cosh βL = −1 (Blevins, Formulas for Natural Frequency and Mode Shape, table 8-1).
    const BENDING: [f64; 3] = [1.875_104_068_7, 4.694_091_133_0, 7.854_757_438_2];
    let (m, l) = (beam.mass_per_length, beam.length);
    let bending = |ei: f64| BENDING.iter().map(|b| b * b / (l * l) * libm::sqrt(ei / m)).collect();
    let rod = |speed: f64| (0..3).map(|k| (k as f64 + 0.5) * std::f64::consts::PI / l * speed).collect();
    let polar = m * beam.gyration * beam.gyration;
    [
        rod(libm::sqrt(beam.axial / m)),
        bending(beam.bending_z),
        bending(beam.bending_y),
        rod(libm::sqrt(beam.torsional / polar)),
    ]
}

#[test]
fn frequencies_converge_to_the_closed_forms_with_second_order() {
    let mut record = Record::new(
        "beam-frequencies",
        "Frequencies of a cantilever, rad/s, extrapolated from 32 and 64 elements, and the order of convergence of the lumped mass",
        "roots of cos βL cosh βL = −1; (2k − 1)π/2L · √(EA/m) and √(GJ/I) (Blevins, *Formulas for Natural Frequency and Mode \
         Shape*, chapter 8); masses lumped at the middle of elements are of second order",
    );
    let beam = cantilever(Vector3::y(), Vector3::x());
    let [coarse, middle, fine] = [16, 32, 64].map(|elements| frequencies(&beam, elements));
    let exact = closed_forms(&beam);
    for (kind, name) in KINDS.iter().enumerate() {
        for mode in 0..3 {
            let [c, m, f] = [coarse[kind][mode], middle[kind][mode], fine[kind][mode]];
            let case = format!("{name} {}", mode + 1);
            record.relative(&case, exact[kind][mode], 2e-5, f + (f - m) / 3.0);
            record.absolute(&format!("{case}, order"), 2.0, 0.05, libm::log2((m - c) / (f - m)));
        }
    }
    record.finish();
}

#[test]
fn frequencies_do_not_depend_on_the_orientation() {
    let mut record = Record::new(
        "beam-orientation",
        "The same beam in other directions: largest relative change of the frequencies above, 8 elements",
        "isotropy",
    );
    let reference = frequencies(&cantilever(Vector3::y(), Vector3::x()), 8);
    for (name, beam) in orientations() {
        let found = frequencies(&beam, 8);
        let pairs = found.iter().flatten().zip(reference.iter().flatten());
        let largest = pairs.map(|(found, reference)| (found / reference - 1.0).abs()).fold(0.0, f64::max);
        record.rounding(name, 1e-7, largest);
    }
    record.finish();
}

#[test]
fn the_stiffness_matrix_resists_no_rigid_motion_of_two_free_elements() {
    let mut record = Record::new(
        "beam-rigid-body",
        "Elastic force of an element in rigid motion, relative to its largest stiffness",
        "a rigid motion strains nothing",
    );
    let (_, beam) = &orientations()[2];
    let aircraft = beam.aircraft(2);
    let structure = Structure::new(&aircraft).unwrap();
    let geometry = &structure.geometry[1];
    let stiffness = geometry.stiffness(&aircraft.beams[1], beam.axial);
    let mut motions = DMatrix::zeros(12, 6);
    for end in 0..2 {
        let place = aircraft.nodes[aircraft.beams[1].nodes[end]];
        for axis in 0..3 {
            let unit = Vector3::ith(axis, 1.0);
            motions.fixed_view_mut::<3, 1>(6 * end, axis).copy_from(&unit);
            motions.fixed_view_mut::<3, 1>(6 * end, 3 + axis).copy_from(&unit.cross(&place));
            motions.fixed_view_mut::<3, 1>(6 * end + 3, 3 + axis).copy_from(&unit);
        }
    }
    record.rounding("six rigid motions", 5e-15, (stiffness * motions).amax() / stiffness.amax());
    record.finish();
}
