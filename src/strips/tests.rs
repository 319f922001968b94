//! Strips on sections of a kind of kinematics that is not the thesis'.

use nalgebra::Vector3;
use pulp::Scalar;

use crate::air::{UniformFlow, UniformlyMet};
use crate::kinematics::test_kind::{Curved, Place};
use crate::kinematics::{Coordinates, GeometricallyExact, Kinematics, RigidFreedom, RigidMotion, Sections};
use crate::math::{Attitude, LANES, SquareMatrix, Window, Work};
use crate::structure::test_jet::{jet, jet_in_plane};
use crate::structure::{ReducedModel, ReducedStrip};

use super::aerofoil::LocalFlow;
use super::inflow::PetersInflow;
use super::{InflowLayout, Strips, SumLoads, Surroundings};

const DENSITY: f64 = 0.6;

/// Strips on sections of a kind of kinematics, with the model's modes.
struct OnSections<K> {
    strips: Strips,
    kinematics: K,
    modes: usize,
    inflow: PetersInflow,
    layout: InflowLayout,
    freedom: RigidFreedom,
}

/// What the strips do.
struct Found {
    /// Forces on ν with the flaps neutral, then per unit of each factor of their loads.
    forces: Vec<Vec<f64>>,
    mass: SquareMatrix,
    inflow_rates: Vec<f64>,
}

impl<K: Kinematics> OnSections<K> {
    fn new(model: &ReducedModel, edge_on: &[ReducedStrip], freedom: RigidFreedom) -> Self {
        let (strips, inflow) = (Strips::new(model, edge_on, freedom), PetersInflow::new(3));
        let layout = InflowLayout::new(strips.groups(), inflow.real_lags(), inflow.lag_pairs());
        let (kinematics, modes) = (K::new(model, edge_on), model.modes.len());
        OnSections { strips, kinematics, modes, inflow, layout, freedom }
    }

    fn around(&self, motion: &RigidMotion) -> Surroundings<'_, UniformlyMet> {
        let still = UniformFlow { velocity: Vector3::zeros(), rate: Vector3::zeros() };
        let level = Attitude::from_quaternion(&[1.0, 0.0, 0.0, 0.0]);
        Surroundings {
            air: still.met_by(&level, [&motion.velocity, &motion.rate]),
            gust: None,
            rate: motion.rate,
            density: DENSITY,
            inflow: &self.inflow,
            deformed_arms: true,
            freedom: self.freedom,
        }
    }

    fn sum(&self, motion: &RigidMotion, at: Coordinates) -> Found {
        let mut memory = self.kinematics.memory();
        self.kinematics.evaluate(Scalar::new(), at, &mut memory);
        let modes = at.q.len();
        let (components, moving) = (6 + modes, self.freedom.moving(modes).len());
        let equal_rows = self.strips.zero_lift_lines_are_chords();
        let state: Vec<f64> = self.layout.all().map(|place| libm::sin(place as f64)).collect();
        let mut inflow_rates = vec![0.0; state.len()];
        let mut passive = vec![0.0; components];
        let mut effects = vec![0.0; self.strips.factors.len() * components];
        let mut mass = SquareMatrix::new(moving);
        let loads = SumLoads {
            strips: &self.strips,
            sections: self.kinematics.sections(at, &memory),
            around: &self.around(motion),
            layout: &self.layout,
            state: &state,
            rates: &mut inflow_rates,
            sums: &mut self.strips.sums(self.freedom, modes, equal_rows),
            passive: &mut passive,
            effects: &mut effects,
            mass: &mut mass,
        };
        loads.with(Scalar::new());
        let forces =
            std::iter::once(passive).chain(effects.chunks(components).map(<[f64]>::to_vec)).collect();
        if equal_rows {
            for (row, column) in (0..moving).flat_map(|row| (0..row).map(move |column| (row, column))) {
                mass[(row, column)] = mass[(column, row)];
            }
        }
        Found { forces, mass, inflow_rates }
    }

    /// The flow at the first strip, and again by what is special for those in the mirror plane.
    fn flows(&self, motion: &RigidMotion, at: Coordinates) -> Vec<LocalFlow<Scalar>> {
        let mut memory = self.kinematics.memory();
        self.kinematics.evaluate(Scalar::new(), at, &mut memory);
        let sections = self.kinematics.sections(at, &memory);
        let (sections, around) = (sections.of_strips(0), &self.around(motion));
        let (window, group) = (Window::single(), &self.strips.groups[0]);
        let mut flows = vec![group.deform::<Scalar, false>(window, (0, &sections), around).flow];
        if group.in_plane {
            flows.push(group.deform_in_plane::<Scalar, false>(window, (0, &sections), around).flow);
        }
        flows
    }
}

