//! What a tool that linearises finds: the library's own linear model.

use nalgebra::DMatrix;

use super::*;
use crate::by_name::{Inflow, LinearModel};
use crate::devices::{Actuator, EngineLag};
use crate::plant::{ModeSelection, eigenvalues};

/// Settings, and the same by name.
fn lagging() -> (Settings, Vec<(&'static str, f64)>) {
    let mut settings = Settings::of(jet());
    settings.plant.mode_count = 6;
    settings.plant.heading = 0.6;
    settings.actuators.set(0, Actuator { frequency: 20.0, ..Actuator::default() });
    settings.engines.set(1, EngineLag { time_constant: 0.7, ..EngineLag::default() });
    let elevator = jet().controls[0].name.as_str();
    assert_eq!((elevator, jet().engines[1].name.as_str()), ("elevator", "right"));
    let values = vec![
        ("mode_count", 6.0),
        ("heading", 0.6),
        ("actuator.elevator.frequency", 20.0),
        ("engine.right.time_constant", 0.7),
    ];
    (settings, values)
}

/// The jet with load modes, as it starts.
fn strained() -> (ReducedModel, Settings) {
    let text = include_str!("../../../../aircraft/generic-business-jet.toml");
    let aircraft = Aircraft::parse(text, "generic-business-jet.toml").unwrap();
    let model = ReducedModel::new(&Aircraft { load_modes: true, ..aircraft }, 8).unwrap();
    let mut settings = Settings::of(&model);
    settings.plant.mode_count = model.natural_modes();
    assert!(settings.plant.load_modes && model.modes.len() > model.natural_modes());
    (model, settings)
}

/// Bounds each entry by a share of the largest of its row.
fn assert_alike(found: &DMatrix<f64>, expected: &DMatrix<f64>, what: &str, names: impl Fn(usize) -> String) {
    assert_eq!(found.shape(), expected.shape());
    for row in 0..found.nrows() {
        let largest = expected.row(row).amax().max(1e-6);
        for column in 0..found.ncols() {
            let (found, expected) = (found[(row, column)], expected[(row, column)]);
            let difference = (found - expected).abs();
            assert!(
                difference <= 1e-8 * largest,
                "{what}, {} column {column}: {found} {expected} {:e}",
                names(row),
                difference / largest
            );
        }
    }
}

#[test]
fn the_jacobian_is_the_linear_model_of_the_library() {
    let (settings, values) = lagging();
    assert_linear_model(jet(), &settings, &values);
    let (model, settings) = strained();
    assert_linear_model(&model, &settings, &[]);
}

/// That the directional derivatives in trim are the library's linear model.
fn assert_linear_model(aircraft: &ReducedModel, settings: &Settings, values: &[(&str, f64)]) {
    let exchange = Exchange::flying(aircraft, values);
    let model = LinearModel::new(aircraft.clone(), settings, Inflow::Kept).unwrap();
    let references =
        |names: Vec<String>| -> Vec<u32> { names.iter().map(|name| exchange.reference(name)).collect() };
    let own =
        |names: &[crate::by_name::LinearName]| names.iter().map(|name| name.name.clone()).collect::<Vec<_>>();
    let states = references(own(&model.states));
    let rates = references(model.states.iter().map(|name| format!("der({})", name.name)).collect());
    // They are seen of states alone that the model leaves out.
    let shown = own(&model.outputs);
    let rows: Vec<usize> = (0..shown.len())
        .filter(|row| !["position.north", "position.east", "attitude.yaw"].contains(&shown[*row].as_str()))
        .collect();
    let outputs = references(rows.iter().map(|row| shown[*row].clone()).collect());
    let inputs = references(own(&model.inputs));
    let unknowns = [&rates[..], &outputs[..]].concat();
    let jacobian = |knowns: &[u32]| {
        let columns: Vec<Vec<f64>> =
            knowns.iter().map(|known| exchange.derivatives(&unknowns, *known)).collect();
        DMatrix::from_fn(unknowns.len(), knowns.len(), |row, column| columns[column][row])
    };
    let names = |row: usize| exchange.name(unknowns[row]).to_owned();
    let stack = |top: &DMatrix<f64>, bottom: &DMatrix<f64>| {
        let bottom = bottom.select_rows(&rows);
        let mut stacked = DMatrix::zeros(top.nrows() + bottom.nrows(), top.ncols());
        stacked.rows_mut(0, top.nrows()).copy_from(top);
        stacked.rows_mut(top.nrows(), bottom.nrows()).copy_from(&bottom);
        stacked
    };
    assert_alike(&jacobian(&states), &stack(&model.a, &model.c), "by states", names);
    assert_alike(&jacobian(&inputs), &stack(&model.b, &model.d), "by inputs", names);
    let winds: Vec<usize> =
        (0..inputs.len()).filter(|i| model.inputs[*i].name.starts_with("wind_")).collect();
    assert_eq!(winds.len(), 3);
    let by_rates =
        references(winds.iter().map(|i| model.inputs[*i].name.replace("wind_", "wind_rate_")).collect());
    let expected = stack(&model.bd, &model.dd).select_columns(&winds);
    assert_alike(&jacobian(&by_rates), &expected, "by rates of the wind", names);
}

/// Reference: the thesis' aircraft at a tenth of its stiffness, eight symmetric modes, from an independent computation.
#[test]
fn its_eigenvalues_are_those_of_the_soft_jet() {
    let values = [("stiffness_scale", 0.1), ("mode_family", 2.0), ("mode_count", 8.0)];
    assert_eq!(ModeSelection::Symmetric as i32 + 1, 2);
    let exchange = Exchange::flying(jet(), &values);
    use crate::flight::ContinuousState as S;
    let rates: Vec<f64> = exchange.rates();
    assert!(rates[6..].iter().all(|rate| rate.abs() < 127.0));
    let kept: Vec<usize> = (0..exchange.table.states().len())
        .filter(|place| {
            let (state, _) = exchange.table.states()[*place];
            !matches!(state, S::Position(0 | 1) | S::Attitude(2) | S::Drift(_))
                && !matches!(state, S::SurfaceAngle(_) | S::SurfaceRate(_) | S::LaggedThrust(_))
        })
        .collect();
    let all_rates: Vec<u32> = exchange.table.rates().collect();
    let unknowns: Vec<u32> = kept.iter().map(|place| all_rates[*place]).collect();
    let columns: Vec<Vec<f64>> =
        kept.iter().map(|place| exchange.derivatives(&unknowns, exchange.table.states()[*place].1)).collect();
    // What rests has a row and a column of zeros, which add roots of 0.
    let a = DMatrix::from_fn(kept.len(), kept.len(), |row, column| columns[column][row]);
    let roots = eigenvalues(&a).unwrap();
    for (re, im) in [(-0.2142, 9.7578), (-1.1087, 8.7422)] {
        let near = roots.iter().any(|root| (root.re - re).abs() < 6e-5 && (root.im - im).abs() < 6e-5);
        let closest = roots.iter().map(|root| (root.re - re).hypot(root.im - im)).fold(f64::MAX, f64::min);
        assert!(near, "{re} {im}: {closest}");
    }
}

#[test]
fn several_directions_at_once_add_up_and_states_give_their_own_component() {
    let exchange = Exchange::flying(jet(), &[]);
    let unknowns = ["der(velocity.x)", "load_factor.z", "attitude.pitch", "modal.q[2]"]
        .map(|name| exchange.reference(name));
    let knowns =
        ["elevator", "attitude.pitch", "velocity.z", "inflow[5,2]"].map(|name| exchange.reference(name));
    let seed = [0.3, -0.7, 2.0, 1.5];
    let mut together = [0.0; 4];
    // SAFETY: the component is alive, the arrays are as long as said.
    let status = unsafe {
        fmi2GetDirectionalDerivative(
            exchange.fmu.component,
            unknowns.as_ptr(),
            4,
            knowns.as_ptr(),
            4,
            seed.as_ptr(),
            together.as_mut_ptr(),
        )
    };
    assert_eq!(status, Status::Ok);
    assert_eq!((together[2], together[3]), (-0.7, 0.0));
    for (row, together) in together.iter().enumerate() {
        let sum: f64 = knowns
            .iter()
            .zip(seed)
            .map(|(known, component)| component * exchange.derivatives(&unknowns, *known)[row])
            .sum();
        assert!((together - sum).abs() < 1e-7 * (1.0 + sum.abs()), "{row}: {together} {sum}");
    }
}

#[test]
fn with_load_modes_all_natural_ones_take_part_and_either_family_is_at_rest_in_trim() {
    let (model, _) = strained();
    let exchange = Exchange::new(&model);
    let count = exchange.reference("mode_count");
    // SAFETY: the component is alive, the arrays have one element.
    assert_eq!(unsafe { fmi2SetInteger(exchange.fmu.component, &count, 1, &2) }, Status::Error);
    exchange.fmu.assert_refused(&["`mode_count`: found 2, allowed is 8"]);
    assert!(exchange.fmu.last_message().format.ends_with("is 8"), "{}", exchange.fmu.last_message().format);
    let symmetric = ModeSelection::Symmetric as i32 + 1;
    for values in [vec![], vec![("mode_family", f64::from(symmetric))], vec![("load_modes", 0.0)]] {
        let exchange = Exchange::flying(&model, &values);
        let rates = exchange.rates();
        let mut strained = 0;
        for (place, (state, reference)) in exchange.table.states().iter().enumerate() {
            use crate::flight::ContinuousState as S;
            assert!(
                matches!(state, S::Position(_) | S::Drift(_)) || rates[place].abs() < 1e-8,
                "{values:?}, {}: {}",
                exchange.name(*reference),
                rates[place]
            );
            let of_loads = matches!(*state, S::Coordinate(mode) if model.modes[mode].of_loads);
            strained += usize::from(of_loads && exchange.states()[place] != 0.0);
        }
        assert_eq!(strained > 0, values != [("load_modes", 0.0)], "{values:?}: {strained}");
    }
}
