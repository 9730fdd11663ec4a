//! Rig records as Python objects.

use crate::errors::{RecordError, raise, say};
use crate::work;
use dashpot_messages::{Kept, Restorer, Sentence};
use dashpot_records::{Options, Profile, Record, load};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::LazyLock;

/// Cleaned records of a campaign in SI units, as a Python object. Extension and tension are positive.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Campaign {
    /// Records with the findings of the reader.
    pub read: dashpot_records::Campaign,
}

impl Campaign {
    /// Returns references to the records, for fits and diagnoses.
    pub fn records(&self) -> Vec<&Record> {
        self.read.records.iter().collect()
    }

    /// Returns the findings about the whole campaign, without its records.
    pub fn about(&self) -> dashpot_records::Campaign {
        let read = &self.read;
        dashpot_records::Campaign {
            records: Vec::new(),
            sign: read.sign.clone(),
            delay: read.delay,
            notes: read.notes.clone(),
            files: read.files.clone(),
            unusable: read.unusable.clone(),
        }
    }
}

/// Data from which a campaign is restored: JSON, channels of each test, fingerprint of each test, and paths of the files.
type State<'py> = (String, Vec<Bound<'py, PyDict>>, Vec<Option<String>>, Vec<PathBuf>);

/// Restores the sentences of a campaign from their messages. The sentences come from the reader of records, and from the fit, which
/// corrects records.
static KEPT: LazyLock<Restorer> =
    LazyLock::new(|| Restorer::new([dashpot_records::templates(), dashpot_identification::templates()].concat()));

/// JSON from which a campaign is restored. It includes the messages of the sentences, because the JSON of the campaign has the sentences in
/// English only.
#[derive(Serialize)]
struct Whole<'a> {
    #[serde(flatten)]
    read: &'a dashpot_records::Campaign,
    messages: Vec<Kept>,
}

/// Messages in the JSON of a stored campaign. Campaigns that an earlier version stored have none.
#[derive(Deserialize)]
struct Messages {
    #[serde(default)]
    messages: Vec<Kept>,
}

/// Returns the sentences of a campaign, in any order.
fn sentences(read: &dashpot_records::Campaign) -> impl Iterator<Item = &Sentence> {
    let notes = read.records.iter().flat_map(|record| &record.notes).chain(&read.notes);
    notes.map(|note| &note.text).chain(read.unusable.iter().map(|one| &one.why)).chain(&read.sign.reasons)
}

/// Returns mutable references to the sentences of a campaign.
fn sentences_mut(read: &mut dashpot_records::Campaign) -> impl Iterator<Item = &mut Sentence> {
    let notes = read.records.iter_mut().flat_map(|record| &mut record.notes).chain(&mut read.notes);
    let unusable = read.unusable.iter_mut().map(|one| &mut one.why);
    notes.map(|note| &mut note.text).chain(unusable).chain(&mut read.sign.reasons)
}

/// Makes the options of the reader from the JSON of a profile (the entries of `campaign.toml`).
pub fn options(mapping: &str, strict: bool) -> PyResult<Options> {
    let profile: Profile = serde_json::from_str(mapping).map_err(raise::<RecordError>)?;
    Ok(Options { strict, ..profile.options().map_err(say::<RecordError>)? })
}

