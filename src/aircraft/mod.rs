//! The aircraft as engineers describe it, expanded to elements, bays, strips and engines.
//!
//! [theory: structure.tree, structure.bay, air-loads.strip; thesis §3.1, §4.1]
//!
//! [`Aircraft`] is what the rest of the program sees: plain data in body axes, origin O at node 0, which is
//! clamped in the body frame. Nothing here knows of modes or of flight, and nothing else in the library reads
//! files. An aircraft file passes through these stages, each of which complains about all that it finds:
//!
//! | module | takes | gives |
//! | --- | --- | --- |
//! | `document`, `read`, `control_tables`, `cut_tables`, `joint_tables`, `limit_tables`, `model_tables`, `section_tables`, `tunnel` | TOML text | `schema`: the fields, each allowed by itself, with their places |
//! | `format` | | which fields there are, what they may hold, what holds without them; `allowed` asks it about a number |
//! | `control`, `limits` | | what controls are, what trims should stay within |
//! | `law`, `geometry`, `sections`, `masses`, `surfaces` | one component | its beams, bays and strips |
//! | `section_matrix`, `box_section` | a 6 × 6 matrix, sizes of a box | stiffness and mass of a section |
//! | `coupling` | | what sections have beyond four stiffnesses, hinges |
//! | `expand` | components | [`Aircraft`]: placed, mirrored, attached to one another |
//! | `toml_value` | a TOML value | what messages call it, its number |
//! | `components` | a name | the component that has it |
//! | `joints` | [`Aircraft`] | which of its nodes move together |
//! | `loops` | [`Aircraft`] | the loops that joints close |
//! | `cuts` | [`Aircraft`] | where it is cut in thought, what is outboard of a cut |
//! | `reference` | [`Aircraft`] | the lengths by which coefficients are made dimensionless |
//! | `stations_along` | [`Aircraft`] | stations that no file lists |
//! | `factors` | [`Aircraft`] | the same with other stiffnesses and masses |
//! | `fidelity` | | at which levels an aircraft can fly |
//! | `flap` | | what a flap does to its section |
//! | `branches` | the tree of beams | what is the mirror image of what |
//! | `control_check`, `former` | the fields | names, roles and uses of controls |
//! | `roles` | [`Aircraft`] | whether controls can do what their roles ask |
//! | `check` | the whole | names, support, symmetry, mass |
//!
//! The rest of this page is the description of the format for those who write such files.
//!
#![doc = include_str!("../../aircraft/README.md")]

mod allowed;
mod box_section;
mod branches;
mod check;
mod components;
mod control;
mod control_check;
mod control_tables;
mod coupling;
mod cut_tables;
mod cuts;
mod document;
mod error;
mod expand;
mod factors;
mod fidelity;
mod flap;
pub mod format;
mod former;
mod geometry;
mod joint_tables;
mod joints;
mod law;
mod limit_tables;
mod limits;
mod loops;
mod masses;
mod model;
mod model_tables;
mod read;
mod reference;
mod roles;
mod schema;
mod section_matrix;
mod section_tables;
mod sections;
mod stations_along;
mod stretch;
mod surfaces;
mod toml_value;
mod tunnel;

use std::path::Path;

use toml::de::DeTable;

use error::{Place, Report};

pub(crate) use branches::Branches;
pub use control::{Control, Mirroring, TrimRole};
pub use control_check::{TAKEN, TAKEN_BY_TRIM};
pub use coupling::{Coupling, Hinge, Spring};
pub use error::{AircraftFileError, Diagnostic, Problem, looked_for};
pub use factors::{Factor, FactorOutOfRange};
pub use fidelity::Fidelity;
pub use flap::FlapEffect;
pub use limits::{Bound, Bounds, Limits};
pub use model::{
    AIRSPEEDS, ALTITUDES, Aircraft, Attachment, Beam, Component, Cut, Engine, Flap, GivenReference, Joint,
    JointEnd, MOST_INFLOW_STATES, MassBay, MassGroup, ModeBasis, Station, Strip, Support,
    TEMPERATURE_OFFSETS, TUNNEL_SPEEDS, TunnelAir, WrittenComponent,
};
pub use reference::ReferenceLengths;
pub use stations_along::StationsAlongError;
pub(crate) use surfaces::CROSSING;
pub use toml_value::{toml_found, toml_number};

impl Aircraft {
    /// Reads and expands an aircraft file.
    ///
    /// # Errors
    /// When the file cannot be read, or for everything [`Aircraft::parse`] complains about.
    pub fn read(path: impl AsRef<Path>) -> Result<Aircraft, AircraftFileError> {
        let path = path.as_ref();
        let file_name = path.display().to_string();
        match std::fs::read_to_string(path) {
            Ok(text) => Aircraft::parse(&text, &file_name),
            Err(source) => Err(AircraftFileError::Unreadable { file_name, source }),
        }
    }

    /// Expands the text of an aircraft file; `file_name` is what messages call it.
    ///
    /// ```
    /// # use flexible_aircraft::Aircraft;
    /// let error = Aircraft::parse("nam = \"A glider\"", "glider.toml").unwrap_err();
    /// assert!(error.to_string().contains("glider.toml:1:1: nam"), "{error}");
    /// ```
    ///
    /// # Errors
    /// [`AircraftFileError::Rejected`] with every mistake that can be told without guessing: first all that
    /// are in the reading of fields, then all that are in the aircraft which they describe.
    pub fn parse(text: &str, file_name: &str) -> Result<Aircraft, AircraftFileError> {
        let report = Report::new(text);
        let document = DeTable::parse(text).map_err(|error| syntax(&report, text, &error)).ok();
        let document = report.conclude(document, file_name)?;
        let file = read::read_file(document.get_ref(), &report);
        if let Some(file) = &file {
            check::names(file, &report);
            control_check::controls(file, &report);
            former::controls(file, &report);
            check::support(file, &report);
        }
        let file = report.conclude(file, file_name)?;
        let assembly = report.conclude(expand::expand(&file, &report), file_name)?;
        check::mass(&assembly.aircraft, &report);
        check::trim_shares(&assembly.aircraft, &file, &report);
        control_check::roles(&assembly.aircraft, &file, &report);
        if file.symmetric {
            check::symmetry(&assembly, &file, &report);
        }
        report.conclude(Some(assembly.aircraft), file_name)
    }
}

fn syntax(report: &Report, text: &str, error: &toml::de::Error) {
    let span = error.span().unwrap_or_default();
    let line = text.get(..span.start).map_or(0, |before| before.matches('\n').count());
    let line = text.lines().nth(line).unwrap_or_default().trim();
    let found = format!("found \"{line}\": {}", error.message());
    let place = Place { span, field: "syntax".to_owned() };
    report.add(Problem::Syntax, &place, found, "TOML is allowed (https://toml.io)");
}
