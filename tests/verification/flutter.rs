//! Flutter and divergence of published wings: a typical section, Goland's wing, Patil's wing.

use std::path::Path;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::{ModeSelection, Plant, PlantSettings, StateMatrix};
use flexible_aircraft::stability::{Crossing, CrossingKind, LossKind, Onset, Sweep};
use flexible_aircraft::structure::{ModeFamily, ReducedModel};
use nalgebra::{Complex, Matrix2, Vector2};

use crate::support::{eight_symmetric, jet};

use super::record::Record;

/// Where the standard atmosphere has Patil's 0.0889 kg/m³, m.
const PATILS_ALTITUDE: f64 = 19_938.0;

/// The roots of a shipped wing over a range of `points` airspeeds.
fn sweep(file: &str, settings: &PlantSettings, [from, to]: [f64; 2], points: usize) -> Sweep {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft").join(file);
    let model = ReducedModel::new(&Aircraft::read(&path).unwrap(), settings.mode_count).unwrap();
    let step = (to - from) / (points - 1) as f64;
    let airspeeds: Vec<f64> = (0..points).map(|i| from + step * i as f64).collect();
    Sweep::new(&model, settings, &airspeeds).unwrap()
}

fn settings(altitude: f64, mode_count: usize, inflow_states: usize) -> PlantSettings {
    PlantSettings { altitude, mode_count, inflow_states, ..PlantSettings::of(&jet()) }
}

/// The lowest onset of a kind: airspeed, m/s, and angular frequency, rad/s.
fn onset(sweep: &Sweep, kind: CrossingKind) -> (f64, f64) {
    let crossing =
        sweep.crossings.iter().find(|crossing| crossing.kind == kind && crossing.is_onset).unwrap();
    (crossing.airspeed, crossing.root.eigenvalue.im)
}

/// Theodorsen's C(k) by Hankel functions of the second kind.
fn theodorsen(k: f64) -> Complex<f64> {
    let h0 = Complex::new(libm::j0(k), -libm::y0(k));
    let h1 = Complex::new(libm::j1(k), -libm::y1(k));
    h1 / (h1 + Complex::<f64>::i() * h0)
}

/// The flutter determinant of the section of [`the_typical_section`] with Theodorsen's function, over πρb⁴ω²;
/// `stiffness` is (ω_θ/ω)².
fn flutter_determinant(k: f64, stiffness: f64) -> Vector2<f64> {
    let (a, e, mu, r2, sigma) = (-0.2, -0.1, 20.0, 0.24, 0.4);
    let (x, ik, c) = (e - a, Complex::<f64>::i() / k, theodorsen(k) * 2.0);
    let circulation = [c * ik, c * (ik * (0.5 - a) + 1.0 / (k * k))];
    let lift = [circulation[0] - 1.0, circulation[1] + ik + a];
    let moment =
        [circulation[0] * (0.5 + a) - a, circulation[1] * (0.5 + a) - ik * (0.5 - a) + 0.125 + a * a];
    let determinant = (lift[0] + mu * (sigma * sigma * stiffness - 1.0))
        * (-moment[1] + mu * r2 * (stiffness - 1.0))
        - (lift[1] - mu * x) * (-moment[0] - mu * x);
    Vector2::new(determinant.re, determinant.im)
}

/// Flutter of the section with Theodorsen's function: U/(bω_θ) and ω/ω_θ, by Newton's method.
fn exact_section_flutter() -> (f64, f64) {
    let mut unknowns = Vector2::new(0.3, 2.4);
    for _ in 0..30 {
        let value = flutter_determinant(unknowns.x, unknowns.y);
        let derivative = |step: Vector2<f64>| {
            let [ahead, behind] =
                [unknowns + step, unknowns - step].map(|at| flutter_determinant(at.x, at.y));
            (ahead - behind) / 2e-6
        };
        let jacobian = Matrix2::from_columns(&[
            derivative(Vector2::new(1e-6, 0.0)),
            derivative(Vector2::new(0.0, 1e-6)),
        ]);
        unknowns -= jacobian.try_inverse().unwrap() * value;
    }
    let frequency = 1.0 / unknowns.y.sqrt();
    (frequency / unknowns.x, frequency)
}

