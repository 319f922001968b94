//! `flexair view`.

use std::io::Read;
use std::path::Path;

use flate2::read::ZlibDecoder;
use serde_json::Value;

use crate::support::{names, run, text, workspace};

/// What a page holds: its scene and its numbers.
struct Page {
    scene: Value,
    data: Vec<u8>,
}

impl Page {
    fn read(path: &Path) -> Self {
        let html = std::fs::read_to_string(path).unwrap();
        let element = |id: &str| {
            let begin = html.find(&format!("id=\"{id}\"")).unwrap();
            let inside = html[begin..].split_once('>').unwrap().1;
            inside.split_once("</script>").unwrap().0.trim().to_owned()
        };
        let mut data = Vec::new();
        ZlibDecoder::new(from_base64(&element("data")).as_slice()).read_to_end(&mut data).unwrap();
        Page { scene: serde_json::from_str(&element("scene")).unwrap(), data }
    }

    fn show(&self, name: &str) -> &Value {
        let shows = self.scene["shows"].as_array().unwrap();
        shows.iter().find(|show| show["name"].as_str().unwrap().starts_with(name)).unwrap()
    }

    /// A row of a matrix as the page computes it.
    fn row(&self, matrix: &Value, row: usize) -> Vec<f64> {
        let number = |name: &str| matrix[name].as_u64().unwrap() as usize;
        let (columns, rank) = (number("columns"), number("rank"));
        let word = |begin: usize, place: usize| {
            f64::from(i16::from_le_bytes(self.data[begin + 2 * place..][..2].try_into().unwrap()))
        };
        let value = |column: usize| {
            let mean = self.data[number("mean") + 4 * column..][..4].try_into().unwrap();
            let term = |term: usize| {
                let scale = |name: &str| matrix[name][term].as_f64().unwrap();
                word(number("coefficients"), row * rank + term)
                    * scale("coefficientScale")
                    * word(number("basis"), term * columns + column)
                    * scale("basisScale")
            };
            f64::from(f32::from_le_bytes(mean)) + (0..rank).map(term).sum::<f64>()
        };
        (0..columns).map(value).collect()
    }

    /// Where a station is, north, east, down, at a frame.
    fn station(&self, show: &Value, name: &str, frame: usize) -> [f64; 3] {
        let stations = self.scene["stations"].as_array().unwrap();
        let station = stations.iter().find(|station| station["name"] == name).unwrap();
        let section = station["section"].as_u64().unwrap() as usize;
        let pose = self.row(&show["poses"], frame);
        let body = self.row(&show["body"], frame);
        let place = turned(&body[3..7], [0, 1, 2].map(|axis| pose[7 * section + axis]));
        [0, 1, 2].map(|axis| body[axis] + place[axis])
    }
}

/// A vector turned by a quaternion.
fn turned(quaternion: &[f64], vector: [f64; 3]) -> [f64; 3] {
    let length = quaternion.iter().map(|part| part * part).sum::<f64>().sqrt();
    let [w, x, y, z] = [0, 1, 2, 3].map(|part| quaternion[part] / length);
    let cross = |[a, b, c]: [f64; 3]| [y * c - z * b, z * a - x * c, x * b - y * a];
    let once = cross(vector);
    let twice = cross(once);
    [0, 1, 2].map(|axis| vector[axis] + 2.0 * (w * once[axis] + twice[axis]))
}

fn from_base64(text: &str) -> Vec<u8> {
    let digit = |letter: u8| match letter {
        b'A'..=b'Z' => u32::from(letter - b'A'),
        b'a'..=b'z' => u32::from(letter - b'a') + 26,
        b'0'..=b'9' => u32::from(letter - b'0') + 52,
        b'+' => 62,
        _ => 63,
    };
    let letters: Vec<u8> = text.bytes().filter(|letter| *letter != b'=').collect();
    let bytes = letters.chunks(4).flat_map(|four| {
        let bits = four.iter().fold(0, |bits, &letter| bits << 6 | digit(letter)) << (6 * (4 - four.len()));
        [bits >> 16, bits >> 8, bits].map(|byte| byte as u8).into_iter().take(four.len() * 6 / 8)
    });
    bytes.collect()
}

