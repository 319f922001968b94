//! Half the aircraft against the whole [theory: symmetry.half].

use nalgebra::Vector3;

use crate::aircraft::Flap;
use crate::equations::tests::configuration;
use crate::equations::{EquationsOfMotion, Fidelity, StateLayout, StationLoad, StationLoads, Workspace};
use crate::math::LANES;
use crate::structure::ReducedModel;
use crate::structure::test_jet::{AILERON_SYMMETRIC, ELEVATOR, jet};

use super::half::{Counterpart, SymmetricHalf};

/// A state of symmetric motion, the inflow of each strip and each place given by `inflow`.
fn symmetric_state(
    layout: &StateLayout,
    coordinates: &[f64],
    inflow: impl Fn(usize, usize) -> f64,
) -> Vec<f64> {
    let mut state = vec![0.0; layout.len()];
    state[layout.position()].copy_from_slice(&[100.0, 0.0, -7000.0]);
    state[layout.attitude()].copy_from_slice(&[libm::cos(0.1), 0.0, libm::sin(0.1), 0.0]);
    state[layout.velocity()].copy_from_slice(&[125.0, 0.0, 12.0]);
    state[layout.rate().start + 1] = 0.2;
    state[layout.coordinates()].copy_from_slice(coordinates);
    let rates: Vec<f64> = coordinates.iter().map(|q| -7.0 * q).collect();
    state[layout.coordinate_rates()].copy_from_slice(&rates);
    for strip in 0..layout.inflow().len() / 5 {
        for (state_index, place) in layout.inflow_layout().of_strip(strip).into_iter().enumerate() {
            state[place] = inflow(strip, state_index);
        }
    }
    state
}

#[test]
fn in_symmetric_motion_half_the_aircraft_moves_as_the_whole_one() {
    let model = jet().select(&[0, 1, 2, 3, 4, 5, 6, 7]);
    half_moves_as(&model);
    half_moves_as(&with_lifting_body(model));
}

/// With flaps and cambered sections along the body, and without the outermost strips: others on the right then share a
/// group with some in the plane.
fn with_lifting_body(mut model: ReducedModel) -> ReducedModel {
    let outermost = model.strips.iter().map(|strip| strip.position.y).fold(0.0, f64::max);
    model.strips.retain(|strip| strip.position.y.abs() < outermost - 1e-6);
    let mut altered = 0;
    for strip in model.strips.iter_mut().filter(|strip| strip.position.y == 0.0 && strip.span.y.abs() > 0.9) {
        let mut gains = vec![0.0; 4];
        (gains[ELEVATOR], gains[AILERON_SYMMETRIC]) = (0.5, -0.3);
        strip.flap = Some(Flap { lift_slope: 4.0, hinge: 0.7, moment_slope: None, drag: 0.3, gains });
        strip.zero_lift_offset = 0.03;
        strip.zero_lift_moment = -0.05;
        strip.moment_slope = 0.2;
        altered += 1;
    }
    assert!(
        altered > LANES && SymmetricHalf::find(&model).unwrap().model.strips.len() % LANES != altered % LANES
    );
    model
}

fn half_moves_as(whole_model: &ReducedModel) {
    let half = SymmetricHalf::find(whole_model).unwrap();
    for fidelity in Fidelity::ALL {
        let mut whole = EquationsOfMotion::new(whole_model, &configuration(fidelity)).unwrap();
        let mut controls = whole.neutral_controls();
        (controls.angles[ELEVATOR], controls.angles[AILERON_SYMMETRIC]) = (-0.2, 0.05);
        controls.thrust.fill(2e4);
        (controls.wind, controls.wind_rate) = (Vector3::new(3.0, 0.0, -4.0), Vector3::new(1.0, 0.0, 2.0));
        let mut halved = half.equations(&configuration(fidelity)).unwrap();
        // Every station has its mirror image.
        let load = StationLoad { force: Vector3::new(900.0, 0.0, -3e3), moment: Vector3::new(0.0, 2e3, 0.0) };
        let loads = StationLoads::new(vec![load; whole_model.stations.len()]);
        [&mut whole, &mut halved].into_iter().for_each(|equations| equations.take_loads(loads.clone()));
        let q: Vec<f64> = (0..halved.layout().modes()).map(|mode| 20.0 / (1.0 + mode as f64)).collect();
        let mut whole_q = vec![0.0; whole.layout().modes()];
        if fidelity != Fidelity::Rigid {
            half.modes.iter().zip(&q).for_each(|(&mode, &q)| whole_q[mode] = q);
        }
        let inflow = |strip: usize, index: usize| 2.0 * libm::sin((strip * 5 + index) as f64);
        let state = symmetric_state(halved.layout(), &q, |strip, index| {
            if strip < half.model.strips.len() { inflow(strip, index) } else { 0.0 }
        });
        let whole_state =
            symmetric_state(whole.layout(), &whole_q, |strip, index| match half.strips.get(strip) {
                Some(&Counterpart::Lifting { index: strip, sign }) => sign * inflow(strip, index),
                _ => 0.0,
            });
        let evaluate = |equations: &EquationsOfMotion, state: &[f64]| {
            let (mut rates, mut workspace) = (vec![0.0; state.len()], Workspace::new(equations));
            equations.rates(state, &controls, &mut rates, &mut workspace);
            rates
        };
        let (rates, whole_rates) = (evaluate(&halved, &state), evaluate(&whole, &whole_state));
        let agree = |found: f64, expected: f64, what: &str| {
            let scale = 100.0 + expected.abs();
            assert!((found - expected).abs() < 1e-11 * scale, "{fidelity:?}, {what}: {found} {expected}");
        };
        for (place, whole_place) in halved.layout().rigid().zip(whole.layout().rigid()) {
            agree(rates[place], whole_rates[whole_place], "rigid motion");
        }
        for (mode, place) in whole.layout().coordinate_rates().enumerate() {
            let kept = half.modes.iter().position(|&kept| kept == mode);
            let expected = kept.map_or(0.0, |kept| rates[halved.layout().coordinate_rates().start + kept]);
            agree(expected, whole_rates[place], "modes");
        }
        for (strip, counterpart) in half.strips.iter().enumerate() {
            for (index, place) in whole.layout().inflow_layout().of_strip(strip).into_iter().enumerate() {
                let expected = match *counterpart {
                    Counterpart::Lifting { index: kept, sign } => {
                        sign * rates[halved.layout().inflow_layout().of_strip(kept)[index]]
                    }
                    Counterpart::EdgeOn(_) => 0.0,
                };
                agree(expected, whole_rates[place], "inflow");
            }
        }
    }
}
