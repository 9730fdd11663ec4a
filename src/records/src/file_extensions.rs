//! File extensions of records.

use std::path::Path;

/// File extensions of records, in lower case.
pub const EXTENSIONS: [&str; 16] =
    ["csv", "txt", "asc", "dat", "tsv", "tra", "lvm", "xlsx", "xlsm", "mat", "mf4", "mdf", "tdms", "rsp", "drv", "tim"];

/// Returns whether the extension of a path is that of a record.
pub fn is_record_name(path: &Path) -> bool {
    EXTENSIONS.contains(&extension(path).as_str())
}

/// Returns the extension of a file name, in lower case.
pub(crate) fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase()
}
