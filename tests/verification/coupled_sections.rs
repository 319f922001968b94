//! Sections that couple bending, torsion and stretch: closed forms of a cantilever under loads at its tip, frequencies against
//! Rayleigh and Ritz, and descriptions of one section in other axes.
//!
//! [theory: coupled-sections.energy, coupled-sections.element, coupled-sections.rigid, coupled-sections.higher]

use flexible_aircraft::aircraft::{Aircraft, Coupling, Fidelity, ModeBasis};
use flexible_aircraft::structure::{ModalBasis, StrainEnergy, Structure};
use nalgebra::{Cholesky, DMatrix, DVector, Matrix3, SymmetricEigen, Vector3};

use super::record::Record;
use crate::support::beams::{Cantilever, MIDDLE, askew};
use crate::support::planar::{TIP, plant, with_strains_of_tip_loads, with_tip};
use crate::support::random;

/// Displacement and rotation of the tip, local axes, under a force and a moment there.
fn tip(
    beam: &Cantilever,
    aircraft: &Aircraft,
    force: Vector3<f64>,
    moment: Vector3<f64>,
) -> [Vector3<f64>; 2] {
    let structure = Structure::new(aircraft).unwrap();
    let last = structure.unknowns() - 6;
    let mut load = DVector::zeros(structure.unknowns());
    load.fixed_rows_mut::<3>(last).copy_from(&(beam.axes() * force));
    load.fixed_rows_mut::<3>(last + 3).copy_from(&(beam.axes() * moment));
    let solution = Cholesky::new(structure.stiffness(false)).unwrap().solve(&load);
    [last, last + 3].map(|row| beam.axes().transpose() * solution.fixed_rows::<3>(row))
}

#[test]
fn a_bend_twist_cantilever_under_loads_at_its_tip_is_that_of_the_inverse_of_its_stiffness() {
    let mut record = Record::new(
        "bend-twist-static",
        "Cantilever that twists as it bends, under a force P and a torque T at its tip, by one element and by five: m and rad",
        "the inverse of the section's stiffness, w″ = (GJ·M − K·T)/D and φ′ = (EI·T − K·M)/D with M = P (L − x) and D = EI·GJ − K², \
         integrated",
    );
    let beam = askew();
    let (ei, gj, k, l) = (beam.bending_y, beam.torsional, 5e3, beam.length);
    let determinant = ei * gj - k * k;
    let (p, t) = (-3.0, 12.0);
    let [w, slope] = [
        (gj * p * l.powi(3) / 3.0 - k * t * l * l / 2.0) / determinant,
        (gj * p * l * l / 2.0 - k * t * l) / determinant,
    ];
    let twist = (ei * t * l - k * p * l * l / 2.0) / determinant;
    for elements in [1, 5] {
        let aircraft = beam.coupled(elements, Coupling { bend_twist: [k, 0.0], ..Coupling::NONE });
        let [u, phi] = tip(&beam, &aircraft, Vector3::z() * p, Vector3::x() * t);
        record.relative(&format!("{elements}: w"), w, 1e-9, u.z);
        record.relative(&format!("{elements}: w′"), slope, 1e-9, -phi.y);
        record.relative(&format!("{elements}: twist"), twist, 1e-9, phi.x);
    }
    record.finish();
}

