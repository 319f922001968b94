//! `flexair loads`.

use crate::support::{names, run, text, workspace};

#[test]
fn a_table_of_nodes_of_an_earlier_run_goes_where_none_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let aircraft = workspace("aircraft/very-flexible-wing.toml");
    let line = format!("loads --aircraft {} --modes 2 --duration 0.05 --output out", aircraft.display());
    let table = "very-flexible-wing-nodes.csv";
    let nodes = || names(&folder.path().join("out")).contains(&table.to_owned());
    for (options, written) in [("--all-nodes", true), ("", false)] {
        let flown = run(folder.path(), &format!("{line} {options}"));
        assert!(flown.status.success(), "{}", text(&flown.stderr));
        assert_eq!((nodes(), text(&flown.stdout).contains(table)), (written, written));
    }
}

#[test]
fn gusts_are_asked_for_as_in_flexair_gust_and_nothing_is_overridden_in_silence() {
    let folder = tempfile::tempdir().unwrap();
    for (options, reason) in [
        ("--peak 3 --set gust.peak=5", "--set gust.peak=5: the gusts of a set have their own, by --peak"),
        ("--gradients 5", "--gradients: found 5 m, allowed with CS-25 is 9.144 to 106.68 m"),
        (
            "--criterion cs25_vd --duration 1",
            "found a flight of 1 s, but the gusts begin at 1 s (`gust.start`)",
        ),
        ("--step 1e-9", "which makes 5000000002 looks in 1 flight of 5 s, allowed are 1000000 at most"),
        ("--set elevator=1", "`elevator` is an input and no parameter"),
    ] {
        let failed = run(folder.path(), &format!("loads --modes 2 {options} --output out"));
        let errors = text(&failed.stderr);
        assert_eq!(failed.status.code(), Some(1), "{options}: {errors}");
        assert!(errors.contains(reason), "{options}: {errors}");
        assert!(!folder.path().join("out").exists(), "{options}");
    }
}
