//! Files and folders that a run reads. No output may replace them.

use super::run;
use std::path::{Path, PathBuf};
use std::sync::{PoisonError, RwLock};

static INPUTS: RwLock<Vec<PathBuf>> = RwLock::new(Vec::new());

/// Registers every existing file or folder that a run reads. The user interface registers further files while it runs.
pub fn register(paths: impl IntoIterator<Item = PathBuf>) {
    let mut inputs = INPUTS.write().unwrap_or_else(PoisonError::into_inner);
    inputs.extend(paths.into_iter().filter_map(|p| std::fs::canonicalize(p).ok()));
}

/// Returns whether this run reads an existing file, either by name or as a record in a registered folder.
pub fn reads(path: &Path) -> bool {
    is_among(path, &INPUTS.read().unwrap_or_else(PoisonError::into_inner)) || is_among(path, &run::reads())
}

fn is_among(path: &Path, inputs: &[PathBuf]) -> bool {
    let Ok(path) = std::fs::canonicalize(path) else { return false };
    inputs.iter().any(|input| {
        same_file(input, &path)
            || (input.is_dir() && path.parent() == Some(input) && dashpot_records::is_record_name(&path))
    })
}

/// Returns whether two paths refer to one file, for example through a hard link.
fn same_file(a: &Path, b: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt as _;
        if let (Ok(a), Ok(b)) = (std::fs::metadata(a), std::fs::metadata(b)) {
            return (a.dev(), a.ino()) == (b.dev(), b.ino());
        }
    }
    a == b
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_named_and_records_of_folders_named_are_inputs() {
        let folder = tempfile::tempdir().unwrap();
        let root = std::fs::canonicalize(folder.path()).unwrap();
        std::fs::create_dir(root.join("records")).unwrap();
        for name in ["records/a.csv", "records/m.toml", "b.csv", "c.csv"] {
            std::fs::write(root.join(name), "x").unwrap();
        }
        std::fs::hard_link(root.join("b.csv"), root.join("d.csv")).unwrap();
        let inputs = [root.join("records"), root.join("b.csv")];
        for (name, wanted) in [
            ("records/a.csv", true),
            ("records/../b.csv", true),
            ("records/m.toml", false),
            ("c.csv", false),
            ("new.csv", false),
            ("d.csv", cfg!(unix)),
        ] {
            assert_eq!(is_among(&root.join(name), &inputs), wanted, "{name}");
        }
    }
}
