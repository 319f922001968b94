//! The equations as a whole.

use nalgebra::Vector3;
use pulp::Arch;

use crate::aircraft::{ControlGains, Flap};
use crate::math::LANES;
use crate::structure::ReducedModel;
use crate::symmetry::{Counterpart, SymmetricHalf};
use crate::variables::tests::jet;

use super::controls::Controls;
use super::fidelity::Fidelity;
use super::layout::StateLayout;
use super::of_motion::{Configuration, EquationsOfMotion};
use super::workspace::Workspace;

fn configuration(fidelity: Fidelity) -> Configuration {
    Configuration {
        fidelity,
        stiffness_scale: 1.0,
        structural_damping: 0.0,
        inflow_states: 5,
        tunnel_flow: Vector3::zeros(),
    }
}

/// Rates of the jet, or of half of it, in a disturbed flight with vectors of a given width.
fn evaluate(arch: Arch, fidelity: Fidelity, half: bool) -> Vec<u64> {
    let model = jet().select(&[0, 1, 2, 3, 4]);
    let mut equations = if half {
        SymmetricHalf::find(&model).unwrap().equations(&configuration(fidelity))
    } else {
        EquationsOfMotion::new(&model, &configuration(fidelity))
    };
    equations.take_arch(arch);
    let mut state: Vec<f64> = (0..equations.layout().len()).map(|i| libm::sin(i as f64)).collect();
    state[equations.layout().velocity().start] = 127.0;
    let mut rates = vec![0.0; state.len()];
    equations.rates(&state, &Controls::neutral(2), &mut rates, &mut Workspace::new(&equations));
    rates.into_iter().map(f64::to_bits).collect()
}

#[test]
fn the_width_of_the_vectors_changes_no_bit() {
    let levels = [Fidelity::Exact, Fidelity::RuthlesslyLinearised];
    for (fidelity, half) in levels.into_iter().flat_map(|fidelity| [(fidelity, false), (fidelity, true)]) {
        let narrow = evaluate(Arch::Scalar, fidelity, half);
        assert!(narrow.iter().all(|bits| f64::from_bits(*bits).is_finite()));
        assert_eq!(narrow, evaluate(Arch::new(), fidelity, half));
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = pulp::x86::V3::try_new() {
            assert_eq!(narrow, evaluate(Arch::V3(avx2), fidelity, half));
        }
    }
}

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
        let gains = ControlGains { elevator: 0.5, aileron_symmetric: -0.3, ..ControlGains::default() };
        strip.flap = Some(Flap { lift_slope: 4.0, hinge: 0.7, gains });
        strip.zero_lift_offset = 0.03;
        strip.zero_lift_moment = -0.05;
        altered += 1;
    }
    assert!(
        altered > LANES && SymmetricHalf::find(&model).unwrap().model.strips.len() % LANES != altered % LANES
    );
    model
}

fn half_moves_as(whole_model: &ReducedModel) {
    let half = SymmetricHalf::find(whole_model).unwrap();
    let mut controls = Controls::neutral(2);
    (controls.elevator, controls.aileron_symmetric, controls.thrust) = (-0.2, 0.05, vec![2e4; 2]);
    (controls.wind, controls.wind_rate) = (Vector3::new(3.0, 0.0, -4.0), Vector3::new(1.0, 0.0, 2.0));
    for fidelity in Fidelity::ALL {
        let whole = EquationsOfMotion::new(whole_model, &configuration(fidelity));
        let halved = half.equations(&configuration(fidelity));
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

#[test]
fn steering_gives_the_same_bits_as_a_new_evaluation() {
    for fidelity in [Fidelity::Exact, Fidelity::RuthlesslyLinearised] {
        let equations = EquationsOfMotion::new(&jet().select(&[0, 1, 2, 3, 4]), &configuration(fidelity));
        let mut state: Vec<f64> = (0..equations.layout().len()).map(|i| libm::sin(i as f64)).collect();
        state[equations.layout().velocity().start] = 127.0;
        let (mut rates, mut workspace) = (vec![0.0; state.len()], Workspace::new(&equations));
        let mut controls = Controls::neutral(2);
        equations.rates(&state, &controls, &mut rates, &mut workspace);
        let before = rates.clone();
        (controls.elevator, controls.aileron, controls.aileron_symmetric) = (0.1, -0.05, 0.02);
        (controls.rudder, controls.thrust) = (0.03, vec![1e4, 2e4]);
        equations.steer(&controls, &mut rates, &mut workspace);
        let steered = rates.clone();
        equations.rates(&state, &controls, &mut rates, &mut Workspace::new(&equations));
        assert_eq!(steered, rates);
        assert_ne!(steered, before);
    }
}

#[test]
fn counted_multiplications_grow_by_the_same_number_with_every_group_of_strips() {
    let model = jet().select(&[0, 1, 2, 3, 4]);
    let count = |groups: usize| {
        let strips = model.strips.iter().filter(|strip| strip.flap.is_none()).take(groups * LANES);
        let model = ReducedModel { strips: strips.cloned().collect(), ..model.clone() };
        let equations = EquationsOfMotion::new(&model, &configuration(Fidelity::Exact));
        let mut state = vec![0.0; equations.layout().len()];
        state[equations.layout().attitude().start] = 1.0;
        state[equations.layout().velocity().start] = 127.0;
        equations.multiplications(&state, &Controls::neutral(2))
    };
    let [none, one, two, three] = [0, 1, 2, 3].map(count);
    assert_eq!([two - one, three - two], [one - none; 2]);
    // Of each strip Ψᵘq, Ψᵠq and their rates for every mode, as often again for their rows.
    assert!(one - none > LANES * 5 * 24 && one - none < LANES * 5 * 24 * 5, "{}", one - none);
}
