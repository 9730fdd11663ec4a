//! Tables of a model file after the lines that the kernel reads: the results of the fit.

use crate::Measured;
use dashpot_core::{Params, element, list, number};
use dashpot_messages::Kept;
use dashpot_records::{Record, clock, restrict};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::BTreeMap;

/// Tables of a model file after the lines that the kernel reads.
#[derive(Debug, Clone, Default, Deserialize, Serialize)]
pub struct Identification {
    /// Names of the tests that the fit used. [`Identification::used`] decides by these names if there are no fingerprints.
    #[serde(default)]
    pub tests: Vec<String>,
    /// Fingerprints of the contents of the tests that the fit used.
    #[serde(default)]
    pub fingerprints: Vec<String>,
    /// Parameters that the data does not determine.
    #[serde(default)]
    pub not_identified: Vec<String>,
    /// Remarks of the fit.
    #[serde(default)]
    pub notes: Vec<String>,
    /// Messages of the remarks and sources, so that reports can show them in other languages.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub messages: Vec<Kept>,
    /// Instant from which the drifts of the force channel's gain and zero count, s since 1970 by the rig's own clock.
    #[serde(
        default,
        deserialize_with = "known_time",
        serialize_with = "written_time",
        skip_serializing_if = "Option::is_none"
    )]
    pub clock_from: Option<f64>,
    /// Measurement errors that the fit found in its records, in SI units: value, and lower and upper end of the 95 % interval. They do not
    /// belong to the damper.
    #[serde(default, deserialize_with = "known_numbers", skip_serializing_if = "BTreeMap::is_empty")]
    pub measurement: BTreeMap<String, [f64; 3]>,
    /// 95 % intervals by parameter. Curves have one pair for each point. A point that was changed since the fit has NaN ends after reading.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub intervals: BTreeMap<String, Interval>,
    /// 95 % intervals of the parameters that depend on the setting, with one entry for each value of the setting.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub intervals_over_setting: BTreeMap<String, IntervalOverSetting>,
    /// Kinds of tests from which each parameter was identified.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: BTreeMap<String, String>,
    /// Plain FV curve fitted to the tests that the fit used.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fv_only: Option<FvOnly>,
    /// Plain FV curves fitted to the tests of each setting.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fv_only_over_setting: Vec<FvOnlyAt>,
}

fn written_time<S: Serializer>(time: &Option<f64>, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&time.map_or_else(String::new, clock::written))
}

fn known_time<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    let text = String::deserialize(from)?;
    let refusal =
        || format!("[identification] clock_from = \"{text}\" is no date and time, such as 2026-11-25 10:03:22");
    clock::seconds(&text).map(Some).ok_or_else(|| serde::de::Error::custom(refusal()))
}

/// Reads the measurement errors. Rejects names that no fit uses, because an unknown error could not be corrected in any record.
fn known_numbers<'de, D: Deserializer<'de>>(from: D) -> Result<BTreeMap<String, [f64; 3]>, D::Error> {
    let numbers = BTreeMap::<String, [f64; 3]>::deserialize(from)?;
    match numbers.iter().find(|(name, numbers)| Measured::named(name, **numbers).is_none()) {
        Some((name, numbers)) => Err(serde::de::Error::custom(format!(
            "[identification.measurement] {name} = {numbers:?} is nothing that a fit finds: it is delay, rig_mass, gain_drift or drift, with \
             value, low and high end; a mass is 0 or more"
        ))),
        None => Ok(numbers),
    }
}

/// 95 % interval of a number, or 95 % intervals of the points of a curve.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(untagged, expecting = "an interval is [low, high], that of a list has one such pair for each entry")]
pub enum Interval {
    /// Interval of one number: low, high.
    Number([f64; 2]),
    /// Interval of a list: low and high of each entry.
    List(Vec<[f64; 2]>),
}

/// 95 % intervals over the values of a setting.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(
    untagged,
    expecting = "an interval over the setting is one [low, high] for each of its values, that of a list one pair for each entry"
)]
pub enum IntervalOverSetting {
    /// Interval of a number: low and high at each value of the setting.
    Number(Vec<[f64; 2]>),
    /// Interval of a list: low and high of each entry at each value of the setting.
    List(Vec<Vec<[f64; 2]>>),
}

