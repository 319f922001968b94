//! What cannot be flown is refused with the reason, and nothing hangs.

use std::sync::Arc;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{ModeSelection, PlantSettings};
use flexible_aircraft::structure::{ModeCount, ModeFamily, ModeKind, ReducedModel, StructureError};

use crate::support::{ELEVATOR, jet};

/// The small aircraft of the aircraft-file tests, changed by the caller.
fn small(change: impl FnOnce(&mut Aircraft)) -> Aircraft {
    let text = include_str!("../data/small-aircraft.toml");
    let mut aircraft = Aircraft::parse(text, "small-aircraft.toml").unwrap();
    change(&mut aircraft);
    aircraft
}

fn refusal(model: ReducedModel, settings: &Settings) -> String {
    Simulation::new(Arc::new(model), settings, 0.0).unwrap_err().to_string()
}

#[test]
fn a_wing_softer_on_one_side_has_no_symmetric_modes() {
    let model = ReducedModel::new(&small(|_| ()), 6).unwrap();
    let symmetric = Settings::from(PlantSettings {
        mode_selection: ModeSelection::Symmetric,
        mode_count: 1,
        ..PlantSettings::of(&model)
    });
    assert!(symmetric.plant.choose_modes(&model).is_ok());
    let lopsided = small(|aircraft| {
        let left = aircraft.beams.iter_mut().find(|beam| beam.component.ends_with("left"));
        left.unwrap().bending_stiffness_y *= 0.999;
    });
    let message = refusal(ReducedModel::new(&lopsided, 6).unwrap(), &symmetric);
    assert!(message.contains("mode_family") && message.contains("no mirror plane"), "{message}");
}

#[test]
fn an_aircraft_without_surfaces_is_told_what_it_lacks() {
    let model = ReducedModel { strips: Vec::new(), ..jet().select(&[]) };
    let message =
        refusal(model, &Settings::from(PlantSettings { mode_count: 0, ..PlantSettings::of(&jet()) }));
    assert!(message.contains("elevator has trim = \"pitch\" and moves no flap"), "{message}");
}

#[test]
fn more_modes_than_can_be_held_are_refused_before_memory_is_asked_for() {
    let text = include_str!("../../aircraft/generic-business-jet.toml");
    let error = ReducedModel::new(&Aircraft::parse(text, "jet.toml").unwrap(), 200).unwrap_err();
    assert!(matches!(error, StructureError::TooManyModes { wanted: 200, most: 120 }), "{error}");
}

#[test]
fn a_count_that_a_structure_cannot_give_is_named_by_one_rule() {
    let small = small(|_| ());
    let Err(StructureError::TooFewModes { wanted: 1000, available, .. }) = ReducedModel::new(&small, 1000)
    else {
        panic!("a structure of 17 elements has no 1000 modes");
    };
    let message = ReducedModel::new(&small, available + 1).unwrap_err().to_string();
    assert_eq!(message, format!("{} modes were asked for, the structure has {available}", available + 1));
    // Fewer are taken only where nobody asked for a number.
    let usual = ReducedModel::new(&small, ModeCount::asked_or_usual(None, 1000)).unwrap();
    assert_eq!(usual.modes.len(), available);
    assert!(ReducedModel::new(&small, ModeCount::asked_or_usual(Some(1000), 26)).is_err());

    let symmetric = |count| ReducedModel::with(&small, count, ModeKind::Symmetric);
    let families =
        |model: &ReducedModel| model.modes.iter().filter(|mode| mode.family == ModeFamily::Symmetric).count();
    for count in 1..8 {
        assert_eq!(families(&symmetric(ModeCount::Asked(count)).unwrap()), count);
    }
    let of_them = families(&usual);
    let message = symmetric(ModeCount::Asked(of_them + 1)).unwrap_err().to_string();
    assert_eq!(
        message,
        format!("{} symmetric modes were asked for, the structure has {of_them}", of_them + 1)
    );
    assert_eq!(families(&symmetric(ModeCount::Usual(1000)).unwrap()), of_them);
}

#[test]
fn a_structure_without_mirror_plane_has_no_symmetric_modes_to_count() {
    let lopsided = small(|aircraft| aircraft.beams[0].bending_stiffness_y *= 0.9);
    for count in [ModeCount::Asked(2), ModeCount::Usual(2)] {
        let error = ReducedModel::with(&lopsided, count, ModeKind::Symmetric).unwrap_err();
        assert!(matches!(error, StructureError::NoMirrorPlane), "{error}");
    }
}

#[test]
fn more_than_sixty_modes_are_reduced_and_read_back() {
    let text = include_str!("../../aircraft/goland-wing.toml");
    let wing = Aircraft::parse(text, "goland-wing.toml").unwrap();
    let (many, few) = (ReducedModel::new(&wing, 64).unwrap(), ReducedModel::new(&wing, 8).unwrap());
    assert_eq!((many.modes.len(), &many.modes[..8]), (64, &few.modes[..]));
    assert_eq!(many.select(&[0, 1, 2, 3, 4, 5, 6, 7]).strain_energy, few.strain_energy);
    assert!(ReducedModel::from_bytes(&many.to_bytes()).is_ok_and(|read| read == many));
}

#[test]
fn times_at_which_the_grid_has_no_cells_are_refused() {
    for start in [1e14, f64::INFINITY, f64::NAN, -2e12] {
        let message = Simulation::new(jet(), &Settings::of(&jet()), start).unwrap_err().to_string();
        assert!(message.starts_with("time: found"), "{message}");
    }
    let last = 1e12 - 1.0;
    let mut flight = Simulation::new(jet(), &Settings::of(&jet()), last).unwrap();
    flight.advance_to(last + 0.5).unwrap();
    assert_eq!(flight.time(), last + 0.5);
    assert!(flight.advance_to(1e12 + 1.0).is_err());
    assert_eq!(flight.time(), last + 0.5);
}

#[test]
fn a_flight_before_time_zero_is_like_any_other() {
    let pitch_after_a_second = |start: f64| {
        let mut flight = Simulation::new(jet(), &Settings::of(&jet()), start).unwrap();
        let mut inputs = flexible_aircraft::flight::Inputs::zero(&jet());
        inputs.controls[ELEVATOR] = 0.02;
        flight.set_inputs(&inputs, &flexible_aircraft::flight::Inputs::zero(&jet()));
        flight.advance_to(start + 1.0).unwrap();
        flight.outputs().attitude.y
    };
    assert!((pitch_after_a_second(-3.0) - pitch_after_a_second(0.0)).abs() < 1e-12);
}

#[test]
fn bytes_with_numbers_that_no_aircraft_has_are_refused_in_spite_of_a_right_checksum() {
    let mut model = (*jet()).clone();
    model.strips[3].semichord = -1.0;
    assert!(matches!(ReducedModel::from_bytes(&model.to_bytes()), Err(StructureError::Bytes(_))));
    let mut model = (*jet()).clone();
    model.integrals.momentum[2].y = f64::NAN;
    assert!(matches!(ReducedModel::from_bytes(&model.to_bytes()), Err(StructureError::Bytes(_))));
}
