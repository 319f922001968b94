//! What decks say in the places and ways that are legal and seldom: what becomes of it.

use super::*;

/// Two beams from O, free: a stick that is held by nothing.
const FREE: &str = "MAT1,1,7.+10,,.33,2700.\nPBAR,1,1,.01,1.-4,4.-4,1.-4\nGRID,1,,0.,0.,0.\nGRID,2,,0.,3.,0.\nGRID,3,,0.,-3.,0.\n\
                    CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,1,3,0.,0.,1.\nCONM2,1,1,,500.\n";

/// What is wrong with a deck.
#[track_caller]
fn refused(text: &str) -> String {
    of_text(&wrapped(text)).map(|found| found.text().to_owned()).unwrap_err().to_string()
}

/// The mass of an aircraft, kg.
fn mass(found: &Imported) -> f64 {
    found.aircraft.bays.iter().map(|bay| bay.mass).sum()
}

#[test]
fn factors_of_masses_count_before_the_bulk_data_too() {
    let found = imported(&format!("SOL 144\nCEND\nPARAM,WTMASS,.5\nBEGIN BULK\n{FREE}"));
    assert!((mass(&found) - 0.5 * (500.0 + 162.0)).abs() < 1e-9, "{}", mass(&found));
    // One of the case control counts before one of the bulk data.
    let found = imported(&format!("CEND\nPARAM,WTMASS,.5\nBEGIN BULK\nPARAM,WTMASS,.25\n{FREE}"));
    assert!((mass(&found) - 0.5 * (500.0 + 162.0)).abs() < 1e-9, "{}", mass(&found));
    let notes = found.remarks.notes;
    assert!(
        notes.iter().any(|note| note.starts_with("PARAM WTMASS = 0.25: it does not count, 0.5 does")),
        "{notes:?}"
    );
}

#[test]
fn constraints_hold_that_the_case_control_asks_for() {
    let clamp = "SPC1,7,123456,2\nSPC1,8,123456,1\n";
    let held = |control: &str| {
        let found = imported(&format!("{control}{FREE}{clamp}"));
        (found.taken.iter().find(|line| line.starts_with("O: ")).unwrap().clone(), found.remarks.notes)
    };
    let (held_at, notes) = held("SOL 144\nCEND\nBEGIN BULK\n");
    assert!(held_at.contains("nearest to the centre of mass"), "{held_at}");
    assert!(
        notes.contains(&"SPC1 7: no SPC = 7 of the case control asks for it: it holds nothing".to_owned()),
        "{notes:?}"
    );
    assert_eq!(held("SOL 144\nCEND\nSPC = 8\nBEGIN BULK\n").0, "O: GRID 1, which SPC1 8 clamps");
    let (held_at, notes) = held("SUBCASE 1\nSPC = 8\nSUBCASE 2\nSPC = 7\nBEGIN BULK\n");
    assert_eq!(held_at, "O: GRID 1, which SPC1 8 clamps");
    assert!(notes.iter().any(|note| note.starts_with("SPC = 7 and 8 of several subcases")), "{notes:?}");
    // A deck of bulk data alone asks for none, and means all.
    assert_eq!(held("BEGIN BULK\n").0, "O: GRID 1, which SPC1 8 clamps");
}

#[test]
fn lists_name_grids_that_are_there() {
    let told = refused(&format!("{FREE}SPC1,7,123456,11\nSPC,7,12,123456\n"));
    assert!(told.contains("deck.bdf:9:1: SPC1 7 (G): found 11; a GRID of the deck is needed"), "{told}");
    assert!(told.contains("deck.bdf:10:1: SPC 7 (G): found 12; a GRID of the deck is needed"), "{told}");
    let told = refused(&panels::wing_text().replace("SET1,1,1,101,THRU,106", "SET1,1,1,33,101,THRU,150"));
    assert!(
        told.contains("SET1 1 (G): found 33; a GRID of the deck is needed") && !told.contains("150"),
        "{told}"
    );
}

