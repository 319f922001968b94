//! Geometrically exact kinematics of the jet against the same recursion with derivatives carried along, and its equations against the
//! Lagrangian whose mass matrix they have.
//!
//! [theory: geometrically-exact.recursion, geometrically-exact.biases, geometrically-exact.jacobians, geometrically-exact.conservation]

use flexible_aircraft::equations::{Configuration, EquationsOfMotion, Fidelity, Mechanics, Workspace};
use flexible_aircraft::math::Attitude;
use flexible_aircraft::plant::{Plant, PointLoad};
use flexible_aircraft::structure::ReducedModel;
use nalgebra::{DVector, Vector3};

use crate::support::plain_sections::{MovingPoint, moving_point};
use crate::support::{derivative_of_eighth_order, jet, random, soft};

use super::modal_integrals::{random_state, velocities};
use super::record::Record;

/// The jet with twelve modes, without air and gravity.
fn in_vacuum() -> ReducedModel {
    let jet = jet();
    ReducedModel { gravity: 0.0, strips: Vec::new(), ..jet.select(&(0..12).collect::<Vec<_>>()) }
}

/// Random coordinates that bend the wing by two metres and more, and rates of them.
fn coordinates(seed: u64) -> [Vec<f64>; 2] {
    let mut next = random(seed);
    [50.0, 100.0].map(|size| (0..12).map(|_| size * next()).collect())
}

/// Level at the origin with some coordinates.
fn level(plant: &Plant, [q, q_dot]: &[Vec<f64>; 2]) -> Vec<f64> {
    let layout = plant.layout();
    let mut state = vec![0.0; layout.len()];
    state[layout.attitude().start] = 1.0;
    state[layout.coordinates()].copy_from_slice(q);
    state[layout.coordinate_rates()].copy_from_slice(q_dot);
    state
}

/// A section of the plain recursion.
fn plain(model: &ReducedModel, section: usize, q: &[f64], q_dot: &[f64]) -> MovingPoint {
    moving_point(&model.sections, [q, q_dot], section, &Vector3::zeros())
}

/// J and S of each mode there.
fn plain_rows(model: &ReducedModel, section: usize, q: &[f64]) -> Vec<[Vector3<f64>; 2]> {
    let row = |mode: usize| {
        let unit: Vec<f64> = (0..q.len()).map(|other| f64::from(u8::from(other == mode))).collect();
        let MovingPoint { velocity, spin, .. } = plain(model, section, q, &unit);
        [velocity, spin]
    };
    (0..q.len()).map(row).collect()
}

/// Without elastic forces: at rest nothing acts but the loads.
fn slack() -> Configuration {
    Configuration { stiffness_scale: 1e-300, ..soft(Fidelity::GeometricallyExact) }
}

/// Largest differences of J, of S and of X of the stations, by unit loads on them, over the largest of each; and how far a tip
/// bends, m.
fn rows_apart(model: &ReducedModel, seed: u64) -> ([f64; 3], f64) {
    let plant = Plant::new(model, &slack()).unwrap();
    let [q, _] = coordinates(seed);
    let state = level(&plant, &[q.clone(), vec![0.0; 12]]);
    let (mut apart, mut size, mut far) = ([0.0_f64; 3], [0.0_f64; 3], 0.0_f64);
    for station in &model.stations {
        let own = plain(model, station.carrier.section, &q, &[0.0; 12]);
        let rows = plain_rows(model, station.carrier.section, &q);
        far = far.max((own.place - station.position).norm());
        for axis in 0..3 {
            let unit = Vector3::ith(axis, 1.0);
            // Moments are about axes that turn with the section.
            let loads = [(unit, Vector3::zeros()), (Vector3::zeros(), own.turn.tr_mul(&unit))];
            for (kind, (force, moment)) in loads.into_iter().enumerate() {
                let load = PointLoad { station: station.name.clone(), force, moment };
                let loaded = plant.clone().under_loads(&[load]).unwrap();
                let mut workspace = loaded.workspace();
                loaded.rates(&state, &loaded.neutral_controls(), &mut vec![0.0; state.len()], &mut workspace);
                let forces = workspace.forces();
                for (mode, of_mode) in rows.iter().enumerate() {
                    let expected = of_mode[kind][axis];
                    apart[kind] = apart[kind].max((forces[6 + mode] - expected).abs());
                    size[kind] = size[kind].max(expected.abs());
                }
                if kind == 0 {
                    let arm = own.place.cross(&unit);
                    let found = Vector3::from_column_slice(&forces[3..6]);
                    apart[2] = apart[2].max((found - arm).norm());
                    size[2] = size[2].max(arm.norm());
                }
            }
        }
    }
    (std::array::from_fn(|i| apart[i] / size[i]), far)
}

