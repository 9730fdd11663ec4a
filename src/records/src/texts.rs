//! All that reading says, for those who translate it.

use crate::formats::unsupported;
use crate::messages::phrases::TEMPLATES;
use crate::messages::sentence::{Template, each_once};
use crate::quantities::channel::Channel;
use crate::quantities::setting_value;

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
            .chain(unsupported::words()),
    )
}
