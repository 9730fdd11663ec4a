//! Writing of files with the overwrite checks of the command.

use anyhow::Context as _;
use dashpot_output::Kind;
use std::path::Path;

/// Rejects a path if writing would replace a file of another kind.
pub fn checked(path: &Path, kind: Kind) -> anyhow::Result<()> {
    dashpot_output::check_kinds([(Some(path), kind)])
}

/// Writes a file, unless a file of another kind exists at the path.
pub fn write(path: &Path, kind: Kind, bytes: &[u8]) -> anyhow::Result<()> {
    checked(path, kind)?;
    dashpot_output::replace_file(path, bytes).with_context(|| format!("cannot write {}", path.display()))
}
