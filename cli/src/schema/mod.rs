//! `flexair schema`: the format of aircraft files for editors, which complete, explain and mark by it.

mod fields;
mod tables;

use std::path::{Path, PathBuf};

use clap::Args;
use flexible_aircraft_packaging::{Draft, FileError};

use crate::files::STANDARD;
use crate::terminal;

/// Options of `flexair schema`.
#[derive(Args)]
#[command(
    after_help = "Example: for an editor that knows TOML (taplo, Even Better TOML), a line at the head of the aircraft file
  flexair schema --output aircraft.schema.json
  #:schema ./aircraft.schema.json"
)]
pub struct SchemaOptions {
    /// The file to write; `-` is standard output
    #[arg(long, value_name = "FILE", default_value = STANDARD)]
    output: PathBuf,
}

/// Writes the schema.
pub fn run(options: &SchemaOptions) -> Result<(), FileError> {
    let schema = text();
    if options.output == Path::new(STANDARD) {
        return terminal::print(&schema);
    }
    Draft::write(schema.as_bytes(), &options.output)?.keep()?;
    terminal::print(&format!("{}\n", options.output.display()))
}

/// The schema as it is written.
fn text() -> String {
    format!("{:#}\n", tables::file())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_schema_beside_the_aircraft_is_that_of_the_format() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/aircraft.schema.json");
        if std::env::var_os("UPDATE_GOLDEN").is_some() {
            Draft::write(text().as_bytes(), &path).unwrap().keep().unwrap();
        }
        let found = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(found == text(), "{} is stale; UPDATE_GOLDEN=1 rewrites it", path.display());
    }

    #[test]
    fn a_field_says_what_it_is_what_it_may_hold_and_what_holds_without_it() {
        let schema = tables::file();
        let gravity = &schema["properties"]["gravity_m_s2"];
        assert_eq!(gravity["default"], 9.80665);
        assert_eq!((&gravity["minimum"], &gravity["maximum"]), (&0.0.into(), &1000.0.into()));
        let expected = "Gravitational acceleration.\n\nAllowed: 0 to 1000 m/s². Default: 9.80665.";
        assert_eq!(gravity["description"], expected);
        let component = &schema["properties"]["component"]["items"];
        assert_eq!(component["additionalProperties"], false);
        assert!(component["required"].as_array().unwrap().contains(&"axis_m".into()), "{component:#}");
        let hinge =
            component.pointer("/properties/surface/items/properties/flap/properties/hinge/oneOf/0").unwrap();
        assert_eq!((&hinge["exclusiveMinimum"], &hinge["exclusiveMaximum"]), (&0.0.into(), &1.0.into()));
    }
}
