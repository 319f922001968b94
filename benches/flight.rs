//! `cargo bench`: the right-hand side, steps, trim and construction of the generic business jet. `flexair bench` measures
//! the same aircraft through the C interface, with accuracy and growth.

use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;

use criterion::{Criterion, criterion_group, criterion_main};
use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::dynamics::{Controls, Workspace};
use flexible_aircraft::simulation::{Inputs, Settings, Simulation};
use flexible_aircraft::structure::ReducedModel;

fn jet() -> Arc<ReducedModel> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
    let aircraft = Aircraft::read(&path).expect("the shipped aircraft file");
    Arc::new(ReducedModel::new(&aircraft, ReducedModel::USUAL_MODES).expect("the shipped aircraft has modes"))
}

fn right_hand_side(criterion: &mut Criterion) {
    let settings = Settings::default();
    let equations = settings.equations(&jet()).expect("the default settings");
    let trim = equations.trim(&settings.trim_condition()).expect("the jet flies");
    let mut controls = Controls::neutral(equations.engine_count());
    controls.elevator = trim.elevator;
    controls.thrust.fill(trim.thrust);
    for (name, equations) in
        [("wide", equations.clone()), ("one strip at a time", equations.one_strip_at_a_time())]
    {
        let (mut rates, mut workspace) = (vec![0.0; trim.state.len()], Workspace::new(&equations));
        criterion.bench_function(&format!("right-hand side, {name}"), |bencher| {
            bencher.iter(|| equations.rates(black_box(&trim.state), &controls, &mut rates, &mut workspace));
        });
    }
}

fn steps(criterion: &mut Criterion) {
    let model = jet();
    for (name, step) in [("10 ms", 0.01), ("1 ms", 0.001)] {
        let mut flight =
            Simulation::new(Arc::clone(&model), &Settings::default(), 0.0).expect("the jet flies");
        let (mut inputs, still) = (Inputs::zero(2), Inputs::zero(2));
        let mut count = 0_u32;
        criterion.bench_function(&format!("step of {name}, elevator moving"), |bencher| {
            bencher.iter(|| {
                count += 1;
                inputs.elevator = 1e-3 * f64::from(count % 2);
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
        bencher.iter(|| Simulation::new(Arc::clone(&model), &Settings::default(), 0.0));
    });
}

criterion_group!(benches, right_hand_side, steps, beginnings);
criterion_main!(benches);
