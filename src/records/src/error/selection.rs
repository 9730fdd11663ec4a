//! Errors of the files and options that the user selects.

use std::path::PathBuf;

use super::kinds;
use crate::messages::phrases;
use crate::quantities::channel::Channel;
use dashpot_messages::Sentence;

/// Reason for which the selected files and options contain no campaign.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
#[allow(missing_docs)] // the messages are the meaning of variants and fields
pub enum SelectionError {
    NoPaths,

    EmptyFolder { folder: PathBuf },

    InSubfolders { folder: PathBuf, names: Vec<String>, count: usize },

    ExcludesNothing { pattern: String, first: String },

    ExcludesAll { count: usize },

    ProfilesDisagree { first: PathBuf, second: PathBuf },

    Indispensable { channel: Channel },
}

impl SelectionError {
    /// Returns the cause and the remedy as a translatable sentence.
    pub fn sentence(&self) -> Sentence {
        match self {
            SelectionError::NoPaths => phrases::NO_PATHS.into(),
            SelectionError::EmptyFolder { folder } => {
                Sentence::from(phrases::EMPTY_FOLDER).with("folder", folder.display()).with_sentence("kinds", kinds())
            }
            SelectionError::InSubfolders { folder, names, count } => Sentence::from(phrases::IN_SUBFOLDERS)
                .with("folder", folder.display())
                .with("count", count)
                .with_names("names", names, phrases::COMMA),
            SelectionError::ExcludesNothing { pattern, first } => Sentence::from(phrases::EXCLUDES_NOTHING)
                .with("pattern", format!("{pattern:?}"))
                .with("first", format!("{first:?}")),
            SelectionError::ExcludesAll { count } => Sentence::from(phrases::EXCLUDES_ALL).with("count", count),
            SelectionError::ProfilesDisagree { first, second } => Sentence::from(phrases::PROFILES_DISAGREE)
                .with("first", first.display())
                .with("second", second.display()),
            SelectionError::Indispensable { channel } => {
                Sentence::from(phrases::INDISPENSABLE).with_sentence("channel", channel.message())
            }
        }
    }
}
