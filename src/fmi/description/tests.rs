use super::*;
use crate::structure::test_jet::jet;
use crate::variables::VariableTable;

#[test]
fn the_guid_follows_the_content() {
    let first = token(Interface::USUAL, jet(), &Settings::of(jet()));
    assert_eq!(first, token(Interface::USUAL, &jet().clone(), &Settings::of(jet())));
    let mut renamed = jet().clone();
    renamed.stations[0].name = "elsewhere".into();
    assert_ne!(first, token(Interface::USUAL, &renamed, &Settings::of(jet())));
    let mut elsewhere = Settings::of(jet());
    elsewhere.tolerance = 1e-3;
    assert_ne!(first, token(Interface::USUAL, jet(), &elsewhere));
    assert_eq!(first.len(), 38);
    assert!(first.starts_with('{') && first.ends_with('}'), "{first}");
}

#[test]
fn the_model_description_is_reproducible_and_carries_the_guid() {
    let xml = write(Interface::USUAL, jet(), &Settings::of(jet()));
    assert_eq!(xml, write(Interface::USUAL, jet(), &Settings::of(jet())));
    assert!(xml.contains(&format!("guid=\"{}\"", token(Interface::USUAL, jet(), &Settings::of(jet())))));
    assert!(!xml.contains("generationDateAndTime"));
}

#[test]
fn every_variable_and_every_output_is_in_the_model_description() {
    let xml = write(Interface::USUAL, jet(), &Settings::of(jet()));
    let table = VariableTable::new(jet());
    assert_eq!(xml.matches("<ScalarVariable ").count(), table.iter().count());
    let outputs = table.iter().filter(|(_, v)| matches!(v.slot, crate::variables::Slot::Output(_))).count();
    assert_eq!(xml.matches("<Unknown ").count(), 2 * outputs);
}

#[test]
fn parameters_and_the_default_experiment_start_where_they_are_said_to() {
    let mut starts = Settings::of(jet());
    (starts.tolerance, starts.gust.gradient) = (1e-3, 45.0);
    let (usual, xml) =
        (write(Interface::USUAL, jet(), &Settings::of(jet())), write(Interface::USUAL, jet(), &starts));
    for (name, tag) in [("tolerance", "start=\"0.001\""), ("gust.gradient", "start=\"45\"")] {
        let of = |xml: &str| {
            let place = xml.find(&format!("name=\"{name}\"")).unwrap();
            xml[place..].split("</ScalarVariable>").next().unwrap().contains(tag)
        };
        assert!(of(&xml) && !of(&usual), "{name}");
    }
    assert!(xml.contains("stopTime=\"15\" tolerance=\"0.001\""));
}

#[test]
fn names_of_people_are_escaped_in_the_xml() {
    let mut model = jet().clone();
    model.name = "A<B & \"C\"".into();
    assert!(write(Interface::USUAL, &model, &Settings::of(&model)).contains("A&lt;B &amp; &quot;C&quot;"));
}

/// Rewritten with `UPDATE_GOLDEN=1 cargo test model_description`.
#[test]
fn the_checked_in_model_description_of_the_jet_is_current() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/modelDescription/modelDescription.xml");
    let current = write(Interface::USUAL, jet(), &Settings::of(jet()));
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        std::fs::write(path, &current).unwrap();
    }
    let checked_in = std::fs::read_to_string(path).unwrap_or_default();
    assert!(
        checked_in == current,
        "{path} is stale: rewrite it with UPDATE_GOLDEN=1 cargo test model_description"
    );
}
