//! Options of the user for reading records.

use std::collections::{BTreeMap, BTreeSet};
use std::str::FromStr;

use dashpot_messages::format_number;
use serde::{Deserialize, Serialize};

use crate::dates::date_order::DateOrder;
use crate::quantities::channel::Channel;
use crate::quantities::setting_rules::SettingRules;
use crate::quantities::unit::Unit;
use crate::tuning::options::{GAINS, LARGEST_FORCE_ZERO, LARGEST_MASS, LARGEST_POSITION, LONGEST_DELAY, SAMPLE_RATES};

/// The positive direction of displacement, velocity and force in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Positive {
    /// Extension and tension are positive. This is the internal convention.
    Rebound,
    /// Compression is positive.
    Compression,
}

impl Positive {
    /// Returns the name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Positive::Rebound => "rebound",
            Positive::Compression => "compression",
        }
    }

    /// Returns the opposite direction.
    #[must_use]
    pub fn opposite(self) -> Positive {
        match self {
            Positive::Rebound => Positive::Compression,
            Positive::Compression => Positive::Rebound,
        }
    }
}

impl FromStr for Positive {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim().to_ascii_lowercase().as_str() {
            "rebound" | "extension" | "tension" => Ok(Positive::Rebound),
            "compression" | "bump" | "jounce" => Ok(Positive::Compression),
            _ => Err(format!("'{text}' should be rebound or compression")),
        }
    }
}

/// Options for reading a campaign. By default all information comes from the files.
#[derive(Debug, Clone)]
pub struct Options {
    /// Units given by the user. They take precedence over the header (`--unit force=kN`).
    pub units: BTreeMap<Channel, Unit>,
    /// Column headings given by the user (`--column force="Load Cell 1"`), or numbers of columns from 1.
    pub columns: BTreeMap<Channel, String>,
    /// Channels that are not read, even if the file has a column for them (`--ignore velocity`).
    pub ignore: BTreeSet<Channel>,
    /// Positive direction of the files after the reversals by `flip_force` and `flip_motion` (`--positive`). If `None`,
    /// it is estimated from the data.
    pub positive: Option<Positive>,
    /// Whether the sign of the force is reversed (`--flip force`).
    pub flip_force: bool,
    /// Whether the sign of displacement and velocity is reversed (`--flip motion`).
    pub flip_motion: bool,
    /// Sampling rate of files without a time column, 1/s (`--sample-rate`).
    pub sample_rate_hz: Option<f64>,
    /// Order of day and month in dates such as 3/11/2026 (`--dates`). If `None`, it is determined from the files.
    pub dates: Option<DateOrder>,
    /// Displacement at the first sample, m, in the direction of the file. Used if only a velocity was recorded.
    pub initial_position: f64,
    /// Lag of the recorded force behind the motion, s (`--delay`).
    pub delay_s: f64,
    /// Reading of the force channel at zero force, N, in the file's direction (`--force-zero`).
    pub force_zero_n: f64,
    /// Reading of the displacement channel at the position that shall be zero, times the channel's gain, m, in the
    /// file's direction (`--displacement-zero`).
    pub displacement_zero_m: f64,
    /// Factor on the force, applied after the zero is subtracted (`--gain`).
    pub gain: f64,
    /// Factors on channels other than the force (`--gain displacement=1.02` for a displacement sensor with readings
    /// that are too low).
    pub gains: BTreeMap<Channel, f64>,
    /// Mass between load cell and damper that moves with the damper's end, kg (`--rig-mass`): eye, clamp, joint.
    pub rig_mass_kg: f64,
    /// Rules for the setting of the damper by test names (`campaign.toml`). They have precedence over setting channels
    /// and over settings in the names.
    pub settings: SettingRules,
    /// Files and tests to leave out, by name. `*` matches any text (`--exclude`).
    pub exclude: Vec<String>,
    /// Whether the records in the subfolders of a folder are read as tests of the same campaign (`--subfolders`).
    pub subfolders: bool,
    /// Whether faulty tests and files that are not records are errors, instead of being left out (`--strict`).
    pub strict: bool,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            units: BTreeMap::new(),
            columns: BTreeMap::new(),
            ignore: BTreeSet::new(),
            positive: None,
            flip_force: false,
            flip_motion: false,
            sample_rate_hz: None,
            dates: None,
            initial_position: 0.0,
            delay_s: 0.0,
            force_zero_n: 0.0,
            displacement_zero_m: 0.0,
            gain: 1.0,
            gains: BTreeMap::new(),
            rig_mass_kg: 0.0,
            settings: SettingRules::default(),
            exclude: Vec::new(),
            subfolders: false,
            strict: false,
        }
    }
}

