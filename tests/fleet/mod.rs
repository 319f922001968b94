//! The fleet: whole aircraft of many kinds that come with the program. Each trims, is stable, does not flutter, and flies at two levels of
//! fidelity; its page in `docs/fleet` says what was measured.
//!
//! With the environment variable `UPDATE_GOLDEN=1` the tests rewrite the tables of the pages instead of failing on them; a
//! second run then rewrites that of `docs/fleet/README.md` from all of them.

mod measured;
mod page;

use std::path::Path;

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::stability::{Crossing, CrossingKind, Sweep};
use flexible_aircraft::{Aircraft, ReducedModel};

use measured::Measured;

/// An aircraft of the fleet and what is asked of it.
struct Entry {
    /// Of its file, its page and its picture.
    name: &'static str,
    /// From tip to tip, m.
    span: f64,
    /// The greatest at which it is flown, m/s true at the altitude of its file, which says so too.
    maximum_speed: f64,
    flights: Flights,
    /// At which it is flown beside the level of its file.
    other_level: Fidelity,
    /// Where section loads are compared.
    cut: &'static str,
}

/// What it is flown through, for some seconds.
struct Flights {
    /// s.
    duration: f64,
    /// H and U of a 1 − cos gust upwards, m and m/s.
    gust: [f64; 2],
    /// Amplitude of a doublet of the elevator, nose up first, rad, and the length of each half, s.
    doublet: [f64; 2],
}

const FLEET: [Entry; 8] = [
    Entry {
        name: "light-single",
        span: 10.8,
        maximum_speed: 88.0,
        flights: Flights { duration: 4.0, gust: [18.0, 7.5], doublet: [0.04, 0.5] },
        other_level: Fidelity::Exact,
        cut: "wing_root_right",
    },
    Entry {
        name: "sailplane",
        span: 18.0,
        maximum_speed: 75.0,
        flights: Flights { duration: 4.0, gust: [10.0, 3.0], doublet: [0.04, 0.5] },
        other_level: Fidelity::Exact,
        cut: "wing_root_right",
    },
    Entry {
        name: "v-tail-uav",
        span: 14.0,
        maximum_speed: 68.0,
        flights: Flights { duration: 4.0, gust: [10.0, 4.5], doublet: [0.04, 0.5] },
        other_level: Fidelity::Exact,
        cut: "wing_root_right",
    },
    Entry {
        name: "flying-wing",
        span: 11.0,
        maximum_speed: 100.0,
        flights: Flights { duration: 4.0, gust: [20.0, 7.5], doublet: [0.02, 0.5] },
        other_level: Fidelity::Exact,
        cut: "wing_root_right",
    },
    Entry {
        name: "t-tail",
        span: 17.0,
        maximum_speed: 175.0,
        flights: Flights { duration: 4.0, gust: [30.0, 12.0], doublet: [0.02, 0.5] },
        other_level: Fidelity::Exact,
        cut: "wing_root_right",
    },
    Entry {
        name: "twin-boom",
        span: 12.0,
        maximum_speed: 85.0,
        flights: Flights { duration: 4.0, gust: [16.0, 7.5], doublet: [0.04, 0.5] },
        other_level: Fidelity::Exact,
        cut: "wing_root_right",
    },
    Entry {
        name: "high-altitude",
        span: 34.0,
        maximum_speed: 32.0,
        flights: Flights { duration: 8.0, gust: [15.0, 1.5], doublet: [0.03, 1.0] },
        other_level: Fidelity::Exact,
        cut: "wing_root_right",
    },
    // A loop on each side: the geometrically exact level does not fly it, and it is cut beyond its struts.
    Entry {
        name: "strut-braced",
        span: 34.0,
        maximum_speed: 150.0,
        flights: Flights { duration: 4.0, gust: [26.0, 10.0], doublet: [0.03, 0.5] },
        other_level: Fidelity::Exact,
        cut: "wing_outer_right",
    },
];

/// Factor on the maximum speed up to which nothing may flutter.
const CLEARANCE: f64 = 1.2;

/// Modes of the structure that take part.
const MODES: usize = 20;

/// Static margins of what has a tail or elevons, in chords.
const MARGINS: std::ops::RangeInclusive<f64> = 0.0..=0.4;

