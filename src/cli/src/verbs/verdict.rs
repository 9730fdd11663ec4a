//! Verdict that determines the exit code of a verb.

/// Verdict of `dashpot validate` or `dashpot check` on a damper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The damper meets all requirements, or there are no requirements.
    Passed,
    /// The damper violates a requirement, or a requirement could not be tested.
    Failed,
}
