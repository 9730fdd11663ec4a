//! Setting of an adjustable damper in the file of a motion.

use crate::cleaning::set_to::setting_channel;
use crate::data::samples::Samples;
use crate::quantities::channel::Channel;
use crate::quantities::setting_rules::SettingRules;
use crate::quantities::setting_value::Setting;

/// Source of the setting of a motion.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SettingSource {
    /// A column of the file: its heading, and the channel that was assigned to it.
    Column(String, Channel),
    /// The name of the test, from the name of the file.
    Name {
        /// Whether the number is certainly a setting. A whole number with a single letter, such as 2A, may be the
        /// number of the motion instead.
        is_sure: bool,
    },
    /// The user's rules, from the entry `settings` of `campaign.toml` in the file's folder.
    Profile,
}

/// The setting of an adjustable damper along a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionSetting {
    /// Name of the setting, such as `current`.
    pub name: String,
    /// Unit of the setting.
    pub unit: String,
    /// Value of the setting at each sample.
    pub values: Vec<f64>,
    /// Source of the setting.
    pub source: SettingSource,
}

impl MotionSetting {
    /// Finds the setting as for a record: from the user's rules, else from a column, else from the file name. Returns
    /// `None` if none of them states a setting, or if the rules state that there is none. Unless the rules state the
    /// setting, removes the setting columns from the samples.
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
        let is_without = rules.find(&samples.name).is_some();
        let channel = if samples.setting.is_some() { Channel::Setting } else { Channel::Current };
        let heading = samples.heading(channel);
        let column = setting_channel(samples, rules);
        if is_without {
            return None;
        }
        if let Some((values, name, unit)) = column {
            return Some(MotionSetting { name, unit, values, source: SettingSource::Column(heading, channel) });
        }
        let (setting, is_sure) = Setting::of_name(&samples.name)?;
        Some(constant(setting, SettingSource::Name { is_sure }))
    }
}
