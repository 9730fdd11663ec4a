//! All texts that a fit reports, for translators.

use super::phrases::{KINDS_OF_TESTS, TEMPLATES};
use dashpot_messages::Template;

/// Returns the templates of all messages.
pub fn templates() -> &'static [Template] {
    TEMPLATES
}

/// Returns the words that messages insert into their templates and that also need a translation.
pub fn words() -> impl Iterator<Item = &'static str> {
    KINDS_OF_TESTS.into_iter().chain(["rebound", "compression"])
}
