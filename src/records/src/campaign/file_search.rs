//! Searches folders for the record files of a campaign.

use std::cmp::Ordering;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::profile::{self, Profile};
use crate::data::record::Note;
use crate::error::{RecordError, RecordFileError, SelectionError};
use crate::file_extensions::is_record_name;
use crate::glob;
use crate::messages::phrases;
use crate::options::Options;
use dashpot_messages::Sentence;

/// A file to be read, and its options.
pub(super) struct File {
    pub path: PathBuf,
    pub options: Arc<Options>,
    /// Prefix of the names of the tests in the file: path of its folder below the searched folder, with a final slash.
    /// It is empty for a file of the searched folder itself.
    pub within: String,
}

/// Files to be read and folders that [`find`] has found.
pub(super) struct Found {
    pub files: Vec<File>,
    /// Folders with a profile, and the options of the profile.
    pub folders: Vec<(PathBuf, Options)>,
    /// Folders whose subfolders contain records, although the user did not request subfolders.
    pub below: Vec<Below>,
    pub excluded: Excluded,
}

/// Patterns of the option `exclude` that match a name, and the number of files and tests that they exclude.
#[derive(Default)]
pub(super) struct Excluded {
    pub patterns: BTreeSet<String>,
    pub count: usize,
}

impl Excluded {
    /// Returns whether an `exclude` pattern of the options matches the name of a file or test. Counts a match and
    /// stores its patterns.
    pub fn takes(&mut self, options: &Options, name: &str) -> bool {
        let matching: Vec<&String> = options.exclude.iter().filter(|p| glob::matches(p, name)).collect();
        self.count += usize::from(!matching.is_empty());
        self.patterns.extend(matching.iter().map(|p| (*p).clone()));
        !matching.is_empty()
    }
}

/// Finds the record files of the paths: the files themselves and the files in the folders. Adds notes about profiles
/// and ignored files.
pub(super) fn find(paths: &[PathBuf], options: &Options, notes: &mut Vec<Note>) -> Result<Found, RecordError> {
    if paths.is_empty() {
        return Err(SelectionError::NoPaths.into());
    }
    let mut found = Found { files: Vec::new(), folders: Vec::new(), below: Vec::new(), excluded: Excluded::default() };
    let mut search = Search { given: options, found: &mut found, known: HashMap::new(), seen: HashSet::new(), notes };
    for path in paths {
        if !path.exists() {
            return Err(RecordFileError::NotFound { file: path.clone() }.into());
        }
        let own = search.options(&profile::folder_of(path), None)?;
        if path.is_dir() {
            search.folder(path, "", &own)?;
        } else {
            search.file(path.clone(), "", &own);
        }
    }
    Ok(found)
}

/// State of the search for the files of a campaign.
struct Search<'a> {
    given: &'a Options,
    found: &'a mut Found,
    /// The options of the folders visited so far.
    known: HashMap<PathBuf, Arc<Options>>,
    /// The canonical paths of the files and subfolders found, so that each counts once even if two paths lead to it.
    seen: HashSet<PathBuf>,
    notes: &'a mut Vec<Note>,
}

impl Search<'_> {
    /// Returns the options of a folder: the given options, completed by the folder's own profile. Without a profile,
    /// the options of the parent folder apply.
    fn options(&mut self, folder: &Path, above: Option<&Arc<Options>>) -> Result<Arc<Options>, RecordError> {
        if let Some(known) = self.known.get(folder) {
            return Ok(known.clone());
        }
        let own = match Profile::read(folder)? {
            Some(profile) => {
                // `Profile::read` has checked the profile, so its options are valid.
                let said = profile.options().unwrap_or_default();
                let file = folder.join(profile::FILE);
                let text = Sentence::from(phrases::PROFILE).with("file", file.display());
                self.notes.push(Note { kind: "profile", text });
                let own = Arc::new(self.given.over(&said));
                self.found.folders.push((folder.to_owned(), said));
                own
            }
            None => above.cloned().unwrap_or_else(|| Arc::new(self.given.clone())),
        };
        self.known.insert(folder.to_owned(), own.clone());
        Ok(own)
    }

    /// Adds the records of a folder, and those of its subfolders if requested.
    fn folder(&mut self, folder: &Path, within: &str, own: &Arc<Options>) -> Result<(), RecordError> {
        let (files, subfolders) = entries(folder, self.notes)?;
        let holds_none = files.is_empty();
        for file in files {
            self.file(file, within, own);
        }
        if holds_none && subfolders.is_empty() {
            return Err(SelectionError::EmptyFolder { folder: folder.to_owned() }.into());
        }
        if own.subfolders {
            for sub in subfolders {
                // Without this check, a link to a parent folder would be followed without end.
                if !self.seen.insert(std::fs::canonicalize(&sub).unwrap_or_else(|_| sub.clone())) {
                    continue;
                }
                let own = self.options(&sub, Some(own))?;
                self.folder(&sub, &format!("{within}{}/", file_name(&sub)), &own)?;
            }
        } else if !subfolders.is_empty() {
            let names = subfolders.iter().map(|sub| file_name(sub)).collect();
            let count = subfolders.iter().map(|sub| records_below(sub, DEEPEST)).sum();
            self.found.below.push(Below { folder: folder.to_owned(), names, count });
        }
        Ok(())
    }

    /// Adds a file, unless it was added before or a pattern excludes it.
    fn file(&mut self, path: PathBuf, within: &str, own: &Arc<Options>) {
        let place = std::fs::canonicalize(&path).unwrap_or_else(|_| path.clone());
        let name = file_name(&path);
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let mut names = vec![name.clone(), stem.clone()];
        if !within.is_empty() {
            names.extend([format!("{within}{name}"), format!("{within}{stem}")]);
        }
        if self.seen.insert(place) && !names.iter().any(|name| self.found.excluded.takes(own, name)) {
            self.found.files.push(File { path, options: own.clone(), within: within.to_owned() });
        }
    }
}

