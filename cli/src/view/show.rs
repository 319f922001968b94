//! A show: frames at equal times with what is said of them, as the page reads it.

use serde_json::{Value, json};

use crate::watched::Watched;

use super::data::Data;
use super::gust::Gust;
use super::recording::{POSE, Place, Recording};
use super::scene::short;

/// How far places may be off, m, and how far parts of quaternions, of sections and of the body: at the aircraft's ends a part of a millimetre.
const PLACE: f64 = 2e-4;
const TURN: f64 = 2e-5;
const BODY_TURN: f64 = 5e-6;

/// Of angles of controls, rad; of colours and charts, in parts of their range.
const ANGLE: f64 = 1e-5;
const COLOUR: f64 = 2e-3;
const CHART: f64 = 1e-4;

/// Winds that blow less, m/s, are not shown.
const CALM: f64 = 1e-9;

/// What a show is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Flight,
    Mode,
    Trim,
    Root,
}

/// A show.
pub struct Show {
    pub kind: Kind,
    /// Unlike all others.
    pub name: String,
    /// Of fidelity.
    pub level: &'static str,
    /// Labels and what is said under them.
    pub facts: Vec<(String, String)>,
    /// s.
    pub start: f64,
    /// Between frames, s.
    pub step: f64,
    pub loops: bool,
    pub recording: Recording,
    pub charted: Vec<Watched>,
    pub gust: Option<Gust>,
    /// The show that is a ghost beside this one.
    pub ghost: Option<String>,
}

impl Kind {
    pub fn name(self) -> &'static str {
        match self {
            Kind::Flight => "flight",
            Kind::Mode => "mode",
            Kind::Trim => "trim",
            Kind::Root => "root",
        }
    }
}

/// Shows as the page reads them, their numbers added to the data. Flights share the ranges of their colours.
pub fn all(shows: &[Show], data: &mut Data) -> Vec<Value> {
    shows.iter().map(|show| show.json(shows, data)).collect()
}

impl Show {
    fn json(&self, all: &[Show], data: &mut Data) -> Value {
        let Recording { frames, poses, body, controls, thrust, wind, .. } = &self.recording;
        let tolerances = |turn: f64| [PLACE, PLACE, PLACE, turn, turn, turn, turn];
        let sections = poses.len() / frames.max(&1) / POSE;
        let count = |values: &[f64]| values.len() / frames.max(&1);
        let matrix = |data: &mut Data, values: &[f64], tolerances: &[f64]| {
            let mut matrix = data.matrix(values, tolerances);
            matrix["rows"] = json!(frames);
            matrix
        };
        let mut value = json!({
            "kind": self.kind.name(),
            "name": self.name,
            "level": self.level,
            "facts": self.facts,
            "start": self.start,
            "step": self.step,
            "count": frames,
            "loops": self.loops,
            "poses": matrix(data, poses, &tolerances(TURN).repeat(sections)),
            "body": matrix(data, body, &tolerances(BODY_TURN)),
            "controls": matrix(data, controls, &vec![ANGLE; count(controls)]),
            "thrust": matrix(data, thrust, &vec![of_range(thrust, CHART); count(thrust)]),
        });
        value["colours"] = self.colours(all, data);
        value["charts"] = self.charts(data);
        if wind.iter().any(|part| part.abs() > CALM) {
            let outputs = matrix(data, wind, &[of_range(wind, CHART); 3]);
            value["wind"] = json!({ "outputs": outputs });
        }
        if let Some(gust) = &self.gust {
            value["gust"] = gust.json();
        }
        if let Some(ghost) = &self.ghost {
            value["ghost"] = json!(ghost);
        }
        value
    }

    fn colours(&self, all: &[Show], data: &mut Data) -> Value {
        let frames = self.recording.frames.max(1);
        let colour = |(quantity, values): &(super::recording::Quantity, Vec<f64>)| {
            let alike = all.iter().filter(|other| other.kind == self.kind && self.kind == Kind::Flight);
            let ranges = alike.chain([self]).filter_map(|show| show.recording.range(quantity.name));
            let [low, high] = ranges
                .reduce(|[low, high], [other_low, other_high]| [low.min(other_low), high.max(other_high)])
                .unwrap_or_default();
            let columns = values.len() / frames;
            json!({
                "name": quantity.name,
                "label": quantity.label,
                "unit": quantity.unit,
                "on": match quantity.place { Place::Strips => "strips", Place::Sections => "sections" },
                "min": short(low),
                "max": short(high),
                "values": data.matrix(values, &vec![share(low, high, COLOUR); columns]),
            })
        };
        Value::Array(self.recording.colours.iter().map(colour).collect())
    }

    fn charts(&self, data: &mut Data) -> Value {
        let chart = |(watched, values): (&Watched, &Vec<f64>)| {
            json!({
                "name": watched.name,
                "unit": watched.unit,
                "label": watched.name,
                "values": data.matrix(values, &[of_range(values, CHART)]),
            })
        };
        Value::Array(self.charted.iter().zip(&self.recording.charts).map(chart).collect())
    }
}

/// A share of the range of some numbers.
fn of_range(values: &[f64], part: f64) -> f64 {
    let (low, high) = values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| (low.min(value), high.max(value)));
    share(low, high, part)
}

/// A share of a range; where it has no width, the rounding of its ends.
fn share(low: f64, high: f64, part: f64) -> f64 {
    const ROUNDING: f64 = 1e-6;
    let least = ROUNDING * low.abs().max(high.abs());
    let share = (part * (high - low)).max(least);
    if share.is_finite() && share > 0.0 { share } else { f64::MIN_POSITIVE.sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_shares_of_a_range_and_never_nothing() {
        assert_eq!(of_range(&[1.0, 3.0, 2.0], 1e-3), 2e-3);
        assert!((of_range(&[5.0, 5.0], 1e-3) - 5e-6).abs() < 1e-15);
        assert!(of_range(&[0.0], 1e-3) > 0.0 && of_range(&[], 1e-3) > 0.0);
    }
}
