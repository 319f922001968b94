//! Elastic hinges at the root of a component: closed forms of deflections, frequencies and finite turns.
//!
//! [theory: coupled-sections.hinge]

use flexible_aircraft::aircraft::{Aircraft, Fidelity, Hinge, ModeBasis, Spring};
use flexible_aircraft::structure::{ModalBasis, ModeMotion, ReducedModel, Structure};
use nalgebra::{Cholesky, DVector, Matrix3, Vector3};

use super::record::Record;
use crate::support::beams::{Cantilever, MIDDLE};
use crate::support::planar::{plant, tip, with_tip};

/// Bends in x and z; far stiffer in the other plane and in torsion.
fn beam() -> Cantilever {
    Cantilever {
        axis: Vector3::x(),
        y_axis: Vector3::y(),
        length: 2.0,
        axial: 1e8,
        torsional: 1e6,
        bending_y: 3e3,
        bending_z: 1e7,
        mass_per_length: 5.0,
        gyration: 1e-3,
        lumps: MIDDLE,
    }
}

fn hinged(mut aircraft: Aircraft, springs: &[(Vector3<f64>, f64)]) -> Aircraft {
    let springs = springs.iter().map(|&(axis, stiffness)| Spring { axis, stiffness });
    aircraft.beams[0].hinge = Some(Hinge { springs: springs.collect() });
    aircraft.mode_basis = ModeBasis::BendingTorsion;
    aircraft
}

#[test]
fn a_hinge_adds_its_turn_to_the_deflections_of_a_cantilever() {
    let mut record = Record::new(
        "hinge-static",
        "Cantilever on springs about its three axes, under a force (20, 7, −30) N and a moment (4, 5, 6) N m at its tip, by one element \
         and by four: m and rad",
        "those of the clamped cantilever, and the moment at its root over each spring's stiffness",
    );
    let beam = beam();
    let [about_x, about_y, about_z] = [2e3, 500.0, 8e3];
    let springs = [(Vector3::x(), about_x), (Vector3::y(), about_y), (Vector3::z(), about_z)];
    let (force, moment) = (Vector3::new(20.0, 7.0, -30.0), Vector3::new(4.0, 5.0, 6.0));
    let l = beam.length;
    let at_root = moment + Vector3::new(l, 0.0, 0.0).cross(&force);
    let (theta_y, theta_z) = (at_root.y / about_y, at_root.z / about_z);
    let expected = [
        (
            "v",
            force.y * l.powi(3) / (3.0 * beam.bending_z)
                + moment.z * l * l / (2.0 * beam.bending_z)
                + theta_z * l,
        ),
        (
            "w",
            force.z * l.powi(3) / (3.0 * beam.bending_y)
                - moment.y * l * l / (2.0 * beam.bending_y)
                - theta_y * l,
        ),
        ("φ", moment.x * l / beam.torsional + at_root.x / about_x),
    ];
    for elements in [1, 4] {
        let aircraft = hinged(beam.aircraft(elements), &springs);
        let structure = Structure::new(&aircraft).unwrap();
        let last = structure.unknowns() - 6;
        let mut load = DVector::zeros(structure.unknowns());
        load.fixed_rows_mut::<3>(last).copy_from(&force);
        load.fixed_rows_mut::<3>(last + 3).copy_from(&moment);
        let solution = Cholesky::new(structure.stiffness(false)).unwrap().solve(&load);
        let found = [solution[last + 1], solution[last + 2], solution[last + 3]];
        for ((name, expected), found) in expected.iter().zip(found) {
            record.relative(&format!("{elements}: {name}"), *expected, 1e-9, found);
        }
    }
    record.finish();
}

/// λ of a beam whose root is held by a spring of the stiffness r EI/L, and whose tip is free.
fn roots(r: f64, count: usize) -> Vec<f64> {
    let mismatch = |x: f64| {
        let (sin, cos) = libm::sincos(x);
        // Over cosh x, that nothing overflows.
        r * (1.0 / libm::cosh(x) + cos) + x * (cos * libm::tanh(x) - sin)
    };
    let mut roots = Vec::new();
    let step = 0.01;
    let mut x = step;
    while roots.len() < count {
        if mismatch(x) * mismatch(x + step) < 0.0 {
            let (mut low, mut high) = (x, x + step);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if mismatch(low) * mismatch(middle) < 0.0 { high = middle } else { low = middle }
            }
            roots.push(low);
        }
        x += step;
    }
    roots
}

