//! The platforms whose shared libraries an FMU can carry.

use std::fmt;
use std::str::FromStr;

use flexible_aircraft::fmi::Version;

/// A platform for which there is one shared library, called after its folder under `binaries/` in FMI 2.0.
///
/// FMI 2.0 names 64-bit x86 folders only; `aarch64-linux` is the name of FMI 3.0, which importers on ARM
/// Linux look for in FMI 2.0 archives too. `darwin64` may hold a universal library, for which FMI 3.0 has two folders.
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

/// A processor that platforms have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Processor {
    /// ARM.
    Aarch64,
    /// x86.
    X86_64,
}

impl Platform {
    /// All platforms, in the order of their names.
    pub const ALL: [Platform; 4] =
        [Platform::Aarch64Linux, Platform::Darwin64, Platform::Linux64, Platform::Win64];

    /// The platform this program runs on; `None` where no version of FMI has a folder that we build for.
    pub fn host() -> Option<Self> {
        match (std::env::consts::OS, std::env::consts::ARCH) {
            ("linux", "x86_64") => Some(Platform::Linux64),
            ("linux", "aarch64") => Some(Platform::Aarch64Linux),
            ("macos", _) => Some(Platform::Darwin64),
            ("windows", "x86_64") => Some(Platform::Win64),
            _ => None,
        }
    }

    /// As people name it: the folder of FMI 2.0.
    pub fn name(self) -> &'static str {
        match self {
            Platform::Aarch64Linux => "aarch64-linux",
            Platform::Darwin64 => "darwin64",
            Platform::Linux64 => "linux64",
            Platform::Win64 => "win64",
        }
    }

    /// On which it runs.
    pub fn processors(self) -> &'static [Processor] {
        match self {
            Platform::Aarch64Linux => &[Processor::Aarch64],
            Platform::Darwin64 => &Processor::ALL,
            Platform::Linux64 | Platform::Win64 => &[Processor::X86_64],
        }
    }

    /// Name of the folder under `binaries/` for one of its processors. FMI 2.0 has one folder for both of macOS.
    pub fn folder(self, version: Version, processor: Processor) -> &'static str {
        match (version, self, processor) {
            (Version::V2, ..) => self.name(),
            (Version::V3, Platform::Aarch64Linux, _) => "aarch64-linux",
            (Version::V3, Platform::Darwin64, Processor::Aarch64) => "aarch64-darwin",
            (Version::V3, Platform::Darwin64, Processor::X86_64) => "x86_64-darwin",
            (Version::V3, Platform::Linux64, _) => "x86_64-linux",
            (Version::V3, Platform::Win64, _) => "x86_64-windows",
        }
    }

    /// Where an FMU keeps the library of this platform for one of its processors, with forward slashes.
    pub fn library_path(self, version: Version, processor: Processor, model_identifier: &str) -> String {
        let extension = match self {
            Platform::Aarch64Linux | Platform::Linux64 => "so",
            Platform::Darwin64 => "dylib",
            Platform::Win64 => "dll",
        };
        format!("binaries/{}/{model_identifier}.{extension}", self.folder(version, processor))
    }

    /// The platform and the processor whose library an FMU keeps at a path; in FMI 2.0 any processor of macOS.
    pub(crate) fn of_library_path(
        path: &str,
        version: Version,
        model_identifier: &str,
    ) -> Option<(Self, Processor)> {
        let all = Platform::ALL.into_iter();
        let mut all = all.flat_map(|one| one.processors().iter().map(move |processor| (one, *processor)));
        all.find(|(platform, processor)| platform.library_path(version, *processor, model_identifier) == path)
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

impl Processor {
    /// Both.
    pub const ALL: [Processor; 2] = [Processor::Aarch64, Processor::X86_64];

    /// That of the machine this program runs on.
    pub fn host() -> Self {
        if std::env::consts::ARCH == "aarch64" { Processor::Aarch64 } else { Processor::X86_64 }
    }
}

impl fmt::Display for Platform {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A word that names no platform.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{found}` is no platform; allowed are {}", Platform::ALL.map(Platform::name).join(", "))]
pub struct UnknownPlatform {
    found: String,
}

impl FromStr for Platform {
    type Err = UnknownPlatform;

    fn from_str(word: &str) -> Result<Self, UnknownPlatform> {
        let named = Platform::ALL.into_iter().find(|platform| platform.name() == word);
        named.ok_or_else(|| UnknownPlatform { found: word.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_platform_is_read_back_from_its_name() {
        for platform in Platform::ALL {
            assert_eq!(platform.name().parse(), Ok(platform));
        }
    }

    #[test]
    fn fmi_3_has_folders_of_its_own_and_two_for_macos() {
        let folders = |version| {
            let all = Platform::ALL.into_iter();
            let all = all.flat_map(|one| Processor::ALL.map(|processor| one.folder(version, processor)));
            let mut all: Vec<&str> = all.collect();
            all.dedup();
            all.join(" ")
        };
        assert_eq!(folders(Version::V2), "aarch64-linux darwin64 linux64 win64");
        assert_eq!(
            folders(Version::V3),
            "aarch64-linux aarch64-darwin x86_64-darwin x86_64-linux x86_64-windows"
        );
    }

    #[test]
    fn a_path_tells_the_platform_in_the_folders_of_its_version_alone() {
        let of = |path: &str, version| Platform::of_library_path(path, version, "M");
        for version in [Version::V2, Version::V3] {
            for platform in Platform::ALL {
                for processor in Processor::ALL {
                    let path = platform.library_path(version, processor, "M");
                    assert_eq!(of(&path, version).unwrap().0, platform, "{path}");
                }
            }
        }
        let arm = "binaries/aarch64-darwin/M.dylib";
        assert_eq!(of(arm, Version::V3), Some((Platform::Darwin64, Processor::Aarch64)));
        for (path, version) in [
            (arm, Version::V2),
            ("binaries/linux64/M.so", Version::V3),
            ("binaries/x86_64-linux/M.dll", Version::V3),
            ("binaries/x86_64-linux/N.so", Version::V3),
        ] {
            assert_eq!(of(path, version), None, "{path}");
        }
    }

    #[test]
    fn an_unknown_platform_is_refused_with_the_allowed_names() {
        let message = "amiga".parse::<Platform>().unwrap_err().to_string();
        assert_eq!(message, "`amiga` is no platform; allowed are aarch64-linux, darwin64, linux64, win64");
    }
}
