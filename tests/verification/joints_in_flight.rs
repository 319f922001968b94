//! Aircraft whose joints close loops fly at the five levels of the thesis, half and whole, and geometrically exactly not at all
//! [theory: structure.loops, limits-of-validity.loops].

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Attachment, Fidelity};
use flexible_aircraft::equations::{Configuration, EquationsOfMotion};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::{ModeSelection, Outputs, Plant, PlantSettings};
use flexible_aircraft::stability::Sweep;
use flexible_aircraft::structure::{ModeFamily, ReducedModel};
use flexible_aircraft::symmetry::{Plants, SymmetricHalf};
use nalgebra::Vector3;

use crate::support::angles;

const BRACED: &str = include_str!("../data/strut-braced.toml");
const TWIN_BOOM: &str = include_str!("../data/twin-boom.toml");
const TAIL: &str = "\n[[joint]]\ncomponent = \"tail_right\"\nat = 1\njoined_to = { component = \"tail_left\", at = 1 }\nrotations = \"fixed\"\n";

fn models() -> [Arc<ReducedModel>; 2] {
    [BRACED.to_owned(), TWIN_BOOM.to_owned() + TAIL].map(|text| {
        let aircraft = Aircraft::parse(&text, "joined.toml").unwrap_or_else(|error| panic!("{error}"));
        Arc::new(ReducedModel::new(&aircraft, 20).unwrap())
    })
}

fn settings(model: &ReducedModel, fidelity: Fidelity) -> Settings {
    Settings { tolerance: 1e-8, ..PlantSettings { fidelity, ..PlantSettings::of(model) }.into() }
}

/// Flies under elevator, and an aileron that lets the whole aircraft fly even where it hardly moves.
fn flight(model: &Arc<ReducedModel>, fidelity: Fidelity, aileron: f64) -> Simulation {
    let mut flight = Simulation::new(Arc::clone(model), &settings(model, fidelity), 0.0)
        .unwrap_or_else(|error| panic!("{} {fidelity:?}: {error}", model.name));
    let [elevator, roll] = ["elevator", "aileron"].map(|name| model.control(name).unwrap());
    flight.set_inputs(&angles(model, &[(elevator, 0.03), (roll, aileron)]), &Inputs::zero(model));
    flight.advance_to(0.5).unwrap();
    flight
}

fn assert_near(one: &Outputs, other: &Outputs, bound: f64) {
    for (one, other) in one.deflections.iter().zip(&other.deflections) {
        assert!((one.displacement - other.displacement).norm() < bound, "{one:?} {other:?}");
    }
    assert!(
        (one.attitude - other.attitude).norm() < bound
            && (one.load_factor - other.load_factor).norm() < 10.0 * bound
    );
}

#[test]
fn aircraft_with_loops_trim_and_fly_at_the_five_levels_of_the_thesis_half_as_whole() {
    for (model, fidelity) in models().iter().flat_map(|model| Fidelity::OF_THESIS.map(|level| (model, level)))
    {
        assert!(SymmetricHalf::find(model).is_some() && !model.joints.is_empty());
        let (mut half, mut whole) = (flight(model, fidelity, 0.0), flight(model, fidelity, 1e-14));
        assert!(half.is_symmetric() && !whole.is_symmetric());
        assert_near(half.outputs(), whole.outputs(), 1e-7);
        let rolled = flight(model, fidelity, 0.02).outputs().attitude[0].abs();
        assert!(rolled > 1e-3, "{fidelity:?} {rolled}");
        // A snapshot goes on as the flight does, bit for bit.
        let mut bytes = Vec::new();
        half.snapshot(&mut bytes);
        half.advance_to(0.7).unwrap();
        let expected = half.outputs().clone();
        let mut other = flight(model, fidelity, 0.0);
        other.advance_to(0.6).unwrap();
        other.restore(&bytes).unwrap();
        other.advance_to(0.7).unwrap();
        assert_eq!(other.outputs().deflections, expected.deflections);
    }
}

