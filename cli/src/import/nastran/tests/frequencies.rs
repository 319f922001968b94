//! Closed forms: what a deck describes swings as the books say.

use super::*;

/// Of a uniform cantilever, (β L)² of its modes [Blevins, Formulas for Natural Frequency and Mode Shape, table 8-1].
const CANTILEVER: [f64; 3] = [3.516_015, 22.034_49, 61.697_21];

/// A cantilever along y of ten metres, with other things on it: EI_up 2e6 N m², EI_aside 8e6, GJ 1e6, 20 kg/m.
fn cantilever(elements: usize, root: &str) -> String {
    let mut text = String::from("MAT1,1,2.+10,1.+10,,1000.\nPBAR,1,1,.02,1.-4,4.-4,1.-4\n");
    for grid in 0..=elements {
        text += &format!("GRID,{},,0.,{},0.\n", grid + 1, 10.0 * grid as f64 / elements as f64);
    }
    for element in 1..=elements {
        text += &format!("CBAR,{element},1,{element},{},0.,0.,1.\n", element + 1);
    }
    text + root
}

/// Checks the modes up and down, and aside at twice their frequencies.
#[track_caller]
fn check_cantilever(imported: &Imported, tolerance: f64) {
    let unit = (2e6_f64 / (20.0 * 1e4)).sqrt();
    let mut expected: Vec<f64> =
        CANTILEVER.iter().flat_map(|factor| [factor * unit, 2.0 * factor * unit]).collect();
    expected.sort_by(f64::total_cmp);
    let found = frequencies(&imported.aircraft, 5);
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
    }
}

#[test]
fn a_clamped_stick_swings_as_a_cantilever() {
    let found = imported(&cantilever(20, "SPC1,1,123456,1\n"));
    assert_eq!(reports(&found), [""; 0]);
    // 20 elements with two masses each are as near as 3e-6.
    check_cantilever(&found, 3e-5);
    assert!(
        found.text().contains("elements = 20\n") && found.text().contains("EI_y_N_m2 = 8000000\n"),
        "{}",
        found.text()
    );
}

#[test]
fn rigid_links_and_offsets_move_a_stick_and_do_not_soften_it() {
    let link = "GRID,90,,-2.,0.,1.\nRBE2,91,90,123456,1\nSPC1,1,123456,90\n";
    check_cantilever(&imported(&cantilever(20, link)), 3e-5);
    // The same grids half a metre ahead of and above the beam.
    let offset = cantilever(20, "SPC1,1,123456,1\n")
        .replace(",0.,0.,1.\nCBAR", ",0.,0.,1.,,,,.5,0.,-.5,.5,0.,-.5\nCBAR");
    let offset =
        offset.replace("CBAR,20,1,20,21,0.,0.,1.\n", "CBAR,20,1,20,21,0.,0.,1.,,,,.5,0.,-.5,.5,0.,-.5\n");
    let found = imported(&offset);
    assert_eq!(reports(&found), [""; 0]);
    check_cantilever(&found, 3e-5);
}

#[test]
fn a_section_with_i12_swings_along_its_principal_axes() {
    // The same section, written in axes that are turned by 30° about the beam.
    let (sin, cos) = 30f64.to_radians().sin_cos();
    let orientation = "0.,0.,1.\n".to_owned();
    let turned = format!("{:.12},0.,{:.12}\n", sin, cos);
    let [one, two] = [1e-4, 4e-4];
    let i1 = one * cos * cos + two * sin * sin;
    let i2 = one * sin * sin + two * cos * cos;
    for i12 in [(two - one) * sin * cos, -(two - one) * sin * cos] {
        let text = cantilever(20, "SPC1,1,123456,1\n").replace(&orientation, &turned);
        let property =
            format!("PBAR*,1,1,.02,{i1:.12e}\n*,{i2:.12e},1.-4,,\n*,,,,\n*,,,,\n*,,,{i12:.12e},\n");
        let found = imported(&text.replace("PBAR,1,1,.02,1.-4,4.-4,1.-4\n", &property));
        check_cantilever(&found, 3e-5);
        assert_eq!(
            (reports(&found), found.remarks.notes.as_slice()),
            (vec![], [""; 0].map(String::from).as_slice())
        );
        assert!(found.text().contains("\nEI_yz_N_m2 = "), "{}", found.text());
    }
}

/// A light bar of 2 m to the right, 1e6 times as stiff as the springs that hold it, with 3 kg at its end.
const PENDULUM: &str = "MAT1,1,2.+11,1.+11,.3\nPBAR,1,1,.1,.01,.01,.01\nGRID,1,,0.,0.,0.\nGRID,2,,0.,2.,0.\nCBAR,1,1,1,2,0.,0.,1.\n\
    CONM2,1,2,,3.\nCBUSH,5,5,1,,,,,0\nPBUSH,5,K,RIGID,RIGID,RIGID,480.,700.,1200.\n";

/// Checks ω² = K / (m L²) of two swings; the bar bends too: 3 EI/L is 6e9 N m/rad.
#[track_caller]
fn check_pendulum(found: &Imported) {
    let swings = frequencies(&found.aircraft, 2);
    for (found, stiffness) in swings.iter().zip([480.0_f64, 1200.0]) {
        let expected = (stiffness / 12.0).sqrt();
        assert!((found / expected - 1.0).abs() < 3e-6, "{found} {expected}");
    }
}

