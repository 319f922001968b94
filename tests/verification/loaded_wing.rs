//! Patil's wing under a dead force at its tip: flutter of the bent wing; and what a rod on it does that weighs nothing.
//!
//! [theory: gravity-and-thrust.point-loads, geometrically-exact.recursion, limits-of-validity.appendages]

use flexible_aircraft::aircraft::{Aircraft, Beam, Coupling, Fidelity, ModeBasis, TunnelAir};
use flexible_aircraft::plant::{Plant, PlantSettings, PointLoad};
use flexible_aircraft::stability::Sweep;
use flexible_aircraft::structure::ReducedModel;
use nalgebra::{Complex, Vector3};

use crate::support::linearised::eigenvalue_near;

use super::record::Record;

/// The shipped wing in the air of the publication.
fn wing() -> Aircraft {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/aircraft/patil-wing.toml");
    let tunnel_air = Some(TunnelAir { density: 0.088_03, temperature: 288.15 });
    Aircraft { tunnel_air, ..Aircraft::read(path).unwrap() }
}

/// Up, N.
fn pull(force: f64) -> PointLoad {
    PointLoad { station: "tip".to_owned(), force: Vector3::z() * -force, moment: Vector3::zeros() }
}

fn settings(model: &ReducedModel, fidelity: Fidelity) -> PlantSettings {
    PlantSettings { fidelity, ..PlantSettings::of(model) }
}

/// Tip force, N; flutter speed, m/s, and frequency, rad/s, of AeroBeams.jl and of an independent computation.
const FLUTTER: [(f64, [f64; 2], [f64; 2]); 3] = [
    (20.0, [26.00, 17.86], [25.62, 17.94]),
    (30.0, [22.78, 15.11], [22.12, 15.18]),
    (40.0, [22.80, 12.64], [22.65, 12.67]),
];

/// The root near a frequency of the wing pulled at its tip in a flow.
fn root(model: &ReducedModel, force: f64, airspeed: f64, frequency: f64) -> Complex<f64> {
    let settings = PlantSettings { airspeed, ..settings(model, Fidelity::GeometricallyExact) };
    let plant = Plant::under(model, &settings).unwrap().under_loads(&[pull(force)]).unwrap();
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    eigenvalue_near(&plant.linearise(&trim).matrix, Complex::new(0.0, frequency))
}

/// Where the root neither grows nor decays, by the secant method: airspeed and frequency.
fn flutter(model: &ReducedModel, force: f64, [speed, frequency]: [f64; 2]) -> [f64; 2] {
    let at = |speed: f64| (speed, root(model, force, speed, frequency));
    let (mut before, mut last) = (at(speed - 0.2), at(speed + 0.2));
    assert!(before.1.re < 0.0 && last.1.re > 0.0, "{before:?} {last:?}");
    for _ in 0..2 {
        let ((v0, r0), (v1, r1)) = (before, last);
        before = last;
        last = at(v1 - r1.re * (v1 - v0) / (r1.re - r0.re));
    }
    [last.0, last.1.im]
}

#[test]
fn a_wing_bent_by_a_dead_force_flutters_where_others_find_it() {
    let mut record = Record::new(
        "flutter-loaded",
        "Patil's wing without weight at 0°, ρ = 0.08803 kg/m³, bent by a dead force at its tip, N = 8, 12 modes, GE: flutter",
        "AeroBeams.jl (L. Pancini; wing of M. J. Patil, D. H. Hodges, C. E. S. Cesnik, J. Aircraft 38 (2001) 88); an independent \
         computation of [theory: geometrically-exact.recursion] with the same modes",
    );
    let model = ReducedModel::new(&wing(), 12).unwrap();
    assert_eq!(model.inflow_states, 8);
    for (force, published, independent) in FLUTTER {
        let [speed, frequency] = flutter(&model, force, independent);
        record.relative(&format!("{force} N: speed, AeroBeams, m/s"), published[0], 0.04, speed);
        record.relative(&format!("{force} N: frequency, AeroBeams, rad/s"), published[1], 0.015, frequency);
        record.relative(&format!("{force} N: speed, independent, m/s"), independent[0], 2e-3, speed);
        record.relative(
            &format!("{force} N: frequency, independent, rad/s"),
            independent[1],
            1e-3,
            frequency,
        );
    }
    record.finish();
}

