//! Whether files move as the library says: joints by modes and by stations, the skin with its joints, targets to first order.

mod reading;

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::Fidelity;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::{Plant, PlantSettings};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::VariableTable;
use nalgebra::{Isometry3, Quaternion, UnitQuaternion, Vector3};

use self::reading::{File, number, vector};
use super::super::View;
use super::super::flap::Flap;
use super::super::outline::Outline;
use super::super::recording::{POSE, Recording};
use super::super::show::{Kind, Show};
use super::joints::is_in_a_body;
use super::{axes, morph, skeleton};

const MODES: usize = 8;

/// With eight flaps, each with a control of its own.
const ODD: &str = "tests/data/eight-flaps.toml";
const JET: &str = "aircraft/generic-business-jet.toml";

/// An aircraft at a moment, as it is recorded.
struct Moment {
    view: View,
    show: Show,
    /// As the FMU has them.
    coordinates: Vec<f64>,
    controls: Vec<f64>,
}

/// An aircraft that is bent at will, so that something moves by about a part of its size, with its controls turned.
fn moment(file: &str, fidelity: Fidelity, bent: f64) -> Moment {
    let mut aircraft = Aircraft::read(format!("{}/../{file}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    for component in aircraft.components.clone() {
        aircraft.add_stations_along(&component.name, 8).unwrap();
    }
    let settings = |_: &VariableTable, model: &ReducedModel| {
        Ok(Settings::from(PlantSettings { fidelity, mode_count: MODES, ..PlantSettings::of(model) }))
    };
    let view = View::new(&aircraft, MODES.into(), settings).unwrap();
    let View { airframe, model, settings, .. } = &view;
    let plant = Plant::under(model, &settings.plant).unwrap();
    let trim = plant.trim(&settings.plant.trim_condition()).unwrap();
    let (mut state, mut controls) = (trim.state.clone(), trim.controls.clone());
    let places = plant.layout().coordinates();
    for (mode, place) in places.enumerate() {
        let largest = model.stations.iter().map(|at| at.shapes.of_mode(mode)[0].norm()).fold(0.0, f64::max);
        // As irregular as any numbers.
        state[place] = bent * airframe.size() / largest * (1.3 + 2.1 * mode as f64).sin();
    }
    controls.angles.iter_mut().enumerate().for_each(|(control, angle)| *angle += 0.1 + 0.02 * control as f64);
    let outputs = plant.outputs_at(&state, &controls, &mut plant.workspace());
    let mut recording = Recording::default();
    recording.take(airframe, &outputs, &[]);
    let show = Show {
        kind: Kind::Flight,
        name: "moment".to_owned(),
        level: fidelity.name(),
        facts: Vec::new(),
        start: 0.0,
        step: 0.1,
        loops: false,
        recording,
        charted: Vec::new(),
        gust: None,
        ghost: None,
    };
    Moment { view, show, coordinates: outputs.modal_q, controls: outputs.controls }
}

impl Moment {
    /// Of a section, body axes.
    fn pose(&self, section: usize) -> Isometry3<f64> {
        let pose = &self.show.recording.poses[POSE * section..][..POSE];
        isometry(pose)
    }

    /// As a skeleton.
    fn file(&self) -> File {
        File::read(&skeleton(&self.view, std::slice::from_ref(&self.show), true))
    }

    /// Corners of all strips where they are, from where O is, earth axes: the leading edge and, turned with its flap, the trailing one.
    fn corners(&self) -> Vec<Vector3<f64>> {
        let aircraft = &self.view.airframe.aircraft;
        let body = isometry(&self.show.recording.body).rotation;
        let mut corners = Vec::new();
        for (number, outline) in Outline::of_all(aircraft).iter().enumerate() {
            if is_in_a_body(aircraft, &aircraft.strips[number]) {
                continue;
            }
            let section = self.pose(self.view.airframe.strips[number]);
            let [leading, trailing] = [0.0, 1.0].map(|fraction| seam(outline.along_chord(fraction)));
            let flap = Flap::of(aircraft, number, outline);
            let turned = trailing.map(|corner| match &flap {
                Some(flap) => {
                    let angle = flap.angle(&self.controls);
                    let turn = UnitQuaternion::from_scaled_axis(flap.axis * angle);
                    flap.hinge[0] + turn * (corner - flap.hinge[0])
                }
                None => corner,
            });
            let place = |corner: Vector3<f64>| body * (section * nalgebra::Point3::from(corner)).coords;
            corners.extend(leading.into_iter().chain(turned).map(place));
        }
        corners
    }
}

/// Both ends where a seam is left free between strips.
fn seam([inboard, outboard]: [Vector3<f64>; 2]) -> [Vector3<f64>; 2] {
    let free = (outboard - inboard) * 0.008;
    [inboard + free, outboard - free]
}

fn isometry(pose: &[f64]) -> Isometry3<f64> {
    let turn = UnitQuaternion::from_quaternion(Quaternion::new(pose[3], pose[4], pose[5], pose[6]));
    Isometry3::from_parts(Vector3::from_column_slice(&pose[..3]).into(), turn)
}

/// A pose in the axes of the file.
fn in_file(pose: &Isometry3<f64>) -> Isometry3<f64> {
    let [x, y, z, w] = axes::quaternion(&pose.rotation).map(f64::from);
    let turn = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
    Isometry3::from_parts(axes::turned(&pose.translation.vector).into(), turn)
}

/// How far two poses are apart, m and rad.
fn apart(one: &Isometry3<f64>, other: &Isometry3<f64>) -> [f64; 2] {
    let moved = one.translation.vector - other.translation.vector;
    [moved.norm(), one.rotation.angle_to(&other.rotation)]
}

/// The nodes of the sections.
fn section_nodes(file: &File, moment: &Moment) -> Vec<usize> {
    let joints = file.list("skins")[0]["joints"].as_array().unwrap();
    joints[..moment.view.airframe.sections.len()].iter().map(number).collect()
}

#[test]
fn joints_that_modes_drive_are_where_the_library_says_at_linear_levels() {
    for (path, fidelity, bent) in [
        (JET, Fidelity::Exact, 0.02),
        (JET, Fidelity::RuthlesslyLinearised, 0.02),
        (ODD, Fidelity::ConsistentlyLinearised, 0.02),
        (ODD, Fidelity::Inconsistent, 0.001),
    ] {
        let moment = moment(path, fidelity, bent);
        let file = moment.file();
        let locals = file.locals(0, 0);
        let mut most = [0.0_f64; 2];
        for (section, node) in section_nodes(&file, &moment).into_iter().enumerate() {
            let node = &file.list("nodes")[node];
            let sum = |what: &str| -> Vector3<f64> {
                let modes = node["extras"]["modes"][what].as_array().unwrap();
                assert_eq!(modes.len(), moment.coordinates.len());
                modes.iter().zip(&moment.coordinates).map(|(mode, q)| vector(mode) * *q).sum()
            };
            let place = vector(&node["translation"]) + sum("displacement");
            let driven =
                Isometry3::from_parts(place.into(), UnitQuaternion::from_scaled_axis(sum("rotation")));
            let animated = &locals[section_nodes(&file, &moment)[section]];
            let recorded = in_file(&moment.pose(section));
            for other in [&recorded, animated] {
                let apart = apart(&driven, other);
                most = [most[0].max(apart[0]), most[1].max(apart[1])];
            }
        }
        assert!(most[0] < 1e-5 && most[1] < 3e-7, "{path} {} {most:?}", fidelity.name());
    }
}

#[test]
fn the_skin_is_where_the_outlines_of_the_strips_are() {
    for (path, fidelity) in [(JET, Fidelity::GeometricallyExact), (ODD, Fidelity::Exact)] {
        let moment = moment(path, fidelity, 0.02);
        let file = moment.file();
        let skin = file.skinned(&file.worlds(&file.locals(0, 0)));
        let mut farthest = 0.0_f64;
        for corner in moment.corners() {
            let corner = axes::turned(&corner);
            let nearest = skin.iter().map(|place| (place - corner).norm()).fold(f64::INFINITY, f64::min);
            farthest = farthest.max(nearest);
        }
        assert!(farthest < 1e-5, "{path} {farthest}");
    }
}

#[test]
fn joints_that_stations_lead_are_where_the_library_says_when_the_aircraft_bends_much() {
    let moment = moment(JET, Fidelity::GeometricallyExact, 0.03);
    let file = moment.file();
    let airframe = &moment.view.airframe;
    let (mut most, mut farthest) = ([0.0_f64; 2], 0.0_f64);
    for (section, node) in section_nodes(&file, &moment).into_iter().enumerate() {
        let node = &file.list("nodes")[node];
        let leaders = node["extras"]["stations"].as_array().unwrap();
        let share = |leader: &serde_json::Value| leader["share"].as_f64().unwrap();
        let rest = 1.0 - leaders.iter().map(share).sum::<f64>();
        let mut place = vector(&node["translation"]) * rest;
        let mut turn = Quaternion::identity() * rest;
        for leader in leaders {
            let station = airframe
                .aircraft
                .stations
                .iter()
                .position(|one| leader["name"] == one.name.as_str())
                .unwrap();
            let pose = in_file(&moment.pose(airframe.stations[station]));
            let led = pose * nalgebra::Point3::from(vector(&leader["offset"]));
            place += led.coords * share(leader);
            turn += pose.rotation.into_inner() * share(leader);
        }
        let led = Isometry3::from_parts(place.into(), UnitQuaternion::from_quaternion(turn));
        let recorded = in_file(&moment.pose(section));
        farthest = farthest.max((recorded.translation.vector - vector(&node["translation"])).norm());
        let apart = apart(&led, &recorded);
        most = [most[0].max(apart[0]), most[1].max(apart[1])];
    }
    assert!(farthest > 1.0, "nothing bends: {farthest}");
    assert!(most[0] < 0.08 && most[1] < 0.07, "{most:?}");
}

#[test]
fn surfaces_are_closed_and_look_outwards() {
    for path in [JET, ODD, "aircraft/goland-wing.toml"] {
        let moment = moment(path, Fidelity::Rigid, 0.0);
        let file = moment.file();
        for primitive in file.primitives() {
            let places = file.vectors(&primitive["attributes"]["POSITION"]);
            let normals = file.vectors(&primitive["attributes"]["NORMAL"]);
            let joints = file.rows(&primitive["attributes"]["JOINTS_0"]);
            let indices = file.rows(&primitive["indices"]);
            let mut volumes = vec![0.0; file.list("nodes").len()];
            for triangle in indices.chunks(3) {
                let [a, b, c] = [0, 1, 2].map(|corner| triangle[corner][0] as usize);
                let front = (places[b] - places[a]).cross(&(places[c] - places[a]));
                assert!(front.dot(&normals[a]) >= 0.0, "{path}");
                volumes[joints[a][0] as usize] += places[a].dot(&places[b].cross(&places[c])) / 6.0;
            }
            let material = &file.list("materials")[number(&primitive["material"])]["name"];
            // Bodies are closed over many joints, inlets are faces alone.
            match material.as_str().unwrap() {
                "skin" | "flap" => assert!(volumes.iter().all(|volume| *volume > -1e-9), "{path} {material}"),
                "body" => assert!(volumes.iter().sum::<f64>() > 0.0, "{path}"),
                _ => {}
            }
            let open: Vector3<f64> = indices
                .chunks(3)
                .map(|triangle| {
                    let [a, b, c] = [0, 1, 2].map(|corner| places[triangle[corner][0] as usize]);
                    (b - a).cross(&(c - a))
                })
                .sum();
            if material != "engine" && material != "inlet" {
                assert!(open.norm() < 1e-4, "{path} {material} {open:?}");
            }
        }
    }
}

/// Right is −x, up is +y, forward is +z.
#[test]
fn the_right_wing_is_on_the_right_of_somebody_who_looks_forward() {
    let moment = moment(JET, Fidelity::Exact, 0.0);
    let file = moment.file();
    let place = |name: &str| vector(&file.list("nodes")[file.node(name)]["translation"]);
    assert!(place("wing_tip_right").x < -10.0 && place("wing_tip_left").x > 10.0);
    let forward = place("vtail_tip");
    assert!(forward.z < -1.0 && forward.y > 1.0, "{forward:?}");
}

#[test]
fn targets_move_vertices_as_joints_do_to_first_order() {
    let departure = |bent: f64| {
        let moment = moment(ODD, Fidelity::Exact, bent);
        let file = File::read(&morph(&moment.view));
        let mesh = &file.list("meshes")[0];
        let targets = mesh["extras"]["targets"].as_array().unwrap();
        let controls = &moment.view.airframe.aircraft.controls;
        let small = 10.0 * bent;
        let weight = |target: &serde_json::Value| {
            let output = target["output"].as_str().unwrap();
            let mode = (1..=moment.coordinates.len()).find(|mode| output == format!("modal.q[{mode}]"));
            let control = controls.iter().position(|one| output == format!("surface.{}", one.name));
            let value = match (mode, control) {
                (Some(mode), _) => moment.coordinates[mode - 1],
                (_, Some(control)) => moment.controls[control] * small,
                _ => panic!("{output}"),
            };
            value / target["scale"].as_f64().unwrap()
        };
        let weights: Vec<f64> = targets.iter().map(weight).collect();
        assert_eq!(targets.len(), moment.coordinates.len() + controls.len());
        let mut show = moment.show;
        show.recording.controls.iter_mut().for_each(|angle| *angle *= small);
        show.recording.body = vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
        let skinned = File::read(&skeleton(&moment.view, &[show], true));
        let mut expected = skinned.skinned(&skinned.worlds(&skinned.locals(0, 0))).into_iter();
        let mut farthest = 0.0_f64;
        for primitive in file.primitives() {
            let moved: Vec<Vec<Vector3<f64>>> = primitive["targets"]
                .as_array()
                .unwrap()
                .iter()
                .map(|target| file.vectors(&target["POSITION"]))
                .collect();
            for (vertex, place) in file.vectors(&primitive["attributes"]["POSITION"]).iter().enumerate() {
                let sum: Vector3<f64> = moved.iter().zip(&weights).map(|(moved, w)| moved[vertex] * *w).sum();
                farthest = farthest.max((place + sum - expected.next().unwrap()).norm());
            }
        }
        assert!(expected.next().is_none());
        farthest
    };
    let [large, small] = [0.01, 0.001].map(departure);
    // A hundredth of it, but for rounding.
    assert!(large > 1e-3 && small < 0.02 * large, "{large} {small}");
}
