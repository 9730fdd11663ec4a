//! The file of a model of the literature that the kernel cannot run: TOML of its own kind, for `validate --against` alone.

use super::Literature;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// What the file says at its top, where people and other tools look first.
const HEADING: &str = "\
# A damper model of the literature, identified for comparison by `dashpot fit --model`.
# This is not a dashpot model file: no host, simulation or export can run it. Only
# `dashpot validate MODEL DATA --against THIS-FILE` reads it.
";

/// Key that tells such a file.
pub const KEY: &str = "literature_model";

/// Why a file was not read.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// Not to be opened.
    #[error("cannot read the comparison model {file}: {why}")]
    Unreadable {
        /// Path.
        file: PathBuf,
        /// The system's reason.
        why: std::io::Error,
    },
    /// Not such a file, or damaged.
    #[error("{file} is no comparison model that dashpot fit --model wrote: {why}")]
    Wrong {
        /// Path.
        file: PathBuf,
        /// The reader's words, with line and column.
        why: String,
    },
}

/// Writes a model and the tests that it was identified from.
pub fn write(model: &Literature, tests: &[String]) -> String {
    #[derive(Serialize)]
    struct File<'a> {
        #[serde(flatten)]
        model: &'a Literature,
        tests: &'a [String],
    }
    // Numbers, lists and strings alone: this cannot fail.
    HEADING.to_owned() + &toml::to_string(&File { model, tests }).unwrap_or_default()
}

/// Reads a model.
///
/// # Errors
/// [`FileError`], naming the file and what is wrong with it.
pub fn read(path: &Path) -> Result<Literature, FileError> {
    let text = dashpot_records::read_small_text(path)
        .map_err(|why| FileError::Unreadable { file: path.to_path_buf(), why })?;
    toml::from_str(&text).map_err(|why| FileError::Wrong { file: path.to_path_buf(), why: why.to_string() })
}

/// Whether a text is such a file.
pub fn is_one(text: &str) -> bool {
    #[derive(Deserialize)]
    struct Head {
        literature_model: Option<String>,
    }
    text.contains(KEY) && toml::from_str::<Head>(text).is_ok_and(|head| head.literature_model.is_some())
}
