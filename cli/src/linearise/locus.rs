//! How the modes of an aircraft move over airspeed: a table and root loci, each mode followed by its name [theory: stability.modes].

use std::sync::Arc;

use flexible_aircraft::flight::{Settings, Simulation, SimulationError};
use flexible_aircraft::plant::LimitExceeded;
use flexible_aircraft::stability::{FlightMode, FlightModeKind, FlightModes};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::{Inflow, flight_modes};
use rayon::prelude::*;

use crate::answer::Answer;
use crate::chart::{Axis, Chart, Curve, Mark, Window, stacked};
use crate::numbers::{Plain, short};
use crate::progress::Progress;

use super::modes::{COLUMNS, cells_of, family};

/// The modes at each airspeed at which there are any.
pub struct Locus {
    title: String,
    /// m/s, ascending, and the modes.
    points: Vec<(f64, FlightModes)>,
    /// m/s, and why there are none.
    pub failures: Vec<(f64, SimulationError)>,
    /// m/s, ascending, and what of the trim is beyond its limit and stands all the same.
    pub limits_exceeded: Vec<(f64, LimitExceeded)>,
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
            let modes = modes(model, &settings, inflow);
            progress.advance();
            (airspeed, modes)
        };
        let found: Vec<_> = airspeeds.par_iter().map(at).collect();
        let mut points: Vec<(f64, FlightModes)> = Vec::new();
        let (mut failures, mut limits_exceeded) = (Vec::new(), Vec::new());
        for (airspeed, modes) in found {
            match modes {
                Ok((modes, exceeded)) => {
                    limits_exceeded.extend(exceeded.into_iter().map(|exceeded| (airspeed, exceeded)));
                    let modes = match points.last() {
                        Some((_, before)) => modes.named_after(before),
                        None => modes,
                    };
                    points.push((airspeed, modes));
                }
                Err(failure) => failures.push((airspeed, failure)),
            }
        }
        Locus { title: format!("{}: modes over airspeed", model.name), points, failures, limits_exceeded }
    }

    /// Whether there is nothing to show.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// A line for each mode at each airspeed, as comma-separated values.
    pub fn table(&self) -> String {
        let mut text = format!("airspeed,mode,family,{COLUMNS},quasi_steady\n");
        for (airspeed, modes) in &self.points {
            for mode in &modes.modes {
                let (family, cells) = (family(mode).unwrap_or_default(), cells_of(mode.eigenvalue()));
                let (airspeed, is_quasi_steady) = (Plain(*airspeed), mode.is_quasi_steady);
                text += &format!("{airspeed},{},{family},{cells},{is_quasi_steady}\n", mode.name);
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
            (
                "family",
                Answer::Texts(
                    rows.iter().map(|(_, mode)| family(mode).unwrap_or_default().to_owned()).collect(),
                ),
            ),
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
        let points = in_view(&curves);
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

/// The modes under some settings, and what of the trim is beyond its limits.
fn modes(
    model: &Arc<ReducedModel>,
    settings: &Settings,
    inflow: Inflow,
) -> Result<(FlightModes, Vec<LimitExceeded>), SimulationError> {
    let modes = flight_modes(Arc::clone(model), settings, inflow)?;
    let exceeded = Simulation::new(Arc::clone(model), settings, 0.0)?.limits_exceeded().to_vec();
    Ok((modes, exceeded))
}

/// What axes show: the roots that swing, and real ones that grow no faster than these are large. Beside real ones that decay fast all
/// would stand in one line. All roots where none swings.
fn in_view(curves: &[Curve]) -> Vec<(f64, f64)> {
    let all = || curves.iter().flat_map(|curve| curve.points.iter().copied());
    let swinging = || all().filter(|(_, imaginary)| *imaginary > 0.0);
    let largest = swinging().map(|(real, imaginary)| real.hypot(imaginary)).fold(0.0, f64::max);
    let grows = |real: f64| 0.0 < real && real <= largest;
    if largest == 0.0 {
        return all().collect();
    }
    all().filter(|(real, imaginary)| *imaginary > 0.0 || grows(*real)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_show_what_swings_and_all_roots_only_where_none_does() {
        let curve = |points: &[(f64, f64)]| Curve { label: "mode".to_owned(), points: points.to_vec() };
        let (swings, decays) = (curve(&[(-0.5, 2.0), (-0.7, 2.5)]), curve(&[(-40.0, 0.0), (-60.0, 0.0)]));
        assert_eq!(in_view(&[decays.clone(), swings.clone()]), swings.points);
        let grows = curve(&[(0.1, 0.0), (3.0, 0.0)]);
        assert_eq!(in_view(&[swings.clone(), grows]), [(-0.5, 2.0), (-0.7, 2.5), (0.1, 0.0)]);
        assert_eq!(in_view(std::slice::from_ref(&decays)), decays.points);
    }
}
