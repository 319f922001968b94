//! The command where it is installed: a copy of the program with its data folder, without cargo and far from the sources.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use flexible_aircraft::fmi::Interface;
use flexible_aircraft_packaging::{Installation, Licences, Package, Platform};

use crate::support::{library, names, text, workspace};

/// A folder with the program and its data in `bin`, and a working directory `work`.
struct Installed(tempfile::TempDir);

impl Installed {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let bin = folder.path().join("bin");
        std::fs::create_dir(&bin).unwrap();
        std::fs::create_dir(folder.path().join("work")).unwrap();
        let program = Path::new(env!("CARGO_BIN_EXE_flexair"));
        std::fs::copy(program, bin.join(program.file_name().unwrap())).unwrap();
        Installation::write(&bin.join("flexair-data"), &workspace("."), &[host_library()], "flexair")
            .unwrap();
        Installed(folder)
    }

    fn work(&self) -> PathBuf {
        self.0.path().join("work")
    }

    fn data(&self) -> PathBuf {
        self.0.path().join("bin/flexair-data")
    }

    /// Runs it in its working directory, where no other program is found.
    fn run(&self, arguments: &str) -> Output {
        let program =
            self.0.path().join("bin").join(Path::new(env!("CARGO_BIN_EXE_flexair")).file_name().unwrap());
        let mut command = Command::new(program);
        command.current_dir(self.work()).args(arguments.split_whitespace());
        command.env("PATH", self.work()).env_remove("CARGO").output().unwrap()
    }
}

fn host_library() -> (Platform, PathBuf) {
    let library = library();
    let (platform, file) = library.split_once('=').unwrap();
    (platform.parse().unwrap(), file.into())
}

#[test]
fn an_own_aircraft_is_packaged_without_cargo_and_sources_as_with_them() {
    let installed = Installed::new();
    let own = installed.work().join("own.toml");
    std::fs::copy(workspace("aircraft/goland-wing.toml"), &own).unwrap();
    let run = installed.run("package --aircraft own.toml --modes 2 --no-scene");
    assert!(run.status.success(), "{}", text(&run.stderr));
    assert!(text(&run.stdout).starts_with("FlexibleAircraft.fmu: "), "{}", text(&run.stdout));
    let package = Package {
        interface: Interface::USUAL,
        aircraft: own,
        mode_count: 2.into(),
        load_modes: false,
        starts: Vec::new(),
        stations_along: Vec::new(),
        binaries: vec![host_library()],
        licences: Licences::Workspace(workspace(".")),
        scene: None,
    };
    let packaged = std::fs::read(installed.work().join("FlexibleAircraft.fmu")).unwrap();
    assert!(packaged == package.to_bytes().unwrap(), "other bytes than from the workspace");
}

#[test]
fn shipped_aircraft_are_listed_and_found_by_their_names_and_outputs_stay_in_the_working_directory() {
    let installed = Installed::new();
    let listed = text(&installed.run("aircraft").stdout);
    assert!(listed.contains("goland-wing             Goland wing, clamped in a wind tunnel\n"), "{listed}");
    assert!(listed.contains(&installed.data().join("aircraft").display().to_string()), "{listed}");
    let run = installed.run("flutter goland-wing --from 60 --to 70 --points 2 --modes 2");
    assert!(run.status.success(), "{}", text(&run.stderr));
    assert_eq!(names(&installed.work()), ["flexair-out"]);
    let outputs = names(&installed.work().join("flexair-out/flutter"));
    assert!(outputs.contains(&"goland-wing-roots.csv".to_owned()), "{outputs:?}");
    let unknown = text(&installed.run("flutter golan-wing --from 60 --to 70").stderr);
    assert!(
        unknown.contains("no aircraft of this name comes with flexair, did you mean `goland-wing`?"),
        "{unknown}"
    );
}

#[test]
fn what_is_missing_is_named() {
    let installed = Installed::new();
    let bench = text(&installed.run("bench --aircraft generic-business-jet").stderr);
    let looked = installed.work().join("FlexibleAircraft.fmu");
    assert!(bench.starts_with("error: cannot read FlexibleAircraft.fmu: "), "{bench}");
    assert!(
        bench.ends_with(&format!("looked for {}; `flexair package` writes one\n", looked.display())),
        "{bench}"
    );
    let (platform, _) = host_library();
    std::fs::remove_dir_all(installed.data().join("binaries").join(platform.name())).unwrap();
    let package = text(&installed.run("package --modes 2").stderr);
    let looked = installed.data();
    let expected =
        format!("no shared libraries came with this program: looked for them in {}", looked.display());
    assert!(package.contains(&expected), "{package}");
    std::fs::remove_dir_all(installed.data().join("aircraft")).unwrap();
    let aircraft = text(&installed.run("aircraft").stderr);
    assert!(aircraft.starts_with("error: no aircraft come with this program: "), "{aircraft}");
}
