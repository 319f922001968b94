//! How far long work has come: a bar on standard error where that is a terminal, nothing elsewhere.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar, which vanishes when dropped. Threads may share it.
pub struct Progress(ProgressBar);

impl Progress {
    /// Of so many steps of something, such as `flights`.
    pub fn new(steps: usize, of: &'static str) -> Self {
        Self::on(ProgressDrawTarget::stderr(), steps, of)
    }

    /// For work whose output scrolls over the terminal.
    pub fn hidden() -> Self {
        Self::on(ProgressDrawTarget::hidden(), 0, "")
    }

    fn on(target: ProgressDrawTarget, steps: usize, of: &'static str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(steps as u64), target).with_message(of);
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}, {elapsed}, {eta} left") {
            bar.set_style(style);
        }
        Progress(bar)
    }

    /// One more step is done.
    pub fn advance(&self) {
        self.0.inc(1);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use indicatif::InMemoryTerm;

    use super::*;

    #[test]
    fn a_terminal_shows_how_far_the_work_is_and_is_clean_afterwards() {
        let terminal = InMemoryTerm::new(5, 100);
        let target = ProgressDrawTarget::term_like(Box::new(terminal.clone()));
        let progress = Progress::on(target, 4, "flights");
        progress.advance();
        progress.0.force_draw();
        assert!(terminal.contents().contains(" 1/4 flights"), "{}", terminal.contents());
        drop(progress);
        assert_eq!(terminal.contents(), "");
    }
}