#[test]
fn all_strains_of_a_coupled_section_answer_constant_forces_by_the_inverse_of_its_stiffness() {
    let mut record = Record::new(
        "coupled-section-static",
        "The same with all couplings, tension axis and shear centre apart, under axial force, torque and two moments at its tip, three \
         elements: mean strains in 1e-3 and 1e-3/m",
        "the inverse of the section's 4 × 4 stiffness; moments of the axial force about the tension axis",
    );
    let beam = askew();
    let coupling = Coupling {
        bending: 9e3,
        bend_twist: [3e3, -4e3],
        stretch_by_twist: 2e-3,
        tension_axis: [0.03, -0.02],
        shear_centre: [-0.05, 0.04],
    };
    let aircraft = beam.coupled(3, coupling);
    let (force, moment) = (Vector3::x() * 900.0, Vector3::new(12.0, 7.0, -9.0));
    let [u, phi] = tip(&beam, &aircraft, force, moment);
    // On u′, φ′, v″, w″: the row of the axial force, and what is left of the energy.
    let [y_t, z_t] = coupling.tension_axis;
    let row = nalgebra::RowVector4::new(1.0, coupling.stretch_by_twist, -y_t, -z_t);
    let [k_w, k_v] = coupling.bend_twist;
    let mut stiffness = row.transpose() * row * beam.axial;
    let rest = Matrix3::new(
        beam.torsional,
        k_v,
        k_w,
        k_v,
        beam.bending_z,
        coupling.bending,
        k_w,
        coupling.bending,
        beam.bending_y,
    );
    let mut block = stiffness.fixed_view_mut::<3, 3>(1, 1);
    block += rest;
    let loads = nalgebra::Vector4::new(force.x, moment.x, moment.z, -moment.y);
    let strains = stiffness.try_inverse().unwrap() * loads * 1e3;
    let found = [u.x, phi.x, phi.z, -phi.y].map(|total| 1e3 * total / beam.length);
    for (name, (expected, found)) in ["u′", "φ′", "v″", "w″"].iter().zip(strains.iter().zip(found)) {
        record.relative(name, *expected, 1e-9, found);
    }
    record.finish();
}

#[test]
fn axes_that_are_apart_bend_and_twist_by_forces_beside_them() {
    let mut record = Record::new(
        "axes-apart-static",
        "Cantilever with its tension axis at z_t, its shear centre at y_s, under forces at the tip of the reference axis, one element",
        "the axial force N bends by the moment N z_t about y: w = N z_t L²/2EI, u = NL/EA + N z_t² L/EI; a transverse force P twists by \
         −y_s P: w = PL³/3EI + y_s² PL/GJ, φ = −y_s PL/GJ",
    );
    let beam = askew();
    let (l, ei, gj) = (beam.length, beam.bending_y, beam.torsional);
    let (z_t, y_s) = (0.07, -0.11);
    let coupling = Coupling { tension_axis: [0.0, z_t], shear_centre: [y_s, 0.0], ..Coupling::NONE };
    let aircraft = beam.coupled(1, coupling);
    let n = 400.0;
    let [u, _] = tip(&beam, &aircraft, Vector3::x() * n, Vector3::zeros());
    record.relative("N: w", n * z_t * l * l / (2.0 * ei), 1e-9, u.z);
    record.relative("N: u", n * l / beam.axial + n * z_t * z_t * l / ei, 1e-9, u.x);
    let p = 30.0;
    let [u, phi] = tip(&beam, &aircraft, Vector3::z() * p, Vector3::zeros());
    record.relative("P: w", p * l.powi(3) / (3.0 * ei) + y_s * y_s * p * l / gj, 1e-9, u.z);
    record.relative("P: φ", -y_s * p * l / gj, 1e-9, phi.x);
    record.finish();
}

/// The largest of the coefficients of U₂, U₃ and U₄ and their largest differences, by values along random directions.
fn energies_differ_by(one: &StrainEnergy, other: &StrainEnergy, modes: usize) -> [f64; 3] {
    let mut next = random(11);
    let mut worst = [0.0_f64; 3];
    for _ in 0..20 {
        let q: Vec<f64> = (0..modes).map(|_| next()).collect();
        let unused = &mut vec![0.0; modes];
        let mut values = |energy: &StrainEnergy| {
            [energy.add_quadratic(&q, unused), energy.add_cubic(&q, unused), energy.add_quartic(&q, unused)]
        };
        let (one, other) = (values(one), values(other));
        // U₃ may be small by chance: it is held against what bounds it.
        let sizes = [one[0], (one[0] * one[2]).sqrt(), one[2]];
        for order in 0..3 {
            worst[order] = worst[order].max((one[order] - other[order]).abs() / sizes[order]);
        }
    }
    worst
}

