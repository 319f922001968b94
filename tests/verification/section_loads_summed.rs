//! Section loads are the plain sum of what acts outboard, particle by particle and strip by strip, whatever the motion
//! [theory: section-loads.summation, section-loads.pieces].

use std::path::Path;

use flexible_aircraft::aircraft::{Aircraft, Hinge, Spring};
use flexible_aircraft::equations::{Controls, EquationsOfMotion, Fidelity};
use flexible_aircraft::math::Attitude;
use flexible_aircraft::plant::{Plant, PlantSettings, PointLoad};
use flexible_aircraft::structure::{BeamSection, ModalBasis, ReducedCut, ReducedModel, RigidBody, Structure};
use nalgebra::{DMatrix, DVector, Matrix3xX, Vector3};

use crate::support::plain_loads::Instant;
use crate::support::plain_points::{Fixed, Moving};
use crate::support::plain_sections::moving_point;
use crate::support::{random, soft};

use super::record::Record;
use super::strip_loads::disturbed;

/// Of the lowest modes of an aircraft.
fn shapes(aircraft: &Aircraft, modes: usize) -> DMatrix<f64> {
    ModalBasis::new(&Structure::new(aircraft).unwrap(), modes).unwrap().shapes
}

/// Force and moment about O.
type Load = [Vector3<f64>; 2];

fn read(name: &str) -> Aircraft {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft").join(name);
    Aircraft::read(&path).unwrap()
}

/// The motion of the body axes, and gravity.
struct Body {
    omega: Vector3<f64>,
    omega_dot: Vector3<f64>,
    /// v̇ + ω×v − g.
    at_origin: Vector3<f64>,
}

impl Body {
    fn new(equations: &EquationsOfMotion, gravity: f64, state: &[f64], rates: &[f64]) -> Self {
        let layout = equations.layout();
        let motion = equations.motion(state);
        let attitude = Attitude::from_quaternion(&state[layout.attitude()]).body_from_inertial;
        let v_dot = Vector3::from_column_slice(&rates[layout.velocity()]);
        Body {
            omega: motion.rate,
            omega_dot: Vector3::from_column_slice(&rates[layout.rate()]),
            at_origin: v_dot + motion.rate.cross(&motion.velocity) - attitude * Vector3::z() * gravity,
        }
    }

    /// m(g − a) of a point that is somewhere, moves and is accelerated in the body axes, at that place.
    fn on(&self, mass: f64, [place, velocity, acceleration]: [Vector3<f64>; 3]) -> Load {
        let omega = &self.omega;
        let force = -(self.at_origin
            + self.omega_dot.cross(&place)
            + omega.cross(&omega.cross(&place))
            + omega.cross(&velocity) * 2.0
            + acceleration)
            * mass;
        [force, place.cross(&force)]
    }
}

fn add([force, moment]: &mut Load, [more, about_origin]: Load) {
    *force += more;
    *moment += about_origin;
}

/// All particles whose attachment is outboard, displaced by their own shapes.
fn particles(
    (aircraft, shapes): (&Aircraft, &DMatrix<f64>),
    motion: [&[f64]; 3],
    body: &Body,
    outboard: &[usize],
) -> Load {
    let structure = Structure::new(aircraft).unwrap();
    let mut load = [Vector3::zeros(); 2];
    for particle in structure.particles.iter().filter(|particle| outboard.contains(&particle.attachment.beam))
    {
        let geometry = &structure.geometry[particle.attachment.beam];
        let map = particle.displacement(geometry);
        let rows = structure.apply_map(particle.attachment.beam, &map, shapes);
        let rows = Matrix3xX::from_row_slice(&rows);
        let [displacement, velocity, acceleration] = motion.map(|numbers| {
            Vector3::from_column_slice((&rows * DVector::from_column_slice(numbers)).as_slice())
        });
        let place = geometry.position(particle.attachment.fraction) + particle.offset + displacement;
        add(&mut load, body.on(particle.mass, [place, velocity, acceleration]));
    }
    load
}

