//! `flexair import`: decks of several files, what the command ends with, and that what it writes flies.

use std::path::Path;

use crate::support::{names, run, text, workspace};

/// A clamped stick of one element.
pub const STICK: &str = "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,.01,1.-4,4.-4,1.-4\nGRID,1,,0.,0.,0.\nGRID,2,,0.,3.,0.\nCBAR,1,1,1,2,0.,0.,1.\nSPC1,1,123456,1\n";

fn write(folder: &Path, name: &str, content: &str) {
    std::fs::write(folder.join(name), content).unwrap();
}

/// Code, standard output and standard error of a line.
fn ended(folder: &Path, line: &str) -> (Option<i32>, String, String) {
    let found = run(folder, line);
    (found.status.code(), text(&found.stdout), text(&found.stderr))
}

#[test]
fn a_deck_ends_clean_with_reports_or_without_output() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write(folder, "clean.bdf", STICK);
    write(folder, "reports.bdf", &format!("{STICK}CELAS2,9,1.,2,1\n"));
    write(folder, "wrong.bdf", &STICK.replace("CBAR,1,1,1,2", "CBAR,1,1,1,3"));
    let (code, output, errors) = ended(folder, "import nastran clean.bdf");
    assert_eq!((code, errors.as_str()), (Some(0), ""), "{output}");
    assert!(
        output.starts_with("clean.toml: written from clean.bdf\n")
            && output.contains("nothing of the aircraft is left out"),
        "{output}"
    );
    assert!(
        output.contains("natural modes of the structure held at O")
            && output.contains("mass 81 kg, centre of mass"),
        "{output}"
    );
    let (code, output, _) = ended(folder, "import nastran reports.bdf --output other.toml");
    assert_eq!(code, Some(2));
    assert!(output.contains("\n1 report of what is not held as the deck has it:\n  reports.bdf:7: CELAS2 9: this card is not read"), "{output}");
    let (code, output, errors) = ended(folder, "import nastran wrong.bdf");
    assert_eq!((code, output.as_str()), (Some(1), ""));
    assert!(
        errors.contains("CBAR 1 (GA, GB): found 3") && errors.contains(" --> wrong.bdf:5:1\n"),
        "{errors}"
    );
    assert!(
        errors.contains("5 | CBAR,1,1,1,3,0.,0.,1.\n") && errors.contains("^ a GRID of the deck is needed"),
        "{errors}"
    );
    assert_eq!(names(folder), ["clean.bdf", "clean.toml", "other.toml", "reports.bdf", "wrong.bdf"]);
}

#[test]
fn a_wrong_option_ends_with_1_for_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write(folder, "clean.bdf", &STICK.replace("2700.", ""));
    for (options, said) in [
        ("--surface 1:3,chord=-1", "chord"),
        ("--altitude 40000", "--altitude: found 40000, allowed is -1000 to 30000 m"),
        ("--airspeed 500", "--airspeed: found 500, allowed is 1 to 400 m/s"),
        ("--no-such-option", "--no-such-option"),
    ] {
        let (code, output, errors) = ended(folder, &format!("import nastran clean.bdf {options}"));
        assert_eq!((code, output.as_str()), (Some(1), ""), "{options}");
        assert!(errors.contains(said), "{errors}");
    }
    assert_eq!(names(folder), ["clean.bdf"]);
    // Masses of elements alone, and where there are none.
    write(folder, "clean.bdf", STICK);
    let (_, output, _) = ended(folder, "import nastran clean.bdf");
    assert!(output.contains("mass: 0 kg of CONM1 and CONM2 and 81 kg of elements"), "{output}");
}

#[test]
fn several_beams_on_one_sprung_root_are_nothing_unusual() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let beams = "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,.01,1.-5,1.-4,2.-5\nGRID,1,,0.,0.,0.\nGRID,2,,0.,5.,0.\nGRID,3,,0.,-5.,0.\n\
                 CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,1,3,0.,0.,1.\nCBUSH,9,9,1\nPBUSH,9,K,RIGID,RIGID,RIGID,1.+6,2.+6,3.+6\n";
    write(folder, "sprung.bdf", beams);
    let (code, output, errors) = ended(folder, "import nastran sprung.bdf");
    assert_eq!(code, Some(0), "{output}{errors}");
    assert!(!output.contains("[[joint]]") && !errors.contains("[[joint]]"), "{output}{errors}");
}

