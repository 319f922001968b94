//! Panels, splines, control surfaces: where strips come to be, what moves them, and that it flies.

use super::*;
use crate::import::nastran::aero::SurfaceLine;

/// A free wing with a body and a tail, both halves, panels from y = 0 out and hinges.
pub fn wing_text() -> String {
    let mut text = String::from(
        "MAT1,1,7.+10,,.3\nPBAR,1,1,.01,2.-4,8.-4,3.-4\nGRID,1,,0.,0.,0.\nGRID,2,,5.,0.,0.\nGRID,3,,-2.,0.,0.\n\
         CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,1,3,0.,0.,1.\nCONM2,1,3,,120.,,,,,9.,0.,9.,0.,0.,9.\nCONM2,2,2,,20.\n\
         CONM2,3,1,,300.,-.1,,,,80.,0.,90.,0.,0.,120.\nAEROS,,,1.25,12.,15.\n",
    );
    for (base, sign) in [(100, 1.0), (200, -1.0)] {
        for step in 1..=6 {
            text +=
                &format!("GRID,{},,{},{},0.\n", base + step, 0.02 * f64::from(step), sign * f64::from(step));
            let from = if step == 1 { 1 } else { base + step - 1 };
            text += &format!("CBAR,{},1,{from},{},0.,0.,1.\n", base + step, base + step);
            text += &format!("CONM2,{},{},,15.,,,,,1.,0.,1.,0.,0.,1.5\n", base + step, base + step);
        }
    }
    for (base, sign) in [(300, 1.0), (400, -1.0)] {
        text += &format!(
            "GRID,{base},,5.,{},0.\nCBAR,{base},1,2,{base},0.,0.,1.\nCONM2,{base},{base},,4.\n",
            1.5 * sign
        );
    }
    text + "PAERO1,1\nCAERO1,1001,1,,6,4,,,1\n+,-.4,0.,0.,1.5,-.28,6.,0.,1.\nCAERO1,2001,1,,6,4,,,1\n+,-.28,-6.,0.,1.,-.4,0.,0.,1.5\n\
        CAERO1,3001,1,,3,4,,,1\n+,4.7,0.,0.,.8,4.7,1.5,0.,.8\nCAERO1,4001,1,,3,4,,,1\n+,4.7,-1.5,0.,.8,4.7,0.,0.,.8\n\
        SPLINE1,1,1001,1001,1024,1\nSET1,1,1,101,THRU,106\nSPLINE1,2,2001,2001,2024,2\nSET1,2,1,201,THRU,206\n\
        CORD2R,21,,.6,0.,0.,.6,0.,1.\n+,1.6,0.,0.\nCORD2R,41,,5.3,0.,0.,5.3,0.,1.\n+,6.3,0.,0.\n\
        AELIST,11,1020,1024\nAELIST,12,2004,2008\nAELIST,31,3004,3008,3012\nAELIST,32,4004,4008,4012\n\
        CORD2R,22,,.6,0.,0.,.6,0.,-1.\n+,1.6,0.,0.\n\
        AESURF,1,AIL,21,11,22,12\nAESURF,2,ELEV,41,31,41,32\n"
}