impl OnSections<Curved> {
    /// Of the only strip.
    fn place(&self) -> &Place {
        let Curved { strips, edge_on, .. } = &self.kinematics;
        strips.first().unwrap_or_else(|| &edge_on[0])
    }

    /// What moves of the rigid motion by which the coordinates move the only strip: a vector for each of them.
    fn twists(&self, place: &Place, q: &[f64]) -> Vec<Vec<f64>> {
        let moving = self.freedom.components();
        let twists = place.twists(q).into_iter();
        twists.map(|twist| moving.iter().map(|&component| twist[component]).collect()).collect()
    }
}

/// The jet with this strip alone.
fn with_strip(model: &ReducedModel, strip: &ReducedStrip) -> ReducedModel {
    ReducedModel { strips: vec![strip.clone()], ..model.clone() }
}

/// Strips of the jet with five modes, each alone and with some camber; then those of its half in the plane, then those edge-on.
fn each_strip_alone<K: Kinematics>(camber: f64) -> Vec<OnSections<K>> {
    let mut model = jet().select(&[0, 1, 2, 3, 4]);
    model.strips.iter_mut().for_each(|strip| strip.zero_lift_offset = camber);
    let whole = model.strips.iter();
    let mut all: Vec<_> =
        whole.map(|strip| OnSections::new(&with_strip(&model, strip), &[], RigidFreedom::All)).collect();
    let (half, edge_on) = jet_in_plane();
    let none = ReducedModel { strips: Vec::new(), ..half.clone() };
    let in_plane = RigidFreedom::InPlane;
    all.extend(half.strips.iter().filter(|strip| strip.stays_in_plane()).map(|strip| {
        let strip = ReducedStrip { zero_lift_offset: camber, ..strip.clone() };
        OnSections::new(&with_strip(&half, &strip), &[], in_plane)
    }));
    all.extend(edge_on.iter().map(|strip| OnSections::new(&none, std::slice::from_ref(strip), in_plane)));
    assert!(all.iter().filter(|one| one.strips.groups.iter().any(|group| group.in_plane)).count() > LANES);
    all
}

/// In the mirror plane where the freedom is.
fn motion(freedom: RigidFreedom) -> RigidMotion {
    match freedom {
        RigidFreedom::InPlane => {
            RigidMotion { velocity: Vector3::new(120.0, 0.0, 9.0), rate: Vector3::y() * 0.3 }
        }
        _ => RigidMotion { velocity: Vector3::new(120.0, 7.0, 9.0), rate: Vector3::new(0.2, 0.3, -0.1) },
    }
}

/// Of so many modes, by some law.
fn numbers(modes: usize, phase: f64, size: f64) -> Vec<f64> {
    (0..modes).map(|mode| size * libm::sin(phase + 2.0 * mode as f64)).collect()
}

fn dot(a: &[f64], b: impl IntoIterator<Item = f64>) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[track_caller]
fn assert_close(found: f64, expected: f64, scale: f64) {
    assert!((found - expected).abs() <= 1e-12 * scale, "{found} {expected} {scale}");
}

/// [theory: kinematics.twist]
#[test]
fn forces_and_apparent_mass_on_coordinates_are_those_on_the_rigid_motion_by_which_they_move_a_strip() {
    for one in [0.0, 0.03].into_iter().flat_map(each_strip_alone::<Curved>) {
        let place = one.place();
        let (q, q_dot) = (numbers(one.modes, 0.3, 30.0), numbers(one.modes, 1.0, 20.0));
        let found = one.sum(&motion(one.freedom), Coordinates { q: &q, q_dot: &q_dot });
        let twists = one.twists(place, &q);
        let rigid = one.freedom.components();
        for force in &found.forces {
            let scale = force.iter().fold(0.0_f64, |largest, force| largest.max(force.abs()));
            for (mode, twist) in twists.iter().enumerate() {
                let expected = dot(twist, rigid.iter().map(|&component| force[component]));
                assert_close(force[6 + mode], expected, scale);
            }
        }
        let size = found.mass.size();
        let scale = (0..size).map(|row| found.mass[(row, row)]).fold(0.0, f64::max);
        for (mode, twist) in twists.iter().enumerate() {
            let own = rigid.len() + mode;
            for other in 0..size {
                let of_rigid = |row: usize| found.mass[(row, other)];
                assert_close(found.mass[(own, other)], dot(twist, (0..rigid.len()).map(of_rigid)), scale);
                let of_rigid = |column: usize| found.mass[(other, column)];
                assert_close(found.mass[(other, own)], dot(twist, (0..rigid.len()).map(of_rigid)), scale);
            }
        }
    }
}

