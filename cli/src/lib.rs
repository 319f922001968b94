//! `flexair`, the command line of flexible-aircraft.
//!
//! One module per command; this one knows the options and nothing else.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::builder::{PathBufValueParser, TypedValueParser};
use clap::{Arg, Args, CommandFactory, FromArgMatches, Parser, Subcommand};
use flexible_aircraft_packaging::{Platform, remove_temporary_files};

mod aircraft;
mod aircraft_file;
mod analysis;
pub mod answer;
mod axis;
mod bench;
pub mod calls;
mod chart;
mod check;
mod commented;
mod completions;
mod condition;
mod converge;
mod describe;
mod diagnostics;
mod files;
mod flown;
mod flutter;
mod gust;
mod gust_flights;
pub mod home;
pub mod import;
mod interfaces;
mod limits;
mod linearise;
mod loads;
mod manoeuvre;
mod mark_labels;
mod marked;
mod merge;
mod new;
mod numbers;
mod outcome;
mod package;
pub mod progress;
mod proof;
mod reproduce;
mod schema;
mod simulate;
mod ssp;
mod sweep;
mod terminal;
mod trim;
mod view;
mod watched;
mod workspace;

use home::Home;
use outcome::Outcome;

/// Nonlinear flight dynamics of flexible aircraft, packaged for simulation tools (FMI 2.0 and 3.0)
#[derive(Parser)]
#[command(name = "flexair", version)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write an aircraft as an FMU or several, and prove by a short flight that it works
    Package(PackageOptions),
    /// Join FMUs of the same aircraft that were packaged for different platforms
    Merge(merge::MergeOptions),
    /// Fly the flights of the thesis, and write a page that lays the results beside its figures and table
    Reproduce(ReproduceOptions),

    /// Fly an aircraft without any FMI tool: inputs that are built in or from a file, all outputs into a table
    Simulate(simulate::SimulateOptions),

    /// Trim an aircraft in level flight, climbs, turns, pull-ups, sideslip or with an engine out: a table over speeds and altitudes
    Trim(trim::TrimOptions),

    /// Say what an aircraft file describes: mass, balance, static margin, natural modes, and what is unusual
    Describe(describe::DescribeOptions),

    /// Say what is wrong with an aircraft file, what is unusual, and what it describes; ends with 1 for mistakes, 2 for warnings
    Check(check::CheckOptions),

    /// Write a linear model about a trim, for control laws: matrices with names and units as JSON, tables, for NumPy and MATLAB
    #[command(visible_alias = "linearize")]
    Linearise(linearise::LineariseOptions),

    /// Find the airspeeds at which an aircraft flutters or diverges, and draw V–g and V–f plots
    Flutter(flutter::FlutterOptions),

    /// Lay trims, deflections, flutter speeds and roots with several numbers of modes side by side, and say how many are enough
    Converge(converge::ConvergeOptions),

    /// Fly an aircraft through one 1-cosine gust after the other, and say which is the worst for each output
    Gust(gust::GustOptions),

    /// Find what sections of the airframe carry in a manoeuvre or in gusts: envelopes, tables and plots
    Loads(loads::LoadsOptions),

    /// Show an aircraft in the browser: flights, gusts, trims and modes on one page that opens from disk
    View(view::ViewOptions),

    /// Fly many points over parameters of the FMU and of the aircraft, on a grid or at random, and keep numbers of each (Parquet)
    Sweep(sweep::SweepOptions),

    /// Measure how fast a packaged aircraft flies, how exact it is then, and what it costs to make it larger
    Bench(bench::BenchOptions),

    /// Join the aircraft's FMU and others, such as control laws, to a system that masters run (SSP, OSP)
    Ssp(ssp::SspOptions),

    /// Write a first file of your own aircraft: asks for kind, span, mass and the like, finds the rest, says what it assumed
    New(new::NewOptions),

    /// Write an aircraft file from the model of another program (a Nastran deck), and report by line what is not held
    Import(import::ImportOptions),

    /// Write the format of aircraft files as JSON Schema, by which editors complete, explain and mark them
    Schema(schema::SchemaOptions),

    /// List the aircraft that come with the program, by the names that every command takes
    Aircraft(aircraft::AircraftOptions),

    /// Print a script with which a shell completes commands and options
    Completions(completions::CompletionsOptions),
}

/// Options of `flexair package`.
#[derive(Args)]
struct PackageOptions {
    #[command(flatten)]
    aircraft: aircraft_file::AircraftFile,

    #[command(flatten)]
    interfaces: interfaces::Interfaces,

    /// The FMU to write, or a folder for several [default: FlexibleAircraft.fmu in the working directory, in a checkout in
    /// target/fmu; with .fmi3 and .me in its name where it is of FMI 3.0 and for model exchange]
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// How many natural modes to put into the FMU, lowest frequencies first; load modes are not counted. Of these fly as
    /// many as its parameter `mode_count` says, 12 unless it is set [default: 26, or all where there are fewer]
    #[arg(long, value_name = "N")]
    modes: Option<usize>,

