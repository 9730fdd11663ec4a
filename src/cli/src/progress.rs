//! Progress of long work, which only a terminal shows.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal as _;

/// A progress line on standard error.
pub struct Progress(ProgressBar);

impl Progress {
    /// Makes a line that starts with `what`. It is invisible if standard error is not a terminal.
    pub fn new(what: &'static str) -> Progress {
        let target =
            if std::io::stderr().is_terminal() { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(Some(1000), target);
        bar.set_style(
            ProgressStyle::with_template("{prefix} {bar:30} {percent:>3} % {wide_msg}")
                .unwrap_or_else(|_| ProgressStyle::default_bar()),
        );
        bar.set_prefix(what);
        Progress(bar)
    }

    /// Sets the fraction done, 0..1.
    pub fn set(&self, done: f64) {
        self.0.set_position((1000.0 * done) as u64);
    }

    /// Sets the fraction done, 0..1, and the text on the current work.
    pub fn say(&self, done: f64, text: &str) {
        self.set(done);
        self.0.set_message(dashpot_output::printable(text).into_owned());
    }

    /// Sets the fraction done from counts of items.
    pub fn count(&self, done: usize, total: usize) {
        self.set(done as f64 / total.max(1) as f64);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
