//! Reduced models against the whole ones.

use std::sync::OnceLock;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::devices::{Actuator, EngineLag};
use flexible_aircraft::flight::Settings;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::{Inflow, LinearModel};
use nalgebra::{Complex, DMatrix};

use crate::home::Home;

use super::{Error, reduce, scales};

/// The jet with two modes and one inflow state, an actuator and an engine that lag.
fn small() -> &'static LinearModel {
    static MODEL: OnceLock<LinearModel> = OnceLock::new();
    MODEL.get_or_init(|| {
        let jet = ReducedModel::new(
            &Aircraft::read(Home::of_program().aircraft_file("generic-business-jet")).unwrap(),
            2,
        )
        .unwrap();
        let mut settings = Settings::of(&jet);
        settings.plant.inflow_states = 1;
        settings.actuators.set(0, Actuator { frequency: 40.0, damping: 0.7, ..settings.actuators.get(0) });
        settings.engines.set(1, EngineLag { time_constant: 0.5, ..settings.engines.get(1) });
        LinearModel::new(jet, &settings, Inflow::Kept).unwrap()
    })
}

/// The response to each input at a frequency, rad/s, in scales of outputs and inputs.
fn response(model: &LinearModel, frequency: f64) -> DMatrix<Complex<f64>> {
    let LinearModel { a, b, c, d, bd, dd, .. } = model;
    let at = Complex::new(0.0, frequency);
    let complex = |matrix: &DMatrix<f64>| matrix.map(|entry| Complex::new(entry, 0.0));
    let [a, b, c, d, bd, dd] = [a, b, c, d, bd, dd].map(complex);
    let states = (DMatrix::identity(a.nrows(), a.nrows()) * at - a).lu().solve(&(b + bd * at)).unwrap();
    let mut found = c * states + d + dd * at;
    for (mut column, scale) in found.column_iter_mut().zip(scales::of_inputs(model)) {
        column *= Complex::from(scale);
    }
    for (mut row, scale) in found.row_iter_mut().zip(scales::of_outputs(model)) {
        row /= Complex::from(scale);
    }
    found
}

#[test]
fn the_response_is_right_within_the_bound_and_the_wind_acts_by_its_rate() {
    let whole = small();
    for order in [18, 30] {
        let reduced = reduce(whole, order).unwrap();
        assert_eq!((reduced.model.states.len(), reduced.model.a.shape()), (order, (order, order)));
        let mut largest = 0.0_f64;
        for frequency in [0.01, 0.1, 1.2, 5.0, 15.6, 26.1, 60.0, 300.0] {
            let [one, other] = [whole, &reduced.model].map(|model| response(model, frequency));
            largest = largest.max((one - other).svd(false, false).singular_values[0]);
        }
        assert!(largest <= reduced.bound, "{order}: {largest:e}, {:e}", reduced.bound);
        // The bound is twice as much as the first singular value that is left out, and the rest.
        assert!(largest > 1e-3 * reduced.bound, "{order}: {largest:e}, {:e}", reduced.bound);
    }
}

#[test]
fn slow_roots_are_those_of_the_whole_model() {
    let reduced = reduce(small(), 30).unwrap();
    let slow = |model: &LinearModel| {
        let mut roots = model.eigenvalues().unwrap();
        roots.retain(|root| root.norm() < super::SLOW);
        roots.sort_by(|one, other| (one.norm(), one.im).partial_cmp(&(other.norm(), other.im)).unwrap());
        roots
    };
    let (expected, found) = (slow(small()), slow(&reduced.model));
    assert_eq!((expected.len(), found.len(), reduced.split), (4, 4, 4));
    for (expected, found) in expected.iter().zip(&found) {
        assert!((expected - found).norm() < 1e-8, "{expected}, {found}");
    }
}

#[test]
fn what_grows_is_split_off() {
    let mut model = small().clone();
    // A swing of 20 rad/s that grows, which an input moves and an output shows.
    let place = model.states.iter().position(|name| name.name == "inflow[8,1]").unwrap();
    let LinearModel { a, b, c, .. } = &mut model;
    for index in 0..2 {
        a.row_mut(place + index).fill(0.0);
        a.column_mut(place + index).fill(0.0);
        b.row_mut(place + index).fill(0.0);
    }
    a[(place, place + 1)] = 1.0;
    a[(place + 1, place)] = -400.0;
    a[(place + 1, place + 1)] = 0.2;
    b[(place + 1, 0)] = 1.0;
    c[(17, place)] = 1.0;
    let reduced = reduce(&model, 40).unwrap();
    assert_eq!(reduced.split, 6);
    let [one, other] = [&model, &reduced.model].map(|model| response(model, 20.0));
    assert!(
        one[(17, 0)].norm() > 0.01 && (&one - &other).svd(false, false).singular_values[0] <= reduced.bound
    );
    let grows = |root: &Complex<f64>| (root - Complex::new(0.1, 20.0)).norm() < 1e-3;
    assert!(reduced.model.eigenvalues().unwrap().iter().any(grows));
}

#[test]
fn too_few_and_too_many_states_are_refused_with_numbers() {
    let Err(Error::Order { least: 4, most, split: 4, whole, .. }) = reduce(small(), 3) else {
        panic!("3 states of 4")
    };
    assert!((30..whole).contains(&most), "{most} of {whole}");
    assert!(reduce(small(), 4).is_ok() && reduce(small(), most).is_ok());
    let refused = reduce(small(), most + 1).err().unwrap().to_string();
    let expected = format!("--inflow balanced:{}: allowed are 4 to {most} states", most + 1);
    assert!(refused.starts_with(&expected), "{refused}");
    // Nothing to move it.
    let mut still = small().clone();
    still.b.fill(0.0);
    still.bd.fill(0.0);
    assert!(matches!(reduce(&still, 30).err(), Some(Error::Order { most: 4, .. })));
}
