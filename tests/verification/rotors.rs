//! What turns in engines: it precesses, whirls, does no work, and is held by the sections that carry it; torques and shares of thrust.
//!
//! [theory: gravity-and-thrust.torque, gravity-and-thrust.gyroscopic, gravity-and-thrust.gyrostat, trim.shares]

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Attachment, Engine, TrimRole};
use flexible_aircraft::equations::{Configuration, EquationsOfMotion, Fidelity, Mechanics, Workspace};
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{ConditionSettings, Plant, PlantSettings};
use flexible_aircraft::structure::ReducedModel;
use nalgebra::{Matrix3, Vector3};

use crate::support::beams::Cantilever;
use crate::support::{jet, soft};

use super::record::Record;

/// The flexible levels.
const FLEXIBLE: [Fidelity; 5] = [
    Fidelity::Exact,
    Fidelity::ConsistentlyLinearised,
    Fidelity::Inconsistent,
    Fidelity::RuthlesslyLinearised,
    Fidelity::GeometricallyExact,
];

/// The jet with propellers that turn the same way.
fn propeller_jet(momentum: f64, torque: f64) -> ReducedModel {
    let mut model = (*jet()).clone();
    for engine in &mut model.engines {
        (engine.angular_momentum, engine.torque) = (momentum, torque);
    }
    model
}

