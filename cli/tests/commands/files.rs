//! Files are written whole or not at all, and never over what was read.

use std::path::Path;

use crate::support::{flexair, library, names, run, text, workspace};

/// Outputs that are inputs, by another path than the input's.
#[test]
fn every_command_refuses_an_output_that_is_an_input() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let fmu = run(path, &format!("package --no-check --modes 2 --binary {} --output a.fmu", library()));
    assert!(fmu.status.success(), "{}", text(&fmu.stderr));
    std::fs::copy(workspace("aircraft/generic-business-jet.toml"), path.join("jet.toml")).unwrap();
    std::fs::write(path.join("inputs.csv"), "time\n0\n0.1\n").unwrap();
    std::fs::hard_link(path.join("jet.toml"), path.join("hard.toml")).unwrap();
    std::fs::hard_link(path.join("jet.toml"), path.join("hard-worst.csv")).unwrap();
    std::fs::hard_link(path.join("inputs.csv"), path.join("jet-nodes.csv")).unwrap();
    std::fs::copy(path.join("a.fmu"), path.join("law.fmu")).unwrap();
    std::fs::write(path.join("lib.so"), "a library").unwrap();
    let library = format!("{}=lib.so", library().split('=').next().unwrap());
    let contents = |path: &Path| {
        names(path).iter().map(|name| std::fs::read(path.join(name)).unwrap()).collect::<Vec<_>>()
    };
    let before = (names(path), contents(path));
    let lines = [
        "simulate inputs.csv --output ./inputs.csv".to_owned(),
        "simulate inputs.csv --output missing/../inputs.csv".to_owned(),
        "simulate inputs.csv --output flight.csv --plot ./inputs.csv".to_owned(),
        "ssp a.fmu --output missing/../a.fmu".to_owned(),
        "merge a.fmu law.fmu --output missing/../law.fmu".to_owned(),
        "simulate inputs.csv --aircraft jet.toml --output hard.toml".to_owned(),
        "package --aircraft jet.toml --output hard.toml".to_owned(),
        "gust hard.toml --output .".to_owned(),
        "loads inputs.csv --aircraft jet.toml --output missing/..".to_owned(),
        format!("package --aircraft jet.toml --binary {library} --output ./lib.so"),
        "ssp a.fmu --output ./a.fmu".to_owned(),
        "ssp a.fmu --component law=law.fmu --output ./law.fmu".to_owned(),
        "ssp a.fmu --component law=law.fmu --osp .".to_owned(),
        "ssp a.fmu --osp osp --output osp/OspSystemStructure.xml".to_owned(),
        "merge a.fmu law.fmu --output ./law.fmu".to_owned(),
        "bench --fmu a.fmu --output ./a.fmu".to_owned(),
        "bench --fmu a.fmu --aircraft jet.toml --plot hard.toml".to_owned(),
        "bench --fmu a.fmu --output same --plot ./same".to_owned(),
    ];
    for line in &lines {
        let refused = run(path, line);
        let errors = text(&refused.stderr);
        assert_eq!(refused.status.code(), Some(1), "{line}: {errors}");
        assert!(
            errors.contains("would be lost") || errors.contains("twice among the outputs"),
            "{line}: {errors}"
        );
        assert!((names(path), contents(path)) == before, "{line} changed a file");
    }
}

#[test]
fn standard_input_that_is_the_output_is_refused_too() {
    let folder = tempfile::tempdir().unwrap();
    let inputs = folder.path().join("inputs.csv");
    std::fs::write(&inputs, "time\n0\n").unwrap();
    let mut command = flexair(folder.path(), "simulate - --output inputs.csv");
    let refused = command.stdin(std::fs::File::open(&inputs).unwrap()).output().unwrap();
    assert!(
        text(&refused.stderr).contains("the output inputs.csv is the same file as the input standard input"),
        "{refused:?}"
    );
    assert_eq!(std::fs::read_to_string(&inputs).unwrap(), "time\n0\n");
}

