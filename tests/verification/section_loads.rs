//! Section loads against an independent computation, and in equilibrium where components meet
//! [theory: section-loads.summation, section-loads.components, section-loads.equilibrium].

use std::f64::consts::FRAC_PI_2;
use std::path::Path;
use std::sync::Arc;

use flexible_aircraft::air::{GustSettings, TurbulenceSettings};
use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::{Fidelity, SectionLoads};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::ReducedModel;
use nalgebra::Vector3;

use crate::support::{AILERON, ELEVATOR, RUDDER, jet};

use super::gusts::{STEP, flight, gust, weak_gust};
use super::record::Record;

const SOURCE: &str = "prototype in numpy that shares nothing with this program";

/// The loads at the cut of a name.
fn at<'l>(model: &ReducedModel, loads: &'l [SectionLoads], name: &str) -> &'l SectionLoads {
    &loads[model.cuts.iter().position(|cut| cut.name == name).unwrap()]
}

/// Of the present.
fn loads(simulation: &mut Simulation) -> Vec<SectionLoads> {
    simulation.instant_with_loads().outputs.loads.known().unwrap().to_vec()
}

/// The jet at a level and a stiffness, before nothing.
fn calm(fidelity: Fidelity, stiffness_scale: f64) -> Settings {
    PlantSettings { fidelity, stiffness_scale, ..PlantSettings::of(&jet()) }.into()
}

#[test]
fn the_loads_of_level_flight_are_those_of_the_independent_computation() {
    let mut record = Record::new(
        "section-loads",
        "Section loads of the jet in level flight, 127 m/s at 7620 m, twelve modes: N and N m (to the digits of the reference)",
        SOURCE,
    );
    // Shear, chordwise shear, axial force, torsion, bending, chordwise bending.
    let cases = [
        (1.0, "wing_root_right", [90_825.0, -7258.0, -7891.0, 52_149.0, 532_649.0, -30_412.0]),
        (1.0, "wing_mid_right", [42_025.0, -1838.0, -1680.0, 12_544.0, 125_555.0, -4187.0]),
        (1.0, "htail_root_right", [6141.0, -410.0, -430.0, 3057.0, 15_519.0, -944.0]),
        (1.0, "vtail_root", [0.0, -2494.0, -2271.0, 0.0, 0.0, -6124.0]),
        (1.0, "fuselage_aft", [906.0, 0.0, 2637.0, 0.0, 23_995.0, 0.0]),
        (1.0, "fuselage_tail", [8800.0, 0.0, 1523.0, 0.0, -12_330.0, 0.0]),
        (0.1, "wing_root_right", [91_329.0, -6741.0, -28_136.0, 54_645.0, 533_142.0, -19_637.0]),
        (0.1, "wing_mid_right", [40_882.0, -1819.0, -3746.0, 11_846.0, 126_034.0, -4392.0]),
        (0.1, "htail_root_right", [6503.0, -319.0, -626.0, 3561.0, 16_241.0, -643.0]),
    ];
    for stiffness in [1.0, 0.1] {
        let mut simulation = Simulation::new(jet(), &calm(Fidelity::Exact, stiffness), 0.0).unwrap();
        let found = loads(&mut simulation);
        for (_, name, expected) in cases.iter().filter(|(of, ..)| *of == stiffness) {
            let sides = if name.ends_with("_right") { vec!["_right", "_left"] } else { vec![""] };
            for side in sides {
                let name = name.replace("_right", side);
                for ((component, expected), found) in
                    COMPONENTS.iter().zip(expected).zip(components(at(&jet(), &found, &name)))
                {
                    record.absolute(
                        &format!("stiffness {stiffness}, {name}: {component}"),
                        *expected,
                        0.51,
                        found,
                    );
                }
            }
        }
    }
    record.finish();
}

const COMPONENTS: [&str; 6] =
    ["shear", "shear_chordwise", "axial", "torsion", "bending", "bending_chordwise"];

fn components(loads: &SectionLoads) -> [f64; 6] {
    let SectionLoads { shear, shear_chordwise, axial, torsion, bending, bending_chordwise, .. } = *loads;
    [shear, shear_chordwise, axial, torsion, bending, bending_chordwise]
}

