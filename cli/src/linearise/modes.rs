//! The modes of a linear model by their names, and its flying qualities: as text, and as they stand in files
//! [theory: stability.modes, linearisation.load-factor-slope].

use std::f64::consts::{LN_2, TAU};

use flexible_aircraft::LinearModel;
use flexible_aircraft::aircraft::TrimRole;
use flexible_aircraft::plant::Unknown;
use flexible_aircraft::stability::{Complex, FlightMode, FlightModes};
use flexible_aircraft::structure::ReducedModel;
use serde_json::{Value, json};

use crate::answer::Answer;
use crate::numbers::{Plain, aligned, fixed};

/// Less than this of the rigid motion that takes part is rounding.
const ASIDE: f64 = 1e-6;

/// States of the structure that take part less than this do not lead a mode.
const LEADS: f64 = 0.1;

/// Other roots that are damped more than this share of critically and decay faster than this (1/s) are not told: most are the wake's.
const WELL_DAMPED: f64 = 0.5;
const FAST: f64 = 1.0;

/// States on which nothing depends, which no mode has.
const ALONE: [&str; 3] = ["position.north", "position.east", "attitude.yaw"];

/// Roots at rest belong to what nothing depends on.
const REST: f64 = 1e-6;

/// Modes of a flight with what is read of them.
pub struct Modes {
    found: FlightModes,
    /// Names of the states that the motion has.
    states: Vec<String>,
    qualities: Qualities,
}

/// Numbers by which the handling of aircraft is judged [theory: linearisation.load-factor-slope].
struct Qualities {
    /// n/α, 1/rad.
    load_factor_slope: Option<f64>,
    /// ω²/(n/α) of the short period, 1/s².
    control_anticipation: Option<f64>,
    /// −1/λ of the roll, s.
    roll_time_constant: Option<f64>,
}

impl Qualities {
    fn of(model: &ReducedModel, linear: &LinearModel, modes: &FlightModes) -> Self {
        let pitch = model.controls.iter().find(|control| control.role == Some(TrimRole::Pitch));
        let load_factor_slope = pitch.and_then(|control| linear.load_factor_slope(&control.name));
        let short_period = modes.named("short period").map(|mode| mode.eigenvalue().norm_sqr());
        let control_anticipation = short_period.zip(load_factor_slope).map(|(square, slope)| square / slope);
        let roll_time_constant = modes.named("roll").map(|mode| -1.0 / mode.eigenvalue().re);
        Qualities { load_factor_slope, control_anticipation, roll_time_constant }
    }

    /// Name, number and unit of each that there is.
    fn named(&self) -> impl Iterator<Item = (&'static str, f64, &'static str)> {
        let all = [
            ("load factor by angle of attack, n/α", self.load_factor_slope, "1/rad"),
            ("control anticipation, ω²/(n/α) of the short period", self.control_anticipation, "1/s²"),
            ("roll time constant", self.roll_time_constant, "s"),
        ];
        all.into_iter().filter_map(|(name, number, unit)| Some((name, number?, unit)))
    }
}

impl Modes {
    /// Of a linear model that is not reduced.
    pub fn new(model: &ReducedModel, linear: &LinearModel, found: FlightModes) -> Self {
        let states = linear.states.iter().map(|state| state.name.clone());
        let states = states.filter(|name| !ALONE.contains(&name.as_str())).take(found.unknowns.len());
        Modes { states: states.collect(), qualities: Qualities::of(model, linear, &found), found }
    }

    /// A table of the modes, then the flying qualities; `eigenvalues` are all of the model: slow or lightly damped ones that belong to none
    /// of the modes are told after them.
    pub fn text(&self, eigenvalues: &[Complex<f64>]) -> String {
        let heads = [
            "mode",
            "family",
            "eigenvalue (1/s)",
            "frequency (rad/s)",
            "damping ratio",
            "period (s)",
            "time (s)",
            "led by",
        ];
        let mut lines = vec![heads.map(str::to_owned).to_vec()];
        lines.extend(self.found.modes.iter().map(|mode| self.line(mode)));
        let others = self.others(eigenvalues);
        lines.extend(others.iter().map(|&root| {
            let mut line = vec!["other".to_owned(), none()];
            line.extend(cells(root));
            line.push(none());
            line
        }));
        let mut text = aligned(&lines);
        if self.found.modes.iter().any(|mode| mode.is_quasi_steady) {
            text += "\n* with an inflow that follows the motion at once: with its own the mode is lost among the wake's\n";
        }
        let qualities: Vec<_> = self.qualities.named().collect();
        if !qualities.is_empty() {
            text += "\n";
        }
        for (name, number, unit) in qualities {
            text += &format!("{name}: {} {unit}\n", fixed(number, 4));
        }
        text
    }

