//! How the modes of an aircraft move over airspeed: a table and root loci, each mode followed by its name [theory: stability.modes].

use std::sync::Arc;

use flexible_aircraft::flight::{Settings, SimulationError};
use flexible_aircraft::stability::{FlightMode, FlightModeKind, FlightModes};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::{Inflow, flight_modes};
use rayon::prelude::*;

use crate::answer::Answer;
use crate::chart::{Axis, Chart, Curve, Mark, Window, stacked};
use crate::numbers::{Plain, short};
use crate::progress::Progress;

use super::modes::{COLUMNS, cells_of};

/// The modes at each airspeed at which there are any.
pub struct Locus {
    title: String,
    /// m/s, ascending, and the modes.
    points: Vec<(f64, FlightModes)>,
    /// m/s, and why there are none.
    pub failures: Vec<(f64, SimulationError)>,
}

impl Locus {
    /// Over ascending airspeeds, m/s, on all cores.
    pub fn new(
        model: &Arc<ReducedModel>,
        settings: &Settings,
        inflow: Inflow,
        airspeeds: &[f64],
        progress: &Progress,
    ) -> Self {
        let at = |&airspeed: &f64| {
            let mut settings = settings.clone();
            settings.plant.airspeed = airspeed;
            let modes = flight_modes(Arc::clone(model), &settings, inflow);
            progress.advance();
            (airspeed, modes)
        };
        let found: Vec<_> = airspeeds.par_iter().map(at).collect();
        let (mut points, mut failures): (Vec<(f64, FlightModes)>, _) = (Vec::new(), Vec::new());
        for (airspeed, modes) in found {
            match modes {
                Ok(modes) => {
                    let modes = match points.last() {
                        Some((_, before)) => modes.named_after(before),
                        None => modes,
                    };
                    points.push((airspeed, modes));
                }
                Err(failure) => failures.push((airspeed, failure)),
            }
        }
        Locus { title: format!("{}: modes over airspeed", model.name), points, failures }
    }

    /// Whether there is nothing to show.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// A line for each mode at each airspeed, as comma-separated values.
    pub fn table(&self) -> String {
        let mut text = format!("airspeed,mode,{COLUMNS},quasi_steady\n");
        for (airspeed, modes) in &self.points {
            for mode in &modes.modes {
                let cells = cells_of(mode.eigenvalue());
                text += &format!("{},{},{cells},{}\n", Plain(*airspeed), mode.name, mode.is_quasi_steady);
            }
        }
        text
    }

    /// The same as arrays.
    pub fn answer(&self) -> Answer {
        let rows: Vec<(f64, &FlightMode)> = self
            .points
            .iter()
            .flat_map(|(airspeed, modes)| modes.modes.iter().map(move |mode| (*airspeed, mode)))
            .collect();
        let eigenvalues =
            rows.iter().map(|(_, mode)| [mode.eigenvalue().re, mode.eigenvalue().im]).collect::<Vec<_>>();
        Answer::named([
            ("airspeed", Answer::Numbers(rows.iter().map(|(airspeed, _)| *airspeed).collect())),
            ("mode", Answer::Texts(rows.iter().map(|(_, mode)| mode.name.to_string()).collect())),
            ("eigenvalue", Answer::Complex { rows: rows.len(), columns: 1, values: eigenvalues }),
            ("quasi_steady", Answer::Truths(rows.iter().map(|(_, mode)| mode.is_quasi_steady).collect())),
        ])
    }

    /// Root loci, upper half: of rigid motion, and of the structure.
    pub fn drawing(&self) -> String {
        let is_elastic = |mode: &FlightMode| matches!(mode.name.kind, FlightModeKind::Elastic(_));
        let charts =
            [self.chart("rigid motion", |mode| !is_elastic(mode)), self.chart("structure", is_elastic)];
        stacked(&self.title, &charts.into_iter().flatten().collect::<Vec<_>>())
    }

    /// Of some modes; none where there are none.
    fn chart(&self, what: &str, is_wanted: impl Fn(&FlightMode) -> bool) -> Option<Chart> {
        let wanted = |modes: &FlightModes| -> Vec<FlightMode> {
            modes.modes.iter().filter(|mode| is_wanted(mode)).cloned().collect()
        };
        let wanted: Vec<Vec<FlightMode>> = self.points.iter().map(|(_, modes)| wanted(modes)).collect();
        let mut names = Vec::new();
        for mode in wanted.iter().flatten() {
            if !names.contains(&mode.name) {
                names.push(mode.name);
            }
        }
        let place = |mode: &FlightMode| (mode.eigenvalue().re, mode.eigenvalue().im);
        let curve = |name| {
            let points = wanted.iter().flatten().filter(|mode| mode.name == name).map(place);
            Curve { label: format!("{name}"), points: points.collect() }
        };
        let curves: Vec<Curve> = names.into_iter().map(curve).collect();
        let points: Vec<(f64, f64)> = curves.iter().flat_map(|curve| curve.points.iter().copied()).collect();
        let window = |value: fn(&(f64, f64)) -> f64| Window::around(points.iter().map(value).chain([0.0]));
        let starts = wanted.first()?.iter().map(place).collect();
        let first = self.points.first().map_or(0.0, |(airspeed, _)| *airspeed);
        let marks =
            vec![Mark::Vertical(0.0, String::new()), Mark::Points(format!("{} m/s", short(first)), starts)];
        (!curves.is_empty()).then(|| Chart {
            title: what.to_owned(),
            x: Axis::new("real part (1/s); grows right of 0", window(|point| point.0)),
            y: Axis::new("imaginary part (rad/s)", window(|point| point.1)),
            curves,
            marks,
            frame: None,
        })
    }
}
