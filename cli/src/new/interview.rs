//! Where each number comes from: an option, an answer on a terminal, or a rule.

use std::fmt::Display;
use std::io::{BufRead, Write};
use std::ops::RangeInclusive;

use clap::ValueEnum;

use super::kind::Kind;
use super::quantity::{Quantity, to_three_digits};
use super::{Error, Given};
use crate::numbers::{Plain, short};

/// A number of the aircraft and where it comes from.
pub struct Choice {
    pub label: &'static str,
    /// With its unit.
    pub value: String,
    /// The rule; none of what was given.
    pub assumed: Option<String>,
}

/// Who asks and who answers on a terminal.
pub struct Terminal<'t> {
    pub answers: &'t mut dyn BufRead,
    pub questions: &'t mut dyn Write,
}

/// Collects the numbers of an aircraft, one after the other.
pub struct Interview<'t> {
    terminal: Option<Terminal<'t>>,
    /// What was given by options, and then by answers too.
    pub given: Given,
    /// Whether anything was answered.
    pub is_answered: bool,
    pub choices: Vec<Choice>,
}

impl<'t> Interview<'t> {
    /// That asks on a terminal, or nowhere, for what is not given.
    pub fn new(terminal: Option<Terminal<'t>>, given: Given) -> Self {
        Interview { terminal, given, is_answered: false, choices: Vec::new() }
    }

    /// The kind of aircraft.
    ///
    /// # Errors
    /// When it is not given and nobody can be asked.
    pub fn kind(&mut self) -> Result<Kind, Error> {
        if let Some(kind) = self.given.kind {
            return Ok(kind);
        }
        if let Some(terminal) = &mut self.terminal {
            for kind in Kind::value_variants() {
                let value = kind.to_possible_value();
                let help = value
                    .as_ref()
                    .and_then(|value| value.get_help())
                    .map_or(String::new(), ToString::to_string);
                terminal.say(&format!("  {:14}{help}\n", kind.option()))?;
            }
        }
        let read = |answer: &str| Kind::from_str(answer, true).map_err(|_| Kind::options());
        let answer = self.ask("kind", Kind::Conventional.option(), read)?;
        let kind = answer.ok_or_else(|| Error::NoKind(Kind::options()))?.unwrap_or(Kind::Conventional);
        self.given.kind = Some(kind);
        Ok(kind)
    }

    /// A number: given, or answered, or else the default with its reason.
    ///
    /// # Errors
    /// When what is given is not allowed.
    pub fn number(&mut self, quantity: &Quantity, (default, reason): (f64, String)) -> Result<f64, Error> {
        let given = *(quantity.of)(&mut self.given);
        check(quantity, given)?;
        let Quantity { label, unit, .. } = *quantity;
        let is_allowed = |number: &f64| quantity.allowed.contains(number);
        let allowed = || quantity.allowed();
        let default = to_three_digits(default).max(*quantity.allowed.start()).min(*quantity.allowed.end());
        let read = |answer: &str| answer.parse().ok().filter(is_allowed).ok_or_else(allowed);
        let chosen = match given {
            Some(number) => Some(number),
            None => self.ask(&format!("{label}, {unit}"), short(default), read)?.flatten(),
        };
        *(quantity.of)(&mut self.given) = chosen;
        let number = chosen.unwrap_or(default);
        let assumed = chosen.is_none().then_some(reason);
        self.choices.push(Choice { label, value: format!("{} {unit}", short(number)), assumed });
        Ok(number)
    }

    /// A number of engines.
    ///
    /// # Errors
    /// When what is given is not allowed.
    pub fn engines(&mut self, allowed: &RangeInclusive<usize>, default: usize) -> Result<usize, Error> {
        let given = self.given.engines;
        let text = if allowed.start() == allowed.end() {
            format!("{} of this kind", allowed.start())
        } else {
            format!("{} to {} of this kind", allowed.start(), allowed.end())
        };
        if let Some(found) = given.filter(|count| !allowed.contains(count)) {
            return Err(Error::NotAllowed { option: "--engines", found: found.to_string(), allowed: text });
        }
        let read = |answer: &str| {
            answer.parse().ok().filter(|count| allowed.contains(count)).ok_or_else(|| text.clone())
        };
        let chosen = match given {
            Some(count) => Some(count),
            None if allowed.start() == allowed.end() => None,
            None => self.ask("engines", default, read)?.flatten(),
        };
        self.given.engines = chosen;
        let assumed = chosen.is_none().then(|| "usual of the kind".to_owned());
        let count = chosen.unwrap_or(default);
        self.choices.push(Choice { label: "engines", value: count.to_string(), assumed });
        Ok(count)
    }

