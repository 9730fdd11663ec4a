//! Tests that are excluded from a fit or a diagnosis, selected by their names.

use crate::Campaign;
use crate::Record;
use crate::glob;

/// Reason for which the patterns of `--hold-out` are rejected.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum HoldOutError {
    /// Every test matches, so none remains.
    #[error("--hold-out leaves no test to {purpose}; it matches all {count}")]
    NoTestsRemain {
        /// The purpose of the remaining tests, such as "fit".
        purpose: &'static str,
        /// Number of tests.
        count: usize,
    },
    /// No test matches the pattern.
    #[error("--hold-out {pattern:?} matches no test; the first is called {first:?}")]
    MatchesNone {
        /// The pattern that matches no test.
        pattern: String,
        /// Name of the first test of the campaign, as an example.
        first: String,
    },
}

/// Returns whether a test's name matches one of the patterns. `*` matches any text and `?` one character.
pub fn matches(record: &Record, patterns: &[String]) -> bool {
    patterns.iter().any(|p| glob::matches(p, &record.name))
}

/// Returns for each record whether the patterns exclude it. `purpose` completes the message "--hold-out leaves no test
/// to ...".
///
/// # Errors
/// A pattern matches no test, or all tests are excluded.
pub fn select_hold_out(
    campaign: &Campaign,
    patterns: &[String],
    purpose: &'static str,
) -> Result<Vec<bool>, HoldOutError> {
    let records = &campaign.records;
    let out: Vec<bool> = records.iter().map(|r| matches(r, patterns)).collect();
    if out.iter().all(|o| *o) {
        return Err(HoldOutError::NoTestsRemain { purpose, count: out.len() });
    }
    match patterns.iter().find(|p| !records.iter().any(|r| glob::matches(p, &r.name))) {
        Some(pattern) => {
            let first = records.first().map_or_else(String::new, |r| r.name.clone());
            Err(HoldOutError::MatchesNone { pattern: pattern.clone(), first })
        }
        None => Ok(out),
    }
}

/// Returns the records that no pattern excludes, which a fit uses.
///
/// # Errors
/// The errors of [`select_hold_out`].
pub fn kept<'a>(campaign: &'a Campaign, patterns: &[String]) -> Result<Vec<&'a Record>, HoldOutError> {
    let out = select_hold_out(campaign, patterns, "fit")?;
    Ok(campaign.records.iter().zip(out).filter(|(_, out)| !out).map(|(record, _)| record).collect())
}