/// Largest differences of what accelerometers and gyros at the stations measure in violent motion, over the largest of each.
fn sensors_apart(model: &ReducedModel, seed: u64) -> [f64; 2] {
    let plant = Plant::new(model, &soft(Fidelity::GeometricallyExact)).unwrap();
    let layout = *plant.layout();
    let state = {
        let mut state = random_state(plant.equations(), seed);
        let attitude = &mut state[layout.attitude()];
        let norm = libm::sqrt(attitude.iter().map(|x| x * x).sum());
        attitude.iter_mut().for_each(|x| *x /= norm);
        state
    };
    let mut workspace = plant.workspace();
    let outputs = plant.outputs_at(&state, &plant.neutral_controls(), &mut workspace);
    let (q, q_dot) = (&state[layout.coordinates()], &state[layout.coordinate_rates()]);
    let accelerations = workspace.accelerations();
    let part = |numbers: &[f64], first: usize| Vector3::from_column_slice(&numbers[first..][..3]);
    let (v, omega) = (part(&state[layout.velocity()], 0), part(&state[layout.rate()], 0));
    let (v_dot, omega_dot) = (part(accelerations, 0), part(accelerations, 3));
    let (mut apart, mut size) = ([0.0_f64; 2], [0.0_f64; 2]);
    for (station, found) in model.stations.iter().zip(&outputs.sensors) {
        let section = station.carrier.section;
        let MovingPoint { turn, place, velocity, spin, acceleration, .. } = plain(model, section, q, q_dot);
        let relative = plain(model, section, q, &accelerations[6..]).velocity + acceleration;
        let inertial = v_dot
            + omega.cross(&v)
            + omega_dot.cross(&place)
            + omega.cross(&omega.cross(&place))
            + omega.cross(&velocity) * 2.0
            + relative;
        let expected = [turn.tr_mul(&inertial), turn.tr_mul(&(omega + spin))];
        for (kind, (found, expected)) in [found.specific_force, found.rate].iter().zip(expected).enumerate() {
            apart[kind] = apart[kind].max((found - expected).norm());
            size[kind] = size[kind].max(expected.norm());
        }
    }
    std::array::from_fn(|kind| apart[kind] / size[kind])
}

#[test]
fn rows_velocities_and_biases_are_those_of_the_plain_recursion() {
    let model = in_vacuum();
    let mut record = Record::new(
        "exact-kinematics",
        "Jet with 12 modes, 10 random shapes: largest difference at the stations, over the largest",
        "the recursion with derivatives carried along, section by section (`support/plain_sections.rs`); J, S and X by what unit loads do on ν, \
         biases by what accelerometers measure",
    );
    let largest = |values: Vec<f64>| values.into_iter().fold(0.0, f64::max);
    let rows: Vec<([f64; 3], f64)> = (0..10).map(|seed| rows_apart(&model, seed)).collect();
    let sensors: Vec<[f64; 2]> = (0..10).map(|seed| sensors_apart(&model, seed)).collect();
    record.at_least("farthest tip, m", 2.0, largest(rows.iter().map(|(_, far)| *far).collect()));
    for (kind, name) in ["J", "S", "X"].into_iter().enumerate() {
        record.rounding(name, 2e-14, largest(rows.iter().map(|(apart, _)| apart[kind]).collect()));
    }
    for (kind, name) in ["acceleration, with bias", "angular velocity"].into_iter().enumerate() {
        record.rounding(name, 2e-14, largest(sensors.iter().map(|apart| apart[kind]).collect()));
    }
    record.finish();
}

/// Kinetic energy, momentum and angular momentum of the bodies on all sections, each by itself: largest differences, over the size
/// of each.
fn bodies_apart(model: &ReducedModel, seed: u64) -> [f64; 3] {
    let equations = EquationsOfMotion::new(model, &soft(Fidelity::GeometricallyExact)).unwrap();
    let (layout, state) = (*equations.layout(), random_state(&equations, seed));
    let motion = equations.motion(&state);
    let (q, q_dot) = (&state[layout.coordinates()], &state[layout.coordinate_rates()]);
    let (mut energy, mut momentum, mut about) = (0.0, Vector3::zeros(), Vector3::zeros());
    for (index, section) in model.sections.iter().enumerate() {
        let centre = moving_point(&model.sections, [q, q_dot], index, &section.body.offset);
        let velocity = motion.velocity + motion.rate.cross(&centre.place) + centre.velocity;
        let spin = motion.rate + centre.spin;
        let turning = centre.turn * (section.body.inertia * centre.turn.tr_mul(&spin));
        energy += 0.5 * (section.body.mass * velocity.norm_squared() + spin.dot(&turning));
        momentum += velocity * section.body.mass;
        about += turning + centre.place.cross(&(velocity * section.body.mass));
    }
    let to_inertial = Attitude::from_quaternion(&state[layout.attitude()]).body_from_inertial.transpose();
    let position = Vector3::from_column_slice(&state[layout.position()]);
    let (momentum, about) = (to_inertial * momentum, to_inertial * about);
    let about = about + position.cross(&momentum);
    let found = Mechanics::new(&equations, &state);
    [
        (found.kinetic_energy / energy - 1.0).abs(),
        (found.linear_momentum - momentum).norm() / momentum.norm(),
        (found.angular_momentum - about).norm() / about.norm(),
    ]
}

