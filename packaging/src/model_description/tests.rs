//! Small descriptions of both versions.

use flexible_aircraft::fmi::{Interface, Kind, Version};

use super::*;

#[test]
fn guid_library_and_variables_are_found() {
    let xml = r#"<?xml version="1.0"?><fmiModelDescription fmiVersion="2.0" guid="{a&amp;b}" version="1.2">
        <CoSimulation modelIdentifier="Plane"/><ModelVariables>
        <ScalarVariable name="modal.q[1]" valueReference="7" causality="output" description="&lt;"><Real/>
        </ScalarVariable><ScalarVariable name="airspeed" valueReference="8" causality="parameter">
        <Real unit="m/s" start="127"/></ScalarVariable></ModelVariables></fmiModelDescription>"#;
    let description = ModelDescription::parse(xml).unwrap();
    assert_eq!(description.token, "{a&b}");
    assert_eq!((description.version.as_str(), description.description.as_str()), ("1.2", ""));
    assert_eq!(description.model_identifier, "Plane");
    let mode = description.variable("modal.q[1]").unwrap();
    assert_eq!((mode.value_reference, mode.description.as_str()), (7, "<"));
    let airspeed = description.variable("airspeed").unwrap();
    assert_eq!((airspeed.unit.as_str(), airspeed.start.as_str()), ("m/s", "127"));
    assert_eq!(description.variable("altitude"), None);
}

#[test]
fn units_are_known_by_what_they_are_made_of_and_inherited_from_types() {
    let xml = r#"<fmiModelDescription fmiVersion="2.0" guid="g"><CoSimulation modelIdentifier="M"/>
        <UnitDefinitions><Unit name="deg"><BaseUnit rad="1" factor="0.0174532925199433"/></Unit>
        <Unit name="rad"><BaseUnit rad="1"/></Unit><Unit name="Radiant"><BaseUnit rad="1"/></Unit>
        <Unit name="odd"/></UnitDefinitions>
        <TypeDefinitions><SimpleType name="Angle"><Real unit="rad"/></SimpleType></TypeDefinitions>
        <ModelVariables><ScalarVariable name="a" valueReference="1"><Real declaredType="Angle"/></ScalarVariable>
        <ScalarVariable name="b" valueReference="2"><Boolean/></ScalarVariable></ModelVariables>
        </fmiModelDescription>"#;
    let description = ModelDescription::parse(xml).unwrap();
    assert_eq!(description.variable("a").unwrap().unit, "rad");
    assert_eq!(description.variable("b").unwrap().kind, VariableType::Boolean);
    assert_eq!(description.variable("b").unwrap().items, []);
    assert_eq!(description.base_unit("rad"), description.base_unit("Radiant"));
    assert_ne!(description.base_unit("rad"), description.base_unit("deg"));
    assert_eq!((description.base_unit("odd"), description.base_unit("none")), (None, None));
}

#[test]
fn limits_and_items_are_those_of_the_variable_or_its_type() {
    let xml = r#"<fmiModelDescription fmiVersion="2.0" guid="g"><CoSimulation modelIdentifier="M"/>
        <TypeDefinitions><SimpleType name="Speed"><Real unit="m/s" min="1" max="9"/></SimpleType>
        <SimpleType name="Level"><Enumeration><Item name="low" value="1"/><Item name="high" value="3"/>
        </Enumeration></SimpleType></TypeDefinitions>
        <ModelVariables><ScalarVariable name="a" valueReference="1"><Real declaredType="Speed" max="7"/></ScalarVariable>
        <ScalarVariable name="b" valueReference="2"><Enumeration declaredType="Level"/></ScalarVariable>
        </ModelVariables></fmiModelDescription>"#;
    let description = ModelDescription::parse(xml).unwrap();
    let speed = description.variable("a").unwrap();
    assert_eq!((speed.unit.as_str(), speed.min.as_str(), speed.max.as_str()), ("m/s", "1", "7"));
    let level = description.variable("b").unwrap();
    let items: Vec<(&str, &str)> = level.items.iter().map(|(name, value)| (&**name, &**value)).collect();
    assert_eq!(items, [("low", "1"), ("high", "3")]);
}