#[pymethods]
impl Campaign {
    /// Reads and cleans files and folders as one campaign.
    #[staticmethod]
    #[pyo3(signature = (paths, mapping, strict, progress=None))]
    fn read(
        py: Python<'_>,
        paths: Vec<PathBuf>,
        mapping: &str,
        strict: bool,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Campaign> {
        let options = options(mapping, strict)?;
        let read = work::run(py, progress, |progress| {
            load(&paths, &options, &|p| progress.say(p.done as f64 / p.total.max(1) as f64, "reading"))
        })?;
        Ok(Campaign { read: read.map_err(raise::<RecordError>)? })
    }

    /// Returns the findings as JSON, without the channels.
    fn json(&self) -> PyResult<String> {
        serde_json::to_string(&self.read).map_err(raise::<RecordError>)
    }

    /// Returns the number of tests.
    fn __len__(&self) -> usize {
        self.read.records.len()
    }

    /// Returns the channels of one test as arrays with their names.
    fn channels<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyDict>> {
        let record = self.read.records.get(index).ok_or_else(|| PyIndexError::new_err("no such test"))?;
        let channels = PyDict::new(py);
        let always = [
            ("time", &record.time),
            ("displacement", &record.displacement),
            ("velocity", &record.velocity),
            ("force", &record.force),
        ];
        let measured = [("side_force", &record.side_force), ("temperature", &record.temperature)];
        let measured = measured.into_iter().filter_map(|(name, c)| c.as_ref().map(|c| (name, c)));
        let measured = measured.chain(record.setting_signal.as_ref().map(|signal| ("setting", &signal.values)));
        for (name, values) in always.into_iter().chain(measured) {
            channels.set_item(name, PyArray1::from_slice(py, values))?;
        }
        Ok(channels)
    }

    /// Returns all data that [restore](Campaign::again) this campaign, or one of its tests if `only` is given.
    ///
    /// These data are the findings as JSON, the channels of every test, the original fingerprints of the tests, and the paths of the files.
    #[pyo3(signature = (only=None))]
    fn state<'py>(&self, py: Python<'py>, only: Option<usize>) -> PyResult<State<'py>> {
        let one = only.map(|index| {
            let records = self.read.records.get(index).cloned().into_iter().collect();
            dashpot_records::Campaign { records, ..self.read.clone() }
        });
        let read = one.as_ref().unwrap_or(&self.read);
        let of = Campaign { read: read.clone() };
        let channels = (0..read.records.len()).map(|k| of.channels(py, k)).collect::<PyResult<_>>()?;
        let as_read = read.records.iter().map(|r| r.original_fingerprint.clone()).collect();
        let messages = sentences(read).map(Kept::from).collect();
        let json = serde_json::to_string(&Whole { read, messages }).map_err(raise::<RecordError>)?;
        Ok((json, channels, as_read, read.files.clone()))
    }

    /// Restores a campaign from its [state](Campaign::state).
    #[staticmethod]
    fn again(
        json: &str,
        channels: Vec<HashMap<String, PyReadonlyArray1<'_, f64>>>,
        as_read: Vec<Option<String>>,
        files: Vec<PathBuf>,
    ) -> PyResult<Campaign> {
        let mut read: dashpot_records::Campaign = serde_json::from_str(json).map_err(raise::<RecordError>)?;
        if channels.len() != read.records.len() || as_read.len() != read.records.len() {
            return Err(say::<RecordError>("a kept campaign whose channels are not those of its tests"));
        }
        for ((record, channels), as_read) in read.records.iter_mut().zip(&channels).zip(as_read) {
            let channel = |name: &str| channels.get(name).map(|values| values.as_array().to_vec());
            let always = |name: &str| {
                channel(name).ok_or_else(|| say::<RecordError>(format!("a kept campaign without the channel {name}")))
            };
            record.time = always("time")?;
            record.displacement = always("displacement")?;
            record.velocity = always("velocity")?;
            record.force = always("force")?;
            (record.side_force, record.temperature) = (channel("side_force"), channel("temperature"));
            if let Some(signal) = &mut record.setting_signal {
                signal.values = always("setting")?;
            }
            record.original_fingerprint = as_read;
            record.counted = Some(read.sign.counted());
        }
        let Messages { messages } = serde_json::from_str(json).map_err(raise::<RecordError>)?;
        let kept = KEPT.by_english(&messages);
        for sentence in sentences_mut(&mut read) {
            if let Some(whole) = kept.get(&sentence.to_string()) {
                *sentence = whole.clone();
            }
        }
        read.files = files;
        Ok(Campaign { read })
    }

    /// Returns a short identifier of the content of one test.
    fn fingerprint(&self, index: usize) -> PyResult<String> {
        self.read.records.get(index).map(Record::fingerprint).ok_or_else(|| PyIndexError::new_err("no such test"))
    }
}
