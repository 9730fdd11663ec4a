//! Origin of a report: the data that a reader needs to reproduce the report.
//!
//! The origin consists of version, command, files with their hashes, and an optional date. No function reads the clock, so equal input
//! gives equal bytes.

use super::blocks::{Block, Column, Section, Table};
use crate::cells::Cell;
use crate::words::Words;
use anyhow::Context as _;
use sha2::{Digest as _, Sha256};
use std::io::Read as _;
use std::path::Path;

/// Identity of an input file: name, size and hash.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MadeFrom {
    /// Name of the file, as on the command line.
    pub name: String,
    /// Size in bytes.
    pub bytes: u64,
    /// SHA-256 of its content, hexadecimal.
    pub sha256: String,
}

/// Origin of a report.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Made {
    /// Version of dashpot.
    pub version: String,
    /// Date of the report, given by the user or by the environment variable `SOURCE_DATE_EPOCH`.
    pub date: Option<String>,
    /// The command line, with all its words as typed.
    pub command: String,
    /// The input files of the report.
    pub files: Vec<MadeFrom>,
}

impl Made {
    /// Describes results that this version of dashpot made from files. Files that are not readable are omitted.
    pub fn from_files<'a>(files: impl IntoIterator<Item = &'a Path>) -> Self {
        Self::of_known(files.into_iter().filter_map(MadeFrom::read).collect())
    }

    /// Describes results that this version of dashpot made from files that are already hashed.
    pub fn of_known(files: Vec<MadeFrom>) -> Self {
        Self { version: env!("CARGO_PKG_VERSION").to_owned(), files, ..Self::default() }
    }
}

/// Returns the date of a report: the given date, or the date of the environment variable `SOURCE_DATE_EPOCH`, or no date. The function does
/// not read the clock, so equal input gives an equal report.
///
/// # Errors
/// `SOURCE_DATE_EPOCH` is not a number of seconds.
pub fn date(given: Option<&str>) -> anyhow::Result<Option<String>> {
    match (given, std::env::var("SOURCE_DATE_EPOCH")) {
        (Some(date), _) => Ok(Some(date.to_owned())),
        (None, Ok(text)) => {
            let seconds = text.trim().parse();
            Ok(Some(day_of(seconds.with_context(|| format!("SOURCE_DATE_EPOCH is {text:?}, not seconds since 1970"))?)))
        }
        (None, Err(_)) => Ok(None),
    }
}

/// Quotes the words of a command and joins them to one line, which a POSIX shell splits into these words again.
pub fn command_line(words: impl IntoIterator<Item = String>) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./=,:+%@".contains(c);
    let quoted = |word: String| match () {
        () if !word.is_empty() && word.chars().all(plain) => word,
        () => format!("'{}'", word.replace('\'', "'\\''")),
    };
    words.into_iter().map(quoted).collect::<Vec<_>>().join(" ")
}

impl MadeFrom {
    /// Reads and hashes a file. Returns `None` if the file is not readable or no regular file.
    pub fn read(path: &Path) -> Option<Self> {
        if !std::fs::metadata(path).ok()?.is_file() {
            return None;
        }
        let mut file = std::fs::File::open(path).ok()?;
        let (mut hash, mut bytes) = (Sha256::new(), 0);
        let mut block = vec![0; 1 << 16];
        loop {
            let read = file.read(&mut block).ok()?;
            if read == 0 {
                break;
            }
            hash.update(&block[..read]);
            bytes += read as u64;
        }
        Some(Self { name: path.display().to_string(), bytes, sha256: hexadecimal(hash.finalize().as_slice()) })
    }

    /// Describes a file whose content is already in memory.
    pub fn of_content(name: &str, content: &[u8]) -> Self {
        let sha256 = hexadecimal(Sha256::digest(content).as_slice());
        Self { name: name.to_owned(), bytes: content.len() as u64, sha256 }
    }
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).collect()
}

/// Anchor of the section on the origin.
pub(crate) const ID: &str = "made";

/// Lists version, date and command, and instructions to reproduce the report. With several input files, adds the SHA-256 of the list of
/// their hashes.
pub(crate) fn lines(made: &Made, words: &Words) -> Vec<String> {
    let mut lines = vec![words.fill(words.made_version, &[("version", &made.version)])];
    lines.extend(made.date.as_ref().map(|date| words.fill(words.made_date, &[("date", date)])));
    if !made.command.is_empty() {
        lines.push(words.fill(words.made_command, &[("command", &made.command)]));
    }
    lines.push(words.made_again.to_owned());
    if made.files.len() > 1 {
        let listed: String = made.files.iter().map(|f| format!("{}  {}\n", f.sha256, f.name)).collect();
        let (count, hash) = (made.files.len().to_string(), hexadecimal(Sha256::digest(listed.as_bytes()).as_slice()));
        lines.push(words.fill(words.made_all, &[("count", &count), ("hash", &hash)]));
    }
    lines
}

/// Largest number of files whose hashes the page shows and prints. A longer table is collapsed, and the list of lines contains the joint
/// hash of all files.
const MANY: usize = 100;

/// Builds the section on the origin of a report, its last section.
pub fn section(made: &Made, words: &Words) -> Section {
    let mut blocks: Vec<Block> = vec![Block::List(lines(made, words))];
    let row = |f: &MadeFrom| vec![f.name.as_str().into(), Cell::count(f.bytes as usize), f.sha256.as_str().into()];
    if !made.files.is_empty() {
        let table = Table {
            caption: words.made_files.to_owned(),
            columns: vec![Column::words(words.col_file), Column::figures(words.col_bytes), Column::words("SHA-256")],
            rows: made.files.iter().map(row).collect(),
            sortable: false,
        };
        blocks.push(match made.files.len() {
            0..=MANY => Block::Table(table),
            _ => Block::Folded(words.made_files.to_owned(), table),
        });
    }
    Section::new(ID, words.made_section, blocks)
}

/// Converts seconds since 1970-01-01 00:00 UTC to a day of the Gregorian calendar, formatted as `YYYY-MM-DD`.
pub fn day_of(seconds: u64) -> String {
    // In this calculation, years begin on 1 March, counted from year 0, so that a leap day ends a year (H. Hinnant, chrono-compatible
    // low-level date algorithms).
    let days = seconds / 86_400 + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    let year = 400 * era + year_of_era + u64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hash_is_that_of_sha256sum() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        std::fs::write(&path, "abc").unwrap();
        let file = MadeFrom::read(&path).unwrap();
        // The expected hash is the hash of the one-block example in FIPS 180-4.
        assert_eq!(file.sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        assert_eq!(file.bytes, 3);
        assert_eq!(MadeFrom::of_content(&path.display().to_string(), b"abc"), file);
        assert!(MadeFrom::read(&folder.path().join("b")).is_none());
    }

    #[test]
    fn a_command_line_is_taken_apart_into_its_words() {
        let line = |words: &[&str]| command_line(words.iter().map(ToString::to_string));
        assert_eq!(line(&["dashpot", "fit", "a*.csv", "", "it's"]), r"dashpot fit 'a*.csv' '' 'it'\''s'");
        assert_eq!(line(&["--unit", "force=kN", "±2.csv"]), "--unit force=kN '±2.csv'");
    }

    #[test]
    fn days_are_those_of_the_calendar() {
        for (seconds, day) in [
            (0, "1970-01-01"),
            (951_782_400, "2000-02-29"),
            (1_735_689_599, "2024-12-31"),
            (4_107_542_400, "2100-03-01"),
        ] {
            assert_eq!(day_of(seconds), day);
        }
    }
}
