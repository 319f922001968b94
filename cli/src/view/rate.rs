//! How many poses a second there are of a flight, and how many there may be in all.

use super::recording::POSE;

/// Poses a second.
const LEAST: f64 = 0.1;
const MOST: f64 = 1000.0;

/// Numbers that are kept at once: a gigabyte.
const MOST_NUMBERS: f64 = 1.2e8;

/// Colours of a section or strip.
const COLOURS: usize = 9;

/// Flights of more frames than can be kept.
#[derive(Debug, PartialEq, thiserror::Error)]
#[error("found {frames:.0} frames with --rate {rate}, allowed are {most:.0} of this aircraft: {}", self.fitting())]
pub struct TooManyFrames {
    rate: f64,
    frames: f64,
    most: f64,
}

impl TooManyFrames {
    /// The rate at which frames would be as many as allowed, if there is one, or how long they may last.
    fn fitting(&self) -> String {
        let rate = (10.0 * self.rate * self.most / self.frames).floor() / 10.0;
        let shorter = format!("a flight of {:.0} s would fit", (self.most / self.rate).floor());
        if rate < LEAST { shorter } else { format!("--rate {rate} or {shorter}") }
    }
}

/// Reads a rate.
pub fn parse(text: &str) -> Result<f64, String> {
    let rate = text.parse().ok().filter(|rate| (LEAST..=MOST).contains(rate));
    rate.ok_or_else(|| format!("allowed is a number of poses a second, {LEAST} to {MOST}"))
}

/// Makes sure that so long a flight, s, of so many sections, those of all levels, can be kept.
///
/// # Errors
/// When it cannot.
pub fn check(rate: f64, duration: f64, sections: usize) -> Result<(), TooManyFrames> {
    let frames = duration * rate + 1.0;
    let most = (MOST_NUMBERS / (sections * (POSE + COLOURS)) as f64).floor();
    if frames <= most { Ok(()) } else { Err(TooManyFrames { rate, frames, most }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_numbers() {
        assert_eq!(parse("25"), Ok(25.0));
        assert!(["0", "-1", "1e9", "nan", "x"].iter().all(|wrong| parse(wrong).is_err()));
    }

    #[test]
    fn too_many_frames_are_refused_with_what_would_fit() {
        assert_eq!(check(50.0, 60.0, 202), Ok(()));
        let told = |duration| check(50.0, duration, 202).unwrap_err().to_string();
        assert!(
            told(2e3)
                .ends_with("allowed are 37128 of this aircraft: --rate 18.5 or a flight of 742 s would fit")
        );
        assert!(told(1e9).ends_with("of this aircraft: a flight of 742 s would fit"));
    }
}