#[test]
fn a_section_turned_in_its_axes_is_that_of_turned_axes() {
    let mut record = Record::new(
        "turned-section",
        "EI_yz of a section whose principal axes are turned by 0.4 rad, against a turned y_axis: stiffness matrix, U₂, U₃, U₄",
        "the same section in other axes",
    );
    let principal = askew();
    let (sin, cos) = libm::sincos(0.4);
    // Local y of the other description is principal y turned by −0.4 about x.
    let z_axis = principal.axis.cross(&principal.y_axis);
    let (one, other) = (principal.bending_z, principal.bending_y);
    let turned = Cantilever {
        y_axis: principal.y_axis * cos - z_axis * sin,
        bending_z: one * cos * cos + other * sin * sin,
        bending_y: one * sin * sin + other * cos * cos,
        ..principal.clone()
    };
    let product = Coupling { bending: (one - other) * sin * cos, ..Coupling::NONE };
    let (one, other) = (principal.aircraft(4), turned.coupled(4, product));
    let [one, other] = [&one, &other].map(|aircraft| Structure::new(aircraft).unwrap());
    let [k, k_other] = [&one, &other].map(|structure| structure.stiffness(false));
    record.rounding("stiffness", 2e-15, (&k - &k_other).amax() / k.amax());
    let shapes = ModalBasis::new(&one, 12).unwrap().shapes;
    let [one, other] = [&one, &other].map(|structure| StrainEnergy::new(structure, &shapes));
    for (order, differ) in energies_differ_by(&one, &other, 12).into_iter().enumerate() {
        record.rounding(&format!("U{}", order + 2), 1e-14, differ);
    }
    record.finish();
}

#[test]
fn tension_axis_and_shear_centre_together_beside_the_axis_are_a_beam_beside_it() {
    let mut record = Record::new(
        "offset-beam",
        "Tension axis and shear centre at one place beside the reference axis, against a beam there with rigid arms: stiffness matrix, U₂, U₃, U₄",
        "the same beam with its nodes elsewhere",
    );
    let beam = askew();
    let apart = [0.15, -0.08];
    let coupling = Coupling { bending: 7e3, bend_twist: [2e3, 1e3], ..Coupling::NONE };
    let there = beam.coupled(4, coupling);
    let here = beam.coupled(4, Coupling { tension_axis: apart, shear_centre: apart, ..coupling });
    let [there, here] = [&there, &here].map(|aircraft| Structure::new(aircraft).unwrap());
    // What nodes at the offset do by what those on the axis do.
    let offset = beam.axes() * Vector3::new(0.0, apart[0], apart[1]);
    let mut arms = DMatrix::identity(here.unknowns(), here.unknowns());
    for node in (0..here.unknowns()).step_by(6) {
        arms.fixed_view_mut::<3, 3>(node, node + 3).copy_from(&-offset.cross_matrix());
    }
    let carried = arms.transpose() * there.stiffness(false) * &arms;
    let stiffness = here.stiffness(false);
    record.rounding("stiffness", 2e-15, (&stiffness - carried).amax() / stiffness.amax());
    let shapes = ModalBasis::new(&here, 12).unwrap().shapes;
    let (one, other) = (StrainEnergy::new(&here, &shapes), StrainEnergy::new(&there, &(&arms * &shapes)));
    for (order, differ) in energies_differ_by(&one, &other, 12).into_iter().enumerate() {
        record.rounding(&format!("U{}", order + 2), 1e-14, differ);
    }
    record.finish();
}

/// Polynomials on 0 to 1 that are orthogonal there, times a power of x: coefficients of 1, x, x² …
fn polynomials(power: usize, count: usize) -> Vec<Vec<f64>> {
    let mut all: Vec<Vec<f64>> = vec![vec![1.0], vec![-1.0, 2.0]];
    for n in 1..count {
        let (a, b) = ((2 * n + 1) as f64 / (n + 1) as f64, n as f64 / (n + 1) as f64);
        let mut next = vec![0.0; n + 2];
        for (i, c) in all[n].iter().enumerate() {
            next[i] -= a * c;
            next[i + 1] += 2.0 * a * c;
        }
        for (i, c) in all[n - 1].iter().enumerate() {
            next[i] -= b * c;
        }
        all.push(next);
    }
    all.truncate(count);
    all.iter().map(|p| [vec![0.0; power], p.clone()].concat()).collect()
}

