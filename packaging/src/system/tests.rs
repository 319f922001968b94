//! Small systems of made-up FMUs.

use super::*;
use crate::model_description::ModelDescription;

const PLANT: &str = r#"<fmiModelDescription fmiVersion="2.0" guid="p"><CoSimulation modelIdentifier="P"/>
    <UnitDefinitions><Unit name="rad"><BaseUnit rad="1"/></Unit></UnitDefinitions><TypeDefinitions>
    <SimpleType name="Model"><Enumeration><Item name="exact" value="1"/><Item name="rigid" value="5"/></Enumeration>
    </SimpleType></TypeDefinitions><ModelVariables>
    <ScalarVariable name="surface" valueReference="0" causality="input"><Real unit="rad" start="0"/></ScalarVariable>
    <ScalarVariable name="attitude.pitch" valueReference="1" causality="output"><Real unit="rad"/></ScalarVariable>
    <ScalarVariable name="name" valueReference="2" causality="output"><String/></ScalarVariable>
    <ScalarVariable name="inner" valueReference="3"><Real/></ScalarVariable>
    <ScalarVariable name="count" valueReference="4" causality="parameter"><Integer start="3"/></ScalarVariable>
    <ScalarVariable name="altitude" valueReference="5" causality="parameter"><Real unit="m" min="-1000" max="30000"/>
    </ScalarVariable>
    <ScalarVariable name="surface.surface" valueReference="7" causality="output"><Real unit="rad"/></ScalarVariable>
    <ScalarVariable name="model" valueReference="6" causality="parameter"><Enumeration declaredType="Model"/>
    </ScalarVariable>
    </ModelVariables></fmiModelDescription>"#;

const LAW: &str = r#"<fmiModelDescription fmiVersion="2.0" guid="l"><CoSimulation modelIdentifier="L"/>
    <UnitDefinitions><Unit name="Radiant"><BaseUnit rad="1"/></Unit>
    <Unit name="deg"><BaseUnit rad="1" factor="0.017453292519943295"/></Unit></UnitDefinitions><ModelVariables>
    <ScalarVariable name="pitch" valueReference="0" causality="input"><Real unit="Radiant"/></ScalarVariable>
    <ScalarVariable name="degrees" valueReference="1" causality="input"><Real unit="deg"/></ScalarVariable>
    <ScalarVariable name="steps" valueReference="2" causality="input"><Integer/></ScalarVariable>
    <ScalarVariable name="command" valueReference="3" causality="output"><Real/></ScalarVariable>
    </ModelVariables></fmiModelDescription>"#;

fn components() -> Vec<Component> {
    let component = |name: &str, xml: &str| Component {
        name: name.into(),
        fmu: xml.as_bytes().to_vec(),
        description: ModelDescription::parse(xml).unwrap(),
    };
    vec![component("plant", PLANT), component("law", LAW)]
}

/// A system with connections written as on the command line.
fn system(connections: &[&str], settings: &[&str]) -> Result<System, SystemError> {
    let halves = |text: &str| {
        let (left, right) = text.split_once('=').unwrap();
        (left.parse::<Endpoint>().unwrap(), right.to_owned())
    };
    let connections = connections.iter().map(|text| halves(text)).map(|(a, b)| (a, b.parse().unwrap()));
    let settings: Vec<_> = settings.iter().map(|text| halves(text)).collect();
    let experiment = Experiment { step: 0.01, stop_time: 2.0 };
    System::new(components(), &connections.collect::<Vec<_>>(), &settings, experiment)
}

#[track_caller]
fn check_refusal(connections: &[&str], settings: &[&str], reason: &str) {
    let error = system(connections, settings).unwrap_err().to_string();
    assert!(error.contains(reason), "{error}");
}

#[test]
fn the_output_comes_first_in_whichever_order_a_connection_is_given() {
    for connection in ["plant.attitude.pitch=law.pitch", "law.pitch=plant.attitude.pitch"] {
        let system = system(&[connection], &[]).unwrap();
        assert_eq!(system.connections[0].output.to_string(), "plant.attitude.pitch");
        assert_eq!(system.connections[0].input.to_string(), "law.pitch");
    }
}

