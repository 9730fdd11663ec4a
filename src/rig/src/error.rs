//! Errors of the virtual rig; their messages state the location of the problem and a remedy.

use std::io;
use std::path::{Path, PathBuf};

/// Errors of the virtual rig.
#[derive(Debug, thiserror::Error)]
pub enum RigError {
    /// A cell or row of a matrix file is invalid.
    #[error("{}, line {line}, column {column}: {problem}", file.display())]
    MatrixCell {
        /// The matrix file.
        file: PathBuf,
        /// Line in the file, counted from 1.
        line: u64,
        /// Name of the column, as in the file's header.
        column: String,
        /// The problem and a remedy.
        problem: String,
    },
    /// A matrix file as a whole is invalid.
    #[error("{}, line {line}: {problem}", file.display())]
    MatrixFile {
        /// The matrix file.
        file: PathBuf,
        /// Line in the file, counted from 1.
        line: u64,
        /// The problem and a remedy.
        problem: String,
    },
    /// A test point exceeds the limits of the rig or the damper.
    #[error("test '{test}': {problem}")]
    TestPoint {
        /// Name of the test.
        test: String,
        /// The problem and a remedy.
        problem: String,
    },
    /// An option is out of range.
    #[error("option {option}: {problem}")]
    Option {
        /// Name of the option.
        option: &'static str,
        /// The problem and a remedy.
        problem: String,
    },
    /// The solver failed on the motion of the damper.
    #[error(
        "test '{test}': the damper's motion could not be solved beyond {time_s:.4} s ({problem}); \
         check the test's amplitude, frequency and side force"
    )]
    Motion {
        /// Name of the test.
        test: String,
        /// Simulated time that the solver reached, s.
        time_s: f64,
        /// Reason for which the solver stopped.
        problem: String,
    },
    /// The output folder contains files that do not belong to an earlier campaign, and could be mistaken for records.
    #[error("{}: {problem}", folder.display())]
    Folder {
        /// The output folder.
        folder: PathBuf,
        /// The problem and a remedy.
        problem: String,
    },
    /// A file could not be read or written.
    #[error("cannot {action} {}: {source}", path.display())]
    Io {
        /// The attempted action, e.g. "read".
        action: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// Error of the operating system.
        source: io::Error,
    },
}

impl RigError {
    /// Returns a closure for `map_err` that wraps a system error with the attempted action and the path.
    pub(crate) fn io(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { action, path, source }
    }
}
