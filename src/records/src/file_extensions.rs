//! How the names of records end.

use std::path::Path;

/// How the names of records end, in small letters.
pub const EXTENSIONS: [&str; 16] =
    ["csv", "txt", "asc", "dat", "tsv", "tra", "lvm", "xlsx", "xlsm", "mat", "mf4", "mdf", "tdms", "rsp", "drv", "tim"];

/// Whether a file is read as a record where its folder is given, by its name.
pub fn is_record_name(path: &Path) -> bool {
    EXTENSIONS.contains(&extension(path).as_str())
}

/// The ending of a name, in small letters.
pub(crate) fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase()
}