/// `rad` and `Radiant` are made of the same base units, degrees are not; `law.command` does not say.
#[test]
fn units_agree_by_definition_and_silence_is_told() {
    assert_eq!(system(&["plant.attitude.pitch=law.pitch"], &[]).unwrap().units_taken_on_trust().count(), 0);
    check_refusal(&["plant.attitude.pitch=law.degrees"], &[], "the output is in rad, the input in deg");
    let silent = system(&["law.command=plant.surface"], &[]).unwrap();
    let ends: Vec<String> = silent.units_taken_on_trust().map(ToString::to_string).collect();
    assert_eq!(ends, ["law.command"]);
}

#[test]
fn what_does_not_fit_is_refused() {
    check_refusal(
        &["plant.attitude.pitch=law.steps"],
        &[],
        "output is of type Real, the input of type Integer",
    );
    check_refusal(
        &["plant.inner=law.pitch"],
        &[],
        "the local variable `plant.inner` and the input `law.pitch`",
    );
    check_refusal(&["plant.pitch=law.pitch"], &[], "the nearest are `attitude.pitch`");
    let twice = ["plant.attitude.pitch=law.pitch", "law.command=law.pitch"];
    check_refusal(
        &twice,
        &[],
        "law.command=law.pitch: the input `law.pitch` is fed by `plant.attitude.pitch`",
    );
    check_refusal(&["law.command=plant.surface"], &["plant.surface=1"], "connected or set already");
    check_refusal(&[], &["plant.count=2.5"], "an integer of 32 bits is allowed");
    check_refusal(&[], &["plant.surface=NaN"], "a finite number in rad is allowed");
}

#[test]
fn settings_keep_to_the_limits_of_the_variable() {
    let setting = |text: &str| system(&[], &[text]).map(|system| system.settings[0].value.clone());
    for value in ["-1000", "7620", "30000"] {
        assert_eq!(setting(&format!("plant.altitude={value}")).unwrap(), value);
    }
    check_refusal(&[], &["plant.altitude=35000"], "found the value `35000`; allowed is -1000 to 30000 m");
    check_refusal(&[], &["plant.altitude=-1001"], "allowed is -1000 to 30000 m");
    check_refusal(&[], &["plant.model=2"], "found the value `2`; allowed is 1 (exact), 5 (rigid)");
    check_refusal(&[], &["plant.model=rigit"], "5 (rigid), did you mean `rigid`?");
    check_refusal(&[], &["plant.altitude=1", "plant.altitude=2"], "connected or set already");
}

/// The law's `pitch` is in rad too, and no surface.
#[test]
fn a_surface_angle_in_degrees_is_refused() {
    check_refusal(
        &[],
        &["plant.surface=5"],
        "found the value `5`; allowed is -1.6 to 1.6 rad: inputs are rad; 5 looks like degrees",
    );
    for setting in ["plant.surface=-1.6", "law.pitch=3"] {
        system(&[], &[setting]).unwrap();
    }
}

