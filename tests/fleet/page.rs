//! Pages of the fleet: what they say of numbers is written from what is measured.

use std::fs;
use std::path::{Path, PathBuf};

use flexible_aircraft::equations::Fidelity;

use super::measured::{Measured, Watched};
use super::{CLEARANCE, Entry, MODES};

/// Natural modes that a page lists.
const LISTED: usize = 6;

fn path(page: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/fleet").join(format!("{page}.md"))
}

/// Compares what stands between `<!-- NAME -->` and `<!-- end of NAME -->` of a page, or writes it anew.
fn compare_part(page: &str, name: &str, right: &str) {
    let path = path(page);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let (opening, closing) = (format!("<!-- {name} -->\n"), format!("<!-- end of {name} -->"));
    let parts =
        text.split_once(&opening).and_then(|(before, rest)| Some((before, rest.split_once(&closing)?)));
    let Some((before, (written, after))) = parts else { panic!("{}: no {opening}", path.display()) };
    if written == right {
        return;
    }
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, format!("{before}{opening}{right}{closing}{after}")).unwrap();
    } else {
        panic!("{} is stale; UPDATE_GOLDEN=1 rewrites it. It should be:\n{right}", path.display());
    }
}

/// The two tables of an aircraft's page.
pub fn compare(entry: &Entry, found: &Measured) {
    compare_part(entry.name, "numbers", &numbers(entry, found));
    compare_part(entry.name, "levels", &levels(entry, found));
}

fn numbers(entry: &Entry, found: &Measured) -> String {
    let modes: Vec<String> = found.modes.iter().take(LISTED).map(mode).collect();
    let held = match found.thrust {
        Some(thrust) => ("thrust of each engine in the trim", format!("{} N", three(thrust))),
        None => ("glide angle in the trim", format!("{:.2}°", -found.climb_angle.to_degrees())),
    };
    let spiral = match found.spiral_doubles {
        Some(doubles) => format!("a spiral that doubles in {} s at the fastest", doubles.round()),
        None => "nothing".to_owned(),
    };
    let trim = &found.trims[0];
    let rows = [
        ("span", format!("{} m", three(found.span))),
        ("wing area", format!("{} m²", three(found.area))),
        ("mass", format!("{:.0} kg", found.mass)),
        ("trimmed at", format!("{} m/s true, {} m", found.airspeed, found.altitude)),
        (
            "angle of attack of the body in the trim",
            format!("{}°", tenths(found.angle_of_attack.to_degrees())),
        ),
        ("elevator in the trim", format!("{}°", tenths(found.pitch_control.to_degrees()))),
        held,
        (
            "wing tip in the trim",
            format!(
                "{} m up, {:.1} % of the half span",
                three(trim.tip_up),
                200.0 * trim.tip_up / found.span
            ),
        ),
        ("static margin", format!("{:.3} chords", found.static_margin)),
        ("natural modes, held at O", modes.join(", ")),
        ("maximum speed", format!("{} m/s true", entry.maximum_speed)),
        (
            "no flutter up to",
            format!("{:.1} m/s, {CLEARANCE} × the maximum, with {MODES} modes", found.flutter_free),
        ),
        ("what grows from the trim's speed to there", spiral),
    ];
    let rows = rows.map(|(what, number)| format!("| {what} | {number} |\n"));
    format!("| what | number |\n| --- | --- |\n{}", rows.concat())
}

fn mode(&(frequency, is_symmetric): &(f64, bool)) -> String {
    format!("{frequency:.2} Hz ({})", if is_symmetric { "s" } else { "a" })
}

fn levels(entry: &Entry, found: &Measured) -> String {
    let [one, other] = found.levels.map(in_words);
    let mut text =
        format!("| when | what | {one} | {other} | difference |\n| --- | --- | --- | --- | --- |\n");
    let [gradient, peak] = entry.flights.gust;
    let [amplitude, length] = entry.flights.doublet;
    let gust = format!("gust of {peak} m/s, H = {gradient} m");
    let doublet = format!("elevator, {amplitude} rad each way for {length} s");
    for (when, watched) in [("trim", &found.trims), (&gust, &found.gusts), (&doublet, &found.doublets)] {
        let is_trim = when == "trim";
        for (what, number) in QUANTITIES {
            // A trim has a load factor of 1 at any level.
            if is_trim && what.starts_with("load factor") {
                continue;
            }
            let [a, b] = watched.each_ref().map(number);
            let difference = difference(a, b);
            text += &format!("| {when} | {what} | {} | {} | {difference} |\n", three(a), three(b));
        }
    }
    text
}

type Quantity = (&'static str, fn(&Watched) -> f64);

const QUANTITIES: [Quantity; 4] = [
    ("wing tip up, m", |watched| watched.tip_up),
    ("pitch, °", |watched| watched.pitch.to_degrees()),
    ("load factor", |watched| watched.load_factor),
    ("wing bending, N m", |watched| watched.bending),
];

/// Of the second by the first, where the first is something.
fn difference(one: f64, other: f64) -> String {
    match 100.0 * (other / one - 1.0) {
        _ if one.abs() < 0.01 => "–".to_owned(),
        percent if percent.abs() < 0.05 => "0".to_owned(),
        percent if percent.abs() < 9.95 => format!("{percent:+.1} %").replace('-', "−"),
        percent => format!("{percent:+.0} %").replace('-', "−"),
    }
}

fn in_words(level: Fidelity) -> &'static str {
    match level {
        Fidelity::GeometricallyExact => "geometrically exact",
        Fidelity::Exact => "exact",
        Fidelity::Inconsistent => "inconsistent",
        _ => "another level",
    }
}

/// Three digits that count, and no sign of a zero.
fn three(number: f64) -> String {
    if number.abs() < 5e-4 {
        return "0".to_owned();
    }
    let leading = number.abs().log10().floor() as i32;
    let unit = 10_f64.powi(leading - 2);
    let decimals = usize::try_from(2 - leading).unwrap_or(0);
    format!("{:.decimals$}", (number / unit).round() * unit).replace('-', "−")
}

fn tenths(number: f64) -> String {
    if number.abs() < 0.05 { "0.0".to_owned() } else { format!("{number:.1}").replace('-', "−") }
}

/// The table of all, from those of the pages.
pub fn compare_overview(fleet: &[Entry]) {
    let mut text = String::from(
        "| | aircraft | span | mass | trimmed at | static margin | first modes | no flutter up to |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for Entry { name, .. } in fleet {
        let page = fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        let title = page.lines().next().and_then(|line| line.strip_prefix("# ")).expect("a title");
        let number = |what: &str| {
            let row = page.lines().find_map(|line| line.strip_prefix(&format!("| {what} | ")));
            row.and_then(|row| row.strip_suffix(" |")).unwrap_or_else(|| panic!("{name}: no row {what}"))
        };
        let modes: Vec<&str> = number("natural modes, held at O").split(", ").take(3).collect();
        let free = number("no flutter up to").split(',').next().unwrap_or_default();
        text += &format!(
            "| [![{title}]({name}.webp)]({name}.md) | [{title}]({name}.md) | {} | {} | {} | {} | {} | {free} |\n",
            number("span"),
            number("mass"),
            number("trimmed at"),
            number("static margin"),
            modes.join(", "),
        );
    }
    compare_part("README", "fleet", &text);
}
