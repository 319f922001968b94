//! Closed forms of sections whose bending goes aside, and of axes that are apart: the signs of Nastran, on both sides.

use nalgebra::{DVector, Vector3};

use super::*;

/// Of both wings, m and N m².
const LENGTH: f64 = 10.0;
const YOUNG: f64 = 2e10;
const I1: f64 = 1e-4;
const I2: f64 = 4e-4;
const I12: f64 = 1.2e-4;

/// A wing of four elements to each side of GRID 100, which is clamped; I12 of each, and whether elements are written from the tip.
fn wings(i12: [f64; 2], is_written_inwards: [bool; 2]) -> String {
    let mut text = String::from("MAT1,1,2.+10,1.+10,,1000.\nGRID,100,,0.,0.,0.\nSPC1,1,123456,100\n");
    for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
        let first = 100 * (side + 1);
        let property = first;
        text += &format!("PBAR,{property},1,.02,1.-4,4.-4,1.-4\n+\n+,,,{:.6e}\n", i12[side]);
        let mut inner = 100;
        for place in 1..=4 {
            let outer = first + place;
            text += &format!("GRID,{outer},,0.,{},0.\n", sign * LENGTH * place as f64 / 4.0);
            let [one, other] = if is_written_inwards[side] { [outer, inner] } else { [inner, outer] };
            text += &format!("CBAR,{outer},{property},{one},{other},0.,0.,1.\n");
            inner = outer;
        }
    }
    text
}

/// Displacement of the node that a force acts on, both in body axes, held at O.
fn deflection(aircraft: &Aircraft, at: Vector3<f64>, force: Vector3<f64>) -> Vector3<f64> {
    let structure = Structure::new(aircraft).unwrap();
    let node = aircraft.nodes.iter().position(|node| (node - at).norm() < 1e-9).unwrap();
    let mut loads = DVector::zeros(structure.unknowns());
    loads.fixed_rows_mut::<3>(6 * (node - 1)).copy_from(&force);
    let moved = structure.stiffness(false).cholesky().unwrap().solve(&loads);
    moved.fixed_rows::<3>(6 * (node - 1)).into()
}

/// A force up bends up by F L³ I2 / (3 E (I1 I2 − I12²)) and by −I12/I2 of that along z of the element, which is aft of an element to the
/// right and forward of one to the left: x × y, with y up [Timoshenko, Strength of Materials, part I, section 47: unsymmetrical bending].
#[test]
fn a_section_with_i12_bends_aside_with_the_sign_of_nastran_on_both_sides() {
    let up = 1000.0 * LENGTH.powi(3) * I2 / (3.0 * YOUNG * (I1 * I2 - I12 * I12));
    let aside = I12 / I2 * up;
    for (i12, is_written_inwards, forward, is_mirrored) in [
        ([I12, I12], [false, false], [aside, -aside], false),
        ([I12, -I12], [false, false], [aside, aside], true),
        ([I12, I12], [false, true], [aside, aside], true),
        ([-I12, -I12], [true, false], [aside, aside], true),
    ] {
        let found = imported(&wings(i12, is_written_inwards));
        assert_eq!(reports(&found), [""; 0]);
        assert_eq!(found.text().contains("mirror = "), is_mirrored, "{}", found.text());
        for (sign, forward) in [1.0, -1.0].into_iter().zip(forward) {
            let tip = Vector3::new(0.0, sign * LENGTH, 0.0);
            let moved = deflection(&found.aircraft, tip, Vector3::new(0.0, 0.0, -1000.0));
            let expected = Vector3::new(forward, 0.0, -up);
            assert!(
                (moved - expected).norm() < 1e-9 * up,
                "{i12:?} {is_written_inwards:?}: {moved} {expected}"
            );
        }
    }
}

