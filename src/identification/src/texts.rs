//! All texts that a fit reports, for translators.

use super::phrases::{KINDS_OF_TESTS, TEMPLATES};
use dashpot_records::sentence::each_once;

/// Returns every English text of a fit once: sentences with placeholders for their values, and words.
pub fn texts() -> Vec<&'static str> {
    each_once(TEMPLATES, KINDS_OF_TESTS)
}
