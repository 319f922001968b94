//! What a flight leaves of an output: one number [theory: sweeps.reductions].

/// How the values of an output over a flight become one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reduction {
    Max,
    Min,
    /// Root of the mean square over time.
    Rms,
    /// The last value.
    End,
    /// When it was greatest, s: the first time.
    TimeOfMax,
}

impl Reduction {
    pub const ALL: [(&str, Reduction); 5] = [
        ("max", Reduction::Max),
        ("min", Reduction::Min),
        ("rms", Reduction::Rms),
        ("end", Reduction::End),
        ("time_of_max", Reduction::TimeOfMax),
    ];

    /// As it is written in files and in names of columns.
    pub fn name(self) -> &'static str {
        let named = Reduction::ALL.iter().find(|(_, reduction)| *reduction == self);
        named.map_or("", |(name, _)| name)
    }

    /// All of them, for people.
    pub fn names() -> String {
        Reduction::ALL.map(|(name, _)| format!("\"{name}\"")).join(", ")
    }
}

/// What has been seen of an output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// With its time, s.
    greatest: (f64, f64),
    least: f64,
    /// ∫ y² dt.
    square: f64,
    first: f64,
    /// Time, s, and value.
    last: (f64, f64),
}

impl Seen {
    /// At a first look, at a time, s.
    pub fn first(time: f64, value: f64) -> Self {
        Seen { greatest: (value, time), least: value, square: 0.0, first: time, last: (time, value) }
    }

    /// At a later one; between two the square runs straight.
    pub fn look(&mut self, time: f64, value: f64) {
        if value > self.greatest.0 {
            self.greatest = (value, time);
        }
        self.least = self.least.min(value);
        let (before, last) = self.last;
        self.square += 0.5 * (time - before) * (last * last + value * value);
        self.last = (time, value);
    }

    pub fn reduced(&self, reduction: Reduction) -> f64 {
        let (end, last) = self.last;
        match reduction {
            Reduction::Max => self.greatest.0,
            Reduction::Min => self.least,
            Reduction::Rms if end > self.first => (self.square / (end - self.first)).sqrt(),
            Reduction::Rms => last.abs(),
            Reduction::End => last,
            Reduction::TimeOfMax => self.greatest.1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_has_the_greatest_least_and_mean_square_that_it_has() {
        let step = 1e-3;
        let at = |n: u32| (step * f64::from(n), (step * f64::from(n) * std::f64::consts::TAU).sin());
        let mut seen = Seen::first(0.0, 0.0);
        for (time, value) in (1..=1000).map(at) {
            seen.look(time, value);
        }
        let of = |reduction| seen.reduced(reduction);
        assert_eq!((of(Reduction::Max), of(Reduction::TimeOfMax)), (1.0, 0.25));
        assert!((of(Reduction::Min) + 1.0).abs() < 1e-15 && of(Reduction::End).abs() < 1e-12);
        // Over a period the trapezoidal rule is exact for a sine squared.
        assert!((of(Reduction::Rms) - 0.5_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn looks_count_by_the_time_between_them() {
        let mut seen = Seen::first(1.0, 2.0);
        seen.look(2.0, 2.0);
        seen.look(2.0, 0.0);
        seen.look(5.0, 0.0);
        assert_eq!(seen.reduced(Reduction::Rms), 1.0);
        assert_eq!(Seen::first(0.0, -3.0).reduced(Reduction::Rms), 3.0);
    }

    #[test]
    fn every_reduction_has_its_name() {
        assert_eq!(
            Reduction::ALL.map(|(_, reduction)| reduction.name()),
            Reduction::ALL.map(|(name, _)| name)
        );
    }
}
