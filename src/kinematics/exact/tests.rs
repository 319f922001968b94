//! Geometrically exact kinematics of the shipped jet against differences and against the thesis' integrals.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use pulp::Scalar;

use crate::kinematics::linear::Superposition;
use crate::kinematics::{
    Coordinates, GeneralisedVector, Inertia, Kinematics, RigidFreedom, RigidMotion, Section, Sections,
    SectionsInPlane, SectionsInSpace, Turn,
};
use crate::math::{Arrow, LANES, LaneVector, PlaneVector, SquareMatrix, Window};
use crate::structure::test_jet::jet;
use crate::structure::{ModeFamily, ReducedModel};

use super::GeometricallyExact;
use super::inertia::ExactInertia;
use super::instant::ExactMemory;
use super::moving::Moving;

const MODES: usize = 12;

fn model() -> ReducedModel {
    jet().select(&(0..MODES).collect::<Vec<_>>())
}

/// Of so many modes, by some law.
fn numbers(phase: f64, size: f64) -> Vec<f64> {
    (0..MODES).map(|mode| size * libm::sin(phase + 2.0 * mode as f64)).collect()
}

/// Large deflections, and rates of them.
fn large() -> [Vec<f64>; 2] {
    [numbers(1.3, 45.0), numbers(0.4, 60.0)]
}

fn ahead(q: &[f64], q_dot: &[f64], time: f64) -> Vec<f64> {
    q.iter().zip(q_dot).map(|(q, rate)| q + rate * time).collect()
}

fn evaluated(kinematics: &GeometricallyExact, q: &[f64], q_dot: &[f64]) -> ExactMemory {
    let mut memory = kinematics.memory();
    kinematics.evaluate(Scalar::new(), Coordinates { q, q_dot }, &mut memory);
    memory
}

/// The derivative of a function at 0, of the eighth order.
fn derivative<T>(step: f64, function: impl Fn(f64) -> T) -> T
where
    T: std::ops::Sub<Output = T> + std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>,
{
    let difference =
        |steps: f64, weight: f64| (function(steps * step) - function(-steps * step)) * (weight / step);
    difference(1.0, 0.8)
        + difference(2.0, -0.2)
        + difference(3.0, 4.0 / 105.0)
        + difference(4.0, -1.0 / 280.0)
}

#[track_caller]
fn assert_close(found: &Vector3<f64>, expected: &Vector3<f64>, bound: f64) {
    assert!((found - expected).norm() < bound, "{found} {expected}");
}

#[test]
fn a_wing_tip_bends_by_more_than_two_metres_in_these_tests() {
    let kinematics = GeometricallyExact::of(&model(), &[]);
    let memory = evaluated(&kinematics, &large()[0], &large()[1]);
    let sections = kinematics.at(&memory);
    let largest = sections.stations().map(|station| station.displacement().norm()).fold(0.0, f64::max);
    assert!(largest > 2.0, "{largest}");
}

/// [theory: geometrically-exact.rates, geometrically-exact.biases]
#[test]
fn velocities_spins_and_biases_are_the_rates_of_what_moves_at_constant_rates_of_coordinates() {
    let kinematics = GeometricallyExact::of(&model(), &[]);
    let [q, q_dot] = large();
    let of = |place: usize, time: f64| {
        evaluated(&kinematics, &ahead(&q, &q_dot, time), &q_dot).tree().section(place)
    };
    for place in kinematics.order().places.iter().copied().step_by(5) {
        let own = of(place, 0.0);
        let rate = |value: fn(&Moving) -> Vector3<f64>| derivative(0.01, |time| value(&of(place, time)));
        assert_close(&own.velocity, &rate(|section| section.position), 1e-11);
        assert_close(&own.acceleration, &rate(|section| section.velocity), 1e-10);
        assert_close(&own.angular_acceleration, &rate(|section| section.spin), 1e-11);
        let turning: Matrix3<f64> = derivative(0.01, |time| of(place, time).turn);
        assert!((turning - own.spin.cross_matrix() * own.turn).norm() < 1e-11);
        assert!((own.turn.transpose() * own.turn - Matrix3::identity()).norm() < 1e-14);
    }
}

/// [theory: geometrically-exact.jacobians]
#[test]
fn twists_of_each_coordinate_are_those_by_which_its_rate_moves_and_turns_a_section() {
    let kinematics = GeometricallyExact::of(&model(), &[]);
    let [q, _] = large();
    for mode in 0..MODES {
        let mut q_dot = vec![0.0; MODES];
        q_dot[mode] = 1.0;
        let memory = evaluated(&kinematics, &q, &q_dot);
        for &place in &kinematics.order().places {
            let own = memory.tree().section(place);
            let [translation, rotation] = twist(&kinematics, &memory, place, mode);
            assert_close(&(translation + rotation.cross(&own.position)), &own.velocity, 1e-14);
            assert_close(&rotation, &own.spin, 1e-15);
        }
    }
}

