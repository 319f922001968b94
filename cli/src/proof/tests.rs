//! Check flights of the jet, and how they are told.

use std::path::Path;

use flexible_aircraft::fmi::{Interface, Version};
use flexible_aircraft_packaging::{Licences, Package, Platform};

use super::trim::{Along, TrimAngle};
use super::*;

/// The check flight of the generic business jet, free or clamped, with the library that cargo built
/// beside this test.
fn jet(support: Support) -> ProofFlight {
    jet_as(Interface::USUAL, support)
}

/// The same, taken as something else.
fn jet_as(interface: Interface, support: Support) -> ProofFlight {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = tempfile::tempdir().unwrap();
    let [aircraft, fmu] = ["aircraft.toml", "aircraft.fmu"].map(|name| folder.path().join(name));
    let text = std::fs::read_to_string(workspace.join("aircraft/generic-business-jet.toml")).unwrap();
    let text = match support {
        Support::Free => text,
        Support::Clamped => text.replace("support = \"free\"", "support = \"clamped\""),
    };
    std::fs::write(&aircraft, text).unwrap();
    let read = Aircraft::read(&aircraft).unwrap();
    let name = format!("{}flexible_aircraft{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let library = std::env::current_exe().unwrap().with_file_name(name);
    let binaries = vec![(Platform::host().unwrap(), library)];
    Package {
        interface,
        aircraft,
        mode_count: 12.into(),
        load_modes: false,
        starts: Vec::new(),
        stations_along: Vec::new(),
        binaries,
        licences: Licences::Workspace(workspace),
        scene: None,
    }
    .write(&fmu)
    .unwrap();
    ProofFlight::fly(&Fmu::open(&fmu).unwrap(), &read).unwrap()
}

#[test]
fn a_free_aircraft_is_trimmed_and_answers_the_elevator() {
    let flight = jet(Support::Free);
    assert!(flight.load_factor.contains(&0.9) && flight.load_factor.contains(&1.05), "{flight:?}");
    assert!(
        flight.pitch.contains(&flight.trim.angles[0].angle)
            && matches!(flight.trim.along, Along::Thrust(thrust) if thrust > 1e4)
    );
    let peak = flight.deflection.unwrap();
    assert!(peak.station.starts_with("wing_tip") && peak.up > peak.trimmed + 0.01, "{peak:?}");
}

#[test]
fn a_trim_tells_what_is_out_of_symmetry_where_it_is() {
    let told = |lateral: f64| {
        let angles = [
            ("pitch", 0.1, true),
            ("elevator", -0.02, true),
            ("bank angle", lateral, false),
            ("sideslip", -lateral, false),
            ("aileron", 2.0 * lateral, false),
            ("rudder", -2.0 * lateral, false),
        ];
        let angles =
            angles.map(|(name, angle, is_in_plane)| TrimAngle { name: name.to_owned(), angle, is_in_plane });
        let angles = angles.to_vec();
        Trim { angles, along: Along::ClimbAngle(-0.05) }.to_string()
    };
    assert_eq!(
        told(0.01),
        "  pitch              5.730° (0.10000 rad)\n  elevator          -1.146° (-0.02000 rad)\n  \
         bank angle         0.573° (0.01000 rad)\n  sideslip          -0.573° (-0.01000 rad)\n  \
         aileron            1.146° (0.02000 rad)\n  rudder            -1.146° (-0.02000 rad)\n  \
         climb angle       -2.865° (-0.05000 rad)\n"
    );
    assert_eq!(told(0.0).lines().count(), 3);
}

#[test]
fn a_clamped_aircraft_holds_still_and_bends_in_the_gust() {
    let flight = jet(Support::Clamped);
    assert_eq!(flight.pitch.start(), flight.pitch.end());
    let peak = flight.deflection.unwrap();
    assert!((peak.up - peak.trimmed).abs() > 0.01 && peak.time > 1.0, "{peak:?}");
}

#[test]
fn the_largest_deflection_is_found_with_its_station_and_time() {
    let history = [vec![0.1, 1.0, 0.5, 0.2], vec![0.1, 1.0, 0.7, -0.9], vec![0.1, 1.0, 0.6, 0.1]];
    let peak = peak_deflection(&["wing_tip", "htail_tip"], &history).unwrap();
    assert_eq!(peak, PeakDeflection { station: "htail_tip".into(), up: -0.9, trimmed: 0.2, time: 0.01 });
}

#[test]
fn without_modes_no_deflection_is_told() {
    assert_eq!(peak_deflection(&["wing_tip"], &[vec![0.1, 1.0, 0.0], vec![0.1, 1.0, 0.0]]), None);
}

#[test]
fn a_downward_peak_is_called_so() {
    let peak = PeakDeflection { station: "wing_tip".into(), up: -0.182, trimmed: 0.05, time: 3.5 };
    let flight = ProofFlight {
        kind: Kind::CoSimulation,
        support: Support::Clamped,
        input: "wind_down".to_owned(),
        trim: Trim { angles: Vec::new(), along: Along::Thrust(0.0) },
        deflection: Some(peak),
        pitch: 0.0..=0.0,
        load_factor: 0.0..=0.0,
        computing: Duration::from_secs(1),
    };
    let text = flight.to_string();
    assert!(text.contains(" 0.182 m down at 3.50 s, wing_tip (0.050 m up at first)"), "{text}");
}

#[test]
fn only_upward_deflections_name_a_station() {
    assert_eq!(station("deflection.wing_tip_right.up"), Some("wing_tip_right"));
    assert_eq!(station("deflection.wing_tip_right.x"), None);
    assert_eq!(station("position.north"), None);
}

/// The first second, in which the wing tip answers a pulse of the elevator.
#[track_caller]
fn check_exchange(version: Version) {
    let flight = jet_as(Interface { version, kind: Kind::ModelExchange }, Support::Free);
    let stepped = jet_as(Interface { version, kind: Kind::CoSimulation }, Support::Free);
    assert_eq!(flight.trim, stepped.trim);
    // As `flexair simulate` flies the same pulse.
    let [least, most] = [flight.load_factor.start(), flight.load_factor.end()];
    assert!((least - 0.98321).abs() < 1e-4 && (most - 1.03145).abs() < 1e-4, "{least} {most}");
    let text = flight.to_string();
    assert!(text.contains("2-3-1-1 of 0.05 rad of elevator, the first 1 s:"), "{text}");
    assert!(text.contains("by Runge-Kutta steps of 1 ms"), "{text}");
}

#[test]
fn for_model_exchange_the_beginning_is_integrated_here() {
    check_exchange(Version::V2);
}

#[test]
fn in_fmi_3_too() {
    check_exchange(Version::V3);
}

#[test]
fn both_versions_fly_the_same_flight() {
    let [second, third] = [Version::V2, Version::V3].map(|version| {
        let flight = jet_as(Interface { version, kind: Kind::CoSimulation }, Support::Free);
        ProofFlight { computing: Duration::ZERO, ..flight }
    });
    assert_eq!(second, third);
}

#[test]
fn a_warning_of_the_trim_is_found_in_the_log_of_both_versions() {
    for version in ["fmi2", "fmi3"] {
        let line = format!("[logStatusWarning] {version}ExitInitializationMode: too slow");
        assert_eq!(warning_of_trim(&line), Some("too slow"));
    }
    assert_eq!(warning_of_trim("[logEvents] fmi2ExitInitializationMode: trimmed"), None);
}
