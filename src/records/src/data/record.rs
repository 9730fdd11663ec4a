//! One cleaned rig test: the channels in SI, rebound positive, and the known facts about the test.

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

/// Kind of a note about a column that was not read and may contain the current or the command of a valve.
pub(crate) const UNREAD_CURRENT: Kind = "unread_current";

/// One test of a campaign after reading and cleaning.
///
/// All channels have the same length and SI units. Extension (rebound) velocity and tension force are positive.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Record {
    /// Name of the test: the file stem, or the value of the test column.
    pub name: String,
    /// Source of the test: path, and sheet or test column value.
    pub source: String,
    /// Time, s, strictly increasing.
    #[serde(skip)]
    pub time: Vec<f64>,
    /// Date and time of the record's time zero, s since 1970 by the rig's own clock, if the file states it. A value
    /// below one day is a time of an unknown day.
    #[serde(default)]
    pub begins: Option<f64>,
    /// Part, serial number, tester and rig, if the file states them.
    #[serde(default, skip_serializing_if = "TestMetadata::is_empty")]
    pub about: TestMetadata,
    /// Setting of the damper, if a rule of the user, a channel, or the name of the test states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub setting: Option<Setting>,
    /// Signal of a setting that changes within the test, if a channel records it. [`Record::setting`] is then `None`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub setting_signal: Option<SettingSignal>,
    /// The campaign's clock at the record's time zero, s. The value is 0 if each record has its own clock, or if all
    /// records already have the same clock.
    #[serde(default)]
    pub clock_s: f64,
    /// Damper displacement, m.
    #[serde(skip)]
    pub displacement: Vec<f64>,
    /// Damper velocity, m/s.
    #[serde(skip)]
    pub velocity: Vec<f64>,
    /// Length of the window for deriving the velocity from the displacement, s; 0 if the recorded velocity is used.
    #[serde(skip)]
    pub velocity_window_s: f64,
    /// Damper force, N.
    #[serde(skip)]
    pub force: Vec<f64>,
    /// Side force, N, if the rig measured it.
    #[serde(skip)]
    pub side_force: Option<Vec<f64>>,
    /// Damper temperature, °C, if the rig measured it.
    #[serde(skip)]
    pub temperature: Option<Vec<f64>>,
    /// Sample ranges of the whole cycles (between upward zero crossings of the displacement about its mean). Empty if
    /// the motion is not periodic.
    pub cycles: Vec<std::ops::Range<usize>>,
    /// Displacement amplitude, m (half the peak-to-peak of a typical cycle).
    pub amplitude: f64,
    /// Frequency of the cycles, Hz; 0 if the motion is not periodic.
    pub frequency: f64,
    /// Peak velocity, m/s (a robust maximum of |velocity|, not a single noisy sample).
    pub peak_velocity: f64,
    /// Mean displacement, m.
    pub mean_displacement: f64,
    /// Noise of the force channel.
    pub noise: Noise,
    /// Actions and findings of cleaning and derivation, in chronological order.
    pub notes: Vec<Note>,
    /// Fingerprint of the record before corrections, if a correction was applied after reading.
    #[serde(skip)]
    pub original_fingerprint: Option<String>,
    /// Measurement error that the user states, a delay and a mass. The record is corrected for it.
    #[serde(skip)]
    pub stated_error: MeasurementError,
    /// Delay of the force channel estimated from the campaign, s; 0 if not significant.
    #[serde(skip)]
    pub apparent_delay_s: f64,
    /// Positive direction that was used for reading the file. `None` for a record that was not read from a file.
    #[serde(skip)]
    pub counted: Option<Counted>,
    /// Sign convention, zero, unit and range of the rig.
    #[serde(skip)]
    pub frame: RigFrame,
}

/// Positive direction that was used for reading a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counted {
    /// Positive direction of force and motion in the file.
    pub positive: Positive,
    /// Whether the user stated the direction. Otherwise it was estimated.
    pub is_stated: bool,
}

impl Record {
    /// Returns start and end of the measurement on the campaign's clock, s. Returns `None` without samples.
    pub fn span(&self) -> Option<(f64, f64)> {
        Some((self.time.first()? + self.clock_s, self.time.last()? + self.clock_s))
    }

    /// Returns a hash of the content before corrections. Equal hashes mean the same measurement, even if the file names
    /// differ.
    pub fn fingerprint(&self) -> String {
        if let Some(as_read) = &self.original_fingerprint {
            return as_read.clone();
        }
        // FNV-1a over the bits of time and force. The campaign's clock is excluded, because it depends on the other
        // records.
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
    /// Autocorrelation of the noise from one sample to the next, −1..1.
    pub lag1: f64,
    /// Method of the estimate.
    pub from: NoiseSource,
}

/// Basis of a noise estimate.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum NoiseSource {
    /// Differences between repeated cycles at equal phase.
    CycleRepeat,
    /// High-pass differences of neighboring samples, used if there are too few cycles.
    SampleDifferences,
    /// The record is too short for both methods.
    #[default]
    Unknown,
}

/// A kind of finding. The alias prevents serde from borrowing the text from its input.
pub type Kind = &'static str;

/// An action or finding of cleaning or derivation on a record.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Note {
    /// Kind of finding, one word in snake case (`trimmed`, `clipped`, `frozen`, `duplicated`, `out_of_order`,
    /// `outlier`, `drift`, `derived`, `converted`, ...).
    #[serde(deserialize_with = "known_kind")]
    pub kind: Kind,
    /// Text for readers, with figures.
    pub text: Sentence,
}

impl Note {
    /// Kinds of notes that are warnings.
    pub const LOUD: [&'static str; 6] =
        ["sign_unsure", "settings", "setting_name", "changing_setting", "cut_off", "label"];

    /// Returns whether the note is a warning: a result may be wrong unless the user reacts.
    pub fn is_loud(&self) -> bool {
        Note::LOUD.contains(&self.kind)
    }

    /// Returns whether the note reports damage to a record or an assumption, instead of a routine step.
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
            "empty_setting",
            "setting_start",
            "small_current",
            UNREAD_CURRENT,
        ]
        .contains(&self.kind)
    }
}

/// Reads a kind as a static text. Each of the few dozen different kinds is stored only once.
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
