//! Where results go: files replaced as a whole, or standard output for `-`.

use crate::report::replace_file;
use anyhow::Context as _;
use std::io::Write as _;
use std::path::Path;

/// Writes `text` to a file, or to standard output where the path is `-`.
pub fn write(path: &Path, text: &str) -> anyhow::Result<()> {
    if path == Path::new("-") {
        let mut out = std::io::stdout().lock();
        out.write_all(text.as_bytes())?;
        return Ok(out.flush()?);
    }
    replace_file(path, text.as_bytes()).with_context(|| format!("cannot write {}", path.display()))
}

/// Writes a value as JSON.
pub fn json(path: &Path, value: &impl serde::Serialize) -> anyhow::Result<()> {
    let mut text = serde_json::to_string_pretty(value)?;
    text.push('\n');
    write(path, &text)
}

/// Prints a line for people: on standard output, or on standard error where standard output carries JSON.
pub fn say(json: Option<&Path>, text: &str) -> anyhow::Result<()> {
    if json == Some(Path::new("-")) {
        return Ok(writeln!(std::io::stderr().lock(), "{text}")?);
    }
    Ok(writeln!(std::io::stdout().lock(), "{text}")?)
}
