//! What a command failed of; mistakes in an aircraft file or in another text are shown with the lines they are in and carets under them.

use std::error::Error;
use std::io::IsTerminal;
use std::ops::Range;
use std::path::Path;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use flexible_aircraft::aircraft::{Aircraft, AircraftFileError};

use crate::marked::{Rejected, RejectedFiles};
use crate::terminal;

/// What any command fails of, for people on a terminal.
pub trait Report {
    /// One block per mistake where a file is not right, a line or so otherwise.
    fn report(&self) -> String {
        self.report_with(&if std::io::stderr().is_terminal() {
            Renderer::styled()
        } else {
            Renderer::plain()
        })
    }

    /// The same without colours.
    fn plain_report(&self) -> String {
        self.report_with(&Renderer::plain())
    }

    /// The same in the style of a renderer.
    fn report_with(&self, renderer: &Renderer) -> String;
}

impl<E: Error + 'static> Report for E {
    fn report_with(&self, renderer: &Renderer) -> String {
        let mut cause: Option<&(dyn Error + 'static)> = Some(self);
        while let Some(error) = cause {
            if let Some(of_file) = error.downcast_ref() {
                return render_with(of_file, renderer);
            }
            if let Some(rejected) = error.downcast_ref() {
                return render_rejected(rejected, renderer);
            }
            if let Some(files) = error.downcast_ref() {
                return render_files(files, renderer);
            }
            cause = error.source();
        }
        format!("error: {self}")
    }
}

/// Reads an aircraft file, and warns of what makes its trims odd.
pub fn read_aircraft(path: &Path) -> Result<Aircraft, AircraftFileError> {
    let aircraft = Aircraft::read(path)?;
    if let Some(odd) = odd_trims(&aircraft) {
        warn(&odd);
    }
    Ok(aircraft)
}

/// What makes the trims of an aircraft odd, for people.
pub fn odd_trims(aircraft: &Aircraft) -> Option<String> {
    aircraft.lopsided_pitch_control().map(|control| {
        format!(
            "{} has trim = \"pitch\" and does not act alike on both sides: trims go aside, with bank angle, sideslip, or angles of \
             the controls for roll and yaw",
            control.name
        )
    })
}

/// Warns on standard error.
pub fn warn(text: &str) {
    terminal::note(&format!("warning: {text}"));
}

fn render_with(error: &AircraftFileError, renderer: &Renderer) -> String {
    match error {
        AircraftFileError::Rejected { file_name, text, diagnostics } => {
            let blocks = diagnostics.iter().map(|diagnostic| {
                let title = format!("{}: {}", diagnostic.field, diagnostic.found);
                // Lines to paste stand by themselves below.
                let (label, lines) = diagnostic.allowed.split_once('\n').unwrap_or((&diagnostic.allowed, ""));
                let report = block(renderer, (file_name, text), &diagnostic.span, (&title, label));
                if lines.is_empty() { report } else { format!("{report}\n{}", lines.trim_end()) }
            });
            blocks.collect::<Vec<_>>().join("\n\n")
        }
        _ => format!("error: {error}"),
    }
}

fn render_rejected(rejected: &Rejected, renderer: &Renderer) -> String {
    let Rejected { file_name, text, mistakes } = rejected;
    let blocks = mistakes.iter().map(|mistake| {
        let title = format!("{}: {}", mistake.field, mistake.found);
        block(renderer, (file_name, text), &mistake.span, (&title, &mistake.allowed))
    });
    blocks.collect::<Vec<_>>().join("\n\n")
}

fn render_files(rejected: &RejectedFiles, renderer: &Renderer) -> String {
    let whole = rejected.whole.iter().map(|text| format!("error: {text}"));
    let files = rejected.files.iter().map(|file| render_rejected(file, renderer));
    whole.chain(files).chain(rejected.rest()).collect::<Vec<_>>().join("\n\n")
}

/// A title, the lines of a file with a place, and a label under it.
fn block(
    renderer: &Renderer,
    (file_name, text): (&str, &str),
    span: &Range<usize>,
    (title, label): (&str, &str),
) -> String {
    let place = AnnotationKind::Primary.span(span.clone()).label(label);
    let snippet = Snippet::source(text).path(file_name).annotation(place);
    renderer.render(&[Level::ERROR.primary_title(title).element(snippet)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mistake_is_shown_with_its_line_and_underlined() {
        let error = Aircraft::parse("format = 1\nwings = 2\n", "jet.toml").unwrap_err();
        let report = render_with(&error, &Renderer::plain());
        assert!(report.contains(" --> jet.toml:2:1\n"), "{report}");
        assert!(report.contains("2 | wings = 2\n  | ^^^^^ allowed here: "), "{report}");
    }

    #[test]
    fn a_missing_file_is_named_with_the_place_where_it_was_looked_for() {
        let error = Aircraft::read(Path::new("no/such.toml")).unwrap_err();
        let report = render_with(&error, &Renderer::plain());
        assert!(report.starts_with("error: no/such.toml: cannot read the aircraft file: "), "{report}");
        let looked = std::env::current_dir().unwrap().join("no/such.toml");
        assert!(report.ends_with(&format!("; looked for {}", looked.display())), "{report}");
    }
}
