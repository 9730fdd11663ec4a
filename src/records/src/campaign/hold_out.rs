//! Tests that are kept from a fit or a diagnosis, chosen by their names.

use crate::Campaign;
use crate::Record;
use crate::glob;

/// Why the patterns choose nothing useful.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum HoldOutError {
    /// Every test matches.
    #[error("--hold-out leaves no test to {purpose}; it matches all {count}")]
    NoTestsRemain {
        /// What the tests are for.
        purpose: &'static str,
        /// How many there are.
        count: usize,
    },
    /// A pattern that no test matches.
    #[error("--hold-out {pattern:?} matches no test; the first is called {first:?}")]
    MatchesNone {
        /// The pattern.
        pattern: String,
        /// Name of the first test.
        first: String,
    },
}

/// Whether a test's name matches one of the patterns, in which `*` stands for anything and `?` for one character.
pub fn matches(record: &Record, patterns: &[String]) -> bool {
    patterns.iter().any(|p| glob::matches(p, &record.name))
}

/// Which records the patterns leave out. `purpose` completes "leaves no test to ...".
///
/// # Errors
/// Where a pattern matches no test, or all tests are left out.
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

/// The tests that a fit may see.
///
/// # Errors
/// As [`held_out`].
pub fn kept<'a>(campaign: &'a Campaign, patterns: &[String]) -> Result<Vec<&'a Record>, HoldOutError> {
    let out = select_hold_out(campaign, patterns, "fit")?;
    Ok(campaign.records.iter().zip(out).filter(|(_, out)| !out).map(|(record, _)| record).collect())
}