    /// Put load modes beside them, shapes that typical static loads give the structure, also where the aircraft file does
    /// not ask for them; the FMU then has a parameter `load_modes`, by which they can be switched off
    #[arg(long)]
    load_modes: bool,

    /// Where a parameter of the FMU starts, if not as the aircraft has it: --set gust.shape=one_minus_cosine for importers that
    /// set no enumerations, --set tolerance=1e-4 for the default experiment too. May be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,

    /// Add stations along a component at (i - 1/2)/N of its length, as in wing_right=20: their outputs are those of
    /// wing_right_01 to wing_right_20. May be repeated
    #[arg(long, value_name = "COMPONENT=COUNT", value_parser = component_and_count)]
    stations_along: Vec<(String, usize)>,

    /// A shared library built elsewhere, for a further platform or in place of the one built here:
    /// aarch64-linux, darwin64, linux64 or win64, and its file. May be repeated [default: where the program is installed, those
    /// that came with it]
    #[arg(long, value_name = "PLATFORM=FILE", value_parser = platform_and_file)]
    binary: Vec<(Platform, PathBuf)>,

    /// Leave out of its documentation the page on which the aircraft is seen in its trim and its modes, a quarter of a megabyte
    #[arg(long)]
    no_scene: bool,

    /// Do not load and fly the FMU afterwards
    #[arg(long)]
    no_check: bool,
}

/// Options of `flexair reproduce`.
#[derive(Args)]
struct ReproduceOptions {
    /// The aircraft file (TOML)
    #[arg(long, value_name = "FILE", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    /// The folder to write index.html, the figures and the histories to
    #[arg(long, value_name = "DIR", default_value = "target/reproduction")]
    output: PathBuf,
}

fn platform_and_file(option: &str) -> Result<(Platform, PathBuf), String> {
    let (platform, file) = option.split_once('=').ok_or("expected PLATFORM=FILE")?;
    Ok((platform.parse().map_err(|error| format!("{error}"))?, PathBuf::from(file)))
}

fn component_and_count(option: &str) -> Result<(String, usize), String> {
    let (component, number) = option.split_once('=').ok_or("expected COMPONENT=COUNT")?;
    Ok((component.to_owned(), count(number)?))
}

/// The command line as it is parsed: every option takes negative numbers as values, so that `-1` is a bad number and not
/// an unknown option; a count says what it allows; names of choices count in any case. Where the program is at home decides
/// where outputs go and which aircraft names are known.
fn command_line(home: &Home) -> clap::Command {
    let option = |option: Arg| {
        if !option.get_action().takes_values() || option.is_positional() {
            return option;
        }
        let is_count = option.get_value_names().is_some_and(|names| *names == ["N"]);
        let option = option.allow_negative_numbers(true).ignore_case(true);
        if is_count { option.value_parser(count) } else { option }
    };
    CommandLine::command().mut_subcommands(|command| {
        let name = command.get_name().to_owned();
        let command = command.mut_args(|argument| at_home(home, &name, option(argument)));
        command.mut_subcommands(|command| command.mut_args(option))
    })
}

/// An option of a command with the default that it has at home.
fn at_home(home: &Home, command: &str, option: Arg) -> Arg {
    let default = option.get_default_values().first().map(PathBuf::from);
    let is_named_so = option.get_value_names().is_some_and(|names| *names == ["AIRCRAFT"]);
    if is_named_so || default == Some(workspace::aircraft()) {
        let home = home.clone();
        let help = option.get_help().map(ToString::to_string).unwrap_or_default();
        let parser = PathBufValueParser::new().try_map(move |given| {
            if let Some([own, found]) = home.namesake(&given) {
                let (name, own) = (found.file_stem().unwrap_or_default().display(), own.display());
                terminal::note(&format!(
                    "note: {name} is the aircraft that comes with flexair; the file here is {own}"
                ));
            }
            home.aircraft(given)
        });
        return option.value_parser(parser).help(format!("{help}, or a name that `flexair aircraft` lists"));
    }
    let Some(default) = default else { return option };
    match home.output(command, &default) {
        same if same == default => option,
        other => option.default_value(other.into_os_string()),
    }
}

fn count(text: &str) -> Result<usize, String> {
    text.parse().map_err(|_| "allowed is a whole number, 0 or more".to_owned())
}

/// Ctrl-C, and a request to terminate, end the program at once, and what is half written goes.
fn stop_when_asked() {
    // Where somebody arranged otherwise before, as `nohup` does, it stays so.
    let _ = ctrlc::try_set_handler(|| {
        remove_temporary_files();
        std::process::exit(INTERRUPTED);
    });
}

/// What shells return for a program that Ctrl-C ended.
const INTERRUPTED: i32 = 130;

/// What shells take for success.
const SUCCESS: u8 = 0;

