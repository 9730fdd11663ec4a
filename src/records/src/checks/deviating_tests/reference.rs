//! The reference of a test: the largest set of tests that agree, with their typical forces.

use super::Seen;
use crate::checks::force_levels::{Level, Levels, apart, velocity};
use crate::numbers::median;
use crate::tuning::deviating_tests::{AGREE, AS_LONG, OF_SCATTER};
use crate::tuning::force_levels::MIDDLE;
use crate::tuning::load_cell::OFFSET;
use std::collections::BTreeMap;

/// Returns the indices of the largest connected set of tests. Two tests are connected if they agree, directly or
/// through other tests. A set may have only one test. The indices are in ascending order.
pub(super) fn largest_agreeing(seen: &[Seen<'_>]) -> Vec<usize> {
    let mut set: Vec<usize> = (0..seen.len()).collect();
    fn root(set: &mut [usize], mut i: usize) -> usize {
        while set[i] != i {
            set[i] = set[set[i]];
            i = set[i];
        }
        i
    }
    for i in 0..seen.len() {
        for j in 0..i {
            let (a, b) = (root(&mut set, i), root(&mut set, j));
            if a != b && agree(&seen[i].levels, &seen[j].levels) {
                set[a.max(b)] = a.min(b);
            }
        }
    }
    let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for i in 0..seen.len() {
        members.entry(root(&mut set, i)).or_default().push(i);
    }
    // Of sets of equal size, use the set with the earliest test.
    members.into_values().rev().max_by_key(Vec::len).unwrap_or_default()
}

/// Returns whether two tests have similar forces at most of their common velocities.
pub(super) fn agree(one: &Levels, other: &Levels) -> bool {
    let mut ratios: Vec<f64> =
        one.iter().filter_map(|(k, l)| Some(libm::log(l.against / other.get(k)?.against))).collect();
    !ratios.is_empty() && median(&mut ratios).abs() < AGREE
}

/// The reference: tests that agree with each other, and their forces at each velocity.
pub(super) struct Reference<'a> {
    pub(super) tests: Vec<&'a Seen<'a>>,
    /// Natural logarithm of the median force, N, against the motion, by velocity level.
    pub(super) curve: BTreeMap<i32, f64>,
    /// Mean of the forces in rebound and compression, N, by velocity level: its median and its median absolute
    /// deviation between tests.
    between: BTreeMap<i32, (f64, f64)>,
}

impl<'a> Reference<'a> {
    pub(super) fn new(tests: Vec<&'a Seen<'a>>) -> Self {
        let mut at: BTreeMap<i32, [Vec<f64>; 2]> = BTreeMap::new();
        for (k, Level { against, between }) in tests.iter().flat_map(|test| &test.levels) {
            let [forces, middles] = at.entry(*k).or_default();
            forces.push(libm::log(*against));
            middles.push(*between);
        }
        let (mut curve, mut between) = (BTreeMap::new(), BTreeMap::new());
        for (k, [mut forces, mut middles]) in at {
            curve.insert(k, median(&mut forces));
            let middle = median(&mut middles);
            let scatter = median(&mut middles.iter().map(|m| (m - middle).abs()).collect::<Vec<_>>());
            between.insert(k, (middle, scatter));
        }
        Reference { tests, curve, between }
    }

    /// Returns the natural logarithm of the typical force against the motion, N, interpolated between velocity levels.
    /// Returns `None` outside the levels of the reference.
    fn usual(&self, level: f64) -> Option<f64> {
        let (below, part) = (level.floor(), level - level.floor());
        // The level of every positive double is within the range of an i32.
        let low = self.curve.get(&(below as i32))?;
        if part < 1e-9 {
            return Some(*low);
        }
        Some(low + part * (self.curve.get(&(below as i32 + 1))? - low))
    }

