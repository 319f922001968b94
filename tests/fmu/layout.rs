//! What lies where in the archives of each interface.

use std::io::{Cursor, Read};

use flexible_aircraft::fmi::{Interface, Kind, Version};
use flexible_aircraft_packaging::{Package, PackageError};
use zip::ZipArchive;

use super::package;

/// A small package, taken as something.
fn package_as(interface: Interface, starts: &[&str]) -> Package {
    let starts = starts.iter().map(ToString::to_string).collect();
    Package { interface, mode_count: 2.into(), starts, ..package() }
}

/// The files by their paths, but the licences that are not its entry point.
fn files(interface: Interface) -> Vec<(String, Vec<u8>)> {
    let bytes = package_as(interface, &["altitude=5000"]).to_bytes().unwrap();
    let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
    let mut files = Vec::new();
    for index in 0..archive.len() {
        let mut file = archive.by_index(index).unwrap();
        let name = file.name().unwrap().into_owned();
        let mut content = Vec::new();
        file.read_to_end(&mut content).unwrap();
        let licence = name.strip_prefix("documentation/licenses/");
        if licence.is_none_or(|name| !name.contains('/')) {
            files.push((name, content));
        }
    }
    files
}

#[test]
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
fn each_version_has_its_own_places() {
    for interface in Interface::ALL {
        let expected = match interface.version {
            Version::V2 => {
                "modelDescription.xml binaries/linux64/FlexibleAircraft.so documentation/index.html \
                 documentation/licenses/README.txt model.png resources/aircraft.toml resources/RESOURCE resources/starts.txt"
            }
            Version::V3 => {
                "modelDescription.xml binaries/x86_64-linux/FlexibleAircraft.so documentation/diagram.png \
                 documentation/index.html documentation/licenses/license.txt resources/aircraft.toml resources/RESOURCE \
                 resources/starts.txt terminalsAndIcons/icon.png terminalsAndIcons/terminalsAndIcons.xml"
            }
        };
        let expected = expected.replace("RESOURCE", flexible_aircraft::fmi::RESOURCE_FILE);
        let names: Vec<String> = files(interface).into_iter().map(|(name, _)| name).collect();
        assert_eq!(names.join(" "), expected, "{interface}");
    }
}

/// One library serves all, and so does the aircraft.
#[test]
fn archives_of_one_aircraft_share_library_model_and_icon() {
    let of = |interface| {
        let files = files(interface);
        move |end: &str| files.iter().find(|(name, _)| name.ends_with(end)).unwrap().1.clone()
    };
    let usual = of(Interface::USUAL);
    for interface in &Interface::ALL[1..] {
        let other = of(*interface);
        for end in [
            std::env::consts::DLL_SUFFIX,
            flexible_aircraft::fmi::RESOURCE_FILE,
            "aircraft.toml",
            "starts.txt",
        ] {
            assert!(other(end) == usual(end), "{interface}: {end}");
        }
        let icon = if interface.version == Version::V2 { "model.png" } else { "icon.png" };
        assert!(other(icon) == usual("model.png"), "{interface}");
        assert!(other("modelDescription.xml") != usual("modelDescription.xml"), "{interface}");
    }
}

#[test]
fn model_exchange_refuses_what_only_an_integrator_of_our_own_flies() {
    for version in [Version::V2, Version::V3] {
        for (start, reason) in [
            ("tolerance=1e-4", "--set tolerance=1e-4: `tolerance` belongs to co-simulation: "),
            (
                "sensor.enabled=true",
                "model exchange: sensor.enabled: found true, allowed is false: a sampled sensor belongs",
            ),
            (
                "actuator.elevator.maximum=0.3",
                "model exchange: actuator.elevator.maximum: found 0.3, allowed is ",
            ),
            ("engine.left.minimum=0", "model exchange: engine.left.minimum: found 0, allowed is "),
            ("inflow_states=3", "model exchange: inflow_states: found 3, allowed is 0 or 5: "),
        ] {
            let of = |kind| package_as(Interface { version, kind }, &[start]).to_bytes();
            let refused = of(Kind::ModelExchange).unwrap_err();
            assert!(matches!(refused, PackageError::Start(_) | PackageError::Discontinuous(_)));
            assert!(refused.to_string().starts_with(reason), "{refused}");
            assert!(of(Kind::CoSimulation).is_ok(), "{start}");
        }
    }
}
