//! Validation of one test: errors, hysteresis and peak forces.

use super::compared::Compared;
use super::deviation::{Deviation, Errors};
use super::hysteresis::{Hysteresis, OfEach};
use crate::peaks::AtPeak;
use serde::Serialize;

/// All figures of one test.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TestValidation {
    /// Name of the test.
    pub name: String,
    /// Displacement amplitude, m.
    pub amplitude_m: f64,
    /// Frequency, Hz, or zero if the motion is not periodic.
    pub frequency_hz: f64,
    /// Peak velocity, m/s.
    pub peak_velocity_m_s: f64,
    /// Largest |measured force|, N.
    pub max_force_n: f64,
    /// Errors of the model and of the force–velocity curve alone.
    #[serde(flatten)]
    pub errors: Errors,
    /// Whether the identification used the test.
    pub used_in_fit: bool,
    /// Number of compared samples.
    pub samples: usize,
    /// Number of whole cycles.
    pub cycles: usize,
    /// Root mean square of the measured force's noise, N. No model can have a smaller error.
    pub noise_rms_n: f64,
    /// Hysteresis, or `None` if the test has no whole cycles.
    pub hysteresis: Option<Hysteresis>,
    /// Force at peak velocity in rebound and in compression, or empty if the test has no whole cycles.
    pub peaks: Vec<PeakForce>,
}

/// Force at the peak velocity of one stroke of a test.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PeakForce {
    /// Velocity, m/s, rebound positive.
    pub velocity_m_s: f64,
    /// Measured and simulated forces at the peak velocity, N.
    pub force_n: OfEach,
}

impl TestValidation {
    /// Computes all figures of a checked test.
    pub(super) fn from_compared(compared: &Compared<'_>) -> Self {
        let record = compared.record;
        let max_force_n = record.force.iter().fold(0.0_f64, |largest, force| largest.max(force.abs()));
        let deviation = |simulated| Deviation::of_test(simulated, &record.force, &record.velocity, max_force_n);
        Self {
            name: record.name.clone(),
            amplitude_m: record.amplitude,
            frequency_hz: record.frequency,
            peak_velocity_m_s: record.peak_velocity,
            max_force_n,
            errors: Errors { model: deviation(&compared.model), fv_only: deviation(&compared.fv_only) },
            used_in_fit: compared.used_in_fit,
            samples: record.force.len(),
            cycles: record.cycles.len(),
            noise_rms_n: record.noise.force_rms,
            hysteresis: Hysteresis::of_test(compared),
            peaks: PeakForce::of_test(compared),
        }
    }
}

impl PeakForce {
    fn of_test(compared: &Compared<'_>) -> Vec<Self> {
        let Some(at) = AtPeak::find(compared.record) else { return Vec::new() };
        let [measured, model, fv_only] =
            [&compared.record.force, &compared.model, &compared.fv_only].map(|force| at.pick(force));
        let stroke = |k: usize| PeakForce {
            velocity_m_s: measured[k].velocity_m_s,
            force_n: OfEach { measured: measured[k].force_n, model: model[k].force_n, fv_only: fv_only[k].force_n },
        };
        vec![stroke(0), stroke(1)]
    }
}
