//! Diagnosis of many dampers, or of one damper at many settings, each compared with one reference or with the previous
//! group.

use crate::diagnose::diagnose;
use crate::hold_out::choose;
use crate::options::{DiagnosisError, Options};
use crate::outcome::Diagnosis;
use dashpot_identification::model_file::ModelFile;
use dashpot_messages::Sentence;
use dashpot_messages::Template;
use dashpot_records::groups::{Group, Split};
use dashpot_records::{Campaign, Record, Unusable};
use serde::Serialize;

/// Diagnosis of one group.
#[derive(Debug, Serialize)]
pub struct GroupResult {
    /// Name of the group.
    pub group: String,
    /// Name of the reference or group with which this group was compared.
    pub reference: String,
    /// Number of tests of the group, including left-out tests.
    pub tests: usize,
    /// Diagnosis relative to the reference.
    pub diagnosis: Diagnosis,
}

/// Diagnoses of all groups. `dashpot diagnose --group` writes this value as JSON.
#[derive(Debug, Serialize)]
pub struct GroupResults {
    /// Name of the reference. In a chain ([`Comparison::Chain`]), name of the reference of the first group.
    pub reference: String,
    /// Names of tests that belong to no group.
    pub left_aside: Vec<String>,
    /// Lines of the list of groups that name none of the tests.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub without_test: Vec<String>,
    /// Files and tests that could not be used, including those of the reference.
    pub unusable: Vec<Unusable>,
    /// Measurement errors that the fit of the model found in its own records. Also states whether the records of the
    /// groups were corrected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub as_the_fit_saw: Option<Sentence>,
    /// Every group except the reference.
    pub groups: Vec<GroupResult>,
}

/// Choice of the reference with which each group is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Comparison {
    /// Compare every group with the reference. The result shows the faults of each damper.
    Reference,
    /// Compare each group with the previous group, and the first group with the reference. The result shows the change
    /// due to one step of an adjuster or of wear.
    Chain,
}

/// Reference that does not belong to the groups.
pub struct Good {
    /// Name of the reference.
    pub name: String,
    /// Records of the reference.
    pub campaign: Campaign,
}

/// Error of a comparison of groups.
#[derive(Debug, thiserror::Error)]
pub enum GroupsError {
    /// There is only one group and no reference.
    #[error("--group {by:?} finds one group, {name}; give --reference to compare it with")]
    One {
        /// Property that splits the data.
        by: String,
        /// Name of the group.
        name: String,
    },
    /// A group cannot be diagnosed.
    #[error("group {name}")]
    Group {
        /// Name of the group.
        name: String,
        /// Error of its diagnosis.
        source: DiagnosisError,
    },
}

/// Diagnoses every group of data that were split `by` a property, relative to the reference `good`. Without `good`, the
/// first group is the reference.
///
/// In a chain, each group is compared with the previous group. The function overwrites the reference in `options`.
/// `seed` selects the left-out tests, which no refit uses. `progress` receives the completed fraction and the current
/// step.
///
/// # Errors
/// Returns an error if there is a single group and no reference, or if a group cannot be diagnosed.
pub fn diagnose_groups(
    (split, by): (Split, &str),
    good: Option<Good>,
    comparison: Comparison,
    model: &ModelFile,
    options: Options,
    seed: u64,
    progress: &(dyn Fn(f64, &str) + Sync),
) -> Result<GroupResults, GroupsError> {
    let Split { mut groups, left_aside, without_test, mut unusable, .. } = split;
    let (name, mut reference) = match good {
        Some(Good { name, campaign }) => {
            unusable.extend(campaign.unusable);
            (name, campaign.records)
        }
        None if groups.len() < 2 => {
            let name = groups.pop().map(|group| group.name).unwrap_or_default();
            return Err(GroupsError::One { by: by.to_owned(), name });
        }
        None => {
            let first = groups.remove(0);
            (first.name, first.records)
        }
    };
    let all = groups.iter_mut().flat_map(|group| &mut group.records).chain(&mut reference);
    let as_the_fit_saw = model.identification.right(all).map(|note| note.text);
    let mut options = Options { reference, ..options };
    let mut compared_with = name.clone();
    let count = groups.len() as f64;
    let one = |(k, Group { name, records }): (usize, Group)| {
        let all: Vec<&Record> = records.iter().collect();
        let left = choose(&all, seed);
        let told = |done: f64, text: Template| {
            progress((k as f64 + done) / count, &format!("{name}: {}", text.english()));
        };
        let found = diagnose(&all, &left, &model.params, &options, &told);
        let diagnosis = found.map_err(|source| GroupsError::Group { name: name.clone(), source })?;
        let answer = GroupResult { group: name, reference: compared_with.clone(), tests: all.len(), diagnosis };
        if comparison == Comparison::Chain {
            (options.reference, compared_with) = (records, answer.group.clone());
        }
        Ok(answer)
    };
    let groups = groups.into_iter().enumerate().map(one).collect::<Result<_, _>>()?;
    Ok(GroupResults { reference: name, left_aside, without_test, unusable, as_the_fit_saw, groups })
}
