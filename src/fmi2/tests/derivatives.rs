//! Derivatives by inputs, against what does not come from differences of outputs: definitions, and the rates at which flights
//! part.

use nalgebra::{Rotation3, Vector3};

use super::state::shortest;
use super::surface::Saved;
use super::*;
use crate::equations::evaluations;
use crate::kinematics::GeneralisedVector;

impl Fmu {
    pub(super) fn derivatives(
        &self,
        unknowns: &[u32],
        knowns: &[u32],
        direction: &[f64],
    ) -> Result<Vec<f64>, Status> {
        let mut changes = vec![0.0; unknowns.len()];
        // SAFETY: the component is alive, the arrays are as long as the counts say.
        let status = unsafe {
            fmi2GetDirectionalDerivative(
                self.component,
                unknowns.as_ptr(),
                unknowns.len(),
                knowns.as_ptr(),
                knowns.len(),
                direction.as_ptr(),
                changes.as_mut_ptr(),
            )
        };
        if status == Status::Ok { Ok(changes) } else { Err(status) }
    }

    /// Of outputs by their names along one known.
    pub(super) fn by(&self, known: &str, outputs: &[&str]) -> Vec<f64> {
        let outputs: Vec<u32> = outputs.iter().map(|name| reference(name)).collect();
        self.derivatives(&outputs, &[reference(known)], &[1.0]).unwrap()
    }

    fn triple(&self, [x, y, z]: [&str; 3]) -> Vector3<f64> {
        Vector3::new(self.get(x), self.get(y), self.get(z))
    }
}

fn references(wanted: impl Fn(Slot) -> bool) -> Vec<u32> {
    VariableTable::new(jet()).iter().filter(|(_, v)| wanted(v.slot)).map(|(r, _)| r).collect()
}

fn is_input(slot: Slot) -> bool {
    matches!(slot, Slot::Input(_))
}

/// In a steady climb with controls deflected and wind, so that nothing is zero by symmetry.
const DISTURBANCE: [(&str, f64); 5] = [
    ("elevator", -0.02),
    ("rudder", 0.01),
    ("aileron_symmetric", 0.03),
    ("wind_east", 4.0),
    ("wind_down", -2.0),
];

fn disturbed() -> Fmu {
    let fmu = Fmu::flying();
    assert_eq!(fmu.set(&DISTURBANCE), Status::Ok);
    assert_eq!(fmu.step(0.0, 0.35), Status::Ok);
    fmu
}

#[test]
fn controls_and_engines_follow_their_own_inputs_one_to_one_and_no_other() {
    let fmu = disturbed();
    let controls = [
        ("elevator", "surface.elevator"),
        ("aileron", "surface.aileron"),
        ("aileron_symmetric", "surface.aileron_symmetric"),
        ("rudder", "surface.rudder"),
        ("thrust_left", "engine.left.thrust"),
        ("thrust_right", "engine.right.thrust"),
    ];
    for (i, (input, _)) in controls.iter().enumerate() {
        for (j, derivative) in fmu.by(input, &controls.map(|(_, output)| output)).into_iter().enumerate() {
            let expected = if i == j { 1.0 } else { 0.0 };
            assert!((derivative - expected).abs() < 1e-12, "d {}/d {input}: {derivative}", controls[j].1);
        }
    }
}

