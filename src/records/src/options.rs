//! What the user may say about his records.

use std::collections::{BTreeMap, BTreeSet};
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::channel::Channel;
use super::date_order::DateOrder;
use super::unit::Unit;

/// The direction in which displacement, velocity and force of a file are counted positive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Positive {
    /// Extension and tension positive, the convention inside.
    Rebound,
    /// Compression positive.
    Compression,
}

impl Positive {
    /// The name as the command line writes it.
    pub fn name(self) -> &'static str {
        match self {
            Positive::Rebound => "rebound",
            Positive::Compression => "compression",
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

/// How to read a campaign; the default leaves everything to the files.
#[derive(Debug, Clone)]
pub struct Options {
    /// Units given by the user; they win over the header (`--unit force=kN`).
    pub units: BTreeMap<Channel, Unit>,
    /// Column headings given by the user (`--column force="Load Cell 1"`), or numbers of columns from 1.
    pub columns: BTreeMap<Channel, String>,
    /// Channels not to be read even if there is a column for them (`--ignore velocity`).
    pub ignore: BTreeSet<Channel>,
    /// Direction counted positive in the files, after the flips below; worked out from the data if not given.
    pub positive: Option<Positive>,
    /// Turn the sign of the force (`--flip force`).
    pub flip_force: bool,
    /// Turn the sign of displacement and velocity (`--flip motion`).
    pub flip_motion: bool,
    /// Samples per second of files that have no column of time, 1/s (`--sample-rate`).
    pub sample_rate_hz: Option<f64>,
    /// Which of day and month comes first in dates such as 3/11/2026; worked out from the files if not given (`--dates`).
    pub dates: Option<DateOrder>,
    /// Displacement at the first sample, m, in the file's direction. Used where only a velocity was recorded.
    pub initial_position: f64,
    /// How much later than the motion the force was recorded, s (`--delay`).
    pub delay_s: f64,
    /// What the force channel shows without force, N, in the file's direction (`--force-zero`).
    pub force_zero_n: f64,
    /// What the displacement channel shows where displacement is to be zero, m, in the file's direction
    /// (`--displacement-zero`).
    pub displacement_zero_m: f64,
    /// Factor on the force, after its zero was taken off (`--gain`).
    pub gain: f64,
    /// Mass between load cell and damper that moves with the damper's end, kg (`--rig-mass`): eye, clamp, joint.
    pub rig_mass_kg: f64,
    /// Files and tests to leave out, by name; `*` stands for anything (`--exclude`).
    pub exclude: Vec<String>,
    /// Read the records in the subfolders of a folder as tests of the same campaign (`--subfolders`).
    pub subfolders: bool,
    /// Refuse files that are no records and tests that have a fault of their own, instead of leaving them out (`--strict`).
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
            rig_mass_kg: 0.0,
            exclude: Vec::new(),
            subfolders: false,
            strict: false,
        }
    }
}

/// Longest delay taken for one, s.
const LONGEST_DELAY: f64 = 1.0;
/// Largest mass taken for one that hangs on a load cell, kg: a heavy truck's damper with its clamps has less. A larger number was meant in
/// grams. Below zero it gives back what a rig's own compensation took too much.
const LARGEST_MASS: f64 = 100.0;

impl Options {
    /// Makes sure that the numbers can be.
    ///
    /// # Errors
    /// A sentence that names the number.
    pub fn check(&self) -> Result<(), String> {
        if !(self.delay_s.abs() <= LONGEST_DELAY) {
            return Err(format!("a delay of {} s cannot be; give it in seconds, such as 0.012", self.delay_s));
        }
        if let Some(rate) = self.sample_rate_hz
            && !(rate > 0.0 && rate.is_finite())
        {
            return Err(format!("a sample rate of {rate} cannot be; give samples per second, such as 1000"));
        }
        if !(self.gain > 0.0 && self.gain.is_finite()) {
            return Err(format!("a gain of {} cannot be; give a factor above 0, and turn a sign with flip", self.gain));
        }
        if !(self.rig_mass_kg.abs() <= LARGEST_MASS) {
            return Err(format!(
                "a mass of {} kg on the load cell cannot be; give it in kg, such as 1.2",
                self.rig_mass_kg
            ));
        }
        if let Some(channel) = [Channel::Time, Channel::Force].iter().find(|c| self.ignore.contains(c)) {
            return Err(format!("{channel} cannot be left out of records; take it off ignore"));
        }
        let zeros = [("force", self.force_zero_n), ("displacement", self.displacement_zero_m)];
        match zeros.into_iter().find(|(_, zero)| !zero.is_finite()) {
            Some((name, zero)) => Err(format!("a {name} zero of {zero} is no number")),
            None => Ok(()),
        }
    }

    /// These options, and where they say nothing, those of a profile.
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
        all.rig_mass_kg = number(self.rig_mass_kg, profile.rig_mass_kg, 0.0);
        all
    }
}