#[test]
fn panels_become_strips_where_they_are() {
    let found = imported(&wing_text());
    assert_eq!(reports(&found), [""; 0], "{}", found.text());
    let aircraft = &found.aircraft;
    // Chords run from 1.5 to 1 m over 6 m on both sides, the tail has 0.8 m over 1.5 m.
    let area = |of: &str| -> f64 {
        let strips = aircraft
            .strips
            .iter()
            .filter(|strip| aircraft.beams[strip.attachment.beam].component.starts_with(of));
        strips.map(|strip| 2.0 * strip.semichord * strip.width).sum()
    };
    assert!(
        (area("wing") - 15.0).abs() < 1e-9 && (area("tail") - 2.4).abs() < 1e-9,
        "{} {}",
        area("wing"),
        area("tail")
    );
    for strip in &aircraft.strips {
        let beam = &aircraft.beams[strip.attachment.beam];
        let [one, other] = beam.nodes.map(|node| aircraft.nodes[node]);
        let place = one.lerp(&other, strip.attachment.fraction);
        // Leading edge in body x: 0.4 − 0.02 y ahead of O on the wing, 4.7 behind it on the tail.
        let (leading, chord) = match beam.component.starts_with("wing") {
            true => (0.4 - 0.02 * place.y.abs(), 1.5 - place.y.abs() / 12.0),
            false => (-4.7, 0.8),
        };
        let axis = (leading - place.x) / chord;
        let found = 0.5 + strip.elastic_axis_aft_of_midchord / (2.0 * strip.semichord);
        assert!((found - axis).abs() < 1e-8, "{found} {axis}");
    }
    assert_eq!(
        aircraft.reference_lengths().map(|lengths| [lengths.chord, lengths.area, lengths.span]),
        Some([1.25, 15.0, 12.0])
    );
    assert!(found.text().contains("symmetric = true\n") && found.text().contains("mirror = \"wing_left\"\n"));
}

#[test]
fn control_surfaces_have_their_boxes_hinges_signs_and_roles() {
    let found = imported(&wing_text());
    let aircraft = &found.aircraft;
    let names: Vec<&str> = aircraft.controls.iter().map(|control| control.name.as_str()).collect();
    assert_eq!(names, ["ail", "elev"]);
    let roles: Vec<_> = aircraft.controls.iter().map(|control| control.role).collect();
    use flexible_aircraft::aircraft::TrimRole;
    assert_eq!(roles, [Some(TrimRole::Roll), Some(TrimRole::Pitch)]);
    let of = |control: usize| {
        aircraft.strips.iter().filter_map(move |strip| {
            let flap = strip.flap.as_ref().filter(|flap| flap.gains[control] != 0.0)?;
            let beam = &aircraft.beams[strip.attachment.beam];
            let [one, other] = beam.nodes.map(|node| aircraft.nodes[node]);
            Some((
                one.lerp(&other, strip.attachment.fraction),
                flap.gains[control],
                flap.hinge,
                strip.semichord,
            ))
        })
    };
    let ailerons: Vec<_> = of(0).collect();
    assert_eq!(ailerons.len(), 4);
    for (place, gain, hinge, semichord) in ailerons {
        // Trailing edge down on the right, up on the left, over the outer two of six metres.
        assert_eq!(gain, place.y.signum());
        assert!(place.y.abs() > 4.0);
        // The hinge is 0.6 m behind O; that of a flap is taken at the middle of it.
        let middle = 0.5 * (4.0 + 6.0);
        let expected = (0.6 + 0.4 - 0.02 * middle) / (1.5 - middle / 12.0);
        assert!((hinge - expected).abs() < 1e-9, "{hinge} {expected} {semichord}");
    }
    assert!(of(1).all(|(_, gain, hinge, _)| gain == 1.0 && (hinge - 0.75).abs() < 1e-9));
    assert_eq!(of(1).count(), 2);
}

#[test]
fn a_deck_with_panels_trims_and_flies() {
    let model = std::sync::Arc::new(imported(&wing_text()).aircraft.reduce().unwrap());
    let settings = flexible_aircraft::flight::Settings::of(&model);
    let mut flight = flexible_aircraft::flight::Simulation::new(model, &settings, 0.0).unwrap();
    let start = flight.outputs().attitude;
    flight.advance_to(1.0).unwrap();
    let now = flight.outputs();
    // It glides as it was trimmed: to 1.2e-5 rad/s and 5e-6 rad.
    assert!(
        now.rate.norm() < 1.2e-4 && (now.attitude - start).norm() < 5e-5,
        "{} {}",
        now.rate,
        now.attitude - start
    );
}

#[test]
fn panels_that_no_spline_names_are_carried_by_the_beam_beside_them_and_say_so() {
    let found = imported(&wing_text());
    let note = "CAERO1 3001, CAERO1 4001: no spline names them, each is carried by the beam beside it";
    assert!(found.remarks.notes.iter().any(|said| said == note), "{:?}", found.remarks.notes);
}

