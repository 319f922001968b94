//! The files of a deck: INCLUDE is followed, to files alone, not in circles, and not without end.

use std::path::{Path, PathBuf};

use super::{DeckFile, Place};

/// How deep files may name one another.
pub const DEEPEST: usize = 16;

/// All files of a deck together: bytes, lines (those that include files too), and how many. Assemblies of aircraft have a tenth of it.
pub const MOST_BYTES: usize = 64 << 20;
pub const MOST_LINES: usize = 1_000_000;
pub const MOST_FILES: usize = 1000;

/// What editors put before a text to say that it is UTF-8.
const MARK: char = '\u{feff}';

/// Where the texts of files come from.
pub trait Source {
    /// The text of a file and the path that is the same however it is named.
    ///
    /// # Errors
    /// Why it cannot be read, in words.
    fn read(&self, path: &Path) -> Result<(PathBuf, String), String>;
}

/// Files on disk.
pub struct OnDisk;

impl Source for OnDisk {
    fn read(&self, path: &Path) -> Result<(PathBuf, String), String> {
        let about = std::fs::metadata(path).map_err(|error| error.to_string())?;
        if !about.is_file() {
            return Err("it is no file".to_owned());
        }
        if about.len() > MOST_BYTES as u64 {
            return Err(format!("it has {} bytes, allowed are {MOST_BYTES}", about.len()));
        }
        let bytes = std::fs::read(path).map_err(|error| error.to_string())?;
        let same = path.canonicalize().map_err(|error| error.to_string())?;
        // Comments of old decks are in whatever alphabet.
        Ok((same, String::from_utf8_lossy(&bytes).into_owned()))
    }
}

/// A line of the deck: its number in its file, the bytes of it there.
pub struct DeckLine {
    pub place: Place,
    pub bytes: std::ops::Range<usize>,
}

/// A file that is missing, a circle, too much.
#[derive(Debug, PartialEq)]
pub struct Refused {
    /// None for the deck itself.
    pub place: Option<(Place, std::ops::Range<usize>)>,
    pub found: String,
    pub allowed: String,
}

/// All files, and all lines in the order in which they count. INCLUDE lines themselves are not among them.
pub struct Files {
    pub files: Vec<DeckFile>,
    pub lines: Vec<DeckLine>,
    bytes: usize,
    /// Lines of the texts, whatever they are.
    read: usize,
}

impl Files {
    /// All up to the first that cannot be had, and why it cannot.
    pub fn read(deck: &Path, source: &dyn Source) -> (Files, Option<Refused>) {
        let mut files = Files { files: Vec::new(), lines: Vec::new(), bytes: 0, read: 0 };
        let refused = files.follow(&[deck.to_owned()], None, (source, &mut Vec::new())).err();
        (files, refused)
    }

    /// Reads the first of some paths that can be read, and what it includes.
    fn follow(
        &mut self,
        paths: &[PathBuf],
        named_at: Option<&(Place, std::ops::Range<usize>)>,
        (source, above): (&dyn Source, &mut Vec<PathBuf>),
    ) -> Result<(), Refused> {
        let refuse = |found: String, allowed: &str| Refused {
            place: named_at.cloned(),
            found,
            allowed: allowed.to_owned(),
        };
        if above.len() > DEEPEST {
            let allowed = format!("{DEEPEST} levels of files that include files are allowed");
            return Err(refuse(format!("found {} one level deeper", paths[0].display()), &allowed));
        }
        let (path, same, text) =
            first_of(paths, source).map_err(|found| refuse(found, "a file that can be read is allowed"))?;
        let shown = path.display();
        if above.contains(&same) {
            let found = format!("found {shown}, which leads here");
            return Err(refuse(
                found,
                "a file is allowed that does not include itself, not by others either",
            ));
        }
        self.bytes += text.len();
        self.read += text.lines().count();
        if self.bytes > MOST_BYTES || self.read > MOST_LINES || self.files.len() >= MOST_FILES {
            let allowed = format!(
                "{MOST_FILES} files, {} MiB and {MOST_LINES} lines are allowed of all files together",
                MOST_BYTES >> 20
            );
            return Err(refuse(format!("found more with {shown}"), &allowed));
        }
        let file = self.files.len();
        let includes = includes(&text);
        let begins = begins(&text);
        self.files.push(DeckFile { name: shown.to_string(), text });
        above.push(same);
        let mut next = 0;
        for include in includes {
            self.add_lines(file, &begins, next..include.lines.start);
            let place = Place { file, line: include.lines.start + 1 };
            let named_at = (place, begins[include.lines.start].clone());
            if include.path.is_empty() {
                let (found, allowed) =
                    ("found no path".to_owned(), "the path of a file is needed".to_owned());
                return Err(Refused { place: Some(named_at), found, allowed });
            }
            let paths = self.places_of(&include.path, path);
            self.follow(&paths, Some(&named_at), (source, above))?;
            next = include.lines.end;
        }
        self.add_lines(file, &begins, next..begins.len());
        above.pop();
        Ok(())
    }

