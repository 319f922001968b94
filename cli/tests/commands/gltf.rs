//! `flexair view --gltf` and `--gltf-morph`.

use std::collections::HashMap;
use std::path::Path;

use gltf::Glb;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde_json::Value;

use crate::support::{names, run, text};

const FLIGHT: &str = "--input elevator=2311:-0.05@0.1:0.1 --duration 0.5 --modes 6";

fn json(path: &Path) -> Value {
    let bytes = std::fs::read(path).unwrap();
    serde_json::from_slice(&Glb::from_slice(&bytes).unwrap().json).unwrap()
}

fn nodes(file: &Value) -> &[Value] {
    file["nodes"].as_array().unwrap()
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from([0, 1, 2].map(|axis| value[axis].as_f64().unwrap()))
}

/// Outputs of a flight at its end, in the axes of the file.
struct Outputs(HashMap<String, f64>);

impl Outputs {
    fn of(folder: &Path, flight: &str) -> Self {
        let found = run(folder, &format!("simulate {flight} --step 0.05 -o flight.csv"));
        assert!(found.status.success(), "{}", text(&found.stderr));
        let table = std::fs::read_to_string(folder.join("flight.csv")).unwrap();
        let names = table.lines().next().unwrap().split(',').map(str::to_owned);
        let last = table.lines().last().unwrap().split(',').map(|number| number.parse().unwrap());
        Outputs(names.zip(last).collect())
    }

    fn earth(&self, name: &str) -> Vector3<f64> {
        let [north, east, down] = ["north", "east", "down"].map(|part| self.0[&format!("{name}.{part}")]);
        Vector3::new(-east, -down, north)
    }

    fn turn(&self, name: &str) -> UnitQuaternion<f64> {
        let [w, x, y, z] = [1, 2, 3, 4].map(|part| self.0[&format!("{name}[{part}]")]);
        UnitQuaternion::from_quaternion(Quaternion::new(w, -y, -z, x))
    }

    /// Pose of a station, as seen from O.
    fn station(&self, name: &str) -> (Vector3<f64>, UnitQuaternion<f64>) {
        let body = self.turn("attitude.quaternion");
        let place = self.earth(&format!("station.{name}.position")) - self.earth("position");
        (body.inverse() * place, body.inverse() * self.turn(&format!("station.{name}.quaternion")))
    }
}

/// As docs/game-engine.md has it.
#[test]
fn modes_put_joints_where_the_outputs_of_stations_are() {
    let folder = tempfile::tempdir().unwrap();
    let found = run(folder.path(), &format!("view {FLIGHT} --gltf jet.glb -o page.html"));
    assert!(found.status.success(), "{}", text(&found.stderr));
    assert_eq!(text(&found.stdout), "page.html\njet.glb\n");
    let file = json(&folder.path().join("jet.glb"));
    let outputs = Outputs::of(folder.path(), FLIGHT);
    for station in ["wing_tip_right", "wing_tip_left", "htail_tip_left", "vtail_tip"] {
        let joint = nodes(&file).iter().find(|node| node["name"] == station).unwrap();
        let sum = |what: &str| -> Vector3<f64> {
            let modes = joint["extras"]["modes"][what].as_array().unwrap().iter().enumerate();
            modes.map(|(mode, shape)| vector(shape) * outputs.0[&format!("modal.q[{}]", mode + 1)]).sum()
        };
        let (place, turn) = outputs.station(station);
        let driven = vector(&joint["translation"]) + sum("displacement");
        assert!((driven - place).norm() < 1e-4, "{station} {driven:?} {place:?}");
        let turned = UnitQuaternion::from_scaled_axis(sum("rotation"));
        assert!(turned.angle_to(&turn) < 1e-5, "{station} {turned:?} {turn:?}");
    }
    let flap = nodes(&file).iter().find(|node| node["extras"]["controls"].get("elevator").is_some()).unwrap();
    assert!(flap["name"].as_str().unwrap().ends_with("flap") && flap["extras"]["axis"].is_array());
}