    /// Returns the highest velocity level common to a test and the reference, as a pair of equal levels. If there is no
    /// common level, returns the two closest levels, first that of the test.
    pub(super) fn closest_levels(&self, test: &Seen<'_>) -> Option<(i32, i32)> {
        let pairs = test.levels.keys().flat_map(|k| self.curve.keys().map(move |other| (*k, *other)));
        pairs.min_by_key(|(k, other)| ((k - other).abs(), -k))
    }

    /// Returns the deviations of a test from the reference at their common velocities, as natural logarithms of the
    /// force ratio. The test's forces and velocities are first scaled by the given factors.
    pub(super) fn deviations(&self, test: &Seen<'_>, of_force: f64, of_velocity: f64) -> Vec<f64> {
        let shift = apart(of_velocity);
        let at = |(k, l): (&i32, &Level)| Some(libm::log(of_force * l.against) - self.usual(f64::from(*k) + shift)?);
        test.levels.iter().filter_map(at).collect()
    }

    /// Returns whether the stroke of some reference test at a common velocity is not much longer than the given
    /// `amplitude`, m. [`AS_LONG`] is the smallest allowed ratio of `amplitude` to the amplitude of that test.
    pub(super) fn are_as_short(&self, test: &Seen<'_>, amplitude: f64) -> bool {
        let with = |other: &&&Seen<'_>| test.levels.keys().any(|k| other.levels.contains_key(k));
        self.tests.iter().filter(with).any(|other| other.record.amplitude * AS_LONG <= amplitude)
    }

    /// Returns whether the mean force of rebound and compression contradicts a multiplication of the test's force by
    /// `factor`.
    ///
    /// This is so if the factor increases the deviation of the mean force from that of the reference, and the deviation
    /// exceeds the acceptable value. Only the middle of the strokes counts, because springs and stops add to the mean
    /// force at their ends.
    pub(super) fn gas_speaks_against(&self, test: &Seen<'_>, factor: f64) -> bool {
        let (mut as_read, mut otherwise, mut allowed) = (Vec::new(), Vec::new(), Vec::new());
        let slowest = MIDDLE * test.record.peak_velocity;
        for (k, level) in test.levels.iter().filter(|(k, _)| velocity(**k) >= slowest) {
            let Some((middle, scatter)) = self.between.get(k) else { continue };
            as_read.push((level.between - middle).abs());
            otherwise.push((factor * level.between - middle).abs());
            allowed.push(OFFSET + OF_SCATTER * scatter);
        }
        let otherwise = median(&mut otherwise);
        otherwise > median(&mut as_read) && otherwise > median(&mut allowed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::deviating_tests::Reading;
    use crate::data::record::Record;
    use crate::options::Options;

    /// Calls `check` with a reference and with a test. The reference consists of three tests of 10 mm amplitude, whose
    /// mean forces of the two directions are −100, −110 and −120 N. The mean force of the test is −110 N.
    fn with_reference(check: impl Fn(&Reference<'_>, &Seen<'_>) -> bool) -> bool {
        let record = Record { amplitude: 0.01, ..Record::default() };
        let (options, units) = (Options::default(), Vec::new());
        let reading = Reading { units, options: &options };
        let seen = |between: f64| {
            let levels = (0..3).map(|k| (k, Level { against: 300.0, between })).collect();
            Seen { record: &record, reading: &reading, levels, stated: 0 }
        };
        let (tests, own) = ([-100.0, -110.0, -120.0].map(seen), seen(-110.0));
        check(&Reference::new(tests.iter().collect()), &own)
    }

    #[test]
    fn a_test_is_compared_with_strokes_of_up_to_one_and_a_half_times() {
        let is_short = |amplitude: f64| with_reference(|reference, own| reference.are_as_short(own, amplitude));
        assert!(is_short(0.0072) && !is_short(0.006));
    }

    #[test]
    fn the_scatter_of_the_gas_force_excuses_a_factor() {
        // The others scatter by 10 N, so a deviation of 45 N is acceptable.
        let is_against = |factor: f64| with_reference(|reference, own| reference.gas_speaks_against(own, factor));
        assert!(!is_against(1.3) && is_against(1.5));
    }
}
