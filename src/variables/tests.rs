use std::collections::HashSet;

use crate::aircraft::{TAKEN, TAKEN_BY_TRIM, TrimRole};
use crate::equations::Fidelity;
use crate::flight::{Inputs, Settings};
use crate::plant::PlantSettings;
use crate::structure::test_jet::jet;

use super::*;

fn table() -> VariableTable {
    VariableTable::new(jet())
}

/// The jet as if its last two modes were load modes.
fn jet_with_load_modes() -> ReducedModel {
    let mut model = jet().clone();
    model.modes[24..].iter_mut().for_each(|mode| mode.of_loads = true);
    model
}

fn row(name: &str) -> Variable {
    let table = table();
    let reference = table.reference(name).unwrap_or_else(|| panic!("no variable `{name}`"));
    table.get(reference).unwrap().clone()
}

#[test]
fn the_jet_has_exactly_the_variables_of_the_contract() {
    let mut expected: Vec<String> = [
        "elevator aileron aileron_symmetric surface.aileron_symmetric rudder thrust_left thrust_right wind_north wind_east wind_down input_reference model",
        "wind_rate_north wind_rate_east wind_rate_down",
        "airspeed altitude temperature_offset heading stiffness_scale structural_damping mode_family mode_count inflow_states",
        "tolerance position.north position.east position.down attitude.roll attitude.pitch attitude.yaw",
        "velocity.x velocity.y velocity.z rate.x rate.y rate.z acceleration.x acceleration.y acceleration.z",
        "load_factor.x load_factor.y load_factor.z air.speed air.alpha air.beta air.mach air.density",
        "air.dynamic_pressure surface.elevator surface.aileron surface.rudder engine.left.thrust",
        "air.equivalent air.calibrated air.pressure air.temperature load_factor.lift load_factor_cg.x load_factor_cg.y",
        "load_factor_cg.z angular_acceleration.x angular_acceleration.y angular_acceleration.z path.climb_angle path.track",
        "path.vertical_speed attitude.quaternion[1] attitude.quaternion[2] attitude.quaternion[3] attitude.quaternion[4]",
        "wind.north wind.east wind.down gust.shape gust.gradient gust.peak gust.direction gust.inclination gust.start",
        "gust.criterion gust.alleviation gust.maximum_operating_altitude gust.peak_velocity turbulence.spectrum",
        "turbulence.intensity turbulence.scale turbulence.seed turbulence.components turbulence.start",
        "engine.right.thrust trim.pitch trim.elevator trim.thrust trim.roll trim.beta trim.aileron trim.rudder",
        "trim.alpha trim.turn_rate trim.pitch_rate trim.load_factor condition.manoeuvre condition.climb_angle",
        "condition.bank_angle condition.load_factor condition.sideslip condition.lateral condition.failed_engine",
    ]
    .iter()
    .flat_map(|line| line.split(' ').map(str::to_owned))
    .collect();
    for station in ["wing_tip_right", "wing_tip_left", "htail_tip_right", "htail_tip_left", "vtail_tip"] {
        expected.extend(["x", "y", "z", "up", "twist"].map(|c| format!("deflection.{station}.{c}")));
        expected.extend(["x", "y", "z"].map(|c| format!("station.{station}.specific_force.{c}")));
        expected.extend(["x", "y", "z"].map(|c| format!("station.{station}.rate.{c}")));
        expected.extend(["north", "east", "down"].map(|c| format!("station.{station}.position.{c}")));
        expected.extend([1, 2, 3, 4].map(|part| format!("station.{station}.quaternion[{part}]")));
    }
    for mode in 1..=ReducedModel::USUAL_MODES {
        expected.extend([format!("modal.q[{mode}]"), format!("modal.q_dot[{mode}]")]);
    }
    let sides = ["wing_root", "wing_mid", "htail_root"]
        .into_iter()
        .flat_map(|cut| ["right", "left"].map(|side| format!("{cut}_{side}")));
    let others = ["vtail_root", "fuselage_aft", "fuselage_tail"].map(str::to_owned);
    for cut in sides.chain(others) {
        let forces = ["shear", "shear_chordwise", "axial", "torsion", "bending", "bending_chordwise"];
        expected.extend(forces.map(|component| format!("loads.{cut}.{component}")));
    }
    for control in ["elevator", "aileron", "aileron_symmetric", "rudder"] {
        let suffixes = ["frequency", "damping", "rate_limit", "minimum", "maximum"].into_iter();
        let suffixes = suffixes.chain(["rate", "rate_limited", "position_limited"]);
        expected.extend(suffixes.map(|suffix| format!("actuator.{control}.{suffix}")));
    }
    for engine in ["left", "right"] {
        expected.extend(["time_constant", "minimum", "maximum"].map(|c| format!("engine.{engine}.{c}")));
    }
    let kinds = ["attitude", "rate", "load_factor", "specific_force", "air_angle", "air_speed", "position"];
    expected.extend(kinds.map(|kind| format!("sensor.noise.{kind}")));
    expected.extend(["enabled", "period", "time_constant", "delay", "seed"].map(|c| format!("sensor.{c}")));
    let is_measured = |name: &str| {
        let of_station = name.contains(".specific_force.") || name.contains(".rate.");
        let air = ["air.speed", "air.alpha", "air.beta", "position.down"].contains(&name);
        let group = ["attitude.", "rate.", "load_factor."].iter().any(|group| name.starts_with(group));
        let is_derived = name.contains("quaternion") || name == "load_factor.lift";
        (group && !is_derived) || air || (of_station && name.starts_with("station."))
    };
    let measured: Vec<String> = expected.iter().filter(|name| is_measured(name)).cloned().collect();
    expected.extend(measured.into_iter().map(|name| format!("sensor.{name}")));
    let mut found: Vec<String> = table().iter().map(|(_, variable)| variable.name.clone()).collect();
    expected.sort();
    found.sort();
    assert_eq!(found, expected);
}