/// Loads at every step of a flight without a hand on the controls.
fn hands_off(settings: &Settings, seconds: f64) -> Vec<Vec<SectionLoads>> {
    let mut simulation = Simulation::new(jet(), settings, 0.0).unwrap();
    let mut history = vec![loads(&mut simulation)];
    for step in 1..=(seconds / STEP).round() as usize {
        simulation.advance_to(step as f64 * STEP).unwrap();
        history.push(loads(&mut simulation));
    }
    history
}
/// A component of a section's loads, by name.
type Quantity = (&'static str, fn(&SectionLoads) -> f64);

#[test]
fn a_gust_loads_sections_as_the_independent_computation_has_it() {
    let mut record = Record::new(
        "section-loads-gust",
        "Largest section loads in 1-cosine gusts upwards, 10 m/s, met by the nose after 0.5 s (1e-3 of the increment)",
        "prototype in numpy that shares nothing with this program; fourth-order steps of 5 ms",
    );
    // Gradient, m; bending and torsion of the right wing's root, bending of the right tailplane's, shear at the tails.
    let cases = [
        (1.0, 15.0, [811_992.0, 73_429.0, 30_566.0, 18_201.0]),
        (1.0, 30.0, [873_133.0, 73_103.0, 28_046.0, 15_705.0]),
        (1.0, 60.0, [800_371.0, 75_640.0, 28_718.0, 17_184.0]),
        (1.0, 107.0, [766_228.0, 74_993.0, 27_248.0, 16_191.0]),
        (0.1, 15.0, [688_748.0, 77_531.0, 32_679.0, 16_035.0]),
        (0.1, 30.0, [791_602.0, 77_949.0, 29_681.0, 18_895.0]),
        (0.1, 60.0, [834_058.0, 73_890.0, 29_281.0, 18_117.0]),
        (0.1, 107.0, [771_729.0, 73_639.0, 27_366.0, 16_404.0]),
    ];
    let quantities: [Quantity; 4] = [
        ("wing_root_right", |loads| loads.bending),
        ("wing_root_right", |loads| loads.torsion),
        ("htail_root_right", |loads| loads.bending),
        ("fuselage_tail", |loads| loads.shear),
    ];
    for (stiffness, gradient, expected) in cases {
        let flown = hands_off(&flight(stiffness, gust(gradient), TurbulenceSettings::default()), 3.0);
        for (place, (cut, value)) in quantities.iter().enumerate() {
            let history: Vec<f64> = flown.iter().map(|loads| value(at(&jet(), loads, cut))).collect();
            let largest = history.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let case = format!(
                "stiffness {stiffness}, H = {gradient} m: {cut} {}",
                ["bending", "torsion", "bending", "shear"][place]
            );
            record.absolute(&case, expected[place], 1e-3 * (expected[place] - history[0]), largest);
        }
    }
    // So weak that the aircraft answers linearly: fifty times its increment is that of 10 m/s.
    let flown = hands_off(&weak_gust(), 1.5);
    let bending = flown.iter().map(|loads| at(&jet(), loads, "wing_root_right").bending);
    let increment =
        bending.fold(f64::NEG_INFINITY, f64::max) - at(&jet(), &flown[0], "wing_root_right").bending;
    let case = "nominal, H = 30 m, 0.2 m/s: 50 times the increment of wing_root_right bending";
    record.relative(case, 336_961.0, 1e-3, 50.0 * increment);
    let lateral = GustSettings { direction: FRAC_PI_2, ..gust(60.0) };
    let flown = hands_off(&flight(1.0, lateral, TurbulenceSettings::default()), 2.0);
    for (name, value, expected, when) in
        [("shear", quantities[3].1, -11_583.0, 1.147), ("bending", quantities[0].1, -25_959.0, 1.152)]
    {
        let history: Vec<f64> = flown.iter().map(|loads| value(at(&jet(), loads, "vtail_root"))).collect();
        let least = history.iter().copied().fold(f64::INFINITY, f64::min);
        let found = history.iter().position(|value| *value == least).unwrap() as f64 * STEP;
        record.absolute(
            &format!("gust to the right, H = 60 m: least vtail_root {name}"),
            expected,
            -1e-3 * expected,
            least,
        );
        record.absolute(&format!("gust to the right, H = 60 m: vtail_root {name} at, s"), when, STEP, found);
    }
    record.finish();
}

/// An aircraft with so many modes and with cuts through these components at O, which are all that meet there.
fn cut_all_round(
    mut aircraft: Aircraft,
    modes: usize,
    components: &[&str],
) -> (Arc<ReducedModel>, Vec<String>) {
    aircraft.cuts = components.iter().map(|root| aircraft.cuts_along(root).unwrap().swap_remove(0)).collect();
    let roots = aircraft.cuts.iter().map(|cut| cut.name.clone()).collect();
    (Arc::new(ReducedModel::new(&aircraft, modes).unwrap()), roots)
}

fn jet_cut_all_round() -> (Arc<ReducedModel>, Vec<String>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
    let roots = ["wing_right", "wing_left", "fuselage_fore", "fuselage_aft"];
    cut_all_round(Aircraft::read(&path).unwrap(), ReducedModel::USUAL_MODES, &roots)
}

/// The small aircraft of the tests, with winglets, a V-tail, and its engine out on the right wing.
fn lopsided_cut_all_round() -> (Arc<ReducedModel>, Vec<String>) {
    let mut text = include_str!("../data/small-aircraft.toml").to_owned();
    for (from, to) in [
        ("symmetric = true", "symmetric = false"),
        (
            "[[0, 0, 0], [0, 5, 0]]\nelements = 4",
            "[[0, 0, 0], [-0.5, 5, -0.2], [-0.8, 5.1, -1]]\nelements = [4, 2]",
        ),
        (
            "component = \"fuselage\"\nat_m = 0\n",
            "component = \"wing_right\"\nat = 0.25\noffset_m = [0.5, 0, 0.2]\n",
        ),
    ] {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    let aircraft = Aircraft::parse(&text, "lopsided.toml").unwrap();
    cut_all_round(aircraft, 12, &["wing_right", "wing_left", "fuselage"])
}

/// What is left of forces, N, and of moments about O, N m.
fn residual(model: &ReducedModel, loads: &[SectionLoads], roots: &[String]) -> [f64; 2] {
    let sum = |vector: fn(&SectionLoads) -> Vector3<f64>| -> f64 {
        roots.iter().map(|root| vector(at(model, loads, root))).sum::<Vector3<f64>>().norm()
    };
    [sum(|loads| loads.force), sum(|loads| loads.moment)]
}

/// The most that is left at looks 50 ms apart in a manoeuvre with three controls (rad at most) and an engine (N) in an oblique
/// gust (m/s).
fn most_left_over(
    (model, roots): &(Arc<ReducedModel>, Vec<String>),
    plant: PlantSettings,
    [pitching, rolling, yawing]: [usize; 3],
    [angle, push, peak]: [f64; 3],
    looks: usize,
) -> [f64; 2] {
    let oblique = GustSettings { direction: 0.5, inclination: 0.3, start: 0.1, peak, ..gust(30.0) };
    let settings = Settings { gust: oblique, ..plant.into() };
    let mut simulation = Simulation::new(Arc::clone(model), &settings, 0.0).unwrap();
    let mut inputs = Inputs::zero(model);
    let mut most = residual(model, &loads(&mut simulation), roots);
    for step in 1..=looks {
        let phase = 0.3 * step as f64;
        inputs.controls[pitching] = angle * libm::sin(phase);
        inputs.controls[rolling] = angle * libm::cos(phase);
        inputs.controls[yawing] = angle * libm::sin(2.0 * phase);
        inputs.thrust[0] = push * libm::sin(phase);
        simulation.set_inputs(&inputs, &Inputs::zero(model));
        simulation.advance_to(0.05 * step as f64).unwrap();
        let found = residual(model, &loads(&mut simulation), roots);
        most = [0, 1].map(|i| most[i].max(found[i]));
    }
    assert!(!simulation.is_symmetric());
    most
}

#[test]
fn components_that_meet_at_o_are_in_equilibrium_there() {
    let mut record = Record::new(
        "section-loads-equilibrium",
        "Loads at O of all components that meet there, summed: what is left, over the weight (and 1 m), the most over 2 s of a \
         manoeuvre with all controls in an oblique gust, of the small aircraft over 0.5 s; of CL and RL at the trim",
        "equilibrium",
    );
    let jet = jet_cut_all_round();
    let (model, roots) = &jet;
    let weight = model.integrals.mass * model.gravity;
    for (fidelity, stiffness) in [
        (Fidelity::Exact, 1.0),
        (Fidelity::Exact, 0.1),
        (Fidelity::Inconsistent, 0.1),
        (Fidelity::GeometricallyExact, 1.0),
        (Fidelity::GeometricallyExact, 0.1),
    ] {
        let left = most_left_over(
            &jet,
            calm(fidelity, stiffness).plant,
            [ELEVATOR, AILERON, RUDDER],
            [0.05, 5000.0, 10.0],
            40,
        );
        record.rounding(&format!("{fidelity:?}, stiffness {stiffness}: force"), 1e-13, left[0] / weight);
        record.rounding(&format!("{fidelity:?}, stiffness {stiffness}: moment"), 1e-13, left[1] / weight);
    }
    let lopsided = lopsided_cut_all_round();
    let own_weight = lopsided.0.integrals.mass * lopsided.0.gravity;
    for fidelity in [Fidelity::Exact, Fidelity::GeometricallyExact] {
        // Hands off it does not stay upright for a second.
        let plant = PlantSettings { fidelity, ..PlantSettings::of(&lopsided.0) };
        let left = most_left_over(&lopsided, plant, [0, 1, 2], [0.01, 20.0, 2.0], 10);
        let case = format!("{fidelity:?}, small aircraft with winglets, a V-tail and an engine on one wing");
        record.rounding(&format!("{case}: force"), 1e-12, left[0] / own_weight);
        record.rounding(&format!("{case}: moment"), 1e-12, left[1] / own_weight);
    }
    let mut propellers = (*jet.0).clone();
    for engine in &mut propellers.engines {
        (engine.angular_momentum, engine.torque) = (5e3, -0.3);
    }
    let propellers = (Arc::new(propellers), jet.1.clone());
    for fidelity in [Fidelity::Exact, Fidelity::GeometricallyExact] {
        let plant = calm(fidelity, 0.1).plant;
        let left = most_left_over(&propellers, plant, [ELEVATOR, AILERON, RUDDER], [0.05, 5000.0, 10.0], 10);
        let case = format!("{fidelity:?}, stiffness 0.1, propellers that turn the same way");
        record.rounding(&format!("{case}: force"), 1e-13, left[0] / weight);
        record.rounding(&format!("{case}: moment"), 1e-13, left[1] / weight);
    }
    for stiffness in [1.0, 0.1] {
        let at_trim = |fidelity| {
            let settings = calm(fidelity, stiffness);
            let mut simulation = Simulation::new(Arc::clone(model), &settings, 0.0).unwrap();
            residual(model, &loads(&mut simulation), roots)
        };
        let [force, moment] = at_trim(Fidelity::ConsistentlyLinearised);
        record.rounding(&format!("CL at the trim, stiffness {stiffness}: force"), 1e-13, force / weight);
        record.rounding(&format!("CL at the trim, stiffness {stiffness}: moment"), 1e-13, moment / weight);
        let [force, moment] = at_trim(Fidelity::RuthlesslyLinearised);
        record.rounding(&format!("RL at the trim, stiffness {stiffness}: force"), 1e-13, force / weight);
        let (expected, tolerance) = if stiffness == 1.0 { (1.2e3, 50.0) } else { (1.1e4, 500.0) };
        let case = format!("RL at the trim, stiffness {stiffness}: moment, N m, from its own arms");
        record.absolute(&case, expected, tolerance, moment);
    }
    record.finish();
}

#[test]
fn half_the_aircraft_has_the_loads_of_the_whole_one() {
    let mut record = Record::new(
        "section-loads-half",
        "Section loads in an upward gust flown by half the aircraft and by all of it: largest difference of any component over \
         1.5 s, over the largest bending",
        "the whole aircraft, kept from using its symmetry by an aileron of 1e-14 rad",
    );
    for fidelity in Fidelity::ALL {
        let settings = Settings { tolerance: 1e-8, gust: gust(30.0), ..calm(fidelity, 0.3) };
        let fly = |aileron: f64| {
            let mut simulation = Simulation::new(jet(), &settings, 0.0).unwrap();
            let mut inputs = Inputs::zero(&jet());
            inputs.controls[AILERON] = aileron;
            simulation.set_inputs(&inputs, &Inputs::zero(&jet()));
            let history: Vec<_> = (0..=15)
                .map(|step| {
                    simulation.advance_to(0.1 * f64::from(step)).unwrap();
                    loads(&mut simulation)
                })
                .collect();
            assert_eq!(simulation.is_symmetric(), aileron == 0.0);
            history
        };
        let (half, whole) = (fly(0.0), fly(1e-14));
        let pairs = half.iter().flatten().zip(whole.iter().flatten());
        let difference = pairs.fold(0.0_f64, |largest, (half, whole)| {
            let differences = components(half).into_iter().zip(components(whole)).map(|(a, b)| (a - b).abs());
            differences.fold(largest, f64::max)
        });
        let largest = half.iter().flatten().fold(0.0_f64, |largest, loads| largest.max(loads.bending.abs()));
        record.rounding(&format!("{fidelity:?}"), 3e-12, difference / largest);
    }
    record.finish();
}
