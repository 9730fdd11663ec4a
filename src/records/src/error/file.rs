//! Errors of a file that cannot be read, or that is no record.

use std::path::PathBuf;

use super::{Place, kinds, locate, locate_file, locate_line};
use crate::messages::phrases;
use dashpot_messages::{Sentence, Template};

/// Formats a file size for messages: below 10 MiB in bytes, else in MiB.
fn size(bytes: u64) -> String {
    if bytes < 10 << 20 { format!("{bytes} bytes") } else { format!("{} MiB", bytes >> 20) }
}

/// Reason for which a file cannot be read as a record.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
#[allow(missing_docs)] // the messages are the meaning of variants and fields
pub enum RecordFileError {
    NotFound {
        file: PathBuf,
    },

    Read {
        file: PathBuf,
        #[source]
        source: std::io::Error,
    },

    /// The path is a pipe, a device or a folder, not a file.
    NotRegular {
        file: PathBuf,
    },

    TooLarge {
        file: PathBuf,
        bytes: u64,
        largest: u64,
    },

    TooCostly {
        at: Place,
    },

    EmptyFile {
        file: PathBuf,
    },

    UnknownType {
        file: PathBuf,
    },

    NotRead {
        file: PathBuf,
        is: Template,
        instead: Template,
    },

    Workbook {
        file: PathBuf,
        cause: String,
    },

    Mat {
        file: PathBuf,
        cause: String,
    },

    Binary {
        file: PathBuf,
        kind: &'static str,
        cause: String,
    },

    Rpc {
        file: PathBuf,
        cause: String,
    },

    PeakTable {
        at: Place,
        line: usize,
        cause: String,
    },

    /// The file contains a table of peaks instead of a record.
    IsPeakTable {
        file: PathBuf,
    },

    Profile {
        file: PathBuf,
        cause: String,
    },
}

impl RecordFileError {
    /// Returns the cause and the remedy as a translatable sentence.
    pub fn sentence(&self) -> Sentence {
        match self {
            RecordFileError::NotFound { file } => locate_file(phrases::NOT_FOUND, file),
            RecordFileError::Read { file, source } => {
                locate_file(phrases::CANNOT_READ, file).with_foreign("cause", source)
            }
            RecordFileError::NotRegular { file } => locate_file(phrases::NOT_REGULAR, file),
            RecordFileError::TooLarge { file, bytes, largest } => {
                locate_file(phrases::TOO_LARGE, file).with("size", size(*bytes)).with("largest", size(*largest))
            }
            RecordFileError::TooCostly { at } => locate(phrases::TOO_COSTLY, at),
            RecordFileError::EmptyFile { file } => locate_file(phrases::EMPTY_FILE, file),
            RecordFileError::UnknownType { file } => {
                locate_file(phrases::UNKNOWN_TYPE, file).with_sentence("kinds", kinds())
            }
            RecordFileError::NotRead { file, is, instead } => {
                locate_file(phrases::NOT_READ, file).with_sentence("is", *is).with_sentence("instead", *instead)
            }
            RecordFileError::Workbook { file, cause } => {
                locate_file(phrases::WORKBOOK, file).with_foreign("cause", cause)
            }
            RecordFileError::Mat { file, cause } => locate_file(phrases::MAT, file).with_foreign("cause", cause),
            RecordFileError::Binary { file, kind, cause } => {
                locate_file(phrases::BINARY, file).with("kind", kind).with_foreign("cause", cause)
            }
            RecordFileError::Rpc { file, cause } => locate_file(phrases::RPC, file).with_foreign("cause", cause),
            RecordFileError::PeakTable { at, line, cause } => {
                locate_line(phrases::IN_LINE, at, line).with_sentence("cause", Sentence::as_it_is(cause))
            }
            RecordFileError::IsPeakTable { file } => locate_file(phrases::IS_PEAK_TABLE, file),
            RecordFileError::Profile { file, cause } => {
                locate_file(phrases::OF_FILE, file).with_sentence("text", Sentence::as_it_is(cause))
            }
        }
    }
}
