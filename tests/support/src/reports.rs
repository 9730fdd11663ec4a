//! Inputs of situations that users reported. The inputs are stored next to the checkout, not inside.

use super::skips::skipped;
use std::path::{Path, PathBuf};

/// Returns the inputs of a situation (`../shared/data/reports`). Reports a skip and returns `None` if they are absent.
#[must_use]
pub fn reported(name: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/reports").join(name);
    if !path.exists() {
        skipped(format!("there is no {}", path.display()));
        return None;
    }
    Some(path)
}
