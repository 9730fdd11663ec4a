//! Records of real dampers, which are not part of the project. Without these records, the tests that read them are
//! skipped.

use crate::library::root;
use dashpot_test_support::skipped;
use std::path::PathBuf;

/// Returns the folder of a set of real records: below `DASHPOT_DATA` if this variable is set, otherwise below
/// `shared/data` next to the project. Reports the test as skipped if the folder is absent.
pub fn records(set: &str) -> Option<PathBuf> {
    let base = std::env::var_os("DASHPOT_DATA").map_or_else(|| root().join("../shared/data"), PathBuf::from);
    let folder = base.join(set);
    if folder.is_dir() {
        return Some(folder);
    }
    skipped(format!("no {}", folder.display()));
    None
}
