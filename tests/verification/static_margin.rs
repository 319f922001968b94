//! The static margin against an independent computation, of the half against the whole, and against trims
//! [theory: linearisation.static-margin, linearisation.residualised, linearisation.reference].

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::ReferenceLengths;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::{
    ConditionSettings, ManoeuvreChoice, NoStaticStability, Plant, PlantSettings, StaticStability,
};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::symmetry::Plants;

use crate::support::jet;

use super::record::Record;

/// The jet at 127 m/s and 7620 m with twelve modes of both families, N = 5.
fn settings(stiffness_scale: f64) -> PlantSettings {
    PlantSettings { stiffness_scale, fidelity: Fidelity::Exact, ..PlantSettings::of(&jet()) }
}

fn of_plant(plant: &Plant, settings: &PlantSettings) -> StaticStability {
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    plant.static_stability(&trim).unwrap()
}

fn of_whole(settings: &PlantSettings) -> StaticStability {
    of_plant(&Plant::under(&jet(), settings).unwrap(), settings)
}

/// Of the jet's wing.
fn lengths() -> ReferenceLengths {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
    Aircraft::read(path).unwrap().reference_lengths().unwrap()
}

#[test]
fn the_static_margin_is_that_of_the_independent_computation() {
    let mut record = Record::new(
        "static-margin",
        "Static margin and lift slope of the jet, 127 m/s, 7620 m, exact model, twelve modes, N = 5 (to the digits of the reference)",
        "prototype in numpy that shares nothing with this program",
    );
    let lengths = lengths();
    record.absolute("mean aerodynamic chord, m", 3.7307, 5e-5, lengths.chord);
    record.absolute("wing area, m²", 87.198, 5e-4, lengths.area);
    for (name, stiffness, margin, slope) in
        [("nominal", 1.0, 0.09872, 5.3986), ("tenth", 0.1, 0.11348, 4.5496)]
    {
        let stability = of_whole(&settings(stiffness));
        record.absolute(&format!("{name}: static margin"), margin, 5e-6, stability.margin(lengths.chord));
        let found = stability.lift_slope_coefficient(lengths.area);
        record.absolute(&format!("{name}: C_Lα, 1/rad"), slope, 5e-5, found);
    }
    record.finish();
}

#[test]
fn half_the_aircraft_has_the_static_margin_of_the_whole() {
    let mut record = Record::new(
        "static-margin-half",
        "Static margin of the jet from half of it, against that from the whole (both trimmed by themselves)",
        "the same aircraft without the half",
    );
    for fidelity in Fidelity::ALL {
        let settings = PlantSettings { fidelity, ..settings(0.3) };
        let plants = Plants::under(&jet(), &settings).unwrap();
        let [half, whole] = [plants.half().unwrap(), plants.whole()].map(|plant| of_plant(plant, &settings));
        let name = fidelity.name();
        record.rounding(&format!("{name}: margin"), 1e-7, half.margin(3.7) - whole.margin(3.7));
        record.rounding(&format!("{name}: lift slope"), 1e-7, half.lift_slope / whole.lift_slope - 1.0);
        let centre = half.centre_of_mass - whole.centre_of_mass;
        record.rounding(&format!("{name}: centre of mass, m"), 1e-9, centre.norm());
    }
    record.finish();
}

/// A shift of all mass by Δ moves the margin by Δ/c̄ and leaves the neutral point where it is, but for what the shifted weight
/// bends.
#[test]
fn a_rigid_aircraft_keeps_its_neutral_point_when_its_mass_is_moved() {
    let mut record = Record::new(
        "neutral-point",
        "Neutral point of the rigid jet without inflow, all mass 0.2 m farther back: m of body x (the angle of attack of the trim \
         changes a little, and with it the moment of drag)",
        "definition of the neutral point",
    );
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
    let mut aircraft = Aircraft::read(path).unwrap();
    let found = |aircraft: &Aircraft| {
        let model = ReducedModel::new(aircraft, 1).unwrap();
        let settings =
            PlantSettings { fidelity: Fidelity::Rigid, inflow_states: 0, ..PlantSettings::of(&model) };
        of_plant(&Plant::under(&model, &settings).unwrap(), &settings)
    };
    let before = found(&aircraft);
    aircraft.bays.iter_mut().for_each(|bay| bay.offset.x -= 0.2);
    let after = found(&aircraft);
    let moved = after.centre_of_mass.x - before.centre_of_mass.x;
    record.absolute("centre of mass", -0.2, 1e-9, moved);
    record.absolute("neutral point", before.neutral_point(), 0.02, after.neutral_point());
    record.absolute("margin", before.margin(4.0) - 0.05, 0.005, after.margin(4.0));
    record.finish();
}

#[test]
fn what_has_no_static_margin_says_why() {
    let pull_up = ConditionSettings {
        manoeuvre: ManoeuvreChoice::PullUp,
        load_factor: 1.5,
        ..ConditionSettings::default()
    };
    let settings = PlantSettings { condition: pull_up, ..settings(1.0) };
    let plant = Plant::under(&jet(), &settings).unwrap();
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    assert_eq!(plant.static_stability(&trim), Err(NoStaticStability::CurvedPath));
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/goland-wing.toml");
    let wing = ReducedModel::new(&Aircraft::read(path).unwrap(), 2).unwrap();
    let settings = PlantSettings::of(&wing);
    let plant = Plant::under(&wing, &settings).unwrap();
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    assert_eq!(plant.static_stability(&trim), Err(NoStaticStability::Clamped));
}
