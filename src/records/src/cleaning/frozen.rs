//! Finds channels that are constant while the others move: a lost sensor or a stalled logger.

use super::cycles::turning_points;
use crate::data::samples::Samples;
use crate::error::{RecordError, SampleError};
use crate::messages::phrases;
use crate::numbers::range;
use crate::quantities::channel::Channel;
use crate::signal::noise::difference_noise;
use crate::tuning::frozen::RUN;

/// Rejects a record with a frozen channel.
///
/// A channel counts as frozen if it is constant while another channel moves. A force that is constant over part of a
/// stroke can be real (pure friction, a coarse load cell). Therefore, a channel with coarse resolution counts as frozen
/// only if the other channel makes two strokes in this time.
pub(crate) fn reject(samples: &Samples) -> Result<(), RecordError> {
    check(samples, Channel::Force, &motion(samples))?;
    if let Some(velocity) = &samples.velocity {
        // The integral of the velocity shows whether the damper moves while the displacement is constant.
        let travelled = travelled(&samples.time, velocity);
        check(samples, Channel::Displacement, &travelled)?;
    } else {
        check(samples, Channel::Displacement, &samples.force)?;
    }
    if let Some(displacement) = &samples.displacement {
        check(samples, Channel::Velocity, displacement)?;
    }
    Ok(())
}

/// Returns the displacement, or the integral of the velocity. Without both, it returns zeros.
fn motion(samples: &Samples) -> Vec<f64> {
    match (&samples.displacement, &samples.velocity) {
        (Some(x), _) => x.clone(),
        (None, Some(v)) => travelled(&samples.time, v),
        (None, None) => vec![0.0; samples.len()],
    }
}

fn travelled(time: &[f64], velocity: &[f64]) -> Vec<f64> {
    let mut x = 0.0;
    let mut out = Vec::with_capacity(time.len());
    for i in 0..time.len() {
        if i > 0 {
            x += 0.5 * (velocity[i] + velocity[i - 1]) * (time[i] - time[i - 1]);
        }
        out.push(x);
    }
    out
}

fn check(samples: &Samples, channel: Channel, other: &[f64]) -> Result<(), RecordError> {
    let Some(values) = samples.channel(channel) else {
        return Ok(());
    };
    let n = values.len();
    let whole = range(other);
    if whole == 0.0 || n < RUN {
        return Ok(());
    }
    let noise = difference_noise(other);
    // At standstill, the force may change because friction relaxes. A constant displacement is therefore frozen only if
    // the other channel changes by half of its range, instead of a tenth.
    let share = if channel == Channel::Displacement { 0.5 } else { 0.1 };
    let mut start = 0;
    for run in values.chunk_by(|a, b| a == b) {
        let end = start + run.len();
        if run.len() >= RUN {
            // The other channel may still change in the first samples after a stop, so the first tenth of the run is
            // left out.
            let inner = &other[start + run.len() / 10..end];
            let moved = range(inner) - 8.0 * noise;
            let swings = turning_points(inner, 0.5 * whole).len().saturating_sub(1);
            let coarse = equal_share(&values[..start], &values[end..]) > 0.2;
            // A constant velocity over a stroke belongs to a triangular motion and is not a fault. Zero velocity during
            // a motion is a fault.
            let steady_motion = channel == Channel::Velocity && run[0] != 0.0;
            let frozen = swings >= 2 || (!coarse && !steady_motion && moved > share * whole);
            if frozen {
                return Err(SampleError::Frozen {
                    at: samples.at.clone(),
                    channel,
                    first: samples.lines[start],
                    last: samples.lines[end - 1],
                    value: run[0],
                    seconds: samples.time[end - 1] - samples.time[start],
                    moving: match channel {
                        Channel::Force => phrases::DAMPER_MOVES,
                        Channel::Displacement if samples.velocity.is_some() => phrases::VELOCITY_MOVES,
                        Channel::Displacement => phrases::FORCE_CHANGES,
                        _ => phrases::DISPLACEMENT_CHANGES,
                    },
                    advice: match channel {
                        Channel::Force => phrases::CHECK_CELL,
                        Channel::Velocity => phrases::READ_DISPLACEMENT_ONLY,
                        _ if samples.velocity.is_some() => phrases::READ_VELOCITY_ONLY,
                        _ => phrases::CUT_OR_MEASURE,
                    },
                }
                .into());
            }
        }
        start = end;
    }
    Ok(())
}

/// Returns the fraction of equal neighboring samples before and after a run, or one if there are no such samples.
fn equal_share(before: &[f64], after: &[f64]) -> f64 {
    let pairs = before.windows(2).chain(after.windows(2));
    let (equal, all) = pairs.fold((0, 0), |(equal, all), w| (equal + usize::from(w[0] == w[1]), all + 1));
    if all == 0 { 1.0 } else { equal as f64 / all as f64 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::SineTest;

    fn freeze(values: &mut [f64], range: std::ops::Range<usize>) {
        let value = values[range.start];
        values[range].fill(value);
    }

    #[test]
    fn frozen_channels_are_named_with_their_lines() {
        let sound = SineTest::default().samples();
        assert!(reject(&sound).is_ok());
        for channel in [Channel::Force, Channel::Displacement] {
            let mut samples = sound.clone();
            freeze(samples.channel_mut(channel).unwrap(), 600..760);
            let error = reject(&samples).unwrap_err().to_string();
            assert!(error.contains(&format!("lines 602 to 761: {channel} is frozen")), "{error}");
        }
        let mut samples = sound.clone();
        samples.velocity.as_mut().unwrap().fill(0.0);
        assert!(reject(&samples).unwrap_err().to_string().contains("--ignore velocity"));
        let mut samples = sound;
        samples.velocity = None;
        freeze(samples.displacement.as_mut().unwrap(), 500..900);
        assert!(reject(&samples).unwrap_err().to_string().contains("displacement is frozen"));
    }

    #[test]
    fn rest_and_coarse_plateaus_are_not_frozen() {
        // With pure friction, no noise and a load cell resolution of 1 N, the force is constant through most of every
        // stroke.
        let mut samples = SineTest { rest: 3.0, frequency: 0.01, ..SineTest::default() }.samples();
        let velocity = samples.velocity.clone().unwrap();
        samples.force = velocity.iter().map(|v| (60.0 * libm::tanh(v / 1e-5)).round() - 120.0).collect();
        reject(&samples).unwrap();
        // A standstill is not a frozen channel, even in a record without a velocity channel.
        let mut samples = SineTest { rest: 3.0, frequency: 0.01, ..SineTest::default() }.samples();
        samples.velocity = None;
        for x in samples.displacement.as_mut().unwrap() {
            *x = (*x * 2e5).round() / 2e5;
        }
        reject(&samples).unwrap();
    }
}
