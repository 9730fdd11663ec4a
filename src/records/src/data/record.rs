//! One cleaned rig test: the channels in SI, rebound positive, and what is known about them.

use super::measurement_error::MeasurementError;
use super::rig_frame::RigFrame;
use super::setting_signal::SettingSignal;
use super::test_metadata::TestMetadata;
use crate::options::Positive;
use crate::quantities::setting_value::Setting;
use dashpot_messages::Sentence;
use serde::{Deserialize, Deserializer, Serialize};
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// One test of a campaign after reading and cleaning.
///
/// All channels have the same length. SI units, extension (rebound) velocity positive, tension force positive.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Record {
    /// Name of the test: the file stem, or the value of the test column.
    pub name: String,
    /// Where it was read from: path, and sheet or test column value.
    pub source: String,
    /// Time, s, strictly increasing.
    #[serde(skip)]
    pub time: Vec<f64>,
    /// Date and time of the record's time zero, s since 1970 by the rig's own clock; below a day, of an unknown day. Where the file bears it.
    #[serde(default)]
    pub begins: Option<f64>,
    /// Part, serial number, tester and rig, where the file says them.
    #[serde(default, skip_serializing_if = "TestMetadata::is_empty")]
    pub about: TestMetadata,
    /// What the damper was set to, where a channel or the name of the test says it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub setting: Option<Setting>,
    /// The setting over time, where a channel shows it to change within the test; then it has no [`Record::setting`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub setting_signal: Option<SettingSignal>,
    /// The campaign's clock at the record's time zero, s: 0 where each record has a clock of its own or all run on one already.
    #[serde(default)]
    pub clock_s: f64,
    /// Damper displacement, m.
    #[serde(skip)]
    pub displacement: Vec<f64>,
    /// Damper velocity, m/s.
    #[serde(skip)]
    pub velocity: Vec<f64>,
    /// Length of the window in which the velocity was taken from the displacement, s; 0 where the file has a velocity.
    #[serde(skip)]
    pub velocity_window_s: f64,
    /// Damper force, N.
    #[serde(skip)]
    pub force: Vec<f64>,
    /// Side force, N, where the rig measured it.
    #[serde(skip)]
    pub side_force: Option<Vec<f64>>,
    /// Damper temperature, °C, where the rig measured it.
    #[serde(skip)]
    pub temperature: Option<Vec<f64>>,
    /// Sample ranges of the whole cycles (between upward zero crossings of the displacement about its
    /// mean); empty where the motion is not periodic.
    pub cycles: Vec<std::ops::Range<usize>>,
    /// Displacement amplitude, m (half the peak-to-peak of a typical cycle).
    pub amplitude: f64,
    /// Frequency of the cycles, Hz; 0 where the motion is not periodic.
    pub frequency: f64,
    /// Peak velocity, m/s (a robust maximum of |velocity|, not a single noisy sample).
    pub peak_velocity: f64,
    /// Mean displacement, m.
    pub mean_displacement: f64,
    /// Noise of the force channel.
    pub noise: Noise,
    /// What cleaning and derivation did or noticed, in the order it happened.
    pub notes: Vec<Note>,
    /// The fingerprint that it had when it was read, where something was taken out of it since.
    #[serde(skip)]
    pub original_fingerprint: Option<String>,
    /// What the user said the measurement to be off by, and what was taken out of it therefore: a delay and a mass.
    #[serde(skip)]
    pub stated_error: MeasurementError,
    /// Delay of its force channel by a first look at its campaign, s; 0 where none stood out.
    #[serde(skip)]
    pub apparent_delay_s: f64,
    /// How its file was read to count; `None` of a record that was in no file.
    #[serde(skip)]
    pub counted: Option<Counted>,
    /// How its rig counts its own position, and how far the campaign has gone.
    #[serde(skip)]
    pub frame: RigFrame,
}

/// Which direction a file was read to count positive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counted {
    /// The direction.
    pub positive: Positive,
    /// Whether the user said so; else it was worked out.
    pub is_stated: bool,
}

impl Record {
    /// From when to when it was measured, by the campaign's clock, s; nothing of a record without samples.
    pub fn span(&self) -> Option<(f64, f64)> {
        Some((self.time.first()? + self.clock_s, self.time.last()? + self.clock_s))
    }

    /// A short name for the content: tells whether two records hold the same measurement, whatever their file is called.
    pub fn fingerprint(&self) -> String {
        if let Some(as_read) = &self.original_fingerprint {
            return as_read.clone();
        }
        // Not of the campaign's clock, which depends on the other records. FNV-1a over the bits of time and force.
        let hash = self.time.iter().chain(&self.force).fold(0xcbf2_9ce4_8422_2325u64, |hash, value| {
            value.to_bits().to_le_bytes().iter().fold(hash, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x100_0000_01b3))
        });
        format!("{hash:016x}")
    }
}

/// Noise floor of the force of one test.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub struct Noise {
    /// Root mean square of the force noise of one sample, N.
    pub force_rms: f64,
    /// Autocorrelation of that noise from one sample to the next, −1..1.
    pub lag1: f64,
    /// How it was estimated.
    pub from: NoiseSource,
}

/// What a noise figure rests on.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum NoiseSource {
    /// Differences between repeated cycles at equal phase.
    CycleRepeat,
    /// Too few cycles: high-pass differences of neighbouring samples.
    SampleDifferences,
    /// The record is too short for either.
    #[default]
    Unknown,
}

/// A kind of finding. As a name of its own, for serde takes a reference for something borrowed from what is read.
pub type Kind = &'static str;

/// One thing that cleaning or derivation did to a record, or noticed in it.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Note {
    /// Kind of finding, one word in snake case (`trimmed`, `clipped`, `frozen`, `duplicated`, `out_of_order`,
    /// `outlier`, `drift`, `derived`, `converted`, ...).
    #[serde(deserialize_with = "known_kind")]
    pub kind: Kind,
    /// What a person reads, with figures.
    pub text: Sentence,
}

impl Note {
    /// Whether it is a warning: a result may be wrong where nobody acts on it.
    pub fn is_loud(&self) -> bool {
        ["sign_unsure", "settings", "setting_name", "changing_setting", "cut_off"].contains(&self.kind)
    }

    /// Whether it tells of damage to a record or of what was only guessed of it, and not of routine.
    pub fn is_of_damage(&self) -> bool {
        [
            "clipped",
            "rounded",
            "guessed",
            "duplicated",
            "missing",
            "out_of_order",
            "outlier",
            "time_resolution",
            "noisy_last_cycle",
        ]
        .contains(&self.kind)
    }
}

/// A kind read back, as a word that lasts: there are some dozens of kinds, each of which is kept once.
fn known_kind<'de, D: Deserializer<'de>>(from: D) -> Result<Kind, D::Error> {
    static KINDS: Mutex<BTreeSet<Kind>> = Mutex::new(BTreeSet::new());
    let kind = String::deserialize(from)?;
    let mut kinds = KINDS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = kinds.get(&*kind) {
        return Ok(known);
    }
    let kind: Kind = Box::leak(kind.into_boxed_str());
    kinds.insert(kind);
    Ok(kind)
}
