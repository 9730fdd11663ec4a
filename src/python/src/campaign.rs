//! Rig records as Python sees them.

use crate::errors::{RecordError, raise, say};
use crate::progress::Progress;
use dashpot_records::{Options, Profile, Record, load};
use numpy::PyArray1;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;

/// Records of a campaign, cleaned, in SI, extension and tension positive.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Campaign {
    /// The records.
    pub read: dashpot_records::Campaign,
}

impl Campaign {
    /// The records by reference, as fits and diagnoses take them.
    pub fn records(&self) -> Vec<&Record> {
        self.read.records.iter().collect()
    }
}

/// How to read records, from the JSON of a profile (the entries of `campaign.toml`).
fn options(mapping: &str, strict: bool) -> PyResult<Options> {
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
        let progress = Progress::new(progress);
        let read =
            py.detach(|| load(&paths, &options, &|p| progress.say(p.done as f64 / p.total.max(1) as f64, "reading")));
        progress.end()?;
        Ok(Campaign { read: read.map_err(raise::<RecordError>)? })
    }

    /// What was found, without the channels, as JSON.
    fn json(&self) -> PyResult<String> {
        serde_json::to_string(&self.read).map_err(raise::<RecordError>)
    }

    /// Number of tests.
    fn __len__(&self) -> usize {
        self.read.records.len()
    }

    /// Channels of one test as arrays, by name.
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
        for (name, values) in always.into_iter().chain(measured) {
            channels.set_item(name, PyArray1::from_slice(py, values))?;
        }
        Ok(channels)
    }

    /// A short name for the content of one test.
    fn fingerprint(&self, index: usize) -> PyResult<String> {
        self.read.records.get(index).map(Record::fingerprint).ok_or_else(|| PyIndexError::new_err("no such test"))
    }
}
