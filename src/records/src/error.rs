//! Errors of reading a record or a campaign. Each message states the location and the remedy.

mod columns;
mod file;
mod imposed_motion;
mod plausibility;
mod samples;
mod selection;

use std::fmt;
use std::path::{Path, PathBuf};

use crate::messages::phrases;
use dashpot_messages::{Sentence, Template};

pub use columns::ColumnError;
pub use file::RecordFileError;
pub use imposed_motion::ImposedMotionError;
pub use plausibility::{FilesUnit, PlausibilityError};
pub use samples::SampleError;
pub use selection::SelectionError;

/// The location that a message refers to: a file, and the sheet or test within it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Path of the file.
    pub file: PathBuf,
    /// Sheet or test within the file, if the file contains several.
    pub part: Option<String>,
}

impl Place {
    /// Makes the location of a whole file.
    pub fn file(file: impl Into<PathBuf>) -> Self {
        Place { file: file.into(), part: None }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        if let Some(part) = &self.part {
            write!(f, " ({part})")?;
        }
        Ok(())
    }
}

/// Reason for which a campaign is rejected. Every message states the file, the line if known, and the remedy.
///
/// Lines count from 1, as in an editor. The lines of a sheet are its rows, and the lines of a MAT file are the elements
/// of its arrays.
#[derive(Debug, thiserror::Error)]
#[error(transparent)]
#[allow(missing_docs)] // the types of the errors are the meaning of the variants
pub enum RecordError {
    File(#[from] RecordFileError),
    Column(#[from] ColumnError),
    Sample(#[from] SampleError),
    ImposedMotion(#[from] ImposedMotionError),
    Selection(#[from] SelectionError),
    Implausible(#[from] PlausibilityError),
}

impl RecordError {
    /// Returns the cause and the remedy as a translatable sentence.
    pub fn sentence(&self) -> Sentence {
        match self {
            RecordError::File(error) => error.sentence(),
            RecordError::Column(error) => error.sentence(),
            RecordError::Sample(error) => error.sentence(),
            RecordError::ImposedMotion(error) => error.sentence(),
            RecordError::Selection(error) => error.sentence(),
            RecordError::Implausible(error) => error.sentence(),
        }
    }

    /// Returns the sentence for a file or test that the campaign leaves out. The user need not act, so the sentence
    /// omits the list of supported headings.
    pub(crate) fn fault(&self) -> Sentence {
        match self {
            RecordError::Column(error) => error.fault(),
            _ => self.sentence(),
        }
    }
}

/// Fills in the place to which a sentence refers.
fn locate(template: Template, at: &Place) -> Sentence {
    Sentence::from(template).with("at", at)
}

/// Fills in the place and the line to which a sentence refers.
fn locate_line(template: Template, at: &Place, line: &usize) -> Sentence {
    locate(template, at).with("line", line)
}

/// Fills in the file to which a sentence refers.
fn locate_file(template: Template, file: &Path) -> Sentence {
    Sentence::from(template).with("file", file.display())
}

/// Lists the supported file extensions, for messages.
fn kinds() -> Sentence {
    let all = crate::file_extensions::EXTENSIONS.map(|ending| format!(".{ending}"));
    let (last, others) = (&all[all.len() - 1], &all[..all.len() - 1]);
    Sentence::from(phrases::KINDS).with("others", others.join(", ")).with("last", last)
}

/// Names tests in a list. Names at most twelve and states the number of the others, so that the text stays readable.
pub(crate) fn name_several(tests: &[String]) -> Sentence {
    const NAMED: usize = 12;
    let named = Sentence::list(tests.iter().take(NAMED).map(Sentence::as_it_is).collect(), phrases::COMMA);
    match tests.len().saturating_sub(NAMED) {
        0 => named,
        more => Sentence::from(phrases::AND_MORE).with_sentence("names", named).with("count", more),
    }
}