#[test]
fn stations_along_components_are_joints_by_their_names_and_lead_the_others_at_any_level() {
    let folder = tempfile::tempdir().unwrap();
    let options = "--stations-along wing_right=4 --set model=geometrically_exact --modes 4 --trim";
    let found = run(folder.path(), &format!("view {options} --gltf jet.glb -o page.html"));
    assert!(found.status.success(), "{}", text(&found.stderr));
    let file = json(&folder.path().join("jet.glb"));
    for station in 1..=4 {
        let name = format!("wing_right_{station:02}");
        let joint = nodes(&file).iter().find(|node| node["name"] == name.as_str()).unwrap();
        assert_eq!(joint["extras"]["stations"][0]["name"], name.as_str());
        assert!(joint["extras"].get("modes").is_none());
    }
    let animations = file["animations"].as_array().unwrap();
    assert_eq!((animations.len(), &animations[0]["name"]), (1, &"trim".into()));
}

#[test]
fn shows_are_animations_and_targets_are_outputs() {
    let folder = tempfile::tempdir().unwrap();
    let options = "view --duration 0.2 --compare exact,rigid --mode-shapes --modes 2 --gltf a.glb --gltf-morph b.glb -o page.html";
    let found = run(folder.path(), options);
    assert!(found.status.success(), "{}", text(&found.stderr));
    assert_eq!(text(&found.stdout), "page.html\na.glb\nb.glb\n");
    let file = json(&folder.path().join("a.glb"));
    let found = file["animations"].as_array().unwrap().iter().map(|one| one["name"].as_str().unwrap());
    let found: Vec<&str> = found.collect();
    assert_eq!(found[..2], ["flight, exact", "flight, rigid"]);
    assert!(found.len() == 4 && found[2].starts_with("1 · "), "{found:?}");
    let targets = &json(&folder.path().join("b.glb"))["meshes"][0]["extras"]["targetNames"];
    assert_eq!(targets[0], "modal.q[1]");
    assert!(targets.as_array().unwrap().contains(&"surface.elevator".into()));
}

#[test]
fn what_cannot_be_written_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    for (options, code, said) in [
        ("--gltf jet.gltf", 2, "allowed is the path of a file that ends in .glb"),
        ("--gltf -", 2, "allowed is the path of a file that ends in .glb"),
        ("--gltf a.glb --gltf-morph ./a.glb", 1, "found ./a.glb twice among the outputs"),
        ("--gltf no/../page.glb -o page.glb", 1, "twice among the outputs"),
        (
            "--gltf a.glb --gltf-morph b.glb --set model=geometrically_exact --modes 2",
            1,
            "--gltf-morph: found the level geometrically_exact, allowed are exact, consistently_linearised",
        ),
        (
            "--gltf a.glb --compare exact,geometrically_exact --gltf-morph b.glb --modes 2",
            1,
            "--gltf-morph: found",
        ),
        (
            "--gltf a.glb --stations-along wing=4",
            1,
            "--stations-along wing: found component \"wing\", allowed are",
        ),
        ("--vtk a.glb --gltf a.glb", 1, "found a.glb twice among the outputs"),
        ("--vtk -", 2, "pictures do not go to standard output"),
        ("--vtk frames --duration 0.1 --input wobble=step:1 --modes 2", 1, "--input wobble=step:1"),
        ("--gltf a.glb --duration 0.1 --input wobble=step:1 --modes 2", 1, "--input wobble=step:1"),
    ] {
        let found = run(folder.path(), &format!("view {options}"));
        let error = text(&found.stderr);
        assert_eq!(found.status.code(), Some(code), "{options}: {error}");
        assert!(error.contains(said), "{options}: {error}");
        assert_eq!(names(folder.path()), Vec::<String>::new(), "{options}");
    }
}
