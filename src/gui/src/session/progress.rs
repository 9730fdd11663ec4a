//! Progress of long tasks.

use dashpot_messages::Template;

/// Progress of a task.
#[derive(Debug, Clone, Default)]
pub struct Progress {
    /// Completed fraction, 0..1.
    pub done: f64,
    /// Current activity, if known.
    pub text: Option<Template>,
}

/// Callback for the progress of a task.
pub type Report<'a> = &'a (dyn Fn(f64, Option<Template>) + Sync);