/// Plain FV curve that was fitted to the tests at one setting.
#[derive(Debug, Clone, Deserialize, Serialize)]
pub struct FvOnlyAt {
    /// Value of the setting.
    pub setting: f64,
    /// Plain FV curve at the setting.
    #[serde(flatten)]
    pub curve: FvOnly,
}

/// Plain FV curve with a constant gas force.
#[derive(Debug, Clone, Deserialize, Serialize)]
pub struct FvOnly {
    /// Velocities, m/s.
    pub velocity: Vec<f64>,
    /// Forces without the gas force, N.
    pub force: Vec<f64>,
    /// Gas force, N.
    pub gas_force: f64,
}

impl Identification {
    /// Returns whether a fit made the results. The numbers of a file without them are not identified.
    pub fn is_of_a_fit(&self) -> bool {
        let has_no_interval = self.intervals.is_empty() && self.intervals_over_setting.is_empty();
        !(has_no_interval && self.not_identified.is_empty() && self.tests.is_empty())
    }

    /// Returns whether the fit used this record. The fingerprints of the measurements must agree. Names decide only for a file without
    /// fingerprints.
    pub fn used(&self, record: &Record) -> bool {
        if self.fingerprints.is_empty() {
            return self.tests.contains(&record.name);
        }
        self.fingerprints.contains(&record.fingerprint())
    }
}

impl FvOnly {
    /// Returns the FV curve and the gas force of a parameter set.
    pub fn from_params(params: &Params) -> FvOnly {
        FvOnly {
            velocity: params.list(list!("fv_velocity")).to_vec(),
            force: params.list(list!("fv_force")).to_vec(),
            gas_force: params.number(number!("gas_force")),
        }
    }

    /// Returns the force at a velocity, N, without the gas force, by linear interpolation and extrapolation. Returns `None` for fewer than
    /// two points.
    fn at(&self, velocity: f64) -> Option<f64> {
        let right =
            restrict(self.velocity.partition_point(|known| *known < velocity), 1, self.velocity.len().max(2) - 1);
        let ends = |values: &[f64]| Some((*values.get(right - 1)?, *values.get(right)?));
        let ((from, to), (low, high)) = (ends(&self.velocity)?, ends(&self.force)?);
        Some(low + (velocity - from) / (to - from) * (high - low))
    }

    /// Interpolates between this curve and another at the fraction `part` of the distance to the other curve. The points lie at the
    /// velocities of the nearer curve. Returns `None` if one of the curves has fewer than two points.
    pub(crate) fn between(&self, other: &FvOnly, part: f64) -> Option<FvOnly> {
        let mix = |from: f64, to: f64| from + part * (to - from);
        let velocity = if part < 0.5 { &self.velocity } else { &other.velocity };
        let force = velocity.iter().map(|velocity| Some(mix(self.at(*velocity)?, other.at(*velocity)?)));
        let force = force.collect::<Option<Vec<f64>>>()?;
        Some(FvOnly { velocity: velocity.clone(), force, gas_force: mix(self.gas_force, other.gas_force) })
    }

    /// Formats the lines of this curve in a model file, after the heading of a table.
    pub(crate) fn lines(&self) -> String {
        let floats = |v: &[f64]| v.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", ");
        format!(
            "velocity = [{}]\nforce = [{}]\ngas_force = {:?}\n",
            floats(&self.velocity),
            floats(&self.force),
            self.gas_force
        )
    }

    /// Converts the curve to a parameter set.
    ///
    /// # Errors
    /// The parameter table rejects a value.
    pub fn params(&self) -> Result<Params, String> {
        let mut p = Params::new();
        p.disable_all();
        let set = |r: Result<(), dashpot_core::Fault>| r.map_err(|f| f.reason.text().to_owned());
        p.enable(element!("fv_curve"), true);
        p.enable(element!("gas_preload"), true);
        set(p.set_list(list!("fv_velocity"), &self.velocity))?;
        set(p.set_list(list!("fv_force"), &self.force))?;
        set(p.set(number!("gas_force"), self.gas_force))?;
        Ok(p)
    }
}
