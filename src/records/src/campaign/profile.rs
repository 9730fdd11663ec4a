//! Known facts about the records of a folder, from the file `campaign.toml` in that folder. All commands apply them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::dates::date_order::DateOrder;
use crate::error::{RecordError, RecordFileError};
use crate::options::{Options, Positive};
use crate::quantities::channel::Channel;
use crate::quantities::setting_rules::SettingRules;
use crate::quantities::stated_setting::StatedSetting;
use crate::source;

/// Name of the file with the known facts about the records of its folder (the profile).
pub const FILE: &str = "campaign.toml";
/// Largest size of a profile, bytes. A profile has one line for each entry, so a larger file is not a profile.
const LARGEST: u64 = 1 << 20;
/// Value of the entry `format` in every profile.
pub const FORMAT: &str = "dashpot campaign profile 1";

/// Beginning of the entry `format` in the description that the virtual rig writes beside its records.
const OF_VIRTUAL_RIG: &str = "dashpot rig campaign";
/// Name of the subfolder in which the virtual rig hides the truth about its damper. Its files are no records.
pub(crate) const SEALED: &str = "sealed";

/// The entries of a file `campaign.toml`. A missing entry means no correction, or a value determined from the records.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Profile {
    /// Format of the file: always [`FORMAT`].
    pub format: String,
    /// Positive direction of the files: rebound or compression.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub positive: Option<String>,
    /// Channels whose sign is reversed: `force`, or `motion` for displacement and velocity.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub flip: Vec<String>,
    /// Channels that are not read.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ignore: Vec<String>,
    /// Files and tests to leave out. `*` matches any text.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub exclude: Vec<String>,
    /// Whether the records in the subfolders are tests of the same campaign.
    #[serde(default, skip_serializing_if = "is_false")]
    pub subfolders: bool,
    /// Lag of the recorded force behind the motion, s.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub delay_s: f64,
    /// Reading of the force channel at zero force, N.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub force_zero_n: f64,
    /// Reading of the displacement channel at the position that shall be zero, times the channel's gain, m.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub displacement_zero_m: f64,
    /// Calibration factor on the force.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub gain: f64,
    /// Mass between load cell and damper that moves with the damper's end, kg.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub rig_mass_kg: f64,
    /// Sampling rate of files without a time column, 1/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sample_rate_hz: Option<f64>,
    /// Order of day and month in the dates of the files: day-first or month-first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dates: Option<String>,
    /// Displacement at the first sample, m, if only a velocity was recorded.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub initial_position_m: f64,
    /// Name of the setting, such as current, clicks or pressure.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub setting: Option<String>,
    /// Unit of the setting, such as A.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub setting_unit: String,
    /// Column of each channel, by its heading or by its number from 1.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub columns: BTreeMap<String, String>,
    /// Factors on channels other than the force, by channel.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub gains: BTreeMap<String, f64>,
    /// Unit of each channel.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub units: BTreeMap<String, String>,
    /// Settings by test names: numbers, numbers with their unit, or `none`. `*` matches any text.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub settings: BTreeMap<String, StatedSetting>,
}

#[allow(clippy::trivially_copy_pass_by_ref)] // serde passes a reference
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

#[allow(clippy::trivially_copy_pass_by_ref)] // serde passes a reference
fn is_false(value: &bool) -> bool {
    !value
}

#[allow(clippy::trivially_copy_pass_by_ref)] // serde passes a reference
fn is_one(value: &f64) -> bool {
    *value == 1.0
}

fn one() -> f64 {
    1.0
}

