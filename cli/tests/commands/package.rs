//! What `flexair package` says.

use std::io::Read;
use std::path::Path;

use crate::support::{flexair, library, names, run, text, workspace};

/// Before it finds that there is no such library.
#[test]
fn the_level_at_which_the_file_flies_is_said_beside_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let shipped = std::fs::read_to_string(workspace("tests/data/small-aircraft.toml")).unwrap();
    let own = "model = \"exact\"\n";
    assert!(shipped.contains(own));
    let platform = library().split('=').next().unwrap().to_owned();
    let package = format!("package --aircraft small.toml --modes 2 --binary {platform}=none --output a.fmu");
    let inconsistent = "model = \"inconsistent\"\n";
    for (written, set, level) in [
        (own, "", "exact"),
        (inconsistent, "", "inconsistent"),
        ("", "", "geometrically_exact"),
        (own, "--set model=rigid", "rigid"),
    ] {
        std::fs::write(folder.path().join("small.toml"), shipped.replace(own, written)).unwrap();
        let said = text(&run(folder.path(), &format!("{package} {set}")).stderr);
        let expected = format!("Packaging Small aircraft (small.toml), which flies with model = {level}\n");
        assert!(said.starts_with(&expected), "{said}");
    }
}

/// No cargo is found that could build it.
#[test]
fn options_are_checked_before_the_library_is_built() {
    let folder = tempfile::tempdir().unwrap();
    for (options, reason) in [
        ("--set gust.shap=none", "--set gust.shap=none: there is no parameter `gust.shap`"),
        ("--set elevator=1", "--set elevator=1: `elevator` is an input and no parameter"),
        ("--stations-along wing=20", "stations along wing: found component \"wing\", allowed are "),
        (
            "--stations-along wing_right=20 --stations-along wing_right=20",
            "stations along wing_right: found the name \"wing_right_01\" of a station that there is",
        ),
        ("", "cannot build the shared library: cargo does not start"),
    ] {
        let mut package = flexair(folder.path(), &format!("package --modes 2 {options} --output a.fmu"));
        let said = text(&package.env("CARGO", "no-cargo").output().unwrap().stderr);
        assert!(said.contains(reason), "{options}: {said}");
        assert_eq!(said.contains("Building the shared library"), options.is_empty(), "{options}: {said}");
    }
}

/// The libraries are there, and nothing is flown.
fn quickly(options: &str) -> String {
    format!("package --no-check --modes 2 --binary {} {options}", library())
}

#[test]
fn all_pairs_of_versions_and_kinds_are_written_into_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    let all = "--fmi 2 --fmi 3 --kind co-simulation --kind model-exchange --output fmus";
    let packaged = run(folder.path(), &quickly(all));
    assert!(packaged.status.success(), "{}", text(&packaged.stderr));
    assert_eq!(names(folder.path()), ["fmus"]);
    let written = [
        "FlexibleAircraft.fmi3.fmu",
        "FlexibleAircraft.fmi3.me.fmu",
        "FlexibleAircraft.fmu",
        "FlexibleAircraft.me.fmu",
    ];
    assert_eq!(names(&folder.path().join("fmus")), written);
    assert_eq!(text(&packaged.stdout).lines().count(), 4);
    // The same bytes as one by one, into a file.
    let alone = run(folder.path(), &quickly("--fmi 3 --kind model-exchange --output alone.fmu"));
    assert!(alone.status.success(), "{}", text(&alone.stderr));
    let bytes = |path: &str| std::fs::read(folder.path().join(path)).unwrap();
    assert!(bytes("alone.fmu") == bytes("fmus/FlexibleAircraft.fmi3.me.fmu"));
}

/// A file of the documentation of an FMU, if it has it.
fn documentation(fmu: &Path, file: &str) -> Option<String> {
    let mut archive = zip::ZipArchive::new(std::fs::File::open(fmu).unwrap()).unwrap();
    let mut page = String::new();
    archive.by_name(&format!("documentation/{file}")).ok()?.read_to_string(&mut page).unwrap();
    Some(page)
}