#[test]
fn a_picture_does_not_go_to_standard_output() {
    let folder = tempfile::tempdir().unwrap();
    for line in [
        "simulate --modes 2 --duration 0.1 --output flight.csv --plot -",
        "describe --modes 2 --plot -",
        "bench --plot -",
    ] {
        let refused = run(folder.path(), line);
        let errors = text(&refused.stderr);
        assert_eq!((refused.status.code(), text(&refused.stdout).as_str()), (Some(2), ""), "{line}");
        assert!(
            errors.contains("invalid value '-' for '--plot <FILE>': allowed is the path of a file: pictures"),
            "{line}: {errors}"
        );
        assert_eq!(names(folder.path()), [""; 0], "{line}");
    }
    let named = run(folder.path(), "simulate --modes 2 --duration 0.1 --output flight.csv --plot ./-");
    assert!(named.status.success(), "{}", text(&named.stderr));
    assert_eq!(names(folder.path()), ["-", "flight.csv"]);
}

/// Wind from behind ends the flight at the second row.
#[test]
fn a_flight_that_fails_keeps_what_was_flown_in_a_file_that_says_so() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("inputs.csv"), "time,wind_north\n0,0\n0.01,400\n0.02,0\n").unwrap();
    std::fs::write(folder.path().join("flight.csv"), "a good one").unwrap();
    let failed = run(folder.path(), "simulate inputs.csv --output flight.csv");
    assert_eq!(failed.status.code(), Some(1));
    let errors = text(&failed.stderr);
    assert!(errors.contains("; what was flown until then is in flight.unfinished.csv"), "{errors}");
    assert_eq!(names(folder.path()), ["flight.csv", "flight.unfinished.csv", "inputs.csv"]);
    assert_eq!(std::fs::read_to_string(folder.path().join("flight.csv")).unwrap(), "a good one");
    let rows = std::fs::read_to_string(folder.path().join("flight.unfinished.csv")).unwrap();
    assert_eq!(rows.lines().count(), 3);
}

#[test]
fn files_that_are_not_found_say_where_they_were_looked_for() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("inputs.csv"), "time\n0\n").unwrap();
    for (line, missing) in [
        ("simulate none.csv", "none.csv"),
        ("simulate inputs.csv --aircraft none.toml", "none.toml"),
        ("package --aircraft none.toml", "none.toml"),
        ("reproduce --aircraft none.toml", "none.toml"),
        ("bench --fmu none.fmu", "none.fmu"),
        ("flutter none.toml --from 1 --to 2", "none.toml"),
        ("converge none.toml", "none.toml"),
        ("gust none.toml", "none.toml"),
        ("loads --aircraft none.toml", "none.toml"),
        ("loads none.csv", "none.csv"),
        ("merge none.fmu none.fmu", "none.fmu"),
        ("ssp none.fmu --output a.ssp", "none.fmu"),
    ] {
        let errors = text(&run(folder.path(), line).stderr);
        let place = folder.path().canonicalize().unwrap().join(missing);
        assert!(errors.contains(&format!("; looked for {}", place.display())), "{line}: {errors}");
    }
}

#[test]
fn a_mistake_in_the_aircraft_file_is_shown_with_its_line_by_every_command() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("inputs.csv"), "time\n0\n").unwrap();
    std::fs::write(folder.path().join("bad.toml"), "format = 1\nwings = 2\n").unwrap();
    for line in [
        "simulate inputs.csv --aircraft bad.toml",
        "package --aircraft bad.toml",
        "reproduce --aircraft bad.toml",
        "bench --aircraft bad.toml",
        "flutter bad.toml --from 1 --to 2",
        "converge bad.toml",
        "gust bad.toml",
        "loads --aircraft bad.toml",
    ] {
        let errors = text(&run(folder.path(), line).stderr);
        assert!(
            errors.contains(" --> bad.toml:2:1\n") && errors.contains("^^^^^ allowed here: "),
            "{line}: {errors}"
        );
    }
}

#[cfg(unix)]
mod unix {
    use std::io::Read;
    use std::process::{Child, Command, Stdio};
    use std::time::{Duration, Instant};

    use super::*;

    fn fifo(path: &Path) {
        assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
    }

