//! The label of another setting as the explanation of a test that deviates from the reference.

use super::Seen;
use super::reference::Reference;
use crate::numbers::median;
use crate::tuning::deviating_tests::{AGREE, CLOSE, FEWEST};

/// Setting whose tests a deviating test agrees with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct WrongLabel {
    /// Root mean square deviation from the tests of the setting, as a natural logarithm of the force ratio.
    pub(super) left: f64,
    /// Index of the setting.
    pub(super) fitting: usize,
}

/// Returns the setting whose tests agree best with a test that deviates from the tests of its own setting `stated`.
///
/// `references` holds the tests of each setting that agree. Returns `None` if the test agrees with no other setting, or
/// if it does not clearly deviate from its own.
pub(super) fn find_wrong_label(
    test: &Seen<'_>,
    stated: usize,
    references: &[Option<Reference<'_>>],
) -> Option<WrongLabel> {
    let own = references[stated].as_ref()?.off(test, 1.0, 1.0);
    if own.len() < FEWEST || median(&mut own.iter().map(|off| off.abs()).collect::<Vec<_>>()) < AGREE {
        return None;
    }
    let others = references.iter().enumerate().filter(|(fitting, _)| *fitting != stated);
    let candidates = others.filter_map(|(fitting, reference)| {
        let off = reference.as_ref()?.off(test, 1.0, 1.0);
        // The setting must have tests at most velocities of the test.
        (off.len() >= FEWEST && 2 * off.len() >= test.levels.len()).then(|| {
            let left = (off.iter().map(|off| off * off).sum::<f64>() / off.len() as f64).sqrt();
            WrongLabel { left, fitting }
        })
    });
    candidates.filter(|candidate| candidate.left < CLOSE).min_by(|a, b| a.left.total_cmp(&b.left))
}
