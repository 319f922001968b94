//! What is drawn of the aircraft, as the page reads it: outlines, bodies, engines, stations, cuts, each hung on a section.

use flexible_aircraft::aircraft::{Aircraft, Strip, Support};
use flexible_aircraft::structure::ReducedModel;
use nalgebra::Vector3;
use serde_json::{Value, json};

use crate::describe::surfaces;

use super::airframe::Airframe;
use super::body::bodies;
use super::flap::Flap;
use super::outline::Outline;

/// Thickness of surfaces and of strips across bodies, in chords.
const AEROFOIL: f64 = 0.12;
const ACROSS: f64 = 0.02;

/// The size at which engines are drawn, in parts of the airframe's.
const ENGINE: f64 = 0.04;

/// Digits of lengths: micrometres.
const DIGITS: f64 = 1e6;

/// The scene without its shows; thrusts up to a largest one, N, are drawn.
pub fn scene(airframe: &Airframe, model: &ReducedModel, largest_thrust: f64, notes: &[String]) -> Value {
    let aircraft = &airframe.aircraft;
    let (bodies, assumed) = bodies(airframe);
    let bodies: Vec<Value> = bodies
        .iter()
        .map(|body| {
            let ring = |&(section, radii): &(usize, [f64; 2])| json!({"section": section, "offset": [0, 0, 0], "radius": radii.map(short)});
            json!({"component": body.component, "rings": body.rings.iter().map(ring).collect::<Vec<_>>()})
        })
        .collect();
    let notes: Vec<&String> = notes.iter().chain(&assumed).collect();
    json!({
        "format": 1,
        "title": aircraft.name,
        "aircraft": aircraft.name,
        "notes": notes,
        "clamped": aircraft.support == Support::Clamped,
        "size": short(airframe.size()),
        "sections": airframe.sections.iter().map(|section| vector(&section.position)).collect::<Vec<_>>(),
        "strips": strips(airframe),
        "bodies": bodies,
        "engines": engines(airframe, largest_thrust),
        "stations": stations(airframe),
        "cuts": cuts(airframe, model),
        "controls": aircraft.controls.iter().map(|control| json!({"name": control.name})).collect::<Vec<_>>(),
    })
}

fn strips(airframe: &Airframe) -> Vec<Value> {
    let aircraft = &airframe.aircraft;
    let outlines = Outline::of_all(aircraft);
    let strip = |(number, outline): (usize, &Outline)| {
        let strip = &aircraft.strips[number];
        let mut value = json!({
            "component": aircraft.beams[strip.attachment.beam].component,
            "number": number + 1,
            "section": airframe.strips[number],
            "corners": outline.corners.map(|corner| vector(&corner)),
            "normal": vector(&outline.normal),
            "thickness": thickness(aircraft, strip),
        });
        if let Some(moved) = Flap::of(aircraft, number, outline) {
            value["flap"] = flap(&moved);
        }
        value
    };
    outlines.iter().enumerate().map(strip).collect()
}

/// As the page reads it.
fn flap(flap: &Flap) -> Value {
    let controls: Vec<Value> =
        flap.gains.iter().map(|(control, gain)| json!({"control": control, "gain": gain})).collect();
    json!({"hinge": flap.hinge.map(|end| vector(&end)), "axis": vector(&flap.axis), "controls": controls})
}

/// The thickness at which a strip is drawn, in chords.
pub fn thickness(aircraft: &Aircraft, strip: &Strip) -> f64 {
    if surfaces::runs_along(aircraft, strip) { AEROFOIL } else { ACROSS }
}

/// The length at which engines are drawn, m.
pub fn engine_size(airframe: &Airframe) -> f64 {
    ENGINE * airframe.size()
}

fn engines(airframe: &Airframe, largest_thrust: f64) -> Vec<Value> {
    let engines = airframe.aircraft.engines.iter().zip(&airframe.engines);
    let size = engine_size(airframe);
    let engine = |(engine, &section): (&flexible_aircraft::aircraft::Engine, &usize)| {
        json!({
            "name": engine.name,
            "section": section,
            "offset": vector(&engine.offset),
            "direction": vector(&engine.direction),
            "size": short(size),
            // The largest is drawn twice as long as the engine.
            "thrustScale": short((0.5 * largest_thrust).max(1.0)),
        })
    };
    engines.map(engine).collect()
}

fn stations(airframe: &Airframe) -> Vec<Value> {
    let stations = airframe.aircraft.stations.iter().zip(&airframe.stations);
    stations
        .map(|(station, section)| json!({"name": station.name, "section": section, "offset": [0, 0, 0]}))
        .collect()
}

fn cuts(airframe: &Airframe, model: &ReducedModel) -> Vec<Value> {
    let cuts = airframe.cuts.iter().zip(&model.cuts);
    cuts.map(|(section, cut)| {
        json!({"name": cut.name, "section": section, "offset": [0, 0, 0], "normal": vector(&cut.along)})
    })
    .collect()
}

/// A vector with digits to a micrometre.
pub fn vector(vector: &Vector3<f64>) -> [f64; 3] {
    [vector.x, vector.y, vector.z].map(short)
}

/// A number to six places.
pub fn short(number: f64) -> f64 {
    // Not −0.
    (number * DIGITS).round() / DIGITS + 0.0
}

#[cfg(test)]
mod tests {
    use super::super::airframe::tests::jet;
    use super::*;

    fn of_jet() -> (Airframe, Value) {
        let airframe = Airframe::new(&jet());
        let model = ReducedModel::new(&airframe.aircraft, 2).unwrap();
        let scene = scene(&airframe, &model, 1e4, &["a note".to_owned()]);
        (airframe, scene)
    }

    #[test]
    fn everything_of_the_jet_hangs_on_a_section() {
        let (airframe, scene) = of_jet();
        let count = airframe.sections.len() as u64;
        for kind in ["strips", "engines", "stations", "cuts"] {
            let parts = scene[kind].as_array().unwrap();
            assert!(!parts.is_empty(), "{kind}");
            assert!(parts.iter().all(|part| part["section"].as_u64().unwrap() < count), "{kind}");
        }
        assert_eq!(scene["stations"].as_array().unwrap().len(), airframe.named[0]);
        assert!(scene["notes"].as_array().unwrap().len() == 2 && scene["clamped"] == false);
    }

    /// Positive is trailing edge down on the wing.
    #[test]
    fn a_positive_angle_turns_the_trailing_edge_down() {
        let (airframe, scene) = of_jet();
        let three = |value: &Value| Vector3::from([0, 1, 2].map(|axis| value[axis].as_f64().unwrap()));
        let strips = scene["strips"].as_array().unwrap();
        let mut seen = 0;
        for (strip, of) in strips.iter().zip(&airframe.aircraft.strips) {
            let Some(flap) = strip.get("flap").filter(|_| of.span.y.abs() > 0.9) else { continue };
            let behind = three(&strip["corners"][3]) - three(&flap["hinge"][0]);
            assert!(three(&flap["axis"]).cross(&behind).z > 0.0);
            seen += 1;
        }
        assert!(seen > 2);
    }
}
