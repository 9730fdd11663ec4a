//! Many dampers, or one at many settings, each against one reference or against the group before it.

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

/// The result for one group.
#[derive(Debug, Serialize)]
pub struct GroupResult {
    /// Its name.
    pub group: String,
    /// What it was compared with.
    pub reference: String,
    /// Number of tests.
    pub tests: usize,
    /// The diagnosis against the reference.
    pub diagnosis: Diagnosis,
}

/// The results for all groups. Its JSON form is what `dashpot diagnose --group` writes.
#[derive(Debug, Serialize)]
pub struct GroupResults {
    /// What they were compared with; in a chain, the first of them alone.
    pub reference: String,
    /// Tests that belong to no group.
    pub left_aside: Vec<String>,
    /// Lines of the list of groups that name none of the tests.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub without_test: Vec<String>,
    /// Files and tests that could not be used, of the reference too.
    pub unusable: Vec<Unusable>,
    /// What the model's fit found in its own records, and whether it was taken out of these.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub as_the_fit_saw: Option<Sentence>,
    /// Every group but the reference.
    pub groups: Vec<GroupResult>,
}

/// What each group is compared with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Comparison {
    /// All with the reference: what is wrong with each damper.
    Reference,
    /// Each with the group before it, the first with the reference: what one step of an adjuster, or of wear, changes.
    Chain,
}

/// What groups are compared with, beside those that are among them.
pub struct Good {
    /// What it is called.
    pub name: String,
    /// Its records.
    pub campaign: Campaign,
}

/// Why groups are not compared.
#[derive(Debug, thiserror::Error)]
pub enum GroupsError {
    /// One group, and nothing beside it.
    #[error("--group {by:?} finds one group, {name}; give --reference to compare it with")]
    One {
        /// What splits the data.
        by: String,
        /// The group.
        name: String,
    },
    /// One that has no diagnosis.
    #[error("group {name}")]
    Group {
        /// Its name.
        name: String,
        /// Why.
        source: DiagnosisError,
    },
}

/// Diagnoses every group of data that were split `by` something against what is good, or against the first of them where that is not given.
///
/// In a chain each is compared with the one before. The reference of `options` is put there; `seed` chooses which tests no refit sees;
/// `progress` is told the fraction done and what is being done.
///
/// # Errors
/// One group alone, or one that cannot be diagnosed.
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
