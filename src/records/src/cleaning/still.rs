//! Rejects tests without motion or without a measured force, which give no information about a damper.

use crate::data::samples::Samples;
use crate::error::{RecordError, SampleError};
use crate::numbers::range;
use crate::quantities::channel::Channel;
use crate::signal::noise::difference_noise;
use crate::tuning::still::{FLICKER, RANGE, SPREAD};

/// Returns whether all motion channels contain only noise.
pub(crate) fn is_at_rest(samples: &Samples) -> bool {
    [Channel::Displacement, Channel::Velocity].into_iter().filter_map(|c| samples.channel(c)).all(rests)
}

/// Rejects a test without motion.
pub(crate) fn reject(samples: &Samples) -> Result<(), RecordError> {
    // If one motion channel is constant while the other changes, `frozen::reject` reports the fault.
    if !is_at_rest(samples) {
        return Ok(());
    }
    let motion = [Channel::Displacement, Channel::Velocity].map(|c| samples.channel(c).map(|values| (c, values)));
    let Some((channel, values)) = motion.into_iter().flatten().next() else { return Ok(()) };
    let unit = if channel == Channel::Displacement { "mm" } else { "mm/s" };
    Err(SampleError::NoMotion { at: samples.at.clone(), channel, range: 1e3 * range(values), unit }.into())
}

/// Rejects a moving test whose force never changes, not even in the last digit.
pub(crate) fn reject_constant_force(samples: &Samples) -> Result<(), RecordError> {
    if range(&samples.force) > 0.0 {
        return Ok(());
    }
    Err(SampleError::ConstantForce { at: samples.at.clone(), value: samples.force.first().copied().unwrap_or(0.0) }
        .into())
}

/// Returns whether a channel contains only noise, or as few distinct values as a sensor at rest.
fn rests(values: &[f64]) -> bool {
    if flickers(values) {
        return true;
    }
    let noise = difference_noise(values);
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let spread = (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n).sqrt();
    range(values) < RANGE * noise && spread < SPREAD * noise
}

/// Returns whether a channel has as few distinct values as a sensor at rest.
fn flickers(values: &[f64]) -> bool {
    let mut seen: Vec<f64> = Vec::with_capacity(FLICKER);
    for value in values {
        if seen.contains(value) {
            continue;
        }
        if seen.len() == FLICKER {
            return false;
        }
        seen.push(*value);
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{Random, SineTest};

    #[test]
    fn rest_is_told_from_the_smallest_motion() {
        let test = SineTest::default();
        reject(&test.samples()).unwrap();
        let mut random = Random::new(3);
        let noise: Vec<f64> = (0..test.samples().len()).map(|_| 1e-5 * random.normal()).collect();
        let with = |x: &dyn Fn(usize) -> f64, velocity: bool| {
            let mut samples = test.samples();
            let n = samples.len();
            samples.displacement = Some((0..n).map(x).collect());
            if !velocity {
                samples.velocity = None;
            }
            reject(&samples).map_err(|e| e.to_string())
        };
        for still in [&|_: usize| 0.01, &|i: usize| 0.01 + 1e-5 * (i * i % 3) as f64, &|i: usize| noise[i]]
            as [&dyn Fn(usize) -> f64; 3]
        {
            let message = with(still, false).unwrap_err();
            assert!(message.contains("test.csv: the damper does not move: displacement"), "{message}");
            // This check accepts a sensor that is constant while the other moves, because `frozen::reject` reports it.
            with(still, true).unwrap();
        }
        // A stroke as small as the noise of its sensor is still a stroke.
        with(&|i: usize| 1e-5 * libm::sin(i as f64 * 0.06) + noise[i], false).unwrap();
    }

    #[test]
    fn a_force_that_never_changes_is_none() {
        let mut samples = SineTest::default().samples();
        reject_constant_force(&samples).unwrap();
        samples.force.fill(-120.0);
        let message = reject_constant_force(&samples).unwrap_err().to_string();
        assert!(message.contains("force is -120.000000 N in every row"), "{message}");
    }

    #[test]
    fn three_distinct_values_are_rest_and_four_are_motion() {
        let channel = |values: usize| -> Vec<f64> { (0..200).map(|i| 0.01 + 1e-5 * (i % values) as f64).collect() };
        assert!(flickers(&channel(3)) && !flickers(&channel(4)));
    }
}