#[test]
fn a_panel_beyond_its_beam_widens_the_last_strip_or_is_left_out_with_a_report() {
    let wider = wing_text()
        .replace("-.28,6.,0.,1.\n", "-.28,6.3,0.,1.\n")
        .replace("-.28,-6.,0.,1.", "-.28,-6.3,0.,1.");
    let found = imported(&wider);
    assert_eq!(reports(&found), [""; 0]);
    let area: f64 = found.aircraft.strips.iter().map(|strip| 2.0 * strip.semichord * strip.width).sum();
    assert!((area - 2.4 - 15.75).abs() < 1e-7, "{area}");
    let far = wing_text().replace("-.28,6.,0.,1.\n", "-.28,9.,0.,1.\n");
    let told = reports(&imported(&far)).join("\n");
    assert!(told.contains("CAERO1 1001: 3.2500 m² of it, from 0.6667 to 1.0000 of its span, are beside no beam and are left out"), "{told}");
}

#[test]
fn elevators_of_one_side_each_are_joined_for_the_trim() {
    let text =
        wing_text().replace("AESURF,2,ELEV,41,31,41,32\n", "AESURF,2,ELEVR,41,31\nAESURF,3,ELEVL,41,32\n");
    let found = imported(&text);
    let names: Vec<&str> = found.aircraft.controls.iter().map(|control| control.name.as_str()).collect();
    assert_eq!(names, ["ail", "elevr", "elevl", "both_elevators"]);
    assert!(
        found.remarks.notes.iter().any(|note| note.starts_with("ELEVR and ELEVL are images of each other"))
    );
    assert!(found.text().contains("side = \"left\"\n"), "{}", found.text());
    assert!(found.aircraft.reduce().is_ok());
}

#[test]
fn ailerons_of_one_side_each_are_joined_against_each_other() {
    let text = wing_text()
        .replace("AESURF,1,AIL,21,11,22,12\n", "AESURF,1,AILR,21,11,,,,,,,-.3,.2\nAESURF,3,AILL,21,12\n");
    let found = imported(&text);
    let names: Vec<&str> = found.aircraft.controls.iter().map(|control| control.name.as_str()).collect();
    assert_eq!(names, ["ailr", "aill", "elev", "both_ailerons"]);
    let note = "AILR and AILL are images of each other: both_ailerons moves one against the other, so that a trim has a control for roll";
    assert!(found.remarks.notes.iter().any(|said| said == note), "{:?}", found.remarks.notes);
    let written =
        found.text().split("name = \"both_ailerons\"").nth(1).unwrap().split("\n\n").next().unwrap();
    assert!(
        written.contains("positive = \"trailing edge down on the right, up on the left\"\nmirror = \"opposite\"\ntrim = \"roll\"\n"),
        "{written}"
    );
    let flaps = found.aircraft.strips.iter().filter_map(|strip| strip.flap.as_ref());
    let ailerons: Vec<&Vec<f64>> = flaps.map(|flap| &flap.gains).filter(|gains| gains[2] == 0.0).collect();
    assert!(ailerons.len() >= 2, "{ailerons:?}");
    for gains in ailerons {
        assert!(gains[3] != 0.0 && gains[3] == gains[0] - gains[1], "{gains:?}");
    }
    assert!(found.aircraft.reduce().is_ok());
}