#[test]
fn the_mass_matrix_of_the_bent_aircraft_is_that_of_its_bodies() {
    let mut record = Record::new(
        "exact-mass",
        "Jet with 12 modes, GE, 10 random states with sections turned by up to 1 rad: largest relative difference",
        "½m|v|² + ½ωᵀRIRᵀω and momenta of the body on each section, which the plain recursion carries",
    );
    let model = in_vacuum();
    let all: Vec<[f64; 3]> = (0..10).map(|seed| bodies_apart(&model, seed)).collect();
    for (kind, name) in ["kinetic energy", "momentum", "angular momentum"].into_iter().enumerate() {
        record.rounding(name, 1e-13, all.iter().fold(0.0, |max, apart| max.max(apart[kind])));
    }
    record.finish();
}

/// What is left of each row of the Boltzmann–Hamel equations of ½νᵀM̂ν − U, relative to the largest of the row's terms.
fn residuals(equations: &EquationsOfMotion, state: &[f64]) -> Vec<f64> {
    let layout = equations.layout();
    let (mut workspace, controls) = (Workspace::new(equations), equations.neutral_controls());
    equations.rates(state, &controls, &mut vec![0.0; state.len()], &mut workspace);
    let nu = DVector::from_vec(velocities(equations, state));
    let nu_dot = DVector::from_row_slice(workspace.accelerations());
    // With the coordinates moved along some rates.
    let moved = |rates: &[f64], s: f64| {
        let mut state = state.to_vec();
        state[layout.coordinates()].iter_mut().zip(rates).for_each(|(q, rate)| *q += s * rate);
        state
    };
    let by = |step: f64, rates: &[f64]| {
        derivative_of_eighth_order(step, |s| equations.exact_mass_matrix(&moved(rates, s)))
    };
    let mass = equations.exact_mass_matrix(state);
    let (inertial, momenta) = (&mass * nu_dot, &mass * &nu);
    let changes = by(1e-2, &nu.as_slice()[6..]) * &nu;
    let part =
        |numbers: &DVector<f64>, first: usize| -> Vector3<f64> { numbers.fixed_rows::<3>(first).into() };
    let (v, omega, p, h) = (part(&nu, 0), part(&nu, 3), part(&momenta, 0), part(&momenta, 3));
    let (turning, about) = (omega.cross(&p), [omega.cross(&h), v.cross(&p)]);
    let terms = |row: usize| match row {
        0..3 => vec![turning[row]],
        3..6 => about.map(|moment| moment[row - 3]).to_vec(),
        _ => {
            let unit: Vec<f64> = (6..nu.len()).map(|other| f64::from(u8::from(other == row))).collect();
            let elastic = |s: f64| equations.strain_energy(&moved(&unit, s)[layout.coordinates()]);
            // U is quadratic.
            vec![-0.5 * nu.dot(&(by(1.0, &unit) * &nu)), (elastic(20.0) - elastic(-20.0)) / 40.0]
        }
    };
    let left = |row: usize| {
        let terms = [vec![inertial[row], changes[row]], terms(row)].concat();
        let largest = terms.iter().fold(0.0_f64, |max, term| max.max(term.abs()));
        terms.iter().sum::<f64>().abs() / largest
    };
    (0..nu.len()).map(left).collect()
}

#[test]
fn every_row_is_that_of_the_lagrangian_of_its_mass_matrix() {
    let mut record = Record::new(
        "exact-rows",
        "Jet with 12 modes at one-tenth stiffness, GE, 10 random states: what is left of a row, relative to its largest term",
        "Boltzmann–Hamel equations of ½νᵀM̂ν − U with derivatives of M̂ by differences",
    );
    let equations = EquationsOfMotion::new(&in_vacuum(), &soft(Fidelity::GeometricallyExact)).unwrap();
    let all: Vec<Vec<f64>> =
        (0..10).map(|seed| residuals(&equations, &random_state(&equations, seed))).collect();
    for (name, range) in [("force", 0..3), ("moment", 3..6), ("generalised", 6..18)] {
        let largest = all.iter().flat_map(|rows| &rows[range.clone()]).fold(0.0_f64, |max, &r| max.max(r));
        record.rounding(&format!("{name} rows"), 2e-11, largest);
    }
    record.finish();
}