/// Plain Runge–Kutta steps.
fn fly(equations: &EquationsOfMotion, state: &mut [f64], (time, steps): (f64, usize)) {
    let length = time / steps as f64;
    let (mut workspace, controls) = (Workspace::new(equations), equations.neutral_controls());
    let mut slopes: [Vec<f64>; 4] = std::array::from_fn(|_| vec![0.0; state.len()]);
    for _ in 0..steps {
        for (index, weight) in [0.0, 0.5, 0.5, 1.0].into_iter().enumerate() {
            let mut stage = state.to_vec();
            if index > 0 {
                stage.iter_mut().zip(&slopes[index - 1]).for_each(|(x, slope)| *x += weight * length * slope);
            }
            equations.rates(&stage, &controls, &mut slopes[index], &mut workspace);
        }
        let [k1, k2, k3, k4] = &slopes;
        for (i, x) in state.iter_mut().enumerate() {
            *x += length / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
    }
}

#[test]
fn a_free_gyrostat_precesses_at_the_rate_of_the_closed_form() {
    let mut record = Record::new(
        "gyrostat",
        "A free rigid body with a rotor along its axis of symmetry, Rigid: transverse angular velocity after 10 s, over its magnitude",
        "[theory: gravity-and-thrust.gyrostat]: it goes round at ((C − A)ω₁ + h)/A; P. C. Hughes, *Spacecraft Attitude Dynamics* (1986)",
    );
    let (axial, transverse) = (4000.0, 9000.0);
    for (momentum, spin) in [(2500.0, 0.4), (-1500.0, 0.0), (0.0, 0.4)] {
        let mut model = ReducedModel { gravity: 0.0, strips: Vec::new(), ..jet().select(&[]) };
        model.integrals.first_moment = Vector3::zeros();
        model.integrals.inertia = Matrix3::from_diagonal(&Vector3::new(axial, transverse, transverse));
        model.engines.truncate(1);
        model.engines[0].angular_momentum = momentum;
        let equations = EquationsOfMotion::new(&model, &soft(Fidelity::Rigid)).unwrap();
        let mut state = vec![0.0; equations.layout().len()];
        let (rate, attitude) = (equations.layout().rate(), equations.layout().attitude());
        state[attitude.start] = 1.0;
        state[rate.clone()].copy_from_slice(&[spin, 0.2, 0.0]);
        let before = Mechanics::new(&equations, &state);
        fly(&equations, &mut state, (10.0, 4000));
        let after = Mechanics::new(&equations, &state);
        let turned = ((axial - transverse) * spin + momentum) / transverse * 10.0;
        let found = &state[rate];
        let case = format!("h = {momentum} kg m²/s, ω₁ = {spin} rad/s");
        record.absolute(&format!("{case}: cosine"), libm::cos(turned), 1e-10, found[1] / 0.2);
        record.absolute(&format!("{case}: sine"), libm::sin(turned), 1e-10, found[2] / 0.2);
        let drift = (after.angular_momentum - before.angular_momentum).norm();
        record.rounding(
            &format!("{case}: drift of the angular momentum, the rotor's too"),
            5e-14,
            drift / before.angular_momentum.norm(),
        );
    }
    record.finish();
}

/// A round rod of no mass with a mass at its tip, in which something turns about its axis.
fn rod(momentum: f64) -> Aircraft {
    let rod = Cantilever {
        axis: Vector3::x(),
        y_axis: Vector3::y(),
        length: LENGTH,
        axial: 1e9,
        torsional: 1e5,
        bending_y: STIFFNESS,
        bending_z: STIFFNESS,
        mass_per_length: MASS / LENGTH,
        gyration: 0.0,
        lumps: &[(1.0, 1.0)],
    };
    let engine = Engine {
        name: "rotor".to_owned(),
        attachment: Attachment { beam: 0, fraction: 1.0 },
        offset: Vector3::zeros(),
        direction: Vector3::x(),
        torque: 0.0,
        angular_momentum: momentum,
        trim_share: 1.0,
    };
    Aircraft { engines: vec![engine], ..rod.aircraft(1) }
}

const LENGTH: f64 = 2.0;
const MASS: f64 = 30.0;
const STIFFNESS: f64 = 5e4;

#[test]
fn a_rotor_on_a_rod_whirls_at_the_frequencies_of_the_closed_form() {
    let mut record = Record::new(
        "whirl",
        "A rotor at the tip of a clamped round rod of no mass: angular frequencies of the linearised motion, rad/s",
        "[theory: gravity-and-thrust.gyrostat]: √(ω₀² + g²/4) ± g/2, ω₀² = 3EI/(mℓ³), g = 9h/(4mℓ²)",
    );
    let momentum = 400.0;
    let own = 3.0 * STIFFNESS / (MASS * LENGTH * LENGTH * LENGTH);
    let coupling = 2.25 * momentum / (MASS * LENGTH * LENGTH);
    let expected = [-0.5, 0.5].map(|sign| libm::sqrt(own + 0.25 * coupling * coupling) + sign * coupling);
    for fidelity in FLEXIBLE {
        let model = ReducedModel::new(&rod(momentum), 2).unwrap();
        let settings = PlantSettings { fidelity, ..PlantSettings::of(&model) };
        let plant = Plant::under(&model, &settings).unwrap();
        let trim = plant.trim(&settings.trim_condition()).unwrap();
        let roots = plant.linearise(&trim).matrix.complex_eigenvalues();
        let mut frequencies: Vec<f64> = roots.iter().map(|root| root.im).filter(|im| *im > 0.0).collect();
        frequencies.sort_by(f64::total_cmp);
        for ((expected, found), sense) in expected.into_iter().zip(frequencies).zip(["against", "with"]) {
            record.relative(&format!("{fidelity:?}, {sense} the rotor"), expected, 1e-8, found);
        }
        let growth = roots.iter().map(|root| root.re.abs()).fold(0.0, f64::max);
        record.rounding(&format!("{fidelity:?}: growth, 1/s"), 1e-12, growth);
    }
    record.finish();
}

#[test]
fn energy_and_angular_momentum_are_kept_with_propellers_that_turn() {
    let mut record = Record::new(
        "rotors-conservation",
        "Relative drifts over 2 s of violent motion with 20 000 kg m²/s in each engine, models that follow from a Lagrangian",
        "gyroscopic moments do no work, and the angular momentum has the rotors' [theory: gravity-and-thrust.gyroscopic]; Runge–Kutta steps",
    );
    let modes: Vec<usize> = (0..12).collect();
    let model = ReducedModel { gravity: 0.0, strips: Vec::new(), ..propeller_jet(2e4, 0.0).select(&modes) };
    for (fidelity, steps) in
        [(Fidelity::Exact, 10_000), (Fidelity::Inconsistent, 10_000), (Fidelity::GeometricallyExact, 4000)]
    {
        let equations = EquationsOfMotion::new(&model, &soft(fidelity)).unwrap();
        let layout = *equations.layout();
        let start = || {
            let mut state = vec![0.0; layout.len()];
            state[layout.attitude().start] = 1.0;
            state[layout.velocity()].copy_from_slice(&[5.0, -2.0, 1.0]);
            state[layout.rate()].copy_from_slice(&[0.5, -0.4, 0.3]);
            for (mode, q_dot) in state[layout.coordinate_rates()].iter_mut().enumerate() {
                *q_dot = 60.0 * libm::sin(2.0 + 3.0 * mode as f64) / (1.0 + mode as f64);
            }
            state
        };
        let mut state = start();
        let before = Mechanics::new(&equations, &state);
        fly(&equations, &mut state, (2.0, steps));
        let after = Mechanics::new(&equations, &state);
        let energy = |mechanics: &Mechanics| mechanics.kinetic_energy + mechanics.strain_energy;
        record.rounding(
            &format!("{fidelity:?}: energy"),
            5e-14,
            (energy(&after) / energy(&before) - 1.0).abs(),
        );
        let drift =
            (after.angular_momentum - before.angular_momentum).norm() / before.angular_momentum.norm();
        record.rounding(&format!("{fidelity:?}: angular momentum"), 5e-13, drift);
        // What turns changes the motion.
        let still =
            EquationsOfMotion::new(&ReducedModel { engines: Vec::new(), ..model.clone() }, &soft(fidelity))
                .unwrap();
        let mut other = start();
        fly(&still, &mut other, (2.0, steps));
        let apart = layout.rate().map(|i| (state[i] - other[i]).abs()).fold(0.0, f64::max);
        record.at_least(&format!("{fidelity:?}: change of the angular velocity, rad/s"), 1e-3, apart);
    }
    record.finish();
}

/// The trim of a model in some condition.
fn trimmed(model: &Arc<ReducedModel>, fidelity: Fidelity, condition: ConditionSettings) -> Simulation {
    let settings = PlantSettings { fidelity, mode_count: 6, condition, ..PlantSettings::of(model) };
    Simulation::new(Arc::clone(model), &Settings::from(settings), 0.0).unwrap()
}

#[test]
fn engines_have_the_thrust_of_a_trim_by_their_shares() {
    let level = ConditionSettings::default();
    let with_shares = |shares: [f64; 2]| {
        let mut model = (*jet()).clone();
        model.engines.iter_mut().zip(shares).for_each(|(engine, share)| engine.trim_share = share);
        Arc::new(model)
    };
    let equal = trimmed(&jet(), Fidelity::Exact, level).trim().thrust;
    // Equal shares are the same flight whatever they are.
    let mut doubled = trimmed(&with_shares([2.0, 2.0]), Fidelity::Exact, level);
    let thrust = doubled.trim().thrust;
    assert!((2.0 * thrust / equal - 1.0).abs() < 1e-12);
    assert_eq!(doubled.outputs().thrust, [2.0 * thrust; 2]);
    assert!(doubled.is_symmetric());
    // Unequal ones push aside, and rudder and bank hold that.
    let mut uneven = trimmed(&with_shares([3.0, 1.0]), Fidelity::Exact, level);
    let point = *uneven.trim();
    assert_eq!(uneven.outputs().thrust, [3.0 * point.thrust, point.thrust]);
    let whole = 4.0 * point.thrust;
    assert!((whole / (2.0 * equal) - 1.0).abs() < 0.02, "{whole} {equal}");
    assert!(point.control(TrimRole::Yaw).abs() > 1e-3);
    // With the left engine out the right one has all of it.
    let failed = ConditionSettings { failed_engine: 1, ..level };
    let [one, other] = [[3.0, 1.0], [1.0, 1.0]].map(|shares| {
        let mut flight = trimmed(&with_shares(shares), Fidelity::Exact, failed);
        let thrust = flight.trim().thrust;
        assert_eq!(flight.outputs().thrust, [0.0, thrust]);
        thrust
    });
    assert!((one / other - 1.0).abs() < 1e-9);
    let settings = PlantSettings { condition: failed, ..PlantSettings::of(&jet()) };
    let refused = Simulation::new(with_shares([1.0, 0.0]), &settings.into(), 0.0).unwrap_err().to_string();
    assert!(
        refused.contains("condition.failed_engine: found 1 (left), allowed is 2 (right): beside it another has a `trim_share`"),
        "{refused}"
    );
}

#[test]
fn ailerons_hold_the_torque_of_propellers_that_turn_the_same_way() {
    // Rigid and without a wake, what a small angle does is what a small angle of the other sign takes back.
    let torque = -0.1;
    let model = Arc::new(propeller_jet(0.0, torque));
    let level = ConditionSettings::default();
    let mut flight = trimmed(&model, Fidelity::Rigid, level);
    let point = *flight.trim();
    let thrusts: f64 = flight.outputs().thrust.iter().sum();
    let settings = PlantSettings { fidelity: Fidelity::Rigid, ..PlantSettings::of(&model) };
    let plant = Plant::under(&model, &settings).unwrap();
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    // Rolling moment about O of everything but the torque, by the same aircraft without it.
    let plain =
        Plant::under(&jet(), &PlantSettings { fidelity: Fidelity::Rigid, ..PlantSettings::of(&jet()) })
            .unwrap();
    let mut workspace = plain.workspace();
    plain.rates(&trim.state, &trim.controls, &mut vec![0.0; trim.state.len()], &mut workspace);
    let rolling = workspace.forces()[3];
    assert!(point.roll_control.abs() > 1e-3, "{point:?}");
    assert!(
        (rolling + torque * thrusts).abs() < 1e-6 * (torque * thrusts).abs(),
        "{rolling} {}",
        torque * thrusts
    );
}

#[test]
fn mirrored_propellers_let_half_the_aircraft_fly_for_the_whole() {
    let mut mirrored = propeller_jet(3000.0, -0.2);
    (mirrored.engines[0].angular_momentum, mirrored.engines[0].torque) = (-3000.0, 0.2);
    let model = Arc::new(mirrored);
    for fidelity in Fidelity::ALL {
        let fly = |aileron: f64| {
            let mut flight = trimmed(&model, fidelity, ConditionSettings::default());
            let mut inputs = flexible_aircraft::flight::Inputs::zero(&model);
            inputs.controls[crate::support::ELEVATOR] = -0.03;
            inputs.controls[crate::support::AILERON] = aileron;
            flight.set_inputs(&inputs, &flexible_aircraft::flight::Inputs::zero(&model));
            flight.advance_to(1.0).unwrap();
            assert_eq!(flight.is_symmetric(), aileron == 0.0);
            flight.outputs().clone()
        };
        let [half, whole] = [0.0, 1e-14].map(fly);
        let apart = (half.rate - whole.rate).amax().max((half.velocity - whole.velocity).amax());
        assert!(apart < 1e-7, "{fidelity:?}: {apart}");
        let tips = half.deflections.iter().zip(&whole.deflections);
        let apart =
            tips.map(|(one, other)| (one.displacement - other.displacement).amax()).fold(0.0, f64::max);
        assert!(apart < 1e-7, "{fidelity:?}: {apart}");
    }
    // In the same sense there is no half.
    let same = Arc::new(propeller_jet(3000.0, 0.0));
    assert!(!trimmed(&same, Fidelity::Exact, ConditionSettings::default()).is_symmetric());
}

#[test]
fn a_propeller_pitches_the_aircraft_that_yaws() {
    // −ω × h with ω = (0, 0, r) and h along x is −r h about y: nose-down in a yaw to the right.
    let rates = |momentum: f64| {
        let model = propeller_jet(momentum, 0.0).select(&[]);
        let configuration = Configuration { inflow_states: 0, ..soft(Fidelity::Rigid) };
        let equations = EquationsOfMotion::new(&model, &configuration).unwrap();
        let mut state = vec![0.0; equations.layout().len()];
        state[equations.layout().attitude().start] = 1.0;
        state[equations.layout().velocity().start] = 127.0;
        state[equations.layout().rate().end - 1] = 0.3;
        let mut workspace = Workspace::new(&equations);
        equations.rates(&state, &equations.neutral_controls(), &mut vec![0.0; state.len()], &mut workspace);
        workspace.forces().to_vec()
    };
    let [with, without] = [1500.0, 0.0].map(rates);
    let pitching = with[4] - without[4];
    assert!((pitching + 2.0 * 1500.0 * 0.3).abs() < 1e-8, "{pitching}");
    assert_eq!([with[3], with[5]], [without[3], without[5]]);
}
