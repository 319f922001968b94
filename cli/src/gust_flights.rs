//! Many flights of one aircraft that differ in the gust alone, on all cores.

use std::fmt;
use std::sync::Arc;

use flexible_aircraft::air::GustSettings;
use flexible_aircraft::flight::{Settings, Simulation, SimulationError};
use flexible_aircraft::structure::ReducedModel;
use rayon::prelude::*;

use crate::numbers::Plain;
use crate::progress::Audience;
use crate::simulate::schedule::Schedule;

/// More looks than anybody needs: hours in steps of 10 ms.
const MOST_LOOKS: f64 = 1e6;

/// Too many looks at the flights.
#[derive(Debug, PartialEq, thiserror::Error)]
#[error(
    "--step: found {} s, which makes {looks:.0} looks in {flights} flight{} of {} s, allowed are {MOST_LOOKS} at most",
    Plain(*step),
    if *flights == 1 { "" } else { "s" },
    Plain(*duration)
)]
pub struct TooManyLooks {
    step: f64,
    duration: f64,
    flights: usize,
    looks: f64,
}

/// What all flights have in common.
pub struct GustFlights<'s> {
    model: &'s Arc<ReducedModel>,
    settings: &'s Settings,
    schedule: &'s Schedule,
    /// Between two looks, s.
    step: f64,
    audience: Audience,
}

/// Flights that failed.
#[derive(Clone, Debug, PartialEq)]
pub struct Failures {
    /// What was flown and why it had to end.
    failed: Vec<(String, SimulationError)>,
    /// How many flights there were.
    flights: usize,
}

impl<'s> GustFlights<'s> {
    /// Flights that are looked at in steps, s.
    pub fn new(
        model: &'s Arc<ReducedModel>,
        settings: &'s Settings,
        schedule: &'s Schedule,
        step: f64,
    ) -> Self {
        GustFlights { model, settings, schedule, step, audience: Audience::of_command() }
    }

    /// The same before others.
    pub fn before(self, audience: &Audience) -> Self {
        GustFlights { audience: audience.clone(), ..self }
    }

    /// Makes sure that so many flights come to an end.
    ///
    /// # Errors
    /// When they would be looked at too often.
    pub fn check(&self, flights: usize) -> Result<(), TooManyLooks> {
        let looks = self.looks(flights);
        let (step, duration) = (self.step, self.schedule.duration());
        if looks > MOST_LOOKS { Err(TooManyLooks { step, duration, flights, looks }) } else { Ok(()) }
    }

    fn looks(&self, flights: usize) -> f64 {
        flights as f64 * self.schedule.point_count(Some(self.step))
    }

    /// Flies into each gust, and has somebody look at what stands at each moment: what was found of each flight, or why it
    /// had to end.
    pub fn fly<T: Send>(
        &self,
        gusts: &[GustSettings],
        begin: impl Fn(usize) -> T + Sync,
        look: impl Fn(&mut T, f64, &mut Simulation) + Sync,
    ) -> Vec<Result<T, SimulationError>> {
        let progress = self.audience.progress(self.looks(gusts.len()) as usize, "looks");
        let fly = |(number, gust): (usize, &GustSettings)| {
            let mut found = begin(number);
            let settings = Settings { gust: *gust, ..self.settings.clone() };
            let mut flight = Simulation::new(Arc::clone(self.model), &settings, self.schedule.start())?;
            self.schedule.fly(&mut flight, self.model, Some(self.step), |time, flight| {
                look(&mut found, time, flight);
                progress.advance();
                Ok::<(), SimulationError>(())
            })?;
            Ok(found)
        };
        gusts.par_iter().enumerate().with_max_len(1).map(fly).collect()
    }
}

impl Failures {
    /// Parts what flights found from why others failed, of which each has a name.
    pub fn part<T>(
        flown: Vec<Result<T, SimulationError>>,
        name: impl Fn(usize) -> String,
    ) -> (Vec<T>, Option<Failures>) {
        let (flights, mut found, mut failed) = (flown.len(), Vec::new(), Vec::new());
        for (number, flight) in flown.into_iter().enumerate() {
            match flight {
                Ok(flight) => found.push(flight),
                Err(error) => failed.push((name(number), error)),
            }
        }
        let failures = (!failed.is_empty()).then_some(Failures { failed, flights });
        (found, failures)
    }

    /// Each by its name, with the reason.
    pub fn lines(&self) -> impl Iterator<Item = String> {
        self.failed.iter().map(|(name, error)| format!("{name}: {error}"))
    }
}

impl fmt::Display for Failures {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Failures { failed, flights } = self;
        if let ([(name, error)], 1) = (failed.as_slice(), flights) {
            return write!(f, "{name}: {error}");
        }
        let others =
            if failed.len() < *flights { "what is written is of the others" } else { "nothing is written" };
        write!(f, "{} of {flights} flights failed; {others}:", failed.len())?;
        self.lines().try_for_each(|line| write!(f, "\n  {line}"))
    }
}

impl std::error::Error for Failures {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn failed_flights_are_named_and_the_others_are_kept() {
        let lost = || Err::<char, _>(SimulationError::NotFinite { time: 1.5 });
        let name = |number: usize| format!("flight {number}");
        let (found, failures) = Failures::part(vec![Ok('a'), lost(), Ok('c')], name);
        assert_eq!(found, ['a', 'c']);
        let text = failures.unwrap().to_string();
        assert!(
            text.starts_with("1 of 3 flights failed; what is written is of the others:\n  flight 1: "),
            "{text}"
        );
        let (_, failures) = Failures::part(vec![lost(), lost()], name);
        assert!(failures.unwrap().to_string().starts_with("2 of 2 flights failed; nothing is written:\n"));
        let (_, failures) = Failures::part(vec![lost()], name);
        assert!(failures.unwrap().to_string().starts_with("flight 0: "));
        assert_eq!(Failures::part(vec![Ok('a')], name), (vec!['a'], None));
    }
}
