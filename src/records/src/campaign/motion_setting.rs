//! What the file of a motion says of the setting of an adjustable damper.

use crate::cleaning::set_to::setting_channel;
use crate::data::samples::Samples;
use crate::quantities::channel::Channel;
use crate::quantities::setting_value::{Setting, SettingRules};

/// Where the setting of a motion stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SettingSource {
    /// A column of the file, by its heading, and the channel that it was read as.
    Column(String, Channel),
    /// The name of the file.
    Name {
        /// Whether the number cannot number the motions, as a letter behind a whole number may.
        is_sure: bool,
    },
    /// `campaign.toml` beside the file.
    Profile,
}

/// The setting of an adjustable damper along a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionSetting {
    /// What is set, such as `current`.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Its value at each sample.
    pub values: Vec<f64>,
    /// Where it stands.
    pub source: SettingSource,
}

impl MotionSetting {
    /// Finds the setting as for a record: what the user's rules say, else a column, else the name of the file. Takes the columns out of the samples.
    pub(crate) fn take(samples: &mut Samples, rules: &SettingRules) -> Option<MotionSetting> {
        let count = samples.len();
        let constant = |setting: Setting, source| MotionSetting {
            name: setting.name,
            unit: setting.unit,
            values: vec![setting.value; count],
            source,
        };
        if let Some(setting) = rules.setting_of(&samples.name) {
            return Some(constant(setting, SettingSource::Profile));
        }
        let channel = if samples.setting.is_some() { Channel::Setting } else { Channel::Current };
        let heading = samples.heading(channel);
        if let Some((values, name, unit)) = setting_channel(samples, rules) {
            return Some(MotionSetting { name, unit, values, source: SettingSource::Column(heading, channel) });
        }
        let (setting, is_sure) = Setting::of_name(&samples.name)?;
        Some(constant(setting, SettingSource::Name { is_sure }))
    }
}
