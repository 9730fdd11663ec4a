//! Inputs of situations that users reported. They lie beside the checkout, not in it.

use super::skips::skipped;
use std::path::{Path, PathBuf};

/// The inputs of a situation (`../shared/data/reports`). Where they are not on this machine it says so, and there are none.
#[must_use]
pub fn reported(name: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/reports").join(name);
    if !path.exists() {
        skipped(format!("there is no {}", path.display()));
        return None;
    }
    Some(path)
}
