//! What assignments become, and what is said of those that are wrong.

use std::path::Path;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::fmi::Version;

use super::*;

/// Nobody asked for a number of modes.
const USUAL: ModeCount = ModeCount::Usual(ReducedModel::USUAL_MODES);

fn set(assignments: &[&str]) -> Result<Settings, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/small-aircraft.toml");
    let model = ReducedModel::new(&Aircraft::read(&path).unwrap(), 2).unwrap();
    let variables = VariableTable::new(&model);
    let assignments: Vec<String> = assignments.iter().map(ToString::to_string).collect();
    settings(&assignments, &variables, &model, USUAL).map_err(|mistake| mistake.to_string())
}

#[test]
fn numbers_and_items_in_any_case_become_settings() {
    let settings = set(&["model=Rigid", "stiffness_scale=0.1", "mode_count=2", "mode_family=2"]).unwrap();
    assert_eq!((settings.plant.fidelity, settings.plant.stiffness_scale), (Fidelity::Rigid, 0.1));
    assert_eq!(settings.plant.mode_count, 2);
}

#[test]
fn a_wrong_assignment_is_told_what_is_allowed_with_its_unit() {
    let cases = [
        ("model", "model: allowed is NAME=VALUE"),
        (
            "elevator=1",
            "elevator=1: `elevator` is an input and no parameter: it has no start, but a course over time, as a column of that \
             name in the INPUTS of `flexair simulate` or `flexair loads`",
        ),
        ("trim.pitch=1", "trim.pitch=1: `trim.pitch` is an output"),
        (
            "stifness_scale=1",
            "stifness_scale=1: there is no parameter `stifness_scale`, did you mean `stiffness_scale`?; there are ",
        ),
        ("flap=1", "flap=1: there is no parameter `flap`; there are input_reference, model, airspeed, "),
        ("model=stiff", "model=stiff: found `stiff`, allowed is 1 (exact), 2 (consistently_linearised), "),
        (
            "model=rigit",
            "model=rigit: found `rigit`, allowed is 1 (exact), 2 (consistently_linearised), 3 (inconsistent), 4 (ruthlessly_linearised), 5 (rigid), 6 (geometrically_exact), did you mean `rigid`?",
        ),
        ("model=7", "model=7: found `7`, allowed is 1 (exact), "),
        ("airspeed=fast", "airspeed=fast: found `fast`, allowed is 1 to 400 m/s"),
        ("airspeed=NaN", "airspeed=NaN: found `NaN`, allowed is 1 to 400 m/s"),
        ("altitude=35000", "altitude=35000: found `35000`, allowed is -1000 to 30000 m"),
        ("heading=north", "heading=north: found `north`, allowed is any finite number, in rad"),
    ];
    for (assignment, expected) in cases {
        let mistake = set(&[assignment]).unwrap_err();
        assert!(mistake.starts_with(expected), "{mistake}");
    }
}

/// The jet's first 12 modes are of both families.
#[test]
fn the_usual_number_of_modes_is_no_more_than_the_family_has() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/generic-business-jet.toml");
    let model = ReducedModel::new(&Aircraft::read(&path).unwrap(), 12).unwrap();
    let variables = VariableTable::new(&model);
    let of = |assignments: &[&str]| {
        let assignments: Vec<String> = assignments.iter().map(ToString::to_string).collect();
        settings(&assignments, &variables, &model, USUAL).unwrap()
    };
    let symmetric = of(&["mode_family=symmetric"]);
    assert!((1..12).contains(&symmetric.plant.mode_count), "{}", symmetric.plant.mode_count);
    assert_eq!(symmetric.plant.choose_modes(&model).unwrap().len(), symmetric.plant.mode_count);
    assert_eq!(of(&[]).plant.mode_count, 12);
    // What was asked for is not changed in silence.
    let asked = of(&["mode_count=12", "mode_family=symmetric"]);
    assert!(asked.plant.choose_modes(&model).unwrap_err().to_string().starts_with("mode_count: found 12"));
}