/// J° and S of the section at a place and a mode.
fn twist(
    kinematics: &GeometricallyExact,
    memory: &ExactMemory,
    place: usize,
    mode: usize,
) -> [Vector3<f64>; 2] {
    let modes = kinematics.order().modes_at(place);
    let Some((_, row)) = modes.into_iter().find(|(moved, _)| *moved == mode) else {
        return [Vector3::zeros(); 2];
    };
    let (_, rows) = &memory.tree().twists[place / LANES][row];
    [0, 3].map(|first| Vector3::from([0, 1, 2].map(|axis| rows[first + axis].0[place % LANES])))
}

fn write_undeformed<K: Kinematics>(model: &ReducedModel, freedom: RigidFreedom) -> SquareMatrix {
    let (kinematics, zero) = (K::new(model, &[]), vec![0.0; MODES]);
    let memory = kinematics.memory();
    let sections = kinematics.sections(Coordinates { q: &zero, q_dot: &zero }, &memory);
    let mut matrix = SquareMatrix::new(freedom.moving(MODES).len());
    kinematics.inertia(&model.integrals, freedom).write_mass_matrix(&sections, false, &mut matrix);
    matrix
}

/// [theory: geometrically-exact.inertia]
#[test]
fn the_undeformed_mass_matrix_is_that_of_the_integrals_whatever_is_free() {
    let model = model();
    for freedom in [RigidFreedom::All, RigidFreedom::InPlane, RigidFreedom::Held] {
        let found = write_undeformed::<GeometricallyExact>(&model, freedom);
        let expected = write_undeformed::<Superposition>(&model, freedom);
        let size = found.size();
        for (i, j) in (0..size).flat_map(|i| (0..size).map(move |j| (i, j))) {
            let scale = libm::sqrt(expected[(i, i)] * expected[(j, j)]);
            let (found, expected) = (found[(i, j)], expected[(i, j)]);
            assert!((found - expected).abs() < 1e-12 * scale, "{i} {j}: {found} {expected}");
        }
    }
}

/// Kinematics with its inertia.
struct Body {
    kinematics: GeometricallyExact,
    inertia: ExactInertia,
}

impl Body {
    fn new() -> Self {
        let (model, kinematics) = (model(), GeometricallyExact::of(&model(), &[]));
        let inertia = kinematics.inertia(&model.integrals, RigidFreedom::All);
        Body { kinematics, inertia }
    }

    fn mass(&self, q: &[f64]) -> DMatrix<f64> {
        let memory = evaluated(&self.kinematics, q, &[0.0; MODES]);
        let (sections, mut inertia) = (self.kinematics.at(&memory), self.inertia.clone());
        inertia.deform(Scalar::new(), &sections);
        let mut matrix = SquareMatrix::new(6 + MODES);
        inertia.write_mass_matrix(&sections, true, &mut matrix);
        DMatrix::from_fn(6 + MODES, 6 + MODES, |i, j| matrix[(i, j)])
    }

    fn forces(&self, q: &[f64], velocities: &DVector<f64>) -> DVector<f64> {
        let GeneralisedVector { translation, rotation, modal } = GeneralisedVector::of(velocities.as_slice());
        let memory = evaluated(&self.kinematics, q, modal);
        let mut forces = DVector::zeros(velocities.len());
        let motion = RigidMotion { velocity: translation, rate: rotation };
        let (sections, mut inertia) = (self.kinematics.at(&memory), self.inertia.clone());
        inertia.deform(Scalar::new(), &sections);
        inertia.add_forces(Scalar::new(), &sections, &motion, true, forces.as_mut_slice());
        forces
    }

    fn weight(&self, q: &[f64], gravity: &Vector3<f64>) -> DVector<f64> {
        let memory = evaluated(&self.kinematics, q, &[0.0; MODES]);
        let (sections, mut inertia) = (self.kinematics.at(&memory), self.inertia.clone());
        inertia.deform(Scalar::new(), &sections);
        let mut forces = DVector::zeros(6 + MODES);
        inertia.add_gravity(&sections, gravity, forces.as_mut_slice());
        forces
    }
}

