//! Beams that bend as far as one likes: Euler's elastica, a half circle, a bend of 45° that leaves its plane.
//!
//! [theory: geometrically-exact.recursion, geometrically-exact.basis, gravity-and-thrust.point-loads]
//!
//! The exact level superposes displacements, so that a beam must stretch to bend far and is held by its axial stiffness.

use std::f64::consts::PI;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::{PlantSettings, PointLoad};
use flexible_aircraft::structure::ReducedModel;
use nalgebra::{Matrix3, Vector3};

use crate::support::beams::{Cantilever, MIDDLE};
use crate::support::planar::{TIP, plant, tip, with_strains_of_tip_loads, with_tip};

use super::record::Record;

/// Of unit length and stiffness; in its other plane and in torsion it is so stiff that its lowest modes bend it in x and z.
fn cantilever(elements: usize) -> Aircraft {
    let beam = Cantilever {
        axis: Vector3::x(),
        y_axis: Vector3::y(),
        length: 1.0,
        axial: 1e6,
        torsional: 1e6,
        bending_y: 1.0,
        bending_z: 1e6,
        mass_per_length: 1.0,
        gyration: 1e-3,
        lumps: MIDDLE,
    };
    with_tip(beam.aircraft(elements))
}

#[test]
fn a_trim_rests_where_the_load_has_led_step_by_step() {
    // Newton's method at once finds no rest under the load of 10, and under that of 20 one that is bent the other way. That one is
    // computed by the same elliptic integrals, θ being the tip's slope, sin θ = 2k² − 1:
    // x/L = √(2 sin θ/(PL²/EI)), z/L = 1 − 2 (E(k) − E(φ, k))/√(PL²/EI), sin φ = 1/(k√2), K(k) − F(φ, k) = √(PL²/EI).
    let loads = DEAD_LOADS.into_iter().chain([(20.0, [0.316_114, 0.868_696])]);
    let model = ReducedModel::new(&cantilever(40), 8).unwrap();
    let plant = plant(&model, Fidelity::GeometricallyExact);
    for (load, [x, z]) in loads {
        let force = Vector3::z() * load;
        let stepped = tip(&plant, &model, force, Vector3::zeros());
        let dead = PointLoad { station: TIP.to_owned(), force, moment: Vector3::zeros() };
        let loaded = plant.clone().under_loads(&[dead]).unwrap();
        let trim = loaded.trim(&PlantSettings::of(&model).trim_condition()).unwrap();
        let outputs = loaded.outputs_at(&trim.state, &trim.controls, &mut loaded.workspace());
        let trimmed = model.stations[0].position + outputs.deflections[0].displacement;
        assert!((stepped - trimmed).norm() < 1e-9, "{load}: {stepped} {trimmed}");
        let apart = (trimmed - Vector3::new(x, 0.0, z)).norm();
        assert!(apart < 1e-4, "{load}: {apart}");
    }
}

/// PL²/EI, and x/L and z/L of the tip.
const DEAD_LOADS: [(f64, [f64; 2]); 4] = [
    (1.0, [0.943_567, 0.301_721]),
    (2.0, [0.839_358, 0.493_457]),
    (5.0, [0.612_372, 0.713_792]),
    (10.0, [0.445_004, 0.810_609]),
];

#[test]
fn a_cantilever_under_a_dead_force_is_the_elastica() {
    let mut record = Record::new(
        "elastica",
        "Cantilever of 40 elements under a dead force at its tip: x/L and z/L of the tip over PL²/EI",
        "elliptic integrals: K. Mattiasson, Int. J. Numer. Methods Eng. 17 (1981) 145–153, whose five digits these round to",
    );
    let aircraft = cantilever(40);
    for (modes, bound) in [(8, 1e-4), (4, 5e-4)] {
        let model = ReducedModel::new(&aircraft, modes).unwrap();
        let plant = plant(&model, Fidelity::GeometricallyExact);
        for (load, [x, z]) in DEAD_LOADS {
            let found = tip(&plant, &model, Vector3::z() * load, Vector3::zeros());
            record.absolute(&format!("GE, {modes} modes, {load}: x/L"), x, bound, found.x);
            record.absolute(&format!("GE, {modes} modes, {load}: z/L"), z, bound, found.z);
        }
    }
    let model = ReducedModel::new(&aircraft, 8).unwrap();
    let exact = plant(&model, Fidelity::Exact);
    for (load, [_, z]) in DEAD_LOADS {
        let found = tip(&exact, &model, Vector3::z() * load, Vector3::zeros());
        let case = format!("E, 8 modes, EA = 10⁶ EI/L², {load}: z/L of {z:.3}");
        record.at_most(&case, 0.2 * z, found.z);
    }
    record.finish();
}