    /// Where an included file may be: beside the file that includes it, else beside the deck.
    fn places_of(&self, included: &str, from: &Path) -> Vec<PathBuf> {
        let deck = self.files.first().map_or(Path::new(""), |deck| Path::new(&deck.name));
        let mut places: Vec<PathBuf> =
            [from, deck].map(|file| file.parent().unwrap_or(Path::new("")).join(included)).into();
        places.dedup();
        places
    }

    fn add_lines(&mut self, file: usize, begins: &[std::ops::Range<usize>], lines: std::ops::Range<usize>) {
        let line =
            |line: usize| DeckLine { place: Place { file, line: line + 1 }, bytes: begins[line].clone() };
        self.lines.extend(lines.map(line));
    }
}

/// Of the first path that can be read: itself, the one that it always has, its text.
fn first_of<'p>(paths: &'p [PathBuf], source: &dyn Source) -> Result<(&'p Path, PathBuf, String), String> {
    let mut failed = Vec::new();
    for path in paths {
        match source.read(path) {
            Ok((same, text)) => {
                let text = text.strip_prefix(MARK).map(str::to_owned).unwrap_or(text);
                return Ok((path, same, text));
            }
            Err(why) => failed.push(format!("{}, which cannot be read: {why}", path.display())),
        }
    }
    Err(format!("found {}", failed.join("; nor ")))
}

/// The bytes of each line, without its end.
fn begins(text: &str) -> Vec<std::ops::Range<usize>> {
    let mut at = 0;
    let bytes = |line: &str| {
        let begin = at;
        at += line.len();
        begin..begin + line.trim_end_matches(['\n', '\r']).len()
    };
    text.split_inclusive('\n').map(bytes).collect()
}

/// An INCLUDE with its file.
struct Include {
    lines: std::ops::Range<usize>,
    path: String,
}

/// A path in quotes may run over several lines, and begin on the next one.
fn includes(text: &str) -> Vec<Include> {
    let lines: Vec<&str> = text.lines().collect();
    let mut found = Vec::new();
    let mut at = 0;
    while at < lines.len() {
        let begin = at;
        at += 1;
        let Some(rest) = after_include(lines[begin]) else { continue };
        let mut path = rest.trim().to_owned();
        if path.is_empty() {
            let next = lines.get(at).filter(|next| next.trim_start().starts_with(QUOTES));
            path = next.map_or_else(String::new, |next| next.trim().to_owned());
            at += usize::from(next.is_some());
        }
        if let Some(quote) = path.chars().next().filter(|letter| QUOTES.contains(letter)) {
            path.remove(0);
            while !path.contains(quote) && at < lines.len() && at - begin < DEEPEST {
                path += lines[at].trim();
                at += 1;
            }
            path = path.split(quote).next().unwrap_or_default().to_owned();
        } else {
            path = path.split('$').next().unwrap_or_default().trim().to_owned();
        }
        found.push(Include { lines: begin..at, path });
    }
    found
}

/// What a path may stand in.
const QUOTES: [char; 2] = ['\'', '"'];

fn after_include(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let word = line.get(..7)?;
    let rest = line.get(7..)?;
    let ends = rest.trim().is_empty() || rest.starts_with([' ', '\t', '\'', '"', '=']);
    (word.eq_ignore_ascii_case("include") && ends).then(|| rest.trim_start().trim_start_matches('='))
}