    fn line(&self, mode: &FlightMode) -> Vec<String> {
        let mark = if mode.is_quasi_steady { "*" } else { "" };
        let mut line = vec![format!("{}{mark}", mode.name), family(mode).unwrap_or("–").to_owned()];
        line.extend(cells(mode.eigenvalue()));
        let leading = self.leading(mode).join(", ");
        line.push(if leading.is_empty() { none() } else { leading });
        line
    }

    /// Eigenvalues of none of the modes, slowest first, that decay slowly or swing.
    fn others(&self, eigenvalues: &[Complex<f64>]) -> Vec<Complex<f64>> {
        let is_named = |root: &Complex<f64>| {
            let at = |mode: &FlightMode| (mode.eigenvalue() - root).norm() < 1e-4 * (1.0 + root.norm());
            self.found.modes.iter().any(at)
        };
        let is_told = |root: &Complex<f64>| {
            let swings = damping_ratio(*root).is_some_and(|ratio| ratio < WELL_DAMPED);
            root.norm() > REST && (swings || root.norm() < FAST)
        };
        let mut others: Vec<_> = eigenvalues
            .iter()
            .filter(|root| root.im >= 0.0 && is_told(root) && !is_named(root))
            .copied()
            .collect();
        others.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        others
    }

    /// Names of the natural modes that take part most, by q and q̇ together.
    fn leading(&self, mode: &FlightMode) -> Vec<String> {
        let unknowns = self.found.unknowns.iter().zip(&mode.participations);
        let share = |coordinate: usize| -> f64 {
            let is_of = |unknown: &Unknown| matches!(unknown, Unknown::Coordinate(other) | Unknown::CoordinateRate(other) if *other == coordinate);
            unknowns.clone().filter(|(unknown, _)| is_of(unknown)).map(|(_, share)| share).sum()
        };
        let coordinates =
            self.found.unknowns.iter().enumerate().filter_map(|(place, unknown)| match unknown {
                Unknown::Coordinate(coordinate) => Some((place, *coordinate)),
                _ => None,
            });
        let mut leading: Vec<(f64, usize)> = coordinates
            .map(|(place, coordinate)| (share(coordinate), place))
            .filter(|(share, _)| *share > LEADS)
            .collect();
        leading.sort_by(|a, b| b.0.total_cmp(&a.0));
        leading.truncate(2);
        leading.into_iter().map(|(_, place)| self.states[place].clone()).collect()
    }

    /// As they stand in a JSON file.
    pub fn json(&self) -> Value {
        let mode = |mode: &FlightMode| {
            let root = mode.eigenvalue();
            let shares = self.states.iter().zip(&mode.participations);
            let participations: serde_json::Map<String, Value> =
                shares.map(|(name, share)| (name.clone(), json!(share))).collect();
            json!({
                "name": mode.name.to_string(),
                "family": family(mode),
                "eigenvalue": [root.re, root.im],
                "frequency": root.norm(),
                "damping_ratio": damping_ratio(root),
                "quasi_steady": mode.is_quasi_steady,
                "participations": participations,
            })
        };
        let modes: Vec<Value> = self.found.modes.iter().map(mode).collect();
        let Qualities { load_factor_slope, control_anticipation, roll_time_constant } = self.qualities;
        let flying_qualities = json!({
            "load_factor_per_alpha": load_factor_slope,
            "control_anticipation": control_anticipation,
            "roll_time_constant": roll_time_constant,
        });
        json!({ "modes": modes, "flying_qualities": flying_qualities })
    }

