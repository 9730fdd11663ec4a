//! How fast the force follows a step of the setting: times of a response, measured and by the model.

use serde::Serialize;

/// Times of a response to a step, s, counted from the step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ResponseTimes {
    /// Until the force has gone a tenth of its way.
    pub t10_s: f64,
    /// Until it has gone 63 %.
    pub t63_s: f64,
    /// Until it has gone 90 %.
    pub t90_s: f64,
    /// How far it goes beyond its end, as a fraction of its way.
    pub overshoot: f64,
}

impl ResponseTimes {
    /// Times of a response that runs from 0 to 1. `None` where it does not get there, or is not known where it crosses.
    pub fn measure(time: &[f64], response: &[f64]) -> Option<ResponseTimes> {
        let begins = time.partition_point(|t| *t < 0.0);
        let reach = |fraction: f64, from: usize| -> Option<usize> {
            // Two in a row, so that no single sample of noise is a response.
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
        // The mean of neighbors: the largest of many noisy samples is no overshoot.
        let most = response[at_63..].windows(5).map(|w| w.iter().sum::<f64>() / 5.0).fold(1.0, f64::max);
        Some(ResponseTimes {
            t10_s: crossing(at_10, 0.1)?.max(0.0),
            t63_s: crossing(at_63, 0.632)?,
            t90_s: crossing(at_90, 0.9)?,
            overshoot: most - 1.0,
        })
    }
}

/// The response to steps of one test in one direction.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StepGroup {
    /// Name of the test.
    pub test: String,
    /// Whether the damper was in rebound at the step.
    pub is_rebound: bool,
    /// Number of steps.
    pub steps: usize,
    /// Times of the measured force; absent where the records do not show them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<ResponseTimes>,
    /// Times of the model's force.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<ResponseTimes>,
}

/// The response to steps from one setting to another.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StepResponse {
    /// Setting before.
    pub from: f64,
    /// Setting after.
    pub to: f64,
    /// Number of steps.
    pub steps: usize,
    /// Tests that they are in.
    pub tests: Vec<String>,
    /// Time between two samples, s; half of it is how far the instant of a step is known.
    pub sample_s: f64,
    /// Fraction of its way that the model's force has gone at the end of the levels.
    pub end_fraction: f64,
    /// Response times of each test and direction that has at least three steps; a limit judges the slowest.
    pub groups: Vec<StepGroup>,
    /// Times of the measured force; absent where the records do not show them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<ResponseTimes>,
    /// Times of the model's force.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<ResponseTimes>,
    /// Time since the step, s.
    #[serde(skip)]
    pub time: Vec<f64>,
    /// Fraction of its way that the measured force has gone.
    #[serde(skip)]
    pub measured_response: Vec<f64>,
    /// Fraction of its way that the model's force has gone.
    #[serde(skip)]
    pub model_response: Vec<f64>,
}

impl StepResponse {
    /// Whether the setting rises.
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
