//! All that reading says, for those who translate it.

use super::channel::Channel;
use super::not_read;
use super::phrases::TEMPLATES;
use super::sentence::{Template, each_once};
use super::setting_value;

/// What a channel, a direction, or the end of a record is called.
const WORDS: &[&str] =
    &["rebound", "compression", "displacement or velocity", "an incomplete cycle or run-down", "rest", "nothing"];

/// Every template of a sentence.
pub fn templates() -> &'static [Template] {
    TEMPLATES
}

/// Every English text that is said of records, each once: sentences with the places of their values, and words.
pub fn texts() -> Vec<&'static str> {
    each_once(
        TEMPLATES,
        WORDS
            .iter()
            .copied()
            .chain(setting_value::NAMES)
            .chain(Channel::ALL.map(Channel::name))
            .chain(not_read::words()),
    )
}