#[test]
fn a_sweep_finds_the_flutter_of_a_loaded_wing_and_without_force_that_of_the_wing() {
    let model = ReducedModel::new(&wing(), 12).unwrap();
    let settings = PlantSettings { inflow_states: 2, ..settings(&model, Fidelity::GeometricallyExact) };
    let onset =
        |sweep: &Sweep| sweep.crossings.iter().find(|crossing| crossing.is_onset).map(|onset| onset.airspeed);
    let loaded =
        |force, speeds: &[f64]| Sweep::under_loads(&model, &settings, speeds, &[pull(force)]).unwrap();
    let found = onset(&loaded(30.0, &[20.0, 24.0])).unwrap();
    assert!(20.0 < found && found < 22.2, "{found}");
    let plain = Sweep::new(&model, &settings, &[24.0, 35.0]).unwrap();
    assert_eq!(onset(&loaded(0.0, &[24.0, 35.0])), onset(&plain));
    assert!(onset(&plain).unwrap() > 30.0, "{:?}", onset(&plain));
    let nowhere = PointLoad { station: "root".to_owned(), ..pull(1.0) };
    let refused = Sweep::under_loads(&model, &settings, &[24.0], &[nowhere]).unwrap_err();
    assert_eq!(refused.to_string(), "point load: found station \"root\", allowed are tip");
}

/// With a rod that hangs from the middle of the wing, 1 m long, as stiff as nothing else is in bending; it weighs nothing.
fn with_rod(mut wing: Aircraft) -> Aircraft {
    let middle = wing.nodes.iter().position(|node| (node.y - 8.0).abs() < 1e-9).unwrap();
    wing.nodes.push(wing.nodes[middle] + Vector3::z());
    wing.beams.push(Beam {
        component: "rod".to_owned(),
        nodes: [middle, wing.nodes.len() - 1],
        y_axis: Vector3::y(),
        axial_stiffness: 1e7,
        torsional_stiffness: 1e7,
        bending_stiffness_y: 1e7,
        bending_stiffness_z: 1e7,
        coupling: Coupling::NONE,
        hinge: None,
    });
    wing
}

/// How far a force moves the tip, m.
fn deflection(model: &ReducedModel, fidelity: Fidelity, force: f64) -> Vector3<f64> {
    let settings = settings(model, fidelity);
    let plant = Plant::under(model, &settings).unwrap().under_loads(&[pull(force)]).unwrap();
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    let outputs = plant.outputs_at(&trim.state, &trim.controls, &mut plant.workspace());
    outputs.deflections[0].displacement
}

#[test]
fn a_weightless_rigid_rod_on_a_wing_changes_nothing_but_where_rotations_are_linear() {
    // In modes of the real axial stiffness, for that of axially rigid beams rounds.
    let without_strips = Aircraft { strips: Vec::new(), mode_basis: ModeBasis::Full, ..wing() };
    let [bare, rod] = [without_strips.clone(), with_rod(without_strips)]
        .map(|aircraft| ReducedModel::new(&aircraft, 8).unwrap());
    let mut record = Record::new(
        "weightless-rod",
        "Patil's wing with a weightless rod of 1 m (EA 10⁷ N, EI 10⁷ N m²) under its middle, a force of 40 N at the tip, 8 modes of a full basis: change of the tip's deflection, over it",
        "statics: what carries nothing is not loaded",
    );
    let change = |fidelity| {
        let [bare, rod] = [&bare, &rod].map(|model| deflection(model, fidelity, 40.0));
        [(rod - bare).norm() / bare.norm(), bare.norm(), 1.0 - rod.norm() / bare.norm()]
    };
    let [exact, far, _] = change(Fidelity::GeometricallyExact);
    record.at_least("GE: deflection, m", 1.0, far);
    record.rounding("GE", 2e-9, exact);
    record.at_least("E: stiffer by", 0.015, change(Fidelity::Exact)[2]);
    record.finish();
}
