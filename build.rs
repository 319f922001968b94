//! Hashes the sources, for the mark by which a shared library is told from one built of others: see
//! `src/fmi/build_mark.rs`.

use std::path::{Path, PathBuf};
use std::{fs, io};

/// What decides what the library does; folders with all that is in them.
const SOURCES: [&str; 3] = ["src", "Cargo.toml", "Cargo.lock"];

fn main() -> io::Result<()> {
    let mut files = Vec::new();
    for source in SOURCES {
        println!("cargo::rerun-if-changed={source}");
        collect(Path::new(source), &mut files)?;
    }
    files.sort();
    let mut hash = 0xcbf2_9ce4_8422_2325; // FNV-1a, 64 bits: the same with every compiler
    for (name, path) in files {
        let text = fs::read(path)?;
        // Git may give lines another end elsewhere.
        let bytes = name.bytes().chain([0]).chain(text.into_iter().filter(|byte| *byte != b'\r')).chain([0]);
        hash = bytes.fold(hash, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3));
    }
    println!("cargo::rustc-env=FLEXIBLE_AIRCRAFT_SOURCES={hash:016x}");
    Ok(())
}

/// Adds the files at a path, each with its name as it is everywhere.
fn collect(path: &Path, files: &mut Vec<(String, PathBuf)>) -> io::Result<()> {
    if path.is_dir() {
        for entry in fs::read_dir(path)? {
            collect(&entry?.path(), files)?;
        }
    } else if path.is_file() {
        files.push((path.to_string_lossy().replace('\\', "/"), path.to_owned()));
    }
    Ok(())
}