fn derivative(p: &[f64], times: usize) -> Vec<f64> {
    (0..times).fold(p.to_vec(), |p, _| p.iter().enumerate().skip(1).map(|(i, c)| i as f64 * c).collect())
}

fn integral(one: &[f64], other: &[f64]) -> f64 {
    let products = one
        .iter()
        .enumerate()
        .flat_map(|(i, a)| other.iter().enumerate().map(move |(j, b)| a * b / (i + j + 1) as f64));
    products.sum()
}

/// Angular frequencies of a cantilever that bends and twists: EI, GJ, K, mass per length, polar inertia per length, length.
fn ritz([ei, gj, k, mass, inertia, length]: [f64; 6]) -> Vec<f64> {
    const COUNT: usize = 9;
    let (w, phi) = (polynomials(2, COUNT), polynomials(1, COUNT));
    let (mut stiffness, mut masses) =
        (DMatrix::zeros(2 * COUNT, 2 * COUNT), DMatrix::zeros(2 * COUNT, 2 * COUNT));
    for i in 0..COUNT {
        for j in 0..COUNT {
            let (bend, twist) = (derivative(&w[i], 2), derivative(&phi[j], 1));
            stiffness[(i, j)] = ei / length.powi(3) * integral(&bend, &derivative(&w[j], 2));
            stiffness[(COUNT + i, COUNT + j)] = gj / length * integral(&derivative(&phi[i], 1), &twist);
            stiffness[(i, COUNT + j)] = k / length.powi(2) * integral(&bend, &twist);
            stiffness[(COUNT + j, i)] = stiffness[(i, COUNT + j)];
            masses[(i, j)] = mass * length * integral(&w[i], &w[j]);
            masses[(COUNT + i, COUNT + j)] = inertia * length * integral(&phi[i], &phi[j]);
        }
    }
    let lower = Cholesky::new(masses).unwrap().l();
    let half = lower.solve_lower_triangular(&stiffness).unwrap();
    let whole = lower.solve_lower_triangular(&half.transpose()).unwrap();
    let mut squares: Vec<f64> =
        SymmetricEigen::new((&whole + whole.transpose()) * 0.5).eigenvalues.iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    squares.into_iter().map(libm::sqrt).collect()
}

#[test]
fn frequencies_of_a_bend_twist_cantilever_are_those_of_rayleigh_and_ritz() {
    let mut record = Record::new(
        "bend-twist-frequencies",
        "Cantilever of glass and epoxy that twists as it bends (EI 0.2865, GJ 0.1891, K 0.1143 N m²; 0.0544 kg/m, 7.77e-7 kg m, 0.1905 m): \
         rad/s, extrapolated from 32 and 64 elements",
        "Rayleigh and Ritz, nine polynomials each for w and φ, in the test. The beam is one that J. R. Banerjee and F. W. Williams \
         (J. Aircraft 32 (1995) 636–642) use, its numbers from memory; their frequencies were not at hand and are not compared",
    );
    let [ei, gj, k, mass, inertia, length] = [0.2865, 0.1891, 0.1143, 0.0544, 7.77e-7, 0.1905];
    let beam = Cantilever {
        axis: Vector3::y(),
        y_axis: Vector3::x(),
        length,
        axial: 1e6,
        torsional: gj,
        bending_y: ei,
        // Far above in the other plane.
        bending_z: 1e6 * ei,
        mass_per_length: mass,
        gyration: libm::sqrt(inertia / mass),
        lumps: MIDDLE,
    };
    let found = |elements: usize| {
        let mut aircraft = beam.coupled(elements, Coupling { bend_twist: [k, 0.0], ..Coupling::NONE });
        aircraft.mode_basis = ModeBasis::BendingTorsion;
        // The reference has no rotary inertia of bending.
        for bay in &mut aircraft.bays {
            bay.inertia = beam.axes()
                * Matrix3::from_diagonal(&Vector3::new(1.0, 0.0, 1.0))
                * beam.axes().transpose()
                * (bay.mass * inertia / mass);
        }
        let basis = ModalBasis::new(&Structure::new(&aircraft).unwrap(), 5).unwrap();
        basis.modes.iter().map(|mode| mode.angular_frequency).collect::<Vec<_>>()
    };
    let (coarse, fine) = (found(32), found(64));
    for (mode, expected) in ritz([ei, gj, k, mass, inertia, length]).into_iter().take(4).enumerate() {
        let extrapolated = fine[mode] + (fine[mode] - coarse[mode]) / 3.0;
        record.relative(&format!("mode {}", mode + 1), expected, 2e-5, extrapolated);
    }
    record.finish();
}