/// A spiral that grows may double in no less, s: level 1 in phases of category B, cruise among them, of MIL-F-8785C, table VIII.
const SPIRAL_DOUBLES: f64 = 20.0;

/// At 1.2 times the maximum speed too air may be taken for incompressible: what `flexair` warns beyond.
const MACH: f64 = 0.7;

fn flies_as_its_page_says(name: &str) {
    let entry = FLEET.iter().find(|entry| entry.name == name).expect("an entry of the fleet");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft").join(format!("{name}.toml"));
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(
        text.starts_with("#:schema ./aircraft.schema.json\n"),
        "{name}: editors find the schema by its first line"
    );
    let said = format!("aximum speed {} m/s", entry.maximum_speed);
    assert!(text.replace("\n# ", " ").contains(&said), "{name}: its head comment does not say: m{said}");
    let aircraft = Aircraft::parse(&text, &format!("{name}.toml")).unwrap_or_else(|error| panic!("{error}"));
    let found = Measured::of(entry, &aircraft);
    let span = found.span;
    assert!((span / entry.span - 1.0).abs() < 1e-3, "{name}: the span is {span} m");
    assert!(MARGINS.contains(&found.static_margin), "{name}: the static margin is {}", found.static_margin);
    // Lift carries the same weight at both levels, and the bending moment of the root tells where: within the width of a strip.
    let [one, other] = found.trims.each_ref().map(|trim| trim.bending);
    assert!((other / one - 1.0).abs() < 0.03, "{name}: bending in the trims, {one} and {other} N m");
    page::compare(entry, &found);
}

#[test]
fn light_single_flies_as_its_page_says() {
    flies_as_its_page_says("light-single");
}

#[test]
fn sailplane_flies_as_its_page_says() {
    flies_as_its_page_says("sailplane");
}

#[test]
fn v_tail_uav_flies_as_its_page_says() {
    flies_as_its_page_says("v-tail-uav");
}

#[test]
fn flying_wing_flies_as_its_page_says() {
    flies_as_its_page_says("flying-wing");
}

#[test]
fn t_tail_flies_as_its_page_says() {
    flies_as_its_page_says("t-tail");
}

#[test]
fn twin_boom_flies_as_its_page_says() {
    flies_as_its_page_says("twin-boom");
}

#[test]
fn high_altitude_flies_as_its_page_says() {
    flies_as_its_page_says("high-altitude");
}

#[test]
fn strut_braced_flies_as_its_page_says() {
    flies_as_its_page_says("strut-braced");
}

#[test]
fn the_table_of_the_fleet_is_that_of_its_pages() {
    page::compare_overview(&FLEET);
}

/// As its page says; its maximum speed is 100 m/s.
#[test]
fn the_flying_wing_flutters_little_beyond_its_maximum_speed_where_its_box_is_soft() {
    let model = ReducedModel::new(&aircraft("flying-wing"), MODES).unwrap();
    let settings = PlantSettings { stiffness_scale: 0.02, mode_count: MODES, ..PlantSettings::of(&model) };
    let sweep = Sweep::new(&model, &settings, &[70.0, 80.0, 90.0, 100.0, 110.0]).unwrap();
    let is_onset = |crossing: &&Crossing| crossing.is_onset && crossing.kind == CrossingKind::Flutter;
    let flutter = sweep.crossings.iter().find(is_onset).expect("flutter");
    assert!((100.0..110.0).contains(&flutter.airspeed), "{} m/s", flutter.airspeed);
}

/// A tenth of the half span is not small: superposed displacements stretch the wing, which its real EA does not allow.
#[test]
fn the_wing_for_high_altitude_bends_by_a_tenth_of_its_half_span() {
    let [bent, locked] =
        measured::trims(&aircraft("high-altitude"), [Fidelity::GeometricallyExact, Fidelity::Exact]);
    assert!((0.09..0.12).contains(&(bent.tip_up / 17.0)), "{}", bent.tip_up);
    assert!(locked.tip_up < 0.2 * bent.tip_up, "{}", locked.tip_up);
}

fn aircraft(name: &str) -> Aircraft {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft").join(format!("{name}.toml"));
    Aircraft::read(&path).unwrap_or_else(|error| panic!("{error}"))
}