#[test]
fn all_modes_fly_that_were_asked_for_and_the_usual_number_where_none_were() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/generic-business-jet.toml");
    let model = ReducedModel::new(&Aircraft::read(&path).unwrap(), 24).unwrap();
    let variables = VariableTable::new(&model);
    let flown = |assignment: &[&str], reduced_to| {
        let assignments: Vec<String> = assignment.iter().map(ToString::to_string).collect();
        let settings = settings(&assignments, &variables, &model, reduced_to).unwrap();
        settings.plant.choose_modes(&model).unwrap().len()
    };
    assert_eq!([flown(&[], ModeCount::Asked(24)), flown(&[], USUAL)], [24, 12]);
    assert_eq!(flown(&["mode_count=8"], ModeCount::Asked(24)), 8);
    let symmetric = model.modes.iter().filter(|mode| mode.family == ModeFamily::Symmetric).count();
    assert_eq!(flown(&["mode_family=symmetric"], ModeCount::Asked(24)), symmetric);
}

#[test]
fn load_modes_are_switched_by_true_and_false_in_any_case_where_there_are_some() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/goland-wing.toml");
    let wing = Aircraft::read(&path).unwrap();
    let set = |load_modes, assignment: &str| {
        let model = ReducedModel::new(&Aircraft { load_modes, ..wing.clone() }, 2).unwrap();
        settings(&[assignment.to_owned()], &VariableTable::new(&model), &model, USUAL)
    };
    assert!(!set(true, "load_modes=false").unwrap().plant.load_modes);
    assert!(set(true, "load_modes=True").unwrap().plant.load_modes);
    let mistake = set(true, "load_modes=1").unwrap_err().to_string();
    assert_eq!(mistake, "load_modes=1: found `1`, allowed is true or false");
    let mistake = set(false, "load_modes=true").unwrap_err().to_string();
    assert!(mistake.starts_with("load_modes=true: there is no parameter `load_modes`"), "{mistake}");
}

#[test]
fn a_parameter_is_set_once() {
    let mistake = set(&["airspeed=100", "model=rigid", "airspeed=120"]).unwrap_err();
    assert_eq!(mistake, "airspeed=120: `airspeed` was set before, by airspeed=100");
}

#[test]
fn what_belongs_to_co_simulation_is_no_parameter_of_model_exchange() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/small-aircraft.toml");
    let model = ReducedModel::new(&Aircraft::read(&path).unwrap(), 2).unwrap();
    let set = |kind, assignment: &str| {
        let interface = Interface { version: Version::V2, kind };
        starts(&[assignment.to_owned()], interface, &model).map_err(|mistake| mistake.to_string())
    };
    assert_eq!(set(Kind::CoSimulation, "tolerance=1e-4").unwrap().tolerance, 1e-4);
    let refused = set(Kind::ModelExchange, "tolerance=1e-4").unwrap_err();
    assert!(refused.starts_with("tolerance=1e-4: `tolerance` belongs to co-simulation: "), "{refused}");
    assert_eq!(set(Kind::ModelExchange, "airspeed=60").unwrap().plant.airspeed, 60.0);
}

#[test]
fn all_natural_modes_take_part_in_model_exchange_where_there_are_load_modes() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/goland-wing.toml");
    let wing = Aircraft { load_modes: true, ..Aircraft::read(&path).unwrap() };
    let model = ReducedModel::new(&wing, 4).unwrap();
    for version in [Version::V2, Version::V3] {
        let interface = Interface { version, kind: Kind::ModelExchange };
        let starts = starts(&["airspeed=80".to_owned()], interface, &model).unwrap();
        assert_eq!(starts.plant.mode_count, 4);
        assert_eq!(flexible_aircraft::flight::continuous_settings::check(&starts, &model), Ok(()));
    }
}