/// Elements whose orientation turns about the beam are one component: each is as stiff in its axes as its card says.
#[test]
fn a_twisted_beam_is_one_component() {
    let turned = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        format!("{sin:.15},0.,{cos:.15}")
    };
    let mut text = String::from(
        "MAT1,1,2.+10,1.+10,,1000.\nPBAR,1,1,.02,1.-4,4.-4,1.-4\nGRID,1,,0.,0.,0.\nSPC1,1,123456,1\n",
    );
    for element in 1..=4 {
        text +=
            &format!("GRID,{},,0.,{}.,0.\nCBAR,{element},1,{element},{},", element + 1, element, element + 1);
        text += &(turned(30.0 * (element - 1) as f64) + "\n");
    }
    let found = imported(&text);
    assert_eq!(found.aircraft.components.len(), 1, "{}", found.text());
    // Of each element EI is diag(I1, I2) in axes that are turned from up (−z) to aft (−x): the flexibilities of a unit force add up.
    let mut expected = Vector3::zeros();
    for element in 0..4 {
        let (sin, cos) = (30.0 * f64::from(element)).to_radians().sin_cos();
        let [y, z] = [Vector3::new(-sin, 0.0, -cos), Vector3::new(-cos, 0.0, sin)];
        // ∫ (4 − s)² ds over the element.
        let [from, to] = [4.0 - f64::from(element), 3.0 - f64::from(element)];
        let arm = (from.powi(3) - to.powi(3)) / 3.0;
        let force = Vector3::new(0.0, 0.0, -1000.0);
        expected += (y * y.dot(&force) / I1 + z * z.dot(&force) / I2) * (arm / YOUNG);
    }
    let moved = deflection(&found.aircraft, Vector3::new(0.0, 4.0, 0.0), Vector3::new(0.0, 0.0, -1000.0));
    assert!((moved - expected).norm() < 1e-9 * expected.norm(), "{moved} {expected}");
}

/// A force F along the axis of shear centres, N1 and N2 from the neutral axis, bends by F N L²/(2 E I) and stretches by F L/(E A) and the arms.
#[test]
fn a_neutral_axis_apart_from_the_shear_centre_is_held_with_the_mass_on_it() {
    let [n1, n2] = [0.03, -0.05];
    let [m1, m2] = [-0.1, 0.2];
    let text = format!(
        "MAT1,1,2.+10,1.+10,,1000.\nPBEAM,1,1,.02,1.-4,4.-4,,1.-4,5.\n+\n+,0.,0.\n+,{m1},{m2},,,{n1},{n2}\nGRID,1,,0.,0.,0.\nGRID,2,,0.,10.,0.\n\
         CBEAM,1,1,1,2,0.,0.,1.\nSPC1,1,123456,1\n"
    );
    let found = imported(&text);
    assert_eq!(reports(&found), [""; 0]);
    let force = 1e6;
    let moved = deflection(&found.aircraft, Vector3::new(0.0, LENGTH, 0.0), Vector3::new(0.0, force, 0.0));
    let bent = |place: f64, second: f64| force * place * LENGTH * LENGTH / (2.0 * YOUNG * second);
    let along = force * LENGTH / YOUNG * (1.0 / 0.02 + n1 * n1 / I1 + n2 * n2 / I2);
    // y of the element is up, z aft.
    let expected = Vector3::new(-bent(n2, I2), along, -bent(n1, I1));
    assert!((moved - expected).norm() < 1e-9 * expected.norm(), "{moved} {expected}");
    let centre: Vector3<f64> = {
        let places = found.aircraft.bays.iter().map(|bay| {
            let [one, other] =
                found.aircraft.beams[bay.attachment.beam].nodes.map(|node| found.aircraft.nodes[node]);
            (one.lerp(&other, bay.attachment.fraction) + bay.offset) * bay.mass
        });
        places.sum::<Vector3<f64>>() / 250.0
    };
    // 20 kg/m of structure on the neutral axis, 5 of other mass.
    let expected = Vector3::new(-(20.0 * n2 + 5.0 * m2) / 25.0, 5.0, -(20.0 * n1 + 5.0 * m1) / 25.0);
    assert!((centre - expected).norm() < 1e-10, "{centre} {expected}");
    let integrals = found.aircraft.clone().reduce().unwrap().integrals.clone();
    // About the beam's axis: masses by squares of their distances, and ρ (I1 + I2).
    let about = 10.0 * (20.0 * (n1 * n1 + n2 * n2) + 5.0 * (m1 * m1 + m2 * m2) + 1000.0 * (I1 + I2));
    assert!((integrals.inertia[(1, 1)] / about - 1.0).abs() < 1e-9, "{} {about}", integrals.inertia[(1, 1)]);
    let told = reports(&imported(&text.replace(&format!("{n1},{n2}"), &format!("{n1},{n2},.05"))));
    assert_eq!(
        told,
        [
            "deck.bdf:5: PBEAM 1, field 8 (N1(B)): found 0.05, and 0.03 at end A: the mean is held, elements are uniform here"
        ]
    );
}

#[test]
fn products_of_inertia_that_no_section_has_are_refused() {
    let text = wings([2.1e-4, 0.0], [false; 2]);
    let told = of_text(&text).map(|_| ()).unwrap_err().to_string();
    assert!(
        told.contains("PBAR 100, field 4 (I12): found 0.00021; less than the root of I1 times I2, 2.000000e-4, is allowed"),
        "{told}"
    );
}