#[test]
fn a_page_without_options_has_the_trim_and_the_natural_modes() {
    let folder = tempfile::tempdir().unwrap();
    let found = run(folder.path(), "view --output jet.html --modes 4");
    assert!(found.status.success(), "{}", text(&found.stderr));
    assert_eq!(text(&found.stdout), "jet.html\n");
    let page = Page::read(&folder.path().join("jet.html"));
    assert_eq!(page.scene["shows"].as_array().unwrap().len(), 5);
    let mode = page.show("1 · ");
    assert!(mode["name"].as_str().unwrap().ends_with("Hz · wing bending, first, symmetric"));
    assert_eq!((mode["kind"].as_str(), mode["loops"].as_bool()), (Some("mode"), Some(true)));
    // It begins where it ends, undeformed.
    let last = mode["count"].as_u64().unwrap() as usize - 1;
    assert_eq!(page.row(&mode["poses"], 0), page.row(&mode["poses"], last));
    let tip = page.station(page.show("trim"), "wing_tip_right", 0)[2];
    assert!(tip < page.station(mode, "wing_tip_right", 0)[2] - 7000.0);
}

/// At the stored frames, to a millimetre.
#[test]
fn stations_are_where_the_outputs_of_the_flight_say_at_every_level() {
    let folder = tempfile::tempdir().unwrap();
    for level in ["exact", "geometrically_exact", "rigid"] {
        let flight =
            format!("--input elevator=2311:-0.05@0.1:0.1 --duration 1 --modes 6 --set model={level}");
        let found = run(folder.path(), &format!("view {flight} --rate 20 -o page.html"));
        assert!(found.status.success(), "{}", text(&found.stderr));
        let found = run(folder.path(), &format!("simulate {flight} --step 0.05 -o flight.csv"));
        assert!(found.status.success(), "{}", text(&found.stderr));
        let table = std::fs::read_to_string(folder.path().join("flight.csv")).unwrap();
        let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
        let page = Page::read(&folder.path().join("page.html"));
        let show = page.show("flight");
        assert_eq!(show["count"], 21);
        for (frame, time) in [(0, 0.0), (8, 0.4), (20, 1.0)] {
            // Edges of pulses have rows of their own.
            let row =
                rows[1..].iter().find(|row| (row[0].parse::<f64>().unwrap() - time).abs() < 1e-6).unwrap();
            let number = |name: &str| -> f64 {
                row[rows[0].iter().position(|other| *other == name).unwrap()].parse().unwrap()
            };
            for station in ["wing_tip_right", "vtail_tip"] {
                let place = page.station(show, station, frame);
                for (axis, name) in ["north", "east", "down"].iter().enumerate() {
                    let expected = number(&format!("station.{station}.position.{name}"));
                    assert!(
                        (place[axis] - expected).abs() < 1e-3,
                        "{level} {station} {name} {place:?} {expected}"
                    );
                }
            }
            let elevator = page.row(&show["controls"], frame)[0];
            assert!((elevator - number("surface.elevator")).abs() < 2e-5);
        }
    }
}

#[test]
fn two_levels_are_ghosts_of_each_other_and_share_their_colours() {
    let folder = tempfile::tempdir().unwrap();
    let options = "view --compare exact,rigid --duration 0.5 --modes 4 --set gust.shape=one_minus_cosine --set gust.start=0 -o two.html";
    let found = run(folder.path(), options);
    assert!(found.status.success(), "{}", text(&found.stderr));
    let page = Page::read(&folder.path().join("two.html"));
    let [exact, rigid] = ["flight, exact", "flight, rigid"].map(|name| page.show(name));
    assert_eq!((&exact["ghost"], &rigid["ghost"]), (&rigid["name"], &exact["name"]));
    let lift = |show: &Value| {
        let colours = show["colours"].as_array().unwrap();
        colours.iter().find(|colour| colour["name"] == "lift").unwrap().clone()
    };
    assert_eq!((&lift(exact)["min"], &lift(exact)["max"]), (&lift(rigid)["min"], &lift(rigid)["max"]));
    assert_eq!(lift(exact)["on"], "strips");
    assert!(exact["colours"].as_array().unwrap().iter().any(|colour| colour["name"] == "bending"));
    let gust = &exact["gust"];
    assert!((gust["end"].as_f64().unwrap() - gust["start"].as_f64().unwrap() - 60.0).abs() < 1e-6);
    assert!((gust["direction"][2].as_f64().unwrap() + 1.0).abs() < 1e-9);
    assert_eq!(gust["profile"][16], 10.0);
}