    /// An answer, asked for until it is right; none inside where the default was taken, none at all where nobody is asked.
    fn ask<T>(
        &mut self,
        what: &str,
        default: impl Display,
        read: impl Fn(&str) -> Result<T, String>,
    ) -> Result<Option<Option<T>>, Error> {
        let Some(terminal) = &mut self.terminal else { return Ok(None) };
        loop {
            terminal.say(&format!("{what} [{default}]: "))?;
            let answer = terminal.line()?;
            match (answer.trim(), read(answer.trim())) {
                ("", _) => return Ok(Some(None)),
                (_, Ok(answer)) => {
                    self.is_answered = true;
                    return Ok(Some(Some(answer)));
                }
                (found, Err(allowed)) => terminal.say(&format!("  found {found}, allowed is {allowed}\n"))?,
            }
        }
    }
}

/// Makes sure that a number that is given is allowed.
///
/// # Errors
/// When it is not.
pub fn check(quantity: &Quantity, given: Option<f64>) -> Result<(), Error> {
    let Quantity { option, unit, .. } = *quantity;
    match given.filter(|number| !quantity.allowed.contains(number)) {
        None => Ok(()),
        Some(found) => Err(Error::NotAllowed {
            option,
            found: format!("{} {unit}", Plain(found)),
            allowed: quantity.allowed(),
        }),
    }
}

impl Terminal<'_> {
    fn say(&mut self, text: &str) -> Result<(), Error> {
        self.questions
            .write_all(text.as_bytes())
            .and_then(|()| self.questions.flush())
            .map_err(Error::Terminal)
    }

    fn line(&mut self) -> Result<String, Error> {
        let mut line = String::new();
        match self.answers.read_line(&mut line) {
            Ok(0) => Err(Error::NoAnswer),
            Ok(_) => Ok(line),
            Err(error) => Err(Error::Terminal(error)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::quantity::{MASS, SPAN};
    use super::*;

    fn answered<T>(answers: &str, ask: impl FnOnce(&mut Interview) -> T) -> (T, String) {
        let (mut answers, mut questions) = (answers.as_bytes(), Vec::new());
        let terminal = Terminal { answers: &mut answers, questions: &mut questions };
        let found = ask(&mut Interview::new(Some(terminal), Given::default()));
        (found, String::from_utf8(questions).unwrap())
    }

    #[test]
    fn enter_takes_the_default_and_a_wrong_answer_is_asked_again() {
        let (numbers, asked) = answered("\nlong\n500\n12.5\n", |interview| {
            let default = || (11.0, "usual".to_owned());
            let numbers = [0, 1].map(|_| interview.number(&SPAN, default()).unwrap());
            assert_eq!((interview.given.span, interview.is_answered), (Some(12.5), true));
            assert_eq!([0, 1].map(|place| interview.choices[place].assumed.is_some()), [true, false]);
            numbers
        });
        assert_eq!(numbers, [11.0, 12.5]);
        assert!(
            asked.starts_with("span, m [11]: span, m [11]:   found long, allowed is 0.5 to 100 m\n"),
            "{asked}"
        );
        assert_eq!(asked.matches("found 500, allowed is 0.5 to 100 m").count(), 1, "{asked}");
    }

    #[test]
    fn kinds_are_listed_and_known_in_any_case() {
        let (kind, asked) = answered("biplane\nFlying-Wing\n", |interview| interview.kind().unwrap());
        assert_eq!(kind, Kind::FlyingWing);
        assert!(asked.contains("  t-tail        Tail on top of the fin"), "{asked}");
        assert!(
            asked.contains("found biplane, allowed is conventional, t-tail, v-tail, canard, "),
            "{asked}"
        );
    }

    #[test]
    fn what_is_given_is_not_asked_and_answers_that_end_are_an_error() {
        let (mass, asked) = answered("", |interview| {
            interview.given.mass = Some(5.0);
            interview.number(&MASS, (1.0, String::new())).unwrap()
        });
        assert_eq!((mass, asked.as_str()), (5.0, ""));
        let (ended, _) = answered("", |interview| interview.engines(&(0..=2), 1).unwrap_err());
        assert!(matches!(ended, Error::NoAnswer));
    }

    #[test]
    fn without_a_terminal_nothing_is_asked_and_the_kind_is_needed() {
        let of = |span, engines| Interview::new(None, Given { span, engines, ..Given::default() });
        assert!(matches!(of(None, None).kind(), Err(Error::NoKind(_))));
        assert_eq!(of(None, None).number(&SPAN, (11.0, "usual".to_owned())).unwrap(), 11.0);
        let refused = of(Some(f64::NAN), None).number(&SPAN, (11.0, String::new())).unwrap_err().to_string();
        assert_eq!(refused, "--span: found NaN m, allowed is 0.5 to 100 m");
        let refused = of(None, Some(9)).engines(&(0..=8), 1).unwrap_err().to_string();
        assert_eq!(refused, "--engines: found 9, allowed is 0 to 8 of this kind");
    }
}
