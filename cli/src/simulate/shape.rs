//! Histories of one input that are built in: pulses, sines, sweeps of frequency; as text, `KIND:AMPLITUDE[@START[:…]]`.

use std::f64::consts::TAU;
use std::str::{FromStr, Split};

/// When an input begins to act unless the text says otherwise, s.
const START: f64 = 1.0;

/// More pulses than any manoeuvre has.
const MOST_PULSES: usize = 16;

/// What one input does over time; 0 before it begins and after it ends.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Pulses of alternating sign, the first of which has the sign of the amplitude. A step is one that never ends.
    Pulses {
        amplitude: f64,
        /// s.
        start: f64,
        /// Of each, s.
        lengths: Vec<f64>,
    },
    /// A sine whose frequency goes from one to another by the same factor in equal times, and stays where both are the same.
    Wave {
        amplitude: f64,
        /// s.
        start: f64,
        /// s; infinite where it never ends.
        length: f64,
        /// At the start and at the end, Hz.
        frequencies: [f64; 2],
    },
}

/// What is wrong with the text of a shape.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShapeError {
    #[error("found `{0}` without an amplitude, allowed is SHAPE:AMPLITUDE, as in 2311:0.05 or step:0.05")]
    NoAmplitude(String),
    #[error(
        "found the shape `{0}`, allowed are up to {MOST_PULSES} digits of 1 to 9, as in 2311 or 3211, and step, pulse, doublet, \
         sine, sweep"
    )]
    Unknown(String),
    #[error("found `{found}` as {what}, allowed is {allowed}")]
    Number { found: String, what: &'static str, allowed: &'static str },
    #[error("found a sweep from {0} Hz without an end, allowed is FROM:TO, as in sweep:0.02@1:20:0.1:5")]
    NoEnd(f64),
    #[error("found `{found}` behind the last number, allowed is {form}")]
    TooMany { found: String, form: &'static str },
}

impl Shape {
    /// In the unit of the input, at a time, s; where it jumps, what it jumps to.
    pub fn value(&self, time: f64) -> f64 {
        match self {
            Shape::Pulses { amplitude, lengths, .. } => {
                let begun = self.edges().iter().filter(|edge| **edge <= time).count();
                match begun {
                    0 => 0.0,
                    ended if ended > lengths.len() => 0.0,
                    odd if odd % 2 == 1 => *amplitude,
                    _ => -amplitude,
                }
            }
            Shape::Wave { .. } if !self.is_curved_from(time) => 0.0,
            Shape::Wave { .. } => self.swing(time),
        }
    }

    /// In the unit of the input.
    pub fn amplitude(&self) -> f64 {
        match self {
            Shape::Pulses { amplitude, .. } | Shape::Wave { amplitude, .. } => *amplitude,
        }
    }

    /// When it jumps, begins or ends, s, ascending.
    pub fn edges(&self) -> Vec<f64> {
        let ends = |start: f64, lengths: &[f64]| {
            let mut elapsed = 0.0;
            let mut edges = vec![start];
            edges.extend(lengths.iter().map(|length| {
                elapsed += length;
                sum(start, elapsed)
            }));
            edges.retain(|edge| edge.is_finite());
            edges
        };
        match self {
            Shape::Pulses { start, lengths, .. } => ends(*start, lengths),
            Shape::Wave { start, length, .. } => ends(*start, &[*length]),
        }
    }

    /// Whether it is no straight line between this time, s, and the next edge.
    pub fn is_curved_from(&self, time: f64) -> bool {
        match self {
            Shape::Pulses { .. } => false,
            Shape::Wave { start, length, .. } => (*start..sum(*start, *length)).contains(&time),
        }
    }

    /// How fast it changes between two times, s, with no edge between them: the slope of the chord, per second.
    pub fn slope(&self, from: f64, to: f64) -> f64 {
        if self.is_curved_from(from) && from < to {
            (self.swing(to) - self.swing(from)) / (to - from)
        } else {
            0.0
        }
    }

    /// The highest frequency of a wave, Hz.
    pub fn highest_frequency(&self) -> Option<f64> {
        match self {
            Shape::Pulses { .. } => None,
            Shape::Wave { frequencies: [first, last], .. } => Some(first.max(*last)),
        }
    }