#[test]
fn a_linked_control_is_turned_by_the_others_and_is_no_input() {
    let apart = wing_text()
        .replace("AESURF,1,AIL,21,11,22,12\n", "AESURF,1,AILR,21,11\nAESURF,3,AILL,21,12,,,,,,,-.2,.1\n");
    // Against each other, as Nastran writes it: AILL + 1 AILR = 0, and half of it.
    let found = imported(&(apart.clone() + "AELINK,ALWAYS,AILL,AILR,1.\n"));
    let whole = imported(&wing_text());
    assert_eq!(reports(&found), [""; 0]);
    let note = "AILL is no input: it turns by -1 × AILR (AELINK 0)";
    assert!(found.remarks.notes.iter().any(|said| said == note), "{:?}", found.remarks.notes);
    assert_eq!(found.aircraft.strips, whole.aircraft.strips);
    let names: Vec<&str> = found.aircraft.controls.iter().map(|control| control.name.as_str()).collect();
    assert_eq!(names, ["ailr", "elev"]);
    assert!(found.text().contains("minimum_deg = -5.7295779513"), "{}", found.text());
    let half = imported(&(apart.clone() + "AELINK,1,AILL,AILR,.5\nAELINK,2,AILL,AILR,.5\n"));
    let gains = |found: &Imported| -> Vec<f64> {
        found.aircraft.strips.iter().filter_map(|strip| Some(strip.flap.as_ref()?.gains[0])).collect()
    };
    assert_eq!(reports(&half), [""; 0]);
    assert!(gains(&half).contains(&1.0) && gains(&half).contains(&-0.5), "{:?}", gains(&half));
    for (link, said) in [
        ("AELINK,1,AILL,AILR,1.\nAELINK,2,AILL,AILR,-1.\n", "AELINK 2: AILL is linked otherwise"),
        ("AELINK,1,AILL,ANGLEA,1.\n", "AELINK 1: AILL: not every LABL"),
        ("AELINK,1,FLAP,AILR,1.\n", "AELINK 1: FLAP is no AESURF"),
        ("AELINK,1,AILL,AILR,1.,ELEV,1.\n", "AELINK 1: the limits of AILL are not held"),
    ] {
        let told = reports(&imported(&(apart.clone() + link))).join("\n");
        assert!(told.contains(said), "{link}: {told}");
    }
    let told = of_text(&wrapped(&(apart + "AELINK,1,AILL,AILR\n"))).unwrap_err().to_string();
    assert!(told.contains("AELINK 1, field 5 (C1): found nothing"), "{told}");
}

/// As BAH's tail and the foreplane of a forward-swept wing in Nastran's own examples.
#[test]
fn a_panel_on_a_rigid_body_gets_a_rigid_beam_of_its_own() {
    let whole = imported(&wing_text());
    let (mut text, mut stiff) = (wing_text(), wing_text() + "PBAR,9,1,10.,10.,10.,10.\n");
    for base in [300, 400] {
        let bar = format!("CBAR,{base},1,2,{base},0.,0.,1.\n");
        stiff = stiff.replace(&bar, &bar.replace(",1,2,", ",9,2,"));
        let panel = 10 * base + 1;
        text = text.replace(&bar, &format!("RBE2,{base},2,123456,{base}\n"));
        text += &format!("SET1,{base},{base}\nSPLINE1,{base},{panel},{panel},{},{base}\n", panel + 11);
    }
    let found = imported(&text);
    assert_eq!(reports(&found), [""; 0]);
    let note = "CAERO1 3001: no beam runs along it: a rigid one carries it, from the node at x -5.0000, y 0.0000, z 0.0000 m in body axes";
    assert!(found.remarks.notes.iter().any(|said| said == note), "{:?}", found.remarks.notes);
    assert!(found.text().contains("# no beam of the deck: CAERO1 3001 (deck.bdf:"), "{}", found.text());
    assert!(found.text().contains("name = \"tail_right\"\nmirror = \"tail_left\"\n"), "{}", found.text());
    // Without splines too, and neither half hangs on the other.
    let without = text.split("SET1,300").next().unwrap().to_owned();
    assert_eq!(imported(&without).aircraft.strips, found.aircraft.strips);
    // Strips where they were, moved by the node alone.
    assert_eq!(found.aircraft.strips.len(), whole.aircraft.strips.len() + 2 * (3 - 1));
    let area: f64 = found.aircraft.strips.iter().map(|strip| 2.0 * strip.semichord * strip.width).sum();
    assert!((area - 17.4).abs() < 1e-9, "{area}");
    // It is trimmed as with beams that are 10⁵ times as stiff as the others: to 2e-13 rad, where those of the deck have 4e-10.
    let attitude = |found: &Imported| {
        let model = std::sync::Arc::new(found.aircraft.reduce().unwrap());
        let settings = flexible_aircraft::flight::Settings::of(&model);
        flexible_aircraft::flight::Simulation::new(model, &settings, 0.0).unwrap().outputs().attitude
    };
    let [on_stick, on_stiff, on_soft] = [&found, &imported(&stiff), &whole].map(attitude);
    assert!((on_stick - on_stiff).norm() < 2e-12 && (on_stick - on_soft).norm() > 1e-10);
}

