//! Commands as calls: a program gives the options of a command line and gets names and arrays, and nothing is printed or
//! written but what was asked for.

use std::ffi::OsString;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use clap::FromArgMatches;

use crate::answer::Answer;
use crate::diagnostics::Report;
use crate::home::Home;
use crate::progress::{Audience, Left};
use crate::{
    Command, CommandLine, command_line, describe, flutter, gust, linearise, package, simulate, trim,
};

/// Why a call has no answer.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Failure {
    /// The options are not right, as the command line says it.
    #[error("{0}")]
    Usage(String),
    /// What was asked for cannot be done, as the command says it.
    #[error("{0}")]
    Command(String),
    /// Nobody waits for the answer.
    #[error("the work was given up")]
    Left,
}

/// What a command finds: its name, then its options, as after `flexair` in a shell. In place of a file of inputs a flight
/// may have a table of the same form.
///
/// # Errors
/// When the options are not right, the command fails, or its audience leaves.
pub fn call(
    arguments: &[OsString],
    table: Option<&[u8]>,
    home: &Home,
    audience: &Audience,
) -> Result<Answer, Failure> {
    let line = std::iter::once(OsString::from("flexair")).chain(arguments.iter().cloned());
    let matches = command_line(home).try_get_matches_from(line);
    let parsed = matches.and_then(|matches| CommandLine::from_arg_matches(&matches));
    let command = parsed.map_err(|error| Failure::Usage(mistake(&error.to_string())))?.command;
    match catch_unwind(AssertUnwindSafe(|| answer(command, table, home, audience))) {
        Ok(answer) => answer,
        Err(unwound) if unwound.is::<Left>() => Err(Failure::Left),
        Err(unwound) => resume_unwind(unwound),
    }
}

fn answer(
    command: Command,
    table: Option<&[u8]>,
    home: &Home,
    audience: &Audience,
) -> Result<Answer, Failure> {
    match command {
        Command::Package(options) => package::answer(options, home, audience).map_err(|error| failed(&error)),
        Command::Describe(options) => describe::answer(&options).map_err(|error| failed(&error)),
        Command::Simulate(options) => {
            simulate::answer(&options, table, audience).map_err(|error| failed(&error))
        }
        Command::Trim(options) => trim::answer(&options, audience).map_err(|error| failed(&error)),
        Command::Linearise(options) => linearise::answer(&options, audience).map_err(|error| failed(&error)),
        Command::Flutter(options) => flutter::answer(&options, audience).map_err(|error| failed(&error)),
        Command::Gust(options) => gust::answer(&options, audience).map_err(|error| failed(&error)),
        _ => Err(Failure::Usage("this command prints and writes, and has no other answer".to_owned())),
    }
}

fn failed(error: &impl Report) -> Failure {
    Failure::Command(mistake(&error.plain_report()))
}

/// What is wrong, without the word and without the hints for a shell.
fn mistake(report: &str) -> String {
    let text = report.strip_prefix("error: ").unwrap_or(report);
    let end = ["\n\nUsage: ", "\n\nFor more information"].iter().filter_map(|hint| text.find(hint)).min();
    text[..end.unwrap_or(text.len())].trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn call(line: &str, table: Option<&[u8]>) -> Result<Answer, Failure> {
        let arguments: Vec<OsString> = line.split(' ').map(OsString::from).collect();
        super::call(&arguments, table, &Home::of_program(), &Audience::new(false))
    }

    /// A member of an answer.
    fn member<'a>(answer: &'a Answer, name: &str) -> &'a Answer {
        let Answer::Members(members) = answer else { panic!("{answer:?}") };
        &members.iter().find(|(found, _)| found == name).unwrap().1
    }

    #[test]
    fn mistakes_are_told_as_by_the_command() {
        let trim = |options: &str| {
            call(&format!("trim generic-business-jet --modes 2 {options}"), None).unwrap_err()
        };
        let usage = Failure::Usage(
            "unexpected argument '--sped' found\n\n  tip: a similar argument exists: '--speed'".into(),
        );
        assert_eq!(trim("--sped 1"), usage);
        let engine = Failure::Command("--failed-engine: found middle, allowed is left, right".into());
        assert_eq!(trim("--failed-engine middle"), engine);
        let Failure::Command(nowhere) = trim("--speed 20") else { panic!("a trim at 20 m/s") };
        assert!(nowhere.starts_with("no point could be trimmed; the first because: "), "{nowhere}");
    }

    #[test]
    fn a_table_of_inputs_is_flown_in_place_of_a_file() {
        let line = "simulate inputs --modes 2 --set model=rigid";
        let answer = call(line, Some(b"time,elevator\n0,0\n0.1,0.01\n0.2,0.01\n")).unwrap();
        let (Answer::Matrix { rows, columns, values }, Answer::Texts(names)) =
            (member(&answer, "values"), member(&answer, "names"))
        else {
            panic!("{answer:?}")
        };
        assert_eq!((*rows, *columns, &names[0]), (3, names.len(), &"time".to_owned()));
        assert_eq!([values[0], values[*columns], values[2 * columns]], [0.0, 0.1, 0.2]);
        let mistake = call(line, Some(b"time,elevatr\n")).unwrap_err().to_string();
        assert!(mistake.starts_with("inputs: line 1, "), "{mistake}");
    }

    #[test]
    fn work_that_nobody_waits_for_ends() {
        let audience = Audience::new(false);
        audience.leave();
        let arguments = ["simulate", "--modes", "2", "--duration", "90000"].map(OsString::from);
        let failure = super::call(&arguments, None, &Home::of_program(), &audience).unwrap_err();
        assert_eq!(failure, Failure::Left);
    }
}
