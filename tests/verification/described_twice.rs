//! One wing described twice flies the same at every level: about a reference axis elsewhere along the chord, and with the local axes of its
//! sections turned. All couplings are there, tension axis and shear centre apart from each other.
//!
//! [theory: coupled-sections.energy, coupled-sections.element, coupled-sections.rigid, coupled-sections.higher, coupled-sections.mirrored]

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Fidelity};
use flexible_aircraft::equations::SectionLoads;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::{Plant, PlantSettings};
use flexible_aircraft::structure::{ModeFamily, ReducedModel};
use nalgebra::Vector3;

use super::coupled_wing::{ALL_COUPLINGS, LEVELS, swept};
use super::record::Record;
use crate::support::redescribed::turned;

/// A wing of 6 m with a chord of 1 m in a wind tunnel, under its weight. Its sections have their shear centre at 0.35 chords, their tension axis
/// at 0.45, their centre of mass at 0.42; the axis runs AXIS metres behind the first of these.
const WING: &str = r#"
format = 1
name = "Half wing"
support = "clamped"
mode_basis = "bending_torsion"
airspeed_m_s = 35
altitude_m = 0
gravity_m_s2 = GRAVITY

[[control]]
name = "flap"
positive = "down"
mirror = "same"

[[component]]
name = "wing"
attached_to = "origin"
axis_m = [[0, 0, 0], [0, 6, 0]]
elements = 10
y_axis = [1, 0, 0]
chord_m = 1
EA_N = 2e7
GJ_N_m2 = 4e4
EI_y_N_m2 = 5e4
EI_z_N_m2 = 4e5
EI_yz_N_m2 = 6e4
bend_twist_y_N_m2 = 1e4
bend_twist_z_N_m2 = -2e4
tension_axis_y_m = TENSION
tension_axis_z_m = 0.02
shear_centre_y_m = SHEAR
shear_centre_z_m = -0.01

[[component.distributed_mass]]
parts = [{ total_kg = 60 }]
offset_m = [MASS, 0, 0.01]
gyration_chords = [0.02, 0.25, 0.25]
gyration_lengths = [0.2887, 0, 0.2887]

[[component.surface]]
elastic_axis = ELASTIC
zero_lift_offset_deg = ANGLE
lift_slope_per_rad = 6
zero_lift_moment = MOMENT
profile_drag = 0
leading_edge_suction = 0.8
flap = { lift_slope_per_rad = 3, hinge = 0.75 }
control = [{ input = "flap", gain = 1 }]

[[station]]
name = "tip"
component = "wing"
at = 1

[[cut]]
name = "root"
component = "wing"
at = 0

[[cut]]
name = "middle"
component = "wing"
at = 0.5
"#;

/// About an axis so far behind the line of shear centres, m, with so much of its loads.
fn about(behind: f64, load: f64) -> Arc<ReducedModel> {
    let numbers = [
        ("SHEAR", behind),
        ("TENSION", behind - 0.1),
        ("MASS", behind - 0.07),
        ("ELASTIC", behind + 0.35),
        ("GRAVITY", 9.80665 * load),
        ("ANGLE", 3.0 * load),
        ("MOMENT", -0.03 * load),
    ];
    let write = |text: String, (name, number): (&str, f64)| text.replace(name, &format!("{number:.9}"));
    let text = numbers.into_iter().fold(WING.to_owned(), write);
    let aircraft = Aircraft::parse(&text, "wing.toml").unwrap_or_else(|error| panic!("{error}"));
    Arc::new(ReducedModel::new(&aircraft, 10).unwrap())
}

/// What is seen at an instant: the twist of the first station, and all section loads.
struct Seen {
    twist: f64,
    loads: Vec<SectionLoads>,
}

/// In trim, and after half a second with a control moved by such an angle, rad.
fn flown(model: &Arc<ReducedModel>, fidelity: Fidelity, angle: f64) -> [Seen; 2] {
    let plant = PlantSettings { fidelity, mode_count: model.natural_modes(), ..PlantSettings::of(model) };
    let settings = Settings { tolerance: 1e-10, ..plant.into() };
    let mut flight = Simulation::new(Arc::clone(model), &settings, 0.0).unwrap();
    let see = |flight: &mut Simulation| {
        let outputs = &flight.instant_with_loads().outputs;
        Seen { twist: outputs.deflections[0].twist, loads: outputs.loads.known().unwrap().to_vec() }
    };
    let trimmed = see(&mut flight);
    let zero = Inputs::zero(model);
    flight.set_inputs(&Inputs { controls: vec![angle; model.controls.len()], ..zero.clone() }, &zero);
    flight.advance_to(0.5).unwrap();
    let later = see(&mut flight);
    [trimmed, later]
}

/// The largest difference of twists over the largest twist, and of forces and of moments about O at the cuts over the largest of each; O of the
/// other description is so far ahead.
fn differ(one: &Seen, other: &Seen, ahead: f64) -> [f64; 3] {
    let about_origin = |load: &SectionLoads| load.moment + load.position.cross(&load.force);
    let mut worst = [(one.twist - other.twist).abs() / one.twist.abs(), 0.0, 0.0];
    let [force, moment] = [0, 1].map(|kind| {
        let sizes = one.loads.iter().map(|load| [load.force, about_origin(load)][kind].norm());
        sizes.fold(0.0_f64, f64::max)
    });
    for (one, other) in one.loads.iter().zip(&other.loads) {
        let carried = about_origin(other) + (Vector3::x() * -ahead).cross(&other.force);
        worst[1] = worst[1].max((one.force - other.force).norm() / force);
        worst[2] = worst[2].max((about_origin(one) - carried).norm() / moment);
    }
    worst
}

