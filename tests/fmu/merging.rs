//! FMUs of several platforms out of FMUs of one.
//!
//! The second platform's library is that of this machine with another processor written into its header: the
//! packager reads libraries and does not load them.

use std::io::{Cursor, Read, Write};
use std::path::{Path, PathBuf};

use flexible_aircraft::fmi::Interface;
use flexible_aircraft_packaging::{Package, Platform, merge};
use zip::write::SimpleFileOptions;
use zip::{ZipArchive, ZipWriter};

use super::{package, replace, with_library};

/// The platform of the second library.
const OTHER: Platform = Platform::Aarch64Linux;

/// The package for the other platform, and the folder that keeps its library.
fn other_package() -> (Package, tempfile::TempDir) {
    const MACHINE: usize = 18; // in the ELF header
    let (mut package, folder) = with_library(|bytes| bytes[MACHINE] = 183);
    package.binaries[0].0 = OTHER;
    (package, folder)
}

fn write(package: &Package, path: &Path) -> PathBuf {
    package.write(path).unwrap();
    path.to_owned()
}

/// Changes a file in an archive.
fn rewrite(fmu: &Path, file: &str, change: impl Fn(&mut Vec<u8>)) {
    let mut archive = ZipArchive::new(Cursor::new(std::fs::read(fmu).unwrap())).unwrap();
    let mut rewritten = ZipWriter::new(std::fs::File::create(fmu).unwrap());
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).unwrap();
        let mut content = Vec::new();
        entry.read_to_end(&mut content).unwrap();
        let name = entry.name().unwrap().into_owned();
        if name.ends_with(file) {
            change(&mut content);
        }
        rewritten.start_file(name, SimpleFileOptions::default()).unwrap();
        rewritten.write_all(&content).unwrap();
    }
    rewritten.finish().unwrap();
}

/// FMUs of this machine's platform and of the other one, the second changed; and why they are not merged.
fn refusal(change: impl FnOnce(&Path)) -> String {
    let (other, folder) = other_package();
    let [first, second] = ["first.fmu", "second.fmu"].map(|name| folder.path().join(name));
    write(&package(), &first);
    write(&other, &second);
    change(&second);
    let message = merge(&[first, second]).unwrap_err().to_string();
    message.replace(&format!("{}/", folder.path().display()), "")
}

#[test]
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
fn merging_in_any_order_gives_what_packaging_at_once_gives() {
    let (other, folder) = other_package();
    let one = write(&package(), &folder.path().join("one.fmu"));
    let two = write(&other, &folder.path().join("two.fmu"));
    let mut both = other.clone();
    both.binaries.extend(package().binaries);
    let both = both.to_bytes().unwrap();
    assert!(merge(&[one.clone(), two.clone()]).unwrap() == both);
    assert!(merge(&[two.clone(), one.clone()]).unwrap() == both);
    let merged = folder.path().join("merged.fmu");
    std::fs::write(&merged, &both).unwrap();
    assert!(merge(&[merged, one, two]).unwrap() == both);
}

#[test]
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
fn fmus_that_differ_in_more_than_their_platforms_are_not_merged() {
    let aircraft = |fmu: &Path| {
        let (mut package, _folder) = other_package();
        package.aircraft = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small-aircraft.toml");
        package.mode_count = 4.into();
        package.write(fmu).unwrap();
    };
    let message = refusal(aircraft);
    assert!(message.starts_with("only FMUs of one aircraft, version and guid can be merged: "), "{message}");
    assert!(message.contains("Generic business jet (span 24.86 m) in first.fmu, "), "{message}");

    let xml = |from: &'static str, to: &'static str| {
        move |fmu: &Path| {
            rewrite(fmu, "modelDescription.xml", |xml| replace(xml, from.as_bytes(), to.as_bytes()));
        }
    };
    let message = refusal(xml(" version=\"0.", " version=\"7."));
    assert!(message.contains("the version is 0.") && message.contains("in first.fmu, 7."), "{message}");
    assert!(refusal(xml(" guid=\"{", " guid=\"[")).contains("the guid is {"));

    let message =
        refusal(|fmu| rewrite(fmu, ".so", |library| replace(library, b" (sources ", b" (bananas ")));
    assert!(message.contains("(sources ") && message.contains("(bananas "), "{message}");

    let message = refusal(|fmu| rewrite(fmu, "aircraft.toml", |text| text.push(b'\n')));
    assert_eq!(message, "first.fmu and second.fmu do not have the same resources/aircraft.toml");
}

#[test]
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
fn different_libraries_for_one_platform_are_not_merged() {
    let message = refusal(|fmu| {
        let (longer, _folder) = with_library(|bytes| bytes.push(0));
        longer.write(fmu).unwrap();
    });
    assert_eq!(message, "first.fmu and second.fmu have different libraries for linux64");
}

#[test]
fn a_file_that_is_no_fmu_of_ours_is_not_merged() {
    let message = refusal(|fmu| std::fs::write(fmu, "text").unwrap());
    assert!(message.starts_with("second.fmu is no FMU of flexible-aircraft: "), "{message}");
    let message = refusal(|fmu| rewrite(fmu, ".so", Vec::clear));
    assert!(
        message.starts_with("second.fmu, aarch64-linux: found a file that is no shared library"),
        "{message}"
    );
    let message = refusal(|fmu| std::fs::remove_file(fmu).unwrap());
    assert!(message.starts_with("cannot read second.fmu: "), "{message}");
}

#[test]
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
fn fmus_of_different_interfaces_are_not_merged() {
    let (first, second) = (Interface::USUAL, Interface::ALL[1]);
    let (other, folder) = other_package();
    let one = write(&Package { interface: first, ..package() }, &folder.path().join("A.fmu"));
    for (interface, said) in [
        (second, "FMI 3.0 co-simulation"),
        (Interface::ALL[2], "FMI 2.0 model exchange"),
        (Interface::ALL[3], "FMI 3.0 model exchange"),
    ] {
        let two = write(&Package { interface, ..other.clone() }, &folder.path().join("B.fmu"));
        let message = merge(&[one.clone(), two]).unwrap_err().to_string();
        let message = message.replace(&format!("{}/", folder.path().display()), "");
        assert_eq!(message, format!("A.fmu is FMI 2.0 co-simulation, B.fmu is {said}: nothing to merge"));
    }
}

#[test]
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
fn fmus_of_each_interface_are_merged_with_their_folders() {
    let (other, folder) = other_package();
    for interface in &Interface::ALL[1..] {
        let of = |package: Package| Package { interface: *interface, ..package };
        let one = write(&of(package()), &folder.path().join("one.fmu"));
        let two = write(&of(other.clone()), &folder.path().join("two.fmu"));
        let mut both = of(other.clone());
        both.binaries.extend(package().binaries);
        assert!(merge(&[two, one]).unwrap() == both.to_bytes().unwrap(), "{interface}");
    }
}