/// By the definitions of airspeed, angles of flow, Mach number and dynamic pressure.
#[test]
fn the_flow_at_o_changes_with_the_wind_as_geometry_says() {
    let fmu = disturbed();
    let [roll, pitch, yaw] = ["attitude.roll", "attitude.pitch", "attitude.yaw"].map(|name| fmu.get(name));
    let to_body = Rotation3::from_euler_angles(roll, pitch, yaw).inverse();
    let wind = fmu.triple(["wind_north", "wind_east", "wind_down"]);
    let flow = fmu.triple(["velocity.x", "velocity.y", "velocity.z"]) - to_body * wind;
    let speed = flow.norm();
    assert!((speed - fmu.get("air.speed")).abs() < 1e-12 * speed);
    for (axis, input) in ["wind_north", "wind_east", "wind_down"].into_iter().enumerate() {
        let change = to_body * Vector3::ith(axis, -1.0);
        let faster = flow.dot(&change) / speed;
        let in_plane = flow.x.powi(2) + flow.z.powi(2);
        let expected = [
            ("air.speed", faster),
            ("air.alpha", (flow.x * change.z - flow.z * change.x) / in_plane),
            ("air.beta", (change.y - flow.y / speed * faster) / in_plane.sqrt()),
            ("air.mach", fmu.get("air.mach") / speed * faster),
            ("air.density", 0.0),
            ("air.dynamic_pressure", fmu.get("air.density") * speed * faster),
        ];
        for (derivative, (output, expected)) in
            fmu.by(input, &expected.map(|(output, _)| output)).into_iter().zip(expected)
        {
            let error = (derivative - expected).abs();
            assert!(
                error <= 1e-10 * expected.abs().max(1e-3),
                "d {output}/d {input}: {derivative} {expected}"
            );
        }
    }
}

/// How fast two flights part that are set apart in one input by `apart` each way: by its derivative, the inputs' whole effect on
/// v̇, ω̇ and q̈. Extrapolated from three short steps. What is left is rounding of the speeds, of which so little remains over so
/// short steps: 4e-7 m/s² per rad and less for the others, 2e-6 of the smallest effect; then third powers of the step over the
/// wake's shortest time (10 µs · 1600/s) and of the wind over the airspeed, both smaller.
fn parting(fmu: &Fmu, input: u32, apart: f64, outputs: &[u32]) -> Vec<f64> {
    const STEP: f64 = 1e-5;
    let beginning = Saved::of(fmu);
    let at = fmu.get_references(&[input]).unwrap()[0];
    let flown = |apart: f64, step: f64| {
        assert_eq!(beginning.restore(), Status::Ok);
        assert_eq!(fmu.set_references(&[input], &[at + apart]), Status::Ok);
        assert_eq!(fmu.step(0.35, step), Status::Ok, "{:?}", fmu.log);
        fmu.get_references(outputs).unwrap()
    };
    let speeds = [1.0, 2.0, 4.0].map(|steps| {
        let step = steps * STEP;
        let (ahead, behind) = (flown(apart, step), flown(-apart, step));
        ahead.iter().zip(behind).map(|(a, b)| (a - b) / (2.0 * apart * step)).collect::<Vec<f64>>()
    });
    assert_eq!(beginning.restore(), Status::Ok);
    let [near, far, farther] = &speeds;
    (0..outputs.len()).map(|i| (8.0 * near[i] - 6.0 * far[i] + farther[i]) / 3.0).collect()
}

