//! Files for ParaView: at each frame the strips as quadrilaterals with their lift and the beams as lines with their section loads (.vtu), and
//! lists of both over time (.pvd).
//!
//! Axes as ParaView has them: x north, y west, z up, from where O is in the first frame, m. Numbers are single, little-endian, in base64,
//! with their units as VTK keeps them.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use flexible_aircraft_packaging::FileError;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use quick_xml::events::{BytesDecl, BytesText, Event};
use quick_xml::writer::{ElementWriter, Writer};

use crate::files::Drafts;

use super::airframe::Airframe;
use super::outline::Outline;
use super::page::base64;
use super::recording::{POSE, Place, Recording};
use super::show::Show;

/// The types of cells.
const LINE: u8 = 3;
const QUADRILATERAL: u8 = 9;

type Xml = Writer<Vec<u8>>;

/// Numbers with a name.
struct Array {
    name: &'static str,
    unit: &'static str,
    components: usize,
    values: Vec<f32>,
}

/// A mesh of cells of one kind.
struct Mesh {
    points: Vec<Vector3<f64>>,
    /// From where they would be on the undeformed aircraft that flies there.
    displacements: Vec<Vector3<f64>>,
    kind: u8,
    cells: Vec<Vec<usize>>,
    of_points: Vec<Array>,
    of_cells: Vec<Array>,
}

/// Writes all frames of shows into a folder; returns the lists that ParaView opens.
pub fn write(airframe: &Airframe, shows: &[Show], folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    let outlines = Outline::of_all(&airframe.aircraft);
    let mut lists = Vec::new();
    for (number, show) in shows.iter().enumerate() {
        let name = word(&show.name, number);
        for (what, mesh) in [("strips", strips as fn(&Frame<'_>, &[Outline]) -> Mesh), ("beams", beams)] {
            let mut files = Vec::new();
            let numbered = |frame: usize| format!("{name}-{what}/{frame:05}.vtu");
            for frame in 0..show.recording.frames {
                let file = numbered(frame);
                let frame_of = Frame { airframe, recording: &show.recording, frame };
                keep(&folder.join(&file), &mesh(&frame_of, &outlines).document())?;
                files.push((show.start + frame as f64 * show.step, file));
            }
            let later = (show.recording.frames..).map(|frame| folder.join(numbered(frame)));
            remove(later)?;
            let list = folder.join(format!("{name}-{what}.pvd"));
            // Last, when all are there.
            keep(&list, &collection(&files))?;
            lists.push(list);
        }
    }
    Ok(lists)
}

/// Makes sure that a folder can be written to, before what is written is computed.
///
/// # Errors
/// When it cannot.
pub fn check(folder: &Path) -> Result<(), FileError> {
    Drafts::new([folder.join("shows.pvd").as_path()]).map(drop)
}

/// Removes files, up to the first that is not there: those of a longer show that was written here before. ParaView takes all that are
/// numbered alike for one series.
fn remove(mut files: impl Iterator<Item = PathBuf>) -> Result<(), FileError> {
    let first_kept = files.try_for_each(|path| fs::remove_file(&path).map_err(|source| (path, source)));
    match first_kept {
        Err((path, source)) if source.kind() != ErrorKind::NotFound => {
            Err(FileError { action: "delete", path, source })
        }
        _ => Ok(()),
    }
}

fn keep(path: &Path, content: &[u8]) -> Result<(), FileError> {
    Drafts::new([path])?.keep([content])
}

/// A show's name as that of files: its words, and its number where others could be called so.
fn word(name: &str, number: usize) -> String {
    let letters = name.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { ' ' });
    let words = letters.collect::<String>();
    let words: Vec<&str> = words.split_whitespace().collect();
    format!("{:02}-{}", number + 1, words.join("-").to_lowercase())
}

/// A moment of a show.
struct Frame<'a> {
    airframe: &'a Airframe,
    recording: &'a Recording,
    frame: usize,
}

impl Frame<'_> {
    /// Where something fixed to a section is, and how far from its undeformed place.
    fn place(&self, section: usize, offset: &Vector3<f64>) -> [Vector3<f64>; 2] {
        let Frame { airframe, recording, frame } = self;
        let pose = &recording.poses[POSE * (frame * airframe.sections.len() + section)..][..POSE];
        let in_body = vector(pose) + turn(&pose[3..]) * offset;
        let body = &recording.body[POSE * frame..][..POSE];
        let on_earth = vector(body) - vector(&recording.body) + turn(&body[3..]) * in_body;
        let moved = in_body - airframe.sections[section].position - offset;
        [on_earth, turn(&body[3..]) * moved].map(|v| Vector3::new(v.x, -v.y, -v.z))
    }

    /// The colours of strips or sections at some of these.
    fn colours(&self, place: Place, at: &[usize]) -> Vec<Array> {
        let all = self.recording.colours.iter().filter(|(quantity, _)| quantity.place == place);
        let array = |(quantity, values): &(super::recording::Quantity, Vec<f64>)| {
            let columns = values.len() / self.recording.frames;
            let row = &values[self.frame * columns..][..columns];
            Array {
                name: quantity.name,
                unit: quantity.unit,
                components: 1,
                values: at.iter().map(|&one| row[one] as f32).collect(),
            }
        };
        all.map(array).collect()
    }
}

