//! Whether a file is flexible-aircraft's shared library for a platform, read without loading it: a wrong one would
//! show only where somebody imports the FMU on that platform.

use std::fmt;

use flexible_aircraft::fmi::{self, Version};
use object::read::NameOrOrdinal;
use object::read::macho::{FatArch, MachOFatFile32};
use object::{Architecture, BinaryFormat, FileKind, Object, ObjectKind};

use crate::{Platform, Processor};

/// The versions of FMI whose functions a library has to export, whatever archive it goes into: one library serves all.
const VERSIONS: &[Version] = &[Version::V2, Version::V3];

/// Why a file cannot be the shared library of a platform.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LibraryFault {
    /// It is no shared library, or damaged.
    #[error("found a file that is no shared library ({reason}), expected for {platform} is {}", needed_on(*platform))]
    Unreadable {
        /// The platform that it was given for.
        platform: Platform,
        /// What is wrong with it.
        reason: String,
    },
    /// It is a library of another platform.
    #[error("found {found}, expected for {platform} is {}", needed_on(*platform))]
    OtherMachine {
        /// The platform that it was given for.
        platform: Platform,
        /// Format and processor.
        found: String,
    },
    /// It does not export all functions of a version of FMI.
    #[error(
        "it exports {exported} of the functions of FMI {}, and lacks {}",
        version.number(), missing.join(", ")
    )]
    MissingFunctions {
        /// Of FMI.
        version: Version,
        /// How many it has.
        exported: usize,
        /// Those it has not.
        missing: Vec<&'static str>,
    },
    /// It does not say that it was built of flexible-aircraft.
    #[error("it is no library of flexible-aircraft, or older than its marks of origin")]
    NoMark,
    /// It was built of other sources.
    #[error("found {found}, expected is {expected}: build both of the same sources")]
    OtherBuild {
        /// What it was built of.
        found: BuildMark,
        /// What it should have been built of.
        expected: BuildMark,
    },
}

/// Version and sources that a library was built of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BuildMark(String);

impl BuildMark {
    /// That of this program.
    pub fn own() -> Self {
        BuildMark(fmi::BUILD_MARK.to_owned())
    }

    /// The mark among the bytes of a library.
    fn find(bytes: &[u8]) -> Option<Self> {
        let beginning = fmi::BUILD_MARK_BEGINNING.as_bytes();
        let at = bytes.windows(beginning.len()).position(|window| window == beginning)?;
        let end = bytes[at..].iter().take(100).position(|byte| *byte == b')')?;
        String::from_utf8(bytes[at..=at + end].to_vec()).ok().map(BuildMark)
    }
}

impl fmt::Display for BuildMark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// What a library is, as far as that can be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Examined {
    /// What it was built of.
    pub mark: BuildMark,
    /// On which it runs.
    pub processors: Vec<Processor>,
}

/// Reads a library that is meant for a platform.
pub(crate) fn examine(bytes: &[u8], platform: Platform) -> Result<Examined, LibraryFault> {
    let unreadable = |error: object::Error| LibraryFault::Unreadable { platform, reason: error.to_string() };
    let (mut marks, mut processors) = (Vec::new(), Vec::new());
    for image in images(bytes).map_err(unreadable)? {
        let file = object::File::parse(image).map_err(unreadable)?;
        let other = || LibraryFault::OtherMachine { platform, found: words(&file) };
        processors.push(processor(&file).filter(|_| fits(&file, platform)).ok_or_else(other)?);
        require_functions(&exports(&file).map_err(unreadable)?)?;
        marks.push(BuildMark::find(image).ok_or(LibraryFault::NoMark)?);
    }
    let mark = marks.pop().ok_or(LibraryFault::NoMark)?;
    match marks.into_iter().find(|other| *other != mark) {
        Some(found) => Err(LibraryFault::OtherBuild { found, expected: mark }),
        None => Ok(Examined { mark, processors }),
    }
}

/// The processor of a library, if it is one that platforms have.
fn processor(file: &object::File<'_>) -> Option<Processor> {
    match file.architecture() {
        Architecture::Aarch64 => Some(Processor::Aarch64),
        Architecture::X86_64 => Some(Processor::X86_64),
        _ => None,
    }
}

/// The libraries in a file: one, but for macOS one for each of several processors.
fn images(bytes: &[u8]) -> object::Result<Vec<&[u8]>> {
    match FileKind::parse(bytes)? {
        FileKind::MachOFat32 => {
            MachOFatFile32::parse(bytes)?.arches().iter().map(|arch| arch.data(bytes)).collect()
        }
        _ => Ok(vec![bytes]),
    }
}

