//! Diagnosis of groups of records: of many dampers, or of one damper at many settings. Each group is compared with a reference.

use crate::campaign::{Campaign, options};
use crate::errors::{DiagnosisError, RecordError, raise};
use crate::examine::arrays;
use crate::model::Model;
use crate::work;
use dashpot_diagnosis::Options;
use dashpot_diagnosis::groups::{Comparison, Good, GroupResults};
use dashpot_records::groups::{GroupError, split};
use dashpot_records::load;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;

/// Records as paths, and as a campaign if they were already read. In that case, the paths are those of the campaign, or empty for a part of
/// a campaign.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Data {
    paths: Vec<PathBuf>,
    read: Option<Py<Campaign>>,
}

impl Data {
    /// Returns the records of these paths. Reads them if necessary.
    fn of(
        &self,
        paths: &[PathBuf],
        read: impl Fn(&[PathBuf]) -> Result<dashpot_records::Campaign, dashpot_records::RecordError>,
    ) -> Result<dashpot_records::Campaign, dashpot_records::RecordError> {
        match &self.read {
            Some(campaign) if paths == self.paths => Ok(campaign.get().read.clone()),
            _ => read(paths),
        }
    }
}

/// Data with the rule that splits them into groups, and the reference of the groups. Without a reference, the first group is the reference.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Grouping {
    data: Data,
    by: String,
    reference: Option<Data>,
    /// Name of the reference.
    reference_name: String,
    /// Whether each group is compared with the preceding group instead of the reference.
    chain: bool,
    /// Entries of a `campaign.toml` as JSON. They are the options for reading the files.
    mapping: String,
    strict: bool,
}

/// Diagnoses of groups with all data that reports need. They cannot be stored, so only the process that made them can write reports.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Grouped {
    /// Results of the diagnoses.
    pub results: GroupResults,
    /// Diagnosed model.
    pub model: Py<Model>,
    /// Paths of all files that were read in addition to the model.
    pub files: Vec<PathBuf>,
}

/// Error that ends the work: records cannot be read, or a group cannot be diagnosed.
enum Refusal {
    Reading(anyhow::Error),
    Diagnosing(anyhow::Error),
}

impl From<GroupError> for Refusal {
    fn from(error: GroupError) -> Refusal {
        match error {
            GroupError::Read(why) => Refusal::Reading(why.into()),
            other => Refusal::Diagnosing(other.into()),
        }
    }
}

/// Mean cycles of every test of a group.
type Cycles<'py> = Vec<Bound<'py, PyDict>>;

/// Diagnoses groups of records. Each group is compared with the reference, or with the preceding group if `chain` is set in `grouping`.
///
/// Returns the output of `dashpot diagnose --group --json`, and the notes on whole campaigns as JSON. Also returns the mean cycles of every
/// group, and the data for reports.
#[pyfunction]
#[pyo3(signature = (model, grouping, max_effects=3, candidates=None, seed=0, progress=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn diagnose_groups<'py>(
    py: Python<'py>,
    model: Py<Model>,
    grouping: Grouping,
    max_effects: usize,
    candidates: Option<Vec<String>>,
    seed: u64,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, String, Vec<Cycles<'py>>, Grouped)> {
    let file = &model.get().file;
    let reading = options(&grouping.mapping, grouping.strict)?;
    let done = work::run(py, progress, |progress| -> Result<_, Refusal> {
        // The number of folders is unknown until the last one is found, so reading reports no progress.
        let read = |paths: &[PathBuf]| load(paths, &reading, &|_| progress.say(0.0, "reading"));
        let Grouping { data, by, reference, reference_name, .. } = &grouping;
        let mut good = match reference {
            None => None,
            Some(good) => {
                let campaign = good.of(&good.paths, read).map_err(|why| Refusal::Reading(why.into()))?;
                Some(Good { name: reference_name.clone(), campaign })
            }
        };
        let of_reference = good.as_mut().map(|good| &mut good.campaign);
        let split = split(&data.paths, by, &|paths| data.of(paths, read), of_reference)?;
        let (mut files, mut notes) = (split.files.clone(), split.notes.clone());
        if let Some(good) = &good {
            files.extend(good.campaign.files.clone());
            notes.extend(good.campaign.notes.clone());
        }
        let options = Options { max_effects, candidates, ..Options::default() };
        let say = |done: f64, text: &str| progress.say(done, text);
        let comparison = if grouping.chain { Comparison::Chain } else { Comparison::Reference };
        let answers =
            dashpot_diagnosis::groups::diagnose_groups((split, by), good, comparison, file, options, seed, &say);
        Ok((answers.map_err(|why| Refusal::Diagnosing(why.into()))?, notes, files))
    })?;
    let (answers, notes, files) = done.map_err(|refusal| match refusal {
        Refusal::Reading(why) => raise::<RecordError>(why),
        Refusal::Diagnosing(why) => raise::<DiagnosisError>(why),
    })?;
    let json = serde_json::to_string(&answers).map_err(raise::<DiagnosisError>)?;
    let notes = serde_json::to_string(&notes).map_err(raise::<DiagnosisError>)?;
    let of_group = |answer: &dashpot_diagnosis::groups::GroupResult| {
        answer.diagnosis.tests.iter().map(|test| arrays(py, &test.curves)).collect::<PyResult<_>>()
    };
    let cycles = answers.groups.iter().map(of_group).collect::<PyResult<_>>()?;
    Ok((json, notes, cycles, Grouped { results: answers, model, files }))
}
