//! Flutter and divergence of published wings: a typical section, Goland's wing, Patil's wing.

use std::path::Path;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::simulation::Settings;
use flexible_aircraft::stability::{Crossing, CrossingKind, Sweep};
use flexible_aircraft::structure::ReducedModel;

fn probe(name: &str, modes: usize, altitude: f64, inflow: usize, from: f64, to: f64, n: usize) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft").join(name);
    for elements in [20, 40] {
        let text = std::fs::read_to_string(&path)
            .unwrap()
            .replace("elements = 20", &format!("elements = {elements}"))
            .replace("elements = 32", &format!("elements = {elements}"));
        let model = ReducedModel::new(&Aircraft::parse(&text, name).unwrap(), modes).unwrap();
        let settings = Settings { altitude, mode_count: modes, inflow_states: inflow, ..Settings::default() };
        let speeds: Vec<f64> = (0..n).map(|i| from + (to - from) * i as f64 / (n - 1) as f64).collect();
        let t = std::time::Instant::now();
        let sweep = Sweep::new(&model, &settings, &speeds).unwrap();
        println!(
            "{name} {modes} modes N={inflow} {elements} elements: {:?} for {} points, {} skipped",
            t.elapsed(),
            sweep.airspeeds.len(),
            sweep.skipped.len()
        );
        for s in sweep.skipped.iter().take(3) {
            println!("  {} {}", s.airspeed, s.reason);
        }
        for c in &sweep.crossings {
            println!(
                "  {:?} onset {} at {:.4} m/s, {:.5} branch {}",
                c.kind, c.is_onset, c.airspeed, c.root.eigenvalue, c.branch
            );
        }
    }
}

#[test]
fn probe_all() {
    for (m, n) in [(4, 6), (8, 6), (8, 8), (8, 5)] {
        probe("goland-wing.toml", m, 0.0, n, 20.0, 300.0, 15);
    }
    for (m, n) in [(4, 6), (8, 6), (10, 6), (10, 8)] {
        probe("patil-wing.toml", m, 19938.0, n, 2.0, 50.0, 17);
    }
}