/// [theory: geometrically-exact.inertia, geometrically-exact.conservation]
#[test]
fn inertial_forces_are_those_by_which_momentum_and_energy_of_the_mass_matrix_are_kept() {
    let body = Body::new();
    let [q, q_dot] = large();
    let rigid = [1.1, 0.2, -0.7, 0.3, -0.2, 0.4];
    let velocities = DVector::from_iterator(6 + MODES, rigid.into_iter().chain(q_dot.iter().copied()));
    let momenta = body.mass(&q) * &velocities;
    // The rate of momenta at constant velocities.
    let rates = derivative(0.01, |time| body.mass(&ahead(&q, &q_dot, time)) * &velocities);
    let [v, rate, p, h] = [
        velocities.fixed_rows::<3>(0),
        velocities.fixed_rows::<3>(3),
        momenta.fixed_rows::<3>(0),
        momenta.fixed_rows::<3>(3),
    ]
    .map(nalgebra::Matrix::into_owned);
    let mut expected = -&rates;
    let turned = [rate.cross(&p), rate.cross(&h) + v.cross(&p)];
    for (part, turned) in turned.iter().enumerate() {
        let mut rows = expected.fixed_rows_mut::<3>(3 * part);
        rows -= turned;
    }
    for mode in 0..MODES {
        let mut along = vec![0.0; MODES];
        along[mode] = 60.0;
        let energy = |time: f64| 0.5 * velocities.dot(&(body.mass(&ahead(&q, &along, time)) * &velocities));
        expected[6 + mode] += derivative(0.01, energy) / along[mode];
    }
    let found = body.forces(&q, &velocities);
    for row in 0..6 + MODES {
        let scale = libm::sqrt(body.mass(&q)[(row, row)]) * 1e3;
        assert!(
            (found[row] - expected[row]).abs() < 1e-10 * scale,
            "{row}: {} {}",
            found[row],
            expected[row]
        );
    }
}

#[test]
fn weight_is_the_force_of_its_potential() {
    let (body, gravity) = (Body::new(), Vector3::new(1.0, -2.0, 9.0));
    let [q, _] = large();
    let first_moment = |q: &[f64]| {
        let mass = body.mass(q);
        // [m1, −c×] above.
        Vector3::new(mass[(1, 5)], mass[(2, 3)], mass[(0, 4)])
    };
    let found = body.weight(&q, &gravity);
    let [force, moment] = [0, 3].map(|first| found.fixed_rows::<3>(first).into_owned());
    let mass = body.mass(&q)[(0, 0)];
    assert_close(&force, &(gravity * mass), 1e-9);
    assert_close(&moment, &first_moment(&q).cross(&gravity), 1e-9);
    for mode in 0..MODES {
        let mut along = vec![0.0; MODES];
        along[mode] = 60.0;
        let potential = |time: f64| first_moment(&ahead(&q, &along, time)).dot(&gravity);
        let expected = derivative(0.01, potential) / along[mode];
        assert!((found[6 + mode] - expected).abs() < 1e-9, "{mode}: {} {expected}", found[6 + mode]);
    }
}

/// [theory: geometrically-exact.air]
#[test]
fn strips_and_stations_read_the_section_that_carries_them() {
    let model = model();
    let kinematics = GeometricallyExact::of(&model, &[]);
    let [q, q_dot] = large();
    let memory = evaluated(&kinematics, &q, &q_dot);
    let sections = kinematics.at(&memory);
    let arrow = Vector3::new(0.6, 0.0, 0.8);
    for (index, strip) in model.strips.iter().enumerate() {
        let window = Window::all(Scalar::new()).nth(index % LANES).unwrap();
        let eight = sections.of_strips(index / LANES);
        // All sections of the jet carry something.
        let place = kinematics.order().places[strip.section];
        let own = memory.tree().section(place);
        let motion = SectionsInSpace::motion(&eight, window);
        assert_eq!(motion.position.vector(), own.position);
        assert_eq!(motion.velocity.vector(), own.velocity);
        assert_eq!(motion.spin.vector(), own.spin);
        let bias = motion.bias.unwrap();
        assert_eq!(bias.acceleration.vector(), own.acceleration);
        assert_eq!(bias.angular_acceleration.vector(), own.angular_acceleration);
        let turned = motion.turn.apply(&LaneVector::single(&arrow)).vector();
        assert_close(&turned, &(own.turn * arrow), 1e-15);
        assert_close(&SectionsInSpace::at_rest(&eight, window).vector(), &strip.position, 1e-15);
        let mut moved = 0;
        for (rows, mode) in SectionsInSpace::rows(&eight, 0..MODES) {
            let rows = rows.map(|row| row.0[index % LANES]);
            let [translation, rotation] = twist(&kinematics, &memory, place, mode);
            moved += usize::from(rotation != Vector3::zeros());
            let [j, s] = [0, 3].map(|first| Vector3::from_column_slice(&rows[first..first + 3]));
            assert_close(&j, &(translation + rotation.cross(&own.position)), 1e-15);
            assert_eq!(s, rotation);
        }
        assert_eq!(moved, kinematics.order().modes_at(place).len());
    }
}