/// All rigid bodies on the sections of a wing beyond a cut, by finite kinematics.
fn bodies(model: &ReducedModel, [q, q_dot, q_ddot]: [&[f64]; 3], body: &Body, cut: &ReducedCut) -> Load {
    // The tail is behind.
    let is_beyond = |at: &BeamSection| {
        let away = at.position - cut.position;
        away.dot(&cut.along) > 1e-9 && away.cross(&cut.along).norm() < 1.0
    };
    let mut load = [Vector3::zeros(); 2];
    for (section, at) in model.sections.iter().enumerate().filter(|(_, at)| is_beyond(at)) {
        let RigidBody { mass, offset, inertia } = at.body;
        let now = moving_point(&model.sections, [q, q_dot], section, &offset);
        let by_rates = moving_point(&model.sections, [q, q_ddot], section, &offset);
        let acceleration = now.acceleration + by_rates.velocity;
        add(&mut load, body.on(mass, [now.place, now.velocity, acceleration]));
        let inertia = now.turn * inertia * now.turn.transpose();
        let spin = body.omega + now.spin;
        let spin_rate =
            body.omega_dot + now.angular_acceleration + by_rates.spin + body.omega.cross(&now.spin);
        load[1] -= inertia * spin_rate + spin.cross(&(inertia * spin));
    }
    load
}

/// The point loads on stations that are outboard of a cut: forces keep their direction on earth, moments turn with the section.
fn on_stations(
    model: &ReducedModel,
    (equations, moving): (&EquationsOfMotion, Moving),
    state: &[f64],
    loads: &[PointLoad],
    cut: &ReducedCut,
) -> Load {
    let to_body = Attitude::from_quaternion(&state[equations.layout().attitude()]).body_from_inertial;
    let mut sum = [Vector3::zeros(); 2];
    for load in loads {
        let number = model.stations.iter().position(|station| station.name == load.station).unwrap();
        if cut.outboard.stations.contains(&number) {
            let at = Fixed::from(&model.stations[number]).point(moving, equations, state);
            let force = to_body * load.force;
            add(&mut sum, [force, at.place.cross(&force) + at.turn * load.moment]);
        }
    }
    sum
}

/// How far the loads at a cut through a right wing are from the plain sum in a state, over the largest of each kind.
fn difference(
    (aircraft, model, shapes): (&Aircraft, &ReducedModel, &DMatrix<f64>),
    cut: &str,
    plant: &Plant,
    fidelity: Fidelity,
    (state, controls): &(Vec<f64>, Controls),
    point_loads: &[PointLoad],
) -> [f64; 2] {
    let plant = plant.clone().under_loads(point_loads).unwrap();
    let equations = plant.equations();
    let number = model.cuts.iter().position(|other| other.name == cut).unwrap();
    let (mut rates, mut workspace) = (vec![0.0; state.len()], plant.workspace());
    plant.rates(state, controls, &mut rates, &mut workspace);
    let found = plant.loads_at(state, controls, &mut workspace)[number];

    let layout = equations.layout();
    let motion =
        [&state[layout.coordinates()], &state[layout.coordinate_rates()], &rates[layout.coordinate_rates()]];
    let body = Body::new(equations, model.gravity, state, &rates);
    let outboard = &aircraft.cuts[number].outboard;
    let mut expected = match fidelity {
        Fidelity::GeometricallyExact => bodies(model, motion, &body, &model.cuts[number]),
        _ => particles((aircraft, shapes), motion, &body, outboard),
    };
    let moving = Moving::at(model, fidelity);
    let instant = Instant { equations, moving, controls, state, rates: &rates, gust: None };
    let strips = model.strips.iter().zip(&aircraft.strips);
    for (strip, _) in strips.filter(|(_, strip)| outboard.contains(&strip.attachment.beam)) {
        let load = instant.load(strip);
        let place = Fixed::from(strip).point(moving, equations, state).place;
        add(&mut expected, [load.force, place.cross(&load.force) + load.span * load.moment]);
    }
    add(&mut expected, on_stations(model, (equations, moving), state, point_loads, &model.cuts[number]));
    let about_origin = found.moment + found.position.cross(&found.force);
    [
        (found.force - expected[0]).norm() / expected[0].norm(),
        (about_origin - expected[1]).norm() / expected[1].norm(),
    ]
}