#[test]
fn the_typical_section() {
    // b = 1 m and ω_θ = 20 rad/s in aircraft/typical-section.toml.
    let flutter = |inflow_states| {
        let sweep = sweep("typical-section.toml", &settings(0.0, 2, inflow_states), [5.0, 80.0], 16);
        let (speed, frequency) = onset(&sweep, CrossingKind::Flutter);
        let (divergence, _) = onset(&sweep, CrossingKind::Divergence);
        (speed / 20.0, frequency / 20.0, divergence / 20.0)
    };
    let mut record = Record::new(
        "flutter-section",
        "Flutter of the typical section a = −1/5, e = −1/10, μ = 20, r² = 6/25, σ = 2/5: U/(bω_θ) and ω/ω_θ",
        "D. H. Hodges, G. A. Pierce, *Introduction to Structural Dynamics and Aeroelasticity* (2011), §5.5; Theodorsen's \
         solution solved here too, from the exact Hankel functions; divergence: √(μr²/(1 + 2a))",
    );
    let (speed, frequency, divergence) = flutter(6);
    record.absolute("Peters, N = 6: speed", 2.165, 5e-4, speed);
    record.absolute("Peters, N = 6: frequency", 0.6545, 5e-5, frequency);
    record.rounding("divergence speed, relative to 2.8284: deviation", 1e-6, divergence / 8_f64.sqrt() - 1.0);
    let exact = exact_section_flutter();
    record.absolute("Theodorsen, solved in the test: speed", 2.184, 5e-4, exact.0);
    record.absolute("Theodorsen, solved in the test: frequency", 0.649, 5e-4, exact.1);
    let (speed, frequency, _) = flutter(8);
    record.relative("Peters, N = 8, against Theodorsen: speed", exact.0, 3e-3, speed);
    record.relative("Peters, N = 8, against Theodorsen: frequency", exact.1, 3e-3, frequency);
    record.finish();
}

#[test]
fn the_wings_of_goland_and_patil() {
    let mut record = Record::new(
        "flutter-wings",
        "Flutter (m/s, rad/s) and divergence (m/s) of cantilever wings, undeformed, N = 8, 8 modes",
        "M. Goland, J. Appl. Mech. 12 (1945) A197 and issue 3 of the project; M. J. Patil, D. H. Hodges, C. E. S. Cesnik, \
         J. Aircraft 38 (2001) 88 and issue 3; divergence of a uniform wing: Bisplinghoff, Ashley, Halfman, \
         *Aeroelasticity* (1955), §8-2",
    );
    let uniform_divergence = |length: f64, torsional_stiffness: f64, chord: f64, arm: f64, density: f64| {
        let wave_number = std::f64::consts::FRAC_PI_2 / length;
        let pressure =
            torsional_stiffness * wave_number * wave_number / (chord * arm * std::f64::consts::TAU);
        (2.0 * pressure / density).sqrt()
    };

    let goland = sweep("goland-wing.toml", &settings(0.0, 8, 8), [100.0, 300.0], 9);
    let (speed, frequency) = onset(&goland, CrossingKind::Flutter);
    record.relative("Goland: flutter speed", 137.3, 1e-3, speed);
    record.relative("Goland: flutter frequency", 70.1, 1e-3, frequency);
    let expected = uniform_divergence(6.096, 0.99e6, 1.8288, 0.08 * 1.8288, 1.225);
    record.relative(
        "Goland: divergence speed, closed form",
        expected,
        1e-3,
        onset(&goland, CrossingKind::Divergence).0,
    );

    // Undeformed wings move alike at every level.
    let alike = PlantSettings { fidelity: Fidelity::GeometricallyExact, ..settings(0.0, 8, 8) };
    let alike = onset(&sweep("goland-wing.toml", &alike, [100.0, 150.0], 6), CrossingKind::Flutter);
    record.relative("Goland, GE: flutter speed of E", speed, 1e-5, alike.0);
    record.relative("Goland, GE: flutter frequency of E", frequency, 1e-5, alike.1);

    let patil = sweep("patil-wing.toml", &settings(PATILS_ALTITUDE, 8, 8), [20.0, 45.0], 6);
    let (speed, frequency) = onset(&patil, CrossingKind::Flutter);
    let divergence = onset(&patil, CrossingKind::Divergence).0;
    record.relative("Patil: flutter speed", 32.5, 2e-3, speed);
    record.relative("Patil: flutter frequency", 22.4, 5e-3, frequency);
    record.relative("Patil: divergence speed", 37.15, 1e-3, divergence);
    let expected = uniform_divergence(16.0, 1e4, 1.0, 0.25, 0.0889);
    record.relative("Patil: divergence speed, closed form", expected, 1e-3, divergence);

    let patil = sweep("patil-wing.toml", &settings(PATILS_ALTITUDE, 8, 6), [20.0, 45.0], 6);
    let (speed, frequency) = onset(&patil, CrossingKind::Flutter);
    record.relative("Patil, as published, N = 6: flutter speed", 32.21, 5e-3, speed);
    record.relative("Patil, as published, N = 6: flutter frequency", 22.61, 5e-3, frequency);
    record.relative(
        "Patil, as published: divergence speed",
        37.29,
        5e-3,
        onset(&patil, CrossingKind::Divergence).0,
    );
    record.finish();
}

