//! Wings in a wind tunnel that bend by a third of their span and more [theory: geometrically-exact.recursion].

use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::{Plant, PlantSettings};
use flexible_aircraft::stability::{CrossingKind, Sweep};
use flexible_aircraft::structure::ReducedModel;
use nalgebra::{Complex, Vector3};

use crate::support::rod::Rod;

use super::record::Record;

/// A shipped wing with some of its text replaced.
fn wing(file: &str, changes: &[(&str, &str)], modes: usize) -> Arc<ReducedModel> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft").join(file);
    let mut text = std::fs::read_to_string(path).unwrap();
    for (shipped, ours) in changes {
        assert_eq!(text.matches(shipped).count(), 1, "{shipped}");
        text = text.replace(shipped, ours);
    }
    Arc::new(ReducedModel::new(&Aircraft::parse(&text, file).unwrap(), modes).unwrap())
}

/// With all of its modes.
fn settings(model: &ReducedModel) -> PlantSettings {
    PlantSettings { mode_count: model.modes.len(), ..PlantSettings::of(model) }
}

/// Displacement of the tip at rest in the flow, body axes, m.
fn tip(model: &Arc<ReducedModel>, fidelity: Fidelity, airspeed: f64) -> Vector3<f64> {
    let settings = PlantSettings { fidelity, airspeed, ..settings(model) };
    let mut flight = Simulation::new(Arc::clone(model), &Settings::from(settings), 0.0).unwrap();
    flight.outputs().deflections[0].displacement
}

/// Patil's wing in the air of the reference, and with weight.
const HIS_TUNNEL: [(&str, &str); 3] = [
    ("model = \"exact\"", "model = \"geometrically_exact\""),
    ("gravity_m_s2 = 0\n", ""),
    ("altitude_m = 19938", "density_kg_m3 = 0.08803"),
];
/// Root incidence of Patil's wing.
const HIS_INCIDENCE: f64 = 2.0 * TAU / 360.0;
/// Airspeed, m/s; the tip normal to the root's chord, m: AeroBeams, an independent computation of these equations.
const HIS_TIP: [(f64, f64, f64); 7] = [
    (0.0, -2.928, -2.9291),
    (10.0, -2.543, -2.5442),
    (15.0, -1.934, -1.9345),
    (20.0, -0.740, -0.7395),
    (25.0, 1.558, 1.5478),
    (28.0, 3.510, 3.4690),
    (30.0, 4.888, 4.8153),
];

/// The wing at 2° in its file, while body axes stay level.
fn patils_wing() -> Arc<ReducedModel> {
    let (sine, cosine) = libm::sincos(HIS_INCIDENCE);
    let chord = format!("y_axis = [{cosine}, 0, {}]", -sine);
    let strips = "elastic_axis = 0.5\nincidence_deg = 2";
    let turned = [("y_axis = [1, 0, 0]", chord.as_str()), ("elastic_axis = 0.5", strips)];
    wing("patil-wing.toml", &[&HIS_TUNNEL[..], &turned].concat(), 12)
}

/// Of a displacement in body axes, normal to the root's chord.
fn normal(displacement: &Vector3<f64>) -> f64 {
    let (sine, cosine) = libm::sincos(HIS_INCIDENCE);
    -(sine * displacement.x + cosine * displacement.z)
}

