//! Records of real dampers, which are not part of the project: tests that read them are skipped where they are absent.

use crate::library::root;
use dashpot_test_support::skipped;
use std::path::PathBuf;

/// Folder of a set of real records: below `DASHPOT_DATA` where that is set, else below `shared/data` beside the project.
/// Where there is none, a line says that the test was skipped.
pub fn records(set: &str) -> Option<PathBuf> {
    let base = std::env::var_os("DASHPOT_DATA").map_or_else(|| root().join("../shared/data"), PathBuf::from);
    let folder = base.join(set);
    if folder.is_dir() {
        return Some(folder);
    }
    skipped(format!("no {}", folder.display()));
    None
}
