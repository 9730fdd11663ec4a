//! All texts of the messages about records, for translators.

use crate::messages::phrases::TEMPLATES;
use crate::quantities::setting_value;
use dashpot_messages::Template;

/// What a direction, a missing channel, or the end of a record is called.
const WORDS: [&str; 8] = [
    "rebound",
    "compression",
    "time",
    "force",
    "displacement or velocity",
    "an incomplete cycle or run-down",
    "rest",
    "nothing",
];

/// Every message.
pub fn templates() -> &'static [Template] {
    TEMPLATES
}

/// Every word that stands in a message.
pub fn words() -> impl Iterator<Item = &'static str> {
    WORDS.into_iter().chain(setting_value::NAMES)
}