/// What they take for the failure of a command.
const FAILURE: u8 = 1;

/// What they take for a command line that is not right.
const USAGE: u8 = 2;

/// What a command ends with that did what was asked and has something to say of it.
const REMARKS: u8 = 2;

/// The commands that may end so: a command line of theirs that is not right ends as a failure does.
const REMARKING: [&str; 2] = ["check", "import"];

/// How a command ended, or the report of why it did not do what was asked.
fn ended<T: Into<Outcome>, E: diagnostics::Report>(result: Result<T, E>) -> Result<Outcome, String> {
    result.map(Into::into).map_err(|error| error.report())
}

/// Does what a command line asks for, the program's name first, and returns what the program should end with.
pub fn command(arguments: impl IntoIterator<Item = OsString>, home: &Home) -> u8 {
    stop_when_asked();
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let may_remark = arguments.get(1).is_some_and(|command| REMARKING.iter().any(|name| command == name));
    let matches = command_line(home).try_get_matches_from(arguments);
    let command = match matches.and_then(|matches| CommandLine::from_arg_matches(&matches)) {
        Ok(CommandLine { command }) => command,
        Err(error) => {
            // Nobody is left who could be told that it failed.
            let _ = error.print();
            let usage = if may_remark { FAILURE } else { USAGE };
            return if error.use_stderr() { usage } else { SUCCESS };
        }
    };
    let outcome = match command {
        Command::Package(options) => ended(package::run(options, home)),
        Command::Merge(options) => ended(merge::run(&options)),
        Command::Reproduce(options) => ended(reproduce::run(&options)),
        Command::Simulate(options) => ended(simulate::run(&options)),
        Command::Trim(options) => ended(trim::run(&options)),
        Command::Describe(options) => ended(describe::run(&options)),
        Command::Check(options) => ended(check::run(&options)),
        Command::Linearise(options) => ended(linearise::run(&options)),
        Command::Flutter(options) => ended(flutter::run(&options)),
        Command::Converge(options) => ended(converge::run(&options)),
        Command::Gust(options) => ended(gust::run(&options)),
        Command::Loads(options) => ended(loads::run(&options)),
        Command::View(options) => ended(view::run(&options, home)),
        Command::Sweep(options) => ended(sweep::run(&options, home)),
        Command::Bench(options) => ended(bench::run(&options)),
        Command::Ssp(options) => ended(ssp::run(&options)),
        Command::New(options) => ended(new::run(&options)),
        Command::Import(options) => ended(import::run(&options)),
        Command::Schema(options) => ended(schema::run(&options)),
        Command::Aircraft(_) => ended(aircraft::run(home)),
        Command::Completions(options) => ended(completions::run(&options, command_line(home))),
    };
    match outcome {
        Ok(Outcome::Clean) => SUCCESS,
        Ok(Outcome::Remarks) => REMARKS,
        Err(report) => {
            terminal::note(&report);
            FAILURE
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As in the checkout in which this is built.
    fn command_line() -> clap::Command {
        super::command_line(&Home::of_program())
    }

    #[test]
    fn the_options_do_not_contradict_each_other() {
        command_line().debug_assert();
    }

    #[test]
    fn a_negative_count_is_a_bad_value_and_choices_count_in_any_case() {
        let parse = |line: &str| command_line().try_get_matches_from(line.split(' '));
        for line in ["simulate i.csv --modes -1", "package --modes -1", "flutter --from 1 --to 2 --modes -1"]
        {
            let error = parse(&format!("flexair {line}")).unwrap_err().to_string();
            assert!(
                error.contains("invalid value '-1' for '--modes <N>': allowed is a whole number"),
                "{error}"
            );
        }
        parse("flexair flutter --from 1 --to 2 --model RIGID").unwrap();
    }

    #[test]
    fn all_commands_share_one_default_aircraft() {
        let lines = [
            "simulate i.csv",
            "loads",
            "package",
            "flutter --from 1 --to 2",
            "converge",
            "gust",
            "trim",
            "describe",
            "linearise",
            "bench",
            "reproduce",
            "view",
        ];
        let jet = Home::of_program().aircraft_file("generic-business-jet");
        assert!(jet.is_file());
        for line in lines.map(|line| format!("flexair {line}")) {
            let matches = command_line().get_matches_from(line.split(' '));
            let (name, matches) = matches.subcommand().unwrap();
            assert_eq!(matches.get_one::<PathBuf>("aircraft"), Some(&jet), "{name}");
        }
    }

    #[test]
    fn a_binary_is_a_platform_and_a_file() {
        let (platform, file) = platform_and_file("win64=build/FlexibleAircraft.dll").unwrap();
        assert_eq!((platform, file), (Platform::Win64, PathBuf::from("build/FlexibleAircraft.dll")));
        assert_eq!(platform_and_file("win64").unwrap_err(), "expected PLATFORM=FILE");
    }
}
