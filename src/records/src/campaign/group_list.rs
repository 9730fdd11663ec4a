//! A laboratory's list that states the gas pressure, clicks or serial number of each test or damper folder.
//!
//! The list and its column are an option of the command: `dashpot diagnose --group tests.csv:clicks`.

use crate::columns::delimiter;
use crate::data::record::Record;
use crate::glob::matches as glob_matches;
use crate::source::read_small_text;
use ::csv::{ReaderBuilder, Trim};
use std::path::{Path, PathBuf};

/// Reason for which a [`GroupList`] is rejected.
#[derive(Debug, thiserror::Error)]
pub enum ListError {
    /// The file cannot be opened.
    #[error("--group: {file}")]
    Unreadable {
        /// Path of the list.
        file: PathBuf,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// The file is not a table.
    #[error("{file}")]
    Table {
        /// Path of the list.
        file: PathBuf,
        /// Error of the crate `csv`, with the line.
        source: ::csv::Error,
    },
    /// No column after the first has the requested heading.
    #[error("{file}: there is no column {column:?} behind the first, which names the tests; the columns are {}", columns.join(", "))]
    NoColumn {
        /// Path of the list.
        file: PathBuf,
        /// The requested heading.
        column: String,
        /// Headings of all columns of the list.
        columns: Vec<String>,
    },
    /// No line has both a name in the first column and an entry in the requested column.
    #[error("{file}: no line has a test in the first column and something under {column:?}")]
    Empty {
        /// Path of the list.
        file: PathBuf,
        /// The requested heading.
        column: String,
    },
    /// Some entries of the first column are folders, but another one is not.
    #[error("{file}: line {line}: {of:?} is no folder, as others of the first column are")]
    NoFolder {
        /// Path of the list.
        file: PathBuf,
        /// Number of the line with the entry that is not a folder.
        line: usize,
        /// The entry that is not a folder.
        of: String,
    },
}

/// A line of the list: the name of a test, file or folder, and its group.
#[derive(Debug)]
struct Entry {
    line: usize,
    of: String,
    group: String,
}

/// A laboratory's list, reduced to its first column and the selected column of groups.
#[derive(Debug)]
pub struct GroupList {
    path: PathBuf,
    column: String,
    entries: Vec<Entry>,
}

/// Splits the option `FILE.csv:COLUMN` into file and column. Returns `None` for other texts.
pub fn named(by: &str) -> Option<(&Path, &str)> {
    // Split at the last colon, because a Windows drive letter has a colon too.
    let (file, column) = by.rsplit_once(':')?;
    let path = Path::new(file);
    let is_list = path.extension().is_some_and(|e| ["csv", "txt"].iter().any(|ending| e.eq_ignore_ascii_case(ending)));
    (is_list && !column.trim().is_empty()).then_some((path, column.trim()))
}

impl GroupList {
    /// Reads a list: a heading, then one line for each test, file or folder, whose name is in the first column. In
    /// names of tests and files, `*` matches any text. `column` is the heading of the column with the groups. Commas,
    /// semicolons or tabs separate the columns.
    ///
    /// # Errors
    /// A file that cannot be read, a missing column, a line without the heading's number of entries, or no line with a
    /// group.
    pub fn read(path: &Path, column: &str) -> Result<GroupList, ListError> {
        let unreadable = |source| ListError::Unreadable { file: path.to_owned(), source };
        GroupList::of_text(&read_small_text(path).map_err(unreadable)?, path, column)
    }

    fn of_text(text: &str, path: &Path, column: &str) -> Result<GroupList, ListError> {
        let file = || path.to_owned();
        let table = |source| ListError::Table { file: file(), source };
        let text = text.trim_start_matches('\u{feff}');
        let separator = delimiter::detect(text.lines().next().unwrap_or_default());
        let mut rows = ReaderBuilder::new().delimiter(separator).trim(Trim::All).from_reader(text.as_bytes());
        let columns: Vec<String> = rows.headers().map_err(table)?.iter().map(str::to_owned).collect();
        let Some(place) = columns.iter().skip(1).position(|c| c.eq_ignore_ascii_case(column)) else {
            return Err(ListError::NoColumn { file: file(), column: column.to_owned(), columns });
        };
        let mut entries = Vec::new();
        for row in rows.records() {
            let row = row.map_err(table)?;
            let line = row.position().map_or(0, ::csv::Position::line) as usize;
            let cell = |k: usize| row.get(k).unwrap_or_default().to_owned();
            entries.push(Entry { line, of: cell(0), group: cell(place + 1) });
        }
        entries.retain(|e| !e.of.is_empty());
        if entries.iter().all(|e| e.group.is_empty()) {
            return Err(ListError::Empty { file: file(), column: column.to_owned() });
        }
        Ok(GroupList { path: path.to_owned(), column: column.to_owned(), entries })
    }