    #[test]
    fn a_link_stays_and_its_target_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("inputs.csv"), "time\n0\n").unwrap();
        std::fs::write(folder.path().join("target.csv"), "old").unwrap();
        std::os::unix::fs::symlink("target.csv", folder.path().join("link.csv")).unwrap();
        assert!(run(folder.path(), "simulate inputs.csv --output link.csv").status.success());
        assert!(folder.path().join("link.csv").is_symlink());
        let written = std::fs::read_to_string(folder.path().join("target.csv")).unwrap();
        assert!(written.starts_with("time,"), "{written}");
        assert_eq!(names(folder.path()), ["inputs.csv", "link.csv", "target.csv"]);
    }

    #[test]
    fn pipes_and_devices_are_written_to_and_stay() {
        use std::os::unix::fs::FileTypeExt;
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("inputs.csv"), "time\n0\n0.01\n").unwrap();
        let pipe = folder.path().join("pipe");
        fifo(&pipe);
        let mut writer = flexair(folder.path(), "simulate inputs.csv --output pipe").spawn().unwrap();
        let mut rows = String::new();
        std::fs::File::open(&pipe).unwrap().read_to_string(&mut rows).unwrap();
        assert!(writer.wait().unwrap().success());
        assert_eq!(rows.lines().count(), 3);
        assert!(std::fs::metadata(&pipe).unwrap().file_type().is_fifo());
        assert!(run(folder.path(), "simulate inputs.csv --output /dev/null").status.success());
        let output = run(folder.path(), "simulate inputs.csv --output /dev/stdout");
        assert_eq!(text(&output.stdout), rows);
        assert_eq!(names(folder.path()), ["inputs.csv", "pipe"]);
    }

    /// The unpacked FMU is in the folder for temporary files.
    #[test]
    fn ctrl_c_takes_temporary_folders_along() {
        let folder = tempfile::tempdir().unwrap();
        let temporary = folder.path().join("temporary");
        std::fs::create_dir(&temporary).unwrap();
        let package = format!("package --no-check --modes 2 --binary {} --output a.fmu", library());
        assert!(run(folder.path(), &package).status.success());
        let mut bench = flexair(folder.path(), "bench --fmu a.fmu --output bench.md --plot bench.svg");
        let mut flying = bench.env("TMPDIR", &temporary).stderr(Stdio::null()).spawn().unwrap();
        wait_until(&mut flying, || !names(&temporary).is_empty());
        interrupt(&mut flying, "-INT");
        assert_eq!(names(&temporary), [""; 0]);
        assert_eq!(names(folder.path()), ["a.fmu", "temporary"]);
    }

    fn wait_until(running: &mut Child, is_so: impl Fn() -> bool) {
        let begin = Instant::now();
        while !is_so() {
            assert!(begin.elapsed() < Duration::from_secs(60) && running.try_wait().unwrap().is_none());
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    /// Sends a signal, which ends the program at once.
    fn interrupt(running: &mut Child, signal: &str) {
        let asked = Instant::now();
        assert!(Command::new("kill").args([signal, &running.id().to_string()]).status().unwrap().success());
        assert_eq!(running.wait().unwrap().code(), Some(130));
        // The machine may be busy; a row takes less than a millisecond.
        assert!(asked.elapsed() < Duration::from_secs(2), "{:?}", asked.elapsed());
    }

    /// A flight of a day, which takes minutes.
    #[test]
    fn ctrl_c_stops_a_long_flight_at_once_and_leaves_nothing_behind() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("inputs.csv"), "time\n0\n86400\n").unwrap();
        let line = "simulate inputs.csv --step 0.01 --output new/flight.csv";
        for signal in ["-INT", "-TERM"] {
            let mut flying = flexair(folder.path(), line).stderr(Stdio::null()).spawn().unwrap();
            let new = folder.path().join("new");
            wait_until(&mut flying, || new.exists() && names(&new).len() == 1);
            interrupt(&mut flying, signal);
            assert_eq!(names(folder.path()), ["inputs.csv"]);
        }
    }
}