/// The subfolders with records of one folder, if the user did not request subfolders.
pub(super) struct Below {
    folder: PathBuf,
    names: Vec<String>,
    count: usize,
}

impl Below {
    pub fn note(&self) -> Note {
        let text = Sentence::from(phrases::BELOW)
            .with("folder", self.folder.display())
            .with("count", self.count)
            .with_names("names", &self.names, phrases::COMMA);
        Note { kind: "subfolders", text }
    }

    pub fn to_error(&self) -> RecordError {
        RecordError::Selection(SelectionError::InSubfolders {
            folder: self.folder.clone(),
            names: self.names.clone(),
            count: self.count,
        })
    }
}

/// Number of folder levels below a subfolder in which [`records_below`] searches for records. Campaigns are one or two
/// folders deep. The limit ends the search if a link points to a parent folder.
const DEEPEST: usize = 4;

/// Counts the files with the extension of a record, in a folder and in up to `deep` levels of its subfolders. Ignores
/// unreadable folders, hidden files and lock files of workbooks.
fn records_below(folder: &Path, deep: usize) -> usize {
    let Ok(within) = std::fs::read_dir(folder) else { return 0 };
    let count = |path: &Path| match () {
        () if is_passed_over(&file_name(path)) => 0,
        () if path.is_dir() => deep.checked_sub(1).map_or(0, |deep| records_below(path, deep)),
        () => usize::from(is_record_name(path)),
    };
    within.filter_map(Result::ok).map(|entry| count(&entry.path())).sum()
}

/// Returns whether the search skips a file or folder by its name: a hidden one, or the lock file of an open workbook.
fn is_passed_over(name: &str) -> bool {
    name.starts_with('.') || name.starts_with("~$")
}

/// Lists the record files and the subfolders with records in a folder, in natural order. Adds a note with the names of
/// the other entries, except hidden files, lock files, the profile, and the sealed folder of the virtual rig.
fn entries(folder: &Path, notes: &mut Vec<Note>) -> Result<(Vec<PathBuf>, Vec<PathBuf>), RecordError> {
    let unreadable = |source| RecordError::File(RecordFileError::Read { file: folder.to_owned(), source });
    let mut entries = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        entries.push(entry.map_err(unreadable)?.path());
    }
    entries.sort_by(|a, b| natural_order(&file_name(a), &file_name(b)));
    let (mut files, mut subfolders, mut ignored) = (Vec::new(), Vec::new(), Vec::new());
    for entry in entries {
        let name = file_name(&entry);
        // `Search::options` has read the profile, so it is not reported as ignored.
        let is_sealed = || name == profile::SEALED && profile::is_of_virtual_rig(folder);
        if is_passed_over(&name) || name == profile::FILE || is_sealed() {
            continue;
        }
        if entry.is_dir() {
            // The caller reads the subfolders with records or reports them, so they are not reported as ignored.
            if records_below(&entry, DEEPEST) == 0 {
                ignored.push(name);
            } else {
                subfolders.push(entry);
            }
        } else if is_record_name(&entry) {
            files.push(entry);
        } else {
            ignored.push(name);
        }
    }
    if !ignored.is_empty() {
        notes.push(Note {
            kind: "ignored",
            text: Sentence::from(phrases::STRAY).with("folder", folder.display()).with_names(
                "names",
                ignored,
                phrases::COMMA,
            ),
        });
    }
    Ok((files, subfolders))
}

pub(super) fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// Compares file names in natural order: digits compare as numbers, so `test2` precedes `test10`.
///
/// The crate `natord` compares digits after a leading zero as decimals, so it puts `t010` before `t9` and is not used.
pub(super) fn natural_order(a: &str, b: &str) -> Ordering {
    let (mut left, mut right) = (a.chars().peekable(), b.chars().peekable());
    loop {
        match (left.peek().copied(), right.peek().copied()) {
            (None, None) => return a.cmp(b),
            (None, _) => return Ordering::Less,
            (_, None) => return Ordering::Greater,
            (Some(x), Some(y)) if x.is_ascii_digit() && y.is_ascii_digit() => {
                let digits = |side: &mut std::iter::Peekable<std::str::Chars<'_>>| {
                    let mut text = String::new();
                    while let Some(c) = side.next_if(char::is_ascii_digit) {
                        text.push(c);
                    }
                    text.trim_start_matches('0').to_string()
                };
                let (x, y) = (digits(&mut left), digits(&mut right));
                let order = x.len().cmp(&y.len()).then_with(|| x.cmp(&y));
                if order != Ordering::Equal {
                    return order;
                }
            }
            (Some(x), Some(y)) => {
                let order = x.to_lowercase().cmp(y.to_lowercase()).then(x.cmp(&y));
                if x.to_lowercase().ne(y.to_lowercase()) {
                    return order;
                }
                left.next();
                right.next();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn natural_order_compares_numbers_as_numbers() {
        let mut names = ["t10", "t9", "T1", "t010a", "t", "s3", "t9.5", "t9.10"];
        names.sort_by(|a, b| natural_order(a, b));
        assert_eq!(names, ["s3", "t", "T1", "t9", "t9.5", "t9.10", "t10", "t010a"]);
    }
}
