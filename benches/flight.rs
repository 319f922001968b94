//! `cargo bench`: the right-hand side, steps, trim and construction of the generic business jet. `flexair bench` measures
//! the same aircraft through the C interface, with accuracy and growth.

use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;

use criterion::{Criterion, criterion_group, criterion_main};
use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::symmetry::Plants;

fn jet() -> Arc<ReducedModel> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
    let aircraft = Aircraft::read(&path).expect("the shipped aircraft file");
    Arc::new(ReducedModel::new(&aircraft, ReducedModel::USUAL_MODES).expect("the shipped aircraft has modes"))
}

fn right_hand_side(criterion: &mut Criterion) {
    let settings = Settings::of(&jet());
    let plants = Plants::under(&jet(), &settings.plant).expect("the default settings");
    let (whole, half) = (plants.whole().clone(), plants.half().expect("a mirror plane").clone());
    for (name, plant) in [
        ("half the aircraft", half),
        ("the whole aircraft", whole.clone()),
        ("the whole aircraft, one strip at a time", whole.one_strip_at_a_time()),
    ] {
        let trim = plant.trim(&settings.plant.trim_condition()).expect("the jet flies");
        let (mut rates, mut workspace) = (vec![0.0; trim.state.len()], plant.workspace());
        criterion.bench_function(&format!("right-hand side of {name}"), |bencher| {
            bencher.iter(|| plant.rates(black_box(&trim.state), &trim.controls, &mut rates, &mut workspace));
        });
    }
}

fn steps(criterion: &mut Criterion) {
    let model = jet();
    for (name, step, aileron) in [
        ("10 ms, elevator moving", 0.01, 0.0),
        ("1 ms, elevator moving", 0.001, 0.0),
        ("10 ms, elevator moving, ailerons set", 0.01, 1e-3),
    ] {
        let mut flight =
            Simulation::new(Arc::clone(&model), &Settings::of(&jet()), 0.0).expect("the jet flies");
        let (mut inputs, still) = (Inputs::zero(&model), Inputs::zero(&model));
        let [elevator, roll] =
            ["elevator", "aileron"].map(|name| model.control(name).expect("the jet has it"));
        let mut count = 0_u32;
        criterion.bench_function(&format!("step of {name}"), |bencher| {
            bencher.iter(|| {
                count += 1;
                inputs.controls[elevator] = 1e-3 * f64::from(count % 2);
                // Ailerons to and fro, or the jet would roll over in the course of so many steps.
                inputs.controls[roll] = if count % 200 < 100 { aileron } else { -aileron };
                flight.set_inputs(&inputs, &still);
                flight.advance_to(f64::from(count) * step).expect("the jet goes on flying");
                black_box(flight.outputs());
            });
        });
    }
}

fn beginnings(criterion: &mut Criterion) {
    let model = jet();
    let bytes = model.to_bytes();
    criterion.bench_function("reading the reduced model", |bencher| {
        bencher.iter(|| ReducedModel::from_bytes(&bytes));
    });
    criterion.bench_function("trim", |bencher| {
        bencher.iter(|| Simulation::new(Arc::clone(&model), &Settings::of(&jet()), 0.0));
    });
}

criterion_group!(benches, right_hand_side, steps, beginnings);
criterion_main!(benches);
