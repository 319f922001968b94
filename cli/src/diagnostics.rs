//! Mistakes in an aircraft file, shown with the lines they are in and carets under them.

use std::io::IsTerminal;
use std::path::Path;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use flexible_aircraft::aircraft::AircraftFileError;
use flexible_aircraft_packaging::looked_for;

use crate::terminal;

/// The report for people: one block per mistake, coloured on a terminal.
pub fn render(error: &AircraftFileError) -> String {
    let coloured = std::io::stderr().is_terminal();
    render_with(error, &if coloured { Renderer::styled() } else { Renderer::plain() })
}

/// Warns on standard error.
pub fn warn(text: &str) {
    terminal::note(&format!("warning: {text}"));
}

fn render_with(error: &AircraftFileError, renderer: &Renderer) -> String {
    match error {
        AircraftFileError::Unreadable { file_name, source } => {
            format!("error: {error}{}", looked_for(Path::new(file_name), source))
        }
        AircraftFileError::Rejected { file_name, text, diagnostics } => {
            let blocks = diagnostics.iter().map(|diagnostic| {
                let title = format!("{}: {}", diagnostic.field, diagnostic.found);
                let place = AnnotationKind::Primary.span(diagnostic.span.clone()).label(&diagnostic.allowed);
                let snippet = Snippet::source(text.as_str()).path(file_name.as_str()).annotation(place);
                renderer.render(&[Level::ERROR.primary_title(title).element(snippet)])
            });
            blocks.collect::<Vec<_>>().join("\n\n")
        }
        _ => format!("error: {error}"),
    }
}

#[cfg(test)]
mod tests {
    use flexible_aircraft::aircraft::Aircraft;

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