#[test]
fn a_coarse_range_finds_the_same_flutter_as_a_fine_one() {
    let flutter = |points| {
        let sweep = sweep("goland-wing.toml", &settings(0.0, 4, 4), [60.0, 180.0], points);
        onset(&sweep, CrossingKind::Flutter)
    };
    let (coarse, fine) = (flutter(3), flutter(25));
    assert!((coarse.0 / fine.0 - 1.0).abs() < 1e-6, "{coarse:?} {fine:?}");
    assert!((coarse.1 / fine.1 - 1.0).abs() < 1e-6, "{coarse:?} {fine:?}");
}

#[test]
fn below_its_flutter_speed_a_wing_has_no_crossing() {
    assert!(sweep("goland-wing.toml", &settings(0.0, 4, 4), [60.0, 130.0], 8).crossings.is_empty());
}

#[test]
fn branches_are_distinct_roots_at_every_speed() {
    let sweep = sweep("goland-wing.toml", &settings(0.0, 4, 4), [60.0, 180.0], 13);
    for index in 0..sweep.airspeeds.len() {
        let roots: Vec<_> = sweep.branches.iter().filter_map(|branch| branch.roots[index].as_ref()).collect();
        assert!(roots.len() >= 4);
        for (one, root) in roots.iter().enumerate() {
            assert!(roots[..one].iter().all(|other| !root.is_at(other.eigenvalue)), "{index}: {root:?}");
        }
    }
}

#[test]
fn a_speed_at_which_a_free_aircraft_has_no_trim_is_skipped_and_the_others_are_not() {
    let sweep = Sweep::new(&jet(), &eight_symmetric().plant, &[3.0, 127.0, 130.0]).unwrap();
    let [skipped] = sweep.skipped.as_slice() else { panic!("{:?}", sweep.skipped) };
    assert_eq!(skipped.airspeed, 3.0);
    assert!(skipped.reason.to_string().contains("no steady level flight found at 3 m/s"));
    assert_eq!(sweep.airspeeds, [127.0, 130.0]);
    // [theory: thesis-runs.eigenvalues]: the short period at 127 m/s, with these modes.
    let short_period = Complex::new(-0.534, 1.186);
    let nearest = sweep.branches.iter().filter_map(|branch| branch.roots[0].as_ref());
    assert!(nearest.into_iter().any(|root| (root.eigenvalue - short_period).norm() < 1e-3));
}