#[test]
fn in_a_bending_torsion_basis_the_tension_axis_does_not_stretch_and_the_reference_axis_does() {
    let beam = askew();
    let mut aircraft = beam.coupled(8, Coupling { tension_axis: [0.0, 0.2], ..Coupling::NONE });
    aircraft.mode_basis = ModeBasis::BendingTorsion;
    let structure = Structure::new(&aircraft).unwrap();
    let shapes = ModalBasis::new(&structure, 6).unwrap().shapes;
    let (mut tension, mut reference, mut bending): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for (element, geometry) in structure.geometry.iter().enumerate() {
        let stretch = structure.apply_row(element, &geometry.gradients(0.5).stretch, &shapes);
        let bend = structure.apply_row(element, &geometry.gradients(0.5).curvature_w, &shapes) * 0.2;
        let along = geometry.axes.row(0);
        let ends = [0.0, 1.0].map(|end| along * geometry.section(end).0);
        let between = ((ends[1] - ends[0]) / geometry.length).transpose();
        let stretched = structure.apply_row(element, &between, &shapes);
        tension = tension.max(stretch.amax());
        bending = bending.max(bend.amax());
        reference = reference.max((stretched - bend).amax());
    }
    assert!(tension < 1e-6 * bending, "{tension} {bending}");
    assert!(reference < 1e-6 * bending, "{reference} {bending}");
}

#[test]
fn a_beam_that_bends_far_keeps_the_length_of_its_tension_axis() {
    let mut record = Record::new(
        "tension-axis-arc",
        "Cantilever with its tension axis at z_t = 0.1 L under a moment at its tip that follows the section: x/L and z/L of the tip of the reference axis",
        "the tension axis is a circle of its length: x/L = sin μ/μ + (z_t/L) sin μ, z/L = (1 − cos μ)/μ + (z_t/L)(1 − cos μ), μ = ML/EI",
    );
    let beam = Cantilever {
        axis: Vector3::x(),
        y_axis: Vector3::y(),
        length: 1.0,
        axial: 1e6,
        torsional: 1e6,
        bending_y: 1.0,
        bending_z: 1e6,
        mass_per_length: 1.0,
        gyration: 1e-3,
        lumps: MIDDLE,
    };
    let z_t = 0.1;
    let mut aircraft = with_tip(beam.coupled(40, Coupling { tension_axis: [0.0, z_t], ..Coupling::NONE }));
    aircraft.mode_basis = ModeBasis::BendingTorsion;
    let model = with_strains_of_tip_loads(&aircraft, 8);
    let plant = plant(&model, Fidelity::GeometricallyExact);
    for turn in [0.5, 1.5] {
        let found = crate::support::planar::tip(&plant, &model, Vector3::zeros(), Vector3::y() * -turn);
        let (sin, cos) = libm::sincos(turn);
        record.absolute(&format!("GE, {turn}: x/L"), sin / turn + z_t * sin, 1e-5, found.x);
        record.absolute(&format!("GE, {turn}: z/L"), (1.0 - cos) / turn + z_t * (1.0 - cos), 1e-5, found.z);
    }
    assert_eq!(model.stations[0].name, TIP);
    record.finish();
}