#[test]
fn patils_wing_bends_in_the_flow_as_other_programs_say() {
    let model = patils_wing();
    let rod = Rod::patils(0.08803, HIS_INCIDENCE);
    let mut record = Record::new(
        "patils-wing",
        "Patil's wing of 16 m at 2° and with its weight, 0.08803 kg/m³: tip normal to the root's chord, m; 12 modes",
        "AeroBeams.jl (L. Pancini; wing of M. J. Patil, D. H. Hodges, C. E. S. Cesnik, J. Aircraft 38 (2001) 88); an \
         independent computation of [theory: geometrically-exact.recursion]; a rod without modes, by moments and curvatures",
    );
    let mut levels = String::from(
        "How far the tip goes up (and, in GE, in), m. Superposed displacements cannot bend without stretching: E locks, by \
         an EA of 1e7 N; CL goes astray; I, quadratic, goes up as far, but keeps its tip outboard.\n\n\
         | m/s | GE | I | CL | E |\n| --- | --- | --- | --- | --- |\n",
    );
    for (airspeed, aerobeams, independent) in HIS_TIP {
        let bent = tip(&model, Fidelity::GeometricallyExact, airspeed);
        let (case, up) = (format!("{airspeed} m/s"), normal(&bent));
        record.absolute(&format!("{case}: AeroBeams"), aerobeams, 0.08, up);
        record.absolute(&format!("{case}: independent"), independent, 3e-3, up);
        record.absolute(&format!("{case}: rod"), rod.tip(airspeed).z, 1e-2, up);
        let others = [Fidelity::Inconsistent, Fidelity::ConsistentlyLinearised, Fidelity::Exact];
        let others = others.map(|level| format!("{:.2}", normal(&tip(&model, level, airspeed))));
        levels += &format!("| {airspeed} | {up:.2} ({:.2}) | {} |\n", -bent.y, others.join(" | "));
    }
    record.remark(levels.trim_end());
    record.finish();
}

/// Turned in its mount or set so in its file, the wing is the same, and its weight acts alike.
#[test]
fn patils_wing_turned_in_its_mount_bends_as_the_wing_that_is_set_so() {
    let mount = [("altitude_m = 19938", "density_kg_m3 = 0.08803\nmount_attitude_deg = [0, 2, 0]")];
    let turned = wing("patil-wing.toml", &[&HIS_TUNNEL[..2], &mount].concat(), 12);
    let set = normal(&tip(&patils_wing(), Fidelity::GeometricallyExact, 30.0));
    let mounted = -tip(&turned, Fidelity::GeometricallyExact, 30.0).z;
    assert!((mounted / set - 1.0).abs() < 1e-5, "{mounted} {set}");
}

/// The shipped wing at an incidence.
fn very_flexible(incidence: i32, modes: usize) -> Arc<ReducedModel> {
    let mount = format!("mount_attitude_deg = [0, {incidence}, 0]");
    wing("very-flexible-wing.toml", &[("mount_attitude_deg = [0, 5, 0]", &mount)], modes)
}

/// The fraction between pairs at which the shipped wing's lift is given, and the value there.
fn between(at: f64, places: [f64; 4], values: [f64; 4]) -> f64 {
    let last = (1..4).find(|&i| at <= places[i]).unwrap_or(3);
    let share = (at - places[last - 1]) / (places[last] - places[last - 1]);
    values[last - 1] + share * (values[last] - values[last - 1])
}

#[test]
fn the_very_flexible_wing_bends_as_a_rod_does() {
    const PLACES: [f64; 4] = [0.0, 0.6, 0.9, 1.0];
    let mut record = Record::new(
        "very-flexible-wing",
        "The shipped very flexible wing: tip up of the root's chord and inboard, of its span of 0.6 m; 12 modes",
        "a rod without modes, by moments and curvatures; 16 modes beside 12",
    );
    for incidence in [5, 7] {
        let rod = Rod {
            length: 0.6,
            chord: 0.1,
            elastic_axis: 0.45,
            stiffness: Vector3::new(5.5, 7.0, 2000.0),
            mass_per_length: 0.5,
            centre_of_mass: -0.03,
            tip_mass: 0.02,
            lift_slope: |at| between(at, PLACES, [5.6, 5.0, 3.5, 2.0]),
            suction: |at| between(at, PLACES, [0.89, 0.8, 0.56, 0.32]),
            profile_drag: 0.01,
            density: 1.225,
            gravity: 9.80665,
            incidence: f64::from(incidence).to_radians(),
        };
        let (usual, more) = (very_flexible(incidence, 12), very_flexible(incidence, 16));
        for airspeed in [0.0, 20.0, 30.0, 40.0, 50.0, 60.0] {
            let bent = tip(&usual, Fidelity::GeometricallyExact, airspeed) / 0.6;
            let rod = rod.tip(airspeed) / 0.6;
            let case = format!("{incidence}°, {airspeed} m/s");
            record.absolute(&format!("{case}: up, rod"), rod.z, 2e-3, -bent.z);
            record.relative(&format!("{case}: inboard, rod"), -rod.y, 2e-2, -bent.y);
            let converged = tip(&more, Fidelity::GeometricallyExact, airspeed) / 0.6;
            record.absolute(&format!("{case}: up, 16 modes"), -converged.z, 1e-4, -bent.z);
        }
    }
    record.finish();
}

