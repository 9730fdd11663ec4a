//! Output of results, for all commands: files, which are replaced as a whole and only by their own kind, or standard
//! output for `-`.

mod format;
mod guard;
mod inputs;
mod kind;
mod lock;
mod replace;
mod run;
mod stdout;
mod terminal;

use anyhow::{Context as _, bail};
use replace::{folder_of, try_folder, write_file};
use std::io::Write as _;
use std::path::{Path, PathBuf};

pub use format::format_once;
pub use guard::set_force;
pub use inputs::register as register_inputs;
pub use kind::{AUTHOR, GENERATOR, Kind, WRITTEN};
pub use lock::FolderLock;
pub use replace::replace_file;
pub use run::as_a_run;
pub use stdout::closed as stdout_closed;
pub use terminal::{printable, warn};

/// Returns whether a path denotes standard output.
pub fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// Names the target of an output in a sentence: its path, or standard output for `-`.
pub fn target_name(path: &Path) -> String {
    if is_stdout(path) { "standard output".to_owned() } else { path.display().to_string() }
}

/// Checks, before long work, that these paths can be written without loss of other files.
///
/// # Errors
/// A path is a folder, an input, a device or write-protected, two paths are equal, or a folder is missing or not
/// writable.
pub fn check<'a>(paths: impl IntoIterator<Item = &'a Path>) -> anyhow::Result<()> {
    check_each(paths.into_iter().map(|path| (path, None)))
}

/// Checks outputs and their kinds before long work, and rejects an existing file of another kind.
///
/// # Errors
/// The errors of [`check`], or an existing file of another kind.
pub fn check_kinds<'a>(outputs: impl IntoIterator<Item = (Option<&'a Path>, Kind)>) -> anyhow::Result<()> {
    check_each(outputs.into_iter().filter_map(|(path, kind)| path.map(|path| (path, Some(kind)))))
}

fn check_each<'a>(outputs: impl Iterator<Item = (&'a Path, Option<Kind>)>) -> anyhow::Result<()> {
    let mut seen: Vec<PathBuf> = Vec::new();
    for (path, kind) in outputs.filter(|(p, _)| !is_stdout(p)) {
        let named = || format!("cannot write {}", path.display());
        let folder = folder_of(path);
        if !folder.is_dir() {
            bail!("{}: there is no folder {}; make it first", named(), folder.display());
        }
        let guard::Target::File(file) = guard::target(path, kind.as_ref()).with_context(named)? else { continue };
        let folder = folder_of(&file);
        if let Err(error) = try_folder(folder) {
            bail!("{}: the folder {} refuses files ({})", named(), folder.display(), error.kind());
        }
        let place = std::fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
        let place = place.join(file.file_name().unwrap_or_default());
        if seen.contains(&place) {
            bail!("{}: two results would go to this file; give each its own", named());
        }
        seen.push(place);
    }
    Ok(())
}

/// Writes text or bytes to a file, or to standard output if the path is `-`.
pub fn write(path: &Path, text: impl AsRef<[u8]>) -> anyhow::Result<()> {
    if is_stdout(path) {
        let mut out = std::io::stdout().lock();
        return out.write_all(text.as_ref()).and_then(|()| out.flush()).context("cannot write to standard output");
    }
    write_file(path, text.as_ref())
}

/// Makes a folder for results, if it does not exist.
///
/// # Errors
/// The system's error, with the folder.
pub fn make_folder(folder: &Path) -> anyhow::Result<()> {
    std::fs::create_dir_all(folder).with_context(|| format!("making the folder {}", folder.display()))
}

/// Writes a value as JSON.
pub fn json(path: &Path, value: &impl serde::Serialize) -> anyhow::Result<()> {
    let mut text = serde_json::to_string_pretty(value)?;
    text.push('\n');
    write(path, text)
}

/// Prints a message on standard output, or on standard error if `result` goes to standard output.
pub fn say(result: Option<&Path>, text: &str) -> anyhow::Result<()> {
    if result.is_some_and(is_stdout) {
        return terminal::warn_or_fail(text);
    }
    terminal::line(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_names_standard_output_and_any_other_target_by_its_path() {
        assert_eq!(target_name(Path::new("-")), "standard output");
        assert_eq!(target_name(Path::new("a/b.csv")), Path::new("a/b.csv").display().to_string());
    }
}
