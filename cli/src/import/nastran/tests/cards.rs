//! Cards one by one: what becomes of them, and what is said.

use super::*;

/// A half wing with a strut's stub, a tip mass, and much else.
fn stick() -> Cards {
    cards(
        "MAT1 1 7.1+10 - .33 2700.
         GRID 1 - 0. 0. 0.
         GRID 2 - 0.1 2. 0.05
         GRID 3 - 0.2 4. 0.1
         GRID 4 - 1. 4. 0.1
         CORD2C 9 0 0. 0. 0. 0. 0. 1. 1. 0. 0.
         GRID 5 9 6.0 90. 0.15
         PBARL 1 1 - BOX - - - - .5 .2 .004 .003 1.5
         PBAR 2 1 .004 2.-5 8.-5 3.-5 .5 - - - - - - - - - - - 1.-6
         PBEAM 3 1 .004 2.-5 8.-5 - 3.-5 .5
         CBAR 1 1 1 2 0. 0. 1.
         CBAR 2 2 2 3 0. 0. 1.
         CBEAM 3 3 3 5 0. 0. 1.
         RBE2 9 3 123456 4
         CONM2 1 4 - 12. .1 0. 0. - 1. - 2. - - 2.5
         CONM1 2 5 - 3. 0. 3. 0. 0. 3. 0. 0. 0. .1 0. 0. 0. 0. .1 0. 0. 0. 0. 0. .15
         SPC1 7 123456 1",
    )
}

#[test]
fn all_three_formats_give_the_same_aircraft() {
    let aircraft: Vec<Imported> =
        [small(&stick()), large(&stick()), free(&stick())].iter().map(|text| imported(text)).collect();
    let texts: Vec<String> = aircraft.iter().map(|found| without_comments(found.text())).collect();
    assert_eq!(texts[0], texts[1]);
    assert_eq!(texts[0], texts[2]);
    for found in &aircraft {
        assert_eq!(found.aircraft, aircraft[0].aircraft);
    }
    let mass: f64 = aircraft[0].aircraft.bays.iter().map(|bay| bay.mass).sum();
    let lengths = [
        (0.01_f64 + 4.0 + 0.0025).sqrt(),
        (0.01_f64 + 4.0 + 0.0025).sqrt(),
        (0.04_f64 + 4.0 + 0.0025).sqrt(),
    ];
    let box_area = 0.5 * 0.2 - 0.494 * 0.192;
    let by_length = [2700.0 * box_area + 1.5, 2700.0 * 0.004 + 0.5, 2700.0 * 0.004 + 0.5];
    let expected: f64 =
        15.0 + std::iter::zip(lengths, by_length).map(|(one, other)| one * other).sum::<f64>();
    assert!((mass / expected - 1.0).abs() < 1e-10, "{mass} {expected}");
}

#[test]
fn grids_in_cylinders_and_in_frames_of_grids_are_where_they_should_be() {
    let found = imported(&free(&stick()));
    // r = 6 m at 90°, z = 0.15 m: 6 m to the right, up; of the deck's x nothing.
    let tip = found
        .aircraft
        .nodes
        .iter()
        .find(|node| (*node - nalgebra::Vector3::new(0.0, 6.0, -0.15)).norm() < 1e-9);
    assert!(tip.is_some(), "{:?}", found.aircraft.nodes);
    // A frame on grids whose z runs out, x down: a place of it.
    let deck = free(&stick())
        + "GRID,20,,0.,0.,0.\nGRID,21,,0.,1.,0.\nGRID,22,,0.,0.,-1.\nCORD1R,30,20,21,22\n\
        GRID,31,30,.5,.25,3.\nRBE2,40,3,123456,31\nCONM2,50,31,30,2.,0.,0.,1.,,1.,0.,2.,0.,0.,2.5\n";
    let with_frame = imported(&deck).aircraft;
    let bay = with_frame.bays.iter().find(|bay| bay.mass == 2.0).unwrap();
    let beam = &with_frame.beams[bay.attachment.beam];
    let [one, other] = beam.nodes.map(|node| with_frame.nodes[node]);
    let centre = one.lerp(&other, bay.attachment.fraction) + bay.offset;
    // x down is −z of the deck, z is y, y = z × x of the deck's is −x: 0.25 m forward, 0.5 m down, 3 m and 1 m more out.
    assert!((centre - nalgebra::Vector3::new(0.25, 4.0, 0.5)).norm() < 1e-9, "{centre}");
    assert!(
        (bay.inertia.diagonal() - nalgebra::Vector3::new(2.0, 2.5, 1.0)).norm() < 1e-9,
        "{}",
        bay.inertia
    );
}

