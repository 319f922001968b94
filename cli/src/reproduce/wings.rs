//! Wings in a wind tunnel that bend by a third of their span and more, beside what others found for them.
//!
//! [theory: geometrically-exact.recursion]

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, AircraftFileError, Attachment, Station, TunnelAir};
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::{ReducedModel, StructureError};

use crate::chart::{Axis, Chart, Curve, Mark, Window};

/// Modes that take part.
const MODES: usize = 12;

/// Patil's wing at 2° with its weight, with what AeroBeams (L. Pancini) found.
const PATIL: &str = include_str!("../../../tests/verification/records/patils-wing.md");

/// The Pazy wing, flown from data that are not ours to ship.
const PAZY: &str = include_str!("../../../tests/verification/records/pazy.md");

/// A figure of the page.
#[derive(Clone, Debug)]
pub struct Wing {
    /// For file names and links.
    pub slug: &'static str,
    pub chart: Chart,
    /// What is seen, in HTML.
    pub caption: &'static str,
}

/// Why there are none.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("{0}")]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Structure(#[from] StructureError),
}

/// All figures.
pub fn all() -> Result<[Wing; 3], Error> {
    Ok([patils_wing()?, pazy_wing(), shape()?])
}

/// How far all stations go outboard and up at rest in the flow, m; none where the wing comes to no rest.
fn at_rest(model: &Arc<ReducedModel>, fidelity: Fidelity, airspeed: f64) -> Option<Vec<(f64, f64)>> {
    let settings = PlantSettings { fidelity, airspeed, ..PlantSettings::of(model) };
    let mut flight = Simulation::new(Arc::clone(model), &Settings::from(settings), 0.0).ok()?;
    let deflections = flight.outputs().deflections.iter();
    Some(deflections.map(|station| (station.displacement.y, -station.displacement.z)).collect())
}

fn patils_wing() -> Result<Wing, Error> {
    let file = include_str!("../../../aircraft/patil-wing.toml");
    let mut aircraft = Aircraft::parse(file, "patil-wing.toml")?;
    aircraft.gravity = 9.80665;
    aircraft.mount.y = f64::to_radians(2.0);
    aircraft.tunnel_air = Some(TunnelAir { density: 0.08803, temperature: 288.15 });
    let model = Arc::new(ReducedModel::new(&aircraft, MODES)?);
    let levels = [
        (Fidelity::GeometricallyExact, "geometrically exact"),
        (Fidelity::Inconsistent, "inconsistent"),
        (Fidelity::ConsistentlyLinearised, "consistently linearised"),
        (Fidelity::Exact, "exact"),
    ];
    let curve = |(fidelity, label): (Fidelity, &str)| {
        let speeds = (0..=30).map(f64::from);
        let up = |speed: f64| Some((speed, at_rest(&model, fidelity, speed)?.first()?.1));
        Curve { label: label.to_owned(), points: speeds.filter_map(up).collect() }
    };
    Ok(Wing {
        slug: "patils-wing",
        chart: Chart {
            title: "Patil's wing of 16 m at 2°, with its weight".to_owned(),
            x: Axis { tick: Some(5.0), ..Axis::new("airspeed (m/s)", Window::new(0.0, 30.0)) },
            y: Axis {
                tick: Some(1.0),
                ..Axis::new("tip, up of the root's chord (m)", Window::new(-4.0, 6.0))
            },
            curves: levels.into_iter().map(curve).collect(),
            marks: vec![Mark::Points("AeroBeams".to_owned(), aerobeams_tips())],
            frame: None,
        },
        caption: "The wing of M. J. Patil, D. H. Hodges and C. E. S. Cesnik (J. Aircraft 38, 2001) in air of 0.08803 kg/m³, \
            with 12 modes; rings: AeroBeams (L. Pancini). Superposed displacements cannot bend without stretching, so that an \
            axial stiffness of 1e7 N holds the exact model down; the consistently linearised one jumps from equilibrium to \
            equilibrium; the inconsistent one goes up as far as the geometrically exact one, but its tip does not come in.",
    })
}

/// Airspeed, m/s, and tip up, m, by AeroBeams.
fn aerobeams_tips() -> Vec<(f64, f64)> {
    let row = |line: &str| {
        let (airspeed, rest) = line.strip_prefix("| ")?.split_once(" m/s: AeroBeams | ")?;
        let (tip, _) = rest.split_once(" | ")?;
        Some((airspeed.parse().ok()?, tip.parse().ok()?))
    };
    PATIL.lines().filter_map(row).collect()
}

fn pazy_wing() -> Wing {
    let (five, seven) = (pazy_tips(5), pazy_tips(7));
    let curve = |incidence: &str, tips: &[[f64; 3]]| Curve {
        label: format!("geometrically exact, {incidence}"),
        points: [(0.0, 0.0)].into_iter().chain(tips.iter().map(|tip| (tip[0], tip[2]))).collect(),
    };
    let published = five.iter().chain(&seven).map(|tip| (tip[0], tip[1])).collect();
    Wing {
        slug: "pazy-wing",
        chart: Chart {
            title: "The Pazy wing at 5° and 7°, without its weight".to_owned(),
            x: Axis { tick: Some(10.0), ..Axis::new("airspeed (m/s)", Window::new(0.0, 60.0)) },
            y: Axis { tick: Some(10.0), ..Axis::new("tip, up (% of the span)", Window::new(0.0, 60.0)) },
            curves: vec![curve("5°", &five), curve("7°", &seven)],
            marks: vec![Mark::Points("UM/NAST".to_owned(), published)],
            frame: None,
        },
        caption: "The wind-tunnel wing of the Technion with skin, from the beam model of C. Riso and C. E. S. Cesnik (IFASD 2022); \
            rings: their UM/NAST. Not flown here: the data are not ours to ship, and these are the numbers of the record in \
            VERIFICATION.md that <code>tests/pazy/compare.py</code> writes.",
    }
}

