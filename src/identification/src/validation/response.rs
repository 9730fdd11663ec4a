//! Response of the damper force to a step of the setting: times of the measured force and of the model's force.

use crate::intervals::Z;
use serde::{Deserialize, Serialize};

/// Times of the response to a step, s, from the instant of the step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ResponseTimes {
    /// Time until the force has completed 10 % of its change.
    pub t10_s: f64,
    /// Time until the force has completed 63 % of its change.
    pub t63_s: f64,
    /// Time until the force has completed 90 % of its change.
    pub t90_s: f64,
    /// Overshoot beyond the final force, as a fraction of the change.
    pub overshoot: f64,
}

impl ResponseTimes {
    /// Computes the times of a response that goes from 0 to 1; `time` is the time since the step, s. Returns `None` if the response does
    /// not reach 0.9, or if it has no samples at a crossing.
    pub fn measure(time: &[f64], response: &[f64]) -> Option<ResponseTimes> {
        let begins = time.partition_point(|t| *t < 0.0);
        let reach = |fraction: f64, from: usize| -> Option<usize> {
            // Require two consecutive samples, because a single noisy sample is not a response.
            let pairs = response.windows(2).enumerate().skip(from);
            pairs.filter(|(_, pair)| pair[0] >= fraction && pair[1] >= fraction).map(|(k, _)| k).next()
        };
        let crossing = |k: usize, fraction: f64| {
            let before = k.checked_sub(1)?;
            let (low, high) = (response[before], response[k]);
            if !low.is_finite() {
                return None;
            }
            let part = if high > low { ((fraction - low) / (high - low)).clamp(0.0, 1.0) } else { 1.0 };
            Some(time[before] + part * (time[k] - time[before]))
        };
        let at_63 = reach(0.632, begins)?;
        let at_10 = (begins..=at_63).rev().find(|k| response[*k] < 0.1).map_or(begins, |k| k + 1);
        let at_90 = reach(0.9, at_63)?;
        // Average five neighboring samples, because the largest of many noisy samples is not an overshoot.
        let most = response[at_63..].windows(5).map(|w| w.iter().sum::<f64>() / 5.0).fold(1.0, f64::max);
        Some(ResponseTimes {
            t10_s: crossing(at_10, 0.1)?.max(0.0),
            t63_s: crossing(at_63, 0.632)?,
            t90_s: crossing(at_90, 0.9)?,
            overshoot: most - 1.0,
        })
    }
}

/// Shortest duration of the constant settings before and after a step, s, at which the step is used. A shorter duration does not show the
/// end of the response.
pub const SHORTEST_LEVEL: f64 = 0.03;
/// Largest half-width of a 95 % interval of a measured response, as a fraction of the change. With more noise, a response at 63 % of the
/// change cannot be distinguished from its end, so no times are computed.
const MOST_NOISE: f64 = 1.0 - 0.632;

/// Computes the times of a measured response with their uncertainties. The slope of the model's response converts noise to an uncertainty
/// in time.
///
/// `samples_s` are the sampling intervals of the force and of the command, s. Both results are `None` if the noise hides the change, for
/// example because the instants of the commands are unknown.
pub fn measured_times(
    time: &[f64],
    measured: &[f64],
    model: &[f64],
    samples_s: [f64; 2],
) -> (Option<ResponseTimes>, Option<TimeUncertainty>) {
    if end_noise(time, measured).is_some_and(|noise| Z * noise > MOST_NOISE) {
        return (None, None);
    }
    let times = ResponseTimes::measure(time, measured);
    (times, times.and_then(|_| TimeUncertainty::measure(time, measured, model, samples_s)))
}

/// Uncertainties of measured response times, s: half the width of their 95 % intervals.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TimeUncertainty {
    /// Uncertainty of the time until 63 %.
    pub t63_s: f64,
    /// Uncertainty of the time until 90 %.
    pub t90_s: f64,
    /// Uncertainty of the time from 10 % to 90 %. The instant of the command does not affect it.
    pub rise_s: f64,
}

/// Fraction of a response time above which texts state its uncertainty, or its difference from the model's time.
const COARSE: f64 = 0.1;
/// Largest error of the instant of a command, in sampling intervals. The instant lies anywhere between two samples.
const HALF_SAMPLE: f64 = 0.5;
/// Rise time from 10 % to 90 % of a straight line over one sampling interval, in sampling intervals.
///
/// A record with few samples shows a jump of the force as such a line. Its measured rise time is then too long by up to this value, and its
/// time until 90 % by half of it.
const LINE: f64 = 0.8;

