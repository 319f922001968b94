//! `flexair import nastran`: a stick model in Nastran bulk data as an aircraft file.
//!
//! Data flow one way, each room taking what those above it give:
//!
//! | room | takes | gives |
//! | --- | --- | --- |
//! | `deck` | files | cards: lines and fields, in three formats |
//! | `cards` | cards | typed cards, in the deck's units and frames |
//! | `frames`, `axes`, `units` | coordinate systems, grids | places in body axes and metres |
//! | `sections`, `stiffness` | dimensions of a shape; axes across it | area, second moments, torsion constant; stiffness in these axes |
//! | `members`, `lumps`, `inertia` | elements, masses | the same in SI and body axes, as beams and bodies have them |
//! | `structure` | members, links, lumps | components: a tree of beams that carries all masses, and joints where beams form loops |
//! | `aero` | panels, splines, control surfaces | strips on components, controls |
//! | `pairs`, `joints`, `layout`, `names` | components, joints | mirror images, names |
//! | `write` | all of it | the text of an aircraft file |
//! | `choices` | what the deck leaves open | whether it flies, how fast, where it is held |
//! | `request`, `conversion` | a deck, options | all of these, one after the other |
//! | `report` | what was found | lines for people |
//!
//! `mistakes` has what is wrong with a deck (nothing is written) and what is not held of it (the file is, with a report).

mod aero;
mod axes;
mod cards;
mod choices;
mod conversion;
mod deck;
mod frames;
mod inertia;
mod joints;
mod layout;
mod lumps;
mod members;
mod mistakes;
mod names;
mod pairs;
mod report;
mod request;
mod sections;
mod stiffness;
mod structure;
mod units;
mod write;

use std::path::{Path, PathBuf};

use clap::Args;
use flexible_aircraft::aircraft::{AIRSPEEDS, ALTITUDES, AircraftFileError, TUNNEL_SPEEDS};
use flexible_aircraft_packaging::FileError;

use crate::files::{Drafts, Overwriting, STANDARD, refuse_overwriting};
use crate::marked::RejectedFiles;
use crate::outcome::Outcome;
use crate::terminal;
use aero::SurfaceLine;
use axes::DeckAxes;
use choices::Support;
use conversion::import;
pub use conversion::{Imported, of_text};
use deck::OnDisk;
use request::Request;
use units::UnitSystem;

/// Options of `flexair import nastran`.
#[derive(Args)]
#[command(
    after_help = "Read are GRID, CORD1R, CORD2R, CORD2C, CBAR, CBEAM, CROD, BAROR, BEAMOR, their properties (shapes ROD, TUBE, BAR, BOX, I, T, CHAN), MAT1, CONM1, CONM2, \
RBE2, RBAR, RBE3, SPC1, SPC, CBUSH at a root, CAERO1, AEFACT, AERO, AEROS, SPLINE1, SPLINE2, SET1, AESURF, AELIST, INCLUDE and PARAM,WTMASS, in free, small \
and large fields. What a deck says beyond that, or what beams here cannot hold, is reported by card, file, line and field. docs/nastran.md has all of it.

Ends with 0 where all of the aircraft is in the file, with 2 where there are reports, with 1 where nothing is written, also of a wrong option.

Examples: a deck in metres; one in inches with masses in pounds; a wing without panels
  flexair import nastran transport.bdf
  flexair import nastran wing.bdf --units in --output wing.toml --force
  flexair import nastran stick.bdf --surface 101:120,chord=2.4:1.2,axis=0.35,control=aileron,hinge=0.75"
)]
pub struct NastranOptions {
    /// The deck (bulk data, with or without executive and case control)
    #[arg(value_name = "DECK")]
    deck: PathBuf,

    /// The aircraft file to write (TOML); - is standard output [default: the name of the deck with .toml, in the working directory]
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Replace the file if it exists
    #[arg(long)]
    force: bool,

    /// The units of the deck, which must be consistent; masses are multiplied by PARAM,WTMASS first
    #[arg(long, value_enum, default_value_t = UnitSystem::M)]
    units: UnitSystem,

    /// Which way x, y and z of the basic system point [default: with AEROS or AERO those of its ACSID, x aft and z up, else aft-right-up]
    #[arg(long, value_enum)]
    axes: Option<DeckAxes>,

    /// The grid that becomes O, where the airframe is held when its modes are computed [default: one that is clamped, that of SUPORT, or the
    /// one nearest to the centre of mass in the plane of symmetry]
    #[arg(long, value_name = "GRID")]
    origin: Option<i64>,