#[test]
fn masses_of_what_closes_a_loop_stay() {
    let strut = "PROD,5,1,.001,,,.3\nGRID,8,,0.,0.,-1.\nRBE2,30,1,123456,8\nCROD,77,5,8,3\n";
    let plain = imported(&free(&stick()));
    let braced = imported(&(free(&stick()) + strut));
    assert_eq!(reports(&braced), [""; 0]);
    let mass = |found: &Imported| found.aircraft.bays.iter().map(|bay| bay.mass).sum::<f64>();
    let of_strut = (2700.0 * 0.001 + 0.3) * (0.04_f64 + 16.0 + 1.21).sqrt();
    assert!((mass(&braced) - mass(&plain) - of_strut).abs() < 1e-8 * of_strut);
    // Torsion of a rod is not held where it closes a loop; of one with both ends on a body nothing is, but its mass.
    let told =
        reports(&imported(&(free(&stick()) + &strut.replace("PROD,5,1,.001,,", "PROD,5,1,.001,1.-6,"))));
    assert!(told[0].contains("CROD 77: it closes a loop and is pinned at both ends"), "{told:?}");
    let idle = imported(&(free(&stick()) + &strut.replace("CROD,77,5,8,3", "CROD,77,5,8,1")));
    assert!(
        reports(&idle)[0].contains("CROD 77: both its ends, GRID 8 and 1, are on one rigid body"),
        "{:?}",
        reports(&idle)
    );
}

#[test]
fn what_beams_do_not_hold_is_said_by_card_line_and_field() {
    for (from, to, said) in [
        (
            "CBAR, 2, 2, 2, 3, 0., 0., 1.",
            "CBAR,2,2,2,3,0.,0.,1.,\n+,5",
            "deck.bdf:17: CBAR 2, field 2 (PA): found 5: pin flags are held where a loop begins or ends, this end is fixed in all six",
        ),
        (
            "RBE2, 9, 3, 123456, 4",
            "RBE2,9,3,123,4",
            "RBE2 9, field 4 (CM): found 123: links are held rigid in all six",
        ),
        (
            "SPC1, 7, 123456, 1",
            "SPC1,7,123456,1\nSPC1,7,13,5",
            "SPC1 7: components 13 of GRID 5 are held, the others not: they are free here",
        ),
        (
            "SPC1, 7, 123456, 1",
            "SPC1,7,123456,1,5",
            "SPC1 7: GRID 5 is held too: one place is clamped here, this one is free",
        ),
        ("SPC1, 7, 123456, 1", "SPC1,7,123456,1\nCQUAD4,1,1,1,2,3,4", "CQUAD4 1: this card is not read"),
        (
            "SPC1, 7, 123456, 1",
            "SPC1,7,123456,1\nGRID,70,,1.,1.,1.\nGRID,71,,2.,1.,1.\nCBAR,8,1,70,71,0.,0.,1.",
            "CBAR 8: no chain of elements and rigid links joins it to the root",
        ),
    ] {
        let deck = free(&stick());
        assert!(deck.contains(from), "{from}\n{deck}");
        let told = reports(&imported(&deck.replace(from, to)));
        assert!(told.iter().any(|line| line.contains(said)), "{said}: {told:?}");
    }
    assert_eq!(reports(&imported(&free(&stick()))), [""; 0]);
}

#[test]
fn shear_areas_warping_and_masses_apart_are_said_of_beams() {
    let beam = "PBEAM,3,1,.004,2.-5,8.-5,,3.-5,.5\n+,0.,0.\n+,YES,1.,.002,1.-5,4.-5,,1.5-5,.5\n+,0.,0.\n+,.5,.5,,,,,.1\n+,,,.02\n";
    let deck = free(&stick()).replace("PBEAM, 3, 1, .004, 2.-5, 8.-5, , 3.-5, .5\n", beam);
    let told = reports(&imported(&deck)).join("\n");
    for said in [
        "PBEAM 3, field 2 (PID): the section changes along the element",
        "deck.bdf:18: PBEAM 3, field 2 (K1): found 0.5: flexibility in shear",
        "deck.bdf:18: PBEAM 3, field 8 (CW(A)): found 0.1: warping",
        "deck.bdf:19: PBEAM 3, field 4 (M1(B)): found 0.02, and 0 at end A: the mean is held",
    ] {
        assert!(told.contains(said), "{said}\n{told}");
    }
}