impl Profile {
    /// Reads the profile of a folder. Returns `None` if the file is missing or empty, or if it describes a campaign
    /// that the virtual rig simulated.
    ///
    /// # Errors
    /// The file cannot be read, is too large, lacks the entry `format`, or has an invalid entry.
    pub fn read(folder: &Path) -> Result<Option<Profile>, RecordError> {
        let file = folder.join(FILE);
        let text = match source::text(&file, LARGEST) {
            Ok(text) => text,
            Err(RecordError::File(RecordFileError::Read { source, .. }))
                if source.kind() == std::io::ErrorKind::NotFound =>
            {
                return Ok(None);
            }
            Err(error) => return Err(error),
        };
        if text.trim().is_empty() {
            return Ok(None);
        }
        let wrong = |cause: String| RecordError::File(RecordFileError::Profile { file: file.clone(), cause });
        let table: toml::Table = toml::from_str(&text).map_err(|e| wrong(e.to_string().trim().to_owned()))?;
        match table.get("format").and_then(toml::Value::as_str) {
            Some(FORMAT) => {}
            // The virtual rig writes its description of a campaign in this format, which has no entries for reading
            // records.
            Some(other) if other.starts_with(OF_VIRTUAL_RIG) => return Ok(None),
            _ => return Err(wrong(format!("it lacks the line format = \"{FORMAT}\""))),
        }
        let profile: Profile = toml::from_str(&text).map_err(|e| wrong(e.to_string().trim().to_owned()))?;
        profile.options().map_err(wrong)?;
        Ok(Some(profile))
    }

    /// Makes the profile from options.
    pub fn from_options(options: &Options) -> Profile {
        let named = |on: bool, name: &str| on.then(|| name.to_owned());
        Profile {
            format: FORMAT.to_owned(),
            positive: options.positive.map(|p| p.name().to_owned()),
            flip: [named(options.flip_force, "force"), named(options.flip_motion, "motion")]
                .into_iter()
                .flatten()
                .collect(),
            ignore: options.ignore.iter().map(Channel::to_string).collect(),
            exclude: options.exclude.clone(),
            subfolders: options.subfolders,
            delay_s: options.delay_s,
            force_zero_n: options.force_zero_n,
            displacement_zero_m: options.displacement_zero_m,
            gain: options.gain,
            gains: options.gains.iter().map(|(c, gain)| (c.to_string(), *gain)).collect(),
            rig_mass_kg: options.rig_mass_kg,
            sample_rate_hz: options.sample_rate_hz,
            dates: options.dates.map(|order| order.name().to_owned()),
            initial_position_m: options.initial_position,
            columns: options.columns.iter().map(|(c, h)| (c.to_string(), h.clone())).collect(),
            units: options.units.iter().map(|(c, u)| (c.to_string(), u.to_string())).collect(),
            setting: options.settings.name.clone(),
            setting_unit: options.settings.unit.clone(),
            settings: options.settings.values.clone(),
        }
    }

    /// Converts the profile to options.
    ///
    /// # Errors
    /// A message about an invalid channel, unit, direction, date order or number.
    pub fn options(&self) -> Result<Options, String> {
        let mut options = Options {
            positive: self.positive.as_deref().map(str::parse::<Positive>).transpose()?,
            exclude: self.exclude.clone(),
            subfolders: self.subfolders,
            delay_s: self.delay_s,
            force_zero_n: self.force_zero_n,
            displacement_zero_m: self.displacement_zero_m,
            gain: self.gain,
            rig_mass_kg: self.rig_mass_kg,
            sample_rate_hz: self.sample_rate_hz,
            dates: self.dates.as_deref().map(str::parse::<DateOrder>).transpose()?,
            initial_position: self.initial_position_m,
            settings: SettingRules {
                name: self.setting.clone(),
                unit: self.setting_unit.clone(),
                values: self.settings.clone(),
            },
            ..Options::default()
        };
        for text in &self.flip {
            match text.as_str() {
                "force" => options.flip_force = true,
                "motion" => options.flip_motion = true,
                _ => return Err(format!("flip takes force or motion, not {text:?}")),
            }
        }
        for text in &self.ignore {
            options.ignore.insert(text.parse()?);
        }
        for (channel, gain) in &self.gains {
            let channel: Channel = channel.parse()?;
            if channel == Channel::Force {
                return Err("the gain of the force is the entry gain".to_owned());
            }
            options.gains.insert(channel, *gain);
        }
        for (channel, heading) in &self.columns {
            options.columns.insert(channel.parse()?, heading.clone());
        }
        for (channel, unit) in &self.units {
            options.units.insert(channel.parse()?, unit.parse()?);
        }
        options.check()?;
        Ok(options)
    }

    /// Formats the profile as the text of `campaign.toml`.
    pub fn text(&self) -> String {
        let rows = toml::to_string(self).unwrap_or_default();
        format!("# What is known about the records in this folder; every verb of dashpot obeys it.\n{rows}")
    }
}

