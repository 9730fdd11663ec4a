//! Atomic replacement of files: a file has either the old or the new content, never a part.

use super::guard::{Target, target};
use super::kind::Kind;
use super::lock;
use anyhow::Context as _;
use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::Path;

/// Prefix of the names of temporary files.
const TEMPORARY: &str = ".dashpot-";
/// Number of attempts to write a file. Another run may remove the temporary file by mistake, as a file of a dead run.
const TRIES: usize = 5;

/// Writes a file, and replaces an older file of the same kind through a temporary file in the same folder.
///
/// Symbolic links remain and refer to the new file, which has the permissions and the owner of the older file. Output
/// to a device or a pipe is direct.
///
/// # Errors
/// An existing file of another kind without `--force`, a missing folder, a full disk, or a file that cannot be
/// replaced. The older file then stays unchanged.
pub fn replace_file(path: &Path, contents: &[u8]) -> anyhow::Result<()> {
    match target(path, Some(&Kind::detect(contents)))? {
        Target::Stream(path) => {
            let mut out = fs::OpenOptions::new().write(true).open(path)?;
            out.write_all(contents)?;
            Ok(out.flush()?)
        }
        Target::File(path) => Ok(replace(&path, contents)?),
    }
}

fn replace(path: &Path, contents: &[u8]) -> io::Result<()> {
    let folder = folder_of(path);
    remove_of_dead_runs(folder);
    let mut outcome = Ok(());
    for _ in 0..TRIES {
        outcome = replace_once(path, folder, contents);
        match &outcome {
            Err(error) if error.kind() == io::ErrorKind::NotFound && folder.is_dir() => {}
            _ => break,
        }
    }
    outcome
}

fn replace_once(path: &Path, folder: &Path, contents: &[u8]) -> io::Result<()> {
    let mut builder = tempfile::Builder::new();
    // Temporary files are private by default, but users share reports. The user's umask still applies.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.prefix(TEMPORARY).tempfile_in(folder)?;
    lock::mark_alive(file.as_file());
    file.write_all(contents)?;
    if let Ok(older) = fs::metadata(path) {
        keep_rights(file.as_file(), &older)?;
    }
    file.as_file().sync_all()?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

#[cfg(unix)]
fn keep_rights(file: &File, older: &fs::Metadata) -> io::Result<()> {
    use std::os::unix::fs::MetadataExt as _;
    let new = file.metadata()?;
    if (new.uid(), new.gid()) != (older.uid(), older.gid()) {
        // Only root may change the owner. Otherwise the file belongs to the current user, as after saving in an editor.
        let _ = std::os::unix::fs::fchown(file, Some(older.uid()), Some(older.gid()));
    }
    file.set_permissions(older.permissions())
}

#[cfg(not(unix))]
fn keep_rights(_: &File, _: &fs::Metadata) -> io::Result<()> {
    Ok(())
}

/// Returns the folder of a file.
pub fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Checks that a folder is writable, and removes temporary files of killed runs from it.
///
/// # Errors
/// The error of the system.
pub fn try_folder(folder: &Path) -> io::Result<()> {
    remove_of_dead_runs(folder);
    tempfile::Builder::new().prefix(TEMPORARY).tempfile_in(folder).map(drop)
}

/// Removes temporary files of killed runs, which have no lock. Ignores files that cannot be removed.
fn remove_of_dead_runs(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten().filter(|e| e.file_name().to_string_lossy().starts_with(TEMPORARY)) {
        if entry.file_type().is_ok_and(|t| t.is_file()) && !lock::is_alive(&entry.path()) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Writes a file with [`replace_file`], and adds its path to the error.
///
/// # Errors
/// The errors of [`replace_file`].
pub fn write_file(path: &Path, contents: &[u8]) -> anyhow::Result<()> {
    replace_file(path, contents).with_context(|| format!("cannot write {}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_whole_and_nothing_is_left_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.svg");
        replace_file(&path, b"<svg>a long first version").unwrap();
        replace_file(&path, b"<svg>short").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"<svg>short");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        assert!(replace_file(&path, b"format = 1\nelements = []\n").unwrap_err().to_string().contains("a picture"));
        assert_eq!(fs::read(&path).unwrap(), b"<svg>short");
    }

    #[test]
    fn a_path_that_cannot_be_replaced_keeps_what_is_there() {
        let folder = tempfile::tempdir().unwrap();
        let occupied = folder.path().join("occupied");
        fs::create_dir_all(occupied.join("inside")).unwrap();
        assert!(replace_file(&occupied, b"x").is_err());
        assert!(occupied.join("inside").is_dir());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn files_of_dead_runs_go_and_those_of_living_runs_stay() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(".dashpot-dead01"), "half").unwrap();
        let living = tempfile::Builder::new().prefix(TEMPORARY).tempfile_in(folder.path()).unwrap();
        lock::mark_alive(living.as_file());
        replace_file(&folder.path().join("a.svg"), b"<svg>").unwrap();
        assert!(!folder.path().join(".dashpot-dead01").exists());
        assert!(living.path().exists());
    }

    #[cfg(unix)]
    #[test]
    fn links_and_rights_survive() {
        use std::os::unix::fs::{PermissionsExt as _, symlink};
        let folder = tempfile::tempdir().unwrap();
        let (file, link) = (folder.path().join("a.svg"), folder.path().join("link"));
        fs::write(&file, "<svg>").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
        symlink("a.svg", &link).unwrap();
        replace_file(&link, b"<svg>new").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&file).unwrap(), b"<svg>new");
        assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
    }
}
