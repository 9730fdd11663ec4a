//! All texts that a diagnosis reports, for translators.

use super::effects::{CARDS, EFFECTS, meaning};
use super::phrases::{FORMS, TEMPLATES};
use dashpot_records::sentence::each_once;

/// Returns the English texts of a diagnosis, without duplicates.
///
/// These are sentences with placeholders for their values, and the names of paths, families, effects and forms.
pub fn texts() -> Vec<&'static str> {
    let of_cards = CARDS.iter().flat_map(|card| [card.path, card.family]);
    let words = of_cards.chain(EFFECTS.iter().map(|e| meaning(e)));
    each_once(TEMPLATES, words.chain(FORMS.iter().copied()))
}
