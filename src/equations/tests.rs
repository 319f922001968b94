//! The equations as a whole.

use nalgebra::Vector3;
use pulp::Arch;

use crate::math::LANES;
use crate::structure::ReducedModel;
use crate::structure::test_jet::{AILERON, AILERON_SYMMETRIC, ELEVATOR, RUDDER, jet, jet_in_plane};

use super::fidelity::Fidelity;
use super::of_motion::{Configuration, EquationsOfMotion};
use super::workspace::Workspace;

/// What tests ask for: five lags a strip, no damping.
pub(crate) fn configuration(fidelity: Fidelity) -> Configuration {
    Configuration {
        fidelity,
        stiffness_scale: 1.0,
        structural_damping: 0.0,
        inflow_states: 5,
        temperature_offset: 0.0,
        tunnel_flow: Vector3::zeros(),
    }
}

/// With a mass matrix that deforms, with one that does not, and of the other kind of kinematics.
const LEVELS: [Fidelity; 3] = [Fidelity::Exact, Fidelity::RuthlesslyLinearised, Fidelity::GeometricallyExact];

/// The model with what aircraft usually do without.
fn with_options(mut model: ReducedModel) -> ReducedModel {
    for (place, strip) in model.strips.iter_mut().enumerate() {
        strip.moment_slope = 0.1 + 0.01 * place as f64;
        if let Some(flap) = &mut strip.flap {
            flap.drag = 0.4 + 0.02 * place as f64;
        }
    }
    for (engine, sense) in model.engines.iter_mut().zip([1.0, -1.0]) {
        (engine.torque, engine.angular_momentum) = (-0.2 * sense, 800.0 * sense);
    }
    model
}

/// Rates of the jet, or of what of it moves in the mirror plane, in a disturbed flight with vectors of a given width.
fn evaluate(
    arch: Arch,
    fidelity: Fidelity,
    in_plane: bool,
    options: fn(ReducedModel) -> ReducedModel,
) -> Vec<u64> {
    let mut equations = if in_plane {
        let (model, edge_on) = jet_in_plane();
        EquationsOfMotion::in_plane(&options(model), &edge_on, &configuration(fidelity)).unwrap()
    } else {
        EquationsOfMotion::new(&options(jet().select(&[0, 1, 2, 3, 4])), &configuration(fidelity)).unwrap()
    };
    equations.take_arch(arch);
    let mut state: Vec<f64> = (0..equations.layout().len()).map(|i| libm::sin(i as f64)).collect();
    state[equations.layout().velocity().start] = 127.0;
    let mut rates = vec![0.0; state.len()];
    equations.rates(&state, &equations.neutral_controls(), &mut rates, &mut Workspace::new(&equations));
    rates.into_iter().map(f64::to_bits).collect()
}

#[test]
fn the_width_of_the_vectors_changes_no_bit() {
    let plain = LEVELS.into_iter().flat_map(|fidelity| [(fidelity, false), (fidelity, true)]);
    for (fidelity, in_plane) in plain {
        let narrow = [|model| model, with_options].map(|options: fn(ReducedModel) -> ReducedModel| {
            let narrow = evaluate(Arch::Scalar, fidelity, in_plane, options);
            assert!(narrow.iter().all(|bits| f64::from_bits(*bits).is_finite()));
            assert_eq!(narrow, evaluate(Arch::new(), fidelity, in_plane, options));
            #[cfg(target_arch = "x86_64")]
            if let Some(avx2) = pulp::x86::V3::try_new() {
                assert_eq!(narrow, evaluate(Arch::V3(avx2), fidelity, in_plane, options));
            }
            narrow
        });
        assert_ne!(narrow[0], narrow[1]);
    }
}

#[test]
fn steering_gives_the_same_bits_as_a_new_evaluation() {
    let jet = jet().select(&[0, 1, 2, 3, 4]);
    let models = [jet.clone(), with_options(jet)];
    for (fidelity, model) in LEVELS.into_iter().flat_map(|fidelity| models.each_ref().map(|m| (fidelity, m)))
    {
        let equations = EquationsOfMotion::new(model, &configuration(fidelity)).unwrap();
        let mut state: Vec<f64> = (0..equations.layout().len()).map(|i| libm::sin(i as f64)).collect();
        state[equations.layout().velocity().start] = 127.0;
        let (mut rates, mut workspace) = (vec![0.0; state.len()], Workspace::new(&equations));
        let mut controls = equations.neutral_controls();
        equations.rates(&state, &controls, &mut rates, &mut workspace);
        let before = rates.clone();
        (controls.angles[ELEVATOR], controls.angles[AILERON], controls.angles[AILERON_SYMMETRIC]) =
            (0.1, -0.05, 0.02);
        (controls.angles[RUDDER], controls.thrust) = (0.03, vec![1e4, 2e4]);
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
        let equations = EquationsOfMotion::new(&model, &configuration(Fidelity::Exact)).unwrap();
        let mut state = vec![0.0; equations.layout().len()];
        state[equations.layout().attitude().start] = 1.0;
        state[equations.layout().velocity().start] = 127.0;
        equations.multiplications(&state, &equations.neutral_controls())
    };
    let [none, one, two, three] = [0, 1, 2, 3].map(count);
    assert_eq!([two - one, three - two], [one - none; 2]);
    // Of each strip Ψᵘq, Ψᵠq and their rates for every mode, as often again for their rows.
    assert!(one - none > LANES * 5 * 24 && one - none < LANES * 5 * 24 * 5, "{}", one - none);
}
