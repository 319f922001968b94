//! Section loads at the root of wings that fold on springs, and beside it: statics of known weights and of a force on one tip.
//!
//! [theory: coupled-sections.hinge, section-loads.summation, section-loads.axes, section-loads.components]

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Fidelity};
use flexible_aircraft::equations::SectionLoads;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{Outputs, Plant, PlantSettings, PointLoad};
use flexible_aircraft::structure::ReducedModel;
use nalgebra::Vector3;

use super::coupled_wing::LEVELS;
use super::record::Record;

/// Stubs of 1 m at both sides of O, hung on the wall, and wings of 4 m that fold about x on them, all far stiffer than the springs. They weigh nothing but for
/// two bodies on each wing, at its middle and at its tip; stations are there.
const WINGS: &str = r#"
format = 1
name = "Folding wings"
support = "clamped"
mode_basis = "bending_torsion"
airspeed_m_s = 1
altitude_m = 0
symmetric = true

[[component]]
name = "stub_right"
mirror = "stub_left"
attached_to = "origin"
axis_m = [[0, 0, 0], [0, 1, 0]]
elements = 2
y_axis = [1, 0, 0]
EA_N = 1e9
GJ_N_m2 = 1e9
EI_y_N_m2 = 1e9
EI_z_N_m2 = 1e9

[[component]]
name = "wing_right"
mirror = "wing_left"
attached_to = { component = "stub_right", at = 1 }
axis_m = [[0, 0, 0], [0, 4, 0]]
elements = 4
y_axis = [1, 0, 0]
EA_N = 1e9
GJ_N_m2 = 1e9
EI_y_N_m2 = 1e9
EI_z_N_m2 = 1e9
hinge = { axis = [1, 0, 0], stiffness_N_m_per_rad = 500 }

[[component.point_masses]]
at_m = [2, 4]
mass_kg = [5, 3]
gyration_m = [0.1, 0.1, 0.1]

[[station]]
name = "middle_right"
component = "wing_right"
at = 0.5

[[station]]
name = "tip_right"
component = "wing_right"
at = 1

[[station]]
name = "middle_left"
component = "wing_left"
at = 0.5

[[station]]
name = "tip_left"
component = "wing_left"
at = 1

[[cut]]
name = "stub_right"
component = "stub_right"
at = 1

[[cut]]
name = "root_right"
component = "wing_right"
at = 0

[[cut]]
name = "beyond_right"
component = "wing_right"
at = 0.25

[[cut]]
name = "root_left"
component = "wing_left"
at = 0
"#;

const GRAVITY: f64 = 9.806_65;

/// N m/rad.
const SPRING: f64 = 500.0;

/// Of each wing: kg, and m from the hinge.
const BODIES: [(f64, f64); 2] = [(5.0, 2.0), (3.0, 4.0)];

fn wings() -> Arc<ReducedModel> {
    let aircraft = Aircraft::parse(WINGS, "wings.toml").unwrap_or_else(|error| panic!("{error}"));
    assert!((aircraft.gravity - GRAVITY).abs() < 1e-9, "{}", aircraft.gravity);
    Arc::new(ReducedModel::new(&aircraft, 4).unwrap())
}

fn settings(model: &ReducedModel, fidelity: Fidelity) -> PlantSettings {
    PlantSettings {
        fidelity,
        mode_count: model.natural_modes(),
        inflow_states: 0,
        ..PlantSettings::of(model)
    }
}

/// Outputs and section loads at rest, under a downward force on the right tip, N.
fn at_rest(model: &ReducedModel, fidelity: Fidelity, force: f64) -> (Outputs, Vec<SectionLoads>) {
    let settings = settings(model, fidelity);
    let load =
        PointLoad { station: "tip_right".to_owned(), force: Vector3::z() * force, moment: Vector3::zeros() };
    let plant = Plant::under(model, &settings).unwrap().under_loads(&[load]).unwrap();
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    let outputs = plant.outputs_at(&trim.state, &trim.controls, &mut plant.workspace());
    let loads = plant.loads_at(&trim.state, &trim.controls, &mut plant.workspace());
    (outputs, loads)
}

/// Places of the bodies of a wing where they are now, those of its stations.
fn places(model: &ReducedModel, outputs: &Outputs, side: &str) -> [Vector3<f64>; 2] {
    ["middle", "tip"].map(|name| {
        let name = format!("{name}_{side}");
        let station = model.stations.iter().position(|station| station.name == name).unwrap();
        model.stations[station].position + outputs.deflections[station].displacement
    })
}

/// The angle of a stiff wing on its spring under its bodies and a force at its tip, down: k θ = Σ W a cos θ, or as if it turned by a linear rotation.
fn fold(force: f64, is_finite: bool) -> f64 {
    let moment = BODIES.iter().map(|(mass, arm)| mass * GRAVITY * arm).sum::<f64>() + 4.0 * force;
    if !is_finite {
        return moment / SPRING;
    }
    (0..100).fold(0.3_f64, |theta, _| {
        theta - (SPRING * theta - moment * theta.cos()) / (SPRING + moment * theta.sin())
    })
}

