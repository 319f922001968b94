//! What is wrong with an aircraft file, said so that its author can put it right.
//!
//! Every reading step adds its complaints to one [`Report`], so that a file with five mistakes shows five
//! diagnostics and not the first of them.

use std::cell::RefCell;
use std::fmt;
use std::ops::Range;
use std::path::Path;

use thiserror::Error;

/// What kind of mistake a [`Diagnostic`] is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Problem {
    /// The text is not TOML.
    Syntax,
    /// A field that the format does not know.
    UnknownField,
    /// A field that must be there.
    MissingField,
    /// A text where a number should be, a list of the wrong length, and the like.
    WrongType,
    /// Infinity or not-a-number, written or computed.
    NotFinite,
    /// A number outside what its quantity can be.
    OutOfRange,
    /// Fields that exclude or need each other.
    Contradiction,
    /// A stiffness by which some strain has no energy, or a negative one.
    NotPositiveDefinite,
    /// Principal moments of inertia that no body has.
    UnphysicalInertia,
    /// A component that hangs on nothing.
    Disconnected,
    /// A beam element without length.
    ZeroLength,
    /// A reference direction parallel to what it should be perpendicular to.
    NoDirection,
    /// A place beyond the ends of its component.
    OffTheBeam,
    /// Two surfaces on one stretch of a component.
    Overlap,
    /// Something that nothing uses.
    Unused,
    /// A name used twice.
    DuplicateName,
    /// A reference to a name that does not exist.
    UnknownName,
    /// Nothing has mass.
    NoMass,
    /// Symmetric modes are asked for and something has no mirror image in y = 0.
    NotSymmetric,
}

/// One mistake: where it is, what was found and what is allowed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The kind of mistake.
    pub problem: Problem,
    /// Bytes of the source text to underline.
    pub span: Range<usize>,
    /// Line of the start of the span, from 1.
    pub line: usize,
    /// Column of the start of the span in characters, from 1.
    pub column: usize,
    /// Dotted path, for example `component.wing_right.chord_m`; list entries count from 1.
    pub field: String,
    /// What the file says.
    pub found: String,
    /// What it may say. At times lines to paste follow it.
    pub allowed: String,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}: {}; {}", self.line, self.column, self.field, self.found, self.allowed)
    }
}

/// Why an aircraft file was not understood.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum AircraftFileError {
    /// The file could not be read at all.
    #[error(
        "{file_name}: cannot read the aircraft file: {source}{}",
        looked_for(Path::new(file_name), source)
    )]
    Unreadable {
        /// As the caller named it.
        file_name: String,
        /// The operating system's reason.
        source: std::io::Error,
    },
    /// The text has mistakes. Displayed as one line `file:line:column: field: found; allowed` for each, at times with lines
    /// to paste below it.
    #[error("{}", lines(.file_name, .diagnostics))]
    Rejected {
        /// As the caller named it.
        file_name: String,
        /// The text that the spans refer to.
        text: String,
        /// At least one, in the order of the file.
        diagnostics: Vec<Diagnostic>,
    },
}

impl AircraftFileError {
    /// The mistakes found, in the order of the file; none when the file could not be read.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        match self {
            AircraftFileError::Unreadable { .. } => &[],
            AircraftFileError::Rejected { diagnostics, .. } => diagnostics,
        }
    }
}

/// Where a file that is not found was looked for, to be put behind a message; empty where the path says it.
pub fn looked_for(path: &Path, error: &std::io::Error) -> String {
    match std::path::absolute(path) {
        Ok(absolute) if error.kind() == std::io::ErrorKind::NotFound && absolute != path => {
            format!("; looked for {}", absolute.display())
        }
        _ => String::new(),
    }
}

fn lines(file_name: &str, diagnostics: &[Diagnostic]) -> String {
    let lines: Vec<String> = diagnostics.iter().map(|d| format!("{file_name}:{d}")).collect();
    lines.join("\n")
}

/// Where a value stands in the file, and what it is called.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) span: Range<usize>,
    pub(super) field: String,
}

impl Place {
    /// The same span, called by the name of a field within.
    pub(super) fn within(&self, field: &str) -> Place {
        Place { span: self.span.clone(), field: join(&self.field, field) }
    }
}

/// `parent.field`, or the field alone at the top of the file.
pub(super) fn join(parent: &str, field: &str) -> String {
    if parent.is_empty() { field.to_owned() } else { format!("{parent}.{field}") }
}

/// Collects the mistakes of one text.
pub(super) struct Report<'t> {
    text: &'t str,
    diagnostics: RefCell<Vec<Diagnostic>>,
}

impl<'t> Report<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Report { text, diagnostics: RefCell::default() }
    }

    pub(super) fn add(
        &self,
        problem: Problem,
        place: &Place,
        found: impl Into<String>,
        allowed: impl Into<String>,
    ) {
        let before = self.text.get(..place.span.start).unwrap_or(self.text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        self.diagnostics.borrow_mut().push(Diagnostic {
            problem,
            span: place.span.clone(),
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
            field: place.field.clone(),
            found: found.into(),
            allowed: allowed.into(),
        });
    }

    /// Whether nothing has been complained about.
    pub(super) fn is_empty(&self) -> bool {
        self.diagnostics.borrow().is_empty()
    }

    /// Ends a stage of reading: its result, or an error when anything has been complained about so far.
    /// (Whoever returns `None` has complained.)
    pub(super) fn conclude<T>(&self, result: Option<T>, file_name: &str) -> Result<T, AircraftFileError> {
        let mut diagnostics = self.diagnostics.borrow().clone();
        match result {
            Some(result) if diagnostics.is_empty() => Ok(result),
            _ => {
                diagnostics.sort_by_key(|d| d.span.start);
                diagnostics.dedup();
                let (file_name, text) = (file_name.to_owned(), self.text.to_owned());
                Err(AircraftFileError::Rejected { file_name, text, diagnostics })
            }
        }
    }
}
