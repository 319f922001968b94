//! The static margin against closed forms, of the half against the whole, and against trims
//! [theory: linearisation.static-margin, linearisation.reference].

use flexible_aircraft::Aircraft;
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

/// A model of a file beside the tests or of a shipped one, with its first modes.
fn model(file: &str, modes: usize) -> ReducedModel {
    ReducedModel::new(&aircraft(file), modes).unwrap()
}

fn aircraft(file: &str) -> Aircraft {
    Aircraft::read(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap()
}

/// Nothing else lifts than two planes in one plane without drag: dL = q Σ a S dα, dM = q Σ a S (x − c) dα. The wing's single strip on each
/// side turns by θ under its moment, 4 (GJ/L) θ = q S a e (α + θ) + πρb² Δy d v̇: the aircraft rises by v̇ = dL/m, and the apparent mass stays
/// behind at mid-chord, d behind the beam.
#[test]
fn lift_slope_and_margin_of_two_planes_are_those_of_closed_forms() {
    let mut record = Record::new(
        "static-margin",
        "Static margin (in chords of the wing) and C_Lα of two planes, the wing rigid or a fifth of the way to divergence: relative to the closed form",
        "strip theory by hand, in the test",
    );
    let model = model("tests/data/two-planes.toml", 12);
    let (half_wing, mass) = (6.0 * 1.5, 3000.0);
    for (name, fidelity, stiffness, bounds) in [
        ("rigid", Fidelity::Rigid, f64::INFINITY, [2e-7, 2e-7]),
        ("elastic", Fidelity::Exact, 4.0 * 2.8e5 / 6.0, [2e-5, 1e-4]),
    ] {
        let settings = PlantSettings { fidelity, ..PlantSettings::of(&model) };
        let found = of_plant(&Plant::under(&model, &settings).unwrap(), &settings);
        let (q, tail) = (found.dynamic_pressure, 2.0 * 1.5 * 4.0);
        let (lift, density) = (q * half_wing * 5.5, 2.0 * q / (200.0 * 200.0));
        let behind = std::f64::consts::PI * density * 0.75 * 0.75 * 6.0 * (0.1 * 1.5) / mass;
        let moment = lift * (0.15 * 1.5) + behind * (2.0 * lift + q * tail);
        let twist = moment / (stiffness - lift * (0.15 * 1.5) - behind * 2.0 * lift);
        let wing = 2.0 * half_wing * 5.5 * (1.0 + twist);
        let centre = found.centre_of_mass.x;
        let margin = -(wing * (0.225 - centre) + tail * (-5.0 - centre)) / (wing + tail) / 1.5;
        let slope = (wing + tail) / (2.0 * half_wing);
        record.rounding(&format!("{name}: margin"), bounds[0], found.margin(1.5) / margin - 1.0);
        record.rounding(
            &format!("{name}: C_Lα"),
            bounds[1],
            found.lift_slope_coefficient(2.0 * half_wing) / slope - 1.0,
        );
    }
    record.finish();
}

/// What a steady wake leaves, however many states it has; from the solar aircraft of 2 kg/m² to the jet of 250.
#[test]
fn the_static_margin_knows_no_inflow_states() {
    let mut record = Record::new(
        "static-margin-inflow",
        "Static margin in chords and C_Lα of shipped aircraft with 12 modes: greatest difference from N = 0 of N = 2, 5, 8",
        "definition of steady flow",
    );
    for name in ["generic-business-jet", "light-single", "high-altitude", "flying-wing"] {
        let file = format!("aircraft/{name}.toml");
        let (model, lengths) = (model(&file, 12), aircraft(&file).reference_lengths().unwrap());
        let found = |inflow_states| {
            let settings = PlantSettings { inflow_states, ..PlantSettings::of(&model) };
            of_plant(&Plant::under(&model, &settings).unwrap(), &settings)
        };
        let (steady, others) = (found(0), [2, 5, 8].map(found));
        let greatest = |quantity: &dyn Fn(&StaticStability) -> f64| {
            others.iter().map(|other| (quantity(other) - quantity(&steady)).abs()).fold(0.0, f64::max)
        };
        record.rounding(&format!("{name}: margin"), 2e-12, greatest(&|found| found.margin(lengths.chord)));
        record.rounding(
            &format!("{name}: C_Lα"),
            3e-11,
            greatest(&|found| found.lift_slope_coefficient(lengths.area)),
        );
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
        record.rounding(&format!("{name}: margin"), 3e-12, half.margin(3.7) - whole.margin(3.7));
        record.rounding(&format!("{name}: lift slope"), 1e-11, half.lift_slope / whole.lift_slope - 1.0);
        let centre = half.centre_of_mass - whole.centre_of_mass;
        record.rounding(&format!("{name}: centre of mass, m"), 1e-14, centre.norm());
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
    let mut aircraft = aircraft("aircraft/generic-business-jet.toml");
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
    let wing = model("aircraft/goland-wing.toml", 2);
    let settings = PlantSettings::of(&wing);
    let plant = Plant::under(&wing, &settings).unwrap();
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    assert_eq!(plant.static_stability(&trim), Err(NoStaticStability::Clamped));
}
