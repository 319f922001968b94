//! Control surfaces as decks have them: on panels of their own, at the leading edge, on one another; and what their text says.

use super::*;

/// A clamped half wing of 3 m with a panel of six strips and ten rows on a chord of 1 m.
fn half(more: &str) -> String {
    format!(
        "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,.01,1.-4,4.-4,1.-4\nGRID,1,,0.,0.,0.\nGRID,2,,0.,1.5,0.\nGRID,3,,0.,3.,0.\n\
         CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\nCAERO1,1001,1,,6,10,,,1\n,-.25,0.,0.,1.,-.25,3.,0.,1.\n\
         SPLINE1,1,1001,1001,1060,1\nSET1,1,1,2,3\nCORD2R,1,,.50,0.,0.,.50,0.,1.\n,1.,0.,0.\nCORD2R,2,,.65,0.,0.,.65,0.,1.\n,1.,0.,0.\n\
         CORD2R,3,,-.1,0.,0.,-.1,0.,1.\n,1.,0.,0.\nSPC1,1,123456,1\n{more}"
    )
}

#[track_caller]
fn read(text: &str) -> Imported {
    of_text(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn area(found: &Imported) -> f64 {
    found.aircraft.strips.iter().map(|strip| 2.0 * strip.semichord * strip.width).sum()
}

/// The wing of `panels` with the rear quarter of each panel a panel of its own, which has the control surfaces.
fn cut_along_the_chord(part: f64) -> String {
    let whole = panels::wing_text();
    let rear = |chord: f64| chord * (1.0 - part);
    let mut text = whole.split("PAERO1").next().unwrap().to_owned() + "PAERO1,1\n";
    for (id, spanwise, [x1, y1, c1], [x2, y2, c2], set) in [
        (1001, 6, [-0.4, 0.0, 1.5], [-0.28, 6.0, 1.0], Some("1,1,101,THRU,106")),
        (2001, 6, [-0.28, -6.0, 1.0], [-0.4, 0.0, 1.5], Some("2,1,201,THRU,206")),
        (3001, 3, [4.7, 0.0, 0.8], [4.7, 1.5, 0.8], None),
        (4001, 3, [4.7, -1.5, 0.8], [4.7, 0.0, 0.8], None),
    ] {
        let mut panel = |id: i32, rows: i32, from: [f64; 2], chords: [f64; 2]| {
            text += &format!(
                "CAERO1,{id},1,,{spanwise},{rows},,,1\n+,{:.5},{y1:.5},0.,{:.5},{:.5},{y2:.5},0.,{:.5}\n",
                from[0], chords[0], from[1], chords[1]
            );
        };
        panel(id, 3, [x1, x2], [c1 * part, c2 * part]);
        panel(id + 500, 1, [x1 + c1 * part, x2 + c2 * part], [rear(c1), rear(c2)]);
        if let Some(set) = set {
            let number = &set[..1];
            text += &format!("SET1,{set}\nSPLINE1,{number},{id},{id},{},{number}\n", id + 3 * spanwise - 1);
            text +=
                &format!("SPLINE1,1{number},{},{},{},{number}\n", id + 500, id + 500, id + 499 + spanwise);
        }
    }
    text + "CORD2R,21,,.6,0.,0.,.6,0.,1.\n+,1.6,0.,0.\nCORD2R,22,,.6,0.,0.,.6,0.,-1.\n+,1.6,0.,0.\n\
            CORD2R,41,,5.3,0.,0.,5.3,0.,1.\n+,6.3,0.,0.\nAELIST,11,1505,1506\nAELIST,12,2501,2502\n\
            AELIST,31,3501,THRU,3503\nAELIST,32,4501,THRU,4503\nAESURF,1,AIL,21,11,22,12\nAESURF,2,ELEV,41,31,41,32\n"
}

#[test]
fn panels_whose_edges_meet_along_the_chord_are_one_with_its_flaps() {
    let whole = imported(&panels::wing_text());
    let cut = imported(&cut_along_the_chord(0.75));
    assert_eq!(reports(&cut), [""; 0]);
    assert!(
        cut.remarks.notes.iter().any(|note| note.starts_with("CAERO1 1501 lies behind CAERO1 1001")),
        "{:?}",
        cut.remarks.notes
    );
    assert!((area(&cut) - 17.4).abs() < 1e-5, "{}", area(&cut));
    assert_eq!(cut.aircraft.strips.len(), whole.aircraft.strips.len());
    for (one, other) in cut.aircraft.strips.iter().zip(&whole.aircraft.strips) {
        assert!((one.semichord - other.semichord).abs() < 1e-5);
        let hinges =
            [one, other].map(|strip| strip.flap.as_ref().map(|flap| (flap.hinge, flap.gains.clone())));
        match &hinges {
            [Some((one, gains)), Some((other, others))] => {
                assert!((one - other).abs() < 1e-4 && gains == others, "{hinges:?}");
            }
            hinges => assert_eq!(hinges, &[None, None]),
        }
    }
}

#[test]
fn a_panel_behind_part_of_another_one_leaves_the_rest_as_it_was() {
    let rear = "CAERO1,2001,1,,2,2,,,1\n,.75,1.,0.,.5,.75,2.,0.,.5\nAELIST,1,2001,THRU,2004\nCORD2R,5,,.75,0.,0.,.75,0.,1.\n,1.,0.,0.\n\
                AESURF,1,FLAP,5,1\n";
    let found = read(&half(rear));
    assert_eq!(reports(&found), [""; 0]);
    assert!((area(&found) - 3.5).abs() < 1e-9, "{}", area(&found));
    let flaps: Vec<_> = found
        .aircraft
        .strips
        .iter()
        .filter_map(|strip| Some((strip.semichord, strip.flap.as_ref()?.hinge)))
        .collect();
    assert!(!flaps.is_empty() && flaps.iter().all(|(semichord, hinge)| (semichord - 0.75).abs() < 1e-9 && (hinge - 2.0 / 3.0).abs() < 1e-7));
}

/// As an elevator with a horn, or one that is as wide as the beam where the stabiliser is not.
#[test]
fn a_panel_wider_than_the_one_ahead_of_it_is_behind_it_where_both_are() {
    let narrow = half("").replace("-.25,3.,0.,1.", "-.25,2.,0.,1.");
    let rear = "CAERO1,2001,1,,3,2,,,1\n,.75,0.,0.,1.,.75,3.,0.,1.\nAELIST,1,2001,THRU,2006\nCORD2R,5,,.75,0.,0.,.75,0.,1.\n,1.,0.,0.\n\
                AESURF,1,FLAP,5,1,0,,1.\n";
    let found = read(&(narrow + rear));
    let told = reports(&found);
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(
        told[0].contains("FLAP: its hinge, y of its frame, is at 0.000 of the chord of CAERO1 2001"),
        "{told:?}"
    );
    assert!((area(&found) - (2.0 * 2.0 + 1.0)).abs() < 1e-9, "{}", area(&found));
    for strip in &found.aircraft.strips {
        let beam = &found.aircraft.beams[strip.attachment.beam];
        let y = beam.nodes.map(|node| found.aircraft.nodes[node].y);
        let place = y[0] + strip.attachment.fraction * (y[1] - y[0]);
        let (semichord, hinge) = if place < 2.0 { (1.0, 0.5) } else { (0.5, 0.02) };
        let flap = strip.flap.as_ref().unwrap();
        assert!(
            (strip.semichord - semichord).abs() < 1e-9 && (flap.hinge - hinge).abs() < 1e-7,
            "{place} {flap:?}"
        );
    }
}

#[test]
fn panels_over_one_another_are_told_of_by_their_cards() {
    let over = "CAERO1,2001,1,,2,2,,,1\n,-.25,1.,0.,1.,-.25,2.,0.,1.\n";
    let found = read(&half(over));
    let told = reports(&found).join("\n");
    let said = "CAERO1 2001: 1.0000 m² of what is from 0.3333 to 0.6667 of a beam lie where CAERO1 1001 has strips: they are left out";
    assert!(told.contains(said), "{told}");
    assert!((area(&found) - 3.0).abs() < 1e-9);
    let told = of_text(&half(&over.replace("2001", "1050"))).map(|_| ()).unwrap_err().to_string();
    assert!(
        told.contains("CAERO1 1050 (EID): found 1050, which is the number of a box of CAERO1 1001"),
        "{told}"
    );
}

#[test]
fn slats_spoilers_tabs_and_boxes_of_no_panel_are_told_of() {
    let told = |more: &str| {
        let found = read(&half(more));
        (reports(&found).join("\n"), found)
    };
    for (boxes, from) in [
        ("1001,1002,1011,1012", "0.000 to 0.200"),
        ("1006,1007,1016,1017", "0.500 to 0.700"),
        ("1001,1010", "0.000 to 0.100"),
    ] {
        let (said, found) = told(&format!("AELIST,1,{boxes}\nAESURF,1,SLAT,3,1\n"));
        assert!(said.contains(&format!("AESURF 1: SLAT: its boxes on CAERO1 1001, from {from} of the chord, do not reach the rear edge")), "{said}");
        assert!(found.aircraft.controls.is_empty());
    }
    let (said, found) = told(
        "AELIST,1,1008,1009,1010,1018,1019,1020\nAELIST,2,1010,1020\nAESURF,1,AIL,1,1\nAESURF,2,TAB,2,2\n",
    );
    assert!(
        said.contains(
            "AESURF 2: from 0.0000 to 0.3333 of a panel's span its flap has its hinge at 0.900 of the chord"
        ),
        "{said}"
    );
    assert!(said.contains("that of AESURF 1 at 0.750"), "{said}");
    assert_eq!(found.aircraft.controls.len(), 1);
    let (said, _) = told("AELIST,1,1009,1010,9919,1020\nAESURF,1,AIL,2,1\n");
    assert!(said.contains("AELIST 1: found 9919, of which no CAERO1 has a box"), "{said}");
    // The other strip has its last row alone, as the list has it.
    assert!(said.contains("begin at 0.800 and at 0.900"), "{said}");
    let (said, _) = told("AELIST,1,1059,THRU,1070\nAESURF,1,AIL,2,1\n");
    assert!(said.contains("AELIST 1: found 1061 and 9 more, of which no CAERO1 has a box"), "{said}");
    let (said, _) = told("AELIST,1,1006,THRU,1010,1019,1020\nAESURF,1,AIL,2,1\n");
    assert!(
        said.contains("AIL: its boxes on CAERO1 1001 begin at 0.500 and at 0.800 of the chord"),
        "{said}"
    );
}

#[test]
fn hinges_have_the_digits_of_the_deck() {
    let found = read(&half(
        "AELIST,1,1008,1009,1010\nCORD2R,7,,.283333,0.,0.,.283333,0.,1.\n,1.,0.,0.\nAESURF,1,AIL,7,1\n",
    ));
    assert!(found.text().contains("hinge = 0.533333 }"), "{}", found.text());
}

#[test]
fn the_text_of_a_control_says_what_its_gains_do_on_each_side() {
    let positive = |text: &str| {
        let found = imported(text);
        let line = found.text().lines().find(|line| line.starts_with("positive")).unwrap().to_owned();
        (line, found.text().lines().find(|line| line.starts_with("mirror = \"")).unwrap().to_owned())
    };
    let pairs = panels::wing_text();
    let expected = (
        "positive = \"trailing edge down on the right, up on the left\"".to_owned(),
        "mirror = \"opposite\"".to_owned(),
    );
    assert_eq!(positive(&pairs), expected);
    // A mass on one side alone: no component has an image.
    assert_eq!(positive(&(pairs.clone() + "CONM2,900,106,,1.\n")), expected);
    let down = pairs.replace("AESURF,1,AIL,21,11,22,12", "AESURF,1,FLAP,21,11,21,12");
    assert_eq!(positive(&down).0, "positive = \"trailing edge down\"");
}

#[test]
fn a_swept_fin_on_a_link_and_wings_beyond_a_kink_are_components_with_their_names() {
    let fin = "MAT1,1,7.+10,,.33,2700.\nPBARL,1,1,,TUBE\n,.8,.797\nPBARL,2,1,,BOX\n,.5,.12,.002,.002\nGRID,1,,0.,0.,0.\nGRID,2,,6.,0.,0.\n\
               GRID,3,,12.,0.,0.\nGRID,4,,12.6,0.,1.\nGRID,5,,14.,0.,3.\nCBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\nRBE2,3,3,123456,4\n\
               CBAR,4,2,4,5,0.,1.,0.\nSPC1,1,123456,1\n";
    let names = |text: &str| -> Vec<String> {
        let found = read(text);
        let mut names: Vec<String> = found.aircraft.beams.iter().map(|beam| beam.component.clone()).collect();
        names.dedup();
        names
    };
    assert_eq!(names(fin), ["fuselage_aft", "fin"]);
    // On a body that is rigid as a whole.
    let on_link = fin.replace("CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\nRBE2,3,3,", "RBE2,3,1,");
    assert_eq!(names(&on_link), ["fin"]);
    let with_tail = on_link + "GRID,6,,13.,2.,1.\nCBAR,6,2,4,6,0.,0.,1.\n";
    assert!(names(&with_tail).contains(&"fuselage_aft".to_owned()), "{:?}", names(&with_tail));
    // A gull wing.
    let wing = "MAT1,1,7.+10,,.33,2700.\nPBAR,1,1,.01,1.-4,4.-4,1.-4\nGRID,1,,0.,0.,0.\nGRID,2,,0.,3.,2.9\nGRID,3,,0.,7.,0.\n\
                CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\nSPC1,1,123456,1\n";
    assert_eq!(names(wing), ["wing_right", "wing_outer_right"]);
}