/// A uniform wing of 7 m swept 30° forward, in a wind tunnel without gravity.
fn forward_swept(incidence_deg: f64) -> ReducedModel {
    let text = format!(
        r#"
        format = 1
        name = "Wing swept forward"
        gravity_m_s2 = 0
        support = "clamped"
        mode_basis = "bending_torsion"
        model = "exact"
        altitude_m = 0

        [[component]]
        name = "wing"
        attached_to = "origin"
        axis_m = [[0, 0, 0], [3.5, 6.0621778, 0]]
        elements = 12
        y_axis = [1, 0, 0]
        chord_m = 1.5
        EA_N = 1e8
        GJ_N_m2 = 8e5
        EI_y_N_m2 = 6e5
        EI_z_N_m2 = 6e6

        [[component.distributed_mass]]
        parts = [{{ total_kg = 80 }}]
        gyration_chords = [0, 0.25, 0.25]
        gyration_lengths = [0.2887, 0, 0.2887]

        [[component.surface]]
        elastic_axis = 0.4
        incidence_deg = {incidence_deg}
        lift_slope_per_rad = 5.5
        profile_drag = 0.008
        "#
    );
    ReducedModel::new(&Aircraft::parse(&text, "forward-swept.toml").unwrap(), 6).unwrap()
}

fn linearised(model: &ReducedModel, settings: &PlantSettings, airspeed: f64) -> Option<StateMatrix> {
    let settings = PlantSettings { airspeed, ..*settings };
    let equations = Plant::under(model, &settings).unwrap();
    let trim = equations.trim(&settings.trim_condition()).ok()?;
    Some(equations.linearise(&trim))
}

/// Uniform wings have nearly equal roots in their wake, on which an eigensolver may go in circles.
/// Uniform wings have nearly equal roots in their wake, on which an eigensolver may go in circles.
#[test]
fn eigenvalues_of_a_uniform_wing_are_found_at_every_speed() {
    let (model, settings) = (forward_swept(0.01), settings(0.0, 6, 5));
    let is_found = |&speed: &i32| {
        linearised(&model, &settings, f64::from(speed)).is_some_and(|matrix| matrix.eigenvalues().is_ok())
    };
    assert_eq!((20..66).filter(is_found).count(), 46);
}

/// At a trace of incidence the trim leaves the equilibrium that bends with the load for the one that is unstable, near
/// the speed at which the straight wing diverges: no root crosses the stability limit.
#[test]
fn every_speed_with_an_unstable_root_is_reported_though_none_crosses() {
    let airspeeds: Vec<f64> = (10..=50).map(|point| 2.0 * f64::from(point)).collect();
    let straight = Sweep::new(&forward_swept(0.0), &settings(0.0, 6, 5), &airspeeds).unwrap();
    let (divergence, _) = onset(&straight, CrossingKind::Divergence);
    assert!((66.0..67.5).contains(&divergence), "{divergence}");
    for (fidelity, incidence, latest) in [
        (Fidelity::Exact, 0.001, 1.03),
        (Fidelity::Exact, 0.01, 1.06),
        (Fidelity::Exact, 0.05, 1.15),
        (Fidelity::ConsistentlyLinearised, 0.02, 1.01),
        (Fidelity::Inconsistent, 0.02, 1.01),
    ] {
        let settings = PlantSettings { fidelity, ..settings(0.0, 6, 5) };
        let model = forward_swept(incidence);
        let sweep = Sweep::new(&model, &settings, &airspeeds).unwrap();
        let case = format!("{fidelity:?} {incidence}: {:?} {:?}", sweep.losses, sweep.unstable);
        assert!(sweep.crossings.is_empty(), "{case}");
        let mut unstable = 0;
        for &airspeed in &sweep.airspeeds {
            let eigenvalues = linearised(&model, &settings, airspeed).unwrap().eigenvalues().unwrap();
            let is_unstable = eigenvalues.iter().any(|eigenvalue| eigenvalue.re > 1e-6);
            let is_told =
                sweep.unstable.iter().any(|range| range.first <= airspeed && airspeed <= range.last);
            assert_eq!(is_told, is_unstable, "{airspeed} m/s, {case}");
            unstable += usize::from(is_unstable);
        }
        assert!(unstable > 10, "{case}");
        // Where the equilibrium is lost is named, and that the root appears there.
        let lost = sweep.losses.first().unwrap_or_else(|| panic!("{case}")).between[0] / divergence;
        assert!((0.99..latest).contains(&lost), "{lost}: {case}");
        let onset = sweep.unstable[0].onset;
        assert!(matches!(onset, Onset::Loss(_) | Onset::AfterGap(_)), "{case}");
    }
}

