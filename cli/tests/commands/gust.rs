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
        let (trim, least, greatest) = (number(2), number(3), number(7));
        assert_eq!(
            (found[5], found[6], found[9], found[10]),
            ("4.5", "negative", "4.5", "positive"),
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
        ("--gradients 5:30:3", "--gradients: found 5 to 30 m, allowed with CS-25 is 9.144 to 106.68 m"),
        ("--set gust.peak=3", "--set gust.peak=3: `flexair gust` flies gusts of its own, by --peak"),
        ("--set airspeed=1e9", "--set airspeed=1e9: found `1e9`, allowed is"),
        ("--duration 0", "--duration: found 0, allowed is a number of seconds, greater than 0"),
        ("--peak 1 --duration 1", "--duration: found 1 s, but the gusts begin at 1 s (`gust.start`)"),
        ("--output-names deflections", "--output-names deflections: there is no such output"),
    ] {
        let failed = run(folder.path(), &format!("gust {} {options} --output out", aircraft.display()));
        let errors = text(&failed.stderr);
        assert!(!failed.status.success() && errors.contains(reason), "{options}: {errors}");
        assert!(!folder.path().join("out").exists(), "{options}");
    }
}