    /// As arrays.
    pub fn answer(&self) -> Answer {
        let modes = &self.found.modes;
        let eigenvalues = modes.iter().map(|mode| [mode.eigenvalue().re, mode.eigenvalue().im]).collect();
        let number = |number: Option<f64>| Answer::Number(number.unwrap_or(f64::NAN));
        let Qualities { load_factor_slope, control_anticipation, roll_time_constant } = self.qualities;
        Answer::named([
            ("names", Answer::Texts(modes.iter().map(|mode| mode.name.to_string()).collect())),
            (
                "families",
                Answer::Texts(modes.iter().map(|mode| family(mode).unwrap_or_default().to_owned()).collect()),
            ),
            ("eigenvalues", Answer::Complex { rows: modes.len(), columns: 1, values: eigenvalues }),
            (
                "damping_ratios",
                Answer::Numbers(
                    modes.iter().map(|mode| damping_ratio(mode.eigenvalue()).unwrap_or(f64::NAN)).collect(),
                ),
            ),
            ("quasi_steady", Answer::Truths(modes.iter().map(|mode| mode.is_quasi_steady).collect())),
            ("load_factor_per_alpha", number(load_factor_slope)),
            ("control_anticipation", number(control_anticipation)),
            ("roll_time_constant", number(roll_time_constant)),
        ])
    }

    /// As a table of comma-separated values.
    pub fn table(&self) -> String {
        let mut text = format!("mode,family,{COLUMNS},quasi_steady\n");
        for mode in &self.found.modes {
            let (family, cells) = (family(mode).unwrap_or_default(), cells_of(mode.eigenvalue()));
            text += &format!("{},{family},{cells},{}\n", mode.name, mode.is_quasi_steady);
        }
        text
    }
}

/// Heads of [`cells_of`].
pub const COLUMNS: &str = "real_part,imaginary_part,frequency,damping_ratio";

/// Real and imaginary part (1/s), frequency (rad/s) and damping ratio of a root as comma-separated values; real roots have no ratio.
pub fn cells_of(root: Complex<f64>) -> String {
    let ratio = damping_ratio(root).map_or(String::new(), |ratio| Plain(ratio).to_string());
    format!("{},{},{},{ratio}", Plain(root.re), Plain(root.im), Plain(root.norm()))
}

/// Symmetric or antisymmetric, where the mode is one of both.
pub fn family(mode: &FlightMode) -> Option<&'static str> {
    match mode.share_aside? {
        share if share < ASIDE => Some("symmetric"),
        share if share > 1.0 - ASIDE => Some("antisymmetric"),
        _ => None,
    }
}

/// Of critical damping, of a root that swings.
fn damping_ratio(root: Complex<f64>) -> Option<f64> {
    (root.im != 0.0).then(|| -root.re / root.norm())
}

fn none() -> String {
    "–".to_owned()
}

/// Eigenvalue, frequency, damping ratio, period, time to half or double.
fn cells(root: Complex<f64>) -> [String; 5] {
    let Complex { re, im } = root;
    let [eigenvalue, period, damping] = match damping_ratio(root) {
        Some(ratio) => {
            let eigenvalue = format!("{} ± {}i", fixed(re, 5), fixed(im, 5));
            [eigenvalue, fixed(TAU / im, 3), fixed(ratio, 4)]
        }
        None => [fixed(re, 5), none(), none()],
    };
    let time = LN_2 / re.abs();
    let time = match re {
        _ if time > 1e6 => none(),
        re if re < 0.0 => format!("{} to half", fixed(time, 3)),
        _ => format!("{} to double", fixed(time, 3)),
    };
    [eigenvalue, fixed(root.norm(), 4), damping, period, time]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_is_told_as_people_know_it() {
        let pair = Complex::new(-0.5, 1.2);
        assert_eq!(cells(pair), ["−0.50000 ± 1.20000i", "1.3000", "0.3846", "5.236", "1.386 to half"]);
        let growing = Complex::new(0.1, 0.0);
        assert_eq!(cells(growing), ["0.10000", "0.1000", "–", "–", "6.931 to double"]);
        assert_eq!(cells(Complex::new(0.0, 0.0))[4], "–");
        assert_eq!(cells_of(pair), format!("-0.5,1.2,1.3,{}", 0.5 / 1.3));
        assert_eq!(cells_of(growing), "0.1,0,0.1,");
    }
}