#[test]
fn modes_in_flight_are_shown_by_name_and_by_number() {
    let folder = tempfile::tempdir().unwrap();
    let found =
        run(folder.path(), "view --root PHUGOID --root 2 --modes 4 --set inflow_states=2 -o roots.html");
    assert!(found.status.success(), "{}", text(&found.stderr));
    let page = Page::read(&folder.path().join("roots.html"));
    let phugoid = page.show("phugoid");
    assert_eq!((phugoid["kind"].as_str(), phugoid["count"].as_u64()), (Some("root"), Some(97)));
    let found = run(folder.path(), "view --root wobble --modes 4 --set inflow_states=2 -o none.html");
    assert_eq!(found.status.code(), Some(1));
    let error = text(&found.stderr);
    assert!(error.contains("--root: found `wobble`") && error.contains("Dutch roll"), "{error}");
    assert_eq!(names(folder.path()), ["roots.html"]);
}

#[test]
fn names_of_aircraft_and_inputs_stay_text() {
    let folder = tempfile::tempdir().unwrap();
    let wing = std::fs::read_to_string(workspace("aircraft/goland-wing.toml")).unwrap();
    let begin = wing.find("name = \"").unwrap();
    let end = begin + 8 + wing[begin + 8..].find('"').unwrap();
    let named = format!("{}name = \"</script><img onerror=x>{}", &wing[..begin], &wing[end..]);
    std::fs::write(folder.path().join("wing.toml"), named).unwrap();
    let found = run(folder.path(), "view wing.toml --trim --modes 2 -o wing.html");
    assert!(found.status.success(), "{}", text(&found.stderr));
    let html = std::fs::read_to_string(folder.path().join("wing.html")).unwrap();
    assert!(!html.contains("<img"));
    let page = Page::read(&folder.path().join("wing.html"));
    assert_eq!(page.scene["title"], "</script><img onerror=x>");
    assert_eq!(page.scene["clamped"], true);
}

#[test]
fn what_cannot_be_shown_is_refused_before_work() {
    let folder = tempfile::tempdir().unwrap();
    for (options, code, said) in [
        ("view --output -", 2, "pictures do not go to standard output"),
        ("view --rate 0", 2, "allowed is a number of poses a second"),
        ("view --compare exact,soft", 2, "allowed are two different levels"),
        ("view --output-name nothing --duration 1", 1, "--output-name nothing: there is no such output"),
        ("view --duration 1e6", 1, "a flight of "),
        ("view --input elevon=step:0.1", 1, "--input elevon=step:0.1"),
        ("view --flight no.csv", 1, "no.csv"),
    ] {
        let found = run(folder.path(), options);
        let error = text(&found.stderr);
        assert_eq!(found.status.code(), Some(code), "{options}: {error}");
        assert!(error.contains(said), "{options}: {error}");
    }
    assert!(!folder.path().join("target").exists());
}

#[test]
fn files_for_paraview_are_listed_over_time() {
    let folder = tempfile::tempdir().unwrap();
    let found = run(folder.path(), "view --duration 0.1 --rate 20 --modes 2 --vtk vtk -o page.html");
    assert!(found.status.success(), "{}", text(&found.stderr));
    let vtk = folder.path().join("vtk");
    let lists = ["01-flight-exact-beams.pvd", "01-flight-exact-strips.pvd"];
    assert_eq!(names(&vtk), ["01-flight-exact-beams", lists[0], "01-flight-exact-strips", lists[1]]);
    for list in lists {
        let list = std::fs::read_to_string(vtk.join(list)).unwrap();
        let files: Vec<&str> =
            list.split("file=\"").skip(1).map(|rest| rest.split_once('"').unwrap().0).collect();
        assert_eq!(files.len(), 3);
        for file in files {
            let mesh = std::fs::read_to_string(vtk.join(file)).unwrap();
            let colour = if file.contains("strips") { "Name=\"lift\"" } else { "Name=\"bending\"" };
            assert!(mesh.contains(colour), "{file}");
        }
    }
}