#[test]
fn an_ssp_sets_enumerations_and_only_libcosims_own_structure_cannot() {
    for value in ["5", "rigid", "Rigid"] {
        let system = system(&[], &[&format!("plant.model={value}")]).unwrap();
        let ssp = String::from_utf8(ssp::structure(&system)).unwrap();
        assert!(ssp.contains(r#"<ssv:Enumeration value="rigid"/>"#), "{ssp}");
        let folder = tempfile::tempdir().unwrap();
        let refused = system.write_osp(&folder.path().join("osp")).unwrap_err().to_string();
        assert!(refused.starts_with("plant.model=rigid: libcosim has no enumerations"), "{refused}");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
        assert_eq!(system.enumerations_set().map(ToString::to_string).collect::<Vec<_>>(), ["plant.model"]);
    }
}

/// The annotation without which OMSimulator's command line aborts: the last element of the system.
#[test]
fn the_system_ends_with_the_annotation_of_omsimulator() {
    let ssp = String::from_utf8(ssp::structure(&system(&[], &[]).unwrap())).unwrap();
    let (system, _) = ssp.split_once("</ssd:System>").unwrap();
    let (_, annotations) = system.split_once("<ssd:Annotations>").unwrap();
    assert!(system.trim_end().ends_with("</ssd:Annotations>"), "{ssp}");
    for part in [
        r#"<ssc:Annotation type="org.openmodelica">"#,
        r#"<oms:FixedStepMaster description="oms-ma" stepSize="0.01" absoluteTolerance="0.0001" relativeTolerance="0.0001"/>"#,
    ] {
        assert!(annotations.contains(part), "{annotations}");
    }
}

#[test]
fn names_and_times_must_be_possible() {
    let experiment = |step, stop_time| System::new(components(), &[], &[], Experiment { step, stop_time });
    assert!(matches!(experiment(0.0, 1.0), Err(SystemError::Experiment(_))));
    assert!(matches!(experiment(0.1, f64::NAN), Err(SystemError::Experiment(_))));
    assert!(matches!(experiment(0.1, 0.05), Err(SystemError::Experiment(_))));
    let same = vec![components().remove(0), components().remove(0)];
    let twice = System::new(same, &[], &[], Experiment { step: 0.1, stop_time: 1.0 });
    assert!(matches!(twice, Err(SystemError::TwoComponents(name)) if name == "plant"));
    for name in ["", "a.b", "a/b", "ä"] {
        assert!(matches!(Component::read(name, Path::new("x.fmu")), Err(SystemError::ComponentName(_))));
    }
}

#[test]
fn both_descriptions_of_a_system_say_the_same() {
    let system = system(&["plant.attitude.pitch=law.pitch"], &["plant.count=5"]).unwrap();
    let ssp = String::from_utf8(ssp::structure(&system)).unwrap();
    let osp = String::from_utf8(osp::structure(&system)).unwrap();
    let in_ssp = [
        r#"<ssd:Component name="law" type="application/x-fmu-sharedlibrary" source="resources/law.fmu""#,
        r#"<ssd:Connection startElement="plant" startConnector="attitude.pitch" endElement="law" endConnector="pitch"/>"#,
        r#"<ssv:Integer value="5"/>"#,
        r#"<osp:FixedStepAlgorithm baseStepSize="0.01"/>"#,
        r#"<ssd:DefaultExperiment startTime="0" stopTime="2">"#,
    ];
    let in_osp = [
        r#"<Simulator name="law" source="law.fmu"/>"#,
        r#"<Variable simulator="plant" name="attitude.pitch"/>"#,
        r#"<Variable simulator="law" name="pitch"/>"#,
        r#"<Integer value="5"/>"#,
        "<BaseStepSize>0.01</BaseStepSize>",
    ];
    assert!(in_ssp.iter().all(|part| ssp.contains(part)), "{ssp}");
    assert!(in_osp.iter().all(|part| osp.contains(part)), "{osp}");
    // Texts are no numbers that a master could record, unconnected inputs keep their start values.
    for hidden in [r#"name="name""#, r#"name="surface""#, r#"name="degrees""#] {
        assert!(!ssp.contains(hidden), "{hidden}");
    }
}

const THIRD: &str = r#"<fmiModelDescription fmiVersion="3.0" instantiationToken="t">
    <ModelExchange modelIdentifier="T"/><UnitDefinitions><Unit name="rad"><BaseUnit rad="1"/></Unit></UnitDefinitions>
    <ModelVariables><Float64 name="pitch" valueReference="0" causality="input" unit="rad"/>
    <Float64 name="command" valueReference="1" causality="output" unit="rad"><Alias name="order"/></Float64>
    <Float64 name="all" valueReference="2" causality="output" unit="rad"><Dimension start="3"/></Float64>
    <Float32 name="single" valueReference="3" causality="output" unit="rad"/>
    <Float64 name="gains" valueReference="4" causality="parameter"><Dimension start="2"/></Float64>
    <UInt8 name="small" valueReference="5" causality="parameter" max="200"/>
    <Binary name="bytes" valueReference="6" causality="output"/></ModelVariables></fmiModelDescription>"#;

/// The plant, of FMI 2.0, and a law of FMI 3.0 for model exchange.
fn mixed(connections: &[&str], settings: &[&str]) -> Result<System, SystemError> {
    let halves = |text: &&str| {
        let (left, right) = text.split_once('=').unwrap();
        (left.parse::<Endpoint>().unwrap(), right.to_owned())
    };
    let mut components = components();
    components[1].description = ModelDescription::parse(THIRD).unwrap();
    let connections: Vec<_> = connections.iter().map(halves).map(|(a, b)| (a, b.parse().unwrap())).collect();
    let settings: Vec<_> = settings.iter().map(halves).collect();
    System::new(components, &connections, &settings, Experiment { step: 0.01, stop_time: 2.0 })
}

#[test]
fn a_component_of_fmi_3_makes_it_a_system_of_ssp_2_with_the_types_of_each() {
    let connections = ["plant.attitude.pitch=law.pitch", "law.order=plant.surface"];
    let system = mixed(&connections, &["law.small=7", "plant.count=5"]).unwrap();
    let ssp = String::from_utf8(ssp::structure(&system)).unwrap();
    for part in [
        r#"version="2.0" name="System">"#,
        r#"source="resources/plant.fmu" implementation="CoSimulation">"#,
        r#"source="resources/law.fmu" implementation="ModelExchange">"#,
        r#"startElement="law" startConnector="order" endElement="plant" endConnector="surface"/>"#,
        r#"<ssv:ParameterSet version="2.0" name="start">"#,
        r#"<ssv:UInt8 value="7"/>"#,
        r#"<ssv:Integer value="5"/>"#,
    ] {
        assert!(ssp.contains(part), "{part}: {ssp}");
    }
    let connector = |name: &str| {
        let (_, rest) = ssp.split_once(&format!(r#"name="{name}" kind="#)).unwrap();
        rest.lines().nth(1).unwrap().trim().to_owned()
    };
    for (name, kind) in
        [("attitude.pitch", "Real"), ("pitch", "Float64"), ("order", "Float64"), ("single", "Float32")]
    {
        assert_eq!(connector(name), format!("<ssc:{kind}/>"), "{name}");
    }
    // Arrays and bytes are no numbers that a master could record.
    assert!(!ssp.contains(r#"name="all""#) && !ssp.contains(r#"name="bytes""#), "{ssp}");
    let first = String::from_utf8(ssp::structure(&self::system(&[], &[]).unwrap())).unwrap();
    assert!(first.contains(r#"version="1.0" name="System">"#), "{first}");
}

#[test]
fn arrays_and_other_types_of_fmi_3_are_refused_with_what_they_are() {
    for (connection, setting, reason) in [
        ("law.all=plant.surface", "", "found the output `law.all`, an array of 3; a connection"),
        ("law.single=plant.surface", "", "output is of type Float32, the input of type Real"),
        ("", "law.gains=1", "found the parameter `law.gains`, an array of 2"),
        ("", "law.small=256", "allowed is 200 and below"),
        ("", "law.small=-1", "allowed is 200 and below"),
    ] {
        let of = |text: &'static str| if text.is_empty() { vec![] } else { vec![text] };
        let error = mixed(&of(connection), &of(setting)).unwrap_err().to_string();
        assert!(error.contains(reason), "{error}");
    }
}

#[test]
fn libcosims_own_structure_takes_fmi_2_for_co_simulation_alone() {
    let refused = mixed(&[], &[]).unwrap().check_for_osp().unwrap_err().to_string();
    let expected = "`law` is an FMU of FMI 3.0 model exchange: libcosim takes FMI 2.0 co-simulation, ";
    assert!(refused.starts_with(expected), "{refused}");
}
