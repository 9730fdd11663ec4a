//! Tests that cannot run on a machine. Rust's test harness reports them as "ok", so each skipped test prints a separate
//! line. The last program of a whole test run (`tests/tests/what_was_skipped.rs`) counts the skipped tests.

use super::built::target_folder;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::fs::{self, OpenOptions};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Age after which the file of skipped tests of a test run is deleted, because the run has certainly ended.
const STALE: Duration = Duration::from_secs(24 * 3600);

/// Returns the path of the file that lists the skipped tests of this test run. Its name is the id of the parent
/// process, cargo.
fn notes() -> PathBuf {
    #[cfg(unix)]
    let run = std::os::unix::process::parent_id();
    #[cfg(not(unix))]
    let run = 0;
    target_folder().join("skipped").join(run.to_string())
}

/// Reports that this test cannot run here, with the reason.
///
/// The report appears on the terminal immediately, because the test harness does not capture it. A whole test run ends
/// with the count of skipped tests.
///
/// # Panics
/// If the file of skipped tests is not writable.
pub fn skipped(reason: impl Display) {
    let thread = std::thread::current();
    let program = std::env::current_exe().expect("the path of this test");
    let program = program.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let program = program.rsplit_once('-').map_or(&*program, |(name, _)| name);
    let line =
        format!("{program} {}\t{}\n", thread.name().unwrap_or("?"), reason.to_string().replace(['\n', '\t'], " "));
    let _ = write!(std::io::stderr(), "skipped: {}", line.replace('\t', ": "));
    note(&notes(), &line).expect("a note below the target directory");
}

fn note(file: &Path, line: &str) -> std::io::Result<()> {
    fs::create_dir_all(file.parent().expect("a folder"))?;
    OpenOptions::new().create(true).append(true).open(file)?.write_all(line.as_bytes())
}

/// Formats one line that counts this run's skipped tests, with the reasons. Deletes the list files of this run and of
/// runs that ended long ago.
#[must_use]
pub fn counted() -> String {
    taken(&notes())
}

fn taken(file: &Path) -> String {
    let text = fs::read_to_string(file).unwrap_or_default();
    let _ = fs::remove_file(file);
    // Other files belong to runs that were interrupted before their last program.
    for entry in file.parent().and_then(|folder| fs::read_dir(folder).ok()).into_iter().flatten().flatten() {
        let old = entry
            .metadata()
            .and_then(|m| m.modified())
            .is_ok_and(|t| SystemTime::now().duration_since(t).is_ok_and(|age| age > STALE));
        if old {
            let _ = fs::remove_file(entry.path());
        }
    }
    // A test that skips several parts counts once, and each of its reasons counts once.
    let mut lines: Vec<(&str, &str)> = text.lines().filter_map(|line| line.split_once('\t')).collect();
    lines.sort_unstable();
    lines.dedup();
    let mut tests: Vec<&str> = lines.iter().map(|(test, _)| *test).collect();
    tests.dedup();
    let mut reasons: BTreeMap<&str, usize> = BTreeMap::new();
    for (_, reason) in &lines {
        *reasons.entry(reason).or_default() += 1;
    }
    let reasons: Vec<String> = reasons.into_iter().map(|(reason, count)| format!("{count} × {reason}")).collect();
    match tests.len() {
        0 => "skipped: none, every test could run here".to_owned(),
        1 => format!("skipped: 1 test that cannot run here and counts as passed above: {}", reasons.join("; ")),
        count => {
            format!("skipped: {count} tests that cannot run here and count as passed above: {}", reasons.join("; "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tests_are_counted_once_and_their_notes_go() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("run").join("1");
        assert_eq!(taken(&file), "skipped: none, every test could run here");
        for line in ["cli a\tno wine\n", "cli b\tno wine\n", "cli b\tno octave\n", "cli a\tno wine\n"] {
            note(&file, line).unwrap();
        }
        assert_eq!(
            taken(&file),
            "skipped: 2 tests that cannot run here and count as passed above: 1 × no octave; 2 × no wine"
        );
        assert_eq!(taken(&file), "skipped: none, every test could run here");
    }
}
