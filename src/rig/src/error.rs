//! What can go wrong on the rig, in words that say where and what to do.

use std::io;
use std::path::{Path, PathBuf};

/// Everything the virtual rig refuses or fails at.
#[derive(Debug, thiserror::Error)]
pub enum RigError {
    /// A cell or row of a matrix file cannot be used.
    #[error("{}, line {line}, column {column}: {problem}", file.display())]
    MatrixCell {
        /// The matrix file.
        file: PathBuf,
        /// Line in the file, counted from 1.
        line: u64,
        /// Name of the column, as in the file's header.
        column: String,
        /// What is wrong and what to do.
        problem: String,
    },
    /// A matrix file as a whole cannot be used.
    #[error("{}, line {line}: {problem}", file.display())]
    MatrixFile {
        /// The matrix file.
        file: PathBuf,
        /// Line in the file, counted from 1.
        line: u64,
        /// What is wrong and what to do.
        problem: String,
    },
    /// A test point lies outside what the rig or its damper can do.
    #[error("test '{test}': {problem}")]
    TestPoint {
        /// Name of the test.
        test: String,
        /// What is wrong and what to do.
        problem: String,
    },
    /// An option is out of range.
    #[error("option {option}: {problem}")]
    Option {
        /// Name of the option.
        option: &'static str,
        /// What is wrong and what to do.
        problem: String,
    },
    /// The motion of the damper could not be solved.
    #[error(
        "test '{test}': the damper's motion could not be solved beyond {time_s:.4} s ({problem}); \
         check the test's amplitude, frequency and side force"
    )]
    Motion {
        /// Name of the test.
        test: String,
        /// Time reached.
        time_s: f64,
        /// What stopped the solver.
        problem: String,
    },
    /// The output folder holds something else than an earlier campaign.
    #[error("{}: {problem}", folder.display())]
    Folder {
        /// The output folder.
        folder: PathBuf,
        /// What is wrong and what to do.
        problem: String,
    },
    /// A file could not be read or written.
    #[error("cannot {action} {}: {source}", path.display())]
    Io {
        /// What was attempted, e.g. "read".
        action: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
}

impl RigError {
    /// For `map_err`: wraps a system error with the action and the path.
    pub(crate) fn io(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { action, path, source }
    }
}