#[test]
fn a_file_that_exists_stays_unless_it_is_forced_and_the_deck_always() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write(folder, "deck.bdf", "INCLUDE 'part.bdf'\n");
    write(folder, "part.bdf", STICK);
    write(folder, "deck.toml", "mine");
    let (code, _, errors) = ended(folder, "import nastran deck.bdf");
    assert_eq!(code, Some(1));
    assert!(
        errors.contains("deck.toml exists and stays as it is; allowed is another file, or --force"),
        "{errors}"
    );
    for deck in ["deck.bdf", "part.bdf"] {
        let (code, _, errors) = ended(folder, &format!("import nastran deck.bdf --force --output {deck}"));
        assert_eq!(code, Some(1));
        assert!(errors.contains("which would be lost"), "{errors}");
    }
    assert_eq!(std::fs::read_to_string(folder.join("deck.toml")).unwrap(), "mine");
    let (code, ..) = ended(folder, "import nastran deck.bdf --force");
    assert_eq!(code, Some(0));
    let (code, output, errors) = ended(folder, "import nastran deck.bdf --output -");
    assert_eq!(code, Some(0));
    assert_eq!(output, std::fs::read_to_string(folder.join("deck.toml")).unwrap());
    assert!(errors.starts_with("standard output: written from deck.bdf"), "{errors}");
}

#[test]
fn includes_lead_to_files_alone_and_not_back() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::create_dir(folder.join("parts")).unwrap();
    write(folder, "folder.bdf", "INCLUDE 'parts'\n");
    write(folder, "circle.bdf", "INCLUDE 'parts/back.bdf'\n");
    write(&folder.join("parts"), "back.bdf", "$\nINCLUDE '../parts/../circle.bdf'\n");
    let (code, _, errors) = ended(folder, "import nastran folder.bdf");
    assert!(
        code == Some(1) && errors.contains("found parts, which cannot be read: it is no file"),
        "{errors}"
    );
    let (code, _, errors) = ended(folder, "import nastran circle.bdf");
    assert!(
        code == Some(1) && errors.contains("which leads here") && errors.contains("back.bdf:2:1"),
        "{errors}"
    );
    let (code, _, errors) = ended(folder, "import nastran gone.bdf");
    assert!(code == Some(1) && errors.contains("error: found gone.bdf, which cannot be read"), "{errors}");
}

#[test]
fn the_example_trims_with_propellers_and_without_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let deck = workspace("examples/nastran/transport.bdf").canonicalize().unwrap();
    let line = format!("import nastran {} --engine right=251 --engine left=351", deck.display());
    let (code, output, errors) = ended(folder, &line);
    assert_eq!((code, errors.as_str()), (Some(2), ""), "{output}");
    assert!(output.contains("\n3 reports of what is not held as the deck has it:\n"), "{output}");
    assert!(!output.contains("warning"), "{output}");
    let written = std::fs::read_to_string(folder.join("transport.toml")).unwrap();
    assert!(
        written.contains("\nsymmetric = true\n")
            && written.contains("\nname = \"wing_right\"\nmirror = \"wing_left\"\n")
    );
    for assumed in
        ["lift_slope_per_rad = 6.28318530718 ", "profile_drag = 0.01 ", "leading_edge_suction = 1 "]
    {
        let lines: Vec<&str> = written.lines().filter(|line| line.starts_with(assumed)).collect();
        assert!(
            lines.len() >= 3 && lines.iter().all(|line| line.contains("# assumed")),
            "{assumed}: {lines:?}"
        );
    }
    let (code, output, errors) = ended(folder, "trim transport.toml");
    assert_eq!((code, errors.as_str()), (Some(0), ""), "{output}");
    let (code, flight, errors) = ended(
        folder,
        "simulate --aircraft transport.toml --modes 6 --step 0.05 --input elev=doublet:0.01@0.2:0.4 --duration 2",
    );
    assert!(code == Some(0) && flight.lines().count() == 42, "{errors}");
}

/// Beams that form loops are read, checked and flown.
#[test]
fn a_braced_wing_is_written_with_joints_and_swings_in_a_tunnel() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let deck = workspace("examples/nastran/braced.bdf").canonicalize().unwrap();
    let (code, output, errors) = ended(folder, &format!("import nastran {}", deck.display()));
    assert_eq!((code, errors.as_str()), (Some(0), ""), "{output}");
    assert!(
        output.contains(
            "note: 2 loops are closed, by CBAR 134 at GRID 107, CBAR 234 at GRID 207: a [[joint]] at each"
        ),
        "{output}"
    );
    let written = std::fs::read_to_string(folder.join("braced.toml")).unwrap();
    assert!(
        written.contains("\nmodel = \"exact\"\n")
            && written.contains("\n[[joint]]")
            && !written.contains("\n[[cut]]"),
        "{written}"
    );
    let (code, output, errors) = ended(folder, "check braced.toml");
    assert_ne!(code, Some(1), "{output}{errors}");
    let (code, flight, errors) = ended(
        folder,
        "simulate --aircraft braced.toml --modes 6 --step 0.02 --input aileron=doublet:0.05@0.1:0.2 --duration 1",
    );
    assert!(code == Some(0) && flight.lines().count() == 52, "{errors}");
}
