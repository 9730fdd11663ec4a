//! Many dampers, or one at many settings, each against the same reference: `dashpot diagnose --group`.

use super::data::DataArgs;
use super::group_list::{self, GroupList};
use anyhow::bail;
use dashpot_diagnosis::{Change, Diagnosis, Finding};
use dashpot_records::glob::matches as glob_matches;
use dashpot_records::{Record, Sentence, Unusable};
use dashpot_report::blocks::{Block, Column, Section, Table};
use dashpot_report::diagnosis::changed_name;
use dashpot_report::numbers::{share, with_interval, with_unit};
use dashpot_report::words::{TERMINAL, Words};
use dashpot_report::{Cell, Made, Workbook, made};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The records of one damper or setting.
#[derive(Debug)]
pub struct Group {
    /// Its name: that of the folder, what the pattern found in the names of its tests, or what the list has in its column.
    pub name: String,
    /// Its records.
    pub records: Vec<Record>,
}

/// Data split into groups.
#[derive(Default)]
pub struct Split {
    /// The groups.
    pub groups: Vec<Group>,
    /// Tests, or folders, that belong to none.
    pub left_aside: Vec<String>,
    /// Lines of a list that name none of the tests.
    pub without_test: Vec<String>,
    /// Files and tests that could not be used.
    pub unusable: Vec<Unusable>,
    /// Every file read.
    pub files: Vec<PathBuf>,
}

/// What stands for the name of the group in a pattern.
const PLACE: &str = "{}";

/// Splits the data: by the folders in it, by a part of the tests' names, or by a column of a list.
///
/// # Errors
/// A pattern without `{}`, data without folders, a list without that column or without one of the tests, records that cannot be read.
pub fn split(data: &DataArgs, by: &str) -> anyhow::Result<Split> {
    let mut split = match (by, group_list::named(by)) {
        ("folders", _) => by_folders(data)?,
        (_, Some((path, column))) => by_list(data, &GroupList::read(path, column)?)?,
        _ if by.matches(PLACE).count() == 1 => by_name(data, by)?,
        _ => bail!(
            "--group takes the word folders, a pattern of the tests' names with {PLACE} once where the group stands and * for \
             anything, such as '*_c{PLACE}_*', or a list with a column, such as tests.csv:clicks; it is {by:?}"
        ),
    };
    // Pressures, clicks and serial numbers in the order of the number.
    let number = |group: &Group| group.name.replace(',', ".").parse::<f64>().ok();
    if split.groups.iter().all(|g| number(g).is_some()) {
        split.groups.sort_by(|a, b| number(a).unwrap_or(0.0).total_cmp(&number(b).unwrap_or(0.0)));
    }
    Ok(split)
}

/// The folders in the data, in the order of their names.
fn folders_in(data: &DataArgs) -> anyhow::Result<Vec<PathBuf>> {
    let mut folders: Vec<PathBuf> = Vec::new();
    for path in &data.data {
        let within = std::fs::read_dir(path).map_err(|e| anyhow::anyhow!("{}: {e}", path.display()))?;
        folders.extend(within.filter_map(|entry| entry.ok().map(|e| e.path())).filter(|p| p.is_dir()));
    }
    folders.sort();
    Ok(folders)
}

fn by_folders(data: &DataArgs) -> anyhow::Result<Split> {
    let folders = folders_in(data)?;
    if folders.is_empty() {
        bail!("--group folders: there is no folder in {}; put the records of each damper into one", data.named());
    }
    let mut split = Split::default();
    for folder in &folders {
        let name = folder.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        let campaign = data.load_like(std::slice::from_ref(folder))?;
        split.files.extend(campaign.files);
        split.unusable.extend(campaign.unusable);
        split.groups.push(Group { name, records: campaign.records });
    }
    Ok(split)
}

fn by_name(data: &DataArgs, pattern: &str) -> anyhow::Result<Split> {
    let mut groups: BTreeMap<String, Vec<Record>> = BTreeMap::new();
    let mut left = Vec::new();
    let campaign = data.load()?;
    for record in campaign.records {
        match found(pattern, &record.name) {
            Some(name) => groups.entry(name.to_owned()).or_default().push(record),
            None => left.push(record.name),
        }
    }
    if groups.is_empty() {
        bail!("--group {pattern:?} matches no test; the first is called {:?}", left.first().map_or("", String::as_str));
    }
    let groups = groups.into_iter().map(|(name, records)| Group { name, records }).collect();
    Ok(Split { groups, left_aside: left, unusable: campaign.unusable, files: campaign.files, ..Split::default() })
}