    /// A wave as if it had no end: A sin 2π ∫ f dt with f = f₀ (f₁/f₀)^(t/T).
    fn swing(&self, time: f64) -> f64 {
        let Shape::Wave { amplitude, start, length, frequencies: [first, last] } = self else { return 0.0 };
        let elapsed = time - start;
        let growth = elapsed / length * (last / first).ln();
        // (e^x - 1)/x, which is 1 of a frequency that stays.
        let mean = if growth == 0.0 { 1.0 } else { growth.exp_m1() / growth };
        amplitude * (TAU * first * elapsed * mean).sin()
    }
}

/// A sum of times as people write it: 1 + 6 · 0.7 is 5.199999999999999 otherwise.
fn sum(start: f64, elapsed: f64) -> f64 {
    const PER_SECOND: f64 = 1e9;
    ((start + elapsed) * PER_SECOND).round() / PER_SECOND
}

impl FromStr for Shape {
    type Err = ShapeError;

    fn from_str(text: &str) -> Result<Self, ShapeError> {
        let (kind, numbers) = text.split_once(':').ok_or_else(|| ShapeError::NoAmplitude(text.to_owned()))?;
        let (amplitude, behind) =
            numbers.split_once('@').map_or((numbers, None), |(amplitude, behind)| (amplitude, Some(behind)));
        let mut behind = Numbers(behind.map(|behind| behind.split(':')));
        let amplitude = number(amplitude, "the amplitude", FINITE)?;
        let start = behind.next("the start", SECONDS)?.unwrap_or(START);
        let pulses = |lengths| Shape::Pulses { amplitude, start, lengths };
        let (shape, form) = match kind {
            "step" => (pulses(vec![f64::INFINITY]), "step:AMPLITUDE[@START]"),
            "pulse" => {
                let length = behind.next("the length", LENGTH)?.unwrap_or(1.0);
                (pulses(vec![length]), "pulse:AMPLITUDE[@START[:LENGTH]]")
            }
            "doublet" => {
                let length = behind.next("the length of each half", LENGTH)?.unwrap_or(1.0);
                (pulses(vec![length; 2]), "doublet:AMPLITUDE[@START[:LENGTH]]")
            }
            "sine" => {
                let frequencies = [behind.next("the frequency", FREQUENCY)?.unwrap_or(1.0); 2];
                let sine = Shape::Wave { amplitude, start, length: f64::INFINITY, frequencies };
                (sine, "sine:AMPLITUDE[@START[:FREQUENCY]]")
            }
            "sweep" => {
                let length = behind.next("the length", LENGTH)?.unwrap_or(20.0);
                let frequencies = behind.sweep()?;
                let sweep = Shape::Wave { amplitude, start, length, frequencies };
                (sweep, "sweep:AMPLITUDE[@START[:LENGTH[:FROM:TO]]]")
            }
            digits => {
                let digits = digits_of(digits).ok_or_else(|| ShapeError::Unknown(kind.to_owned()))?;
                let unit = behind.next("the unit time", LENGTH)?.unwrap_or(0.7);
                let lengths = digits.iter().map(|digit| f64::from(*digit) * unit).collect();
                (pulses(lengths), "DIGITS:AMPLITUDE[@START[:UNIT]]")
            }
        };
        behind.end(form)?;
        Ok(shape)
    }
}

/// The digits of a kind like `2311`.
fn digits_of(kind: &str) -> Option<Vec<u32>> {
    let is_some = (1..=MOST_PULSES).contains(&kind.len());
    let digits = kind.chars().map(|letter| letter.to_digit(10).filter(|digit| *digit > 0));
    digits.collect::<Option<Vec<u32>>>().filter(|_| is_some)
}