fn fits(file: &object::File<'_>, platform: Platform) -> bool {
    let machine = match platform {
        Platform::Aarch64Linux => processor(file) == Some(Processor::Aarch64),
        Platform::Darwin64 => processor(file).is_some(),
        Platform::Linux64 | Platform::Win64 => processor(file) == Some(Processor::X86_64),
    };
    machine
        && file.format() == format(platform)
        && file.is_little_endian()
        && file.kind() == ObjectKind::Dynamic
}

fn format(platform: Platform) -> BinaryFormat {
    match platform {
        Platform::Aarch64Linux | Platform::Linux64 => BinaryFormat::Elf,
        Platform::Darwin64 => BinaryFormat::MachO,
        Platform::Win64 => BinaryFormat::Pe,
    }
}

/// What the library of a platform is, in words as those of [`words`].
fn needed_on(platform: Platform) -> &'static str {
    match platform {
        Platform::Aarch64Linux => "a shared library (ELF) for aarch64",
        Platform::Darwin64 => "a shared library (MachO) for x86_64, aarch64 or both",
        Platform::Linux64 => "a shared library (ELF) for x86_64",
        Platform::Win64 => "a shared library (PE) for x86_64",
    }
}

fn words(file: &object::File<'_>) -> String {
    let kind = match file.kind() {
        ObjectKind::Dynamic => "a shared library",
        ObjectKind::Executable => "a program",
        _ => "an object file",
    };
    let format = match file.format() {
        BinaryFormat::Elf => "ELF".to_owned(),
        BinaryFormat::Pe => "PE".to_owned(),
        other => format!("{other:?}"),
    };
    format!("{kind} ({format}) for {}", format!("{:?}", file.architecture()).to_lowercase())
}

/// The names that a library exports; macOS puts a line before those of C.
fn exports(file: &object::File<'_>) -> object::Result<Vec<String>> {
    let line = if file.format() == BinaryFormat::MachO { "_" } else { "" };
    let mut names = Vec::new();
    for export in file.exports()? {
        if let NameOrOrdinal::Name(name) = export?.name() {
            let name = String::from_utf8_lossy(name);
            names.push(name.strip_prefix(line).unwrap_or(&name).to_owned());
        }
    }
    Ok(names)
}

fn require_functions(exports: &[String]) -> Result<(), LibraryFault> {
    let is_there = |name: &&str| exports.iter().any(|export| export == name);
    for &version in VERSIONS {
        let (there, missing): (Vec<_>, Vec<_>) = version.function_names().partition(is_there);
        if !missing.is_empty() {
            return Err(LibraryFault::MissingFunctions { version, exported: there.len(), missing });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mark_is_found_among_other_bytes() {
        let mark = BuildMark::own();
        let bytes = [b"\0\xffflexible-aircraft ", fmi::BUILD_MARK.as_bytes(), b")\0"].concat();
        assert_eq!(BuildMark::find(&bytes), Some(mark));
        assert_eq!(BuildMark::find(&bytes[..40]), None);
        assert_eq!(BuildMark::find(b""), None);
    }

    #[test]
    fn a_file_that_is_no_library_is_refused() {
        for bytes in
            [b"localhost\n".as_slice(), b"", b"MZ", b"\x7fELF\x01\x01", b"\xca\xfe\xba\xbe\0\0\0\x01"]
        {
            for platform in Platform::ALL {
                let fault = examine(bytes, platform).unwrap_err();
                assert!(matches!(fault, LibraryFault::Unreadable { .. }), "{bytes:?}: {fault}");
            }
        }
    }

    #[test]
    fn a_program_and_a_library_for_another_machine_are_refused() {
        let header = |kind: u8, machine: u8| {
            let mut elf = [0; 64];
            elf[..7].copy_from_slice(b"\x7fELF\x02\x01\x01");
            (elf[16], elf[18], elf[20], elf[52]) = (kind, machine, 1, 64);
            elf
        };
        let message = |bytes: &[u8]| examine(bytes, Platform::Linux64).unwrap_err().to_string();
        let expected = "expected for linux64 is a shared library (ELF) for x86_64";
        assert_eq!(message(&header(3, 183)), format!("found a shared library (ELF) for aarch64, {expected}"));
        assert_eq!(message(&header(2, 62)), format!("found a program (ELF) for x86_64, {expected}"));
        assert!(
            message(&header(3, 62)).contains("exports 0 of the functions"),
            "{}",
            message(&header(3, 62))
        );
    }
}