impl TimeUncertainty {
    /// Returns an uncertainty if it is more than a tenth of the time to which it belongs. Texts state only such an uncertainty.
    pub fn if_coarse(uncertainty: Option<f64>, time: f64) -> Option<f64> {
        uncertainty.filter(|of| *of > COARSE * time)
    }

    /// Computes the uncertainties from the noise of the measured response and the slope of the modeled response, which has no noise.
    ///
    /// Near its end, a response is almost level. So even a small noise makes the time until 90 % uncertain.
    ///
    /// Returns `None` if the modeled response does not reach 90 %, or if the measured response has fewer than three samples in its last
    /// quarter.
    pub fn measure(
        time: &[f64],
        measured: &[f64],
        model: &[f64],
        [sample_s, command_sample_s]: [f64; 2],
    ) -> Option<TimeUncertainty> {
        let noise = Z * end_noise(time, measured)?;
        let reaches = |fraction: f64| (0..time.len()).find(|k| time[*k] >= 0.0 && model[*k] >= fraction);
        let last = *time.last()?;
        let at = |fraction: f64| {
            let Some(k) = reaches(fraction) else { return last };
            let Some(before) = k.checked_sub(1).filter(|before| model[*before] < fraction) else { return time[k] };
            let part = (fraction - model[before]) / (model[k] - model[before]);
            time[before] + part * (time[k] - time[before])
        };
        let of_noise = |fraction: f64| 0.5 * (at(fraction + noise) - at(fraction - noise));
        reaches(0.9)?;
        let [at_10, at_63, at_90] = [0.1, 0.632, 0.9].map(of_noise);
        let instant = HALF_SAMPLE * command_sample_s;
        let line = LINE * sample_s;
        Some(TimeUncertainty {
            t63_s: instant + at_63,
            t90_s: instant + 0.5 * line + at_90,
            rise_s: line + libm::hypot(at_10, at_90),
        })
    }
}

/// Fraction of a response, at its end, from which the noise is determined.
const END: f64 = 0.25;

/// Computes the standard deviation of a response from a straight line in its last quarter. Returns `None` for fewer than three samples.
fn end_noise(time: &[f64], response: &[f64]) -> Option<f64> {
    let from = time.partition_point(|t| *t < (1.0 - END) * time[time.len() - 1]);
    let points = || time[from..].iter().zip(&response[from..]).filter(|(_, r)| r.is_finite());
    let count = points().count() as f64;
    if count < 3.0 {
        return None;
    }
    let mean = |of: &dyn Fn(f64, f64) -> f64| points().map(|(t, r)| of(*t, *r)).sum::<f64>() / count;
    let [t, r] = [mean(&|t, _| t), mean(&|_, r| r)];
    let [tt, tr] = [mean(&|x, _| (x - t) * (x - t)), mean(&|x, y| (x - t) * (y - r))];
    let slope = tr / tt;
    let square = mean(&|x, y| (y - r - slope * (x - t)) * (y - r - slope * (x - t)));
    Some((square * count / (count - 2.0)).sqrt())
}

/// Response to the steps of one test in one stroke direction: rebound or compression.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StepGroup {
    /// Name of the test.
    pub test: String,
    /// Whether the damper was in rebound at the step.
    pub is_rebound: bool,
    /// Number of steps.
    pub steps: usize,
    /// Times of the measured force, or `None` if the records do not show them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<ResponseTimes>,
    /// Uncertainties of the measured times, or `None` if they cannot be computed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<TimeUncertainty>,
    /// Times of the model's force, or `None` if they cannot be determined.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<ResponseTimes>,
}

/// Response to steps from one setting to another.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StepResponse {
    /// Setting before the step.
    pub from: f64,
    /// Setting after the step.
    pub to: f64,
    /// Number of steps.
    pub steps: usize,
    /// Names of the tests that contain the steps.
    pub tests: Vec<String>,
    /// Sampling interval, s. The instant of a step is known to half of it if the command has no missing values.
    pub sample_s: f64,
    /// Completed fraction of the change of the model's force when the next step begins. It is below 1 if the setting is constant for too
    /// short a time, compared with the lag.
    pub end_fraction: f64,
    /// Response times of each test and stroke direction with at least three steps. A limit applies to the slowest of these groups and of
    /// all steps together.
    pub groups: Vec<StepGroup>,
    /// Times of the measured force, or `None` if the records do not show them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<ResponseTimes>,
    /// Uncertainties of the measured times, or `None` if they cannot be computed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<TimeUncertainty>,
    /// Times of the model's force, or `None` if they cannot be determined.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<ResponseTimes>,
    /// Time since the step, s.
    #[serde(skip)]
    pub time: Vec<f64>,
    /// Completed fraction of the change of the measured force.
    #[serde(skip)]
    pub measured_response: Vec<f64>,
    /// Completed fraction of the change of the model's force.
    #[serde(skip)]
    pub model_response: Vec<f64>,
}