#[test]
fn springs_at_a_root_are_a_hinge_and_hold_a_stiff_bar_as_a_pendulum_is_held() {
    let found = imported(PENDULUM);
    assert_eq!(reports(&found), [""; 0]);
    check_pendulum(&found);
    // About x of the bar, and of the basic axes about y; two of three, of which the last goes round.
    assert!(found.text().contains("\nstiffnesses_N_m_per_rad = [700, 1200, 480]\n"), "{}", found.text());
    assert!(found.text().contains("\naxis_m = [[0, 0, 0], [0, 2, 0]]\n"), "{}", found.text());
    let told = reports(&imported(&PENDULUM.replace("RIGID,RIGID,RIGID,480.,700.,", "1.+8,1.+8,1.+8,480.,,")))
        .join("\n");
    assert!(told.contains("CBUSH 5: found no K5: held as if rigid about it"), "{told}");
    assert!(told.contains("CBUSH 5: the springs K1, K2, K3 along its axes are held as if rigid"), "{told}");
}

#[test]
fn springs_about_axes_that_no_beam_has_or_that_hold_several_beams_have_an_element_of_their_own() {
    // 45° about z: the bar goes along the bisector of two springs' axes.
    let turned = "CORD2R,7,,0.,0.,0.,0.,0.,1.\n+,1.,1.,0.\n";
    let skew = PENDULUM
        .replace("CBUSH,5,5,1,,,,,0", "CBUSH,5,5,1,,,,,,7")
        .replace("CBUSH,5,5,1,,,,,,7", "CBUSH,5,5,1,,,,,7");
    let skew = imported(&(skew.replace("480.,700.,", "480.,480.,") + turned));
    assert_eq!(reports(&skew), [""; 0]);
    check_pendulum(&skew);
    assert!(skew.text().contains("\nname = \"root\"\n"), "{}", skew.text());
    // The same bar to the left hangs on the same springs: twice the inertia, half the squares.
    let both = PENDULUM.replace("480.,700.,1200.", "960.,700.,2400.")
        + "GRID,3,,0.,-2.,0.\nCBAR,2,1,1,3,0.,0.,1.\nCONM2,2,3,,3.\n";
    let both = imported(&both);
    assert_eq!(reports(&both), [""; 0]);
    check_pendulum(&both);
    // One spring alone, about an axis that is no bar's.
    let one = imported(&PENDULUM.replace("480.,700.,1200.", "480.,RIGID,RIGID"));
    assert!(one.text().contains("\naxis = [-1, 0, 0]\nstiffness_N_m_per_rad = 480\n"), "{}", one.text());
    let swing = frequencies(&one.aircraft, 1)[0];
    assert!((swing / 40f64.sqrt() - 1.0).abs() < 3e-6, "{swing}");
}

#[test]
fn units_are_those_that_are_said() {
    let metres = cantilever(8, "SPC1,1,123456,1\nCONM2,1,9,,100.,.1,.2,.3,,5.,0.,6.,0.,0.,7.\n");
    let aircraft = imported(&metres).aircraft;
    // Millimetres, newtons, tonnes.
    let mut text = String::from("MAT1,1,2.+4,1.+4,,1.-9\nPBAR,1,1,2.+4,1.+8,4.+8,1.+8\nSPC1,1,123456,1\n");
    text += "CONM2,1,9,,.1,100.,200.,300.,,5.+3,0.,6.+3,0.,0.,7.+3\n";
    for grid in 0..=8 {
        text += &format!("GRID,{},,0.,{}.,0.\n", grid + 1, 1250 * grid);
    }
    for element in 1..=8 {
        text += &format!("CBAR,{element},1,{element},{},0.,0.,1.\n", element + 1);
    }
    let same = |text: &str, factor: f64| {
        let (mass, inertia) = ((0.1 * factor).to_string(), factor);
        let text = text.replace("CONM2,1,9,,.1,", &format!("CONM2,1,9,,{mass},"));
        let text = text.replace(
            "5.+3,0.,6.+3,0.,0.,7.+3",
            &format!("{},0.,{},0.,0.,{}", 5e3 * inertia, 6e3 * inertia, 7e3 * inertia),
        );
        let text = wrapped(&text);
        let source = OneText(&text);
        let found = import(&Request { units: UnitSystem::Mm, ..Request::of_text(&source) }).unwrap().aircraft;
        assert_eq!(found.nodes.len(), aircraft.nodes.len());
        for (one, other) in found.nodes.iter().zip(&aircraft.nodes) {
            assert!((one - other).norm() < 1e-9);
        }
        for (one, other) in found.beams.iter().zip(&aircraft.beams) {
            assert!((one.bending_stiffness_y / other.bending_stiffness_y - 1.0).abs() < 1e-9);
            assert!((one.axial_stiffness / other.axial_stiffness - 1.0).abs() < 1e-9);
        }
        for (one, other) in found.bays.iter().zip(&aircraft.bays) {
            assert!((one.mass / other.mass - 1.0).abs() < 1e-9, "{} {}", one.mass, other.mass);
            assert!((one.inertia - other.inertia).norm() < 1e-9 && (one.offset - other.offset).norm() < 1e-9);
        }
    };
    same(&text, 1.0);
    // Masses in kilograms, by WTMASS.
    let in_kilograms = text.replace("1.+4,,1.-9", "1.+4,,1.-6");
    same(&format!("PARAM,WTMASS,.001\n{in_kilograms}"), 1000.0);
}
