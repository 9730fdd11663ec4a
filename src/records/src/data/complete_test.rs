//! A test with valid samples and complete motion.

use super::cycle::Cycle;
use super::measurement_error::MeasurementError;
use super::record::Note;
use super::setting_signal::SettingSignal;
use super::test_metadata::TestMetadata;
use crate::error::Place;
use crate::quantities::setting_value::Setting;

/// A test with valid samples and complete motion, with the signs of the file and without trimming.
#[derive(Debug, Clone)]
pub(crate) struct CompleteTest {
    pub at: Place,
    pub name: String,
    pub time: Vec<f64>,
    pub begins: Option<f64>,
    /// Metadata of the test.
    pub about: TestMetadata,
    pub displacement: Vec<f64>,
    pub velocity: Vec<f64>,
    /// Length of the window for deriving the velocity from the displacement, s; 0 if the recorded velocity is used.
    pub velocity_window_s: f64,
    pub force: Vec<f64>,
    pub side_force: Option<Vec<f64>>,
    pub temperature: Option<Vec<f64>>,
    pub setting: Option<Setting>,
    /// Signal of a setting that changes within the test, if a channel records it.
    pub setting_signal: Option<SettingSignal>,
    pub cycles: Vec<Cycle>,
    /// Error stated by the user. The force channel still contains the inertia force of the mass between load cell and
    /// damper.
    pub stated_error: MeasurementError,
    pub notes: Vec<Note>,
}

impl CompleteTest {
    /// Returns the sample range of the steady part: from the first whole cycle to the last, or all samples if there are
    /// no cycles.
    pub fn steady(&self) -> std::ops::Range<usize> {
        steady(&self.cycles, self.time.len())
    }
}

/// Returns the sample range from the first whole cycle to the last, or all samples if there are no cycles.
pub(crate) fn steady(cycles: &[Cycle], samples: usize) -> std::ops::Range<usize> {
    match (cycles.first(), cycles.last()) {
        (Some(first), Some(last)) => first.start..last.end,
        _ => 0..samples,
    }
}
