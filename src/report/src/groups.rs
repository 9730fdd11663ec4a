//! The report on many dampers, or on one damper at many settings: `dashpot diagnose --group`.

use crate::blocks::{Block, Column, Figure, Section, Table};
use crate::diagnosis::changed_name;
use crate::numbers::fraction;
use crate::plot::axes::{Axis, Marks, Plane, Series};
use crate::plot::palette::Role;
use crate::words::Words;
use crate::{Cell, Made, Workbook, made};
use dashpot_core::{Model, Params};
use dashpot_diagnosis::groups::{GroupResult, GroupResults};
use dashpot_diagnosis::{Change, Diagnosis, Finding};
use dashpot_identification::Standing;
use dashpot_simulation::prediction::between_velocities;
use std::collections::BTreeMap;
use std::path::Path;

fn finding(finding: &Finding, words: &Words) -> String {
    words.fill(words.name_and_sure, &[("name", finding.effect), ("sure", &fraction(finding.confidence))])
}

/// Builds the report on all groups.
pub fn page(answers: &GroupResults, model: &Path, made: Made, words: &'static Words) -> Page {
    let mut first: Vec<Block> = curves(answers, words).map(Block::Wide).into_iter().collect();
    first.push(Block::Table(of_groups(answers, words)));
    let mut sections = vec![Section::new("groups", words.groups_section, first)];
    let changed = numbers(answers, words);
    if !changed.rows.is_empty() {
        let folded = Block::Folded(words.numbers_section.to_owned(), changed);
        sections.push(Section::new("numbers", words.numbers_section, vec![folded]));
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

/// Formats the name of a group. If the group has another reference than the first group, the name includes this reference.
fn label(answer: &GroupResult, answers: &GroupResults, words: &Words) -> String {
    if answer.reference == answers.reference {
        return answer.group.clone();
    }
    words.fill(words.group_against, &[("group", &answer.group), ("reference", &answer.reference)])
}

/// Builds a table with one row per group: its verdict and its errors.
fn of_groups(answers: &GroupResults, words: &Words) -> Table {
    let has_names = answers.groups.iter().any(|answer| !answer.diagnosis.findings.is_empty());
    let of_group = |answer: &GroupResult| {
        let names: Vec<String> = answer.diagnosis.findings.iter().map(|f| finding(f, words)).collect();
        let mut row: Vec<Cell> = vec![
            label(answer, answers, words).into(),
            Cell::count(answer.tests),
            words.say(&answer.diagnosis.summary).into(),
        ];
        row.extend(has_names.then(|| names.join(words.comma).into()));
        let (before, after) = (&answer.diagnosis.before, &answer.diagnosis.after);
        row.extend([before.rmse_n, after.rmse_n, before.noise_n].map(|rms| Cell::digits(rms, 3)));
        row
    };
    let mut columns =
        vec![Column::words(words.col_group), Column::figures(words.col_tests), Column::sentences(words.col_answer)];
    columns.extend(has_names.then(|| Column::sentences(words.col_named)));
    columns.extend([words.col_before_n, words.col_after_n, words.col_group_noise].map(Column::figures));
    let rows = answers.groups.iter().map(of_group).collect();
    Table { caption: words.groups_caption.to_owned(), columns, rows, sortable: true }
}

/// Width and height of the figure of the FV curves, px, for the full width of a printed page.
const SIZE: [f64; 2] = [880.0, 400.0];
/// Number of groups with a distinct hue. Further groups are gray.
const HUES: usize = 8;

/// Draws the FV curves of all groups and of the reference in one figure. The curves include friction and gas force. The curve of a group
/// covers the velocity range of the group's tests. The curve of the reference covers the range of the first group that has a reference.
fn curves(answers: &GroupResults, words: &Words) -> Option<Figure> {
    let reach = |diagnosis: &Diagnosis| {
        let velocities = diagnosis.tests.iter().flat_map(|test| test.curves.velocity.iter().copied());
        velocities.fold((0.0f64, 0.0f64), |(low, high), v| (low.min(v), high.max(v)))
    };
    let line = |params: &Params, (low, high): (f64, f64)| -> Option<Vec<[f64; 2]>> {
        let model = Model::new(params).ok()?;
        Some(between_velocities(&model, low, high).into_iter().map(|[v, f]| [1e3 * v, f]).collect())
    };
    let first = answers.groups.iter().find_map(|a| Some((a.diagnosis.reference.as_ref()?, reach(&a.diagnosis))));
    let mut series: Vec<Series> = Vec::new();
    let mut names: Vec<String> = Vec::new();
    let mut add = |role: Role, name: &str, lines: Vec<Vec<[f64; 2]>>| {
        if lines.iter().any(|l| !l.is_empty()) {
            series.push(Series { role, label: "", lines, marks: Marks::Line });
            names.push(name.to_owned());
        }
    };
    let mut groups: Vec<(&str, Vec<[f64; 2]>)> = Vec::new();
    for answer in &answers.groups {
        groups.extend(line(&answer.diagnosis.improved, reach(&answer.diagnosis)).map(|l| (answer.group.as_str(), l)));
    }
    let rest = groups.split_off(groups.len().min(HUES));
    add(Role::Shadow, words.other_groups, rest.into_iter().map(|g| g.1).collect());
    if let Some((reference, reach)) = first {
        add(Role::Before, &answers.reference, line(reference, reach).into_iter().collect());
    }
    for (k, (name, points)) in groups.into_iter().enumerate() {
        add(Role::Group(k as u8), name, vec![points]);
    }
    if series.is_empty() {
        return None;
    }
    let all = || series.iter().flat_map(|s| &s.lines).flatten().copied();
    let plane = Plane {
        title: words.plot_group_curves.into(),
        x: Axis::around(words.axis_velocity, all().map(|p| p[0])),
        y: Axis::around(words.axis_force, all().map(|p| p[1])),
        series,
    };
    Some(Figure::new("group-curves", plane.draw_named(&names, SIZE, words)).saying(words.group_curves_caption))
}

/// Returns whether the records of a group determine a parameter, so that a comparison with the reference is valid. `velocity`, m/s, is that
/// of a point of the FV curve.
fn is_compared(diagnosis: &Diagnosis, parameter: &str, velocity: Option<f64>) -> bool {
    if diagnosis.reference.is_none() {
        return false;
    }
    match velocity {
        // A point beyond the velocities of the group's tests is extrapolated, so it is not compared.
        Some(v) => reaches(diagnosis.tests.iter().flat_map(|t| &t.curves.velocity).copied(), v),
        None => diagnosis.estimates.iter().any(|e| e.name == parameter && e.standing == Standing::Identified),
    }
}

/// Returns whether one of `velocities`, m/s, has the direction of `velocity` and at least its magnitude.
fn reaches(mut velocities: impl Iterator<Item = f64>, velocity: f64) -> bool {
    velocities.any(|of| of * velocity > 0.0 && of.abs() >= velocity.abs())
}

/// Builds the table of every parameter that changed in any group, for the reference and all groups.
fn numbers(answers: &GroupResults, words: &Words) -> Table {
    let mut numbers: BTreeMap<String, (&Change, &str, String)> = BTreeMap::new();
    for (answer, one) in answers.groups.iter().flat_map(|a| a.diagnosis.changes.iter().map(move |one| (a, one))) {
        numbers.entry(one.label()).or_insert_with(|| (one, &answer.reference, changed_name(one, words)));
    }
    let mut rows = Vec::new();
    for (name, (change, reference, called)) in &numbers {
        let first = [(*reference).into(), Cell::measured(change.reference, change.unit), Cell::none()];
        rows.push([Cell::from(called.as_str())].into_iter().chain(first).collect());
        for answer in &answers.groups {
            let there = answer.diagnosis.changes.iter().find(|c| c.label() == *name);
            let [value, interval] = match there {
                Some(c) => Cell::with_interval(c.value, c.low, c.high, c.unit, words),
                None if is_compared(&answer.diagnosis, change.name, change.velocity_m_s) => {
                    [words.no_change.into(), Cell::none()]
                }
                None => [words.not_compared.into(), Cell::none()],
            };
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

/// A report on groups: one HTML page, or a workbook of its tables.
pub struct Page {
    subtitle: String,
    sections: Vec<Section>,
    made: Made,
    words: &'static Words,
}

impl Page {
    /// Renders the report as HTML.
    pub fn render(&self) -> String {
        let mut sections = self.sections.clone();
        sections.push(made::section(&self.made, self.words));
        crate::render_sections(self.words.groups_title, &self.subtitle, &sections, self.words)
    }

    /// Returns the tables as a workbook.
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
    use super::reaches;

    #[test]
    fn a_point_beyond_the_tests_of_a_group_is_not_compared() {
        let velocities = [-0.3, 0.0, 0.5];
        let is_reached = |velocity| reaches(velocities.iter().copied(), velocity);
        assert!(is_reached(0.4) && is_reached(0.5) && is_reached(-0.3));
        assert!(!is_reached(0.6) && !is_reached(-0.4));
    }
}
