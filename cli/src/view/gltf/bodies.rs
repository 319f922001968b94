//! Bodies, lofted from their rings, and engines, as the page draws them.

use nalgebra::Vector3;

use super::super::airframe::Airframe;
use super::super::body::{Body, bodies};
use super::super::scene::engine_size;
use super::shape::{Paint, Shape, Surface, across, around, unit};

/// Points around a ring.
const BODY: usize = 28;
const ENGINE: usize = 20;

/// Radius of a nacelle along it, from its inlet, both in parts of its length.
const NACELLE: [[f64; 2]; 6] =
    [[0.0, 0.2], [0.03, 0.225], [0.12, 0.25], [0.35, 0.26], [0.7, 0.22], [1.0, 0.14]];

/// Adds all bodies and engines.
pub fn add(airframe: &Airframe, shape: &mut Shape) {
    for body in bodies(airframe).0 {
        add_body(airframe, &body, shape.of(Paint::Body));
    }
    for engine in 0..airframe.engines.len() {
        add_engine(airframe, engine, shape);
    }
}

fn add_body(airframe: &Airframe, body: &Body, surface: &mut Surface) {
    let centres: Vec<Vector3<f64>> =
        body.rings.iter().map(|(section, _)| airframe.sections[*section].position).collect();
    let rings: Vec<Vec<u32>> =
        (0..centres.len()).map(|ring| add_ring(body, &centres, ring, surface)).collect();
    surface.rings(&rings);
    let last = centres.len() - 1;
    for (ring, beside) in [(0, 1), (last, last - 1)] {
        let outwards = unit(centres[ring] - centres[beside], Vector3::x());
        let corners: Vec<Vector3<f64>> =
            rings[ring].iter().map(|vertex| surface.vertices[*vertex as usize].place).collect();
        surface.face(body.rings[ring].0, outwards, &corners);
    }
}

/// Adds the vertices around a ring.
fn add_ring(body: &Body, centres: &[Vector3<f64>], ring: usize, surface: &mut Surface) -> Vec<u32> {
    let (before, after) = (ring.saturating_sub(1), (ring + 1).min(centres.len() - 1));
    let step = centres[after] - centres[before];
    let along = unit(step, Vector3::x());
    let [vertical, horizontal] = across(&along);
    let mean = |ring: usize| 0.5 * body.rings[ring].1.iter().sum::<f64>();
    let slope = (mean(after) - mean(before)) / step.norm().max(f64::MIN_POSITIVE);
    let (section, [wide, high]) = body.rings[ring];
    let vertex = |place: usize| {
        let angle = std::f64::consts::TAU * place as f64 / BODY as f64;
        let (sine, cosine) = angle.sin_cos();
        let out = horizontal * (cosine * wide) + vertical * (sine * high);
        let round = unit(horizontal * (cosine * high) + vertical * (sine * wide), horizontal);
        (centres[ring] + out, unit(round - along * slope, round))
    };
    (0..BODY)
        .map(|place| {
            let (at, normal) = vertex(place);
            surface.vertex(section, at, normal)
        })
        .collect()
}

/// Adds a nacelle with dark faces before and behind.
fn add_engine(airframe: &Airframe, number: usize, shape: &mut Shape) {
    let (engine, joint) = (&airframe.aircraft.engines[number], airframe.engines[number]);
    let size = engine_size(airframe);
    let ahead = unit(engine.direction, Vector3::x());
    let front = airframe.sections[joint].position + engine.offset + ahead * (0.5 * size);
    let directions = around(&ahead, ENGINE);
    let circle = |share: f64, radius: f64| -> Vec<Vector3<f64>> {
        let centre = front - ahead * (share * size);
        directions.iter().map(|out| centre + out * (radius * size)).collect()
    };
    let hull = shape.of(Paint::Engine);
    let row = |place: usize| {
        let [share, radius] = NACELLE[place];
        let [[from, narrow], [to, wide]] =
            [NACELLE[place.saturating_sub(1)], NACELLE[(place + 1).min(NACELLE.len() - 1)]];
        // Forwards where it becomes wider backwards.
        let lean = ahead * ((wide - narrow) / (to - from));
        let normals = directions.iter().map(|out| unit(out + lean, *out)).collect::<Vec<_>>();
        std::iter::zip(circle(share, radius), normals).collect::<Vec<_>>()
    };
    let mut rows = Vec::new();
    for place in 0..NACELLE.len() {
        let points = row(place).into_iter();
        rows.push(points.map(|(at, normal)| hull.vertex(joint, at, normal)).collect::<Vec<u32>>());
    }
    hull.rings(&rows);
    let [inlet, exit] = [NACELLE[0], NACELLE[NACELLE.len() - 1]].map(|[share, radius]| circle(share, radius));
    shape.of(Paint::Inlet).face(joint, ahead, &inlet);
    shape.of(Paint::Inlet).face(joint, -ahead, &exit);
}
