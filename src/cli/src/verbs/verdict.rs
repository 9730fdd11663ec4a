//! What a verb that judges says to scripts by its exit code.

/// What a verb found of a damper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It keeps what was asked of it, or nothing was asked.
    Passed,
    /// It does not, or that could not be tested as a whole.
    Failed,
}