fn vector(parts: &[f64]) -> Vector3<f64> {
    Vector3::new(parts[0], parts[1], parts[2])
}

fn turn(parts: &[f64]) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(Quaternion::new(parts[0], parts[1], parts[2], parts[3]))
}

fn strips(frame: &Frame<'_>, outlines: &[Outline]) -> Mesh {
    let corners = frame.airframe.strips.iter().zip(outlines);
    let places: Vec<[Vector3<f64>; 2]> = corners
        .flat_map(|(&section, outline)| outline.corners.map(|corner| frame.place(section, &corner)))
        .collect();
    let all: Vec<usize> = (0..outlines.len()).collect();
    Mesh {
        cells: all.iter().map(|strip| (4 * strip..4 * strip + 4).collect()).collect(),
        kind: QUADRILATERAL,
        of_points: Vec::new(),
        of_cells: frame.colours(Place::Strips, &all),
        points: places.iter().map(|place| place[0]).collect(),
        displacements: places.iter().map(|place| place[1]).collect(),
    }
}

fn beams(frame: &Frame<'_>, _: &[Outline]) -> Mesh {
    let sections: Vec<usize> = frame.airframe.nodes.concat();
    let places: Vec<[Vector3<f64>; 2]> =
        sections.iter().map(|&section| frame.place(section, &Vector3::zeros())).collect();
    let mut cells = Vec::new();
    let mut first = 0;
    for nodes in &frame.airframe.nodes {
        cells.extend((first..first + nodes.len() - 1).map(|node| vec![node, node + 1]));
        first += nodes.len();
    }
    Mesh {
        cells,
        kind: LINE,
        of_points: frame.colours(Place::Sections, &sections),
        of_cells: Vec::new(),
        points: places.iter().map(|place| place[0]).collect(),
        displacements: places.iter().map(|place| place[1]).collect(),
    }
}

impl Mesh {
    /// As a file.
    fn document(&self) -> Vec<u8> {
        document("UnstructuredGrid", |xml| {
            let counts = [self.points.len(), self.cells.len()].map(|count| count.to_string());
            let piece = xml
                .create_element("Piece")
                .with_attribute(("NumberOfPoints", counts[0].as_str()))
                .with_attribute(("NumberOfCells", counts[1].as_str()));
            piece.write_inner_content(|xml| {
                let points = [three("points", &self.points)];
                xml.create_element("Points").write_inner_content(|xml| floats(xml, &points))?;
                xml.create_element("Cells").write_inner_content(|xml| self.write_cells(xml))?;
                xml.create_element("PointData").write_inner_content(|xml| {
                    floats(xml, &[three("displacement", &self.displacements)])?;
                    floats(xml, &self.of_points)
                })?;
                xml.create_element("CellData").write_inner_content(|xml| floats(xml, &self.of_cells))?;
                Ok(())
            })?;
            Ok(())
        })
    }

    fn write_cells(&self, xml: &mut Xml) -> io::Result<()> {
        let number = |number: usize| (number as i32).to_le_bytes();
        let corners: Vec<u8> = self.cells.iter().flatten().flat_map(|&point| number(point)).collect();
        let mut end = 0;
        let ends = self.cells.iter().flat_map(|cell| {
            end += cell.len();
            number(end)
        });
        let ends: Vec<u8> = ends.collect();
        whole(xml, ("connectivity", "Int32"), &corners)?;
        whole(xml, ("offsets", "Int32"), &ends)?;
        whole(xml, ("types", "UInt8"), &vec![self.kind; self.cells.len()])
    }
}

fn three(name: &'static str, vectors: &[Vector3<f64>]) -> Array {
    let values = vectors.iter().flat_map(|vector| vector.iter().map(|part| *part as f32).collect::<Vec<_>>());
    Array { name, unit: "m", components: 3, values: values.collect() }
}

fn floats(xml: &mut Xml, arrays: &[Array]) -> io::Result<()> {
    arrays.iter().try_for_each(|array| {
        let bytes: Vec<u8> = array.values.iter().flat_map(|value| value.to_le_bytes()).collect();
        let components = array.components.to_string();
        let vectors = (array.components > 1).then_some(("NumberOfComponents", components.as_str()));
        let element = data_array(xml, array.name, "Float32").with_attributes(vectors);
        element.write_inner_content(|xml| {
            xml.write_event(Event::Text(BytesText::new(&encoded(&bytes))))?;
            let unit = xml.create_element("InformationKey").with_attribute(("name", "UNITS_LABEL"));
            let unit = unit.with_attribute(("location", "vtkDataArray"));
            unit.write_text_content(BytesText::new(array.unit)).map(|_| ())
        })?;
        Ok(())
    })
}