#[test]
fn section_loads_are_the_plain_sum_of_all_that_acts_outboard() {
    let mut record = Record::new(
        "section-loads-summed",
        "Force and moment about O at cuts through the right wing in five random states of flight, sections turned by up to 1 rad, \
         the jet's strips cambered, a force and a moment on its wing tips: largest difference to the plain sum, over the sum",
        "strips by `support/plain_loads.rs`; masses as equimomental particles, of the geometrically exact level as rigid \
         bodies by `support/plain_sections.rs`",
    );
    let modes: Vec<usize> = (0..12).collect();
    let aircraft = read("generic-business-jet.toml");
    let mut model = crate::support::jet().select(&modes);
    for (place, strip) in model.strips.iter_mut().enumerate() {
        (strip.zero_lift_offset, strip.zero_lift_moment) = (0.03, -0.05 - 1e-3 * place as f64);
    }
    let point_loads = ["wing_tip_right", "wing_tip_left"].map(|tip| PointLoad {
        station: tip.to_owned(),
        force: Vector3::new(-2e4, 3e4, 5e4),
        moment: Vector3::new(1e4, -2e5, 4e4),
    });
    let shapes = shapes(&aircraft, ReducedModel::USUAL_MODES).select_columns(&modes);
    with_wings_that_swing(&mut record, "jet, ", (&aircraft, &model, &shapes), &point_loads);
    // A clamped wing that swings in still air blown at by a wind.
    let aircraft = read("very-flexible-wing.toml");
    let wing = ReducedModel::new(&aircraft, 8).unwrap();
    let shapes = self::shapes(&aircraft, 8);
    for fidelity in [Fidelity::Exact, Fidelity::GeometricallyExact] {
        let settings =
            PlantSettings { fidelity, airspeed: 0.0, inflow_states: 0, ..PlantSettings::of(&wing) };
        let plant = Plant::under(&wing, &settings).unwrap();
        let layout = plant.layout();
        let (mut state, mut next) = (vec![0.0; layout.len()], random(3));
        state[layout.attitude()][0] = 1.0;
        for place in layout.coordinates() {
            state[place] = 0.02 * next();
        }
        for place in layout.coordinate_rates() {
            state[place] = 0.5 * next();
        }
        let mut controls = plant.neutral_controls();
        controls.wind = Vector3::new(-50.0, 1.0, -3.0);
        let found =
            difference((&aircraft, &wing, &shapes), "root", &plant, fidelity, &(state, controls), &[]);
        record.rounding(&format!("very flexible wing, {fidelity:?}, root: force"), 1e-13, found[0]);
        record.rounding(&format!("very flexible wing, {fidelity:?}, root: moment"), 1e-13, found[1]);
    }
    record.finish();
}

/// The greatest differences of five disturbed states, at each level that bends.
fn with_wings_that_swing(
    record: &mut Record,
    name: &str,
    (aircraft, model, shapes): (&Aircraft, &ReducedModel, &DMatrix<f64>),
    point_loads: &[PointLoad],
) {
    for fidelity in Fidelity::ALL.into_iter().filter(|fidelity| *fidelity != Fidelity::Rigid) {
        let plant = Plant::new(model, &soft(fidelity)).unwrap();
        for cut in ["wing_root_right", "wing_mid_right"] {
            let mut largest = [0.0_f64; 2];
            for seed in 0..5 {
                let disturbed = disturbed(plant.equations(), seed);
                let found =
                    difference((aircraft, model, shapes), cut, &plant, fidelity, &disturbed, point_loads);
                largest = [0, 1].map(|i| largest[i].max(found[i]));
            }
            record.rounding(&format!("{name}{fidelity:?}, {cut}: force"), 1e-13, largest[0]);
            record.rounding(&format!("{name}{fidelity:?}, {cut}: moment"), 1e-13, largest[1]);
        }
    }
}

