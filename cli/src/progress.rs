//! How far long work has come: a bar on standard error where that is a terminal, nothing elsewhere; and who waits for it.

use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::terminal;

/// Who waits for the results of work. Whoever shares one may leave, from any thread: the work then ends at its next step.
#[derive(Clone, Debug)]
pub struct Audience {
    /// Whether they want to see how far it is.
    is_shown: bool,
    has_left: Arc<AtomicBool>,
}

/// The work was given up, for nobody waits for it: what it unwinds with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Left;

impl Audience {
    /// That sees on standard error what is being done, or sees nothing.
    pub fn new(is_shown: bool) -> Self {
        Audience { is_shown, has_left: Arc::default() }
    }

    /// Of a command.
    pub fn of_command() -> Self {
        Audience::new(true)
    }

    /// Wants no more.
    pub fn leave(&self) {
        self.has_left.store(true, Ordering::Relaxed);
    }

    /// Of so many steps of something, such as `flights`.
    pub fn progress(&self, steps: usize, of: &'static str) -> Progress {
        let shown = if self.is_shown { Progress::new(steps, of) } else { Progress::hidden() };
        Progress { has_left: Arc::clone(&self.has_left), ..shown }
    }

    /// Says what is being done.
    pub fn note(&self, text: &str) {
        if self.is_shown {
            terminal::note(text);
        }
    }
}

/// A bar, which vanishes when dropped. Threads may share it.
pub struct Progress {
    bar: Bar,
    has_left: Arc<AtomicBool>,
}

/// Cleared away when dropped.
struct Bar(ProgressBar);

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
        Progress { bar: Bar(bar), has_left: Arc::default() }
    }

    /// One more step is done. Where nobody waits any more, this unwinds with [`Left`], through threads and past
    /// everything that cleans up behind itself.
    pub fn advance(&self) {
        self.bar.0.inc(1);
        if self.has_left.load(Ordering::Relaxed) {
            resume_unwind(Box::new(Left));
        }
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use indicatif::InMemoryTerm;
    use rayon::prelude::*;

    use super::*;

    #[test]
    fn a_terminal_shows_how_far_the_work_is_and_is_clean_afterwards() {
        let terminal = InMemoryTerm::new(5, 100);
        let target = ProgressDrawTarget::term_like(Box::new(terminal.clone()));
        let progress = Progress::on(target, 4, "flights");
        progress.advance();
        progress.bar.0.force_draw();
        assert!(terminal.contents().contains(" 1/4 flights"), "{}", terminal.contents());
        drop(progress);
        assert_eq!(terminal.contents(), "");
    }

    #[test]
    fn work_ends_at_its_next_step_when_its_audience_has_left() {
        let audience = Audience::new(false);
        let progress = audience.progress(1000, "steps");
        let step = |number: usize| {
            progress.advance();
            if number == 0 {
                audience.leave();
            }
        };
        let work = std::panic::AssertUnwindSafe(|| (0..1000).into_par_iter().for_each(step));
        assert!(std::panic::catch_unwind(work).unwrap_err().is::<Left>());
        assert!(progress.bar.0.position() < 1000);
    }
}