impl Options {
    /// Checks that the numbers are within their limits, and that the rules for settings and the ignored channels are
    /// valid.
    ///
    /// # Errors
    /// A sentence that names the invalid option. A gain of time or temperature is invalid, and so is ignoring time or
    /// force.
    pub fn check(&self) -> Result<(), String> {
        if !(self.delay_s.abs() <= LONGEST_DELAY) {
            return Err(format!(
                "a delay of {} s cannot be; give it in seconds, such as 0.012, of {LONGEST_DELAY} s at most",
                format_number(self.delay_s)
            ));
        }
        if let Some(rate) = self.sample_rate_hz
            && !(SAMPLE_RATES.0..=SAMPLE_RATES.1).contains(&rate)
        {
            return Err(format!(
                "a sample rate of {} cannot be; give samples per second, such as 1000, of {} to {}",
                format_number(rate),
                SAMPLE_RATES.0,
                SAMPLE_RATES.1
            ));
        }
        let gains = std::iter::once((Channel::Force, self.gain)).chain(self.gains.iter().map(|(c, gain)| (*c, *gain)));
        for (channel, gain) in gains {
            if matches!(channel, Channel::Time | Channel::Temperature) {
                return Err(format!("{channel} takes no gain; give its unit where that is wrong"));
            }
            if !(GAINS.0..=GAINS.1).contains(&gain) {
                let of = if channel == Channel::Force { String::new() } else { format!(" of {channel}") };
                return Err(format!(
                    "a gain{of} of {} cannot be; give a factor above 0, of {} to {}, and turn a sign with flip",
                    format_number(gain),
                    GAINS.0,
                    GAINS.1
                ));
            }
        }
        if !(0.0..=LARGEST_MASS).contains(&self.rig_mass_kg) {
            return Err(format!(
                "a rig mass of {} kg on the load cell cannot be; give it in kg, such as 1.2, of 0 to {LARGEST_MASS} kg",
                format_number(self.rig_mass_kg)
            ));
        }
        self.settings.check()?;
        if let Some(channel) = [Channel::Time, Channel::Force].iter().find(|c| self.ignore.contains(c)) {
            return Err(format!("{channel} cannot be left out of records; take it off ignore"));
        }
        let limited = [
            ("force zero", self.force_zero_n, LARGEST_FORCE_ZERO, "N"),
            ("displacement zero", self.displacement_zero_m, LARGEST_POSITION, "m"),
            ("initial position", self.initial_position, LARGEST_POSITION, "m"),
        ];
        match limited.into_iter().find(|(_, value, largest, _)| !(value.abs() <= *largest)) {
            Some((name, value, largest, unit)) => {
                Err(format!("a {name} of {} {unit} cannot be; it is at most {largest} {unit}", format_number(value)))
            }
            None => Ok(()),
        }
    }

