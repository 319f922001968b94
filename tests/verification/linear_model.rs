//! Linear models by names: gains and eigenvalues against an independent computation, and small steps as flown
//! [theory: linearisation.inputs, linearisation.outputs, linearisation.wind-rates].

use std::f64::consts::PI;

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::{ConditionSettings, ManoeuvreChoice, Plant, PlantSettings};
use flexible_aircraft::{Flight, Inflow, LinearModel};
use nalgebra::Complex;

use crate::support::jet;
use crate::support::linearised::eigenvalue_near;
use crate::support::response::{frequency_response, place, step_response};

use super::record::Record;

pub(super) const SOURCE: &str = "prototype in numpy that shares nothing with this program; differences of second order with steps of 1e-6";

/// The jet at 127 m/s and 7620 m with twelve modes of both families, N = 5.
pub(super) fn settings(stiffness_scale: f64, condition: ConditionSettings) -> Settings {
    PlantSettings {
        fidelity: Fidelity::Exact,
        stiffness_scale,
        inflow_states: 5,
        condition,
        ..PlantSettings::of(&jet())
    }
    .into()
}

pub(super) fn level() -> ConditionSettings {
    ConditionSettings::default()
}

pub(super) fn linearised(stiffness_scale: f64, inflow: Inflow) -> LinearModel {
    LinearModel::new(jet(), &settings(stiffness_scale, level()), inflow).unwrap()
}

/// Input, output, ω (rad/s), gains of nominal and one-tenth stiffness.
type Gain = (&'static str, &'static str, f64, [(f64, f64); 2]);

const GAINS: [Gain; 7] = [
    ("elevator", "load_factor.z", 1.0, [(-1.6280, 2.5013), (-1.3117, 2.0693)]),
    ("elevator", "rate.y", 1.0, [(-0.47283, -0.045226), (-0.43812, -0.071064)]),
    ("aileron", "rate.x", 1.0, [(1.7891, -0.70466), (0.58247, -0.035478)]),
    ("rudder", "air.beta", 1.0, [(-0.20418, 0.040225), (-0.17908, 0.061422)]),
    ("elevator", "loads.wing_root_right.bending", 9.0, [(9208.2, 819.91), (12_381.0, 39_537.0)]),
    ("aileron", "rate.x", 9.0, [(0.19372, -0.92792), (0.13664, -1.0405)]),
    ("wind_down", "load_factor.z", 9.0, [(-0.055350, 0.0088441), (0.0053671, 0.054670)]),
];

#[test]
fn gains_are_those_of_the_independent_computation() {
    let mut record = Record::new(
        "linear-model-gains",
        "Gains of the linear model of the jet, 127 m/s, 7620 m, twelve modes, N = 5, SI units; the wind acts by its rate too \
         (to 2e-4 of each gain's magnitude; the reference has five digits, by coarser differences)",
        SOURCE,
    );
    for (stiffness, name) in [(1.0, "nominal"), (0.1, "tenth")] {
        let model = linearised(stiffness, Inflow::Kept);
        let [slow, fast] = [1.0, 9.0].map(|frequency| frequency_response(&model, frequency));
        for (input, output, frequency, references) in GAINS {
            let (re, im) = references[usize::from(stiffness != 1.0)];
            let response = if frequency == 1.0 { &slow } else { &fast };
            let found = response[(place(&model.outputs, output), place(&model.inputs, input))];
            let tolerance = 2e-4 * libm::hypot(re, im);
            let case = format!("{name}, {input} → {output}, ω = {frequency}");
            record.absolute(&format!("{case}: real part"), re, tolerance, found.re);
            record.absolute(&format!("{case}: imaginary part"), im, tolerance, found.im);
        }
    }
    record.finish();
}

/// Name, real and imaginary part, 1/s.
pub(super) type Roots = &'static [(&'static str, f64, f64)];

/// Real parts of which only four digits are printed in the columns that have five.
pub(super) const FOUR_DIGITS: [f64; 4] = [-3.2610, -1.4614, -1.1376, -0.7653];

