//! How far long work is.

use dashpot_messages::Template;

/// How far it is.
#[derive(Debug, Clone, Default)]
pub struct Progress {
    /// Share done, 0..1.
    pub done: f64,
    /// What is being done, where that is known.
    pub text: Option<Template>,
}

/// Reports how far work is.
pub type Report<'a> = &'a (dyn Fn(f64, Option<Template>) + Sync);
