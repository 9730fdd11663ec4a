//! Force levels of a test at each velocity: the part that resists the motion, and the mean of both directions.
//!
//! These levels make tests of one damper comparable, even if strokes and frequencies differ.

use crate::data::record::Record;
use crate::numbers::median;
use crate::tuning::force_levels::{FEWEST, LOWEST, MIDDLE, STEP};
use std::collections::BTreeMap;

/// Lower limit of velocity level 0, m/s. The limit of each further level is higher by the factor [`STEP`]. Only
/// differences of levels matter.
const FROM: f64 = 1e-3;

/// Forces of a test at one velocity level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Level {
    /// Half the difference of the forces in rebound and in compression, N: the force against the motion.
    pub against: f64,
    /// Half the sum of the two forces, N: gas, springs, the zero of the channel, and the asymmetry of rebound and
    /// compression.
    pub between: f64,
}

/// Forces of a test, by the number of the velocity level (see [`FROM`]).
pub(crate) type Levels = BTreeMap<i32, Level>;

/// Returns the number of levels, possibly fractional, between two velocities with the given ratio.
pub(crate) fn apart(times: f64) -> f64 {
    libm::log(times) / libm::log(STEP)
}

/// Returns the geometric mean of the velocity limits of a level, m/s.
pub(crate) fn velocity(level: i32) -> f64 {
    FROM * libm::pow(STEP, f64::from(level) + 0.5)
}

/// Computes the force levels of a test from the samples for which `counts` is true. Omits samples that are slower than
/// the fraction [`LOWEST`] of the peak velocity or faster than the peak velocity. Also omits levels with fewer than
/// [`FEWEST`] samples in a direction.
pub(crate) fn levels(record: &Record, counts: impl Fn(usize) -> bool) -> Levels {
    let lowest = LOWEST * record.peak_velocity;
    let mut forces: BTreeMap<i32, [Vec<f64>; 2]> = BTreeMap::new();
    for (i, (v, force)) in record.velocity.iter().zip(&record.force).enumerate() {
        let speed = v.abs();
        if speed > 0.0 && speed >= lowest && speed <= record.peak_velocity && counts(i) {
            // The level of every positive double is within the range of an i32.
            let level = apart(speed / FROM).floor() as i32;
            forces.entry(level).or_default()[usize::from(*v < 0.0)].push(*force);
        }
    }
    let seen = forces.into_iter().filter(|(_, [out, back])| out.len() >= FEWEST && back.len() >= FEWEST);
    seen.map(|(level, [mut out, mut back])| {
        let (out, back) = (median(&mut out), median(&mut back));
        (level, Level { against: 0.5 * (out - back), between: 0.5 * (out + back) })
    })
    .collect()
}

/// Returns whether a sample lies in the middle of a stroke. At the ends of a stroke, stops and springs add forces.
pub(crate) fn is_in_the_middle(record: &Record, i: usize) -> bool {
    record.velocity[i].abs() >= MIDDLE * record.peak_velocity
}

/// Computes the levels of each test in the middle of its strokes.
pub(crate) fn in_the_middle(records: &[Record]) -> Vec<Levels> {
    records.iter().map(|record| levels(record, |i| is_in_the_middle(record, i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_shows_force_against_motion_and_between_at_its_velocities() {
        let time: Vec<f64> = (0..4000).map(|i| 1e-3 * f64::from(i)).collect();
        let velocity: Vec<f64> = time.iter().map(|t| 0.5 * libm::sin(6.0 * t)).collect();
        let force = velocity.iter().map(|v| 1000.0 * v - 150.0 + if *v > 0.0 { 500.0 * v } else { 0.0 }).collect();
        let record = Record { time, velocity, force, peak_velocity: 0.5, ..Record::default() };
        let seen = levels(&record, |_| true);
        assert!(seen.len() >= 8, "{seen:?}");
        for (level, at) in &seen {
            let v = super::velocity(*level);
            assert!((at.against / (1250.0 * v) - 1.0).abs() < 0.15, "{v}: {at:?}");
            assert!((at.between + 150.0 - 250.0 * v).abs() < 25.0, "{v}: {at:?}");
        }
        assert!(levels(&record, |i| i < 3).is_empty());
        assert!((apart(STEP * STEP) - 2.0).abs() < 1e-12);
    }
}
