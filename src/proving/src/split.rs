//! Splits of the seeds: one for calibration, one for development, one locked for published figures.
//!
//! Results on seeds that were used in development are biased. The ledger issues seeds of the locked split and records
//! them, so that no seed is issued twice.

use std::path::{Path, PathBuf};

/// A range of seeds for one purpose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Split {
    /// Seeds for the values in `calibration.toml` and the divisors of the log evidence in the search (its
    /// temperatures).
    Calibrate,
    /// Seeds for development.
    Check,
    /// Seeds that are issued once for a published result.
    Locked,
}

/// Number of seeds of a split.
const SIZE: u64 = 1_000_000;
/// Number of seeds in one issue of the locked split. It is larger than any suite.
const OPENING: u64 = 10_000;
/// First seed of the splits. Smaller seeds were used before the splits existed.
const OLD: u64 = SIZE;

impl Split {
    /// Returns the split with a name, or `None` if no split has this name.
    pub fn named(name: &str) -> Option<Split> {
        match name {
            "calibrate" => Some(Split::Calibrate),
            "check" => Some(Split::Check),
            "locked" => Some(Split::Locked),
            _ => None,
        }
    }

    /// Returns the first seed of the split.
    pub fn first_seed(self) -> u64 {
        match self {
            Split::Calibrate => OLD,
            Split::Check => OLD + SIZE,
            Split::Locked => OLD + 2 * SIZE,
        }
    }
}

/// Record of the issued seeds of the locked split, in a file of the project.
#[derive(Debug)]
pub struct Ledger {
    path: PathBuf,
    text: String,
}

impl Ledger {
    /// Reads the ledger of the project. Its folder is determined at run time, because a compiled-in path would reveal
    /// the build folder in every package.
    ///
    /// # Errors
    /// Returns an error if Cargo did not start this program, or if the file cannot be read.
    pub fn of_the_project() -> std::io::Result<Ledger> {
        let folder = std::env::var_os("CARGO_MANIFEST_DIR").ok_or_else(|| {
            std::io::Error::new(std::io::ErrorKind::NotFound, "run this with cargo, which says where the project is")
        })?;
        Ledger::read(&Path::new(&folder).join("ledger.toml"))
    }

    /// Reads a ledger.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read.
    pub fn read(path: &Path) -> std::io::Result<Ledger> {
        Ok(Ledger { path: path.to_owned(), text: std::fs::read_to_string(path)? })
    }

    /// Returns the first seeds of all issues.
    pub fn opened(&self) -> Vec<u64> {
        let first = |line: &str| line.strip_prefix("first_seed = ").and_then(|v| v.trim().parse().ok());
        self.text.lines().filter_map(first).collect()
    }

    /// Issues unused seeds and returns the first one. The entry is written before the first case runs.
    ///
    /// # Errors
    /// Returns an error if the file cannot be replaced.
    pub fn open(&mut self, for_what: &str) -> std::io::Result<u64> {
        let first = self.opened().into_iter().map(|s| s + OPENING).fold(Split::Locked.first_seed(), u64::max);
        let what = for_what.replace(['"', '\\'], " ");
        self.text += &format!("\n[[opened]]\nfirst_seed = {first}\nfor = \"{what}\"\n");
        let folder = self.path.parent().unwrap_or(Path::new("."));
        let mut file = tempfile::NamedTempFile::new_in(folder)?;
        std::io::Write::write_all(&mut file, self.text.as_bytes())?;
        file.persist(&self.path).map_err(|e| e.error)?;
        Ok(first)
    }
}

/// Returns the first seed that the arguments of an example request by `split=NAME`, or `None` without such an argument.
/// A request for the locked split issues unused seeds and records them in the ledger.
///
/// # Errors
/// Returns an error for an unknown split, for a request for the locked split without a purpose, or if the ledger cannot
/// be written.
pub fn first_seed(args: &[String]) -> Result<Option<u64>, String> {
    let Some(asked) = args.iter().find_map(|a| a.strip_prefix("split=")) else { return Ok(None) };
    let (name, purpose) = asked.split_once('=').unwrap_or((asked, ""));
    match (Split::named(name), purpose) {
        (None, _) => Err(format!("there is no split {name}: calibrate, check or locked")),
        (Some(Split::Locked), "") => {
            Err("say what the locked split is opened for: split=locked=\"README, table 1\"".to_owned())
        }
        (Some(Split::Locked), purpose) => {
            let mut ledger = Ledger::of_the_project().map_err(|e| format!("ledger.toml: {e}"))?;
            ledger.open(purpose).map(Some).map_err(|e| format!("ledger.toml: {e}"))
        }
        (Some(split), _) => Ok(Some(split.first_seed())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_opening_is_written_down_and_its_seeds_never_come_again() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("ledger.toml");
        std::fs::write(&path, "# what was opened\n").unwrap();
        let mut ledger = Ledger::read(&path).unwrap();
        let first = ledger.open("a \"figure\"").unwrap();
        let second = Ledger::read(&path).unwrap().open("another").unwrap();
        assert_eq!((first, second), (Split::Locked.first_seed(), Split::Locked.first_seed() + OPENING));
        assert_eq!(Ledger::read(&path).unwrap().opened(), [first, second]);
    }

    #[test]
    fn the_projects_own_ledger_is_in_order() {
        let opened = Ledger::of_the_project().unwrap().opened();
        assert!(opened.windows(2).all(|w| w[1] >= w[0] + OPENING), "{opened:?}");
        assert!(opened.iter().all(|s| *s >= Split::Locked.first_seed()));
    }
}