/// Returns whether the virtual rig has written the records of a folder.
pub(crate) fn is_of_virtual_rig(folder: &Path) -> bool {
    let table =
        source::text(&folder.join(FILE), LARGEST).ok().and_then(|text| toml::from_str::<toml::Table>(&text).ok());
    let format = table.as_ref().and_then(|table| table.get("format")).and_then(toml::Value::as_str);
    format.is_some_and(|format| format.starts_with(OF_VIRTUAL_RIG))
}

/// Returns the folder whose profile applies to a path: the path itself if it is a folder, else the folder of the file.
pub fn folder_of(path: &Path) -> PathBuf {
    if path.is_dir() {
        return path.to_owned();
    }
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<Option<Profile>, String> {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join(FILE), text).unwrap();
        Profile::read(folder.path()).map_err(|e| e.to_string())
    }

    #[test]
    fn a_profile_reads_back_as_written() {
        let mut options = Options { flip_force: true, gain: 2.0, delay_s: 0.01, ..Options::default() };
        options.positive = Some(Positive::Compression);
        options.dates = Some(DateOrder::DayFirst);
        options.columns.insert(Channel::Time, "Zeit [s]".into());
        options.gains.insert(Channel::Displacement, 1.02);
        options.units.insert(Channel::Force, "kN".parse().unwrap());
        options.ignore.insert(Channel::Velocity);
        options.exclude = vec!["warm*".into()];
        options.settings.name = Some("current".into());
        for (pattern, stated) in [("*1.6A*", "1.6"), ("*hard", "800 mA"), ("warm*", "none")] {
            options.settings.values.insert(pattern.into(), stated.parse().unwrap());
        }
        let profile = Profile::from_options(&options);
        assert!(profile.text().contains("\"*1.6A*\" = 1.6\n\"*hard\" = \"800.0 mA\"\n\"warm*\" = \"none\"\n"));
        let back = of(&profile.text()).unwrap().unwrap();
        assert_eq!(back, profile);
        assert_eq!(Profile::from_options(&back.options().unwrap()), profile);
    }

    #[test]
    fn what_is_no_profile_is_told_from_a_wrong_one() {
        assert_eq!(of("").unwrap(), None);
        assert_eq!(of("format = \"dashpot rig campaign 1\"\nseed = 3\n").unwrap(), None);
        for (text, wanted) in [
            ("gain = 2\n", "lacks the line format"),
            ("format = \"dashpot campaign profile 1\"\ngian = 2.0\n", "gian"),
            ("format = \"dashpot campaign profile 1\"\ngain = -1.0\n", "gain"),
            ("format = \"dashpot campaign profile 1\"\ndisplacement_zero_m = 1e308\n", "at most 10 m"),
            ("format = \"dashpot campaign profile 1\"\ngains = { displacement = 1e9 }\n", "gain of displacement"),
            ("format = \"dashpot campaign profile 1\"\ngains = { time = 1.1 }\n", "takes no gain"),
            ("format = \"dashpot campaign profile 1\"\nunits = { force = \"parsec\" }\n", "parsec"),
            ("format = \"dashpot campaign profile 1\"\ncolumns = { pressure = \"p\" }\n", "pressure"),
            ("format = \"dashpot campaign profile 1\"\npositive = \"up\"\n", "up"),
            ("format = \"dashpot campaign profile 1\"\ndates = \"iso\"\n", "iso"),
            ("format = \"dashpot campaign profile 1\"\n[settings]\n\"a*\" = 1.0\n", "setting = \"current\""),
            ("format = \"dashpot campaign profile 1\"\nsetting = \"current\"\n[settings]\n\"a*\" = inf\n", "a*"),
            (
                "format = \"dashpot campaign profile 1\"\nsetting = \"current\"\n[settings]\n\"a*\" = \"hard\"\n",
                "0.8 A",
            ),
            ("format = \"dashpot campaign profile 1\"\nsetting = \"current\"\n[settings]\n\"a*\" = [1]\n", "a number"),
            (
                "format = \"dashpot campaign profile 1\"\nsetting = \"current\"\n[settings]\n\"a*\" = \"3 bar\"\n",
                "unit of current",
            ),
            ("format = [\n", "campaign.toml"),
        ] {
            let message = of(text).unwrap_err();
            assert!(message.contains(wanted) && message.contains("campaign.toml"), "{text}: {message}");
        }
    }
}
