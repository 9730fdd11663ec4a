//! Finds tests whose deviation is explained by a wrong label: the forces are those of another setting.
//!
//! A test deviates from the reference of its setting, which is the largest set of agreeing tests at this setting.

use super::Seen;
use super::reference::Reference;
use crate::numbers::median;
use crate::tuning::deviating_tests::{AGREE, CLOSE, FEWEST, LEAST_CONTRAST, OF_OWN, TIMES_SCATTER};

/// Setting whose tests a deviating test agrees with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct WrongLabel {
    /// Root mean square deviation from the tests of the setting, as a natural logarithm of the force ratio.
    pub(super) left: f64,
    /// Index of the setting.
    pub(super) fitting: usize,
}

/// Deviations of all tests from the references of their own settings.
pub(super) struct Labels<'a> {
    settings: &'a [Vec<Seen<'a>>],
    references: &'a [Option<Reference<'a>>],
    /// Median deviation of each test from the reference of its own setting, as a natural logarithm of the force ratio.
    ///
    /// `None` if test and reference share too few velocities. The outer index is that of the setting.
    own: Vec<Vec<Option<f64>>>,
    /// Median of the absolute deviations `own` of all tests. Most labels are right, so this median is the scatter of
    /// the campaign.
    scatter: f64,
}

impl<'a> Labels<'a> {
    /// Compares every test with the reference of its setting. `references` holds the tests of each setting that agree.
    pub(super) fn new(settings: &'a [Vec<Seen<'a>>], references: &'a [Option<Reference<'a>>]) -> Labels<'a> {
        let of = |test: &Seen<'a>, reference: &Option<Reference<'a>>| {
            let mut off = compared(test, reference.as_ref()?)?;
            Some(median(&mut off))
        };
        let own: Vec<Vec<Option<f64>>> = settings
            .iter()
            .zip(references)
            .map(|(tests, reference)| tests.iter().map(|test| of(test, reference)).collect())
            .collect();
        let mut all: Vec<f64> = own.iter().flatten().flatten().map(|off| off.abs()).collect();
        let scatter = if all.is_empty() { 0.0 } else { median(&mut all) };
        Labels { settings, references, own, scatter }
    }

    /// Returns the setting whose tests agree best with a test that deviates from the tests of its own setting `stated`.
    ///
    /// `place` is the index of the test. Returns `None` if the test states no setting, agrees with no other setting, or
    /// does not clearly deviate from its own setting. Also returns `None` if the deviation is attributed to the motion,
    /// because tests with this motion deviate similarly at other settings.
    pub(super) fn find_wrong(&self, stated: usize, place: usize) -> Option<WrongLabel> {
        let test = &self.settings[stated][place];
        let name = &test.record.setting.as_ref()?.name;
        let own = self.own[stated][place]?;
        let is_clear = own.abs() > (TIMES_SCATTER * self.scatter).max(LEAST_CONTRAST);
        let is_of_motion = match self.same_motion_elsewhere(stated, test) {
            // If no test at another setting has this motion, a deviation below [`AGREE`] is attributed to the motion.
            others if others.is_empty() => own.abs() < AGREE,
            others => {
                let alike = others.iter().filter(|other| *other * own > 0.0 && 3.0 * other.abs() > own.abs()).count();
                2 * alike >= others.len()
            }
        };
        if !is_clear || is_of_motion {
            return None;
        }
        let has_name = |tests: &[Seen<'_>]| tests[0].record.setting.as_ref().is_some_and(|of| of.name == *name);
        let is_other = |fitting: usize| fitting != stated && has_name(&self.settings[fitting]);
        let others = self.references.iter().enumerate().filter(|(fitting, _)| is_other(*fitting));
        let candidates = others.filter_map(|(fitting, reference)| {
            let off = compared(test, reference.as_ref()?)?;
            let left = (off.iter().map(|off| off * off).sum::<f64>() / off.len() as f64).sqrt();
            Some(WrongLabel { left, fitting })
        });
        let most = CLOSE.min(OF_OWN * own.abs());
        candidates.filter(|candidate| candidate.left < most).min_by(|a, b| a.left.total_cmp(&b.left))
    }

    /// Returns the deviations of the tests that have the motion of `test` but another setting. Each deviation is from
    /// the reference of the test's own setting, as a natural logarithm of the force ratio.
    fn same_motion_elsewhere(&self, stated: usize, test: &Seen<'_>) -> Vec<f64> {
        let elsewhere = self.settings.iter().zip(&self.own).enumerate().filter(|(setting, _)| *setting != stated);
        elsewhere
            .flat_map(|(_, (tests, own))| tests.iter().zip(own))
            .filter(|(other, _)| test.has_motion_of(other))
            .filter_map(|(_, own)| *own)
            .collect()
    }
}

/// Returns the deviations of a test from a reference at their common velocities, as natural logarithms of the force
/// ratio. Returns `None` if these velocities are too few.
fn compared(test: &Seen<'_>, reference: &Reference<'_>) -> Option<Vec<f64>> {
    let off = reference.deviations(test, 1.0, 1.0);
    (off.len() >= FEWEST && 2 * off.len() >= test.levels.len()).then_some(off)
}