    /// Whether it flies [default: clamped where SPC1 or a CBUSH holds it in all six components, else free]
    #[arg(long, value_enum)]
    support: Option<Support>,

    /// True airspeed of its trim, m/s [default: VELOCITY of AERO, else for a lift coefficient of 0.5]
    #[arg(long, value_name = "M/S")]
    airspeed: Option<f64>,

    /// Altitude of its trim, m
    #[arg(long, value_name = "M", default_value_t = 0.0)]
    altitude: f64,

    /// A lifting surface between two grids, GRID:GRID,chord=ROOT:TIP,axis=FRACTION: chords in m, and where in them the grids are, behind
    /// the leading edge; with a flap over all of it, control=NAME,hinge=FRACTION. May be repeated
    #[arg(long, value_name = "LINE")]
    surface: Vec<SurfaceLine>,

    /// An engine whose thrust acts at a grid, forward: decks have none. May be repeated
    #[arg(long, value_name = "NAME=GRID", value_parser = name_and_grid)]
    engine: Vec<(String, i64)>,
}

fn name_and_grid(option: &str) -> Result<(String, i64), String> {
    let allowed = || "allowed is NAME=GRID, the name of letters, digits and underscores".to_owned();
    let (name, grid) = option.split_once('=').ok_or_else(allowed)?;
    let is_name = name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_')
        && name.starts_with(|first: char| first.is_ascii_alphabetic());
    let grid = grid.parse().ok().filter(|_| is_name).ok_or_else(allowed)?;
    Ok((name.to_owned(), grid))
}

/// Why nothing is written.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The deck is not as it must be.
    #[error("{0}")]
    Rejected(#[from] RejectedFiles),
    /// An option is out of range.
    #[error("{option}: found {found}, allowed is {allowed}")]
    NotAllowed {
        /// Its name.
        option: &'static str,
        /// What it was given.
        found: f64,
        /// With its unit.
        allowed: String,
    },
    /// The output would replace a file.
    #[error("{} exists and stays as it is; allowed is another file, or --force to replace it", .0.display())]
    Exists(PathBuf),
    /// The library does not read what came of the deck.
    #[error("{0}")]
    NotRead(#[source] Box<AircraftFileError>),
    /// A file cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The output is part of the deck.
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

/// Reads a deck, writes an aircraft file, and says what became of what.
pub fn run(options: &NastranOptions) -> Result<Outcome, Error> {
    let output = options.output.clone().unwrap_or_else(|| {
        let stem = options.deck.file_stem().unwrap_or(options.deck.as_os_str());
        PathBuf::from(stem).with_extension("toml")
    });
    let is_standard = output == Path::new(STANDARD);
    if !options.force && !is_standard && output.is_file() {
        return Err(Error::Exists(output));
    }
    check_numbers(options)?;
    refuse_overwriting(&[&output], [options.deck.as_path()])?;
    let drafts = Drafts::new(Some(output.as_path()).filter(|_| !is_standard))?;
    let imported = import(&Request {
        deck: &options.deck,
        source: &OnDisk,
        units: options.units,
        axes: options.axes,
        root: options.origin,
        support: options.support,
        airspeed: options.airspeed,
        altitude: options.altitude,
        surfaces: &options.surface,
        engines: &options.engine,
    })?;
    let inputs: Vec<PathBuf> = imported.files().map(PathBuf::from).collect();
    refuse_overwriting(&[&output], inputs.iter().map(PathBuf::as_path))?;
    let report = report::text(&imported, &output);
    if is_standard {
        terminal::note(&report);
        terminal::print(imported.text())?;
    } else {
        drafts.keep([imported.text()])?;
        terminal::print(&report)?;
    }
    Ok(if imported.has_reports() { Outcome::Remarks } else { Outcome::Clean })
}

fn check_numbers(options: &NastranOptions) -> Result<(), Error> {
    let airspeeds = if options.support == Some(Support::Clamped) { TUNNEL_SPEEDS } else { AIRSPEEDS };
    if let Some(found) = options.airspeed.filter(|airspeed| !airspeeds.contains(airspeed)) {
        return Err(Error::NotAllowed {
            option: "--airspeed",
            found,
            allowed: format!(
                "{} to {} m/s, of what is clamped from 0 on",
                AIRSPEEDS.start(),
                AIRSPEEDS.end()
            ),
        });
    }
    if !ALTITUDES.contains(&options.altitude) {
        return Err(Error::NotAllowed {
            option: "--altitude",
            found: options.altitude,
            allowed: format!("{} to {} m", ALTITUDES.start(), ALTITUDES.end()),
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests;