#[test]
fn masses_on_several_carriers_keep_their_mass_centre_and_inertia() {
    let spread = "GRID,60,,.7,3.,.4\nRBE3,61,,60,123456,1.,123,2,3\nCONM2,62,60,,40.,,,,,3.,0.,4.,0.,0.,5.\n";
    let rigid = "GRID,60,,.7,3.,.4\nRBE2,61,3,123456,60\nCONM2,62,60,,40.,,,,,3.,0.,4.,0.,0.,5.\n";
    let [spread, rigid] = [spread, rigid].map(|more| imported(&(free(&stick()) + more)));
    assert!(
        reports(&spread)[0].contains("RBE3 61: CONM2 62 on GRID 60: its mass is divided"),
        "{:?}",
        reports(&spread)
    );
    let integrals = |found: &Imported| found.aircraft.clone().reduce().unwrap().integrals.clone();
    let [spread, rigid] = [integrals(&spread), integrals(&rigid)];
    assert!((spread.mass - rigid.mass).abs() < 1e-9);
    assert!((spread.first_moment - rigid.first_moment).norm() < 1e-8);
    assert!((spread.inertia - rigid.inertia).norm() < 1e-7);
}

#[test]
fn mistakes_are_told_with_file_line_card_field_found_and_allowed() {
    for (from, to, said) in [
        (
            "GRID, 2, , 0.1,",
            "GRID,2,,0.1.2,",
            "deck.bdf:3:9: GRID 2, field 4 (X1): found 0.1.2; a number is allowed, as 1.5, 1.5E3 or 1.5+3",
        ),
        (
            "CBAR, 1, 1, 1, 2,",
            "CBAR,1,1,1,99,",
            "deck.bdf:15:1: CBAR 1 (GA, GB): found 99; a GRID of the deck is needed",
        ),
        ("CBAR, 1, 1,", "CBAR,1,3,", "CBAR 1 (PID): found 3; a PBAR or PBARL of the deck is needed"),
        ("BOX,", "HAT,", "PBARL 1, field 5 (TYPE): found HAT; ROD, TUBE, BAR, BOX, I, T or CHAN is allowed"),
        (
            ".5, .2, .004, .003",
            ".5,.2,.104,.003",
            "PBARL 1, field 4 (DIM3): found 0.104; less than half of the height, 0.1, is allowed",
        ),
        (
            "GRID, 5, 9,",
            "GRID,5,8,",
            "GRID 5 (place): found 8; a CORD1R, CORD2R or CORD2C of the deck is needed",
        ),
        (
            "CBAR, 1, 1, 1, 2, 0., 0., 1.",
            "CBAR,1,1,1,2,.1,2.,.05",
            "CBAR 1 (X1, X2, X3): found a direction along the element",
        ),
        ("CORD2C, 9, 0,", "CORD2C,9,9,", "CORD2C 9 (place): found 9, which rests on this one"),
        (
            "CORD2C, 9, 0, 0., 0., 0., 0., 0., 1.",
            "CORD2C,9,0,0.,0.,0.,0.,0.,0.",
            "found three points on one line",
        ),
        (
            "CBAR, 2,",
            "CBAR,1,",
            "CBAR 1, field 2 (ID): found 1 a second time; a number that no other has is allowed",
        ),
        ("CONM2, 1, 4,", "CONM2,1,44,", "CONM2 1 (G): found 44; a GRID of the deck is needed"),
    ] {
        let deck = free(&stick());
        assert!(deck.contains(from), "{from}\n{deck}");
        let told = of_text(&deck.replace(from, to)).map(|_| ()).unwrap_err().to_string();
        assert!(told.contains(said), "{said}\n{told}");
    }
    let told = of_text("GRID,1\n").unwrap_err().to_string();
    assert_eq!(told, "found no CBAR, CBEAM or CROD; one of them at least is needed");
}

#[test]
fn inertias_that_no_body_has_are_mended_and_said() {
    let deck = free(&stick()).replace("1., , 2., , , 2.5", ",,2.,,,");
    let found = imported(&deck);
    assert!(
        reports(&found)[0]
            .contains("CONM2 1: no body has the principal moments 0.000000, 0.000000, 2.000000 kg m²"),
        "{:?}",
        reports(&found)
    );
    let bay = found.aircraft.bays.iter().find(|bay| bay.mass == 12.0).unwrap();
    assert!((bay.inertia.diagonal() - nalgebra::Vector3::new(0.0, 2.0, 2.0)).norm() < 1e-12);
}

/// The stick in columns of eight.
pub fn stick_text() -> String {
    small(&stick())
}

#[test]
fn damping_is_reported_and_a_modulus_that_is_not_given_is_noted() {
    let text = free(&stick()).replace("2700.", "2700.,,,.02") + "PARAM,G,.03\nMAT1,9,7.+10\n";
    let found = imported(&text);
    let reports = reports(&found);
    assert!(
        reports
            .iter()
            .any(|report| report
                .contains("MAT1 1, field 9 (GE): found 0.02: damping of materials is not held")),
        "{reports:?}"
    );
    let notes = &found.remarks.notes;
    assert!(notes.iter().any(|note| note.starts_with("PARAM G = .03: damping")), "{notes:?}");
    assert!(notes.iter().any(|note| note.starts_with("MAT1 9 has one modulus and no NU")), "{notes:?}");
}
