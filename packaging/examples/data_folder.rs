//! Writes the data folder of an installed `flexair`: libraries, licences, aircraft files.
//!
//! ```text
//! cargo run --package flexible-aircraft-packaging --example data_folder -- FOLDER PROGRAM PLATFORM=LIBRARY …
//! ```
//!
//! PROGRAM is the package of this workspace whose licences it gets: `flexair`, or `flexair-python`.

use std::error::Error;
use std::path::{Path, PathBuf};

use flexible_aircraft_packaging::{Installation, Platform};

const USAGE: &str = "allowed are FOLDER PROGRAM PLATFORM=LIBRARY …";

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (folder, program) = arguments.next().zip(arguments.next()).ok_or(USAGE)?;
    let mut libraries: Vec<(Platform, PathBuf)> = Vec::new();
    for argument in arguments {
        let (platform, library) = argument.split_once('=').ok_or(USAGE)?;
        libraries.push((platform.parse()?, library.into()));
    }
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let written = Installation::write(Path::new(&folder), &workspace, &libraries, &program)?;
    println!("{}: libraries for {} platforms", folder, written.libraries().len());
    Ok(())
}
