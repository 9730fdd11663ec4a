//! Compares displacement and velocity if both were recorded.

use nalgebra::{Matrix4, Vector4};

use super::derivative::integrate;
use super::unit_slip::{self, MotionSize};
use crate::messages::phrases;
use crate::numbers::range;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use crate::tuning::consistency::{LAG_OF_PHASE, LAG_OF_SAMPLE, SAME_MOTION};
use dashpot_messages::{Sentence, Template, format_decimals};

/// Agreement of velocity and displacement.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Agreement {
    /// Ratio of the velocity channel to the derivative of the displacement; 1 means agreement.
    pub gain: f64,
    /// Time by which the velocity channel lags behind the displacement, s.
    pub lag: f64,
    /// Fraction of the displacement's variance that the integrated velocity explains, 0..1.
    pub explained: f64,
    /// Size of the motion in the units in which the channels were read.
    pub size: MotionSize,
}

/// Fits displacement x, m, and velocity v, m/s, over time t, s, by x = a·∫v dt + b·v + c + d·t. The gain is 1/a, the
/// lag is b/a. The terms c + d·t absorb offset and integration drift.
///
/// The integral of the velocity is less sensitive to noise than the derivative of the displacement. Returns `None` for
/// fewer than eight samples, a constant channel or a singular fit.
pub(crate) fn compare(time: &[f64], displacement: &[f64], velocity: &[f64]) -> Option<Agreement> {
    let n = time.len();
    if n < 8 {
        return None;
    }
    let integral = integrate(time, velocity, 0.0);
    let mean = |values: &[f64]| values.iter().sum::<f64>() / n as f64;
    let spread = |values: &[f64], mean: f64| (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n as f64).sqrt();
    let scaled = |values: &[f64]| {
        let centre = mean(values);
        let width = spread(values, centre);
        (centre, width)
    };
    let ((ci, wi), (cv, wv), (ct, wt), (cx, wx)) =
        (scaled(&integral), scaled(velocity), scaled(time), scaled(displacement));
    if [wi, wv, wt, wx].contains(&0.0) {
        return None;
    }
    let (mut normal, mut right, mut total, mut plain) = (Matrix4::zeros(), Vector4::zeros(), 0.0, 0.0);
    for i in 0..n {
        let t = (time[i] - ct) / wt;
        let row = Vector4::new((integral[i] - ci) / wi, (velocity[i] - cv) / wv, 1.0, t);
        let x = (displacement[i] - cx) / wx;
        normal += row * row.transpose();
        right += row * x;
        total += x * x;
        plain += x * t;
    }
    let solution = normal.lu().solve(&right)?;
    // Subtract the variance of the displacement that a straight line over time explains without the velocity.
    let line = plain * plain / n as f64;
    let explained = (solution.dot(&right) - line) / (total - line);
    let (a, b) = (solution[0] * wx / wi, solution[1] * wx / wv);
    let size = MotionSize { amplitude: 0.5 * range(displacement), speed: 0.5 * range(velocity) };
    Some(Agreement { gain: 1.0 / a, lag: b / a, explained, size })
}

/// Returns whether the velocity is the derivative of the displacement with a significant time shift, such as that of a
/// filter. `step` is the time between samples, s. `period` is that of the cycles, s, or `None` without cycles.
pub(crate) fn is_delayed(agreement: &Agreement, step: f64, period: Option<f64>) -> bool {
    let Agreement { gain, lag, explained, .. } = *agreement;
    let phase = period.map_or(f64::INFINITY, |period| std::f64::consts::TAU * lag.abs() / period);
    explained > SAME_MOTION && (0.75..1.33).contains(&gain) && lag.abs() > LAG_OF_SAMPLE * step && phase > LAG_OF_PHASE
}