/// What the aircraft reader refuses as the name of a control is what other variables have, and the time.
#[test]
fn names_that_no_control_can_have_are_those_of_other_variables() {
    let glider = ReducedModel { engines: Vec::new(), ..jet().clone() };
    let tables = [jet(), &glider, &jet_with_load_modes()].map(VariableTable::new);
    let names = tables.iter().flat_map(|table| table.iter().map(|(_, variable)| variable.name.as_str()));
    let names: HashSet<&str> = names.collect();
    let is_controls = |name: &str| jet().control(name).is_some();
    let of_engine = |name: &str| name.starts_with("thrust_");
    let plain =
        names.iter().filter(|name| !name.contains(['.', '[']) && !is_controls(name) && !of_engine(name));
    let taken: HashSet<&str> = plain.copied().chain(["time"]).collect();
    assert_eq!(taken, TAKEN.iter().copied().collect());
    let of_trims = names.iter().filter_map(|name| name.strip_prefix("trim."));
    let of_trims: HashSet<&str> = of_trims.filter(|name| !is_controls(name)).collect();
    assert_eq!(of_trims, TAKEN_BY_TRIM.iter().copied().collect());
}

#[test]
fn controls_bring_variables_by_their_names_and_only_those_with_roles_stand_in_the_trim() {
    let mut model = jet().clone();
    model.controls[1].name = "canard".to_owned();
    (model.controls[1].description, model.controls[1].positive) =
        ("V-tail angle".to_owned(), "nose-up".to_owned());
    model.controls[0].role = None;
    (model.controls[1].role, model.controls[3].role) = (Some(TrimRole::Pitch), None);
    let table = VariableTable::new(&model);
    let described =
        |name: &str| table.reference(name).map(|reference| table.get(reference).unwrap().description.clone());
    assert_eq!(
        described("canard").as_deref(),
        Some(
            "V-tail angle, positive nose-up; acts with opposite signs on the two sides; holds pitch in trim; has the usual limits of \
         -30 to 30 deg, which change no flight"
        )
    );
    assert_eq!(
        described("surface.canard").unwrap().split(';').next(),
        Some("Acting V-tail angle, trim included")
    );
    assert_eq!(described("trim.canard").as_deref(), Some("V-tail angle of the trim found at initialisation"));
    assert_eq!(
        described("surface.elevator").as_deref(),
        Some(
            "Acting elevator deflection, trim included; a flap turns by the sum of gain times angle over the controls that move it"
        )
    );
    for gone in ["aileron", "surface.aileron", "trim.elevator", "trim.aileron", "trim.rudder"] {
        assert_eq!(described(gone), None, "{gone}");
    }
    // Without a role nothing of the trim acts by it.
    let initial = |control| !table.initial_dependencies(OutputSlot::Control(control)).is_empty();
    assert_eq!([0, 1, 2, 3].map(initial), [true; 4]);
    let parameters = |control| {
        let known = table.initial_dependencies(OutputSlot::Control(control));
        known.iter().filter(|known| matches!(table.get(**known).unwrap().slot, Slot::Parameter(_))).count()
    };
    // Frequency and limits of its own actuator, and what the trim depends on.
    assert_eq!([0, 1, 2, 3].map(parameters), [3, 18, 3, 3]);
}

