//! What meets, crosses, doubles or goes on is held as the deck has it, or told by its card.

use super::*;

/// A clamped half wing of 10 m in four elements, on whose beam panels may be.
const WING: &str = "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,.01,1.-5,1.-4,2.-5\nSPC1,1,123456,100\nGRID,100,,1.,0.,0.\nGRID,101,,1.,2.5,0.\n\
    GRID,102,,1.,5.,0.\nGRID,103,,1.,7.5,0.\nGRID,104,,1.,10.,0.\nCBAR,101,1,100,101,0.,0.,1.\nCBAR,102,1,101,102,0.,0.,1.\n\
    CBAR,103,1,102,103,0.,0.,1.\nCBAR,104,1,103,104,0.,0.,1.\n";

/// Hinges at three quarters, nine tenths and an eighth of a chord of 2 m.
const HINGES: &str = "CORD2R,11,,1.5,6.,0.,1.5,6.,1.\n,2.5,6.,0.\nCORD2R,12,,1.8,6.,0.,1.8,6.,1.\n,2.8,6.,0.\nCORD2R,13,,.3,6.,0.,.3,6.,1.\n,2.8,6.,0.\n";

#[track_caller]
fn read(text: &str) -> Imported {
    of_text(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn area(found: &Imported) -> f64 {
    found.aircraft.strips.iter().map(|strip| 2.0 * strip.semichord * strip.width).sum()
}

#[test]
fn panels_that_overlap_by_a_slip_meet() {
    let found = read(&format!(
        "{WING}CAERO1,10001,,,4,4,,,1\n,0.,0.,0.,2.,0.,5.002,0.,2.\nCAERO1,20001,,,4,4,,,1\n,0.,4.998,0.,2.,.4,10.,0.,1.\n"
    ));
    assert_eq!(reports(&found), [""; 0]);
    assert!((area(&found) - 17.5).abs() < 5e-3, "{}", area(&found));
}

#[test]
fn of_panels_over_one_another_the_larger_one_stays_however_controls_cut_it() {
    let found = read(&format!(
        "{WING}{HINGES}CAERO1,10001,,,20,4,,,1\n,0.,0.,0.,2.,0.,10.,0.,2.\nCAERO1,20001,,,4,2,,,1\n,.5,6.,0.,1.2,.5,6.9,0.,1.2\n\
         AELIST,1,10052\nAELIST,2,10056\nAESURF,1,AILA,11,1\nAESURF,2,AILB,11,2\n"
    ));
    assert!((area(&found) - 20.0).abs() < 1e-9 && found.aircraft.controls.len() == 2);
    let told = reports(&found);
    assert!(
        told.len() == 1
            && told[0].contains("CAERO1 20001: 1.0800 m² of what is from 0.6000 to 0.6900 of a beam"),
        "{told:?}"
    );
}

#[test]
fn panels_whose_spans_cross_are_both_held_on_one_beam() {
    let beam = WING.split("GRID,100").next().unwrap();
    let found = read(&format!(
        "{beam}GRID,100,,1.,0.,0.\nGRID,104,,1.,5.,4.\nCBAR,101,1,100,104,0.,0.,1.\nCAERO1,10001,,,10,4,,,1\n,0.,0.,0.,2.,0.,5.,0.,2.\n\
         CAERO1,20001,,,10,4,,,1\n,0.,0.,0.,1.,0.,0.,4.,1.\n"
    ));
    assert!((area(&found) - 14.0).abs() < 1e-9, "{}", area(&found));
    assert!(reports(&found).iter().all(|told| told.contains("above or below its beam")));
}

#[test]
fn tabs_are_told_whatever_else_is_told_of_their_card() {
    let found = read(&format!(
        "{WING}{HINGES}CAERO1,10001,,,10,4,,,1\n,0.,0.,0.,2.,0.,10.,0.,2.\nAELIST,1,10001,10005,10009\nAELIST,2,10028,10032\n\
         AELIST,21,10024,10028,10032\nAESURF,1,FLAP,11,21\nAESURF,2,MIX,13,1,12,2\n"
    ));
    let told = reports(&found).join("\n");
    for said in [
        "AESURF 2: MIX: its boxes on CAERO1 10001, from 0.000 to 0.250 of the chord",
        "AESURF 2: from 0.6000 to 0.8000 of a panel's span its flap has its hinge at 0.900",
        "AESURF 2: MIX: no strip has a flap of it, it is left out",
    ] {
        assert!(told.contains(said), "{told}");
    }
}

#[test]
fn two_elevators_pitch_more_than_flaps_and_turn_as_far_as_both_may() {
    let flaps = panels::wing_text().replace("AESURF,1,AIL,21,11,22,12", "AESURF,1,FLAPS,21,11,21,12");
    for (hinge, limits) in [
        ("41", "minimum_deg = -11.4591559026\nmaximum_deg = 17.1887338539"),
        ("43", "minimum_deg = -22.9183118052\nmaximum_deg = 11.4591559026"),
    ] {
        let apart = format!("AESURF,2,ELEVR,41,31\n,,,-.4,.3\nAESURF,3,ELEVL,{hinge},32\n,,,-.2,.5\n");
        let text = flaps.replace("AESURF,2,ELEV,41,31,41,32\n", &apart);
        let found = imported(&(text + "CORD2R,43,,5.3,0.,0.,5.3,0.,-1.\n,6.3,0.,0.\n"));
        let control = found.text().split("[[control]]").find(|text| text.contains("both_elevators")).unwrap();
        assert!(control.contains("trim = \"pitch\"") && control.contains(limits), "{control}");
    }
}

#[test]
fn links_that_tie_beams_to_a_mean_and_those_that_are_free_are_told() {
    let two = "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,.01,1.-5,1.-4,2.-5\nSPC1,1,123456,1\nGRID,1,,0.,0.,0.\nGRID,2,,0.,5.,0.\nGRID,3,,5.,0.,0.\n\
               GRID,4,,5.,5.,0.\nCBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,1,3,0.,0.,1.\nCBAR,3,1,2,4,0.,0.,1.\n";
    let told = reports(&read(&format!("{two}RBE3,50,,4,123456,1.,123456,2,3\n"))).join("\n");
    assert!(
        told.contains(
            "RBE3 50: GRID 4 is on beams of its own: that it moves with the mean of 2 grids is not held"
        ),
        "{told}"
    );
    let mass = "GRID,5,,6.,5.,0.\nCONM2,9,5,,3.\n";
    let told = |more: &str| reports(&read(&format!("{two}{mass}{more}"))).join("\n");
    assert!(
        told("RBE3,50,,5,123,1.,123,4\n")
            .contains("RBE3 50, field 5 (REFC): found 123 of 123: links are held rigid")
    );
    assert_eq!(told("RBE3,50,,5,123456,1.,123456,4\n"), "");
}

#[test]
fn other_mass_that_changes_and_stations_twice_are_told() {
    let beam = |lines: &str| {
        let stick = "MAT1,1,7.+10,,.3,2700.\nSPC1,1,123456,1\nGRID,1,,0.,0.,0.\nGRID,2,,0.,4.,0.\nCBEAM,1,1,1,2,0.,0.,1.\n";
        format!("{stick}PBEAM,1,1,.01,1.-5,1.-4,,2.-5,{lines}")
    };
    let told = reports(&read(&beam("0.\n,NO,1.,.01,1.-5,1.-4,,2.-5,100.\n,0.,0.,,,1.,3.\n"))).join("\n");
    assert!(told.contains("PBEAM 1, field 2 (PID): other mass (NSM) changes along the element"), "{told}");
    assert!(told.contains("(NSI(B)): found 3, and 1 at end A"), "{told}");
    let refused = of_text(&beam("0.\n,NO,.5,.02\n,NO,.5,.03\n")).map(|_| ()).unwrap_err().to_string();
    assert!(refused.contains("PBEAM 1, field 3 (X/XB): found 0.5 a second time"), "{refused}");
}

#[test]
fn an_inertia_without_mass_gets_a_share_of_the_elements_mass_too() {
    let found = read(&format!("{WING}CONM2,2,104,,0.\n,1.,,1.,,,1.\n"));
    assert!(
        reports(&found)[0].contains("CONM2 2: an inertia without mass: it gets 2.700e-4 kg"),
        "{:?}",
        reports(&found)
    );
}

#[test]
fn all_grids_of_a_suport_are_told_and_second_defaults_are_mistakes() {
    let found = read(&format!("{}SUPORT,102,123456,104\n", WING.replace("SPC1,1,123456,100\n", "")));
    let told = "SUPORT: GRID 104 is supported too; of all, GRID 102 is O".to_owned();
    assert!(found.remarks.notes.contains(&told), "{:?}", found.remarks.notes);
    for card in ["BAROR", "BEAMOR", "GRDSET"] {
        let twice = format!("{WING}{card},,,,,0.,0.,1.\n{card},,,,,0.,0.,1.\n")
            .replace("GRDSET,,,,,0.,0.,1.", "GRDSET,,,,,0");
        let told = of_text(&twice).map(|_| ()).unwrap_err().to_string();
        assert!(told.contains(&format!("found a second {card}; one is allowed")), "{told}");
    }
}

#[test]
fn the_vector_of_a_baror_is_in_the_frame_that_the_element_says() {
    let deck = |offt: &str| {
        format!(
            "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,.01,1.-4,4.-4,1.-4\nSPC1,1,123456,1\nBAROR,,1,,,0.,0.,1.,BGG\nCORD2R,5,,0.,0.,0.,1.,0.,0.\n,0.,0.,1.\n\
             GRID,1,,0.,0.,0.,5\nGRID,2,,0.,3.,0.,5\nCBAR,1,1,1,2,,,,{offt}\n"
        )
    };
    let y_axis = |text: &str| read(text).aircraft.beams[0].y_axis;
    // z of the basic frame is up, -z of body axes; z of frame 5 is aft, -x of body axes.
    assert!((y_axis(&deck("")) + nalgebra::Vector3::z()).norm() < 1e-12);
    assert!((y_axis(&deck("GGG")) + nalgebra::Vector3::x()).norm() < 1e-12);
}

#[test]
fn fractions_run_from_0_to_1_and_splines_move_boxes_that_are_there() {
    let panel = "CAERO1,10001,,,4,,,1,1\n,0.,0.,0.,2.,0.,10.,0.,2.\n";
    let told = of_text(&format!("{WING}{panel}AEFACT,1,0.,.5,.8\n")).map(|_| ()).unwrap_err().to_string();
    assert!(told.contains("CAERO1 10001 (LCHORD): found [0.0, 0.5, 0.8] in AEFACT 1"), "{told}");
    let spline = |boxes: &str| {
        let found = read(&format!(
            "{WING}{panel}AEFACT,1,0.,.5,1.\nSET1,1,100,THRU,104\nSPLINE1,4,10001,{boxes},1\n"
        ));
        (reports(&found).join("\n"), found.remarks.notes.join("\n"))
    };
    assert!(
        spline("10001,10099").0.contains("SPLINE1 4: found 10001 to 10099, of which CAERO1 10001 has no box")
    );
    // Corners in either order.
    assert_eq!([spline("10001,10008"), spline("10008,10001")].map(|(told, notes)| told + &notes), [""; 2]);
}
