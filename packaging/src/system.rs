//! Several FMUs and the connections between them, checked, and written as masters read them: an SSP archive
//! (System Structure and Parameterization 1.0, or 2.0 where a component is of FMI 3.0) or a folder for libcosim (OSP system
//! structure 0.1).

use std::path::{Path, PathBuf};

mod check;
mod component;
mod connection;
mod endpoint;
mod error;
mod experiment;
mod osp;
mod setting;
mod ssp;
#[cfg(test)]
mod tests;
mod whole;
mod xml;

pub use component::Component;
pub use endpoint::Endpoint;
pub use error::{ConnectionError, Misfit, SystemError};
pub use experiment::Experiment;
pub use whole::System;

use crate::{Draft, PackageError};

/// Name of libcosim's own description of a system.
const OSP_STRUCTURE: &str = "OspSystemStructure.xml";

impl System {
    /// Writes the `.ssp`; equal systems give equal bytes.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_ssp(&self, output: &Path) -> Result<(), PackageError> {
        Ok(Draft::write(&ssp::to_bytes(self)?, output)?.keep()?)
    }

    /// The files that [`write_osp`](Self::write_osp) writes.
    pub fn osp_files(&self, folder: &Path) -> Vec<PathBuf> {
        let fmus = self.components.iter().map(|component| format!("{}.fmu", component.name));
        fmus.chain([OSP_STRUCTURE.to_owned()]).map(|name| folder.join(name)).collect()
    }

    /// Writes `OspSystemStructure.xml` and the FMUs into a folder, which is made where it does not exist.
    ///
    /// # Errors
    /// As [`check_for_osp`](Self::check_for_osp), or when a file cannot be written.
    pub fn write_osp(&self, folder: &Path) -> Result<(), SystemError> {
        self.check_for_osp()?;
        let structure = osp::structure(self);
        let contents = self.components.iter().map(|component| component.fmu.as_slice());
        let drafts: Vec<Draft> = contents
            .chain([structure.as_slice()])
            .zip(self.osp_files(folder))
            .map(|(content, path)| Draft::write(content, &path))
            .collect::<Result<_, _>>()?;
        Ok(drafts.into_iter().try_for_each(Draft::keep)?)
    }
}