#[test]
fn derivatives_by_inputs_are_the_rates_at_which_flights_part() {
    let fmu = disturbed();
    let table = VariableTable::new(jet());
    let modes = jet().modes.len();
    let names = ["velocity.x", "velocity.y", "velocity.z", "rate.x", "rate.y", "rate.z"].map(str::to_owned);
    let moving: Vec<String> =
        names.into_iter().chain((1..=modes).map(|mode| format!("modal.q_dot[{mode}]"))).collect();
    let moving: Vec<u32> = moving.iter().map(|name| reference(name)).collect();
    let q: Vec<f64> = (1..=modes).map(|mode| fmu.get(&format!("modal.q[{mode}]"))).collect();
    for input in references(is_input) {
        let name = &table.get(input).unwrap().name;
        let apart = if name.starts_with("thrust") {
            1000.0
        } else if name.starts_with("wind_rate") {
            10.0
        } else if name.starts_with("wind") {
            0.1
        } else {
            0.01
        };
        let parting = parting(&fmu, input, apart, &moving);
        let GeneralisedVector { translation: velocity, rotation: rate, modal } =
            GeneralisedVector::of(&parting);
        let combine = |shapes: &[f64], weights: &[f64]| {
            Vector3::from_fn(|axis, _| {
                (0..modes).map(|mode| shapes[axis * modes + mode] * weights[mode]).sum()
            })
        };
        let load_factor = velocity.component_mul(&Vector3::new(1.0, 1.0, -1.0)) / jet().gravity;
        let mut expected =
            vec![("acceleration".to_owned(), velocity), ("load_factor".to_owned(), load_factor)];
        for station in &jet().stations {
            let (translation, rotation) = (&station.shapes.translation, &station.shapes.rotation);
            let place = station.position + combine(translation, &q);
            let acceleration = velocity + rate.cross(&place) + combine(translation, modal);
            let turn: Rotation3<f64> = Rotation3::from_scaled_axis(combine(rotation, &q));
            expected
                .push((format!("station.{}.specific_force", station.name), turn.inverse() * acceleration));
        }
        for (group, expected) in expected {
            let outputs = ["x", "y", "z"].map(|axis| format!("{group}.{axis}"));
            let derivatives = fmu.by(name, &outputs.each_ref().map(String::as_str));
            let error = (Vector3::from_column_slice(&derivatives) - expected).norm();
            println!("d {group}/d {name}: {:.1e} of {:.3e}", error / expected.norm(), expected.norm());
            assert!(error < 1e-5 * expected.norm(), "d {group}/d {name}: {derivatives:?} {expected}");
        }
    }
}

#[test]
fn derivatives_vanish_exactly_where_the_model_description_says_that_nothing_depends() {
    let fmu = disturbed();
    let table = VariableTable::new(jet());
    for (reference, variable) in table.iter() {
        let (Slot::Output(slot), Type::Real) = (variable.slot, variable.kind) else { continue };
        let dependencies = table.dependencies(slot);
        for input in references(is_input) {
            let derivative = fmu.derivatives(&[reference], &[input], &[1.0]).unwrap()[0];
            let name = &table.get(input).unwrap().name;
            assert!(derivative == 0.0 || dependencies.contains(&input), "d {}/d {name}", variable.name);
        }
    }
}

#[test]
fn a_direction_of_several_knowns_adds_up_and_scales() {
    let outputs =
        ["acceleration.z", "station.wing_tip_left.specific_force.z", "surface.elevator"].map(reference);
    let initialising = Fmu::initialising();
    assert_eq!(initialising.set(&DISTURBANCE), Status::Ok);
    for (fmu, knowns) in [(disturbed(), ["elevator", "wind_down"]), (initialising, ["elevator", "airspeed"])]
    {
        let knowns = knowns.map(reference);
        let one = |i: usize| fmu.derivatives(&outputs, &knowns[i..=i], &[1.0]).unwrap();
        let (first, second) = (one(0), one(1));
        for scale in [1e-12, 1.0, 1e9] {
            let together = fmu.derivatives(&outputs, &knowns, &[2.0 * scale, -3.0 * scale]).unwrap();
            for ((together, first), second) in together.iter().zip(&first).zip(&second) {
                let expected = scale * (2.0 * first - 3.0 * second);
                assert!((together - expected).abs() < 1e-8 * expected.abs(), "{together} {expected}");
            }
        }
        assert_eq!(fmu.derivatives(&outputs, &knowns, &[0.0, 0.0]), Ok(vec![0.0; 3]));
    }
}

#[test]
fn asking_for_derivatives_leaves_the_flight_alone() {
    // In the symmetric flight half the aircraft flies, and answers for all of it.
    let symmetric = || {
        let fmu = Fmu::flying();
        assert_eq!([fmu.set(&[("elevator", 0.02)]), fmu.step(0.0, 0.354)], [Status::Ok; 2]);
        fmu
    };
    for (begin, flight) in [(0.35, disturbed as fn() -> Fmu), (0.354, symmetric)] {
        let (asked, silent) = (flight(), flight());
        for input in references(is_input) {
            asked.derivatives(&outputs_of(&VariableTable::new(jet()), Type::Real), &[input], &[1.0]).unwrap();
        }
        assert_eq!(asked.outputs(), silent.outputs());
        assert_eq!(Saved::of(&asked).bytes(), Saved::of(&silent).bytes());
        for fmu in [&asked, &silent] {
            assert_eq!(fmu.step(begin, 0.2), Status::Ok);
        }
        assert_eq!(asked.outputs(), silent.outputs());
        assert_eq!(Saved::of(&asked).bytes(), Saved::of(&silent).bytes());
    }
}