pub(super) const NOMINAL: Roots = &[
    ("phugoid", -0.01050, 0.11412),
    ("short period", -0.52616, 1.20220),
    ("spiral", -0.00060, 0.0),
    ("Dutch roll", -0.25477, 1.77369),
    ("roll", -3.2610, 0.0),
    ("symmetric 1", -1.4614, 15.5731),
    ("symmetric 2", -0.01419, 26.63184),
    ("symmetric 3", -0.77321, 37.13746),
    ("antisymmetric 1", -0.73901, 26.09579),
    ("antisymmetric 2", -0.68980, 28.09516),
];

pub(super) const NOMINAL_STEADY: Roots = &[
    ("phugoid", -0.01068, 0.11410),
    ("short period", -0.51502, 1.16115),
    ("spiral", -0.00060, 0.0),
    ("Dutch roll", -0.35053, 1.76127),
    ("roll", -2.43326, 0.0),
    ("symmetric 1", -1.98396, 15.17350),
    ("symmetric 2", -0.01538, 26.63201),
    ("symmetric 3", -1.15044, 37.12937),
    ("antisymmetric 1", -1.18249, 26.16553),
    ("antisymmetric 2", -0.91411, 27.75915),
];

pub(super) const TENTH: Roots = &[
    ("phugoid", -0.00865, 0.10438),
    ("short period", -0.45302, 1.19072),
    ("spiral", -0.03153, 0.0),
    ("Dutch roll", -0.36493, 1.69456),
    ("roll", -2.65480, 0.0),
    ("symmetric 1", -1.1376, 8.4287),
    ("symmetric 2", -0.04243, 9.53303),
    ("symmetric 3", -0.47830, 13.31385),
    ("antisymmetric 1", -0.20862, 9.74617),
    ("antisymmetric 2", -0.7653, 13.4444),
];

pub(super) const TENTH_STEADY: Roots = &[
    ("phugoid", -0.00874, 0.10437),
    ("short period", -0.45441, 1.15600),
    ("spiral", -0.03153, 0.0),
    ("Dutch roll", -0.42379, 1.67419),
    ("roll", -2.13492, 0.0),
    ("symmetric 1", -1.49369, 8.17277),
    ("symmetric 2", -0.04556, 9.53254),
    ("symmetric 3", -0.80846, 13.42524),
    ("antisymmetric 1", -0.30766, 9.84748),
    ("antisymmetric 2", -1.30659, 13.55022),
];

pub(super) const TURN: Roots = &[
    ("phugoid", -0.0137, 0.1237),
    ("short period", -0.5176, 1.2039),
    ("spiral", -0.0043, 0.0),
    ("Dutch roll", -0.2838, 1.7892),
    ("roll", -3.1031, 0.0),
    ("symmetric 1", -1.4382, 15.8044),
    ("symmetric 2", -0.0150, 26.6784),
    ("symmetric 3", -0.7654, 37.1960),
    ("antisymmetric 1", -0.6639, 26.2234),
    ("antisymmetric 2", -0.7486, 28.4725),
];

#[test]
fn eigenvalues_are_those_of_the_independent_computation() {
    let mut record = Record::new(
        "linear-model-eigenvalues",
        "Eigenvalues of the linear model of the jet, 127 m/s, 7620 m, twelve modes, 1/s: the nearest one to each of the reference \
         (to the digits of the reference)",
        SOURCE,
    );
    let turn = ConditionSettings { manoeuvre: ManoeuvreChoice::Turn, bank_angle: PI / 6.0, ..level() };
    let turning = LinearModel::new(jet(), &settings(1.0, turn), Inflow::Kept).unwrap();
    let cases = [
        ("nominal, N = 5", linearised(1.0, Inflow::Kept), NOMINAL, 1.2e-5),
        ("nominal, N = 0", linearised(1.0, Inflow::Steady), NOMINAL_STEADY, 1.2e-5),
        ("tenth, N = 5", linearised(0.1, Inflow::Kept), TENTH, 1.2e-5),
        ("tenth, N = 0", linearised(0.1, Inflow::Steady), TENTH_STEADY, 1.2e-5),
        ("nominal, N = 5, turn φ 30°", turning, TURN, 6e-5),
    ];
    for (name, model, roots, printed) in cases {
        for &(root, re, im) in roots {
            let tolerance = if FOUR_DIGITS.contains(&re) { 6e-5 } else { printed };
            let found = eigenvalue_near(&model.a, Complex::new(re, im));
            record.absolute(&format!("{name}, {root}: real part"), re, tolerance, found.re);
            if im != 0.0 {
                record.absolute(&format!("{name}, {root}: imaginary part"), im, tolerance, found.im);
            }
        }
    }
    record.finish();
}

