//! All that a diagnosis says, for those who translate it.

use super::effects::{CARDS, EFFECTS, meaning};
use super::phrases::{FORMS, TEMPLATES};
use dashpot_records::sentence::each_once;

/// Every English text that is said of a diagnosis, each once: sentences with the places of their values, and what paths, families,
/// effects and forms are called.
pub fn texts() -> Vec<&'static str> {
    let of_cards = CARDS.iter().flat_map(|card| [card.path, card.family]);
    let words = of_cards.chain(EFFECTS.iter().map(|e| meaning(e)));
    each_once(TEMPLATES, words.chain(FORMS.iter().copied()))
}