#[test]
fn sections_that_stay_in_the_mirror_plane_turn_there_as_in_space() {
    let symmetric = |&mode: &usize| jet().modes[mode].family == ModeFamily::Symmetric;
    let model = jet().select(&(0..26).filter(symmetric).collect::<Vec<_>>());
    let kinematics = GeometricallyExact::of(&model, &[]);
    let q: Vec<f64> = (0..model.modes.len()).map(|mode| 40.0 * libm::sin(mode as f64 + 0.7)).collect();
    let memory = evaluated(&kinematics, &q, &q);
    let sections = kinematics.at(&memory);
    let arrow = Vector3::new(0.6, 0.0, 0.8);
    let mut turned = 0;
    for (index, strip) in model.strips.iter().enumerate().filter(|(_, strip)| strip.position.y.abs() < 1e-9) {
        let window = Window::all(Scalar::new()).nth(index % LANES).unwrap();
        let eight = sections.of_strips(index / LANES);
        let own = memory.tree().section(kinematics.order().places[strip.section]);
        let in_plane = SectionsInPlane::motion(&eight, window);
        let PlaneVector { x, z } = in_plane.turn.apply(&PlaneVector::splat(window, &arrow));
        let expected = own.turn * arrow;
        assert_close(&Vector3::new(x.numbers()[0], 0.0, z.numbers()[0]), &expected, 1e-12);
        assert_eq!(in_plane.rate.numbers()[0], own.spin.y);
        turned += usize::from((expected - arrow).norm() > 1e-3);
    }
    assert!(turned > LANES, "{turned}");
}

/// [theory: symmetry.mirror]
#[test]
fn in_the_mirror_all_stations_move_as_their_images() {
    let model = model();
    let kinematics = GeometricallyExact::of(&model, &[]);
    let sign = |mode: usize| if model.modes[mode].family == ModeFamily::Symmetric { 1.0 } else { -1.0 };
    let mirrored = |numbers: &[f64]| -> Vec<f64> {
        numbers.iter().enumerate().map(|(mode, number)| number * sign(mode)).collect()
    };
    let [q, q_dot] = large();
    let memories =
        [evaluated(&kinematics, &q, &q_dot), evaluated(&kinematics, &mirrored(&q), &mirrored(&q_dot))];
    let mirror = |arrow: Vector3<f64>| Vector3::new(arrow.x, -arrow.y, arrow.z);
    let [sections, images] = memories.each_ref().map(|memory| kinematics.at(memory));
    for (station, section) in model.stations.iter().zip(sections.stations()) {
        let image = model.stations.iter().zip(images.stations());
        let image = image.filter(|(other, _)| (mirror(other.position) - station.position).norm() < 1e-9);
        let (_, image) = image.last().unwrap();
        assert_close(&mirror(image.displacement()), &section.displacement(), 1e-12);
        assert_close(&mirror(image.velocity()), &section.velocity(), 1e-11);
        let [zero, turning] = [image, section].map(|section| section.angular_velocity(&Vector3::zeros()));
        assert_close(&-mirror(zero), &turning, 1e-12);
    }
}

/// [theory: geometrically-exact.twist]
#[test]
fn twist_is_the_rotation_about_the_axis_and_for_small_coordinates_that_of_the_linear_shapes() {
    let model = model();
    let kinematics = GeometricallyExact::of(&model, &[]);
    let q = numbers(1.3, 1e-4);
    let memory = evaluated(&kinematics, &q, &q);
    for (station, section) in model.stations.iter().zip(kinematics.at(&memory).stations()) {
        let rotation: Vector3<f64> = (0..MODES).map(|mode| station.shapes.of_mode(mode)[1] * q[mode]).sum();
        let expected = station.twist_axis.dot(&rotation);
        assert!((section.twist(&station.twist_axis) - expected).abs() < 1e-9, "{expected}");
        let displacement: Vector3<f64> =
            (0..MODES).map(|mode| station.shapes.of_mode(mode)[0] * q[mode]).sum();
        assert_close(&section.displacement(), &displacement, 1e-9);
    }
}
