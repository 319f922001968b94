//! The parts of a system.

use std::path::Path;

use super::error::SystemError;
use crate::model_description::ModelDescription;
use crate::read;

/// An FMU with a name in the system.
#[derive(Clone, Debug)]
pub struct Component {
    pub(super) name: String,
    pub(super) fmu: Vec<u8>,
    pub(super) description: ModelDescription,
}

impl Component {
    /// Reads an FMU. Names are of letters, digits, underscores and hyphens.
    ///
    /// # Errors
    /// When the name is of something else, or the file is no FMU of FMI 2.0 or 3.0.
    pub fn read(name: &str, path: &Path) -> Result<Self, SystemError> {
        let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        if name.is_empty() || !name.chars().all(is_plain) {
            return Err(SystemError::ComponentName(name.to_owned()));
        }
        let failed = |reason: String| SystemError::Fmu { path: path.to_owned(), reason };
        let fmu = read(path)?;
        let xml = model_description_of(&fmu).map_err(failed)?;
        let description = ModelDescription::parse(&xml)
            .map_err(|reason| failed(format!("modelDescription.xml: {reason}")))?;
        Ok(Component { name: name.to_owned(), fmu, description })
    }
}

fn model_description_of(fmu: &[u8]) -> Result<String, String> {
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(fmu)).map_err(|error| error.to_string())?;
    let file = archive.by_name("modelDescription.xml");
    let file = file.map_err(|error| format!("modelDescription.xml: {error}"))?;
    std::io::read_to_string(file).map_err(|error| format!("modelDescription.xml: {error}"))
}
