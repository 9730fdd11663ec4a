//! File of a model of the literature that the kernel cannot run. It is a separate TOML format that only `validate --against` reads.

use super::Literature;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Text at the top of the file, for people and other tools.
const HEADING: &str = "\
# A damper model of the literature, identified for comparison by `dashpot fit --model`.
# This is not a dashpot model file: no host, simulation or export can run it. Only
# `dashpot validate MODEL DATA --against THIS-FILE` reads it.
";

/// Key that identifies a file of this format.
pub const KEY: &str = "literature_model";

/// Reason why a file of a model of the literature cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The file cannot be opened.
    #[error("cannot read the comparison model {file}: {why}")]
    Unreadable {
        /// Path of the file.
        file: PathBuf,
        /// Reason from the operating system.
        why: std::io::Error,
    },
    /// The file has another format, or it is damaged.
    #[error("{file} is no comparison model that dashpot fit --model wrote: {why}")]
    Wrong {
        /// Path of the file.
        file: PathBuf,
        /// Message of the TOML reader, with line and column.
        why: String,
    },
}

/// Formats the file of a model, with the names of the tests from which it was identified.
pub fn write(model: &Literature, tests: &[String]) -> String {
    #[derive(Serialize)]
    struct File<'a> {
        #[serde(flatten)]
        model: &'a Literature,
        tests: &'a [String],
    }
    // The file holds only numbers, lists and strings, so the conversion cannot fail.
    HEADING.to_owned() + &toml::to_string(&File { model, tests }).unwrap_or_default()
}

/// Reads a model of the literature from its file.
///
/// # Errors
/// [`FileError`], with the file and the reason.
pub fn read(path: &Path) -> Result<Literature, FileError> {
    let text = dashpot_records::read_small_text(path)
        .map_err(|why| FileError::Unreadable { file: path.to_path_buf(), why })?;
    toml::from_str(&text).map_err(|why| FileError::Wrong { file: path.to_path_buf(), why: why.to_string() })
}

/// Returns whether a text is the file of a model of the literature.
pub fn is_one(text: &str) -> bool {
    #[derive(Deserialize)]
    struct Head {
        literature_model: Option<String>,
    }
    text.contains(KEY) && toml::from_str::<Head>(text).is_ok_and(|head| head.literature_model.is_some())
}
