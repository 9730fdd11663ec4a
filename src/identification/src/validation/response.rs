//! Response of the force to a step of the setting: times of the measured force and of the model.

use serde::Serialize;

/// Times of a response to a step, s, relative to the step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
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
    /// Computes the times of a response from 0 to 1. Returns `None` if the response does not reach 1, or has no samples at a crossing.
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
        // Average neighbors, because the largest of many noisy samples is not an overshoot.
        let most = response[at_63..].windows(5).map(|w| w.iter().sum::<f64>() / 5.0).fold(1.0, f64::max);
        Some(ResponseTimes {
            t10_s: crossing(at_10, 0.1)?.max(0.0),
            t63_s: crossing(at_63, 0.632)?,
            t90_s: crossing(at_90, 0.9)?,
            overshoot: most - 1.0,
        })
    }
}

/// Response to the steps of one test in one direction.
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
    /// Times of the model's force.
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
    /// Names of the tests that contain these steps.
    pub tests: Vec<String>,
    /// Sampling interval, s. The uncertainty of the instant of a step is half of it.
    pub sample_s: f64,
    /// Completed fraction of the change of the model's force at the end of the levels.
    pub end_fraction: f64,
    /// Response times of each test and direction with at least three steps. A limit applies to the slowest group.
    pub groups: Vec<StepGroup>,
    /// Times of the measured force, or `None` if the records do not show them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<ResponseTimes>,
    /// Times of the model's force.
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
}
