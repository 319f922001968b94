//! Envelopes of the jet in a gust.

use std::path::PathBuf;

use clap::Parser;

use super::*;
use crate::home::Home;

#[derive(Parser)]
struct Line {
    #[command(flatten)]
    options: LoadsOptions,
}

fn options(line: &str) -> LoadsOptions {
    let mut options = Line::parse_from(std::iter::once("loads").chain(line.split_whitespace())).options;
    if options.aircraft == workspace::aircraft() {
        options.aircraft = Home::of_program().aircraft_file("generic-business-jet");
    }
    options
}

fn analysis(line: &str) -> Analysis {
    let options = options(line);
    analyse(&options, &read(&options).unwrap()).unwrap()
}

#[test]
fn the_envelope_of_two_gusts_is_that_of_each_where_it_is_larger() {
    let common = "--modes 4 --duration 2 --peak 10 --gradients";
    let [short, long, both] =
        ["15", "60", "15,60"].map(|gradients| analysis(&format!("{common} {gradients}")));
    assert_eq!(both.cases.names, ["gust 15 m up", "gust 60 m up", "gust 15 m down", "gust 60 m down"]);
    assert_eq!(both.named, 9);
    for cut in 0..both.model.cuts.len() {
        let [short, long, both] = [&short, &long, &both].map(|analysis| analysis.envelopes.of(cut).unwrap());
        for place in 0..envelope::COMPONENTS {
            let [one, other] = [short, long].map(|envelope| envelope.most[place].loads[place]);
            assert_eq!(both.most[place].loads[place], one.max(other));
            let [one, other] = [short, long].map(|envelope| envelope.least[place].loads[place]);
            assert_eq!(both.least[place].loads[place], one.min(other));
        }
    }
    let text = report::text(&both);
    let heading = "Generic business jet (span 24.86 m): section loads in 4 flights at 127 m/s, 7620 m, model = exact, 4 modes\n\
                   peak 10.0000 m/s of true airspeed, as given\n";
    assert!(text.starts_with(heading), "{text}");
    assert!(text.contains("\nwing_root_right\n  shear") && text.contains("gust 60 m up"), "{text}");
}

#[test]
fn the_loads_of_a_wing_grow_from_its_tip_to_its_root() {
    let analysis = analysis("--modes 4 --duration 0.1 --all-nodes");
    let nodes: Vec<f64> = analysis
        .model
        .cuts
        .iter()
        .enumerate()
        .skip(analysis.named)
        .filter(|(_, cut)| cut.component == "wing_right")
        .map(|(index, _)| analysis.envelopes.of(index).unwrap().start[4])
        .collect();
    assert_eq!(nodes.len(), 25);
    assert!(nodes.windows(2).all(|pair| pair[0] > pair[1]), "{nodes:?}");
    assert_eq!(nodes[24], 0.0);
    // The root is a cut of the file too.
    assert_eq!(nodes[0], analysis.envelopes.of(0).unwrap().start[4]);
    let table = report::table(&analysis, analysis.named..analysis.model.cuts.len());
    let columns = table.lines().next().unwrap().split(',').count();
    assert!(table.lines().all(|line| line.split(',').count() == columns));
}

#[test]
fn an_aircraft_without_cuts_is_refused_unless_all_nodes_are_asked_for() {
    let aircraft: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/typical-section.toml");
    let line = format!("--aircraft {}", aircraft.display());
    let refused = read(&options(&line)).unwrap_err().to_string();
    assert!(refused.ends_with("found no [[cut]], allowed is at least one, or --all-nodes"), "{refused}");
    assert!(read(&options(&format!("{line} --all-nodes"))).is_ok());
}
