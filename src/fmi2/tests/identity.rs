use super::*;
use crate::fmi2::model_description;

#[test]
fn the_guid_follows_the_content() {
    let first = guid(jet());
    assert_eq!(first, guid(&jet().clone()));
    let mut renamed = jet().clone();
    renamed.stations[0].name = "elsewhere".into();
    assert_ne!(first, guid(&renamed));
    assert_eq!(first.len(), 38);
    assert!(first.starts_with('{') && first.ends_with('}'), "{first}");
}

#[test]
fn the_model_description_is_reproducible_and_carries_the_guid() {
    let xml = model_description::write(jet());
    assert_eq!(xml, model_description::write(jet()));
    assert!(xml.contains(&format!("guid=\"{}\"", guid(jet()))));
    assert!(!xml.contains("generationDateAndTime"));
}

#[test]
fn every_variable_and_every_output_is_in_the_model_description() {
    let xml = model_description::write(jet());
    let table = VariableTable::new(jet());
    assert_eq!(xml.matches("<ScalarVariable ").count(), table.iter().count());
    let outputs = table.iter().filter(|(_, v)| matches!(v.slot, crate::variables::Slot::Output(_))).count();
    assert_eq!(xml.matches("<Unknown ").count(), 2 * outputs);
}

#[test]
fn names_of_people_are_escaped_in_the_xml() {
    let mut model = jet().clone();
    model.name = "A<B & \"C\"".into();
    assert!(model_description::write(&model).contains("A&lt;B &amp; &quot;C&quot;"));
}

/// For a look with FMPy: `FMI2_XML=/tmp/modelDescription.xml cargo test -- --ignored model_description`.
#[test]
#[ignore = "writes a file to look at"]
fn write_the_model_description_of_the_jet() {
    let path = std::env::var("FMI2_XML").unwrap();
    std::fs::write(path, model_description::write(jet())).unwrap();
}
