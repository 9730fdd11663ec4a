//! All texts that a fit reports, for translators.

use super::phrases::{KINDS_OF_TESTS, TEMPLATES};
use dashpot_messages::Template;

/// Every message.
pub fn templates() -> &'static [Template] {
    TEMPLATES
}

/// Every word that stands in a message.
pub fn words() -> impl Iterator<Item = &'static str> {
    KINDS_OF_TESTS.into_iter().chain(["rebound", "compression"])
}