/// Airspeed, m/s, tip of UM/NAST and of this program, % of the span, at a root incidence in degrees.
fn pazy_tips(incidence: i32) -> Vec<[f64; 3]> {
    let row = |line: &str| {
        let rest = line.strip_prefix(&format!("| {incidence}°, "))?;
        let (airspeed, rest) = rest.split_once(" m/s: tip up, % of the span | ")?;
        let mut numbers = rest.split(" | ").map(str::parse::<f64>);
        let (published, found) = (numbers.next()?.ok()?, numbers.nth(1)?.ok()?);
        Some([airspeed.parse().ok()?, published, found])
    };
    PAZY.lines().filter_map(row).collect()
}

fn shape() -> Result<Wing, Error> {
    let file = include_str!("../../../aircraft/very-flexible-wing.toml");
    let mut aircraft = Aircraft::parse(file, "very-flexible-wing.toml")?;
    let tip = aircraft.stations.clone();
    let end = |(tip, beam): (&Station, usize)| Station {
        name: format!("section_{beam}"),
        attachment: Attachment { beam, fraction: 1.0 },
        ..tip.clone()
    };
    aircraft.stations = tip.iter().cycle().zip(0..aircraft.beams.len()).map(end).collect();
    let places: Vec<f64> = aircraft.beams.iter().map(|beam| aircraft.nodes[beam.nodes[1]].y).collect();
    let model = Arc::new(ReducedModel::new(&aircraft, MODES)?);
    let curve = |(fidelity, airspeed, label): (Fidelity, f64, &str)| {
        let moved = at_rest(&model, fidelity, airspeed).unwrap_or_default();
        let points = places.iter().zip(moved).map(|(place, (outboard, up))| (place + outboard, up));
        Curve { label: label.to_owned(), points: [(0.0, 0.0)].into_iter().chain(points).collect() }
    };
    let curves = [
        (Fidelity::GeometricallyExact, 60.0, "geometrically exact, 60 m/s"),
        (Fidelity::GeometricallyExact, 50.0, "50 m/s"),
        (Fidelity::GeometricallyExact, 40.0, "40 m/s"),
        (Fidelity::GeometricallyExact, 0.0, "at rest"),
        (Fidelity::Inconsistent, 60.0, "inconsistent, 60 m/s"),
        (Fidelity::Exact, 60.0, "exact, 60 m/s"),
    ];
    Ok(Wing {
        slug: "very-flexible-wing",
        chart: Chart {
            title: "The shipped very flexible wing at 5°, seen from ahead".to_owned(),
            x: Axis { tick: Some(0.1), ..Axis::new("outboard (m)", Window::new(0.0, 0.65)) },
            y: Axis { tick: Some(0.1), ..Axis::new("up (m)", Window::new(-0.04, 0.32)) },
            curves: curves.map(curve).into(),
            marks: Vec::new(),
            frame: None,
        },
        caption: "<code>aircraft/very-flexible-wing.toml</code>, 0.6 m of span, with its weight, 12 modes; both axes have nearly \
            one scale. At 60 m/s the tip stands 45 % of the span above the root and has come in by 12 %. Superposed \
            displacements leave it outboard and the wing longer than it is, or, where the axial stiffness counts, do not let it \
            bend.",
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_record_of_patils_wing_has_what_aerobeams_found() {
        let tips = aerobeams_tips();
        let airspeeds: Vec<f64> = tips.iter().map(|tip| tip.0).collect();
        assert_eq!(airspeeds, [0.0, 10.0, 15.0, 20.0, 25.0, 28.0, 30.0]);
        assert!(tips.is_sorted_by(|below, above| below.1 < above.1) && tips[0].1 < -2.9 && tips[6].1 > 4.8);
    }

    #[test]
    fn the_record_of_the_pazy_wing_has_both_incidences() {
        for incidence in [5, 7] {
            let tips = pazy_tips(incidence);
            assert_eq!(
                tips.iter().map(|tip| tip[0]).collect::<Vec<_>>(),
                [10.0, 20.0, 30.0, 40.0, 50.0, 60.0]
            );
            assert!(tips.iter().all(|tip| (tip[2] - tip[1]).abs() < 0.7), "{tips:?}");
        }
    }

    #[test]
    fn curves_pass_through_what_others_found_where_displacements_are_not_superposed() {
        let [patil, _, shape] = all().unwrap();
        let tip_at = |speed: f64| {
            patil.chart.curves[0].points.iter().find(|point| point.0 == speed).map(|point| point.1).unwrap()
        };
        for (speed, published) in aerobeams_tips() {
            assert!((tip_at(speed) - published).abs() < 0.08);
        }
        // The wing keeps its length but where displacements are superposed.
        let length = |curve: &Curve| -> f64 {
            curve.points.windows(2).map(|ends| (ends[1].0 - ends[0].0).hypot(ends[1].1 - ends[0].1)).sum()
        };
        let lengths: Vec<f64> = shape.chart.curves.iter().map(length).collect();
        assert!((0..4).all(|curve| (lengths[curve] - 0.6).abs() < 1e-3) && lengths[4] > 0.65, "{lengths:?}");
    }
}