#[test]
fn a_cut_at_a_hinged_root_carries_what_hangs_on_it_in_the_axes_of_what_turns() {
    let mut record = Record::new(
        "hinge-loads",
        "Stiff wings folded down about x on springs of 500 N m/rad by bodies of 5 and 3 kg, 2 and 4 m from their hinges, and by 40 N more on the right tip: \
         loads at the end of the stub, at the root of the wing and 1 m outboard, N and N m, and the angle of the wing, rad",
        "statics: forces times arms where the bodies are; the springs' moment k θ with k θ = Σ W a cos θ, of the levels that superpose displacements with unturned arms. E \
         holds the wing with its EA, which superposition strains ([theory: limits-of-validity.appendages]): there the angle is only what it is",
    );
    let model = wings();
    let cut = |name: &str| model.cuts.iter().position(|cut| cut.name == name).unwrap();
    for (fidelity, force) in LEVELS.into_iter().flat_map(|fidelity| [(fidelity, 0.0), (fidelity, 40.0)]) {
        let (outputs, loads) = at_rest(&model, fidelity, force);
        let case = |what: &str| {
            format!(
                "{}, {}: {what}",
                fidelity.symbol(),
                if force == 0.0 { "both alike" } else { "40 N on the right" }
            )
        };
        // By where the bodies are: all forces are downward.
        let bodies = places(&model, &outputs, "right");
        let weights = [0, 1].map(|body| BODIES[body].0 * GRAVITY + if body == 1 { force } else { 0.0 });
        let weight: f64 = weights.iter().sum();
        let differences = ["stub_right", "root_right", "beyond_right"].map(|name| {
            let load = &loads[cut(name)];
            let moment: Vector3<f64> = bodies
                .iter()
                .zip(weights)
                .map(|(place, weight)| (place - load.position).cross(&(Vector3::z() * weight)))
                .sum();
            let force = (load.force - Vector3::z() * weight).norm() / weight;
            [force, (load.moment - moment).norm() / moment.norm()]
        });
        for (kind, name) in ["forces", "moments"].into_iter().enumerate() {
            let worst = differences.iter().fold(0.0, |worst: f64, cut| worst.max(cut[kind]));
            record.rounding(&case(&format!("{name} at three cuts")), 1e-14, worst);
        }
        let angle = {
            let arm = bodies[1] - Vector3::new(0.0, 1.0, 0.0);
            if fidelity == Fidelity::GeometricallyExact { arm.z.atan2(arm.y) } else { arm.z / 4.0 }
        };
        let expected = match fidelity {
            Fidelity::GeometricallyExact => fold(force, true),
            Fidelity::Rigid => 0.0,
            Fidelity::Exact => angle,
            _ => fold(force, false),
        };
        if expected != 0.0 {
            record.relative(&case("angle"), expected, 1e-5, angle);
        }
        let (stub, root) = (&loads[cut("stub_right")], &loads[cut("root_right")]);
        // The axes turn by the finite rotation whose vector the modes make, at all levels.
        let (cos, sin) = (angle.cos(), angle.sin());
        record.relative(&case("root, shear"), -weight * cos, 5e-6, root.shear);
        record.absolute(&case("root, axial"), weight * sin, 4e-6 * weight, root.axial);
        record.relative(&case("stub, shear"), -weight, 1e-9, stub.shear);
        record.absolute(&case("stub, axial"), 0.0, 4e-6 * weight, stub.axial);
        // Arms across: folded in by the finite rotation alone.
        let arms = if fidelity == Fidelity::GeometricallyExact { cos } else { 1.0 };
        let bending = -(weights[0] * 2.0 + weights[1] * 4.0) * arms;
        record.relative(&case("root, bending"), bending, 1e-6, root.bending);
        record.relative(&case("stub, bending"), bending, 1e-6, stub.bending);
        if !matches!(fidelity, Fidelity::Rigid | Fidelity::Exact) {
            record.relative(&case("root, bending, by the spring"), -SPRING * angle, 1e-5, root.bending);
        }
        record.relative(
            &case("1 m outboard, bending"),
            -(weights[0] + weights[1] * 3.0) * arms,
            1e-6,
            loads[cut("beyond_right")].bending,
        );
        // The other wing knows nothing of the force.
        let left = &loads[cut("root_left")];
        let (_, alone) = at_rest(&model, fidelity, 0.0);
        record.rounding(
            &case("left root, bending"),
            1e-14,
            left.bending / alone[cut("root_right")].bending - 1.0,
        );
    }
    record.finish();
}

#[test]
fn the_half_that_flies_for_both_hinged_wings_carries_what_each_does() {
    let model = wings();
    for fidelity in LEVELS {
        let mut flight =
            Simulation::new(Arc::clone(&model), &Settings::from(settings(&model, fidelity)), 0.0).unwrap();
        assert!(flight.is_symmetric());
        let half = flight.instant_with_loads().outputs.loads.known().unwrap().to_vec();
        let (_, whole) = at_rest(&model, fidelity, 0.0);
        for (half, whole) in half.iter().zip(&whole) {
            assert!((half.force - whole.force).norm() < 1e-9 * whole.force.norm(), "{half:?} {whole:?}");
            assert!((half.moment - whole.moment).norm() < 1e-9 * whole.moment.norm(), "{half:?} {whole:?}");
            assert!((half.bending - whole.bending).abs() < 1e-9 * whole.bending.abs(), "{half:?} {whole:?}");
        }
    }
}
