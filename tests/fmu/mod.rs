//! The FMU of the generic business jet, packaged and then used through its C interface.

mod controls;
mod layout;
mod merging;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::fmi::Interface;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft_packaging::c_abi::Fmu;
use flexible_aircraft_packaging::{FmuError, Licences, Package, PackageError, Platform};

use crate::support::{AILERON, ELEVATOR, RUDDER, jet};

const MODE_COUNT: usize = ReducedModel::USUAL_MODES;

fn jet_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml")
}

/// The jet with the shared library that cargo built beside this test.
fn package() -> Package {
    let name = format!("{}flexible_aircraft{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let library = std::env::current_exe().unwrap().with_file_name(name);
    Package {
        interface: Interface::USUAL,
        aircraft: jet_file(),
        mode_count: MODE_COUNT.into(),
        load_modes: false,
        starts: Vec::new(),
        stations_along: Vec::new(),
        binaries: vec![(Platform::host().unwrap(), library)],
        licences: Licences::Workspace(env!("CARGO_MANIFEST_DIR").into()),
        scene: None,
    }
}

/// The FMU, and the folder that keeps it.
fn fmu() -> (Fmu, tempfile::TempDir) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("new folder/FlexibleAircraft.fmu");
    package().write(&path).unwrap();
    (Fmu::open(&path).unwrap(), folder)
}

#[test]
fn packaging_twice_gives_the_same_bytes() {
    assert!(package().to_bytes().unwrap() == package().to_bytes().unwrap());
}

#[test]
fn a_second_library_for_a_platform_is_refused() {
    let mut package = package();
    package.binaries.push(package.binaries[0].clone());
    assert!(matches!(package.to_bytes(), Err(PackageError::TwoBinaries(_))));
    package.binaries.clear();
    assert!(matches!(package.to_bytes(), Err(PackageError::NoBinary)));
}

/// Surfaces, thrust and wind, all moving.
fn inputs_at(time: f64) -> Inputs {
    let mut inputs = Inputs::zero(&jet());
    inputs.controls[ELEVATOR] = -0.03 * (2.0 * time).sin();
    inputs.controls[AILERON] = 0.02 * (1.3 * time).sin();
    inputs.controls[RUDDER] = 0.01 * (0.9 * time).sin();
    inputs.thrust.copy_from_slice(&[1e3 * time.sin(), -1e3 * time.sin()]);
    inputs.wind.z = -2.0 * (1.0 - time.cos());
    inputs
}

#[test]
fn fmu_and_rust_library_give_the_same_bits() {
    let aircraft = Aircraft::read(jet_file()).unwrap();
    let model = Arc::new(ReducedModel::new(&aircraft, MODE_COUNT).unwrap());
    let settings = Settings::of(&model);
    let mut flight = Simulation::new(model, &settings, 0.0).unwrap();

    let (fmu, _folder) = fmu();
    let mut names: Vec<String> = ["elevator", "aileron", "rudder"].map(String::from).to_vec();
    names.extend(aircraft.engines.iter().map(|engine| format!("thrust_{}", engine.name)));
    names.push("wind_down".into());
    let inputs = fmu.variables(&names).unwrap();
    let outputs = ["position.north", "position.east", "position.down", "attitude.pitch", "load_factor.z"];
    let outputs = fmu.variables(&outputs).unwrap();
    let modes: Vec<String> = (1..=MODE_COUNT).map(|mode| format!("modal.q[{mode}]")).collect();
    let modes = fmu.variables(&modes).unwrap();
    let mut instance = fmu.instantiate("same bits").unwrap();
    instance.initialise(0.0, None).unwrap();

    let step = 0.01;
    for index in 0..200 {
        let time = f64::from(index) * step;
        let now = inputs_at(time);
        let mut values = vec![now.controls[ELEVATOR], now.controls[AILERON], now.controls[RUDDER]];
        values.extend(&now.thrust);
        values.push(now.wind.z);
        instance.set_real(&inputs, &values).unwrap();
        instance.do_step(time, step).unwrap();
        flight.set_inputs(&now, &Inputs::zero(&jet()));
        flight.advance_to(time + step).unwrap();

        let (mut of_fmu, mut q_of_fmu) = ([0.0; 5], [0.0; MODE_COUNT]);
        instance.get_real(&outputs, &mut of_fmu).unwrap();
        instance.get_real(&modes, &mut q_of_fmu).unwrap();
        let here = flight.outputs();
        let position = here.position;
        let of_library = [position.x, position.y, position.z, here.attitude.y, here.load_factor.z];
        assert_eq!(of_fmu.map(f64::to_bits), of_library.map(f64::to_bits), "after {} s", time + step);
        let q_of_library: Vec<u64> = here.modal_q.iter().map(|q| q.to_bits()).collect();
        assert_eq!(q_of_fmu.map(f64::to_bits).to_vec(), q_of_library, "after {} s", time + step);
    }
}

