//! Verdicts that determine the exit code of a verb.

/// Verdict of a verb on a damper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The damper meets the requirements, or there were none.
    Passed,
    /// The damper violates a requirement, or not all could be tested.
    Failed,
}