#[test]
fn a_hinged_cantilever_has_the_frequencies_of_a_beam_on_a_spring() {
    let mut record = Record::new(
        "hinge-frequencies",
        "Frequencies of a body and of a beam on a hinge, rad/s; of the beam extrapolated from 32 and 64 elements",
        "√(k/I) of a rigid body with I about the hinge; roots of r (1 + cos λ cosh λ) + λ (cos λ sinh λ − sin λ cosh λ) = 0 with \
         r = kL/EI, ω = λ²/L² √(EI/μ) (Blevins, *Formulas for Natural Frequency and Mode Shape*, chapter 8: torsion spring and free end)",
    );
    let rigid = Cantilever { bending_y: 1e12, bending_z: 1e12, torsional: 1e12, ..beam() };
    let mut body = rigid.aircraft(1);
    let (mass, arm, stiffness) = (7.0, Vector3::new(0.3, 0.0, 0.2), 400.0);
    body.bays[0].mass = mass;
    body.bays[0].offset = arm;
    body.bays[0].inertia = Matrix3::from_diagonal(&Vector3::new(0.5, 0.9, 0.7));
    // The bay sits at 1 m, half of the beam.
    let about_hinge = 0.9 + mass * (1.3 * 1.3 + 0.2 * 0.2);
    let body = hinged(body, &[(Vector3::y(), stiffness)]);
    let basis = ModalBasis::new(&Structure::new(&body).unwrap(), 1).unwrap();
    record.relative(
        "a rigid body",
        libm::sqrt(stiffness / about_hinge),
        1e-7,
        basis.modes[0].angular_frequency,
    );
    let beam = beam();
    for r in [0.1, 1.0, 10.0] {
        let stiffness = r * beam.bending_y / beam.length;
        let found = |elements: usize| {
            let aircraft = hinged(beam.aircraft(elements), &[(Vector3::y(), stiffness)]);
            let basis = ModalBasis::new(&Structure::new(&aircraft).unwrap(), 3).unwrap();
            basis.modes.iter().map(|mode| mode.angular_frequency).collect::<Vec<_>>()
        };
        let (coarse, fine) = (found(32), found(64));
        let scale = libm::sqrt(beam.bending_y / beam.mass_per_length) / (beam.length * beam.length);
        for (mode, root) in roots(r, 3).into_iter().enumerate() {
            let extrapolated = fine[mode] + (fine[mode] - coarse[mode]) / 3.0;
            let case = format!("r = {r}, mode {}", mode + 1);
            record.relative(&case, root * root * scale, 2e-5, extrapolated);
        }
    }
    record.finish();
}

#[test]
fn a_stiff_arm_on_a_hinge_turns_as_far_as_one_likes() {
    let mut record = Record::new(
        "hinge-far",
        "Stiff arm on a hinge of 1 N m/rad under a dead force at its tip, geometrically exact level: x/L and z/L over PL/k",
        "θ = (PL/k) cos θ, x/L = cos θ, z/L = sin θ",
    );
    let arm = Cantilever { length: 1.0, bending_y: 1e6, bending_z: 1e6, mass_per_length: 1.0, ..beam() };
    let aircraft = with_tip(hinged(arm.aircraft(3), &[(Vector3::y(), 1.0)]));
    let model = ReducedModel::new(&aircraft, 1).unwrap();
    // The hinge stands in the place of O.
    assert_eq!((model.sections[1].parent, model.sections[1].position), (0, Vector3::zeros()));
    let plant = plant(&model, Fidelity::GeometricallyExact);
    for load in [0.5_f64, 1.0, 1.5] {
        let mut theta = 0.5_f64;
        for _ in 0..60 {
            theta -= (theta - load * theta.cos()) / (1.0 + load * theta.sin());
        }
        let found = tip(&plant, &model, Vector3::z() * load, Vector3::zeros());
        record.absolute(&format!("{load}: x/L"), theta.cos(), 1e-5, found.x);
        record.absolute(&format!("{load}: z/L"), theta.sin(), 1e-5, found.z);
    }
    record.finish();
}

#[test]
fn a_mode_that_turns_on_a_hinge_strains_its_spring() {
    let mut aircraft = hinged(beam().aircraft(8), &[(Vector3::y(), 10.0)]);
    aircraft.components.push(flexible_aircraft::aircraft::Component {
        name: "beam".to_owned(),
        nodes: (0..=8).collect(),
        first_beam: 0,
        image: None,
        parent: None,
    });
    let structure = Structure::new(&aircraft).unwrap();
    let basis = ModalBasis::new(&structure, 2).unwrap();
    let motion = &ModeMotion::of_modes(&structure, &basis.shapes)[0];
    assert!((motion.strain[0].sum() - 1.0).abs() < 1e-9 && motion.strain[0].bending > 0.99, "{motion:?}");
}
