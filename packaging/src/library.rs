//! Whether a file is a shared library of a platform, as its first bytes say: a wrong file would show only where
//! somebody imports the FMU on that platform.

use std::fmt;

use crate::Platform;

/// What a file is, by its first bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileKind {
    /// Of Unix systems but macOS; with the machine's number in the file format.
    Elf(u16),
    /// Of Windows; with the machine's number in the file format.
    PortableExecutable(u16),
    /// Of macOS, for one machine or several.
    MachO,
    /// None of these.
    Other,
}

const ELF_X86_64: u16 = 62;
const ELF_AARCH64: u16 = 183;
const PE_X86_64: u16 = 0x8664;

impl FileKind {
    pub(crate) fn of(bytes: &[u8]) -> Self {
        match bytes {
            // 64 bits, little-endian.
            [0x7f, b'E', b'L', b'F', 2, 1, ..] => FileKind::Elf(word(bytes, 18)),
            [0xcf, 0xfa, 0xed, 0xfe, ..] | [0xca, 0xfe, 0xba, 0xbe, ..] => FileKind::MachO,
            [b'M', b'Z', ..] => {
                let header = usize::from(word(bytes, 0x3c)) | usize::from(word(bytes, 0x3e)) << 16;
                match bytes.get(header..) {
                    Some(header @ [b'P', b'E', 0, 0, ..]) => FileKind::PortableExecutable(word(header, 4)),
                    _ => FileKind::Other,
                }
            }
            _ => FileKind::Other,
        }
    }

    /// What the shared library of a platform must be.
    pub(crate) fn needed_on(platform: Platform) -> Self {
        match platform {
            Platform::Aarch64Linux => FileKind::Elf(ELF_AARCH64),
            Platform::Darwin64 => FileKind::MachO,
            Platform::Linux64 => FileKind::Elf(ELF_X86_64),
            Platform::Win64 => FileKind::PortableExecutable(PE_X86_64),
        }
    }
}

/// Two bytes, little-endian; 0 beyond the end.
fn word(bytes: &[u8], at: usize) -> u16 {
    bytes.get(at..at + 2).map_or(0, |pair| u16::from_le_bytes([pair[0], pair[1]]))
}

impl fmt::Display for FileKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FileKind::Elf(ELF_X86_64) => f.write_str("an ELF file for x86-64"),
            FileKind::Elf(ELF_AARCH64) => f.write_str("an ELF file for aarch64"),
            FileKind::Elf(machine) => write!(f, "an ELF file for machine {machine}"),
            FileKind::PortableExecutable(PE_X86_64) => f.write_str("a Windows library (MZ, PE) for x86-64"),
            FileKind::PortableExecutable(machine) => {
                write!(f, "a Windows library (MZ, PE) for machine {machine:#x}")
            }
            FileKind::MachO => f.write_str("a Mach-O file"),
            FileKind::Other => f.write_str("a file that is no 64-bit shared library"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn libraries_are_told_apart_by_their_first_bytes() {
        let elf = |machine: u8| [b"\x7fELF\x02\x01".as_slice(), &[0; 12], &[machine, 0]].concat();
        let windows =
            |machine: [u8; 2]| [b"MZ".as_slice(), &[0; 0x3a], &[0x40, 0, 0, 0], b"PE\0\0", &machine].concat();
        for (bytes, platform) in [
            (elf(62), Platform::Linux64),
            (elf(183), Platform::Aarch64Linux),
            (windows([0x64, 0x86]), Platform::Win64),
            (vec![0xcf, 0xfa, 0xed, 0xfe], Platform::Darwin64),
            (vec![0xca, 0xfe, 0xba, 0xbe], Platform::Darwin64),
        ] {
            let fits = |other: &Platform| FileKind::of(&bytes) == FileKind::needed_on(*other);
            let on: Vec<_> = Platform::ALL.into_iter().filter(fits).collect();
            assert_eq!(on, [platform]);
        }
        for bytes in [b"localhost\n".as_slice(), b"", b"MZ", b"\x7fELF\x01\x01", &windows([0; 2])[..0x40]] {
            assert_eq!(FileKind::of(bytes), FileKind::Other, "{bytes:?}");
        }
        assert_eq!(
            FileKind::of(&windows([0x64, 0xaa])).to_string(),
            "a Windows library (MZ, PE) for machine 0xaa64"
        );
    }
}
