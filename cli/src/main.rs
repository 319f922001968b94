//! `flexair`, the command line of flexible-aircraft.
//!
//! One module per command; this one knows the options and nothing else.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};
use flexible_aircraft_packaging::Platform;

mod bench;
mod chart;
mod check;
mod diagnostics;
mod flutter;
mod manoeuvre;
mod merge;
mod package;
mod reproduce;
mod simulate;
mod ssp;

/// Nonlinear flight dynamics of flexible aircraft, packaged for simulation tools (FMI 2.0 co-simulation)
#[derive(Parser)]
#[command(name = "flexair", version)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write an aircraft as an FMU, and prove by a short flight that it works
    Package(PackageOptions),
    /// Join FMUs of the same aircraft that were packaged for different platforms
    Merge(merge::MergeOptions),
    /// Fly the flights of the thesis, and write a page that lays the results beside its figures and table
    Reproduce(ReproduceOptions),

    /// Fly an aircraft without any FMI tool: inputs from a file, all outputs into another
    Simulate(simulate::SimulateOptions),

    /// Find the airspeeds at which an aircraft flutters or diverges, and draw V–g and V–f plots
    Flutter(flutter::FlutterOptions),

    /// Measure how fast a packaged aircraft flies, how exact it is then, and what it costs to make it larger
    Bench(bench::BenchOptions),

    /// Join the aircraft's FMU and others, such as control laws, to a system that masters run (SSP, OSP)
    Ssp(ssp::SspOptions),
}

/// Options of `flexair package`.
#[derive(Args)]
struct PackageOptions {
    /// The aircraft file (TOML) [default: aircraft/generic-business-jet.toml of flexible-aircraft's own folder]
    #[arg(long, value_name = "FILE")]
    aircraft: Option<PathBuf>,

    /// The FMU to write [default: target/fmu/FlexibleAircraft.fmu in flexible-aircraft's own folder]
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// How many natural modes to put into the FMU, lowest frequencies first; its parameter `mode_count`
    /// chooses among them [default: 26, or all where there are fewer]
    #[arg(long, value_name = "N")]
    modes: Option<usize>,

    /// A shared library built elsewhere, for a further platform or in place of the one built here:
    /// aarch64-linux, darwin64, linux64 or win64, and its file. May be repeated
    #[arg(long, value_name = "PLATFORM=FILE", value_parser = platform_and_file)]
    binary: Vec<(Platform, PathBuf)>,

    /// Do not load and fly the FMU afterwards
    #[arg(long)]
    no_check: bool,
}

/// Options of `flexair reproduce`.
#[derive(Args)]
struct ReproduceOptions {
    /// The aircraft file (TOML)
    #[arg(long, value_name = "FILE", default_value = "aircraft/generic-business-jet.toml")]
    aircraft: PathBuf,

    /// The folder to write index.html, the figures and the histories to
    #[arg(long, value_name = "DIR", default_value = "target/reproduction")]
    output: PathBuf,
}

fn platform_and_file(option: &str) -> Result<(Platform, PathBuf), String> {
    let (platform, file) = option.split_once('=').ok_or("expected PLATFORM=FILE")?;
    Ok((platform.parse().map_err(|error| format!("{error}"))?, PathBuf::from(file)))
}

fn main() -> ExitCode {
    let outcome = match CommandLine::parse().command {
        Command::Package(options) => package::run(options).map_err(|error| error.report()),
        Command::Merge(options) => merge::run(&options).map_err(|error| format!("error: {error}")),
        Command::Reproduce(options) => reproduce::run(&options).map_err(|error| error.report()),
        Command::Simulate(options) => simulate::run(&options).map_err(|error| error.report()),
        Command::Flutter(options) => flutter::run(&options).map_err(|error| error.report()),
        Command::Bench(options) => bench::run(&options).map_err(|error| error.report()),
        Command::Ssp(options) => ssp::run(&options).map_err(|error| format!("error: {error}")),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(report) => {
            eprintln!("{report}");
            ExitCode::FAILURE
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_options_do_not_contradict_each_other() {
        CommandLine::command().debug_assert();
    }

    #[test]
    fn a_binary_is_a_platform_and_a_file() {
        let (platform, file) = platform_and_file("win64=build/FlexibleAircraft.dll").unwrap();
        assert_eq!((platform, file), (Platform::Win64, PathBuf::from("build/FlexibleAircraft.dll")));
        assert_eq!(platform_and_file("win64").unwrap_err(), "expected PLATFORM=FILE");
    }
}
