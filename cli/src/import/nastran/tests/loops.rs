//! Beams that form loops: what joins them, and that they swing as they should.

use super::*;

/// A cantilever of ten metres to the right, 20 elements, EI_up 2e6 N m², EI_aside 8e6, 20 kg/m; below its tip a place that the root holds.
fn above_ground() -> String {
    let mut text = String::from(
        "MAT1,1,2.+10,1.+10,,1000.\nMAT1,2,2.+10,1.+10\nPBAR,1,1,.02,1.-4,4.-4,1.-4\nSPC1,1,123456,1\nGRID,100,,0.,10.,-5.\nRBE2,1,1,123456,100\n",
    );
    for grid in 0..=20 {
        text += &format!("GRID,{},,0.,{},0.\n", grid + 1, 0.5 * f64::from(grid));
    }
    for element in 1..=20 {
        text += &format!("CBAR,{element},1,{element},{},0.,0.,1.\n", element + 1);
    }
    text
}

/// A rod without mass below the tip holds it up and down and not aside: (β L)² of a beam that is clamped and propped, and of a cantilever
/// [Blevins, Formulas for Natural Frequency and Mode Shape, table 8-1]. The rod is 1e5 times as stiff as the beam.
#[test]
fn a_cantilever_on_a_rod_swings_as_a_propped_one_and_aside_as_a_free_one() {
    let found = imported(&(above_ground() + "PROD,5,2,.2\nCROD,50,5,100,21\n"));
    assert_eq!(reports(&found), [""; 0]);
    assert!(
        found.remarks.notes[0].starts_with("CROD 50 closes a loop at GRID 21"),
        "{:?}",
        found.remarks.notes
    );
    let unit = (2e6_f64 / (20.0 * 1e4)).sqrt();
    let mut expected: Vec<f64> = [3.516_015, 22.034_49]
        .map(|aside| 2.0 * aside * unit)
        .into_iter()
        .chain([15.418_21, 49.964_86].map(|up| up * unit))
        .collect();
    expected.sort_by(f64::total_cmp);
    for (found, expected) in frequencies(&found.aircraft, 4).iter().zip(&expected) {
        assert!((found / expected - 1.0).abs() < 3e-4, "{found} {expected}");
    }
    let text = found.text();
    assert!(
        text.contains("\nmodel = \"exact\"\n") && text.contains("geometrically exact level does not fly"),
        "{text}"
    );
    assert!(
        text.contains("joined_to = { component = \"wing_right\", at = 1 }\nrotations = \"free\"\n"),
        "{text}"
    );
}

/// A strut of three elements: what is cut is its upper end, wherever elements and grids stand in the deck.
#[test]
fn a_loop_is_cut_where_the_softest_chain_meets_the_other_beam() {
    let strut = "PBAR,6,2,.002,1.-6,1.-6,1.-6\nGRID,101,,0.,8.,-4.\nGRID,102,,0.,6.,-3.\nCBAR,62,6,101,102,1.,0.,0.\nCBAR,61,6,100,101,1.,0.,0.\n\
                 CBAR,63,6,102,11,1.,0.,0.\n";
    let pinned = strut.replace("CBAR,63,6,102,11,1.,0.,0.", "CBAR,63,6,102,11,1.,0.,0.,,,456");
    for (strut, rotations) in [(strut, "\"fixed\""), (&pinned, "\"free\"")] {
        let found = imported(&(strut.to_owned() + &above_ground()));
        assert_eq!(reports(&found), [""; 0]);
        let text = found.text();
        assert!(text.contains("# CBAR 61 to CBAR 63 (3 elements,"), "{text}");
        assert!(
            text.contains(&format!(
                "component = \"strut_right\"\nat = 1\njoined_to = {{ component = \"wing_right\", at = 0.5 }}\nrotations = {rotations}\n"
            )),
            "{text}"
        );
        assert_eq!(found.aircraft.joints.len(), 1);
    }
    // Pinned at its other end alone it hangs on the wing.
    let other = strut.replace("CBAR,61,6,100,101,1.,0.,0.", "CBAR,61,6,100,101,1.,0.,0.,,456");
    let found = imported(&(other + &above_ground()));
    assert_eq!(reports(&found), [""; 0]);
    assert!(
        found.text().contains("attached_to = { component = \"wing_right\", at = 0.5 }"),
        "{}",
        found.text()
    );
}

/// Both ends pinned: a hinge below, the joint above; a massless strut between pins carries axial force alone, as a rod does.
#[test]
fn a_bar_between_pins_is_a_rod() {
    let rod = imported(&(above_ground() + "PROD,5,2,.002\nCROD,50,5,100,21\n"));
    let bar =
        imported(&(above_ground() + "PBAR,5,2,.002,1.-4,1.-4,1.-4\nCBAR,50,5,100,21,1.,0.,0.,,56,456\n"));
    assert_eq!(reports(&bar), [""; 0]);
    assert!(bar.text().contains("\n[component.hinge]"), "{}", bar.text());
    for (rod, bar) in frequencies(&rod.aircraft, 6).iter().zip(frequencies(&bar.aircraft, 6)) {
        assert!((rod / bar - 1.0).abs() < 1e-7, "{rod} {bar}");
    }
    // About an axis of the bar that is a body axis rotations are shared; about others all are free, and it is said.
    let upright =
        imported(&(above_ground() + "PBAR,5,2,.002,1.-4,1.-4,1.-4\nCBAR,50,5,100,21,1.,0.,0.,,,56\n"));
    assert_eq!(reports(&upright), [""; 0]);
    assert!(upright.text().contains("rotations = [\"z\"]\n"), "{}", upright.text());
    let oblique =
        imported(&(above_ground() + "PBAR,5,2,.002,1.-4,1.-4,1.-4\nCBAR,50,5,100,11,1.,0.,0.,,,56\n"));
    assert!(
        reports(&oblique)[0].contains("CBAR 50, field 3 (PB): found 56: a joint turns about body axes, so that all rotations are free here"),
        "{:?}",
        reports(&oblique)
    );
}

