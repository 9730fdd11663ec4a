//! Lists the Rust files of a folder, for tests that read the sources.

use std::path::{Path, PathBuf};
use std::{fs, io};

/// Names of folders with built or downloaded files, which are not sources.
const NOT_SOURCES: [&str; 3] = ["target", ".git", ".venv"];

/// Lists all Rust files in a folder and its subfolders, sorted by path.
///
/// # Errors
/// If a folder is not readable.
pub fn rust_files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    list(folder, &mut files)?;
    files.sort();
    Ok(files)
}

fn list(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let path = entry.path();
        if entry.file_type()?.is_dir() {
            if !NOT_SOURCES.iter().any(|name| entry.file_name() == *name) {
                list(&path, files)?;
            }
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_built_is_no_source() {
        let folder = tempfile::tempdir().unwrap();
        for path in ["b.rs", "a/c.rs", "target/made.rs", "a/target/made.rs", "a/read.md"] {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "").unwrap();
        }
        assert_eq!(rust_files(folder.path()).unwrap(), ["a/c.rs", "b.rs"].map(|name| folder.path().join(name)));
    }
}