#[test]
fn the_documentation_shows_the_aircraft_in_its_trim_and_its_modes_unless_it_should_not() {
    let folder = tempfile::tempdir().unwrap();
    let write = |options: &str| {
        let packaged = run(folder.path(), &quickly(&format!("{options} --output a.fmu")));
        assert!(packaged.status.success(), "{}", text(&packaged.stderr));
        let size = std::fs::metadata(folder.path().join("a.fmu")).unwrap().len();
        let page = |file| documentation(&folder.path().join("a.fmu"), file);
        (page("index.html").unwrap(), page("scene.html"), size, text(&packaged.stderr))
    };
    let (index, scene, with_scene, _) = write("");
    let scene = scene.unwrap();
    assert!(index.contains("<iframe src=\"scene.html\""));
    assert_eq!(scene.matches("\"kind\":\"trim\"").count(), 1);
    assert_eq!(scene.matches("\"kind\":\"mode\"").count(), 2);
    let (index, scene, without_scene, _) = write("--no-scene");
    assert!(!index.contains("scene.html") && scene.is_none());
    // Measured: 0.21 MB for the small scene of two modes.
    assert!((1..1_200_000).contains(&(with_scene - without_scene)), "{with_scene} {without_scene}");
    // Slower than it can fly.
    let (_, scene, _, said) = write("--set airspeed=30");
    assert!(said.contains("The documentation shows no trim, for there is none: "), "{said}");
    let scene = scene.unwrap();
    assert!(!scene.contains("\"kind\":\"trim\"") && scene.contains("\"kind\":\"mode\""));
}

#[test]
fn names_stay_text_in_the_documentation() {
    let folder = tempfile::tempdir().unwrap();
    let shipped = std::fs::read_to_string(workspace("tests/data/small-aircraft.toml")).unwrap();
    let odd = shipped.replacen("Small aircraft", "</script><img src=x onerror=alert(1)>", 1);
    std::fs::write(folder.path().join("odd.toml"), odd).unwrap();
    let packaged = run(folder.path(), &quickly("--aircraft odd.toml --output a.fmu"));
    assert!(packaged.status.success(), "{}", text(&packaged.stderr));
    for file in ["index.html", "scene.html"] {
        let page = documentation(&folder.path().join("a.fmu"), file).unwrap();
        assert!(!page.contains("<img") && page.contains("onerror=alert(1)"), "{file}");
    }
}

#[test]
fn all_archives_are_written_or_none() {
    let folder = tempfile::tempdir().unwrap();
    let both = "--kind co-simulation --kind model-exchange";
    for (options, reason) in [
        (
            "--fmi 2,3 --kind model-exchange --output all.fmu",
            "error: --output FILE takes one archive; 2 were asked for",
        ),
        (
            &*format!("{both} --set tolerance=1e-4 --output new"),
            "error: --set tolerance=1e-4: `tolerance` belongs to co-simulation: ",
        ),
        (
            &*format!("{both} --set sensor.enabled=true --output new"),
            "error: model exchange: sensor.enabled: found true, ",
        ),
        ("--fmi 1 --output a.fmu", "error: invalid value '1' for '--fmi <VERSION>'"),
    ] {
        let refused = run(folder.path(), &quickly(options));
        let said = text(&refused.stderr);
        assert!(!refused.status.success() && said.starts_with(reason), "{said}");
        assert_eq!(names(folder.path()), [""; 0], "{options}");
    }
}

#[test]
fn an_fmu_for_model_exchange_flies_its_first_second() {
    let folder = tempfile::tempdir().unwrap();
    let package = format!("package --modes 2 --kind model-exchange --binary {} --output a.fmu", library());
    let packaged = run(folder.path(), &package);
    let (said, noted) = (text(&packaged.stdout), text(&packaged.stderr));
    assert!(packaged.status.success(), "{noted}");
    assert!(noted.contains("Flying it as FMI 2.0 model exchange for 1 s"), "{noted}");
    assert!(said.contains("by Runge-Kutta steps of 1 ms"), "{said}");
    // The benchmark flies the other kind.
    let bench = text(&run(folder.path(), "bench --fmu a.fmu").stderr);
    let expected = "error: a.fmu: found an FMU of FMI 2.0 model exchange, needed is one of FMI 2.0 co-simulation; `flexair package`";
    assert!(bench.starts_with(expected), "{bench}");
    // Two of a kind are merged, two kinds are not.
    let usual = run(folder.path(), &quickly("--output b.fmu"));
    assert!(usual.status.success(), "{}", text(&usual.stderr));
    let merged = text(&run(folder.path(), "merge a.fmu b.fmu --output c.fmu").stderr);
    assert_eq!(
        merged,
        "error: a.fmu is FMI 2.0 model exchange, b.fmu is FMI 2.0 co-simulation: nothing to merge\n"
    );
    // Both are components.
    let system = "ssp b.fmu --component other=a.fmu --connect aircraft.rate.y=other.elevator --output s.ssp";
    let refused = text(&run(folder.path(), system).stderr);
    assert!(refused.contains("the output is in rad/s, the input in rad"), "{refused}");
}
