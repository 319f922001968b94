//! The pages of the jet.

use flexible_aircraft::flight::continuous_settings;
use flexible_aircraft::fmi::{Kind, Version};

use super::*;

fn jet() -> Aircraft {
    let text = include_str!("../../../aircraft/generic-business-jet.toml");
    Aircraft::parse(text, "jet").unwrap()
}

fn reduced(aircraft: &Aircraft) -> Reduction {
    Reduction { aircraft: aircraft.clone(), model: ReducedModel::new(aircraft, 4).unwrap() }
}

fn page_of(aircraft: &Aircraft) -> String {
    let reduction = reduced(aircraft);
    page(Interface::USUAL, &reduction, &Settings::of(&reduction.model), false)
}

#[test]
fn the_page_says_how_the_aircraft_is_held() {
    let mut aircraft = jet();
    let free = page_of(&aircraft);
    aircraft.support = Support::Clamped;
    let clamped = page_of(&aircraft);
    assert!(free.contains("flies trimmed") && !free.contains("wind tunnel"));
    assert!(free.contains("a coordinated turn") && !clamped.contains("a coordinated turn"));
    assert!(clamped.contains("wind tunnel") && !clamped.contains("flies trimmed"));
    assert!(!free.contains("{{") && !clamped.contains("{{"));
}

#[test]
fn the_page_says_what_gusts_actuators_sensors_and_loads_mean_and_how_far_they_go() {
    let mut aircraft = jet();
    let with_cuts = page_of(&aircraft);
    for said in [
        "<code>gust.shape = one_minus_cosine</code>",
        "<code>turbulence.seed</code>",
        "<code>actuator.*.frequency</code>",
        "<code>sensor.enabled</code>",
        "waves down to πc/2",
        "below waves of 8&nbsp;m",
        "not for a flap that several controls move",
        "<code>torsion</code> nose-up",
        "section loads jump",
    ] {
        assert!(with_cuts.contains(said), "{said}");
    }
    aircraft.cuts.clear();
    let without = page_of(&aircraft);
    assert!(!without.contains("<code>loads.*</code>") && !without.contains("section loads"));
}

#[test]
fn the_page_says_what_positive_angles_of_the_aircrafts_own_controls_do() {
    let mut aircraft = jet();
    let expected = "<li>Positive <code>elevator</code>: nose-down. It acts alike on both sides; holds pitch in trim; has the usual \
                     limits of -30 to 30 deg, which change no flight.</li>";
    assert!(page_of(&aircraft).contains(expected));
    let canard = &mut aircraft.controls[0];
    (canard.name, canard.description) = ("canard".to_owned(), "Canard angle".to_owned());
    canard.positive = "up & away".to_owned();
    let page = page_of(&aircraft);
    assert!(
        page.contains("<li>Positive <code>canard</code>: up &amp; away. It ") && !page.contains("elevator")
    );
}

#[test]
fn every_variable_stands_once_in_the_table_of_its_group() {
    let model = ReducedModel::new(&jet(), 4).unwrap();
    let table = ArchiveTable::new(&model, &Settings::of(&model), Interface::USUAL.extent());
    let groups = groups(&table);
    assert_eq!(groups.iter().map(|group| group.variables.len()).sum::<usize>(), table.iter().count());
    let names: Vec<&str> = groups.iter().map(|group| group.anchor).collect();
    assert_eq!(&names[..4], ["inputs", "parameters", "position", "attitude"]);
    // A group that this page does not know would have no title of its own.
    for name in &names[2..] {
        assert!(OUTPUT_GROUPS.iter().any(|(known, _)| known == name), "{name}");
    }
    let page = page_of(&jet());
    for name in names {
        assert_eq!(page.matches(&format!("id=\"{name}\"")).count(), 1, "{name}");
        assert_eq!(page.matches(&format!("href=\"#{name}\"")).count(), 1, "{name}");
    }
}