/// Two booms on a wing, a tailplane between them: symmetric, joined in the plane of symmetry, where a mass stands.
#[test]
fn a_loop_from_side_to_side_is_joined_in_the_plane_of_symmetry() {
    let mut text = String::from(
        "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,.01,1.-4,4.-4,1.-4\nPBAR,2,1,.004,2.-5,2.-5,2.-5\nGRID,1,,0.,0.,0.\nGRID,9,,8.,0.,1.\n",
    );
    text += "CONM2,1,9,,12.,.1,0.,0.2,,1.,0.,2.,0.,0.,2.5\nCONM2,2,1,,500.\n";
    for (first, sign) in [(10, 1), (20, -1)] {
        let grids = [(1, 0, 2, 0), (2, 0, 6, 0), (3, 8, 2, 1), (4, 4, 2, 0)];
        for (grid, x, y, z) in grids {
            text += &format!("GRID,{},,{x}.,{}.,{z}.\n", first + grid, sign * y);
        }
        for (element, property, one, other) in [
            (1, 1, 1, first + 1),
            (2, 1, first + 1, first + 2),
            (3, 2, first + 1, first + 4),
            (4, 2, first + 4, first + 3),
            (5, 2, first + 3, 9),
        ] {
            text += &format!("CBAR,{},{property},{one},{other},0.,0.,1.\n", first + element);
        }
    }
    let found = imported(&text);
    assert_eq!(reports(&found).len(), 1, "{:?}", reports(&found));
    let file = found.text();
    assert!(file.contains("\nsymmetric = true\n"), "{:?}\n{file}", found.remarks.notes);
    assert!(
        file.contains("component = \"tail_right\"\nat = 1\njoined_to = { component = \"tail_left\", at = 1 }\nrotations = \"fixed\"\n")
            || file.contains("component = \"tail_left\"\nat = 1\njoined_to = { component = \"tail_right\", at = 1 }\nrotations = \"fixed\"\n"),
        "{file}"
    );
    assert_eq!(found.aircraft.joints.len(), 1);
    let mass: f64 = found.aircraft.bays.iter().map(|bay| bay.mass).sum();
    let length = |x: f64, y: f64, z: f64| (x * x + y * y + z * z).sqrt();
    let elements = 2.0 * 2700.0 * (0.01 * 6.0 + 0.004 * (4.0 + length(4.0, 0.0, 1.0) + 2.0));
    assert!((mass - 512.0 - elements).abs() < 1e-8 * mass, "{mass} {elements}");
}

/// Wings that are alike stay a pair with a strut on one side alone; struts that differ in their pins alone are no pair, nor are their wings.
#[test]
fn joints_are_on_both_sides_where_they_are_alike_there() {
    let mut text = above_ground();
    for grid in 1..=20 {
        let inner = if grid == 1 { 1 } else { 199 + grid };
        text += &format!(
            "GRID,{},,0.,{},0.\nCBAR,{},1,{inner},{},0.,0.,1.\n",
            200 + grid,
            -0.5 * f64::from(grid),
            200 + grid,
            200 + grid
        );
    }
    let plain = imported(&text);
    assert!(plain.text().contains("mirror = \"wing_left\""), "{}", plain.text());
    let braced = imported(&(text.clone() + "PROD,5,2,.002\nCROD,50,5,100,11\n"));
    assert!(
        braced.text().contains("mirror = \"wing_left\"") && !braced.text().contains("symmetric"),
        "{}",
        braced.text()
    );
    assert_eq!(braced.aircraft.joints.len(), 1);
    let struts = "GRID,101,,0.,-10.,-5.\nRBE2,2,1,123456,101\nPBAR,6,2,.002,1.-6,1.-6,1.-6\nCBAR,61,6,100,11,1.,0.,0.,,,PIN\nCBAR,62,6,101,210,1.,0.,0.,,,456\n";
    let alike = imported(&(text.clone() + &struts.replace("PIN", "456")));
    assert_eq!(
        (alike.text().matches("[[joint]]").count(), alike.aircraft.joints.len()),
        (1 + 1, 2),
        "{}",
        alike.text()
    );
    assert!(alike.text().contains("symmetric = true\n"), "{}", alike.text());
    let unlike = imported(&(text + &struts.replace("PIN", "")));
    assert!(!unlike.text().contains("mirror = "), "{}", unlike.text());
    assert_eq!(unlike.aircraft.joints.len(), 2);
}

#[test]
fn more_loops_than_a_stick_has_are_refused() {
    let mut text = String::from(
        "MAT1,1,7.+10,,.3,2700.\nPROD,1,1,.01\nGRID,1,,0.,0.,0.\nGRID,2,,0.,1.,0.\nSPC1,1,123456,1\n",
    );
    for element in 1..=202 {
        text += &format!("CROD,{element},1,1,2\n");
    }
    let told = of_text(&text).map(|_| ()).unwrap_err().to_string();
    assert_eq!(told, "found beams that form 201 loops; up to 200 are allowed of a stick model");
}
