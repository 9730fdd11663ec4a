//! Functions that write files, replace files atomically, and read regular files of limited size.

use std::fs;
use std::io::{self, BufWriter, Read, Write};
use std::path::Path;

use crate::RigError;

/// Largest accepted size of a table, bytes.
const LARGEST: u64 = 16 << 20;

/// Reads a regular file of at most 16 MiB. Rejects a pipe, which would block forever, and a device, which never ends.
pub(crate) fn read_table(path: &Path) -> io::Result<Vec<u8>> {
    if !fs::metadata(path)?.is_file() {
        return Err(io::Error::other("it is no regular file"));
    }
    let mut bytes = Vec::new();
    fs::File::open(path)?.take(LARGEST + 1).read_to_end(&mut bytes)?;
    match bytes.len() as u64 > LARGEST {
        true => Err(io::Error::other(format!("it is larger than {} MiB", LARGEST >> 20))),
        false => Ok(bytes),
    }
}

/// Reads a regular text file in UTF-8 of at most 16 MiB.
pub(crate) fn read_text(path: &Path) -> io::Result<String> {
    String::from_utf8(read_table(path)?).map_err(|_| io::Error::other("it is no text in UTF-8"))
}

/// Writes a file and flushes it to the disk. After an error, the file may be incomplete.
pub(crate) fn write_file(path: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), RigError> {
    let write = || {
        let mut out = BufWriter::with_capacity(1 << 16, fs::File::create(path)?);
        content(&mut out)?;
        out.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()
    };
    write().map_err(RigError::io("write", path))
}

/// Replaces a file atomically: writes a temporary file in its folder, then renames it.
pub(crate) fn replace_file(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), RigError> {
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.unfinished", std::process::id()));
    let aside = path.with_file_name(name);
    let outcome =
        write_file(&aside, content).and_then(|()| fs::rename(&aside, path).map_err(RigError::io("write", path)));
    if outcome.is_err() {
        // Ignore an error of the removal, because the first error is reported.
        let _ = fs::remove_file(&aside);
    }
    outcome
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_replacement_leaves_the_file_as_it_was() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("matrix.csv");
        replace_file(&file, |out| out.write_all(b"first")).unwrap();
        let fault = replace_file(&file, |out| {
            out.write_all(b"sec")?;
            Err(io::Error::other("disk full"))
        });
        let message = fault.unwrap_err().to_string();
        assert!(message.contains("matrix.csv") && message.contains("disk full"), "{message}");
        assert_eq!(fs::read(&file).unwrap(), b"first");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        replace_file(&file, |out| out.write_all(b"second")).unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"second");
    }
}
