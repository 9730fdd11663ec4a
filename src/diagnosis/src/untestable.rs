//! Effects that these records cannot show, and the tests that would show them.

use super::advice::Advice;
use super::effects::{CARDS, remedy};
use super::outcome::CouldNotTest;
use super::phrases;
use dashpot_core::element;
use dashpot_core::parameter::Element;
use dashpot_estimation::situation::Situation;
use dashpot_messages::Sentence;

/// Smallest squared response of an effect of typical strength, summed over all tests, at which the records can show the
/// effect. The unit is σ², the squared allowed error of a sample. Only the part of the response that other parameters
/// of the model cannot reproduce counts.
const TRACE: f64 = 20.0;

/// Lists all effects that could not be tested, because of missing channels, too small ranges, or a small response at a
/// typical strength. Effects of the base model and the named effects `found` are not listed. `invisible` contains the
/// squared response of each screened effect, in units of the squared allowed error of a sample.
pub fn list(s: &Situation, invisible: &[(&'static str, f64)], found: &[&str], advice: &Advice) -> Vec<CouldNotTest> {
    let mut all: Vec<CouldNotTest> = Vec::new();
    for card in CARDS {
        let effect = card.name;
        let is_on = Element::find(effect).is_ok_and(|element| s.base.is_on(element));
        if is_on || found.contains(&effect) {
            continue;
        }
        if let Some(why) = (card.missing)(s, advice) {
            // The reason comes from the given model. If the diagnosis adds the series path, another reason applies.
            let is_added = found.contains(&element!("series_compliance").name());
            let next = why == Sentence::from(phrases::NEEDS_SERIES) && is_added;
            all.push(CouldNotTest { effect, why: if next { phrases::SERIES_ADDED.into() } else { why } });
        } else if invisible.iter().any(|(name, seen)| *name == effect && *seen < TRACE) {
            let why = Sentence::from(phrases::NO_TRACE).with_sentence("remedy", remedy(effect, advice));
            all.push(CouldNotTest { effect, why });
        }
    }
    all.push(CouldNotTest { effect: "cylinder_expansion", why: phrases::SUM_ALONE.into() });
    all
}