/// By parameters the Jacobian of the trim is needed: central differences by pitch, elevator, thrust and every symmetric mode.
#[test]
fn a_call_by_inputs_costs_at_most_8_right_hand_sides_and_calls_by_parameters_share_one_jacobian() {
    let count = |action: &dyn Fn()| {
        let before = evaluations::so_far();
        action();
        evaluations::so_far() - before
    };
    let outputs = outputs_of(&VariableTable::new(jet()), Type::Real);
    for fmu in [disturbed(), Fmu::flying(), Fmu::initialising()] {
        fmu.outputs();
        for input in references(is_input) {
            let cost = count(&|| {
                fmu.derivatives(&outputs, &[input], &[1.0]).unwrap();
                fmu.outputs();
            });
            let is_wind = VariableTable::new(jet()).get(input).unwrap().name.starts_with("wind");
            let least = if is_wind { 4 } else { 0 }; // controls and thrusts act through forces that are there already
            assert!((least..=8).contains(&cost), "{cost} for {input}");
        }
    }
    let fmu = Fmu::initialising();
    for known in ["elevator", "wind_down", "airspeed"] {
        let (output, reference) = ([reference("load_factor.z")], [reference(known)]);
        let time = shortest(|_| assert!(fmu.derivatives(&output, &reference, &[1.0]).is_ok()));
        println!("a call by {known} takes {:.1} µs", 1e6 * time);
    }
    let fmu = Fmu::initialising();
    fmu.outputs();
    let cost = |known: &str| count(&|| assert_eq!(fmu.by(known, &["attitude.pitch"]).len(), 1));
    let (first, others) = (cost("airspeed"), ["airspeed", "altitude", "stiffness_scale"].map(cost));
    let symmetric = 6; // of the twelve lowest modes
    assert_eq!(first - others[0], 2 * (3 + symmetric));
    println!("right-hand sides of a call by airspeed: {first}, then {others:?}");
    assert!(others.iter().all(|other| *other <= 20), "{others:?}");
}

#[test]
fn derivatives_are_refused_of_what_is_no_output_and_by_what_is_no_known() {
    let (fmu, flying) = (Fmu::initialising(), Fmu::flying());
    let (output, input) = (reference("surface.elevator"), reference("elevator"));
    let airspeed = reference("airspeed");
    for (fmu, unknown, known, direction, parts) in [
        (&fmu, input, input, 1.0, ["`elevator`", "not an output"]),
        (&fmu, output, output, 1.0, ["`surface.elevator`", "neither an input nor a parameter"]),
        (&flying, output, airspeed, 1.0, ["`airspeed`", "only in initialisation mode"]),
        (&fmu, output, reference("model"), 1.0, ["`model`", "a Real"]),
        (&fmu, reference("model"), input, 1.0, ["`model`", "a Real"]),
        (&fmu, output, 100_000, 1.0, ["100000", "no such variable"]),
        (&fmu, output, input, f64::NAN, ["`elevator`", "NaN"]),
        (&fmu, output, airspeed, f64::INFINITY, ["`airspeed`", "inf"]),
    ] {
        assert_eq!(fmu.derivatives(&[unknown], &[known], &[direction]), Err(Status::Error));
        fmu.assert_refused(&parts);
    }
    // Where the trim has to be found first and there is none.
    let slow = Fmu::initialising();
    assert_eq!(slow.set(&[("airspeed", 1.0)]), Status::Ok);
    assert_eq!(slow.derivatives(&[output], &[airspeed], &[1.0]), Err(Status::Error));
    slow.assert_refused(&["no steady level flight"]);
}
