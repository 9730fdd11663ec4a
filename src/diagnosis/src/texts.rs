//! All texts that a diagnosis reports, for translators.

use super::effects::CARDS;
use super::phrases::{FORMS, TEMPLATES};
use dashpot_messages::Template;

/// Returns the templates of all messages.
pub fn templates() -> &'static [Template] {
    TEMPLATES
}

/// Returns all words that are not in templates: the names of locations, families and forms of effects.
pub fn words() -> impl Iterator<Item = &'static str> {
    CARDS.iter().flat_map(|card| [card.path, card.family]).chain(FORMS.iter().copied())
}