    /// Returns the folders that the list names, each with its group (empty if it has none). If the list names tests,
    /// the result is empty. Paths are relative to the list, to the data or to the working directory.
    ///
    /// # Errors
    /// A list that contains folders and an entry that is not a folder.
    pub fn folders(&self, data: &[PathBuf]) -> Result<Vec<(PathBuf, &str)>, ListError> {
        let beside = self.path.parent().unwrap_or(Path::new(""));
        let within = || std::iter::once(beside).chain(data.iter().map(PathBuf::as_path)).chain([Path::new("")]);
        let folder = |e: &Entry| within().map(|p| p.join(&e.of)).find(|p| p.is_dir());
        let found: Vec<(PathBuf, &str)> =
            self.entries.iter().filter_map(|e| Some((folder(e)?, e.group.as_str()))).collect();
        if found.is_empty() || found.len() == self.entries.len() {
            return Ok(found);
        }
        let other = self.entries.iter().find(|e| folder(e).is_none());
        let (line, of) = other.map_or((0, String::new()), |e| (e.line, e.of.clone()));
        Err(ListError::NoFolder { file: self.path.clone(), line, of })
    }

    /// Returns the group of a record, from the first line that names the record. Returns `None` if no line names it or
    /// the line has no group.
    pub fn group_of(&self, record: &Record) -> Option<&str> {
        let entry = self.entries.iter().find(|e| e.names(record))?;
        (!entry.group.is_empty()).then_some(entry.group.as_str())
    }

    /// Formats the lines that name none of the records.
    pub fn without_test(&self, records: &[&Record]) -> Vec<String> {
        let without = self.entries.iter().filter(|e| !records.iter().any(|r| e.names(r)));
        without.map(|e| format!("{} (line {})", e.of, e.line)).collect()
    }

    /// Formats the list and the column as in the option `--group`.
    pub fn describe(&self) -> String {
        format!("{}:{}", self.path.display(), self.column)
    }
}

impl Entry {
    /// Returns whether the entry names a record: by the name of its test, by a pattern, or by the name of its file.
    fn names(&self, record: &Record) -> bool {
        let of = self.of.replace('\\', "/");
        let file = of.rsplit('/').next().unwrap_or(&of);
        let stem = Path::new(file).file_stem().map_or(file, |s| s.to_str().unwrap_or(file));
        [of.as_str(), file, stem].iter().any(|name| *name == record.name || glob_matches(name, &record.name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(text: &str, column: &str) -> Result<GroupList, ListError> {
        GroupList::of_text(text, Path::new("tests.csv"), column)
    }

    fn record(name: &str) -> Record {
        Record { name: name.to_owned(), ..Record::default() }
    }

    #[test]
    fn the_option_names_a_file_and_a_column() {
        assert_eq!(named("tests.csv:clicks"), Some((Path::new("tests.csv"), "clicks")));
        assert_eq!(named(r"C:\rig\Liste.CSV:Druck [bar]"), Some((Path::new(r"C:\rig\Liste.CSV"), "Druck [bar]")));
        for other in ["folders", "*_c{}_*", "tests.csv:", "a:{}", "tests.csv"] {
            assert_eq!(named(other), None, "{other}");
        }
    }

    #[test]
    fn a_test_is_named_by_itself_by_its_file_or_by_a_pattern() {
        let list = list("\u{feff}Test;Serial;Clicks\na1;7;3\nrig/a2.csv;7;5\nb*;8;3\nc1;9;\n", "clicks").unwrap();
        let group = |name: &str| list.group_of(&record(name)).map(str::to_owned);
        assert_eq!(group("a1").as_deref(), Some("3"));
        assert_eq!(group("a2").as_deref(), Some("5"));
        assert_eq!(group("b17").as_deref(), Some("3"));
        // Test c1 has no entry in the column, and test d has no line.
        assert_eq!((group("c1"), group("d")), (None, None));
        let (a, b) = (record("a1"), record("b1"));
        assert_eq!(list.without_test(&[&a, &b]), ["rig/a2.csv (line 3)", "c1 (line 5)"]);
    }

    #[test]
    fn what_is_wrong_with_a_list_is_said() {
        let describe = |text: &str, column: &str| {
            let error = list(text, column).unwrap_err();
            let cause = std::error::Error::source(&error).map_or_else(String::new, ToString::to_string);
            format!("{error}: {cause}")
        };
        assert!(describe("test,clicks\na,1\n", "pressure").contains("the columns are test, clicks"));
        assert!(
            describe("test,clicks\na,1,2\n", "clicks").contains("line: 2"),
            "{}",
            describe("test,clicks\na,1,2\n", "clicks")
        );
        assert!(describe("test,clicks\na,\n", "clicks").contains("no line has a test"));
        assert!(GroupList::read(Path::new("none.csv"), "a").is_err());
    }
}
