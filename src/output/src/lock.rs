//! Locks: only one run at a time writes results into a folder, and temporary files show whether their run still exists.

use anyhow::{Context as _, bail};
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// Lock of a folder for this run. The lock ends when this value is dropped.
pub struct FolderLock {
    held: Option<File>,
    /// The folder, if this run made it. The folder is removed again if it stays empty.
    made: Option<PathBuf>,
}

impl FolderLock {
    /// Makes the folder if necessary, and locks it.
    ///
    /// # Errors
    /// A folder that cannot be made, or that another run has locked.
    pub fn take(folder: &Path) -> anyhow::Result<FolderLock> {
        let made = (!folder.exists()).then(|| folder.to_owned());
        fs::create_dir_all(folder).with_context(|| format!("making the folder {}", folder.display()))?;
        match hold(folder) {
            Ok(held) => Ok(FolderLock { held, made }),
            Err(Held) => bail!(
                "another run of dashpot writes into the folder {}; wait for it, or choose another folder",
                folder.display()
            ),
        }
    }
}

impl Drop for FolderLock {
    fn drop(&mut self) {
        drop(self.held.take());
        if let Some(folder) = &self.made {
            // This fails, as intended, if the folder is not empty.
            let _ = fs::remove_dir(folder);
        }
    }
}

/// Error of a folder that another run has locked.
struct Held;

/// Locks a folder. Returns `None` if the file system has no locks.
#[cfg(unix)]
fn hold(folder: &Path) -> Result<Option<File>, Held> {
    let Ok(file) = File::open(folder) else { return Ok(None) };
    match rustix::fs::flock(&file, rustix::fs::FlockOperation::NonBlockingLockExclusive) {
        Err(rustix::io::Errno::WOULDBLOCK) => Err(Held),
        _ => Ok(Some(file)),
    }
}

/// Makes a file that other runs cannot open and that the system removes at the end of the run. The file is next to the folder, not in it,
/// because a run checks the content of the folder.
#[cfg(windows)]
fn hold(folder: &Path) -> Result<Option<File>, Held> {
    use std::os::windows::fs::OpenOptionsExt as _;
    /// `FILE_FLAG_DELETE_ON_CLOSE` of the Windows interface.
    const DELETE_ON_CLOSE: u32 = 0x0400_0000;
    /// `ERROR_SHARING_VIOLATION` of the Windows interface.
    const SHARING_VIOLATION: i32 = 32;
    let mut open = fs::OpenOptions::new();
    open.write(true).create(true).share_mode(0).custom_flags(DELETE_ON_CLOSE);
    let beside = fs::canonicalize(folder).ok().and_then(|folder| {
        let name = format!(".{}.dashpot-lock", folder.file_name()?.to_string_lossy());
        Some(folder.with_file_name(name))
    });
    let Some(beside) = beside else { return Ok(None) };
    match open.open(beside) {
        Ok(file) => Ok(Some(file)),
        Err(error) if error.raw_os_error() == Some(SHARING_VIOLATION) => Err(Held),
        Err(_) => Ok(None),
    }
}

/// Marks a temporary file as belonging to an existing run. The mark disappears when the run ends, even if the run is
/// killed.
pub fn mark_alive(file: &File) {
    // A file system without locks has no marks, and its temporary files are never removed.
    #[cfg(unix)]
    let _ = rustix::fs::flock(file, rustix::fs::FlockOperation::NonBlockingLockShared);
    // Windows does not remove an open file that prohibits deletion, so a mark is unnecessary.
    #[cfg(not(unix))]
    let _ = file;
}

/// Returns whether a temporary file belongs to an existing run, or whether this is unknown.
pub fn is_alive(path: &Path) -> bool {
    #[cfg(unix)]
    {
        let Ok(file) = File::open(path) else { return true };
        rustix::fs::flock(&file, rustix::fs::FlockOperation::NonBlockingLockExclusive).is_err()
    }
    #[cfg(not(unix))]
    {
        let _ = path;
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_held_by_one_and_an_empty_one_goes_again() {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("new");
        let first = FolderLock::take(&folder).unwrap();
        assert!(FolderLock::take(&folder).is_err());
        drop(first);
        assert!(!folder.exists());
        let again = FolderLock::take(&folder).unwrap();
        fs::write(folder.join("x"), "y").unwrap();
        drop(again);
        assert!(folder.join("x").exists());
        assert!(FolderLock::take(&folder).is_ok());
    }
}
