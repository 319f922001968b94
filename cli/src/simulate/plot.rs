//! What a flight looks like: outputs and inputs over time, those of a kind and a unit in one chart.

use flexible_aircraft::aircraft::Support;
use flexible_aircraft::flight::{Instant, Settings};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::{Unit, VariableTable};

use super::schedule::{MOST_DRAWN, Schedule};
use crate::chart::{Axis, Chart, Curve, Mark, Window, stacked};
use crate::flown::condition;
use crate::watched::Watched;

/// Stations whose deflections are drawn unless others are named.
const STATIONS: usize = 3;

/// Curves that a chart bears.
const MOST_CURVES: usize = 8;

/// Outputs of a flight over time.
pub struct Recorded {
    outputs: Vec<Watched>,
    /// One look is kept of so many.
    every: usize,
    looks: usize,
    /// s.
    times: Vec<f64>,
    /// Of each output at each time.
    values: Vec<Vec<f64>>,
}

/// Pitch and load factor of what moves as a whole, and the deflections of the first stations; modes where there is nothing of these.
pub fn usual(variables: &VariableTable, support: Support) -> Vec<Watched> {
    let motion = |output: &Watched| {
        support == Support::Free && ["attitude.pitch", "load_factor.z"].contains(&output.name.as_str())
    };
    let is_up = |output: &Watched| output.name.starts_with("deflection.") && output.name.ends_with(".up");
    let deflections = Watched::all(variables).filter(is_up).take(STATIONS);
    let chosen: Vec<Watched> = Watched::all(variables).filter(motion).chain(deflections).collect();
    if !chosen.is_empty() {
        return chosen;
    }
    Watched::all(variables).filter(|output| output.name.starts_with("modal.q[")).take(STATIONS).collect()
}

impl Recorded {
    /// Nothing yet, of a flight of about so many looks.
    pub fn new(outputs: Vec<Watched>, looks: f64) -> Self {
        let (every, values) =
            ((looks / MOST_DRAWN as f64).ceil().max(1.0) as usize, vec![Vec::new(); outputs.len()]);
        Recorded { outputs, every, looks: 0, times: Vec::new(), values }
    }

    /// Takes what is there at a time, s.
    pub fn look(&mut self, time: f64, instant: &Instant) {
        if self.looks.is_multiple_of(self.every) {
            self.times.push(time);
            for (values, output) in self.values.iter_mut().zip(&self.outputs) {
                values.push(output.slot.number(instant));
            }
        }
        self.looks += 1;
    }

    /// The outputs above the inputs that a schedule gives, as a drawing that stands alone; where the flight ended before it, it
    /// says so.
    pub fn plot(
        &self,
        schedule: &Schedule,
        variables: &VariableTable,
        model: &ReducedModel,
        settings: &Settings,
        is_whole: bool,
    ) -> String {
        let [start, end] = [schedule.start(), schedule.end()];
        let shown = Window::new(start, if end > start { end } else { start + 1.0 });
        let last = self.times.last().filter(|_| !is_whole);
        let marks: Vec<Mark> =
            last.map(|last| Mark::Vertical(*last, "ended".to_owned())).into_iter().collect();
        let chart = |Panel { quantity, unit, curves }: Panel| Chart {
            title: if let [only] = curves.as_slice() { only.label.clone() } else { quantity.clone() },
            x: Axis::new("time (s)", shown),
            y: Axis::new(
                quantity + &unit,
                Window::around(curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1))),
            ),
            curves,
            marks: marks.clone(),
            frame: None,
        };
        let charts: Vec<Chart> = self.panels(schedule, variables, model).into_iter().map(chart).collect();
        stacked(&format!("{}: {}", model.name, condition(model, settings)), &charts)
    }

    fn panels(&self, schedule: &Schedule, variables: &VariableTable, model: &ReducedModel) -> Vec<Panel> {
        let mut panels = Vec::new();
        for (output, values) in self.outputs.iter().zip(&self.values) {
            let points = self.times.iter().copied().zip(values.iter().copied()).collect();
            let quantity = output.name.split('.').next().unwrap_or_default();
            let curve = Curve { label: output.name.clone(), points };
            Panel::add(&mut panels, quantity, &unit(&output.name, variables), curve);
        }
        for (name, points) in schedule.histories(model) {
            Panel::add(
                &mut panels,
                "input",
                &unit(name, variables),
                Curve { label: name.to_owned(), points },
            );
        }
        panels
    }
}

/// Curves of one quantity and unit.
struct Panel {
    quantity: String,
    /// In brackets behind a blank; empty where there is none.
    unit: String,
    curves: Vec<Curve>,
}

impl Panel {
    /// A curve comes to the others of its kind, unless they are too many.
    fn add(panels: &mut Vec<Panel>, quantity: &str, unit: &str, curve: Curve) {
        let is_place = |panel: &&mut Panel| {
            panel.quantity == quantity && panel.unit == unit && panel.curves.len() < MOST_CURVES
        };
        match panels.iter_mut().find(is_place) {
            Some(panel) => panel.curves.push(curve),
            None => {
                panels.push(Panel {
                    quantity: quantity.to_owned(),
                    unit: unit.to_owned(),
                    curves: vec![curve],
                });
            }
        }
    }
}

fn unit(name: &str, variables: &VariableTable) -> String {
    let unit = variables.named(name).and_then(|variable| variable.unit);
    unit.map_or(String::new(), |unit: Unit| format!(" ({})", unit.name()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_of_a_kind_share_a_chart_as_long_as_it_bears_them() {
        let mut panels = Vec::new();
        let mut add = |quantity: &str, unit: &str, label: &str| {
            let curve = Curve { label: label.to_owned(), points: vec![(0.0, 1.0)] };
            Panel::add(&mut panels, quantity, unit, curve);
        };
        add("deflection", " (m)", "right");
        add("input", " (rad)", "elevator");
        add("deflection", " (m)", "left");
        add("deflection", " (rad)", "twist");
        (0..MOST_CURVES).for_each(|_| add("deflection", " (m)", "more"));
        let counts: Vec<usize> = panels.iter().map(|panel| panel.curves.len()).collect();
        assert_eq!(counts, [MOST_CURVES, 1, 1, 2]);
    }
}