fn by_list(data: &DataArgs, list: &GroupList) -> anyhow::Result<Split> {
    let mut groups: BTreeMap<String, Vec<Record>> = BTreeMap::new();
    let mut split = Split::default();
    let folders = list.folders(&data.data)?;
    for (folder, group) in &folders {
        if group.is_empty() {
            split.left_aside.push(folder.display().to_string());
            continue;
        }
        let campaign = data.load_like(std::slice::from_ref(folder))?;
        split.files.extend(campaign.files);
        split.unusable.extend(campaign.unusable);
        groups.entry((*group).to_owned()).or_default().extend(campaign.records);
    }
    if !folders.is_empty() {
        // The list may lie elsewhere and name them by another way.
        let place = |p: &Path| p.canonicalize().unwrap_or_else(|_| p.to_owned());
        let listed: Vec<PathBuf> = folders.iter().map(|(folder, _)| place(folder)).collect();
        let others = folders_in(data)?.into_iter().filter(|p| !listed.contains(&place(p)));
        split.left_aside.extend(others.map(|p| p.display().to_string()));
    } else {
        let campaign = data.load()?;
        split.files = campaign.files;
        split.unusable = campaign.unusable;
        split.without_test = list.without_test(&campaign.records.iter().collect::<Vec<_>>());
        for record in campaign.records {
            match list.group_of(&record) {
                Some(name) => groups.entry(name.to_owned()).or_default().push(record),
                None => split.left_aside.push(record.name),
            }
        }
        if groups.is_empty() {
            let first = split.left_aside.first().map_or("", String::as_str);
            bail!("--group {}: the list gives no test of the data a group; the first is called {first:?}", list.said());
        }
    }
    split.groups = groups.into_iter().map(|(name, records)| Group { name, records }).collect();
    Ok(split)
}

/// The shortest part of a name that stands where the pattern has `{}`, the first of equals.
fn found<'a>(pattern: &str, name: &'a str) -> Option<&'a str> {
    let (before, after) = pattern.split_once(PLACE)?;
    let places: Vec<usize> = name.char_indices().map(|(i, _)| i).chain([name.len()]).collect();
    let spans = places.iter().enumerate().flat_map(|(k, a)| places[k + 1..].iter().map(move |b| (*a, *b)));
    spans
        .filter(|(a, b)| glob_matches(before, &name[..*a]) && glob_matches(after, &name[*b..]))
        .min_by_key(|(a, b)| (b - a, *a))
        .map(|(a, b)| &name[a..b])
}

/// The answer for one group.
#[derive(Debug, Serialize)]
pub struct Answer {
    /// Its name.
    pub group: String,
    /// Number of tests.
    pub tests: usize,
    /// The diagnosis against the reference.
    pub diagnosis: Diagnosis,
}

/// The answers for all groups. Its JSON form is what `dashpot diagnose --group` writes.
#[derive(Debug, Serialize)]
pub struct Answers {
    /// What they were compared with.
    pub reference: String,
    /// Tests that belong to no group.
    pub left_aside: Vec<String>,
    /// Lines of the list of groups that name none of the tests.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub without_test: Vec<String>,
    /// Files and tests that could not be used, of the reference too.
    pub unusable: Vec<Unusable>,
    /// What the model's fit found in its own records, and whether it was taken out of these.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub as_the_fit_saw: Option<Sentence>,
    /// Every group but the reference.
    pub groups: Vec<Answer>,
}

fn finding(finding: &Finding, words: &Words) -> String {
    words.fill(words.name_and_sure, &[("name", finding.effect), ("sure", &share(finding.confidence))])
}

fn change(change: &Change) -> String {
    let (value, interval) = with_interval(change.value, change.low, change.high, change.unit, &TERMINAL);
    format!("{value} (95 %: {interval})")
}

impl Answers {
    /// One line a group, and the numbers that changed in any of them.
    pub fn told(&self) -> Vec<String> {
        let mut lines = vec![format!("Compared with {}:", self.reference)];
        for answer in &self.groups {
            let names: Vec<String> = answer
                .diagnosis
                .findings
                .iter()
                .map(|f| format!("{} ({} sure)", f.effect, share(f.confidence)))
                .collect();
            let names = if names.is_empty() { answer.diagnosis.summary.to_string() } else { names.join(", ") };
            lines.push(format!("  {}: {} tests; {names}", answer.group, answer.tests));
            for one in &answer.diagnosis.changed {
                let before = with_unit(one.reference, one.unit);
                lines.push(format!("    {:<30} {before:>16} -> {}", one.name(), change(one)));
            }
        }
        lines.extend(self.as_the_fit_saw.iter().map(|text| format!("note: {text}")));
        if !self.left_aside.is_empty() {
            lines.push(format!(
                "note: {} tests belong to no group: {}",
                self.left_aside.len(),
                self.left_aside.join(", ")
            ));
        }
        if !self.without_test.is_empty() {
            lines.push(format!("note: the list names what is not in the data: {}", self.without_test.join(", ")));
        }
        lines
    }

