//! `flexair ssp`: joins the aircraft's FMU and others to a system that masters run.

use std::path::{Path, PathBuf};

use clap::Args;
use flexible_aircraft_packaging::system::{Component, Endpoint, Experiment, System, SystemError};
use flexible_aircraft_packaging::{FileError, PackageError};

use crate::files::{Overwriting, refuse_overwriting};
use crate::terminal;

/// Name of the aircraft in the system.
const AIRCRAFT: &str = "aircraft";

/// Options of `flexair ssp`.
#[derive(Args)]
#[command(after_help = "Example: close a pitch-attitude hold around the aircraft
  flexair ssp FlexibleAircraft.fmu --component hold=PitchAttitudeHold.fmu \\
    --connect aircraft.attitude.pitch=hold.pitch --connect aircraft.rate.y=hold.pitch_rate \\
    --connect hold.elevator=aircraft.elevator --output closed_loop.ssp")]
pub struct SspOptions {
    /// The FMU of the aircraft: the component `aircraft`
    #[arg(value_name = "AIRCRAFT.fmu")]
    aircraft: PathBuf,

    /// A further FMU (of FMI 2.0 or 3.0, for co-simulation or model exchange) and its name in the system. May be repeated
    #[arg(long, value_name = "NAME=FMU", value_parser = name_and_file)]
    component: Vec<(String, PathBuf)>,

    /// An output and the input that it feeds, in either order. May be repeated
    #[arg(long, value_name = "COMPONENT.VARIABLE=COMPONENT.VARIABLE", value_parser = two_endpoints)]
    connect: Vec<(Endpoint, Endpoint)>,

    /// The start value of a parameter or of an input that is not connected. May be repeated
    #[arg(long, value_name = "COMPONENT.VARIABLE=VALUE", value_parser = endpoint_and_value)]
    set: Vec<(Endpoint, String)>,

    /// Communication step, s
    #[arg(long, value_name = "SECONDS", default_value_t = 0.01)]
    step: f64,

    /// End of the default experiment, s
    #[arg(long, value_name = "SECONDS", default_value_t = 15.0)]
    stop_time: f64,

    /// The SSP archive to write (System Structure and Parameterization 1.0, or 2.0 where an FMU is of FMI 3.0)
    #[arg(short, long, value_name = "FILE.ssp", required_unless_present = "osp")]
    output: Option<PathBuf>,

    /// The folder to write libcosim's own system structure and the FMUs to, which all have to be of FMI 2.0 for co-simulation
    #[arg(long, value_name = "DIR")]
    osp: Option<PathBuf>,
}

/// Why `flexair ssp` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    System(#[from] SystemError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
    #[error(transparent)]
    Write(#[from] PackageError),
    #[error(transparent)]
    Print(#[from] FileError),
}

/// Checks the connections and writes the system.
pub fn run(options: &SspOptions) -> Result<(), Error> {
    let mut components = vec![Component::read(AIRCRAFT, &options.aircraft)?];
    for (name, path) in &options.component {
        components.push(Component::read(name, path)?);
    }
    let experiment = Experiment { step: options.step, stop_time: options.stop_time };
    let system = System::new(components, &options.connect, &options.set, experiment)?;
    refuse_to_overwrite_components(options, &system)?;
    if options.osp.is_some() {
        system.check_for_osp()?;
    }
    for end in system.units_taken_on_trust() {
        terminal::note(&format!(
            "note: the unit of {end} is not declared; it is taken to be that of the other end"
        ));
    }
    for end in system.enumerations_set() {
        terminal::note(&format!(
            "note: {end} is an enumeration: libcosim does not load a system that sets one, OMSimulator leaves it at its start"
        ));
    }
    let (components, connections) = system.size();
    let report = |path: &Path| {
        terminal::print(&format!("{}: {components} components, {connections} connections\n", path.display()))
    };
    if let Some(output) = &options.output {
        system.write_ssp(output)?;
        report(output)?;
    }
    if let Some(folder) = &options.osp {
        system.write_osp(folder)?;
        report(folder)?;
    }
    Ok(())
}

fn refuse_to_overwrite_components(options: &SspOptions, system: &System) -> Result<(), Overwriting> {
    let mut outputs = options.osp.as_ref().map_or(Vec::new(), |folder| system.osp_files(folder));
    outputs.extend(options.output.clone());
    let outputs: Vec<&Path> = outputs.iter().map(PathBuf::as_path).collect();
    let others = options.component.iter().map(|(_, fmu)| fmu.as_path());
    refuse_overwriting(&outputs, others.chain([options.aircraft.as_path()]))
}

fn name_and_file(option: &str) -> Result<(String, PathBuf), String> {
    let (name, file) = option.split_once('=').ok_or("expected NAME=FMU")?;
    Ok((name.to_owned(), PathBuf::from(file)))
}

fn two_endpoints(option: &str) -> Result<(Endpoint, Endpoint), String> {
    let (first, second) = option.split_once('=').ok_or("expected COMPONENT.VARIABLE=COMPONENT.VARIABLE")?;
    Ok((first.parse()?, second.parse()?))
}

fn endpoint_and_value(option: &str) -> Result<(Endpoint, String), String> {
    let (end, value) = option.split_once('=').ok_or("expected COMPONENT.VARIABLE=VALUE")?;
    Ok((end.parse()?, value.to_owned()))
}