#[test]
fn names_are_unique_and_every_real_but_the_modal_coordinates_has_a_unit() {
    let table = table();
    let mut names = HashSet::new();
    for (_, variable) in table.iter() {
        assert!(names.insert(variable.name.clone()), "{} twice", variable.name);
        let has_unit = variable.kind == Type::Real && !variable.name.starts_with("modal.");
        assert_eq!(variable.unit.is_some(), has_unit, "{}", variable.name);
        assert!(!variable.description.is_empty(), "{}", variable.name);
    }
}

/// A unit's name is a product of powers of SI units, as every importer's grammar has it: `kg/m3` is kg m⁻³.
#[test]
fn every_unit_is_a_product_of_integer_powers_that_is_what_its_name_says() {
    for unit in Unit::ALL {
        let mut product = BaseUnit::default();
        let sides = [1, -1].into_iter().zip(unit.name().split('/'));
        for (sign, factors) in sides.flat_map(|(sign, side)| side.split('.').map(move |one| (sign, one))) {
            let symbol = factors.trim_end_matches(|c: char| c.is_ascii_digit());
            let power = sign * factors[symbol.len()..].parse::<i32>().unwrap_or(1);
            let BaseUnit { kilogram, metre, second, radian, kelvin } = match symbol {
                "kg" => BaseUnit { kilogram: 1, ..BaseUnit::default() },
                "m" => BaseUnit { metre: 1, ..BaseUnit::default() },
                "s" => BaseUnit { second: 1, ..BaseUnit::default() },
                "rad" => BaseUnit { radian: 1, ..BaseUnit::default() },
                "K" => BaseUnit { kelvin: 1, ..BaseUnit::default() },
                "N" => BaseUnit { kilogram: 1, metre: 1, second: -2, ..BaseUnit::default() },
                "Pa" => BaseUnit { kilogram: 1, metre: -1, second: -2, ..BaseUnit::default() },
                "" => BaseUnit::default(),
                other => panic!("{}: what is {other}?", unit.name()),
            };
            product.kilogram += power * kilogram;
            product.metre += power * metre;
            product.second += power * second;
            product.radian += power * radian;
            product.kelvin += power * kelvin;
        }
        assert_eq!(product, unit.base(), "{}", unit.name());
    }
}

#[test]
fn starts_are_those_of_the_contract_and_are_allowed() {
    let starts = [("airspeed", 127.0), ("altitude", 7620.0), ("stiffness_scale", 1.0), ("elevator", 0.0)];
    for (name, start) in starts {
        assert_eq!(row(name).start, Some(Value::Real(start)), "{name}");
    }
    for (name, start) in [("model", 1), ("input_reference", 1), ("mode_count", 12), ("inflow_states", 5)] {
        assert_eq!(row(name).start, Some(Value::Integer(start)), "{name}");
    }
    for (_, variable) in table().iter() {
        assert!(variable.start.is_none_or(|start| variable.allows(start)), "{}", variable.name);
    }
}

#[test]
fn airspeed_and_altitude_start_where_the_aircraft_file_says() {
    let model = ReducedModel { airspeed: 35.0, altitude: 1000.0, ..jet().clone() };
    let table = VariableTable::new(&model);
    for (name, start) in [("airspeed", 35.0), ("altitude", 1000.0)] {
        let row = table.get(table.reference(name).unwrap()).unwrap();
        assert_eq!(row.start, Some(Value::Real(start)), "{name}");
    }
}

