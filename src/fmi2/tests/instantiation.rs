use super::*;

/// A request that succeeds, changed by the caller, and the log of its failure.
fn refusal(change: impl FnOnce(&mut Request)) -> Message {
    let unpacked = Unpacked::new("jet");
    let (guid, uri) = (guid(jet()), unpacked.uri("jet"));
    let mut request =
        Request { name: Some("jet"), kind: 1, guid: Some(&guid), uri: Some(&uri), logging_on: false };
    change(&mut request);
    let fmu = Fmu::request(&request);
    assert!(fmu.component.is_null());
    let message = fmu.last_message();
    assert_eq!(message.status, Status::Error);
    message
}

#[test]
fn a_wrong_guid_is_refused_and_both_are_shown() {
    let text = refusal(|request| request.guid = Some("{wrong}")).format;
    assert!(text.contains("{wrong}") && text.contains(&guid(jet())), "{text}");
}

#[test]
fn missing_arguments_are_refused() {
    for (text, part) in [
        (refusal(|request| request.name = Some("")).format, "instance name"),
        (refusal(|request| request.name = None).format, "instance name"),
        (refusal(|request| request.guid = None).format, "guid"),
        (refusal(|request| request.uri = None).format, "resource location"),
        (
            refusal(|request| request.kind = 7).format,
            "allowed are fmi2ModelExchange (0) and fmi2CoSimulation (1)",
        ),
        (refusal(|request| request.kind = 0).format, "co-simulation, not FMI 2.0 model exchange"),
    ] {
        assert!(text.contains(part), "{text}");
    }
}

#[test]
fn missing_resources_are_refused_with_the_path() {
    let text = refusal(|request| request.uri = Some("file:///no/such/resources")).format;
    assert!(text.contains("/no/such/resources/model.bin"), "{text}");
}

#[test]
fn damaged_resources_are_refused_with_the_path() {
    let unpacked = Unpacked::new("jet");
    let path = unpacked.0.join("jet/resources").join(RESOURCE_FILE);
    std::fs::write(&path, b"no model").unwrap();
    let (guid, uri) = (guid(jet()), unpacked.uri("jet"));
    let fmu = Fmu::request(&Request {
        name: Some("jet"),
        kind: 1,
        guid: Some(&guid),
        uri: Some(&uri),
        logging_on: false,
    });
    assert!(fmu.component.is_null());
    let text = fmu.last_message().format;
    assert!(text.contains(path.to_str().unwrap()), "{text}");
}

#[test]
fn missing_callbacks_give_no_instance() {
    // SAFETY: NULL is allowed everywhere here.
    assert!(unsafe { fmi2Instantiate(null(), 1, null(), null(), null(), 0, 0) }.is_null());
}

#[test]
fn directories_with_spaces_accents_and_braces_are_found() {
    let name = "a b {é}%";
    let unpacked = Unpacked::new(name);
    let written = [name.to_owned(), name.replace('%', "%25").replace(' ', "%20").replace('é', "%C3%A9")];
    for name in written {
        for uri in [unpacked.uri(&name), unpacked.uri(&name) + "/", unpacked.uri(&name).replace("//", "")] {
            let guid = guid(jet());
            let request = Request {
                name: Some("a/b c%s"),
                kind: 1,
                guid: Some(&guid),
                uri: Some(&uri),
                logging_on: false,
            };
            let fmu = Fmu::request(&request);
            assert!(!fmu.component.is_null(), "{uri}: {:?}", fmu.log);
        }
    }
}

/// `é` in Latin-1: a byte that is no UTF-8, percent-encoded and as it is.
#[test]
#[cfg(target_os = "linux")]
fn a_resource_path_of_bytes_that_are_not_utf8_opens() {
    use std::os::unix::ffi::OsStringExt;
    let unpacked = Unpacked::new("jet");
    let folder = unpacked.0.join(std::ffi::OsString::from_vec(b"caf\xE9".to_vec()));
    std::fs::rename(unpacked.0.join("jet"), folder).unwrap();
    let guid = CString::new(guid(jet())).unwrap();
    let callbacks = no_callbacks();
    for name in [&b"caf%E9"[..], b"caf\xE9"] {
        let root = format!("file://{}/", unpacked.0.display());
        let uri = CString::new([root.as_bytes(), name, b"/resources"].concat()).unwrap();
        // SAFETY: strings and callbacks live during the call.
        let component = unsafe {
            fmi2Instantiate(c"jet".as_ptr(), 1, guid.as_ptr(), uri.as_ptr(), &raw const callbacks, 0, 0)
        };
        assert!(!component.is_null(), "{uri:?}");
        // SAFETY: it is an instance that is not used any more.
        unsafe { fmi2FreeInstance(component) };
    }
}

#[test]
fn no_text_of_the_user_is_a_format() {
    let text = refusal(|request| request.guid = Some("%s%n")).format;
    assert!(text.contains("%%s%%n") && !text.replace("%%", "").contains('%'), "{text}");
}

#[test]
fn the_logger_gets_only_the_chosen_categories() {
    let unpacked = Unpacked::new("jet");
    let (guid, uri) = (guid(jet()), unpacked.uri("jet"));
    let request =
        Request { name: Some("jet"), kind: 1, guid: Some(&guid), uri: Some(&uri), logging_on: true };
    let fmu = Fmu::request(&request);
    assert_eq!(fmu.last_message().category, "logEvents");
    assert_eq!(fmu.last_message().instance, "jet");
    let choose = |on: c_int, categories: &[&CStr]| {
        let pointers: Vec<_> = categories.iter().map(|text| text.as_ptr()).collect();
        fmu.log.borrow_mut().clear();
        // SAFETY: the component is alive, the array is as long as said.
        unsafe { fmi2SetDebugLogging(fmu.component, on, pointers.len(), pointers.as_ptr()) }
    };
    // SAFETY: the component is alive.
    let reset_and_refuse = || unsafe { (fmi2Reset(fmu.component), fmi2CancelStep(fmu.component)) };
    for (on, categories, heard) in [
        (1, &[c"logEvents"][..], &["logEvents"][..]),
        (1, &[c"logStatusError"], &["logStatusError"]),
        (1, &[], &["logEvents", "logStatusError"]),
        (0, &[], &["logStatusError"]),
        (1, &[c"logAll"], &["logEvents", "logStatusError"]),
    ] {
        assert_eq!(choose(on, categories), Status::Ok);
        assert_eq!(reset_and_refuse(), (Status::Ok, Status::Error));
        let categories: Vec<_> = fmu.log.borrow().iter().map(|message| message.category.clone()).collect();
        assert_eq!(categories, heard);
    }
    assert_eq!(choose(1, &[c"logNothing"]), Status::Error);
    fmu.assert_refused(&["logNothing", "logStatusWarning"]);
}

#[test]
fn versions_are_those_of_the_standard() {
    // SAFETY: both are NUL-terminated constants.
    let texts = [fmi2GetVersion(), fmi2GetTypesPlatform()].map(|text| unsafe { CStr::from_ptr(text) });
    assert_eq!(texts, [c"2.0", c"default"]);
}
