//! All texts of the messages about records, for translators.

use crate::formats::unsupported;
use crate::messages::phrases::TEMPLATES;
use crate::messages::sentence::{Template, each_once};
use crate::quantities::channel::Channel;
use crate::quantities::setting_value;

/// Words for channels, directions and the end of a record.
const WORDS: &[&str] =
    &["rebound", "compression", "displacement or velocity", "an incomplete cycle or run-down", "rest", "nothing"];

/// Returns every sentence template.
pub fn templates() -> &'static [Template] {
    TEMPLATES
}

/// Returns the English texts of messages about records without duplicates: words, and sentences with placeholders for
/// values.
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