#[test]
fn surfaces_of_the_command_line_stand_in_for_panels() {
    let text = wing_text();
    let structure: String = text.split("PAERO1").next().unwrap().to_owned();
    let structure = wrapped(&structure);
    let source = OneText(&structure);
    let lines: Vec<SurfaceLine> = [
        "1:106,chord=1.5:1,axis=0.25",
        "1:206,chord=1.5:1,axis=0.25",
        "2:300,chord=0.8,axis=0.375,control=elevator,hinge=0.7",
        "2:400,chord=0.8,axis=0.375,control=elevator,hinge=0.7",
    ]
    .map(|line| line.parse().unwrap())
    .into();
    let found = import(&Request { surfaces: &lines, ..Request::of_text(&source) }).unwrap();
    assert_eq!(reports(&found), [""; 0]);
    let area: f64 = found.aircraft.strips.iter().map(|strip| 2.0 * strip.semichord * strip.width).sum();
    assert!((area - 17.4).abs() < 1e-9, "{area}");
    assert_eq!(found.aircraft.controls[0].name, "elevator");
    for strip in &found.aircraft.strips {
        // Of fractions of 0.25 and 0.375 behind the leading edge.
        let is_wing = found.aircraft.beams[strip.attachment.beam].component.starts_with("wing");
        let expected = if is_wing { -0.25 } else { -0.125 };
        let axis = strip.elastic_axis_aft_of_midchord / (2.0 * strip.semichord);
        assert!((axis - expected).abs() < 1e-9, "{axis}");
    }
    let bare = imported(&structure);
    assert!(reports(&bare)[0].starts_with("nothing holds it in pitch"), "{:?}", reports(&bare));
}

#[test]
fn boxes_without_splines_second_cards_and_supports_are_told() {
    let whole = wing_text();
    assert!(imported(&whole).remarks.notes.iter().all(|note| !note.contains("no spline moves")));
    let half = whole.replace("SPLINE1,1,1001,1001,1024,1", "SPLINE1,1,1001,1001,1012,1");
    assert_ne!(half, whole);
    let notes = imported(&half).remarks.notes;
    assert!(
        notes.iter().any(|note| note.starts_with("CAERO1 1001: no spline moves 12 of its 24 boxes")),
        "{notes:?}"
    );
    let by_list =
        whole.replace("SPLINE1,1,1001,1001,1024,1", "SPLINE5,1,1001,91,,1\nAELIST,91,1001,THRU,1020");
    let notes = imported(&by_list).remarks.notes;
    assert!(
        notes.iter().any(|note| note.starts_with("CAERO1 1001: no spline moves 4 of its 24 boxes")),
        "{notes:?}"
    );
    let notes = imported(&(whole.clone() + "SUPORT,1,123456\nSUPORT,2,35\n")).remarks.notes;
    assert!(notes.contains(&"SUPORT: GRID 2 is supported too; of all, GRID 1 is O".to_owned()), "{notes:?}");
    let both = "SOL 103\nCEND\nSUBCASE 1\nSPC = 1\nSUBCASE 2\nSPC = 2\nBEGIN BULK\n".to_owned() + &whole;
    let notes = imported(&(both + "SPC1,1,123,1\nSPC1,2,456,1\n")).remarks.notes;
    assert!(notes.contains(&"SPC = 1 and 2 of several subcases hold together here".to_owned()), "{notes:?}");
    let text = of_text(&wrapped(&(whole + "AEROS,,,1.25,12.,15.\n"))).unwrap_err().to_string();
    assert!(text.contains("found a second AEROS; one is allowed"), "{text}");
}