    /// Merges these options with the options of a profile. Entries of `self` have precedence. A number that equals its
    /// default counts as not stated. Lists are joined, and a switch is on if it is on in either of the two. `strict` is
    /// that of `self`.
    pub fn over(&self, profile: &Options) -> Options {
        let number = |own: f64, other: f64, nothing: f64| if own == nothing { other } else { own };
        let mut all = self.clone();
        profile.units.iter().for_each(|(c, u)| {
            all.units.entry(*c).or_insert(*u);
        });
        profile.columns.iter().for_each(|(c, h)| {
            all.columns.entry(*c).or_insert_with(|| h.clone());
        });
        all.ignore.extend(&profile.ignore);
        all.exclude.extend(profile.exclude.iter().cloned());
        all.positive = self.positive.or(profile.positive);
        all.flip_force |= profile.flip_force;
        all.flip_motion |= profile.flip_motion;
        all.subfolders |= profile.subfolders;
        all.sample_rate_hz = self.sample_rate_hz.or(profile.sample_rate_hz);
        all.dates = self.dates.or(profile.dates);
        all.initial_position = number(self.initial_position, profile.initial_position, 0.0);
        all.delay_s = number(self.delay_s, profile.delay_s, 0.0);
        all.force_zero_n = number(self.force_zero_n, profile.force_zero_n, 0.0);
        all.displacement_zero_m = number(self.displacement_zero_m, profile.displacement_zero_m, 0.0);
        all.gain = number(self.gain, profile.gain, 1.0);
        profile.gains.iter().for_each(|(channel, gain)| {
            all.gains.entry(*channel).or_insert(*gain);
        });
        all.rig_mass_kg = number(self.rig_mass_kg, profile.rig_mass_kg, 0.0);
        all.settings = self.settings.over(&profile.settings);
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Function that sets one number of the options.
    type Change<'a> = &'a dyn Fn(&mut Options, f64);

    #[test]
    fn numbers_that_cannot_be_are_rejected_where_the_limits_are_stated() {
        let check = |change: Change, value: f64| {
            let mut options = Options::default();
            change(&mut options, value);
            options.check().is_ok()
        };
        let limits: [(Change, f64); 8] = [
            (&|o, v| o.delay_s = v, 1.0),
            (&|o, v| o.sample_rate_hz = Some(v), 1e7),
            (&|o, v| o.gain = v, 1e4),
            (&|o, v| o.force_zero_n = v, 1e6),
            (&|o, v| o.initial_position = v, 10.0),
            (&|o, v| o.rig_mass_kg = v, 100.0),
            (&|o, v| o.displacement_zero_m = v, 10.0),
            (&|o, v| o.gains = [(Channel::Displacement, v)].into(), 1e4),
        ];
        for (change, limit) in limits {
            assert!(check(change, 0.75 * limit) && !check(change, 1.35 * limit), "{limit}");
        }
        let named = ["delay", "sample rate", "gain", "force zero", "initial position", "mass", "displacement zero"];
        for (k, (change, _)) in limits.iter().enumerate() {
            for value in [1e308, -1e308, f64::NAN, f64::INFINITY] {
                let mut options = Options::default();
                change(&mut options, value);
                let message = options.check().unwrap_err();
                let name = named.get(k).copied().unwrap_or("gain of displacement");
                assert!(message.contains(name) && message.contains(&format_number(value)), "{message}");
                assert!(message.len() < 300, "{message}");
            }
        }
        // Delay and zeros may have either sign. A rate, a factor and a mass may not.
        for (k, (change, limit)) in limits.iter().enumerate() {
            assert_eq!(check(*change, -0.75 * limit), [0, 3, 4, 6].contains(&k), "-{limit}");
        }
        assert!(check(limits[5].0, 0.0) && !check(limits[5].0, -1e-308));
        for (change, _) in [limits[1], limits[2], limits[7]] {
            assert!(!check(change, 0.0) && !check(change, 1e-308));
        }
        for (change, limit) in [(limits[1].0, 1e-3), (limits[2].0, 1e-4), (limits[7].0, 1e-4)] {
            assert!(check(change, 1.35 * limit) && !check(change, 0.75 * limit), "{limit}");
        }
    }
}
