//! Errors of files of dimensions.

use std::path::PathBuf;

/// Reason why a file of dimensions is rejected.
#[derive(Debug, thiserror::Error)]
pub enum DimensionsError {
    /// The file cannot be read.
    #[error("cannot read the dimensions {file}: {why}")]
    Unreadable {
        /// Path of the file.
        file: PathBuf,
        /// The system's reason.
        why: std::io::Error,
    },
    /// The text is not TOML.
    #[error("{file} is not a TOML file: {why}")]
    Toml {
        /// Path of the file.
        file: PathBuf,
        /// Message of the TOML reader, with line and column.
        why: String,
    },
    /// An entry is invalid.
    #[error("{file}, line {line}: {key}{text}")]
    Entry {
        /// Path of the file.
        file: PathBuf,
        /// Line number, from 1.
        line: usize,
        /// Key of the invalid entry.
        key: String,
        /// The problem and its remedy.
        text: String,
    },
    /// Two entries contradict each other.
    #[error("{file}: {text}")]
    Together {
        /// Path of the file.
        file: PathBuf,
        /// The problem and its remedy.
        text: String,
    },
}
