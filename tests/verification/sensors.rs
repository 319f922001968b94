//! Sensors at the stations read what a real one fixed to the moving, deformed section would: the second derivative
//! of its path less gravity, and the spin of its axes, both found here by differentiating the flight's history.

use flexible_aircraft::aircraft::Fidelity;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::{Outputs, PlantSettings};
use flexible_aircraft::structure::ModeShapes;
use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::support::plain_sections::moving_point;
use crate::support::{AILERON, ELEVATOR, RUDDER, jet, station};

use super::record::Record;

/// With rotation vectors of modes, and with finite rotations along the beams.
const LEVELS: [Fidelity; 2] = [Fidelity::Exact, Fidelity::GeometricallyExact];

/// Between the samples, s: the modes of up to 55 rad/s turn by 0.1 rad.
const STEP: f64 = 2e-3;

/// A section's place, north-east-down, m, and the rotation that turns its components into north-east-down ones.
struct Sample {
    place: Vector3<f64>,
    axes: Matrix3<f64>,
}

impl Sample {
    fn new(outputs: &Outputs, index: usize, fidelity: Fidelity) -> Self {
        let model = jet();
        let station = &model.stations[index];
        let turn = match fidelity {
            Fidelity::GeometricallyExact => {
                let motion = [outputs.modal_q.as_slice(), &vec![0.0; outputs.modal_q.len()]];
                moving_point(&model.sections, motion, station.carrier.section, &Vector3::zeros()).turn
            }
            _ => Rotation3::new(rotation(&station.shapes, &outputs.modal_q)).into_inner(),
        };
        let attitude = outputs.attitude;
        let to_inertial = Rotation3::from_euler_angles(attitude.x, attitude.y, attitude.z);
        Sample {
            place: outputs.position
                + to_inertial * (station.position + outputs.deflections[index].displacement),
            axes: to_inertial * turn,
        }
    }
}

/// Ψᵠ q.
fn rotation(shapes: &ModeShapes, q: &[f64]) -> Vector3<f64> {
    Vector3::from_fn(|axis, _| {
        let row = &shapes.rotation[axis * q.len()..(axis + 1) * q.len()];
        row.iter().zip(q).map(|(shape, q)| shape * q).sum()
    })
}

/// Flies a manoeuvre about all axes at a tenth of the stiffness, so that wing tips move by metres; returns the
/// outputs at five neighbouring instants.
fn five_instants(fidelity: Fidelity) -> Vec<Outputs> {
    let settings = Settings {
        tolerance: 1e-11,
        ..PlantSettings { fidelity, stiffness_scale: 0.1, ..PlantSettings::of(&jet()) }.into()
    };
    let mut flight = Simulation::new(jet(), &settings, 0.0).unwrap();
    let mut inputs = Inputs::zero(&jet());
    (inputs.controls[ELEVATOR], inputs.controls[AILERON], inputs.controls[RUDDER]) = (-0.05, 0.03, 0.02);
    inputs.wind = Vector3::new(2.0, 5.0, -3.0);
    flight.set_inputs(&inputs, &Inputs::zero(&jet()));
    let instants = (-2..=2).map(|instant| {
        flight.advance_to(1.2 + f64::from(instant) * STEP).unwrap();
        flight.outputs().clone()
    });
    instants.collect()
}

#[test]
fn accelerometers_and_gyros_on_deformed_sections_read_what_their_paths_say() {
    let mut record = Record::new(
        "sensors",
        "Jet at a tenth of its stiffness in a turn: readings at stations against differentiated paths",
        "five-point differences of the history, each over 8 ms; as a share of the largest component",
    );
    let stations = ["wing_tip_right", "wing_tip_left", "htail_tip_left", "vtail_tip"];
    for (name, fidelity) in stations.into_iter().flat_map(|name| LEVELS.map(|level| (name, level))) {
        let (outputs, index) = (five_instants(fidelity), station(name));
        let samples: Vec<Sample> =
            outputs.iter().map(|outputs| Sample::new(outputs, index, fidelity)).collect();
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|i: usize| samples[i].place);
        let acceleration = ((b + d) * 16.0 - (a + e) - c * 30.0) / (12.0 * STEP * STEP);
        let to_section = samples[2].axes.transpose();
        let specific_force = to_section * (acceleration - Vector3::z() * jet().gravity);

        let [a, b, d, e] = [0, 1, 3, 4].map(|i: usize| samples[i].axes);
        let spin = to_section * ((d - b) * 8.0 - (e - a)) / (12.0 * STEP);
        let rate = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);

        let sensors = outputs[2].sensors[index];
        let share = |error: Vector3<f64>, of: Vector3<f64>| error.amax() / of.amax();
        let deviation = share(sensors.specific_force - specific_force, specific_force);
        record.error(&format!("{name}, {fidelity:?}: specific force"), 1e-4, deviation);
        record.error(&format!("{name}, {fidelity:?}: rate"), 3e-7, share(sensors.rate - rate, rate));
        record.at_least(&format!("{name}, {fidelity:?}: largest rate, rad/s"), 0.01, sensors.rate.amax());
    }
    record.finish();
}

#[test]
fn in_level_flight_accelerometers_feel_the_weight_turned_into_their_section() {
    let mut flight = Simulation::new(jet(), &Settings::of(&jet()), 0.0).unwrap();
    let outputs = flight.outputs();
    for sensors in &outputs.sensors {
        assert!((sensors.specific_force.norm() - jet().gravity).abs() < 1e-6, "{sensors:?}");
        assert!(sensors.specific_force.z < -0.9 * jet().gravity, "{sensors:?}");
        assert_eq!(sensors.rate, Vector3::zeros());
    }
    let lean = |name: &str| outputs.sensors[station(name)].specific_force.y;
    assert!(lean("wing_tip_right") > 0.0 && lean("wing_tip_left") < 0.0, "the tips are bent up");
}
