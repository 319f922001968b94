//! `flexair gust`.

use crate::support::{run, text, workspace};

#[test]
fn the_worst_of_many_gusts_is_found_and_both_senses_mirror_each_other_for_small_ones() {
    let folder = tempfile::tempdir().unwrap();
    let aircraft = workspace("aircraft/very-flexible-wing.toml");
    let line = format!(
        "gust {} --modes 4 --peak 0.01 --gradients 0.5:4.5:3 --duration 2 --output-names deflection,loads --output out",
        aircraft.display()
    );
    let flown = run(folder.path(), &line);
    assert!(flown.status.success(), "{}", text(&flown.stderr));
    let printed = text(&flown.stdout);
    assert!(printed.contains("6 gusts at 50 m/s") && printed.contains("as given"), "{printed}");
    let read = |name: &str| std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    let worst = read("very-flexible-wing-worst.csv");
    for (name, some) in [("deflection.tip.up", 1e-4), ("loads.root.bending", 1e-3)] {
        let of = |line: &&str| line.starts_with(&format!("{name},"));
        let found: Vec<&str> = worst.lines().find(of).unwrap().split(',').collect();
        let number = |place: usize| found[place].parse::<f64>().unwrap();
        let (trim, least, greatest) = (number(2), number(3), number(8));
        assert_eq!(
            (&found[5..8], &found[10..13]),
            (&["4.5", "180", "negative"][..], &["4.5", "0", "positive"][..]),
            "{found:?}"
        );
        // What is quadratic in a gust of 0.01 m/s in 50 m/s is below 1e-3 of what is linear.
        let [down, up] = [trim - least, greatest - trim];
        assert!(up > some && (up / down - 1.0).abs() < 1e-2, "{name}: {down} {up}");
    }
    assert_eq!(
        read("very-flexible-wing-gusts.csv").lines().filter(|line| line.contains(".tip.up,")).count(),
        6
    );
    assert!(read("very-flexible-wing-gusts.svg").contains("gradient H (m)"));
}

#[test]
fn what_cannot_be_flown_is_told_before_the_first_gust() {
    let folder = tempfile::tempdir().unwrap();
    let aircraft = workspace("aircraft/very-flexible-wing.toml");
    for (options, reason) in [
        (
            "--gradients 30,5",
            "--gradients: found 5 m, allowed with CS-25 is 9.144 to 106.68 m; --peak flies others",
        ),
        ("--set gust.peak=3", "--set gust.peak=3: the gusts of a set have their own, by --peak"),
        ("--set airspeed=1e9", "--set airspeed=1e9: found `1e9`, allowed is"),
        ("--set elevator=1", "--set elevator=1: there is no parameter `elevator`"),
        ("--duration 0", "'--duration <SECONDS>': allowed is a number of seconds, greater than 0"),
        ("--peak -1", "'--peak <M/S>': allowed is a number of m/s, greater than 0"),
        ("--direction -90,x", "'--direction <DEG>': allowed is a finite number of degrees"),
        ("--gradients -1:3:2", "allowed is FROM:TO:N in m with 0 < FROM ≤ TO"),
        ("--weights -1,2,3", "allowed is MTOW,MLW,MZFW"),
        ("--peak 1 --duration 1", "found a flight of 1 s, but the gusts begin at 1 s (`gust.start`)"),
        (
            "--step 1e-9",
            "--step: found 1e-9 s, which makes 740000000148 looks in 74 flights of 10 s, allowed are 1000000 at most",
        ),
        ("--gradients 10:100:10000", "looks in 20000 flights of 10 s, allowed are 1000000 at most"),
        ("--output-names deflections", "--output-names deflections: there is no such output"),
    ] {
        let failed = run(folder.path(), &format!("gust {} {options} --output out", aircraft.display()));
        let errors = text(&failed.stderr);
        assert!(!failed.status.success() && errors.contains(reason), "{options}: {errors}");
        assert!(!folder.path().join("out").exists(), "{options}");
    }
}

/// A gust from behind, faster than the wing, ends its flight; the one against it does not.
#[test]
fn a_gust_that_cannot_be_flown_is_named_and_the_others_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    let aircraft = workspace("aircraft/very-flexible-wing.toml");
    let line = format!(
        "{} --modes 4 --set model=rigid --set gust.inclination=1.5707963267948966 --peak 55 --gradients 2,4 --duration 2 --output out",
        aircraft.display()
    );
    let failed = run(folder.path(), &format!("gust {line}"));
    let errors = text(&failed.stderr);
    assert_eq!(failed.status.code(), Some(1), "{errors}");
    assert!(
        errors.contains("error: 2 of 4 flights failed; what is written is of the others:\n  gust 2 m up "),
        "{errors}"
    );
    assert!(errors.contains(" (positive): at ") && errors.contains("from behind"), "{errors}");
    let table = std::fs::read_to_string(folder.path().join("out/very-flexible-wing-gusts.csv")).unwrap();
    assert!(
        table.lines().skip(1).all(|row| row.contains(",negative,")) && table.lines().count() > 2,
        "{table}"
    );
    // `loads` flies the same.
    let failed = run(folder.path(), &format!("loads --aircraft {line}"));
    assert!(
        text(&failed.stderr).contains("error: 2 of 4 flights failed; what is written is of the others:\n")
    );
    let table = std::fs::read_to_string(folder.path().join("out/very-flexible-wing-envelopes.csv")).unwrap();
    assert!(table.lines().count() > 1 && !table.contains(" up "), "{table}");
}

#[test]
fn a_trim_beyond_the_limits_and_a_gust_that_is_not_over_are_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("inputs.csv"), "time\n0\n").unwrap();
    let slow = "--modes 2 --set airspeed=70";
    let warnings = |line: &str| text(&run(folder.path(), &format!("{line} {slow}")).stderr);
    let beyond = "warning: the trim at 70 m/s and 7620 m stands, but ";
    let expected = warnings("simulate inputs.csv --output flight.csv");
    let expected = expected.lines().find(|line| line.starts_with(beyond)).unwrap();
    let gust = warnings("gust --gradients 20,60 --duration 1.1 --step 0.05 --output out");
    let loads = warnings("loads --gradients 20,60 --duration 1.1 --step 0.05 --output out");
    for warned in [gust, loads] {
        assert_eq!(warned.lines().filter(|line| *line == expected).count(), 1, "{warned}");
        let not_over = "warning: the gust with a gradient of 60 m, met at 1 s (`gust.start`), passes the nose until 2.714 s at 70 m/s";
        assert!(warned.contains(not_over), "{warned}");
    }
}