#[test]
fn wakes_follow_rates_of_coordinates_as_they_follow_the_rigid_motion_by_which_those_move_a_strip() {
    let mut followed = 0;
    for one in each_strip_alone::<Curved>(0.03).iter().filter(|one| one.strips.count() > 0) {
        let (q, q_dot) = (numbers(one.modes, 0.3, 30.0), numbers(one.modes, 1.0, 20.0));
        let still = vec![0.0; one.modes];
        let mut carried = motion(one.freedom);
        let rigid =
            |twist: &[f64; 6]| [0, 3].map(|first| Vector3::from_column_slice(&twist[first..first + 3]));
        for (twist, rate) in one.place().twists(&q).iter().zip(&q_dot) {
            let [velocity, turning] = rigid(twist);
            carried.velocity += velocity * *rate;
            carried.rate += turning * *rate;
        }
        let rates = |motion: &RigidMotion, q_dot: &[f64]| {
            let rates = one.sum(motion, Coordinates { q: &q, q_dot }).inflow_rates;
            one.layout.of_strip(0).into_iter().map(|place| rates[place]).collect::<Vec<_>>()
        };
        let moved = rates(&motion(one.freedom), &q_dot);
        let [expected, unmoved] = [&carried, &motion(one.freedom)].map(|motion| rates(motion, &still));
        let largest = expected.iter().fold(0.0_f64, |largest, rate| largest.max(rate.abs()));
        moved.iter().zip(&expected).for_each(|(moved, expected)| assert_close(*moved, *expected, largest));
        let differences = moved.iter().zip(&unmoved).map(|(moved, unmoved)| (moved - unmoved).abs());
        followed += usize::from(differences.fold(0.0, f64::max) > 1e-3 * largest);
    }
    assert!(followed > 2 * LANES, "{followed}");
}

#[test]
fn upwash_and_pitch_rate_drift_as_they_change_along_a_motion_without_accelerations() {
    drift_as_they_change::<Curved>();
    drift_as_they_change::<GeometricallyExact>();
}

/// Whether those of each strip do, on sections of a kind.
fn drift_as_they_change<K: Kinematics>() {
    for one in each_strip_alone::<K>(0.03).iter().filter(|one| one.strips.count() > 0) {
        let (q, q_dot) = (numbers(one.modes, 0.3, 30.0), numbers(one.modes, 1.0, 20.0));
        let at = |time: f64| {
            let q: Vec<f64> = q.iter().zip(&q_dot).map(|(q, rate)| q + rate * time).collect();
            one.flows(&motion(one.freedom), Coordinates { q: &q, q_dot: &q_dot })
        };
        let step = 1e-3;
        let rate_of = |number: fn(&LocalFlow<Scalar>) -> f64, flow: usize| {
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|steps| number(&at(steps * step)[flow]));
            ((c - b) * 8.0 - (d - a)) / (12.0 * step)
        };
        for (place, flow) in at(0.0).iter().enumerate() {
            let upwash_rate = rate_of(|flow| flow.upwash.numbers()[0], place);
            let pitch_acceleration = rate_of(|flow| flow.pitch_rate.numbers()[0], place);
            let [upwash_drift, pitch_drift] =
                [flow.upwash_drift, flow.pitch_drift].map(|drift| drift.numbers()[0]);
            assert!((upwash_drift - upwash_rate).abs() < 1e-7, "{upwash_drift} {upwash_rate}");
            assert!((pitch_drift - pitch_acceleration).abs() < 1e-9, "{pitch_drift} {pitch_acceleration}");
        }
    }
}
