//! Which instances come into being, and what the log says of others.

use super::*;

/// A request that is refused, with parts of the reason.
fn refuse(request: &Request, parts: &[&str]) {
    let fmu = Fmu::request(request, jet());
    assert!(fmu.instance.is_null(), "{request:?}");
    fmu.assert_refused(parts);
}

#[test]
fn tokens_paths_and_callbacks_out_of_reason_are_refused_also_without_logging() {
    let resources = Resources::of(jet());
    for kind in [Kind::CoSimulation, Kind::ModelExchange] {
        let good = Request::of(kind, jet(), &resources);
        let own = good.token.clone().unwrap();
        refuse(&Request { token: None, ..good.clone() }, &["instantiation token: found NULL"]);
        let foreign = Some("{0}".to_owned());
        refuse(&Request { token: foreign, ..good.clone() }, &["`{0}`", "this FMU is `", &own]);
        refuse(&Request { path: None, ..good.clone() }, &["resource path: found NULL"]);
        let nowhere = Some("/nowhere/at/all".to_owned());
        refuse(&Request { path: nowhere, ..good.clone() }, &["`/nowhere/at/all`, which is no folder"]);
        let host = Some("file://server/x".to_owned());
        refuse(&Request { path: host, ..good }, &["the host is `server`"]);
    }
    let good = Request::of(Kind::CoSimulation, jet(), &resources);
    refuse(&Request { event_mode_used: 1, ..good.clone() }, &["eventModeUsed: found true"]);
    refuse(
        &Request { intermediate_variables: 3, ..good.clone() },
        &["nRequiredIntermediateVariables: found 3"],
    );
    refuse(
        &Request { kind: Kind::ModelExchange, ..good },
        &["fmi3InstantiateModelExchange: this archive is FMI 3.0 co-simulation, not FMI 3.0 model exchange"],
    );
}

#[test]
fn the_path_of_the_resources_is_taken_as_it_is_and_of_early_importers_as_a_uri() {
    let resources = Resources::of(jet());
    let request = Request::of(Kind::CoSimulation, jet(), &resources);
    for path in [resources.path(), resources.path() + "/", format!("file://{}", resources.path())] {
        let fmu = Fmu::request(&Request { path: Some(path.clone()), ..request.clone() }, jet());
        assert!(!fmu.instance.is_null(), "{path}: {:?}", fmu.log);
    }
    // A path that has what would be an escape in a URI.
    let odd = Resources(resources.0.with_file_name(format!("fmi3 %41 {}", std::process::id())));
    std::fs::create_dir_all(&odd.0).unwrap();
    std::fs::copy(resources.0.join(RESOURCE_FILE), odd.0.join(RESOURCE_FILE)).unwrap();
    let fmu = Fmu::request(&Request { path: Some(odd.path()), ..request }, jet());
    assert!(!fmu.instance.is_null(), "{:?}", fmu.log);
}

#[test]
fn scheduled_execution_is_refused_with_its_reason() {
    let log: Box<Log> = Box::default();
    let environment = (&raw const *log).cast_mut().cast();
    let name = c"x".as_ptr();
    // SAFETY: strings and log live during the call.
    let instance = unsafe {
        fmi3InstantiateScheduledExecution(name, name, name, 0, 0, environment, Some(logger), None, None, None)
    };
    assert!(instance.is_null());
    assert!(log.borrow()[0].text.contains("no clocks"), "{log:?}");
}

#[test]
fn number_signs_in_messages_are_doubled() {
    let resources = Resources::of(jet());
    let good = Request::of(Kind::CoSimulation, jet(), &resources);
    refuse(&Request { token: Some("a#b".to_owned()), ..good }, &["`a##b`"]);
    // SAFETY: the version is a string.
    assert_eq!(unsafe { CStr::from_ptr(fmi3GetVersion()) }, c"3.0");
}
