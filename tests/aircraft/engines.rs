//! Engines of an aircraft file: torque, angular momentum, shares of the thrust.

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::structure::ReducedModel;

const JET: &str = include_str!("../../aircraft/generic-business-jet.toml");

/// The jet with more said of its left and of its right engine.
fn with_engines(left: &str, right: &str) -> String {
    let mut text = JET.to_owned();
    for (name, more) in [("left", left), ("right", right)] {
        let engine = format!("[[engine]]\nname = \"{name}\"");
        assert!(text.contains(&engine));
        text = text.replacen(&engine, &format!("{engine}\n{more}"), 1);
    }
    text
}

/// What is said of a file.
fn messages(text: &str) -> Vec<String> {
    let error = Aircraft::parse(text, "jet.toml").unwrap_err();
    error.diagnostics().iter().map(ToString::to_string).collect()
}

fn is_refused_with(text: &str, expected: &str) {
    let said = messages(text);
    assert!(said.iter().any(|message| message.contains(expected)), "{said:#?}");
}

#[test]
fn torque_momentum_and_share_come_with_the_reduced_engine_through_its_bytes() {
    let text = with_engines(
        "torque_m = 0.2\nangular_momentum_kg_m2_s = -90\ntrim_share = 2",
        "torque_m = -0.2\nangular_momentum_kg_m2_s = 90\ntrim_share = 2",
    );
    let model = ReducedModel::new(&Aircraft::parse(&text, "jet.toml").unwrap(), 4).unwrap();
    let found = ReducedModel::from_bytes(&model.to_bytes()).unwrap();
    let engines = found.engines.iter().map(|e| [e.torque, e.angular_momentum, e.trim_share]);
    assert_eq!(engines.collect::<Vec<_>>(), [[0.2, -90.0, 2.0], [-0.2, 90.0, 2.0]]);
    let usual = ReducedModel::new(&Aircraft::parse(JET, "jet.toml").unwrap(), 4).unwrap();
    assert!(usual.engines.iter().all(|e| [e.torque, e.angular_momentum, e.trim_share] == [0.0, 0.0, 1.0]));
}

#[test]
fn with_symmetric_mirrored_engines_turn_opposite_ways() {
    let momentum = "angular_momentum_kg_m2_s = 90";
    is_refused_with(
        &with_engines(momentum, momentum),
        "found angular_momentum_kg_m2_s = 90 of the engine \"left\", and 90 of its mirror image \"right\", while symmetric = true; \
         -90 is allowed, or symmetric = false",
    );
    is_refused_with(
        &with_engines("torque_m = 0.1", ""),
        "found torque_m = 0.1 of the engine \"left\", and 0 of its mirror image \"right\", while symmetric = true; 0 is allowed",
    );
    is_refused_with(
        &with_engines("trim_share = 2", ""),
        "found trim_share = 2 of the engine \"left\", and 1 of its",
    );
    let free = with_engines(momentum, momentum).replace("symmetric = true", "symmetric = false");
    assert!(Aircraft::parse(&free, "jet.toml").is_ok());
}

#[test]
fn with_symmetric_an_engine_in_the_plane_turns_nothing() {
    let begin = JET.find("[[engine]]").unwrap();
    let end = begin + JET[begin..].find("[[station]]").unwrap();
    let engine =
        "[[engine]]\nname = \"nose\"\ncomponent = \"fuselage_aft\"\nat_m = 4.9\ndirection = [1, 0, 0]\n";
    let with = |more: &str| format!("{}{engine}{more}\n\n{}", &JET[..begin], &JET[end..]);
    assert!(Aircraft::parse(&with(""), "jet.toml").is_ok());
    is_refused_with(
        &with("angular_momentum_kg_m2_s = 5"),
        "found angular_momentum_kg_m2_s = 5 of the engine \"nose\" in the plane y = 0, while symmetric = true; 0 is allowed there",
    );
    is_refused_with(&with("torque_m = -0.1"), "found torque_m = -0.1 of the engine \"nose\" in the plane");
}

#[test]
fn what_is_odd_of_an_engine_is_all_told_where_it_stands() {
    let turning = "torque_m = 0.2\nangular_momentum_kg_m2_s = 90";
    let text = with_engines(turning, turning);
    let error = Aircraft::parse(&text, "jet.toml").unwrap_err();
    let told: Vec<_> =
        error.diagnostics().iter().map(|d| (d.field.as_str(), &text[d.span.clone()])).collect();
    let expected =
        ["left", "right"].map(|_| [("torque_m", "0.2"), ("angular_momentum_kg_m2_s", "90")]).concat();
    assert_eq!(told.len(), expected.len(), "{told:?}");
    for ((field, value), (ending, expected)) in told.into_iter().zip(expected) {
        assert!(field.ends_with(ending) && value == expected, "{field}: {value}");
    }
}

#[test]
fn some_engine_has_thrust_in_trims() {
    is_refused_with(
        &with_engines("trim_share = 0", "trim_share = 0"),
        "found trim_share = 0 of all engines: none has thrust in trims; more than 0 is allowed of one at least",
    );
}
