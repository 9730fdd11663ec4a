//! All texts of the messages about records, for translators.

use crate::messages::phrases::TEMPLATES;
use crate::quantities::setting_value;
use dashpot_messages::Template;

/// Words for directions, missing channels and the end of a record in messages.
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

/// Returns the templates of all messages.
pub fn templates() -> &'static [Template] {
    TEMPLATES
}

/// Returns all words that are inserted into messages.
pub fn words() -> impl Iterator<Item = &'static str> {
    WORDS.into_iter().chain(setting_value::NAMES)
}
