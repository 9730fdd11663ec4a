//! The report over many dampers, or one at many settings: `dashpot diagnose --group`.

use crate::blocks::{Block, Column, Section, Table};
use crate::diagnosis::changed_name;
use crate::numbers::share;
use crate::words::Words;
use crate::{Cell, Made, Workbook, made};
use dashpot_diagnosis::Finding;
use dashpot_diagnosis::groups::{Answer, Answers};
use std::collections::BTreeMap;
use std::path::Path;

fn finding(finding: &Finding, words: &Words) -> String {
    words.fill(words.name_and_sure, &[("name", finding.effect), ("sure", &share(finding.confidence))])
}

/// The report for people.
pub fn page(answers: &Answers, model: &Path, made: Made, words: &'static Words) -> Page {
    let mut sections =
        vec![Section::new("groups", words.groups_section, vec![Block::Table(of_groups(answers, words))])];
    let changed = numbers(answers, words);
    if !changed.rows.is_empty() {
        sections.push(Section::new("numbers", words.numbers_section, vec![Block::Table(changed)]));
    }
    if let Some(text) = &answers.as_the_fit_saw {
        sections.push(Section::new("measurement", words.measurement_section, vec![Block::Warning(words.say(text))]));
    }
    let aside: Vec<Block> = [(words.aside, &answers.left_aside), (words.without_test, &answers.without_test)]
        .into_iter()
        .filter(|(_, list)| !list.is_empty())
        .map(|(text, list)| Block::Warning(words.fill(text, &[("tests", &list.join(words.comma))])))
        .collect();
    if !aside.is_empty() {
        sections.push(Section::new("aside", words.aside_section, aside));
    }
    if !answers.unusable.is_empty() {
        let why = answers.unusable.iter().map(|one| words.say(&one.why)).collect();
        sections.push(Section::new("unusable", words.remarks, vec![Block::List(why)]));
    }
    let model = model.display().to_string();
    let subtitle = words.fill(words.groups_subtitle, &[("model", &model), ("reference", &answers.reference)]);
    Page { subtitle, sections, made, words }
}

/// A row a group: its answer and its errors.
fn of_groups(answers: &Answers, words: &Words) -> Table {
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
        rows: answers.groups.iter().map(of_group).collect(),
        sortable: true,
    }
}

/// Every number that changed in any group, of the reference and of all groups.
fn numbers(answers: &Answers, words: &Words) -> Table {
    let mut numbers: BTreeMap<String, (f64, &str, String)> = BTreeMap::new();
    for one in answers.groups.iter().flat_map(|a| &a.diagnosis.changes) {
        numbers.entry(one.label()).or_insert_with(|| (one.reference, one.unit, changed_name(one, words)));
    }
    let mut rows = Vec::new();
    for (name, (reference, unit, called)) in &numbers {
        let first = [answers.reference.as_str().into(), Cell::measured(*reference, unit), Cell::none()];
        rows.push([Cell::from(called.as_str())].into_iter().chain(first).collect());
        for answer in &answers.groups {
            let there = answer.diagnosis.changes.iter().find(|c| c.label() == *name);
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
        crate::render_sections(self.words.groups_title, &self.subtitle, &sections, self.words)
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