#[test]
fn a_moment_at_its_tip_makes_a_cantilever_an_arc() {
    let mut record = Record::new(
        "half-circle",
        "The same cantilever under a moment at its tip that follows the section: x/L and z/L of the tip over ML/EI",
        "a circle: x/L = sin μ/μ, z/L = (1 − cos μ)/μ with μ = ML/EI",
    );
    let aircraft = cantilever(40);
    let natural = ReducedModel::new(&aircraft, 16).unwrap();
    let with_strains = with_strains_of_tip_loads(&aircraft, 8);
    for (basis, model, bound) in
        [("8 modes and strains of tip force and moment", &with_strains, 1e-5), ("16 modes", &natural, 2e-3)]
    {
        let plant = plant(model, Fidelity::GeometricallyExact);
        let arc = |turn: f64| tip(&plant, model, Vector3::zeros(), Vector3::y() * -turn);
        let (quarter, half) = (arc(PI / 2.0), arc(PI));
        record.absolute(&format!("GE, {basis}, π/2: x/L"), 2.0 / PI, bound, quarter.x);
        record.absolute(&format!("GE, {basis}, π/2: z/L"), 2.0 / PI, bound, quarter.z);
        record.error(&format!("GE, {basis}, π: x/L"), bound, half.x);
        record.absolute(&format!("GE, {basis}, π: z/L"), 2.0 / PI, bound, half.z);
    }
    record.finish();
}

/// An eighth of a circle of radius 100 in the plane of x and y, of a square section of 1 × 1.
fn bend(elements: usize) -> Aircraft {
    const YOUNG: f64 = 1e7;
    let mut aircraft = cantilever(elements);
    let angle = |node: usize| std::f64::consts::FRAC_PI_4 * node as f64 / elements as f64;
    for (index, node) in aircraft.nodes.iter_mut().enumerate() {
        let (sin, cos) = libm::sincos(angle(index));
        *node = Vector3::new(100.0 * sin, 100.0 * (1.0 - cos), 0.0);
    }
    for beam in &mut aircraft.beams {
        beam.y_axis = Vector3::z();
        (beam.axial_stiffness, beam.torsional_stiffness) = (YOUNG, 0.5 * YOUNG * 0.1406);
        (beam.bending_stiffness_y, beam.bending_stiffness_z) = (YOUNG / 12.0, YOUNG / 12.0);
    }
    for bay in &mut aircraft.bays {
        // A cube of the section's size, as every element is some of.
        (bay.mass, bay.inertia) = (78.54 / elements as f64, Matrix3::identity() * (13.1 / elements as f64));
    }
    aircraft
}

#[test]
fn a_bend_leaves_its_plane_as_computed_and_published() {
    let mut record = Record::new(
        "bend",
        "Bend of 45° (R = 100, E = 10⁷, ν = 0, section 1 × 1) under a dead force normal to its plane: tip, 16 elements, 12 modes",
        "an independent computation with the torsion constant 0.1406; published with 8 cubic elements (J. C. Simo, L. Vu-Quoc, Comput. \
         Methods Appl. Mech. Eng. 58 (1986) 79–116): 58.84, 22.33, 40.08 at 300 and 47.23, 15.79, 53.37 at 600, which a torsion \
         constant of 1/6 comes closer to",
    );
    let model = ReducedModel::new(&bend(16), 12).unwrap();
    let plant = plant(&model, Fidelity::GeometricallyExact);
    for (force, expected) in [(300.0, [58.54, 22.12, 40.47]), (600.0, [46.90, 15.57, 53.59])] {
        let found = tip(&plant, &model, Vector3::z() * force, Vector3::zeros());
        for ((axis, expected), found) in ["x", "y", "z"].iter().zip(expected).zip(found.iter()) {
            record.absolute(&format!("GE, {force}: {axis}"), expected, 0.02, *found);
        }
    }
    record.finish();
}