#[test]
fn section_loads_at_hinged_roots_are_the_plain_sum_too() {
    let mut record = Record::new(
        "section-loads-hinged",
        "The same, the jet's wings on springs about three axes at their roots, softer than the wings, twelve modes",
        "as above",
    );
    let mut aircraft = read("generic-business-jet.toml");
    for component in ["wing_right", "wing_left"] {
        let root = aircraft.beams.iter_mut().find(|beam| beam.component == component).unwrap();
        let springs = [(Vector3::x(), 2e7), (Vector3::y(), 1e7), (Vector3::z(), 8e7)];
        let springs = springs.map(|(axis, stiffness)| Spring { axis, stiffness });
        root.hinge = Some(Hinge { springs: springs.to_vec() });
    }
    let model = ReducedModel::new(&aircraft, 12).unwrap();
    let shapes = shapes(&aircraft, 12);
    // The springs turn the roots by much of what the wings do.
    let root = aircraft.beams.iter().position(|beam| beam.component == "wing_right").unwrap();
    let structure = Structure::new(&aircraft).unwrap();
    let angles = structure.geometry[root]
        .springs()
        .iter()
        .map(|(angle, _)| structure.apply_row(root, angle, &shapes).amax());
    assert!(angles.fold(0.0, f64::max) > 1e-3);
    with_wings_that_swing(&mut record, "", (&aircraft, &model, &shapes), &[]);
    record.finish();
}

#[test]
fn a_cut_where_no_section_stands_is_where_one_would_be() {
    // Elements carry their masses and strips in the middle, so that no section stands at the nodes between.
    let mut aircraft = read("very-flexible-wing.toml");
    aircraft.stations.clear();
    aircraft.cuts = aircraft.cuts_along("wing").unwrap();
    let nodes = aircraft.cuts.len();
    let without = ReducedModel::new(&aircraft, 8).unwrap();
    // One station near the middle at a node: a section stands there, and little else changes.
    let middle = nodes / 2;
    aircraft.stations.push(flexible_aircraft::aircraft::Station {
        name: "middle".to_owned(),
        attachment: aircraft.cuts[middle].attachment,
        twist_axis: Vector3::y(),
    });
    let with = ReducedModel::new(&aircraft, 8).unwrap();
    assert_eq!(with.sections.len(), without.sections.len() + 1);
    let settings = PlantSettings {
        fidelity: Fidelity::GeometricallyExact,
        inflow_states: 0,
        ..PlantSettings::of(&with)
    };
    let [station, loads] = [&with, &without].map(|model| {
        let plant = Plant::under(model, &settings).unwrap();
        let trim = plant.trim(&settings.trim_condition()).unwrap();
        let outputs = plant.outputs_at(&trim.state, &trim.controls, &mut plant.workspace());
        let loads = plant.loads_at(&trim.state, &trim.controls, &mut plant.workspace());
        let station = outputs.deflections.first().map(|deflection| deflection.displacement);
        (station.unwrap_or_default() + model.cuts[middle].position, loads)
    });
    let (expected, deflected) = (station.0, (station.0 - with.cuts[middle].position).norm());
    assert!(deflected > 0.05, "{deflected} m");
    assert!((station.1[middle].position - expected).norm() < 1e-12);
    let found = loads.1[middle].position;
    assert!((found - expected).norm() < 1e-4 * deflected, "{found} {expected}");
}