#[test]
fn settings_start_from_the_aircrafts_own_flight_condition() {
    let model =
        ReducedModel { airspeed: 35.0, altitude: 1000.0, inflow_states: 3, ..jet().select(&[0, 1, 2]) };
    let PlantSettings { airspeed, altitude, inflow_states, mode_count, .. } = PlantSettings::of(&model);
    assert_eq!((airspeed, altitude, inflow_states, mode_count), (35.0, 1000.0, 3, 3));
}

#[test]
fn every_parameter_reads_back_what_was_set() {
    let model = jet_with_load_modes();
    let mut settings = Settings::of(&model);
    for (_, variable) in VariableTable::new(&model).iter() {
        let Slot::Parameter(slot) = variable.slot else { continue };
        let value = match variable.kind {
            Type::Real => Value::Real(0.03),
            Type::Integer => Value::Integer(3),
            Type::Enumeration(enumeration) => Value::Integer(enumeration.items().len() as i32),
            Type::Boolean => Value::Boolean(variable.start != Some(Value::Boolean(true))),
        };
        assert_ne!(
            slot.get(&settings),
            value,
            "{}: the test needs a value other than the start",
            variable.name
        );
        slot.set(&mut settings, value);
        assert_eq!(slot.get(&settings), value, "{}", variable.name);
    }
    assert_eq!(settings.plant.fidelity, Fidelity::GeometricallyExact);
}

#[test]
fn only_an_aircraft_with_load_modes_has_the_parameter_and_its_mode_count_counts_natural_modes() {
    let model = jet_with_load_modes();
    let table = VariableTable::new(&model);
    assert!(row("mode_count").max == Some(26.0) && self::table().named("load_modes").is_none());
    assert_eq!(table.named("mode_count").unwrap().max, Some(24.0));
    let load_modes = table.named("load_modes").unwrap();
    assert_eq!((load_modes.kind, load_modes.start), (Type::Boolean, Some(Value::Boolean(true))));
    assert_eq!(load_modes.allowed(), "true or false");
    let allows = [Value::Boolean(false), Value::Integer(1), Value::Real(1.0)].map(|v| load_modes.allows(v));
    assert_eq!(allows, [true, false, false]);
    assert!(!row("mode_count").allows(Value::Boolean(true)));
    for (mode, described) in [(24, false), (25, true), (26, true)] {
        for name in ["q", "q_dot"].map(|name| format!("modal.{name}[{mode}]")) {
            let text = &table.named(&name).unwrap().description;
            assert_eq!(text.contains("symmetric load mode"), described, "{text}");
        }
    }
    let Slot::Output(pitch) = row("trim.pitch").slot else { panic!("trim.pitch is no output") };
    assert!(table.initial_dependencies(pitch).contains(&table.reference("load_modes").unwrap()));
}

#[test]
fn of_all_angles_roll_yaw_track_and_angle_of_attack_jump_by_whole_turns() {
    let table = table();
    let mut found = Vec::new();
    for (_, variable) in table.iter() {
        let Slot::Output(slot) = variable.slot else { continue };
        if table.mirrored(slot).turns() {
            assert_eq!(variable.unit, Some(Unit::Radian), "{}", variable.name);
            found.push(variable.name.strip_prefix("sensor.").unwrap_or(&variable.name).to_owned());
        }
    }
    found.sort();
    let sensed = ["air.alpha", "attitude.roll", "attitude.yaw"].map(|name| [name; 2]);
    assert_eq!(found, [sensed.as_flattened(), &["path.track"]].concat());
}

#[test]
fn every_input_has_its_own_place() {
    let mut inputs = Inputs::zero(jet());
    let slots: Vec<_> = table()
        .iter()
        .filter_map(|(_, variable)| if let Slot::Input(slot) = variable.slot { Some(slot) } else { None })
        .collect();
    for (i, slot) in slots.iter().enumerate() {
        *slot.of(&mut inputs) = 1.0 + i as f64;
    }
    for (i, slot) in slots.iter().enumerate() {
        assert_eq!(slot.get(&inputs), 1.0 + i as f64, "{slot:?}");
    }
}

