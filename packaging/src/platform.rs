//! The platforms whose shared libraries an FMU can carry.

use std::fmt;
use std::str::FromStr;

/// A platform, by its folder under `binaries/`.
///
/// FMI 2.0 names 64-bit x86 folders only; `aarch64-linux` is the name of FMI 3.0, which importers on ARM
/// Linux look for in FMI 2.0 archives too. `darwin64` may hold a universal library.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Platform {
    /// Linux on ARM.
    Aarch64Linux,
    /// macOS.
    Darwin64,
    /// Linux on x86.
    Linux64,
    /// Windows on x86.
    Win64,
}

impl Platform {
    /// All platforms, in the order of their folder names.
    pub const ALL: [Platform; 4] =
        [Platform::Aarch64Linux, Platform::Darwin64, Platform::Linux64, Platform::Win64];

    /// The platform this program runs on; `None` where FMI 2.0 has no folder for it.
    pub fn host() -> Option<Self> {
        match (std::env::consts::OS, std::env::consts::ARCH) {
            ("linux", "x86_64") => Some(Platform::Linux64),
            ("linux", "aarch64") => Some(Platform::Aarch64Linux),
            ("macos", _) => Some(Platform::Darwin64),
            ("windows", "x86_64") => Some(Platform::Win64),
            _ => None,
        }
    }

    /// Name of the folder under `binaries/`.
    pub fn folder(self) -> &'static str {
        match self {
            Platform::Aarch64Linux => "aarch64-linux",
            Platform::Darwin64 => "darwin64",
            Platform::Linux64 => "linux64",
            Platform::Win64 => "win64",
        }
    }

    /// Where an FMU keeps the library of this platform, with forward slashes.
    pub fn library_path(self, model_identifier: &str) -> String {
        let extension = match self {
            Platform::Aarch64Linux | Platform::Linux64 => "so",
            Platform::Darwin64 => "dylib",
            Platform::Win64 => "dll",
        };
        format!("binaries/{}/{model_identifier}.{extension}", self.folder())
    }

    /// The platform whose library an FMU keeps at a path.
    pub(crate) fn of_library_path(path: &str, model_identifier: &str) -> Option<Self> {
        Platform::ALL.into_iter().find(|platform| platform.library_path(model_identifier) == path)
    }

    /// Rust's name of the platform, for cargo.
    pub(crate) fn target_triple(self) -> &'static str {
        match self {
            Platform::Aarch64Linux => "aarch64-unknown-linux-gnu",
            Platform::Darwin64 => "x86_64-apple-darwin",
            Platform::Linux64 => "x86_64-unknown-linux-gnu",
            Platform::Win64 => "x86_64-pc-windows-gnu",
        }
    }
}

impl fmt::Display for Platform {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.folder())
    }
}

/// A word that names no platform.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{found}` is no platform; allowed are {}", Platform::ALL.map(Platform::folder).join(", "))]
pub struct UnknownPlatform {
    found: String,
}

impl FromStr for Platform {
    type Err = UnknownPlatform;

    fn from_str(word: &str) -> Result<Self, UnknownPlatform> {
        let named = Platform::ALL.into_iter().find(|platform| platform.folder() == word);
        named.ok_or_else(|| UnknownPlatform { found: word.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_platform_is_read_back_from_its_folder_name() {
        for platform in Platform::ALL {
            assert_eq!(platform.folder().parse(), Ok(platform));
        }
    }

    #[test]
    fn an_unknown_platform_is_refused_with_the_allowed_names() {
        let message = "amiga".parse::<Platform>().unwrap_err().to_string();
        assert_eq!(message, "`amiga` is no platform; allowed are aarch64-linux, darwin64, linux64, win64");
    }
}
