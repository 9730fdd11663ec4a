//! Sentences about the items of an inventory. An inventory lists the effects of a model with their forces and probabilities.

use super::phrases;
use dashpot_estimation::structure::inventory::InventoryItem;
use dashpot_messages::Sentence;
use dashpot_records::newtons::newtons;

/// Formats an item as one sentence: effect, form, force and probability.
pub fn describe_item(item: &InventoryItem) -> Sentence {
    let percent = |x: f64| format!("{:.0} %", 100.0 * x);
    let sentence = if item.form.is_empty() {
        Sentence::from(phrases::CARRIES).with("effect", item.effect)
    } else {
        Sentence::from(phrases::CARRIES_IN_FORM).with("effect", item.effect).with_word("form", item.form)
    };
    sentence
        .with("force", newtons(item.force_n_rms, 1))
        .with("share", percent(item.fraction))
        .with("probability", percent(item.probability))
}
