//! What a folder of parts belongs to: by it a sweep goes on where it was stopped, and no other does.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use flexible_aircraft::fmi::{BUILD_MARK, BUILD_MARK_BEGINNING};
use flexible_aircraft_packaging::{Draft, FileError};
use serde_json::{Value, json};
use twox_hash::XxHash3_128;

/// Points of a part but the last.
pub const POINTS_PER_PART: u64 = 1000;

const NAME: &str = "manifest.json";

/// What decides the bytes of all parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Identity {
    /// Of the program, with the hash of its sources.
    version: String,
    /// Hashes (XXH3, 128 bits).
    sweep: String,
    aircraft: String,
}

/// Why a folder cannot have the parts of a sweep.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    File(#[from] FileError),
    #[error(
        "{} is of another sweep: {} differ; its parts stay as they are: name another --output, or delete the folder",
        path.display(),
        differences.join(", ")
    )]
    Other { path: PathBuf, differences: Vec<String> },
    #[error("{} is not what a sweep writes: name another --output, or delete the folder", .0.display())]
    Unreadable(PathBuf),
    #[error("{} has parts of a sweep and no {NAME} that says of which: name another --output, or delete them", .0.display())]
    Missing(PathBuf),
}

/// The place of a sweep's parts.
pub struct Folder {
    path: PathBuf,
    /// Until it is sure that there is something to do.
    manifest: Option<Draft>,
}

impl Identity {
    /// Of the bytes of both files.
    pub fn new(sweep: &[u8], aircraft: &[u8]) -> Self {
        let hash = |bytes| format!("{:032x}", XxHash3_128::oneshot(bytes));
        let version = BUILD_MARK.strip_prefix(BUILD_MARK_BEGINNING).unwrap_or(BUILD_MARK);
        Identity { version: version.to_owned(), sweep: hash(sweep), aircraft: hash(aircraft) }
    }

    /// With what readers want to know.
    fn manifest(&self, points: Option<u64>) -> Value {
        json!({
            "format": 1,
            "version": self.version,
            "sweep_xxh3_128": self.sweep,
            "aircraft_xxh3_128": self.aircraft,
            "points": points,
            "points_per_part": POINTS_PER_PART,
        })
    }

    /// What of a manifest is not as it would be here.
    fn differences(&self, manifest: &Value) -> Vec<String> {
        let own = self.manifest(None);
        let named = [
            ("format", "the form of the parts"),
            ("version", "the version of the program"),
            ("sweep_xxh3_128", "the sweep file"),
            ("aircraft_xxh3_128", "the aircraft file"),
            ("points_per_part", "the points of a part"),
        ];
        let differ = named.into_iter().filter(|(key, _)| manifest[key] != own[key]);
        let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        differ
            .map(|(key, name)| format!("{name} ({} there, {} here)", text(&manifest[key]), text(&own[key])))
            .collect()
    }
}

impl Folder {
    /// A folder for the parts of a sweep of so many points, yet to be written to or with some of them.
    ///
    /// # Errors
    /// When it cannot be written to, or has something else.
    pub fn open(path: &Path, identity: &Identity) -> Result<Self, Error> {
        let manifest = path.join(NAME);
        let folder = |manifest| Folder { path: path.to_owned(), manifest };
        if !manifest.exists() {
            if folder(None).part(0).exists() {
                return Err(Error::Missing(path.to_owned()));
            }
            return Ok(folder(Some(Draft::new(&manifest)?)));
        }
        let failed = |source| FileError { action: "read", path: manifest.clone(), source };
        let text = std::fs::read_to_string(&manifest).map_err(failed)?;
        let found: Value = serde_json::from_str(&text).map_err(|_| Error::Unreadable(manifest.clone()))?;
        let differences = identity.differences(&found);
        if differences.is_empty() {
            Ok(folder(None))
        } else {
            Err(Error::Other { path: manifest, differences })
        }
    }

    /// Says of which sweep the parts are that follow.
    ///
    /// # Errors
    /// When that cannot be written.
    pub fn begin(&mut self, identity: &Identity, points: u64) -> Result<(), Error> {
        if let Some(mut draft) = self.manifest.take() {
            let failed = |source| FileError { action: "write", path: self.path.join(NAME), source };
            let text = format!("{:#}\n", identity.manifest(Some(points)));
            draft.write_all(text.as_bytes()).map_err(failed)?;
            draft.keep()?;
        }
        Ok(())
    }

    /// Where a part stands.
    pub fn part(&self, number: u64) -> PathBuf {
        self.path.join(format!("part-{number:05}.parquet"))
    }

    /// Of which sweep it is.
    pub fn manifest(&self) -> PathBuf {
        self.path.join(NAME)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_gone_on_with_by_the_same_sweep_alone_and_others_are_told_what_differs() {
        let parent = tempfile::tempdir().unwrap();
        let path = parent.path().join("new");
        let identity = Identity::new(b"sweep", b"aircraft");
        let open = |identity: &Identity| Folder::open(&path, identity);
        // Before it begins nothing is left behind.
        drop(open(&identity).unwrap());
        assert!(!path.exists());
        open(&identity).unwrap().begin(&identity, 2500).unwrap();
        let text = std::fs::read_to_string(path.join(NAME)).unwrap();
        let manifest: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(
            (manifest["points"].as_u64(), manifest["points_per_part"].as_u64()),
            (Some(2500), Some(1000))
        );
        let mut again = open(&identity).unwrap();
        again.begin(&identity, 2500).unwrap();
        assert_eq!(std::fs::read_to_string(again.manifest()).unwrap(), text);
        assert_eq!(again.part(7), path.join("part-00007.parquet"));
        let refused = |identity: &Identity| open(identity).err().unwrap().to_string();
        let other = refused(&Identity::new(b"another", b"aircraft"));
        assert!(
            other.contains("of another sweep: the sweep file (") && !other.contains("the aircraft file"),
            "{other}"
        );
        let both = refused(&Identity { version: "0.0.1".to_owned(), ..Identity::new(b"sweep", b"other") });
        assert!(
            both.contains("the version of the program (")
                && both.contains("0.0.1 here), the aircraft file ("),
            "{both}"
        );
        std::fs::write(path.join(NAME), "[").unwrap();
        assert!(refused(&identity).contains("is not what a sweep writes"));
        std::fs::remove_file(path.join(NAME)).unwrap();
        std::fs::write(again.part(0), "").unwrap();
        assert!(refused(&identity).contains("has parts of a sweep and no manifest.json"));
    }

    /// XXH3-128 of nothing, as the reference implementation has it: `xxhsum -H2 /dev/null`.
    #[test]
    fn hashes_are_the_published_ones() {
        assert_eq!(Identity::new(b"", b"").sweep, "99aa06d3014798d86001c324468d497f");
    }
}