/// Where flutter begins and ends, m/s, and its angular frequencies, rad/s, in the order of airspeed.
fn flutter(model: &ReducedModel) -> Vec<(f64, f64)> {
    let airspeeds: Vec<f64> = (0..7).map(|point| 29.0 + 7.0 * f64::from(point)).collect();
    let sweep = Sweep::new(model, &settings(model), &airspeeds).unwrap();
    let flutter = sweep.crossings.iter().filter(|crossing| crossing.kind == CrossingKind::Flutter);
    flutter.map(|crossing| (crossing.airspeed, crossing.root.eigenvalue.im)).collect()
}

#[test]
fn the_bent_wing_flutters_within_a_range_of_airspeeds_and_again_above() {
    let mut record = Record::new(
        "very-flexible-wing-flutter",
        "The shipped very flexible wing: flutter about its bent shape, m/s and rad/s; 12 modes",
        "convergence: the same with 16 modes",
    );
    for incidence in [5, 7] {
        let [found, converged] = [12, 16].map(|modes| flutter(&very_flexible(incidence, modes)));
        let names = ["begins", "ends", "begins again"];
        assert_eq!((found.len(), converged.len()), (3, 3), "{found:?} {converged:?}");
        for ((name, found), converged) in names.into_iter().zip(found).zip(converged) {
            record.relative(&format!("{incidence}°: {name}, airspeed"), converged.0, 2e-3, found.0);
            record.relative(&format!("{incidence}°: {name}, frequency"), converged.1, 2e-3, found.1);
        }
    }
    record.finish();
}

/// How fast the root nearest to a frequency grows, 1/s, and how fast the twist of the tip does after a puff of air.
fn growths(model: &Arc<ReducedModel>, airspeed: f64, frequency: f64) -> [f64; 2] {
    let settings = PlantSettings { airspeed, ..settings(model) };
    let plant = Plant::under(model, &settings).unwrap();
    let roots = plant.linearise(&plant.trim(&settings.trim_condition()).unwrap()).eigenvalues().unwrap();
    let apart = |root: &Complex<f64>| (root.im - frequency).abs();
    let predicted = roots.iter().min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap().re;

    let mut flight = Simulation::new(Arc::clone(model), &Settings::from(settings), 0.0).unwrap();
    let rest = flight.outputs().deflections[0].twist;
    let calm = Inputs::zero(model);
    let puff = Inputs { wind: Vector3::new(0.0, 0.0, -0.1), ..calm.clone() };
    flight.set_inputs(&puff, &calm);
    flight.advance_to(0.05).unwrap();
    flight.set_inputs(&calm, &calm);
    // Many periods of 33 ms, so that steps of 10 ms come close to the peaks.
    let mut swing = |seconds: f64| {
        let of_step = |step: i32| {
            flight.advance_to(seconds + 0.01 * f64::from(step)).unwrap();
            (flight.outputs().deflections[0].twist - rest).abs()
        };
        (0..50).map(of_step).fold(0.0, f64::max)
    };
    let (early, late) = (swing(1.0), swing(2.0));
    [predicted, libm::log(late / early)]
}

#[test]
fn a_puff_dies_out_below_the_onset_and_grows_above_as_the_roots_say() {
    let model = very_flexible(5, 12);
    // Of the record of the test above.
    let (onset, frequency) = (36.4, 190.7);
    for (airspeed, grows) in [(0.97 * onset, false), (1.03 * onset, true)] {
        let [predicted, flown] = growths(&model, airspeed, frequency);
        assert_eq!(predicted > 0.0, grows, "{airspeed}: {predicted}");
        assert!((flown / predicted - 1.0).abs() < 0.1, "{airspeed}: {flown} {predicted}");
    }
}
