//! Clamped modes and mass of the jet [theory: thesis-runs.frequencies, thesis-runs.aircraft].

use flexible_aircraft::structure::ModeFamily::{self, Antisymmetric, Symmetric};

use super::record::Record;
use crate::support::jet;

/// Nominal clamped frequencies, Hz [theory: thesis-runs.frequencies].
const FREQUENCIES: [(f64, ModeFamily); 12] = [
    (2.166, Symmetric),
    (2.166, Antisymmetric),
    (3.968, Symmetric),
    (3.968, Antisymmetric),
    (4.542, Antisymmetric),
    (4.733, Symmetric),
    (6.262, Antisymmetric),
    (7.647, Symmetric),
    (7.647, Antisymmetric),
    (8.662, Symmetric),
    (8.756, Symmetric),
    (8.798, Antisymmetric),
];

#[test]
fn the_twelve_lowest_clamped_frequencies_and_the_mass_are_the_published_ones() {
    let mut record = Record::new(
        "frequencies",
        "Clamped modes of the jet, Hz, and its mass, kg",
        "[theory: thesis-runs.frequencies, thesis-runs.aircraft]",
    );
    for (index, (mode, (frequency, family))) in jet().modes.iter().zip(FREQUENCIES).enumerate() {
        let found = mode.angular_frequency / std::f64::consts::TAU;
        assert_eq!(mode.family, family, "{frequency} Hz");
        // Half a unit of the last published digit.
        record.absolute(&format!("mode {}, {family:?}", index + 1), frequency, 5e-4, found);
    }
    record.absolute("mass", 29_224.0, 0.5, jet().integrals.mass);
    record.finish();
}

#[test]
fn modes_are_mass_normalised_and_uncoupled_in_mass() {
    let jet = jet();
    let n = jet.modes.len();
    for a in 0..n {
        for b in 0..n {
            let expected = f64::from(a == b);
            assert!((jet.integrals.mass_matrix[a * n + b] - expected).abs() < 1e-9, "{a} {b}");
        }
    }
}