/// Outputs at every step of a flight in which an input jumps at the start.
fn flown(input: &str, jump: f64, outputs: &[&str]) -> Vec<Vec<f64>> {
    let mut flight = Flight::new(jet());
    flight.set("model", "exact").unwrap();
    flight.set("inflow_states", STEP_INFLOW).unwrap();
    flight.set("tolerance", 1e-9).unwrap();
    let read = |flight: &mut Flight| -> Vec<f64> {
        outputs.iter().map(|output| flight.get(output).unwrap()).collect()
    };
    flight.set(input, jump).unwrap();
    let mut history = vec![read(&mut flight)];
    for _ in 0..STEPS {
        flight.advance(STEP).unwrap();
        history.push(read(&mut flight));
    }
    history
}

/// s, and how many.
const STEP: f64 = 0.01;
const STEPS: usize = 200;

/// Fewer than usual, for the exponential of a matrix of all states.
const STEP_INFLOW: i32 = 2;

#[test]
fn a_small_step_is_answered_in_flight_as_the_linear_model_has_it() {
    const JUMP: f64 = 1e-3;
    let mut record = Record::new(
        "linear-model-steps",
        "Steps of 1e-3 rad, 2 s: flight against linear model of the jet, 127 m/s, 7620 m, twelve modes, N = 2; half the difference of \
         a step up and a step down, in which nothing quadratic is left; largest deviation by the peak",
        "the same equations, integrated in time",
    );
    let small = PlantSettings { inflow_states: 2, ..settings(1.0, level()).plant };
    let model = LinearModel::new(jet(), &small.into(), Inflow::Kept).unwrap();
    let cases: [(&str, f64, &[&str]); 2] = [
        (
            "elevator",
            2.5e-6,
            &[
                "load_factor.z",
                "rate.y",
                "attitude.pitch",
                "air.alpha",
                "deflection.wing_tip_right.up",
                "loads.wing_root_right.bending",
                "loads.htail_root_right.shear",
            ],
        ),
        ("aileron", 2.5e-5, &["rate.x", "attitude.roll", "air.beta", "loads.wing_mid_right.torsion"]),
    ];
    for (input, tolerance, outputs) in cases {
        let [up, down] = [JUMP, -JUMP].map(|jump| flown(input, jump, outputs));
        let linear = step_response(&model, input, JUMP, STEP, STEPS);
        for (column, output) in outputs.iter().enumerate() {
            let row = place(&model.outputs, output);
            let (mut peak, mut deviation) = (0.0_f64, 0.0_f64);
            for ((up, down), linear) in up.iter().zip(&down).zip(&linear) {
                let flown = 0.5 * (up[column] - down[column]);
                peak = peak.max(linear[row].abs());
                deviation = deviation.max((flown - linear[row]).abs());
            }
            record.error(&format!("{input} → {output}"), tolerance, deviation / peak);
        }
    }
    record.finish();
}

#[test]
fn the_state_matrix_is_that_of_the_plant() {
    let plant_settings = PlantSettings { mode_count: 4, inflow_states: 1, ..settings(1.0, level()).plant };
    let plant = Plant::under(&jet(), &plant_settings).unwrap();
    let trim = plant.trim(&plant_settings.trim_condition()).unwrap();
    let expected = plant.linearise(&trim).matrix;
    let model = LinearModel::new(jet(), &plant_settings.into(), Inflow::Kept).unwrap();
    for (found, expected) in model.a.row_iter().zip(expected.row_iter()) {
        assert!((found - expected).amax() <= 1e-8 * expected.amax());
    }
}
