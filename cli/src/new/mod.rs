//! `flexair new`: an aircraft file from a few numbers and rules of conceptual design, that trims and flies as it is.

use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

use clap::Args;
use flexible_aircraft_packaging::FileError;

use crate::files::{Drafts, STANDARD, named};
use crate::numbers::{Plain, fixed, short};
use crate::terminal;

mod basis;
mod bodies;
mod build;
mod controls;
mod design;
mod engines;
mod failure;
mod fit;
mod interview;
mod kind;
mod layout;
mod planform;
mod quantity;
mod sizing;
mod stiffness;
mod tails;
mod text;
mod wing;

use failure::NotFound;
use fit::Fitted;
use interview::{Interview, Terminal};
use kind::Kind;
use sizing::Sizing;

/// Options of `flexair new`.
#[derive(Args)]
#[command(
    after_help = "What is not given is asked for on a terminal, where Enter takes what is usual; elsewhere, and with --no-questions, what is usual is \
taken. The file says what was given and what was assumed. Stiffnesses are such that the wing has its bending frequency, held at its root; the payload \
is put where the static margin is 0.1 of the mean chord.

Examples: answer questions; a sailplane of 15 m; an aircraft of your own mass and frequency
  flexair new my-aircraft.toml
  flexair new sailplane.toml --kind sailplane --span 15 --no-questions
  flexair new jet.toml --kind t-tail --span 25 --mass 16000 --engines 2 --bending-frequency 2.4"
)]
pub struct NewOptions {
    /// The aircraft file to write (TOML); - is standard output
    #[arg(value_name = "FILE")]
    file: PathBuf,

    #[command(flatten)]
    given: Given,

    /// Replace the file if it exists
    #[arg(long)]
    force: bool,

    /// Ask nothing on a terminal either: take what is usual
    #[arg(long)]
    no_questions: bool,
}

/// What of an aircraft is given.
#[derive(Args, Clone, Debug, Default)]
pub struct Given {
    /// What it looks like
    #[arg(long, value_enum)]
    pub kind: Option<Kind>,

    /// Span from tip to tip, of a wing on a wall from there to the tip, 0.5 to 100 m
    #[arg(long, value_name = "M")]
    pub span: Option<f64>,

    /// Chord of the wing at its root, m
    #[arg(long, value_name = "M")]
    pub root_chord: Option<f64>,

    /// Chord at its tip, m
    #[arg(long, value_name = "M")]
    pub tip_chord: Option<f64>,

    /// Sweep of its quarter-chord line, -20 to 40 degrees
    #[arg(long, value_name = "DEG")]
    pub sweep: Option<f64>,

    /// Its dihedral, -10 to 15 degrees
    #[arg(long, value_name = "DEG")]
    pub dihedral: Option<f64>,

    /// Mass of the aircraft, or of the wing on a wall, kg
    #[arg(long, value_name = "KG")]
    pub mass: Option<f64>,

    /// How many engines; 0 glides
    #[arg(long, value_name = "N")]
    pub engines: Option<usize>,

    /// True airspeed of its trim, m/s
    #[arg(long, value_name = "M/S")]
    pub airspeed: Option<f64>,

    /// Altitude of its trim, m
    #[arg(long, value_name = "M")]
    pub altitude: Option<f64>,

    /// Frequency of the first (symmetric) bending of the wing, held at its root, Hz
    #[arg(long, value_name = "HZ")]
    pub bending_frequency: Option<f64>,
}

