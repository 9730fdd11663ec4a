//! Doubt about the setting of a test, because its forces are those of another setting.

use crate::phrases;
use dashpot_messages::Sentence;
use dashpot_records::setting_in_words;
use serde::Serialize;

/// Test with a doubtful setting, and the errors on which the doubt is based.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SettingDoubt {
    /// Name of the test.
    pub test: String,
    /// Setting that the record states, or that the user gave for it.
    pub stated: f64,
    /// Setting at which the model fits best.
    pub fitting: f64,
    /// Mean absolute error at the stated setting, N.
    pub stated_error_n: f64,
    /// Mean absolute error at the fitting setting, N.
    pub fitting_error_n: f64,
}

impl SettingDoubt {
    /// Formats the doubt as a sentence. `unit` is the unit of the setting.
    pub fn sentence(&self, unit: &str) -> Sentence {
        Sentence::from(phrases::SETTING_DOUBT)
            .with("test", &self.test)
            .with("stated", setting_in_words(self.stated, unit))
            .with("fitting", setting_in_words(self.fitting, unit))
            .with("stated_error", format!("{:.0}", self.stated_error_n))
            .with("fitting_error", format!("{:.0}", self.fitting_error_n))
    }
}
