//! Mistakes in a text that somebody wrote, each with its place.

use std::fmt::Write as _;
use std::ops::Range;

/// One mistake: where it is, what was found and what is allowed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// Bytes of the text to underline.
    pub span: Range<usize>,
    /// Dotted path, for example `vary[1].from`; list entries count from 1.
    pub field: String,
    pub found: String,
    pub allowed: String,
}

/// A text that is not as it must be. Displayed as one line `file:line:column: field: found; allowed` for each mistake.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", self.lines())]
pub struct Rejected {
    /// As the user named it.
    pub file_name: String,
    /// The text that the spans refer to.
    pub text: String,
    /// At least one, in the order of the text.
    pub mistakes: Vec<Mistake>,
}

impl Rejected {
    fn lines(&self) -> String {
        let mut lines = String::new();
        for Mistake { span, field, found, allowed } in &self.mistakes {
            let before = self.text.get(..span.start).unwrap_or_default();
            let line = 1 + before.matches('\n').count();
            let column = 1 + before.chars().rev().take_while(|letter| *letter != '\n').count();
            // PROOF: a string takes every text.
            let _ = writeln!(lines, "{}:{line}:{column}: {field}: {found}; {allowed}", self.file_name);
        }
        lines.trim_end().to_owned()
    }
}

/// Texts that are not as they must be, and what is wrong in none of their lines. Displayed as one line for each mistake.
#[derive(Clone, Debug, Default, PartialEq, Eq, thiserror::Error)]
#[error("{}", self.lines())]
pub struct RejectedFiles {
    /// Each with its own mistakes.
    pub files: Vec<Rejected>,
    /// Mistakes that are in no line.
    pub whole: Vec<String>,
    /// How many more there are, which are not told.
    pub more: usize,
    /// What is no mistake by itself and may explain one.
    pub beside: Vec<String>,
}

impl RejectedFiles {
    fn lines(&self) -> String {
        let files = self.files.iter().map(ToString::to_string);
        self.whole.iter().cloned().chain(files).chain(self.rest()).collect::<Vec<_>>().join("\n")
    }

    /// That there are more, and what else is to be said.
    pub fn rest(&self) -> impl Iterator<Item = String> + '_ {
        let more = (self.more > 0).then(|| format!("and {} mistakes more", self.more));
        more.into_iter().chain(self.beside.iter().cloned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mistake_is_one_line_with_its_place() {
        let mistake = |span, found: &str| Mistake {
            span,
            field: "run.step".to_owned(),
            found: found.to_owned(),
            allowed: "a number is allowed".to_owned(),
        };
        let rejected = Rejected {
            file_name: "a.toml".to_owned(),
            text: "[run]\nstep = \"ä\" # x\n".to_owned(),
            mistakes: vec![mistake(13..17, "found a text"), mistake(0..1, "found nothing")],
        };
        assert_eq!(
            rejected.to_string(),
            "a.toml:2:8: run.step: found a text; a number is allowed\na.toml:1:1: run.step: found nothing; a number is allowed"
        );
    }
}