#[test]
fn a_refused_call_says_why() {
    let (fmu, _folder) = fmu();
    assert!(matches!(fmu.variable("speed_of_light"), Err(FmuError::UnknownVariable(_))));
    let airspeed = fmu.variable("airspeed").unwrap();
    let mut instance = fmu.instantiate("refused").unwrap();
    let error = instance.set_real(&[airspeed], &[-127.0]).unwrap_err().to_string();
    assert!(error.starts_with("fmi2SetReal returned fmi2Error\n"), "{error}");
    assert!(error.contains("airspeed") && error.contains("-127"), "{error}");
}

#[test]
fn an_fmu_that_is_none_is_refused() {
    let error = Fmu::open(&jet_file()).err().unwrap().to_string();
    assert!(error.starts_with("cannot unpack ") && error.contains("generic-business-jet.toml"), "{error}");
}

#[test]
fn a_file_that_is_no_library_of_its_platform_is_refused() {
    let mut package = package();
    package.binaries.push((Platform::Win64, jet_file()));
    let error = package.to_bytes().unwrap_err().to_string();
    let expected = "generic-business-jet.toml: found a file that is no shared library (Unknown file magic), expected \
                    for win64 is a shared library (PE) for x86_64";
    assert!(error.ends_with(expected), "{error}");
}

#[test]
fn a_draft_replaces_the_old_fmu_only_when_it_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("aircraft.fmu");
    std::fs::write(&output, "the old one").unwrap();
    let files = || std::fs::read_dir(folder.path()).unwrap().count();
    let draft = package().draft(&output).unwrap();
    assert!(Fmu::open(draft.path()).is_ok());
    drop(draft);
    assert_eq!((std::fs::read(&output).unwrap(), files()), (b"the old one".to_vec(), 1));
    package().draft(&output).unwrap().keep().unwrap();
    assert!(Fmu::open(&output).is_ok());
    assert_eq!(files(), 1);
}

/// The package with its library changed, and the folder that keeps that.
fn with_library(change: impl FnOnce(&mut Vec<u8>)) -> (Package, tempfile::TempDir) {
    let mut package = package();
    let folder = tempfile::tempdir().unwrap();
    let changed = folder.path().join("changed.so");
    let mut bytes = std::fs::read(&package.binaries[0].1).unwrap();
    change(&mut bytes);
    std::fs::write(&changed, bytes).unwrap();
    package.binaries[0].1 = changed;
    (package, folder)
}

/// Puts other bytes of the same length wherever `from` stands.
fn replace(bytes: &mut [u8], from: &[u8], to: &[u8]) {
    assert_eq!(from.len(), to.len());
    let places: Vec<_> =
        bytes.windows(from.len()).enumerate().filter(|(_, window)| *window == from).collect();
    let places: Vec<usize> = places.into_iter().map(|(at, _)| at).collect();
    assert!(!places.is_empty(), "{}", String::from_utf8_lossy(from));
    for at in places {
        bytes[at..at + to.len()].copy_from_slice(to);
    }
}

#[test]
fn a_library_that_lacks_a_function_is_refused_by_the_name_of_the_function() {
    let (package, _folder) = with_library(|bytes| replace(bytes, b"\0fmi2DoStep\0", b"\0fmi2DoStop\0"));
    let error = package.to_bytes().unwrap_err().to_string();
    let expected = "changed.so: it exports 43 of the functions of FMI 2.0, and lacks fmi2DoStep";
    assert!(error.ends_with(expected), "{error}");
}

#[test]
fn a_library_of_another_version_or_of_other_sources_is_refused() {
    let (package, _folder) =
        with_library(|bytes| replace(bytes, b"aircraft library 0.", b"aircraft library 9."));
    let error = package.to_bytes().unwrap_err().to_string();
    assert!(error.contains("changed.so: found flexible-aircraft library 9."), "{error}");
    assert!(error.contains(", expected is flexible-aircraft library 0."), "{error}");

    let (package, _folder) = with_library(|bytes| replace(bytes, b" (sources ", b" (bananas "));
    let error = package.to_bytes().unwrap_err().to_string();
    assert!(error.contains("(bananas ") && error.ends_with("build both of the same sources"), "{error}");
}

#[test]
fn a_library_of_another_program_is_refused() {
    let (package, _folder) = with_library(|bytes| replace(bytes, b"aircraft library ", b"spacecraft libr. "));
    let error = package.to_bytes().unwrap_err().to_string();
    assert!(error.contains("it is no library of flexible-aircraft"), "{error}");
}

#[test]
fn a_library_that_is_cut_off_is_refused() {
    let (package, _folder) = with_library(|bytes| bytes.truncate(64));
    let error = package.to_bytes().unwrap_err().to_string();
    assert!(error.contains("changed.so: found a file that is no shared library"), "{error}");
}

#[test]
#[cfg(target_os = "linux")]
fn a_library_that_does_not_load_is_refused_with_the_reason_of_the_loader() {
    let (package, folder) = with_library(|bytes| replace(bytes, b"\0libc.so.6\0", b"\0libz.so.0\0"));
    let fmu = folder.path().join("aircraft.fmu");
    package.write(&fmu).unwrap();
    let error = Fmu::open(&fmu).err().unwrap().to_string();
    assert!(error.starts_with("cannot use the shared library: ") && error.contains("libz.so.0"), "{error}");
}