/// Why `flexair new` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("--kind: found none, allowed is {0}")]
    NoKind(String),
    #[error("{option}: found {found}, allowed is {allowed}")]
    NotAllowed { option: &'static str, found: String, allowed: String },
    #[error("{} exists and stays as it is; allowed is another file, or --force to replace it", .0.display())]
    Exists(PathBuf),
    #[error("the answers ended before the questions: nothing is written")]
    NoAnswer,
    #[error("the terminal cannot be read or written: {0}")]
    Terminal(#[source] io::Error),
    #[error("{0}")]
    NotFound(Box<NotFound>),
    #[error(transparent)]
    File(#[from] FileError),
}

/// Asks, finds, writes, and says what was assumed.
pub fn run(options: &NewOptions) -> Result<(), Error> {
    let file = options.file.as_path();
    let is_standard = file == Path::new(STANDARD);
    if !options.force && !is_standard && file.is_file() {
        return Err(Error::Exists(file.to_owned()));
    }
    let drafts = Drafts::new(Some(file).filter(|_| !is_standard))?;
    let (mut answers, mut questions) = (io::stdin().lock(), io::stderr());
    let is_asked = !options.no_questions && answers.is_terminal() && questions.is_terminal();
    let terminal = is_asked.then_some(Terminal { answers: &mut answers, questions: &mut questions });
    let mut interview = Interview::new(terminal, options.given.clone());
    let (sizing, Fitted { text, found }) = made(file, &mut interview).inspect_err(|_| {
        if interview.is_answered {
            terminal::note(&again(file, options.force, &interview.given));
        }
    })?;
    let report = report(file, &sizing, &found);
    if is_standard {
        terminal::note(&report);
        return Ok(terminal::print(&text)?);
    }
    drafts.keep([text])?;
    Ok(terminal::print(&report)?)
}

/// The aircraft of an interview.
fn made(file: &Path, interview: &mut Interview) -> Result<(Sizing, Fitted), Error> {
    let sizing = Sizing::new(interview)?;
    let fitted = fit::fit(&name(file, &sizing), &sizing);
    let fitted = fitted.map_err(|failure| Error::NotFound(NotFound::of(failure, &interview.given)))?;
    Ok((sizing, fitted))
}

/// What was answered as a command that asks no more.
fn again(file: &Path, is_forced: bool, given: &Given) -> String {
    let mut command = format!("flexair new {}", quoted(file));
    command.extend(given.kind.map(|kind| format!(" --kind {}", kind.option())));
    for quantity in &quantity::ALL {
        let number = *(quantity.of)(&mut given.clone());
        command.extend(number.map(|number| format!(" {} {}", quantity.option, Plain(number))));
    }
    command.extend(given.engines.map(|engines| format!(" --engines {engines}")));
    command += if is_forced { " --force --no-questions" } else { " --no-questions" };
    format!("What was given and answered, to change a number and run again:\n  {command}\n")
}

/// For people: that of the file, with what it is.
fn name(file: &Path, sizing: &Sizing) -> String {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let printable: String = stem.chars().filter(|letter| !letter.is_control()).collect();
    let kind = sizing.usual.name;
    if file == Path::new(STANDARD) || printable == kind {
        return kind.to_owned();
    }
    format!("{printable}, {kind}")
}

/// As a shell takes it.
fn quoted(path: &Path) -> String {
    let text = path.display().to_string();
    let is_plain = |letter: char| letter.is_alphanumeric() || "_-./".contains(letter);
    if text.chars().all(is_plain) { text } else { format!("'{}'", text.replace('\'', r"'\''")) }
}

/// What was assumed and what it came to.
fn report(file: &Path, sizing: &Sizing, found: &fit::Found) -> String {
    let shown = named(file, "standard output");
    let mut text = format!("{shown}: {}\n\n", sizing.usual.name);
    text += &text::choices(&sizing.choices).iter().map(|line| format!("  {line}\n")).collect::<String>();
    text += &format!("\n{}", found.told());
    if let Some(flight) = &found.flight {
        let pushed = match sizing.engines {
            0 => format!("path {} deg", fixed(flight.climb, 1)),
            _ => format!("thrust {} N of each engine", quantity::in_three_digits(flight.thrust)),
        };
        text += &format!(
            ", {pushed}, trimmed at {} m/s and {} m",
            short(sizing.airspeed),
            short(sizing.altitude)
        );
    }
    if sizing.kind == Kind::TwinBoom {
        text += &format!("\n\n{} The end of the file says how to join them.", text::HALVES);
    }
    text += "\n\nThe file says how the rest was found.";
    if file == Path::new(STANDARD) {
        return text;
    }
    let (own, schema) = (quoted(file), quoted(&file.with_file_name(text::SCHEMA)));
    let next = ["check", "view", "package --aircraft"].map(|command| format!("\n  flexair {command} {own}"));
    text + " Next:"
        + &next.concat()
        + &format!("\nEditors complete and mark the file after:\n  flexair schema --output {}\n", schema)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_given_is_one_command_for_a_shell() {
        let given = Given {
            kind: Some(Kind::FlyingWing),
            span: Some(3.0),
            sweep: Some(-4.5),
            engines: Some(0),
            bending_frequency: Some(1e-7),
            ..Given::default()
        };
        let command = again(Path::new("it's mine.toml"), true, &given);
        assert!(
            command.ends_with(
                "\n  flexair new 'it'\\''s mine.toml' --kind flying-wing --span 3 --sweep -4.5 --bending-frequency 1e-7 --engines 0 \
                 --force --no-questions\n"
            ),
            "{command}"
        );
    }
}