#[test]
fn a_row_has_unit_start_limits_and_the_numbers_and_names_of_an_enumeration() {
    let page = page_of(&jet());
    let row = |name: &str| {
        let rows = page.lines().filter(|line| line.starts_with(&format!("<tr><td><code>{name}</code>")));
        rows.collect::<Vec<_>>().concat()
    };
    for cell in ["\"unit\">m<", "\"start\">7620<", "\"min\">-1000<", "\"max\">30000<"] {
        assert!(row("altitude").contains(cell), "{cell}: {}", row("altitude"));
    }
    assert!(row("model").contains("\"start\">1<"));
    // The list counts from 1, as the enumeration does.
    assert!(row("model").contains("<ol><li><code>exact</code>: "), "{}", row("model"));
    assert_eq!(row("model").matches("<li>").count(), 6);
    assert!(row("tolerance").contains("\"min\">1e-12<"));
    assert!(!row("attitude.pitch").contains("\"start\""), "outputs have no start");
}

#[test]
fn the_page_fits_a_phone_and_needs_no_other_file_but_the_scene() {
    let page = page_of(&jet());
    let reduction = reduced(&jet());
    let with_scene = super::page(Interface::USUAL, &reduction, &Settings::of(&reduction.model), true);
    assert_eq!(with_scene.matches("src=").count(), 1);
    assert!(with_scene.contains(&format!("<iframe src=\"{SCENE}\"")) && !with_scene.contains("{{"));
    assert!(page.contains("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"));
    assert!(page.contains("@media (max-width:"));
    for external in ["src=", "url(http", "@import", "<link", "href=\"http"] {
        assert!(!page.contains(external), "{external}");
    }
}

#[test]
fn the_page_says_what_importers_take_the_fmu_as_and_names_no_function_of_another_version() {
    let reduction = reduced(&jet());
    for interface in Interface::ALL {
        let page = page(interface, &reduction, &continuous_settings::usual(&reduction.model), false);
        assert!(page.contains(&format!("An {interface} unit, written by")), "{interface}");
        assert!(!page.contains("{{"), "{interface}");
        let (own, other) = match interface.version {
            Version::V2 => ("<code>fmi2", "<code>fmi3"),
            Version::V3 => ("<code>fmi3", "<code>fmi2"),
        };
        assert!(page.contains(own) && !page.contains(other), "{interface}");
        let is_exchange = interface.kind == Kind::ModelExchange;
        for said in
            ["implicit ones pay for a Jacobian of ", "it is not wrapped to ±π", "<code>rate_limit</code>"]
        {
            assert_eq!(page.contains(said), is_exchange, "{interface}: {said}");
        }
        assert_eq!(page.contains("<tr><td><code>tolerance</code>"), !is_exchange, "{interface}");
        assert!(page.contains("<tr><td><code>wind_rate_down</code>"), "{interface}");
    }
}

#[test]
fn all_states_stand_in_one_table_by_their_sorts() {
    let model = ReducedModel::new(&jet(), 4).unwrap();
    let exchange = Interface { version: Version::V2, kind: Kind::ModelExchange };
    let table = ArchiveTable::new(&model, &continuous_settings::usual(&model), exchange.extent());
    let text = exchange::states(&table);
    let count = table.states().len();
    assert!(text.contains(&format!("integrates its {count} states")), "{text}");
    for row in [
        "<td>1–3</td><td><code>position.north</code> to <code>position.down</code></td>",
        "<td>13–16</td><td><code>modal.q[1]</code> to <code>modal.q[4]</code></td>",
        "<td>17–20</td><td><code>modal.q_dot[1]</code> to <code>modal.q_dot[4]</code></td>",
        "<td>21–515</td><td><code>inflow[1,1]</code> to <code>inflow[99,5]</code></td>",
    ] {
        assert!(text.contains(row), "{row}: {text}");
    }
    assert!(text.contains(&format!("–{count}</td>")), "{text}");
}