#[test]
fn limits_of_control_surfaces_are_held_as_nastran_has_them() {
    let limits = |fields: &str| {
        let text = panels::wing_text().replace("41,31,41,32\n", &format!("41,31,41,32,,{fields}\n"));
        let found = imported(&text);
        let controls = found.text().split("name = \"elev\"").nth(1).unwrap().to_owned();
        let limit = |name: &str| {
            let line = controls
                .split("[[")
                .next()
                .unwrap()
                .lines()
                .find(|line| line.starts_with(name))
                .map(str::to_owned);
            line.map(|line| line.split(" = ").nth(1).unwrap().parse::<f64>().unwrap())
        };
        let told = (reports(&found), found.remarks.notes.join("\n"));
        ([limit("minimum_deg"), limit("maximum_deg")], told)
    };
    assert_eq!(limits("LDW,1.,1.").0, [None, None]);
    let ([low, high], _) = limits("LDW,1.,1.,-.35");
    assert!((low.unwrap() + 0.35_f64.to_degrees()).abs() < 1e-9);
    assert_eq!(high, Some(90.0));
    let (both, (told, notes)) = limits("NOLDW,1.,1.,-1.5708,1.5708");
    assert_eq!(both, [Some(-90.0), Some(90.0)]);
    assert!(
        notes.contains("AESURF 2: its limits, -1.5708 to 1.5708 rad, are held as -90.000 to 90.000 deg"),
        "{notes}"
    );
    assert!(told[0].contains("AESURF 2, field 9 (LDW): found NOLDW"), "{told:?}");
    let told = refused(&panels::wing_text().replace("41,31,41,32\n", "41,31,41,32,,,,,.5,.2\n"));
    assert!(told.contains("AESURF 2, field 4 (PLLIM): found 0.5 to 0.2 rad"), "{told}");
    let ([low, high], (told, _)) = limits("LDW,1.,1.,.2,.5");
    assert_eq!([low, high], [None, None]);
    assert!(told[0].contains("found limits from 0.2 to 0.5 rad, between which 0 is not"), "{told:?}");
    let (_, (told, _)) = limits("LDW,1.,1.,0.,0.");
    assert!(told[0].contains("found limits from 0 to 0 rad, which let it turn nowhere"), "{told:?}");
}

#[test]
fn the_airspeed_of_an_aero_is_that_of_the_trim_where_it_may_fly_at_it() {
    // 762 kg and more on 15 m² of wing: at 60 m/s a lift coefficient near 0.3.
    let airspeed = |velocity: &str| {
        let found = imported(&(panels::wing_text() + &format!("AERO,,{velocity},1.,1.225\n")));
        let notes = found.remarks.notes.join("\n");
        (found.text().lines().find(|line| line.starts_with("airspeed_m_s")).unwrap().to_owned(), notes)
    };
    assert!(
        airspeed("60.").0.starts_with("airspeed_m_s = 60 ")
            && airspeed("60.").0.ends_with("# VELOCITY of AERO")
    );
    for dummy in ["1.", "5.", "340."] {
        let (line, notes) = airspeed(dummy);
        assert!(line.ends_with("# assumed: lift coefficient 0.5"), "{line}");
        assert!(
            notes.contains(&format!("AERO: its VELOCITY, {dummy}").trim_end_matches('.').to_owned()),
            "{notes}"
        );
    }
}

#[test]
fn blanks_of_a_beam_between_its_ends_are_on_the_line_from_end_to_end() {
    let beam = "MAT1,1,7.+10,,.3,1.\nPBEAM,1,1,8.,8.,8.,,8.\n,,,,,,,,\n,NO,.5\n,NO,1.,4.,4.,4.,,4.\n,0.,0.\n\
                GRID,1,,0.,0.,0.\nGRID,2,,0.,10.,0.\nCBEAM,1,1,1,2,0.,0.,1.\nSPC1,1,123456,1\n";
    // 8, 6 and 4 m² along 10 m of 1 kg/m³.
    assert!((mass(&of_text(beam).unwrap()) - 60.0).abs() < 1e-9);
    // Given in the middle: 8, 8, 4.
    let given = beam.replace(",NO,.5\n", ",NO,.5,8.,8.,8.,,8.\n");
    assert!((mass(&of_text(&given).unwrap()) - 70.0).abs() < 1e-9);
    // Blank at end B: that of end A.
    let blank = beam.replace(",NO,1.,4.,4.,4.,,4.\n", ",NO,1.\n");
    assert!((mass(&of_text(&blank).unwrap()) - 80.0).abs() < 1e-9);
    let shaped = "PBEAML,1,1,,BAR\n,2.,4.,0.,NO,.5,,,\n,NO,1.,2.,2.,0.\n";
    let text = format!("MAT1,1,7.+10,,.3,1.\n{shaped}{}", &beam[beam.find("GRID").unwrap()..]);
    // 2 × 4, 2 × 3, 2 × 2.
    assert!((mass(&of_text(&text).unwrap()) - 60.0).abs() < 1e-9);
}