#[test]
fn enumerations_list_their_items_and_refuse_others() {
    let model = row("model");
    let names: Vec<_> = EnumerationType::Model.items().iter().map(|(name, _)| *name).collect();
    assert_eq!(names, Fidelity::ALL.map(Fidelity::name));
    assert!(model.allowed().contains("5 (rigid), 6 (geometrically_exact)"), "{}", model.allowed());
    for (value, allowed) in [(0, false), (1, true), (6, true), (7, false)] {
        assert_eq!(model.allows(Value::Integer(value)), allowed, "{value}");
    }
}

#[test]
fn nothing_allows_a_number_that_is_not_finite() {
    for (_, variable) in table().iter() {
        for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!variable.allows(Value::Real(number)), "{}: {number}", variable.name);
        }
    }
}

#[test]
fn states_do_not_depend_directly_on_inputs_but_accelerations_depend_on_all() {
    let table = table();
    let direct = |name: &str| {
        let Slot::Output(slot) = row(name).slot else { panic!("{name} is no output") };
        let names = table.dependencies(slot).into_iter().map(|r| table.get(r).unwrap().name.clone());
        names.collect::<Vec<_>>()
    };
    for state in [
        "position.down",
        "velocity.x",
        "rate.y",
        "deflection.wing_tip_left.up",
        "modal.q[1]",
        "trim.pitch",
        "station.vtail_tip.rate.x",
    ] {
        assert!(direct(state).is_empty(), "{state}");
    }
    for fed in ["acceleration.z", "load_factor.x", "station.wing_tip_left.specific_force.z"] {
        assert_eq!(direct(fed).len(), 12, "{fed}");
    }
    assert_eq!(direct("air.alpha"), ["wind_north", "wind_east", "wind_down"]);
    assert_eq!(direct("engine.right.thrust"), ["thrust_right"]);
}

#[test]
fn the_trim_depends_at_initialisation_on_what_defines_steady_flight() {
    let table = table();
    let dependencies = table.initial_dependencies(OutputSlot::TrimPitch);
    let names: Vec<_> = dependencies.iter().map(|r| table.get(*r).unwrap().name.as_str()).collect();
    let [condition, others]: [Vec<_>; 2] = [true, false]
        .map(|is| names.iter().copied().filter(|name| name.starts_with("condition.") == is).collect());
    let expected = "model airspeed altitude temperature_offset stiffness_scale mode_family mode_count";
    assert_eq!(others.join(" "), expected);
    assert_eq!(condition.len(), 7);
}

#[test]
fn a_sensors_channel_has_unit_and_dependencies_of_the_output_that_it_mirrors() {
    let table = table();
    let slot = |name: &str| match row(name).slot {
        Slot::Output(slot) => slot,
        _ => panic!("{name} is no output"),
    };
    for (channel, mirrored) in [
        ("sensor.air.alpha", "air.alpha"),
        ("sensor.station.wing_tip_left.specific_force.z", "station.wing_tip_left.specific_force.z"),
        ("sensor.position.down", "position.down"),
    ] {
        assert_eq!(row(channel).unit, row(mirrored).unit);
        assert_eq!(table.dependencies(slot(channel)), table.dependencies(slot(mirrored)), "{channel}");
        let (own, others) =
            (table.initial_dependencies(slot(channel)), table.initial_dependencies(slot(mirrored)));
        let extra = own.iter().filter(|known| !others.contains(known));
        // Enabled, seed and seven kinds of noise.
        assert!(extra.count() == 9 && others.iter().all(|known| own.contains(known)), "{channel}");
    }
    let flag = row("actuator.elevator.rate_limited");
    assert_eq!((flag.kind, flag.variability, flag.unit), (Type::Boolean, Variability::Discrete, None));
    assert_eq!(row("engine.left.time_constant").allowed(), "0 to 10000 s");
    let frequency = row("actuator.rudder.frequency");
    assert_eq!(frequency.allowed(), "0 or 0.001 to 1000 rad/s");
    let allows = [0.0, -0.0, 1e-3, 1000.0, 1e-300, 9e-4, -1.0].map(|x| frequency.allows(Value::Real(x)));
    assert_eq!(allows, [true, true, true, true, false, false, false]);
}