#[test]
fn a_variable_without_value_reference_is_refused() {
    let error = ModelDescription::parse(r#"<ScalarVariable name="x"/>"#).unwrap_err();
    assert_eq!(error, "<ScalarVariable> has no attribute valueReference");
}

#[test]
fn another_version_of_the_standard_is_refused() {
    let error = ModelDescription::parse(r#"<fmiModelDescription fmiVersion="1.0"/>"#).unwrap_err();
    assert_eq!(error, "found FMI version 1.0, allowed are 2.0 and 3.0");
}

#[test]
fn an_fmu_is_what_it_has_an_element_for_and_one_for_co_simulation_where_it_has_both() {
    let kind = |version: &str, elements: &str| {
        let xml = format!(
            r#"<fmiModelDescription fmiVersion="{version}" guid="g" instantiationToken="t">{elements}</fmiModelDescription>"#
        );
        ModelDescription::parse(&xml).map(|found| (found.interface, found.model_identifier, found.token))
    };
    let exchange = r#"<ModelExchange modelIdentifier="E"/>"#;
    let both = format!(r#"{exchange}<CoSimulation modelIdentifier="C"/>"#);
    let of = |version, kind| Interface { version, kind };
    for (number, version, token) in [("2.0", Version::V2, "g"), ("3.0.2", Version::V3, "t")] {
        let found = kind(number, exchange).unwrap();
        assert_eq!(found, (of(version, Kind::ModelExchange), "E".into(), token.into()));
        let found = kind(number, &both).unwrap();
        assert_eq!(found, (of(version, Kind::CoSimulation), "C".into(), token.into()));
        let error = kind(number, "").unwrap_err();
        assert_eq!(error, "no element CoSimulation and none ModelExchange");
    }
}

const THIRD: &str = r#"<fmiModelDescription fmiVersion="3.0" instantiationToken="t">
    <ModelExchange modelIdentifier="M"/><UnitDefinitions><Unit name="rad"><BaseUnit rad="1"/></Unit></UnitDefinitions>
    <TypeDefinitions><Float64Type name="Angle" unit="rad" min="-2" max="2"/>
    <EnumerationType name="Level"><Item name="low" value="1"/><Item name="high" value="3"/></EnumerationType></TypeDefinitions>
    <ModelVariables><Float64 name="time" valueReference="9" causality="independent"/>
    <Float64 name="pitch" valueReference="1" causality="output" declaredType="Angle" max="1" description="up">
      <Annotations><Annotation type="x"><Float64 name="none" valueReference="1"/></Annotation></Annotations>
      <Alias name="theta" description="the same"/><Alias name="nose"/></Float64>
    <Enumeration name="level" valueReference="2" causality="parameter" declaredType="Level" start="3"/>
    <UInt64 name="n" valueReference="3" causality="structuralParameter" start="4"/>
    <Float64 name="matrix" valueReference="4" causality="input" start="0 0 0 0"><Dimension start="2"/>
      <Dimension valueReference="3"/><Alias name="other"/></Float64>
    <String name="file" valueReference="5" causality="parameter"><Start value="a.txt"/></String>
    <Float64 name="q" valueReference="6"/><Float64 name="der(q)" valueReference="7" derivative="6"/></ModelVariables>
    <ModelStructure><Output valueReference="1"/><ContinuousStateDerivative valueReference="7"/>
    <InitialUnknown valueReference="7"/></ModelStructure></fmiModelDescription>"#;

#[test]
fn variables_of_fmi_3_have_their_types_limits_and_further_names() {
    let found = ModelDescription::parse(THIRD).unwrap();
    let names: Vec<&str> = found.variables.iter().map(|variable| variable.name.as_str()).collect();
    let expected = "time pitch theta nose level n matrix other file q der(q)";
    assert_eq!(names.join(" "), expected);
    let pitch = found.variable("pitch").unwrap();
    assert_eq!((pitch.kind, pitch.value_reference, &*pitch.causality), (VariableType::Float64, 1, "output"));
    assert_eq!((&*pitch.unit, &*pitch.min, &*pitch.max), ("rad", "-2", "1"));
    let expected = Variable { name: "theta".into(), description: "the same".into(), ..pitch.clone() };
    assert_eq!(found.variable("theta"), Some(&expected));
    assert_eq!(found.variable("nose").unwrap().description, "up");
    let level = found.variable("level").unwrap();
    assert_eq!((level.kind, &*level.start, level.items.len()), (VariableType::Enumeration, "3", 2));
    assert_eq!(found.variable("file").unwrap().kind, VariableType::String);
}

#[test]
fn arrays_are_known_with_their_dimensions() {
    let found = ModelDescription::parse(THIRD).unwrap();
    let dimensions = |name: &str| found.dimensions(found.variable(name).unwrap());
    assert_eq!(dimensions("pitch"), None);
    for name in ["matrix", "other"] {
        assert_eq!(dimensions(name).as_deref(), Some("2 × n"));
    }
}

#[test]
fn states_are_counted_by_their_derivatives() {
    assert_eq!(ModelDescription::parse(THIRD).unwrap().states, 1);
    let second = r#"<fmiModelDescription guid="g"><ModelExchange modelIdentifier="M"/><ModelStructure><Outputs>
        <Unknown index="1"/></Outputs><Derivatives><Unknown index="4"/><Unknown index="5"/></Derivatives>
        <InitialUnknowns><Unknown index="2"/></InitialUnknowns></ModelStructure></fmiModelDescription>"#;
    assert_eq!(ModelDescription::parse(second).unwrap().states, 2);
}
