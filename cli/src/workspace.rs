//! What commands take when nothing else is asked for, as it is called in a checkout; elsewhere see [`crate::home`].

use std::path::PathBuf;

/// The aircraft of all commands, by its name: the generic business jet.
pub fn aircraft() -> PathBuf {
    "generic-business-jet".into()
}

/// Where its FMU is packaged to, from flexible-aircraft's own folder.
pub fn fmu() -> PathBuf {
    "target/fmu/FlexibleAircraft.fmu".into()
}