/// Returns the likely cause if displacement and velocity contradict each other strongly, else `None`. `units` are the
/// units in which the channels were read.
pub(crate) fn contradiction(agreement: &Agreement, units: &[(Channel, Unit)]) -> Option<Sentence> {
    let Agreement { gain, explained, size, .. } = *agreement;
    let by = |cause: Template, figure: &'static str, value: String| {
        Sentence::from(cause).with(figure, value).with_sentence("advice", phrases::READ_ONE_ONLY)
    };
    if explained < 0.5 {
        return Some(by(phrases::OTHER_MOTION, "percent", format_decimals(100.0 * explained.max(0.0), 0)));
    }
    if gain < 0.0 {
        return Some(by(phrases::OPPOSITE_SIGNS, "gain", format_decimals(gain, 3)));
    }
    if !(0.75..1.33).contains(&gain) {
        let mut causes = unit_slip::candidates(gain, size, units).into_iter();
        if let Some(likely) = causes.next() {
            let others: Vec<Sentence> = causes.collect();
            let others = (!others.is_empty())
                .then(|| Sentence::from(phrases::OTHERWISE).with_list("others", others, phrases::OR_ELSE));
            let slip = Sentence::from(phrases::UNIT_SLIP).with("gain", format_decimals(gain, 4));
            return Some(slip.with_sentence("likely", likely).with_any("others", others));
        }
        return Some(by(phrases::OTHER_SCALE, "gain", format_decimals(gain, 3)));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::SineTest;

    fn channels() -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let samples = SineTest { per_cycle: 500, ..SineTest::default() }.samples();
        (samples.time, samples.displacement.unwrap(), samples.velocity.unwrap())
    }

    #[test]
    fn gain_and_lag_are_found() {
        let (time, x, v) = channels();
        let agreement = compare(&time, &x, &v).unwrap();
        assert!((agreement.gain - 1.0).abs() < 1e-3 && agreement.lag.abs() < 1e-5, "{agreement:?}");
        assert!(contradiction(&agreement, &[]).is_none());
        assert!(!is_delayed(&agreement, 0.002, Some(1.0)));
        // The velocity is 3 % too large, has an offset and lags by four samples (8 ms).
        let late: Vec<f64> = (0..v.len()).map(|i| 1.03 * v[i.saturating_sub(4)] + 0.002).collect();
        let agreement = compare(&time, &x, &late).unwrap();
        assert!((agreement.gain - 1.03).abs() < 3e-3 && (agreement.lag - 0.008).abs() < 2e-4, "{agreement:?}");
        assert!(is_delayed(&agreement, 0.002, Some(1.0)) && !is_delayed(&agreement, 0.002, Some(100.0)));
    }

    #[test]
    fn gross_contradictions_are_named() {
        let (time, x, v) = channels();
        let units = [
            (Channel::Time, Unit::Second),
            (Channel::Displacement, Unit::Metre),
            (Channel::Velocity, Unit::MetrePerSecond),
        ];
        let cause = |factor: f64| {
            let other: Vec<f64> = v.iter().map(|v| factor * v).collect();
            contradiction(&compare(&time, &x, &other).unwrap(), &units).unwrap_or_default().to_string()
        };
        assert!(cause(-1.0).contains("opposite signs"));
        assert!(cause(1000.0).contains("Most likely the unit of velocity is mm/s where m/s was read"));
        assert!(cause(0.001).contains("Most likely the unit of displacement is mm where m was read"));
        assert!(cause(1.0 / 39.37).contains("the unit of displacement is in where m was read"));
        assert!(cause(2.0).contains("calibration"));
        assert!(cause(1.1).is_empty());
        let unrelated: Vec<f64> = time.iter().map(|t| libm::sin(7.3 * t)).collect();
        assert!(
            contradiction(&compare(&time, &x, &unrelated).unwrap(), &units)
                .unwrap()
                .to_string()
                .contains("do not belong")
        );
        assert!(compare(&time, &x, &vec![0.0; x.len()]).is_none());
    }

    #[test]
    fn a_lag_within_conversion_or_noise_is_none() {
        let size = MotionSize { amplitude: 0.05, speed: 0.31 };
        let is_delayed =
            |lag: f64, step: f64| is_delayed(&Agreement { gain: 1.0, lag, explained: 1.0, size }, step, Some(1.0));
        // The lags are first fractions of a sampling interval of 0.1 s, then phases in rad of a cycle of 1 s.
        assert!(!is_delayed(0.2 * 0.1, 0.1) && is_delayed(0.3 * 0.1, 0.1));
        let tau = std::f64::consts::TAU;
        assert!(!is_delayed(0.015 / tau, 1e-4) && is_delayed(0.025 / tau, 1e-4));
    }
}