/// The cubic energy of the consistently linearised model has another equilibrium there, metres away.
#[test]
fn a_jump_to_another_equilibrium_is_named_with_what_moves() {
    let settings = PlantSettings { fidelity: Fidelity::ConsistentlyLinearised, ..settings(0.0, 6, 5) };
    let model = forward_swept(0.05);
    let sweep = Sweep::new(&model, &settings, &[60.0, 64.0, 66.0, 68.0]).unwrap();
    let [loss] = sweep.losses.as_slice() else { panic!("{:?}", sweep.losses) };
    let LossKind::Jump { component, displacement } = &loss.kind else { panic!("{loss:?}") };
    assert!(component == "wing" && (1.0..10.0).contains(displacement), "{loss:?}");
    assert!(
        (66.0..68.0).contains(&loss.between[0]) && loss.between[1] / loss.between[0] < 1.000_02,
        "{loss:?}"
    );
    // The trims at the two airspeeds, a hundred-thousandth apart.
    let [below, above] = loss.between.map(|airspeed| {
        let settings = PlantSettings { airspeed, ..settings };
        let equations = Plant::under(&model, &settings).unwrap();
        let trim = equations.trim(&settings.trim_condition()).unwrap();
        trim.state[equations.layout().coordinates()][0]
    });
    assert!((below - above).abs() > 1.0, "{below} {above}");
    assert_eq!(sweep.unstable[0].onset, Onset::Loss(loss.between[0]));
}

/// Nothing of the kind is found where a wing bends steadily.
#[test]
fn a_continuous_equilibrium_is_not_lost() {
    let airspeeds: Vec<f64> = (2..=6).map(|point| 10.0 * f64::from(point)).collect();
    for incidence in [0.0, 0.01, 2.0] {
        let sweep = Sweep::new(&forward_swept(incidence), &settings(0.0, 6, 5), &airspeeds).unwrap();
        assert!(sweep.losses.is_empty() && sweep.unstable.is_empty(), "{:?}", sweep.losses);
    }
}

/// The phugoid of a sailplane whose wing is soft in torsion becomes two real roots, of which one grows, between two airspeeds: the branch of that
/// one begins and crosses between them, and eigenvalues of whole state matrices beside the crossing say the same.
#[test]
fn one_of_two_real_roots_that_a_pair_leaves_is_seen_to_cross() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/sailplane.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let soft = text.replacen("factor = 0.7 }", "factor = 0.3 }", 1);
    assert_ne!(soft, text);
    let model = ReducedModel::new(&Aircraft::parse(&soft, "soft.toml").unwrap(), 20).unwrap();
    let symmetric = model.modes.iter().filter(|mode| mode.family == ModeFamily::Symmetric).count();
    let settings = PlantSettings {
        mode_count: symmetric,
        mode_selection: ModeSelection::Symmetric,
        ..PlantSettings::of(&model)
    };
    let sweep = Sweep::new(&model, &settings, &[76.0, 84.0]).unwrap();
    let is_onset = |crossing: &&Crossing| crossing.is_onset;
    let crossing = sweep.crossings.iter().find(is_onset).unwrap_or_else(|| panic!("{:?}", sweep.unstable));
    assert_eq!(crossing.kind, CrossingKind::Divergence);
    assert_eq!(sweep.unstable[0].onset, Onset::Crossing(crossing.airspeed));
    let growth = |airspeed: f64| {
        let settings = PlantSettings { airspeed, ..settings };
        let plant = Plant::under(&model, &settings).unwrap();
        let trim = plant.trim(&settings.trim_condition()).unwrap();
        plant.linearise(&trim).eigenvalues().unwrap().iter().map(|root| root.re).fold(f64::MIN, f64::max)
    };
    let [below, above] = [-0.01, 0.01].map(|beside| growth(crossing.airspeed + beside));
    assert!(below < 1e-6 && above > 1e-5, "{} m/s: {below} {above}", crossing.airspeed);
}
