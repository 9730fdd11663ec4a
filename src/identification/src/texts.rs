//! All that a fit says, for those who translate it.

use super::phrases::{KINDS_OF_TESTS, TEMPLATES};
use super::variants::{FRICTION, PHYSICAL_SPRING, SPRING};
use super::{fit, of_the_rig};
use dashpot_records::sentence::each_once;

/// Every English text that is said of a fit, each once: sentences with the places of their values, and words.
pub fn texts() -> Vec<&'static str> {
    let variants =
        FRICTION.iter().chain(SPRING).chain(PHYSICAL_SPRING).flat_map(|variant| [variant.name, variant.rigid]);
    each_once(TEMPLATES, KINDS_OF_TESTS.into_iter().chain(fit::WORDS).chain(of_the_rig::WORDS).chain(variants))
}