/// What a number has to be: in words, and whether it is.
type Allowed = (&'static str, fn(f64) -> bool);

const FINITE: Allowed = ("a finite number, in the unit of the input", f64::is_finite);
const SECONDS: Allowed = ("a finite number of seconds", f64::is_finite);
const LENGTH: Allowed =
    ("a finite number of seconds, greater than 0", |number| number.is_finite() && number > 0.0);
const FREQUENCY: Allowed =
    ("a finite frequency in Hz, greater than 0", |number| number.is_finite() && number > 0.0);

fn number(text: &str, what: &'static str, (allowed, is_allowed): Allowed) -> Result<f64, ShapeError> {
    let number = text.parse::<f64>().ok().filter(|number| is_allowed(*number));
    number.ok_or_else(|| ShapeError::Number { found: text.to_owned(), what, allowed })
}

/// What stands behind the `@`.
struct Numbers<'t>(Option<Split<'t, char>>);

impl Numbers<'_> {
    /// The next number, if there is one.
    fn next(&mut self, what: &'static str, allowed: Allowed) -> Result<Option<f64>, ShapeError> {
        let text = self.0.as_mut().and_then(Iterator::next);
        text.map(|text| number(text, what, allowed)).transpose()
    }

    /// The frequencies at both ends of a sweep, Hz: both are given, or none.
    fn sweep(&mut self) -> Result<[f64; 2], ShapeError> {
        let Some(first) = self.next("the frequency at the start", FREQUENCY)? else { return Ok([0.1, 5.0]) };
        let last = self.next("the frequency at the end", FREQUENCY)?.ok_or(ShapeError::NoEnd(first))?;
        Ok([first, last])
    }

    /// Nothing is left over.
    fn end(&mut self, form: &'static str) -> Result<(), ShapeError> {
        match self.0.as_mut().and_then(Iterator::next) {
            Some(found) => Err(ShapeError::TooMany { found: found.to_owned(), form }),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(text: &str) -> Shape {
        text.parse().unwrap()
    }

    #[test]
    fn digits_are_lengths_of_alternating_pulses_whose_edges_people_would_write() {
        for text in ["2311:0.05", "2311:0.05@1", "2311:0.05@1:0.7"] {
            let shape = shape(text);
            assert_eq!(shape.edges(), [1.0, 2.4, 4.5, 5.2, 5.9]);
            let values = [0.0, 0.999, 1.0, 2.399, 2.4, 4.5, 5.2, 5.899, 5.9, 100.0];
            let values = values.map(|time| shape.value(time));
            assert_eq!(values, [0.0, 0.0, 0.05, 0.05, -0.05, 0.05, -0.05, -0.05, 0.0, 0.0]);
        }
        assert_eq!(shape("3211:-1@-2:0.1").edges(), [-2.0, -1.7, -1.5, -1.4, -1.3]);
        assert_eq!(shape("3211:-1@-2:0.1").value(-2.0), -1.0);
    }

    #[test]
    fn steps_stay_pulses_end_and_doublets_go_both_ways() {
        let values = |text: &str| [0.9, 1.0, 1.5, 2.0, 2.5, 3.0, 1e9].map(|time| shape(text).value(time));
        assert_eq!(values("step:3"), [0.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0]);
        assert_eq!(values("pulse:3"), [0.0, 3.0, 3.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(values("pulse:3@1.5:1"), [0.0, 0.0, 3.0, 3.0, 0.0, 0.0, 0.0]);
        assert_eq!(values("doublet:3"), [0.0, 3.0, 3.0, -3.0, -3.0, 0.0, 0.0]);
        let edges = ["step:3@0.5", "pulse:3@0.5:0.25", "doublet:3@0.5:0.25"].map(|text| shape(text).edges());
        assert_eq!(edges, [vec![0.5], vec![0.5, 0.75], vec![0.5, 0.75, 1.0]]);
        assert_eq!(shape("pulse:3").slope(1.0, 2.0), 0.0);
        assert!(!shape("pulse:3").is_curved_from(1.0));
    }

    #[test]
    fn a_sine_goes_on_and_its_chords_meet_it() {
        let sine = shape("sine:2@1:0.5");
        assert_eq!(sine.edges(), [1.0]);
        for (time, expected) in [(0.9, 0.0), (1.0, 0.0), (1.5, 2.0), (2.5, -2.0), (101.5, 2.0)] {
            assert!((sine.value(time) - expected).abs() < 1e-12, "{time}: {}", sine.value(time));
        }
        assert!((sine.slope(1.0, 1.5) - 4.0).abs() < 1e-12);
        assert_eq!(sine.slope(0.5, 1.0), 0.0);
        assert_eq!(sine.highest_frequency(), Some(0.5));
    }

    /// Periods are counted by what changes sign: ∫ f dt = (f₁ - f₀) T/ln(f₁/f₀).
    #[test]
    fn a_sweep_goes_through_its_frequencies_by_equal_factors_in_equal_times() {
        let sweep = shape("sweep:0.02");
        assert_eq!(sweep, shape("sweep:0.02@1:20:0.1:5"));
        assert_eq!(sweep.edges(), [1.0, 21.0]);
        let step = 1e-4;
        let signs = (1..210_000).map(|index| sweep.value(step * f64::from(index)) >= 0.0);
        let signs: Vec<bool> = signs.collect();
        let crossings: Vec<f64> = (1..signs.len())
            .filter(|index| signs[*index] != signs[index - 1])
            .map(|index| step * (index as f64 + 1.0))
            .collect();
        let periods = 4.9 * 20.0 / 50.0_f64.ln();
        assert_eq!(crossings.len(), (2.0 * periods).floor() as usize);
        // Half a period of 0.1·50^(10/20) Hz in the middle.
        let middle = crossings.iter().position(|time| *time > 11.0).unwrap();
        let half = crossings[middle] - crossings[middle - 1];
        assert!((half * 2.0 * 0.1 * 50.0_f64.sqrt() - 1.0).abs() < 0.1, "{half}");
        assert_eq!((sweep.value(0.5), sweep.value(21.0)), (0.0, 0.0));
        // The last chord leads to where it would be, not to the 0 behind its end.
        assert!((sweep.slope(20.9999, 21.0) * 1e-4 + sweep.value(20.9999) - sweep.swing(21.0)).abs() < 1e-12);
        assert_eq!(sweep.highest_frequency(), Some(5.0));
    }

    #[test]
    fn a_sweep_from_a_frequency_to_itself_is_a_sine() {
        let [sweep, sine] = ["sweep:1@2:5:3:3", "sine:1@2:3"].map(shape);
        for time in [2.0, 2.1, 4.0, 6.99] {
            assert_eq!(sweep.value(time), sine.value(time));
        }
    }

    #[test]
    fn what_is_no_shape_is_told_with_what_is_allowed() {
        let kinds = "allowed are up to 16 digits of 1 to 9, as in 2311 or 3211, and step, pulse, doublet, sine, sweep";
        let length = "allowed is a finite number of seconds, greater than 0";
        for (text, expected) in [
            ("0.05", "found `0.05` without an amplitude, allowed is SHAPE:AMPLITUDE, as in 2311:0.05"),
            ("steps:1", &format!("found the shape `steps`, {kinds}")),
            ("2301:1", &format!("found the shape `2301`, {kinds}")),
            (":1", &format!("found the shape ``, {kinds}")),
            ("11111111111111111:1", &format!("found the shape `11111111111111111`, {kinds}")),
            ("step:", "found `` as the amplitude, allowed is a finite number, in the unit of the input"),
            ("step:inf", "found `inf` as the amplitude"),
            ("step:1@x", "found `x` as the start, allowed is a finite number of seconds"),
            ("step:1@", "found `` as the start"),
            ("step:1@1:2", "found `2` behind the last number, allowed is step:AMPLITUDE[@START]"),
            ("2311:1@1:0", &format!("found `0` as the unit time, {length}")),
            ("pulse:1@1:-1", &format!("found `-1` as the length, {length}")),
            ("doublet:1@1:NaN", &format!("found `NaN` as the length of each half, {length}")),
            ("sine:1@1:0", "found `0` as the frequency, allowed is a finite frequency in Hz, greater than 0"),
            ("sweep:1@1:20:0:5", "found `0` as the frequency at the start"),
            ("sweep:1@1:20:0.1", "found a sweep from 0.1 Hz without an end, allowed is FROM:TO"),
            ("sweep:1@1:20:0.1:5:1", "found `1` behind the last number, allowed is sweep:AMPLITUDE[@START"),
        ] {
            let error = text.parse::<Shape>().unwrap_err().to_string();
            assert!(error.contains(expected), "{text}: {error}");
        }
    }
}