impl StepResponse {
    /// Returns whether the setting rises.
    pub fn is_up(&self) -> bool {
        self.to > self.from
    }

    /// Returns by how much later than measured the model's force has completed 63 % of its change, s; negative if earlier. Returns `None`
    /// if the difference is within the uncertainty of the measured time, or below a tenth of this time.
    pub fn delay_of_model(&self) -> Option<f64> {
        let (measured, model) = (self.measured?.t63_s, self.model?.t63_s);
        let least = (COARSE * measured).max(self.uncertainty?.t63_s);
        Some(model - measured).filter(|delay| delay.abs() > least)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_a_lag_with_dead_time() {
        let time: Vec<f64> = (0..600).map(|k| 5e-4 * f64::from(k) - 0.01).collect();
        let response: Vec<f64> =
            time.iter().map(|t| if *t < 0.003 { 0.0 } else { 1.0 - libm::exp(-(t - 0.003) / 0.01) }).collect();
        let found = ResponseTimes::measure(&time, &response).unwrap();
        assert!((found.t63_s - 0.013).abs() < 1e-4, "{found:?}");
        assert!((found.t10_s - 0.00405).abs() < 1e-4 && (found.t90_s - 0.02603).abs() < 1e-4, "{found:?}");
        assert!(found.overshoot < 1e-9);
        assert_eq!(ResponseTimes::measure(&time, &vec![0.3; 600]), None);
    }

    #[test]
    fn a_model_later_than_the_uncertainty_is_stated() {
        let times = |t63_s: f64| Some(ResponseTimes { t10_s: 0.002, t63_s, t90_s: 0.03, overshoot: 0.0 });
        let uncertainty = Some(TimeUncertainty { t63_s: 1e-3, t90_s: 1e-3, rise_s: 1e-3 });
        let of = |measured: f64, model: f64| StepResponse {
            from: 1.6,
            to: 0.3,
            steps: 9,
            tests: Vec::new(),
            sample_s: 1e-3,
            end_fraction: 1.0,
            groups: Vec::new(),
            measured: times(measured),
            uncertainty,
            model: times(model),
            time: Vec::new(),
            measured_response: Vec::new(),
            model_response: Vec::new(),
        };
        assert!((of(0.006, 0.011).delay_of_model().unwrap() - 5e-3).abs() < 1e-12);
        assert!((of(0.011, 0.006).delay_of_model().unwrap() + 5e-3).abs() < 1e-12);
        // The differences are within the uncertainty, and within a tenth of the measured time.
        assert_eq!(of(0.006, 0.0069).delay_of_model(), None);
        assert_eq!(of(0.020, 0.0218).delay_of_model(), None);
    }

    #[test]
    fn noise_makes_the_time_to_the_end_of_a_response_uncertain() {
        let time: Vec<f64> = (0..1600).map(|k| 1e-4 * f64::from(k) - 0.01).collect();
        let model: Vec<f64> = time.iter().map(|t| if *t < 0.0 { 0.0 } else { 1.0 - libm::exp(-t / 0.01) }).collect();
        // The noise has a standard deviation of 0.02.
        let noisy: Vec<f64> = (0i32..).zip(&model).map(|(k, r)| r + if k % 2 == 0 { 0.02 } else { -0.02 }).collect();
        let of = |measured: &[f64]| TimeUncertainty::measure(&time, measured, &model, [1e-3; 2]).unwrap();
        let (clean, found) = (of(&model), of(&noisy));
        assert!((clean.t63_s - 5e-4).abs() < 2e-5 && (clean.rise_s - 8e-4).abs() < 5e-5, "{clean:?}");
        // The slope of the modeled response is 0.1/τ at 90 % and e^-1/τ at 63 %, with the time constant τ = 0.01 s.
        assert!((found.t63_s - 5e-4 - 0.04 * 0.01 / 0.368).abs() < 1e-4, "{found:?}");
        assert!(found.rise_s > 4.6e-3 && found.rise_s < 5.6e-3, "{found:?}");
        // Noise as large as the remaining change hides the times.
        let noise: Vec<f64> = (0i32..).zip(&model).map(|(k, r)| r + if k % 2 == 0 { 0.3 } else { -0.3 }).collect();
        assert_eq!(measured_times(&time, &noise, &model, [1e-3; 2]), (None, None));
        assert!(measured_times(&time, &noisy, &model, [1e-3; 2]).0.is_some());
        assert_eq!(TimeUncertainty::measure(&time, &noisy, &vec![0.5; 1600], [1e-3; 2]), None);
    }
}
