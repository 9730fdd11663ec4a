//! All that a fit says, for those who translate it.

use super::phrases::{KINDS_OF_TESTS, TEMPLATES};
use dashpot_records::sentence::each_once;

/// Every English text that is said of a fit, each once: sentences with the places of their values, and words.
pub fn texts() -> Vec<&'static str> {
    each_once(TEMPLATES, KINDS_OF_TESTS)
}