    /// The report for people.
    pub fn page(&self, model: &Path, made: Made, words: &'static Words) -> Page {
        let mut sections =
            vec![Section::new("groups", words.groups_section, vec![Block::Table(self.of_groups(words))])];
        let numbers = self.numbers(words);
        if !numbers.rows.is_empty() {
            sections.push(Section::new("numbers", words.numbers_section, vec![Block::Table(numbers)]));
        }
        if let Some(text) = &self.as_the_fit_saw {
            sections.push(Section::new(
                "measurement",
                words.measurement_section,
                vec![Block::Warning(words.say(text))],
            ));
        }
        let aside: Vec<Block> = [(words.aside, &self.left_aside), (words.without_test, &self.without_test)]
            .into_iter()
            .filter(|(_, list)| !list.is_empty())
            .map(|(text, list)| Block::Warning(words.fill(text, &[("tests", &list.join(words.comma))])))
            .collect();
        if !aside.is_empty() {
            sections.push(Section::new("aside", words.aside_section, aside));
        }
        if !self.unusable.is_empty() {
            let why = self.unusable.iter().map(|one| words.say(&one.why)).collect();
            sections.push(Section::new("unusable", words.remarks, vec![Block::List(why)]));
        }
        let model = model.display().to_string();
        let subtitle = words.fill(words.groups_subtitle, &[("model", &model), ("reference", &self.reference)]);
        Page { subtitle, sections, made, words }
    }

    /// A row a group: its answer and its errors.
    fn of_groups(&self, words: &Words) -> Table {
        let of_group = |answer: &Answer| {
            let names: Vec<String> = answer.diagnosis.findings.iter().map(|f| finding(f, words)).collect();
            let rms = |value: f64| Cell::digits(value, 3);
            vec![
                answer.group.as_str().into(),
                Cell::count(answer.tests),
                words.say(&answer.diagnosis.summary).into(),
                names.join(words.comma).into(),
                rms(answer.diagnosis.before.rmse_n),
                rms(answer.diagnosis.after.rmse_n),
                rms(answer.diagnosis.before.noise_n),
            ]
        };
        Table {
            caption: words.groups_caption.to_owned(),
            columns: vec![
                Column::words(words.col_group),
                Column::figures(words.col_tests),
                Column::words(words.col_answer),
                Column::words(words.col_named),
                Column::figures(words.col_before_n),
                Column::figures(words.col_after_n),
                Column::figures(words.col_group_noise),
            ],
            rows: self.groups.iter().map(of_group).collect(),
            sortable: true,
        }
    }

    /// Every number that changed in any group, of the reference and of all groups.
    fn numbers(&self, words: &Words) -> Table {
        let mut numbers: BTreeMap<String, (f64, &str, String)> = BTreeMap::new();
        for one in self.groups.iter().flat_map(|a| &a.diagnosis.changed) {
            numbers.entry(one.name()).or_insert_with(|| (one.reference, one.unit, changed_name(one, words)));
        }
        let mut rows = Vec::new();
        for (name, (reference, unit, called)) in &numbers {
            let first = [self.reference.as_str().into(), Cell::measured(*reference, unit), Cell::none()];
            rows.push([Cell::from(called.as_str())].into_iter().chain(first).collect());
            for answer in &self.groups {
                let there = answer.diagnosis.changed.iter().find(|c| c.name() == *name);
                let [value, interval] = there.map_or_else(
                    || [words.no_change.into(), Cell::none()],
                    |c| Cell::with_interval(c.value, c.low, c.high, c.unit, words),
                );
                rows.push(vec![Cell::from(called.as_str()), answer.group.as_str().into(), value, interval]);
            }
        }
        Table {
            caption: words.numbers_caption.to_owned(),
            columns: vec![
                Column::words(words.col_quantity),
                Column::words(words.col_group),
                Column::figures(words.col_value),
                Column::figures(words.col_interval),
            ],
            rows,
            sortable: true,
        }
    }
}

/// A report over groups: one HTML page, or a workbook of its tables.
pub struct Page {
    subtitle: String,
    sections: Vec<Section>,
    made: Made,
    words: &'static Words,
}

impl Page {
    /// As HTML.
    pub fn render(&self) -> String {
        let mut sections = self.sections.clone();
        sections.push(made::section(&self.made, self.words));
        dashpot_report::render_sections(self.words.groups_title, &self.subtitle, &sections, self.words)
    }

    /// As a workbook.
    pub fn workbook(&self) -> Workbook<'static> {
        Workbook {
            title: self.words.groups_title.to_owned(),
            subtitle: self.subtitle.clone(),
            sections: self.sections.clone(),
            made: self.made.clone(),
            words: self.words,
        }
    }
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
