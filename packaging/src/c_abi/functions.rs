//! The functions of a library, of the version that its archive is of.

use std::ffi::c_int;

use flexible_aircraft::fmi::Version;
use libloading::Library;

use super::{fmi2, fmi3};

/// Those of one version.
pub(super) enum Functions {
    V2(fmi2::Functions),
    V3(fmi3::Functions),
}

impl Functions {
    pub(super) fn of(library: &Library, version: Version) -> Result<Self, libloading::Error> {
        Ok(match version {
            Version::V2 => Functions::V2(fmi2::Functions::of(library)?),
            Version::V3 => Functions::V3(fmi3::Functions::of(library)?),
        })
    }

    /// What this version calls a status.
    pub(super) fn status_name(&self, status: c_int) -> &'static str {
        let names: &[&'static str] = match self {
            Functions::V2(_) => &fmi2::STATUS_NAMES,
            Functions::V3(_) => &fmi3::STATUS_NAMES,
        };
        let known = usize::try_from(status).ok().and_then(|status| names.get(status));
        known.copied().unwrap_or("an unknown status")
    }
}
