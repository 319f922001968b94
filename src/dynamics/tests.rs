//! The equations as a whole.

use nalgebra::Vector3;
use pulp::Arch;

use super::{Configuration, Controls, EquationsOfMotion, Fidelity, Workspace};
use crate::variables::tests::jet;

/// Rates and accelerations of the jet in a disturbed flight with vectors of a given width.
fn evaluate(arch: Arch, fidelity: Fidelity) -> Vec<u64> {
    let configuration = Configuration {
        fidelity,
        stiffness_scale: 1.0,
        structural_damping: 0.0,
        inflow_states: 5,
        tunnel_flow: Vector3::zeros(),
    };
    let mut equations = EquationsOfMotion::new(&jet().select(&[0, 1, 2, 3, 4]), &configuration);
    equations.take_arch(arch);
    let mut state: Vec<f64> = (0..equations.layout().len()).map(|i| libm::sin(i as f64)).collect();
    state[equations.layout().velocity().start] = 127.0;
    let mut rates = vec![0.0; state.len()];
    equations.rates(&state, &Controls::neutral(2), &mut rates, &mut Workspace::new(&equations));
    rates.into_iter().map(f64::to_bits).collect()
}

#[test]
fn the_width_of_the_vectors_changes_no_bit() {
    for fidelity in [Fidelity::Exact, Fidelity::RuthlesslyLinearised] {
        let narrow = evaluate(Arch::Scalar, fidelity);
        assert!(narrow.iter().all(|bits| f64::from_bits(*bits).is_finite()));
        assert_eq!(narrow, evaluate(Arch::new(), fidelity));
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = pulp::x86::V3::try_new() {
            assert_eq!(narrow, evaluate(Arch::V3(avx2), fidelity));
        }
    }
}
