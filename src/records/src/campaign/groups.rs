//! Splits the data of many dampers, or of one damper at many settings, into groups: `dashpot diagnose --group`.

use super::group_list::{self, GroupList, ListError};
use super::loading::Campaign;
use super::rig_sign::agree_on_sign;
use super::unusable::Unusable;
use crate::data::record::{Note, Record};
use crate::error::RecordError;
use crate::glob::matches as glob_matches;
use crate::settings::assignment::note_settings_of_groups;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The records of one damper or setting.
#[derive(Debug)]
pub struct Group {
    /// Name of the group: the folder's name, the match of `{}` in the test names, or the entry in the list's column.
    pub name: String,
    /// Records of the group.
    pub records: Vec<Record>,
}

/// Data split into groups.
#[derive(Default)]
pub struct Split {
    /// The groups.
    pub groups: Vec<Group>,
    /// Names of the tests or folders without a group.
    pub left_aside: Vec<String>,
    /// Lines of a list that name none of the tests.
    pub without_test: Vec<String>,
    /// Files and tests that could not be used.
    pub unusable: Vec<Unusable>,
    /// Paths of all files that were read.
    pub files: Vec<PathBuf>,
    /// Notes about campaigns as a whole.
    pub notes: Vec<Note>,
}

/// Reason for which data cannot be split into groups.
#[derive(Debug, thiserror::Error)]
pub enum GroupError {
    /// The option `--group` is none of the word `folders`, a pattern, or a list with a column.
    #[error(
        "--group takes the word folders, a pattern of the tests' names with {PLACE} once where the group stands and * for anything, such as \
         '*_c{PLACE}_*', or a list with a column, such as tests.csv:clicks; it is {by:?}"
    )]
    NoWay {
        /// The given value of the option.
        by: String,
    },
    /// The folder cannot be read.
    #[error("{folder}")]
    Folder {
        /// Path of the folder.
        folder: PathBuf,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// The data contain no folder of a damper.
    #[error("--group folders: there is no folder in {data}; put the records of each damper into one")]
    NoFolders {
        /// The paths of the data, as text.
        data: String,
    },
    /// No test matches the pattern.
    #[error("--group {pattern:?} matches no test; the first is called {first:?}")]
    NoMatch {
        /// The pattern of the option `--group`.
        pattern: String,
        /// Name of the first test in the data, as an example.
        first: String,
    },
    /// The list names none of the tests.
    #[error("--group {list}: the list gives no test of the data a group; the first is called {first:?}")]
    NotListed {
        /// The list and its column, as in the option `--group`.
        list: String,
        /// Name of the first test in the data, as an example.
        first: String,
    },
    /// The list is invalid.
    #[error(transparent)]
    List(#[from] ListError),
    /// The records cannot be read.
    #[error(transparent)]
    Read(#[from] RecordError),
}

/// Function that reads record files and folders as one campaign, always with the same options.
pub type Read<'a> = dyn Fn(&[PathBuf]) -> Result<Campaign, RecordError> + 'a;

/// Placeholder for the name of the group in a pattern.
const PLACE: &str = "{}";

/// Splits the data of a laboratory into groups, each of one damper or setting.
///
/// The groups are the folders in the data (`folders`), parts of the test names (a pattern with `{}`), or entries of a
/// list's column (`FILE.csv:COLUMN`).
///
/// `read` reads the files of one campaign. The groups and their `reference` come from one rig, so uncertain positive
/// directions are adapted to the most certain one.
///
/// # Errors
/// An option of another form, unreadable folders or records, data without folders, or an invalid list. Also a pattern
/// or list that matches no test.
pub fn split(
    data: &[PathBuf],
    by: &str,
    read: &Read<'_>,
    reference: Option<&mut Campaign>,
) -> Result<Split, GroupError> {
    let mut split = match (by, group_list::named(by)) {
        ("folders", _) => by_folders(data, read, reference)?,
        (_, Some((path, column))) => by_list(data, &GroupList::read(path, column)?, read, reference)?,
        _ if by.matches(PLACE).count() == 1 => by_name(data, by, read, reference)?,
        _ => return Err(GroupError::NoWay { by: by.to_owned() }),
    };
    // If each folder is a separate campaign, its notes already concern a single group. Otherwise, replace the note
    // about several settings by one for each group that has several settings.
    if by != "folders" {
        note_settings_of_groups(split.groups.iter().map(|group| group.records.as_slice()), &mut split.notes);
    }
    // Sort the groups by value if all their names are numbers, such as pressures, clicks and serial numbers.
    let number = |group: &Group| group.name.replace(',', ".").parse::<f64>().ok();
    if split.groups.iter().all(|g| number(g).is_some()) {
        split.groups.sort_by(|a, b| number(a).unwrap_or(0.0).total_cmp(&number(b).unwrap_or(0.0)));
    }
    Ok(split)
}

/// Returns the subfolders of the data paths, sorted by path.
fn folders_in(data: &[PathBuf]) -> Result<Vec<PathBuf>, GroupError> {
    let mut folders: Vec<PathBuf> = Vec::new();
    for path in data {
        let within = std::fs::read_dir(path).map_err(|source| GroupError::Folder { folder: path.clone(), source })?;
        folders.extend(within.filter_map(|entry| entry.ok().map(|e| e.path())).filter(|p| p.is_dir()));
    }
    folders.sort();
    Ok(folders)
}

impl Split {
    /// Moves files, notes and unusable tests of a campaign into the split. Returns the records of the campaign.
    fn without_records(&mut self, campaign: Campaign) -> Vec<Record> {
        self.files.extend(campaign.files);
        self.unusable.extend(campaign.unusable);
        self.notes.extend(campaign.notes);
        campaign.records
    }

    /// Sorts records into their groups and sets aside those without a group. If no record has a group, returns the name
    /// of the first record as the error.
    fn sort(
        &mut self,
        records: Vec<Record>,
        group_of: impl Fn(&Record) -> Option<String>,
        groups: &mut BTreeMap<String, Vec<Record>>,
    ) -> Result<(), String> {
        for record in records {
            match group_of(&record) {
                Some(name) => groups.entry(name).or_default().push(record),
                None => self.left_aside.push(record.name),
            }
        }
        if groups.is_empty() { Err(self.left_aside.first().cloned().unwrap_or_default()) } else { Ok(()) }
    }
}

fn by_folders(data: &[PathBuf], read: &Read<'_>, reference: Option<&mut Campaign>) -> Result<Split, GroupError> {
    let folders = folders_in(data)?;
    if folders.is_empty() {
        let data: Vec<String> = data.iter().map(|p| p.display().to_string()).collect();
        return Err(GroupError::NoFolders { data: data.join(", ") });
    }
    let mut split = Split::default();
    let campaigns = read_each(folders.iter(), read, reference)?;
    for (folder, campaign) in folders.iter().zip(campaigns) {
        let name = folder.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        let records = split.without_records(campaign);
        split.groups.push(Group { name, records });
    }
    Ok(split)
}

/// Reads each folder as one campaign. Adapts uncertain positive directions to the most certain one.
fn read_each<'a>(
    folders: impl Iterator<Item = &'a PathBuf>,
    read: &Read<'_>,
    reference: Option<&mut Campaign>,
) -> Result<Vec<Campaign>, RecordError> {
    let mut campaigns =
        folders.map(|folder| read(std::slice::from_ref(folder))).collect::<Result<Vec<Campaign>, RecordError>>()?;
    agree_on_sign(&mut campaigns.iter_mut().chain(reference).collect::<Vec<_>>());
    Ok(campaigns)
}

fn by_name(
    data: &[PathBuf],
    pattern: &str,
    read: &Read<'_>,
    reference: Option<&mut Campaign>,
) -> Result<Split, GroupError> {
    let mut groups: BTreeMap<String, Vec<Record>> = BTreeMap::new();
    let mut split = Split::default();
    let mut campaign = read(data)?;
    agree_on_sign(&mut std::iter::once(&mut campaign).chain(reference).collect::<Vec<_>>());
    let records = split.without_records(campaign);
    split
        .sort(records, |record| found(pattern, &record.name).map(str::to_owned), &mut groups)
        .map_err(|first| GroupError::NoMatch { pattern: pattern.to_owned(), first })?;
    split.groups = groups.into_iter().map(|(name, records)| Group { name, records }).collect();
    Ok(split)
}

fn by_list(
    data: &[PathBuf],
    list: &GroupList,
    read: &Read<'_>,
    reference: Option<&mut Campaign>,
) -> Result<Split, GroupError> {
    let mut groups: BTreeMap<String, Vec<Record>> = BTreeMap::new();
    let mut split = Split::default();
    let folders = list.folders(data)?;
    let (grouped, aside): (Vec<_>, Vec<_>) = folders.iter().partition(|(_, group)| !group.is_empty());
    split.left_aside.extend(aside.iter().map(|(folder, _)| folder.display().to_string()));
    let mut reference = reference;
    let campaigns = if grouped.is_empty() {
        Vec::new()
    } else {
        read_each(grouped.iter().map(|(folder, _)| folder), read, reference.take())?
    };
    for ((_, group), campaign) in grouped.iter().zip(campaigns) {
        let records = split.without_records(campaign);
        groups.entry((*group).to_owned()).or_default().extend(records);
    }
    if !folders.is_empty() {
        // The list and the data may name one folder by different paths, so canonical paths are compared.
        let place = |p: &Path| p.canonicalize().unwrap_or_else(|_| p.to_owned());
        let listed: Vec<PathBuf> = folders.iter().map(|(folder, _)| place(folder)).collect();
        let others = folders_in(data)?.into_iter().filter(|p| !listed.contains(&place(p)));
        split.left_aside.extend(others.map(|p| p.display().to_string()));
    } else {
        let mut campaign = read(data)?;
        agree_on_sign(&mut std::iter::once(&mut campaign).chain(reference).collect::<Vec<_>>());
        let records = split.without_records(campaign);
        split.without_test = list.without_test(&records.iter().collect::<Vec<_>>());
        split
            .sort(records, |record| list.group_of(record).map(str::to_owned), &mut groups)
            .map_err(|first| GroupError::NotListed { list: list.describe(), first })?;
    }
    split.groups = groups.into_iter().map(|(name, records)| Group { name, records }).collect();
    Ok(split)
}

/// Returns the shortest part of a name that matches `{}` in the pattern. Among parts of equal length, returns the
/// first.
fn found<'a>(pattern: &str, name: &'a str) -> Option<&'a str> {
    let (before, after) = pattern.split_once(PLACE)?;
    let places: Vec<usize> = name.char_indices().map(|(i, _)| i).chain([name.len()]).collect();
    let spans = places.iter().enumerate().flat_map(|(k, a)| places[k + 1..].iter().map(move |b| (*a, *b)));
    spans
        .filter(|(a, b)| glob_matches(before, &name[..*a]) && glob_matches(after, &name[*b..]))
        .min_by_key(|(a, b)| (b - a, *a))
        .map(|(a, b)| &name[a..b])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_group_is_what_stands_at_its_place_in_the_name() {
        for (pattern, name, group) in [
            ("*_c{}_*", "a25mm_c12_v0131", Some("12")),
            ("sn{}", "sn0041", Some("0041")),
            ("{}bar*", "20bar_a05", Some("20")),
            ("*_p{}", "a_p5_p7", Some("7")),
            ("*_c{}_*", "a25mm_v0131", None),
            ("sn{}", "sn", None),
            ("größe{}_*", "größe3_ä", Some("3")),
        ] {
            assert_eq!(found(pattern, name), group, "{pattern} {name}");
        }
    }
}
