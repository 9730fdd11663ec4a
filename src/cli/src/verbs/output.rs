//! Where results go: files replaced as a whole, or standard output for `-`.

use crate::report::replace_file;
use anyhow::{Context as _, bail};
use std::io::Write as _;
use std::path::Path;

/// Whether the path stands for standard output.
pub fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// Makes sure, before long work, that files can be written to these paths.
///
/// # Errors
/// Where a path is a folder, or its folder is missing or cannot be written to.
pub fn check<'a>(paths: impl IntoIterator<Item = &'a Path>) -> anyhow::Result<()> {
    for path in paths.into_iter().filter(|p| !is_stdout(p)) {
        if path.is_dir() {
            bail!("cannot write {}: it is a folder; name a file in it", path.display());
        }
        let folder = path.parent().filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if !folder.is_dir() {
            bail!("cannot write {}: there is no folder {}; make it first", path.display(), folder.display());
        }
        if let Err(error) = tempfile::Builder::new().prefix(".dashpot-").tempfile_in(folder) {
            bail!("cannot write {}: the folder {} refuses files ({})", path.display(), folder.display(), error.kind());
        }
    }
    Ok(())
}

/// Writes text or bytes to a file, or to standard output where the path is `-`.
pub fn write(path: &Path, text: impl AsRef<[u8]>) -> anyhow::Result<()> {
    if is_stdout(path) {
        let mut out = std::io::stdout().lock();
        out.write_all(text.as_ref())?;
        return Ok(out.flush()?);
    }
    replace_file(path, text.as_ref()).with_context(|| format!("cannot write {}", path.display()))
}

/// Writes a value as JSON.
pub fn json(path: &Path, value: &impl serde::Serialize) -> anyhow::Result<()> {
    let mut text = serde_json::to_string_pretty(value)?;
    text.push('\n');
    write(path, text)
}

/// Prints a line for people: on standard output, or on standard error where standard output carries `result`.
pub fn say(result: Option<&Path>, text: &str) -> anyhow::Result<()> {
    if result.is_some_and(is_stdout) {
        return Ok(writeln!(std::io::stderr().lock(), "{text}")?);
    }
    Ok(writeln!(std::io::stdout().lock(), "{text}")?)
}