#[test]
fn a_strut_stays_on_its_wing_and_takes_its_bending() {
    let mut joined = Aircraft::parse(BRACED, "braced.toml").unwrap();
    let wing = joined.components.iter().find(|component| component.name == "wing_right").unwrap();
    let middle = Attachment { beam: wing.first_beam + 3, fraction: 1.0 };
    joined.stations.push(joined.station_at("node", middle));
    let alone = Aircraft { joints: Vec::new(), ..joined.clone() };
    let tip_and_node = |aircraft: &Aircraft| -> [Vector3<f64>; 3] {
        let model = ReducedModel::new(aircraft, 20).unwrap();
        let settings = PlantSettings::of(&model);
        let plant = Plant::under(&model, &settings).unwrap();
        let trim = plant.trim(&settings.trim_condition()).unwrap();
        let outputs = plant.outputs_at(&trim.state, &trim.controls, &mut plant.workspace());
        let at = |name: &str| {
            let place = model.stations.iter().position(|station| station.name == name).unwrap();
            outputs.deflections[place].displacement
        };
        [at("tip_right"), at("strut_right"), at("node")]
    };
    let [tip, strut, node] = tip_and_node(&joined);
    assert!((strut - node).norm() < 1e-12 && node.z < -1e-4, "{strut} {node}");
    let [free_tip, free_strut, free_node] = tip_and_node(&alone);
    assert!((free_strut - free_node).norm() > 1e-3);
    assert!(free_tip.z < 3.0 * tip.z, "{free_tip} {tip}");
}

#[test]
fn symmetric_modes_trim_a_braced_aircraft_as_all_modes_do() {
    let [model, _] = models();
    let symmetric = model.modes.iter().filter(|mode| mode.family == ModeFamily::Symmetric).count();
    let trim = |mode_selection, mode_count| {
        let plant = PlantSettings { mode_selection, mode_count, ..PlantSettings::of(&model) };
        let flight = Simulation::new(Arc::clone(&model), &plant.into(), 0.0).unwrap();
        [flight.trim().pitch, flight.trim().pitch_control]
    };
    let (half, whole) =
        (trim(ModeSelection::Symmetric, symmetric), trim(ModeSelection::All, model.modes.len()));
    assert!(half.iter().zip(&whole).all(|(half, whole)| (half - whole).abs() < 1e-9), "{half:?} {whole:?}");
}

#[test]
fn geometrically_exact_flight_of_a_loop_is_refused_by_the_name_of_its_joint() {
    let [model, _] = models();
    let settings = settings(&model, Fidelity::GeometricallyExact);
    let refused = Simulation::new(Arc::clone(&model), &settings, 0.0).unwrap_err().to_string();
    let expected = "model: found geometrically_exact, allowed is exact, consistently_linearised, inconsistent, \
                    ruthlessly_linearised, rigid: the joint of \"strut_right\" at 1 and \"wing_right\" at 0.5 closes a loop";
    assert!(refused.contains(expected), "{refused}");
}

#[test]
fn no_way_to_equations_leads_to_geometrically_exact_ones_of_a_loop() {
    let [model, _] = models();
    let settings = PlantSettings { fidelity: Fidelity::GeometricallyExact, ..PlantSettings::of(&model) };
    let configuration = settings.configuration(model.support);
    let modes = PlantSettings::of(&model).choose_modes(&model).unwrap();
    let half = SymmetricHalf::find(&model).unwrap();
    let refused = [
        EquationsOfMotion::new(&model, &configuration).err(),
        EquationsOfMotion::in_plane(&model, &[], &configuration).err(),
        half.equations(&configuration).err(),
        Plant::new(&model, &configuration).err(),
        Plant::of_modes(&model, &configuration, &modes).err(),
        Plants::new(&model, &configuration, &modes).err(),
    ];
    let by_settings = [
        settings.choose_modes(&model).err(),
        Plant::under(&model, &settings).err(),
        Plants::under(&model, &settings).err(),
        Sweep::new(&model, &settings, &[settings.airspeed]).err(),
    ];
    let words = refused.map(|refused| refused.unwrap().to_string());
    let by_settings = by_settings.map(|refused| refused.unwrap().to_string());
    let closes = "the joint of \"strut_right\" at 1 and \"wing_right\" at 0.5 closes a loop";
    assert!(words[0].ends_with(closes), "{}", words[0]);
    assert!(
        words.iter().chain(&by_settings).all(|message| *message == words[0]),
        "{words:?} {by_settings:?}"
    );
    // What has no loop flies, and so does a loop at another level.
    let alone = ReducedModel { joints: Vec::new(), ..(*model).clone() };
    assert!(Plant::new(&alone, &configuration).is_ok());
    assert!(Plant::new(&model, &Configuration { fidelity: Fidelity::Exact, ..configuration }).is_ok());
}
