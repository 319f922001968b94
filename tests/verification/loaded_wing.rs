//! Patil's wing under a dead force at its tip: flutter of the bent wing; and what a rod on it does that weighs nothing.
//!
//! [theory: gravity-and-thrust.point-loads, geometrically-exact.recursion, limits-of-validity.appendages]

use flexible_aircraft::aircraft::{Aircraft, Beam, Fidelity, TunnelAir};
use flexible_aircraft::plant::{Plant, PlantSettings, PointLoad};
use flexible_aircraft::stability::{CrossingKind, Sweep};
use flexible_aircraft::structure::ReducedModel;
use nalgebra::Vector3;

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

/// Tip force, N; range of airspeeds, m/s; flutter speed and frequency (rad/s) of AeroBeams and of an independent computation.
const FLUTTER: [(f64, [f64; 2], [f64; 2], [f64; 2]); 3] = [
    (20.0, [25.0, 26.5], [26.00, 17.86], [25.62, 17.94]),
    (30.0, [21.5, 23.0], [22.78, 15.11], [22.12, 15.18]),
    (40.0, [22.0, 23.5], [22.80, 12.64], [22.65, 12.67]),
];

#[test]
fn a_wing_bent_by_a_dead_force_flutters_where_others_find_it() {
    let mut record = Record::new(
        "flutter-loaded",
        "Patil's wing without weight at 0°, ρ = 0.08803 kg/m³, bent by a dead force at its tip, N = 8, 12 modes, GE: flutter",
        "AeroBeams.jl, another program for geometrically exact beams; an independent computation with the same strips and modes",
    );
    let model = ReducedModel::new(&wing(), 12).unwrap();
    let settings = PlantSettings { inflow_states: 8, ..settings(&model, Fidelity::GeometricallyExact) };
    for (force, airspeeds, published, independent) in FLUTTER {
        let sweep = Sweep::under_loads(&model, &settings, &airspeeds, &[pull(force)]).unwrap();
        let is_flutter = |crossing: &&flexible_aircraft::stability::Crossing| {
            crossing.kind == CrossingKind::Flutter && crossing.is_onset
        };
        let flutter = sweep.crossings.iter().find(is_flutter).unwrap();
        let (speed, frequency) = (flutter.airspeed, flutter.root.eigenvalue.im);
        record.relative(&format!("{force} N: speed, AeroBeams, m/s"), published[0], 0.04, speed);
        record.relative(&format!("{force} N: frequency, AeroBeams, rad/s"), published[1], 0.015, frequency);
        record.absolute(&format!("{force} N: speed, independent, m/s"), independent[0], 0.02, speed);
        record.absolute(
            &format!("{force} N: frequency, independent, rad/s"),
            independent[1],
            0.02,
            frequency,
        );
    }
    record.finish();
}

/// A rod of 1 m as stiff as nothing on the wing is, forwards from its middle; it weighs nothing.
fn with_rod(mut wing: Aircraft) -> Aircraft {
    let middle = wing.nodes.iter().position(|node| (node.y - 8.0).abs() < 1e-9).unwrap();
    wing.nodes.push(wing.nodes[middle] + Vector3::x());
    wing.beams.push(Beam {
        component: "rod".to_owned(),
        nodes: [middle, wing.nodes.len() - 1],
        y_axis: Vector3::y(),
        axial_stiffness: 1e9,
        torsional_stiffness: 1e7,
        bending_stiffness_y: 1e7,
        bending_stiffness_z: 1e7,
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
    let without_strips = Aircraft { strips: Vec::new(), ..wing() };
    let [bare, rod] = [without_strips.clone(), with_rod(without_strips)]
        .map(|aircraft| ReducedModel::new(&aircraft, 8).unwrap());
    let mut record = Record::new(
        "weightless-rod",
        "Patil's wing with a weightless rod of 1 m (EA 10⁹ N, EI 10⁷ N m²) across its middle, a force of 40 N at the tip: change of the tip's deflection, over it",
        "statics: what carries nothing is not loaded",
    );
    let change = |fidelity| {
        let [bare, rod] = [&bare, &rod].map(|model| deflection(model, fidelity, 40.0));
        [(rod - bare).norm() / bare.norm(), bare.norm()]
    };
    let [exact, far] = change(Fidelity::GeometricallyExact);
    record.at_least("GE: deflection, m", 1.0, far);
    record.rounding("GE", 1e-7, exact);
    record.at_least("E", 1e-3, change(Fidelity::Exact)[0]);
    record.finish();
}