fn whole(xml: &mut Xml, (name, kind): (&str, &str), bytes: &[u8]) -> io::Result<()> {
    data_array(xml, name, kind).write_text_content(BytesText::new(&encoded(bytes))).map(|_| ())
}

fn data_array<'a>(xml: &'a mut Xml, name: &str, kind: &str) -> ElementWriter<'a, Vec<u8>> {
    xml.create_element("DataArray")
        .with_attribute(("type", kind))
        .with_attribute(("Name", name))
        .with_attribute(("format", "binary"))
}

/// Numbers behind how many bytes they are.
fn encoded(bytes: &[u8]) -> String {
    base64(&[&(bytes.len() as u32).to_le_bytes(), bytes].concat())
}

/// The list of files over time, s.
fn collection(files: &[(f64, String)]) -> Vec<u8> {
    document("Collection", |xml| {
        files.iter().try_for_each(|(time, file)| {
            xml.create_element("DataSet")
                .with_attribute(("timestep", time.to_string().as_str()))
                .with_attribute(("part", "0"))
                .with_attribute(("file", file.as_str()))
                .write_empty()
                .map(|_| ())
        })
    })
}

/// A file of VTK of a kind.
fn document(kind: &str, content: impl FnOnce(&mut Xml) -> io::Result<()>) -> Vec<u8> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 1);
    let declared = xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)));
    let root = || {
        let file = xml
            .create_element("VTKFile")
            .with_attribute(("type", kind))
            .with_attribute(("version", "1.0"))
            .with_attribute(("byte_order", "LittleEndian"))
            .with_attribute(("header_type", "UInt32"));
        file.write_inner_content(|xml| xml.create_element(kind).write_inner_content(content).map(|_| ()))
            .map(|_| ())
    };
    // PROOF: memory takes every byte.
    declared.and_then(|()| root()).expect("writing to memory succeeds");
    xml.into_inner()
}

#[cfg(test)]
mod tests {
    use quick_xml::Reader;

    use super::super::airframe::tests::jet;
    use super::super::recording::LIFT;
    use super::*;

    /// The names of all elements, of which the document is one.
    fn elements(document: &[u8]) -> Vec<String> {
        let mut reader = Reader::from_reader(document);
        let (mut names, mut buffer) = (Vec::new(), Vec::new());
        loop {
            match reader.read_event_into(&mut buffer).unwrap() {
                Event::Start(element) | Event::Empty(element) => {
                    names.push(element.name().as_ref().to_owned());
                }
                Event::Eof => return names,
                _ => {}
            }
        }
    }

    #[test]
    fn strips_and_beams_are_meshes_with_loads() {
        let airframe = Airframe::new(&jet());
        let outlines = Outline::of_all(&airframe.aircraft);
        let mut recording = Recording { frames: 1, ..Recording::default() };
        recording.body.extend([100.0, 50.0, -7620.0, 1.0, 0.0, 0.0, 0.0]);
        for section in &airframe.sections {
            recording.poses.extend(section.position.iter());
            recording.poses.extend([1.0, 0.0, 0.0, 0.0]);
        }
        recording.colour(LIFT, (0..airframe.strips.len()).map(|strip| strip as f64));
        let frame = Frame { airframe: &airframe, recording: &recording, frame: 0 };
        let quads = strips(&frame, &outlines);
        let [right, left] =
            [1.0, -1.0].map(|side| quads.points.iter().map(|p| -p.y * side).fold(0.0, f64::max));
        assert!((right - 12.43).abs() < 0.1 && (right - left).abs() < 1e-9, "{right} {left}");
        assert!(quads.displacements.iter().all(|moved| moved.norm() < 1e-12));
        assert_eq!(quads.of_cells[0].values[3], 3.0);
        let found = elements(&quads.document());
        assert_eq!(found[..3], ["VTKFile", "UnstructuredGrid", "Piece"]);
        assert_eq!(found.iter().filter(|name| *name == "DataArray").count(), 6);
        // Of points, displacements and lift.
        assert_eq!(found.iter().filter(|name| *name == "InformationKey").count(), 3);
        let lines = beams(&frame, &outlines);
        assert_eq!(lines.cells.len(), airframe.aircraft.beams.len());
        assert_eq!(lines.points.len(), airframe.nodes.concat().len());
    }

    #[test]
    fn lists_name_their_files_and_shows_have_names_of_files() {
        let list = collection(&[(0.0, "a/0.vtu".to_owned()), (0.5, "a/1.vtu".to_owned())]);
        assert_eq!(elements(&list), ["VTKFile", "Collection", "DataSet", "DataSet"]);
        assert!(String::from_utf8(list).unwrap().contains("timestep=\"0.5\" part=\"0\" file=\"a/1.vtu\""));
        assert_eq!(word("1 · 3.2 Hz · wing bending, first", 0), "01-1-3-2-hz-wing-bending-first");
    }
}