#[test]
fn halves_of_aircraft_and_damping_are_reported_wherever_they_are_said() {
    for card in ["AERO,,60.,1.,1.225,1\n", "AERO,,60.,1.,1.225,-1\n"] {
        let told = reports(&imported(&(panels::wing_text() + card))).join("\n");
        assert!(told.contains("AERO 0: SYMXZ says that half of an aircraft is meant"), "{told}");
    }
    let told = reports(&imported(&panels::wing_text().replace("12.,15.\n", "12.,15.,0,1\n"))).join("\n");
    assert!(told.contains("AEROS 0, field 8 (SYMXY): found 1: an image of the flow in the ground"), "{told}");
    let told = refused(&(panels::wing_text() + "AEROS,,,1.25,12.,15.\n"));
    assert!(told.contains("found a second AEROS; one is allowed"), "{told}");
    let damped = imported(&(FREE.replace("2700.", "2700.,,,.02") + "PARAM,G,.03\n"));
    assert!(
        reports(&damped)[1].contains("MAT1 1, field 9 (GE): found 0.02: damping of materials is not held"),
        "{:?}",
        reports(&damped)
    );
    assert!(
        damped.remarks.notes.iter().any(|note| note.starts_with("PARAM G = .03: damping")),
        "{:?}",
        damped.remarks.notes
    );
}

#[test]
fn fields_that_bars_leave_blank_are_those_of_baror() {
    let whole = FREE.replace("CBAR,2,1,1,3,0.,0.,1.", "CBAR,2,,1,3");
    let told = refused(&whole);
    assert!(told.contains("CBAR 2, field 6 (X1): found no direction"), "{told}");
    let found = imported(&format!("BAROR,,1,,,0.,0.,1.\n{whole}"));
    assert_eq!(found.aircraft, imported(FREE).aircraft);
    // In old decks 1 says that a vector stands before it.
    let old = FREE.replace("CBAR,2,1,1,3,0.,0.,1.", "CBAR,2,1,1,3,0.,0.,1.,1");
    assert_eq!(imported(&old).aircraft, found.aircraft);
    // What is not read may be why another card lacks something.
    let told = refused(&format!("XYZ,1\n{whole}"));
    assert!(told.ends_with("reported beside the mistakes:\ndeck.bdf:1: XYZ 1: this card is not read: what it says is not in the aircraft"), "{told}");
}

#[test]
fn what_the_library_would_not_read_is_refused_by_what_the_deck_lacks() {
    let weightless = FREE.replace(",2700.", "").replace("CONM2,1,1,,500.\n", "");
    assert_eq!(
        refused(&weightless),
        "found a structure of 0.000000 kg; a CONM1 or CONM2 with a mass, a RHO of MAT1 or an NSM above 0 is needed"
    );
    let named =
        |label: &str| imported(&panels::wing_text().replace("AESURF,2,ELEV", &format!("AESURF,2,{label}")));
    let found = named("A\u{1}B\u{7f}");
    assert!(found.text().contains("description = \"AB\"\n"), "{}", found.text());
    assert_eq!(named("temperature_offset").aircraft.controls[1].name, "temperature_offset_2");
    for text in [format!("{FREE}CAERO1,9,1,,1,1,,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\n"), FREE.to_owned()] {
        let twice = text.lines().filter(|line| line.starts_with("CAERO1") || line.starts_with("CBAR"));
        let twice: String = twice.map(|line| format!("{line}\n")).collect();
        assert!(
            refused(&format!("{text}{twice}"))
                .contains("a second time; a number that no other has is allowed")
        );
    }
}
