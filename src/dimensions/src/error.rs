//! Why a drawing cannot be used.

use std::path::PathBuf;

/// What is wrong with a file of dimensions.
#[derive(Debug, thiserror::Error)]
pub enum DimensionsError {
    /// The file cannot be read.
    #[error("cannot read the dimensions {file}: {why}")]
    Unreadable {
        /// Path.
        file: PathBuf,
        /// The system's reason.
        why: std::io::Error,
    },
    /// The text is not TOML.
    #[error("{file} is not a TOML file: {why}")]
    Toml {
        /// Path.
        file: PathBuf,
        /// The reader's words, with line and column.
        why: String,
    },
    /// One entry is wrong.
    #[error("{file}, line {line}: {key}{text}")]
    Entry {
        /// Path.
        file: PathBuf,
        /// Line.
        line: usize,
        /// Key.
        key: String,
        /// What is wrong and what to do.
        text: String,
    },
    /// Two entries contradict each other.
    #[error("{file}: {text}")]
    Together {
        /// Path.
        file: PathBuf,
        /// What is wrong and what to do.
        text: String,
    },
}