/// The largest relative difference of the eigenvalues at rest.
fn roots_differ(models: [&Arc<ReducedModel>; 2], fidelity: Fidelity) -> f64 {
    let [one, other] = models.map(|model| {
        let settings =
            PlantSettings { fidelity, mode_count: model.natural_modes(), ..PlantSettings::of(model) };
        let plant = Plant::under(model, &settings).unwrap();
        let trim = plant.trim(&settings.trim_condition()).unwrap();
        plant.linearise(&trim).eigenvalues().unwrap()
    });
    assert_eq!(one.len(), other.len());
    let away = one.iter().map(|root| {
        let nearest = other.iter().map(|other| (root - other).norm()).fold(f64::INFINITY, f64::min);
        nearest / root.norm()
    });
    away.fold(0.0, f64::max)
}

/// Of rounding; trims of GE are found to a tolerance.
fn bound(fidelity: Fidelity) -> f64 {
    if fidelity == Fidelity::GeometricallyExact { 1e-8 } else { 1e-10 }
}

#[test]
fn a_wing_described_about_another_axis_flies_the_same() {
    let mut record = Record::new(
        "described-twice",
        "Clamped wing with all couplings, its axis 0 or 0.25 chords behind its line of shear centres, in a wind tunnel at rest and half a second after a flap was moved: \
         twist of the tip, forces and moments about one point at two cuts, eigenvalues: largest relative differences; under all of its loads, and a hundredth of them",
        "the same wing; profile drag is zero, since it acts by the velocity of the axis. Superposition moves what is at an arm o by φ × o and turns it by the rotation \
         of φ, so that by φ² it is another wing: a hundredth of the loads leaves a hundredth of the difference. GE turns both alike",
    );
    let loads = [1.0, 0.01];
    let models = loads.map(|load| [0.0, 0.25].map(|behind| about(behind, load)));
    for fidelity in LEVELS {
        let symbol = fidelity.symbol();
        for (models, load) in models.iter().zip(loads) {
            let flown = models.each_ref().map(|model| flown(model, fidelity, 0.05 * load));
            let [[rest, later], [other_rest, other_later]] = flown;
            let mut largest = differ(&rest, &other_rest, 0.25).map(f64::abs).to_vec();
            let moving = differ(&later, &other_later, 0.25);
            largest.iter_mut().zip(moving).for_each(|(one, other)| *one = one.max(other));
            largest.push(roots_differ(models.each_ref(), fidelity));
            for (what, worst) in ["twist", "forces", "moments", "eigenvalues"].into_iter().zip(largest) {
                let case = format!("{symbol}, {load} of the loads: {what}");
                match fidelity {
                    Fidelity::Rigid if what == "twist" => {}
                    Fidelity::Rigid | Fidelity::GeometricallyExact => {
                        record.rounding(&case, bound(fidelity), worst);
                    }
                    _ => record.error(&case, 0.02 * load, worst),
                }
            }
        }
    }
    record.finish();
}

#[test]
fn an_aircraft_whose_sections_are_described_in_turned_axes_flies_the_same() {
    let mut record = Record::new(
        "turned-flight",
        "Free aircraft with swept wings of all couplings, local y and z of their elements turned by 0.6 rad on the right, mirrored on the left: trim and half a \
         second of elevator, largest relative differences as above",
        "the same aircraft",
    );
    let aircraft = swept(0.3, ALL_COUPLINGS);
    let mut other = aircraft.clone();
    let (sin, cos) = libm::sincos(0.6);
    for beam in other.beams.iter_mut().filter(|beam| beam.component.starts_with("wing")) {
        let along = (aircraft.nodes[beam.nodes[1]] - aircraft.nodes[beam.nodes[0]]).normalize();
        let side = if beam.component == "wing_right" { 1.0 } else { -1.0 };
        let y_axis = beam.y_axis * cos + along.cross(&beam.y_axis) * (side * sin);
        *beam = turned(beam, &along, y_axis);
    }
    let models = [aircraft, other].map(|aircraft| Arc::new(ReducedModel::new(&aircraft, 16).unwrap()));
    assert!(models.iter().flat_map(|model| &model.modes).all(|mode| mode.family != ModeFamily::Unsymmetric));
    for fidelity in LEVELS {
        let [[trim, later], [other_trim, other_later]] =
            models.each_ref().map(|model| flown(model, fidelity, 0.05));
        let symbol = fidelity.symbol();
        for (when, one, other) in [("trim", trim, other_trim), ("moving", later, other_later)] {
            let bound = bound(fidelity);
            for (what, worst) in ["twist", "forces", "moments"].into_iter().zip(differ(&one, &other, 0.0)) {
                if what != "twist" || fidelity != Fidelity::Rigid {
                    record.rounding(&format!("{symbol}, {when}: {what}"), bound, worst);
                }
            }
        }
    }
    record.finish();
}
