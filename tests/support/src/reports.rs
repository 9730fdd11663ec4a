//! Input files of problems that users reported. They are stored next to the checkout of the project, not inside.

use super::skips::skipped;
use std::path::{Path, PathBuf};

/// Returns the path of the inputs of a reported problem, `../shared/data/reports/<name>`. Reports the test as skipped
/// and returns `None` if the path does not exist.
#[must_use]
pub fn reported(name: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/reports").join(name);
    if !path.exists() {
        skipped(format!("there is no {}", path.display()));
        return None;
    }
    Some(path)
}
