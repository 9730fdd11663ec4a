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
use dashpot_messages::Sentence;
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
    let notes = notes(answers, words);
    if !notes.is_empty() {
        sections.push(Section::new("notes", words.remarks, vec![Block::List(notes)]));
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

/// Returns the notes of all diagnoses: each once, after the groups that have it, unless all have it.
fn notes(answers: &GroupResults, words: &Words) -> Vec<String> {
    let mut notes: Vec<(&Sentence, Vec<String>)> = Vec::new();
    for answer in &answers.groups {
        for note in &answer.diagnosis.notes {
            let group = label(answer, answers, words);
            match notes.iter_mut().find(|(known, _)| *known == note) {
                Some((_, groups)) => groups.push(group),
                None => notes.push((note, vec![group])),
            }
        }
    }
    let format = |(note, groups): (&Sentence, Vec<String>)| {
        let text = words.say(note);
        if groups.len() == answers.groups.len() {
            return text;
        }
        words.fill(words.group_note, &[("groups", &groups.join(words.comma)), ("text", &text)])
    };
    notes.into_iter().map(format).collect()
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

/// Returns the lowest and the highest velocity of the tests of a group, m/s. Zero is always within.
fn reach(diagnosis: &Diagnosis) -> (f64, f64) {
    let velocities = diagnosis.tests.iter().flat_map(|test| test.curves.velocity.iter().copied());
    velocities.fold((0.0f64, 0.0f64), |(low, high), v| (low.min(v), high.max(v)))
}

/// Returns whether the records of a group determine a parameter, so that a comparison with the reference is valid. For a point of the FV
/// curve, `velocity` is its velocity, m/s. Otherwise, `velocity` is `None`.
fn is_compared(diagnosis: &Diagnosis, parameter: &str, velocity: Option<f64>) -> bool {
    if diagnosis.reference.is_none() {
        return false;
    }
    match velocity {
        // A point beyond the velocities of the group's tests is extrapolated, so it is not compared. A change of the whole curve has one
        // point in rebound and one in compression at the same speed. `velocity` is that of the point in rebound.
        Some(v) => reaches(reach(diagnosis), v) && (parameter != WHOLE_CURVE || reaches(reach(diagnosis), -v)),
        None => diagnosis.estimates.iter().any(|e| e.name == parameter && e.standing == Standing::Identified),
    }
}

/// Name of the change of the FV curve in both directions.
const WHOLE_CURVE: &str = "fv_curve";

/// Returns whether a motion with the lowest velocity `low` and the highest velocity `high` reaches `velocity` in the same direction.
fn reaches((low, high): (f64, f64), velocity: f64) -> bool {
    if velocity < 0.0 { velocity >= low } else { velocity <= high && high > 0.0 }
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
    for answer in &answers.groups {
        for (name, of) in answer.diagnosis.findings.iter().flat_map(|finding| &finding.parameters) {
            let [value, interval] = Cell::with_interval(of.value, of.low, of.high, of.unit, words);
            rows.push(vec![words.named(name).into(), answer.group.as_str().into(), value, interval]);
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
    use super::*;
    use crate::words::EN;
    use dashpot_core::number;
    use dashpot_diagnosis::{Curves, Figures, TestOutcome, Verdict};
    use dashpot_identification::Estimate;
    use dashpot_messages::Sentence;

    fn change(name: &'static str, velocity_m_s: Option<f64>) -> Change {
        let (reference, value, low, high) = (1000.0, 1300.0, 1280.0, 1320.0);
        Change { name, reference, value, low, high, unit: "N", velocity_m_s, probability: 0.99, force_n_rms: 100.0 }
    }

    fn estimate(name: &'static str, standing: Standing) -> Estimate {
        Estimate {
            name,
            index: None,
            value: 1.0,
            low: None,
            high: None,
            unit: "N",
            from: Sentence::default(),
            standing,
        }
    }

    /// Makes the result of a group whose tests have these velocities.
    fn group(group: &str, velocities: &[&[f64]], changes: Vec<Change>, estimates: Vec<Estimate>) -> GroupResult {
        let figures =
            Figures { rmse_n: 5.0, error_percent: 1.0, left_out_rmse_n: None, noise_n: 4.0, left_out_noise_n: None };
        let test = |velocity: &&[f64]| TestOutcome {
            test: "sine".to_owned(),
            left_out: false,
            before_rmse_n: 5.0,
            after_rmse_n: 5.0,
            noise_n: 4.0,
            allowed_n: 5.0,
            curves: Curves { velocity: velocity.to_vec(), ..Curves::default() },
        };
        let diagnosis = Diagnosis {
            verdict: Verdict::Changed,
            summary: Sentence::default(),
            findings: Vec::new(),
            inventory: Vec::new(),
            changes,
            suspects: Vec::new(),
            regions: Vec::new(),
            before: figures,
            after: figures,
            gap_closed: None,
            unexplained_fraction: 0.0,
            tree: Vec::new(),
            next_tests: Vec::new(),
            could_not_test: Vec::new(),
            shifts: Vec::new(),
            notes: Vec::new(),
            about_the_reference: None,
            tests: velocities.iter().map(test).collect(),
            iterations: Vec::new(),
            base: Params::new(),
            improved: Params::new(),
            reference: Some(Params::new()),
            estimates,
            measured: Vec::new(),
            priors: Default::default(),
            corrections: BTreeMap::new(),
        };
        GroupResult { group: group.to_owned(), reference: "good".to_owned(), tests: velocities.len(), diagnosis }
    }

    fn results(groups: Vec<GroupResult>) -> GroupResults {
        GroupResults {
            reference: "good".to_owned(),
            left_aside: Vec::new(),
            without_test: Vec::new(),
            unusable: Vec::new(),
            as_the_fit_saw: None,
            groups,
        }
    }

    #[test]
    fn a_velocity_is_reached_from_zero_to_the_end_of_the_range_in_its_direction() {
        let range = (-0.3, 0.5);
        for (velocity, is_reached) in [
            (0.4, true),
            (0.5, true),
            (0.500_001, false),
            (0.6, false),
            (-0.2, true),
            (-0.3, true),
            (-0.300_001, false),
            (-0.4, false),
            (f64::NAN, false),
        ] {
            assert_eq!(reaches(range, velocity), is_reached, "{velocity}");
        }
        // Motion in one direction alone shows nothing of the other.
        assert!(!reaches((0.0, 0.5), -0.001) && !reaches((-0.5, 0.0), 0.001) && !reaches((0.0, 0.0), 0.0));
    }

    #[test]
    fn the_reach_of_a_group_is_that_of_all_its_tests() {
        let of = |velocities: &[&[f64]]| reach(&group("a", velocities, Vec::new(), Vec::new()).diagnosis);
        assert_eq!(of(&[&[-0.1, 0.0, 0.2], &[-0.3, 0.1]]), (-0.3, 0.2));
        // The range of a test always includes zero, even if its velocity does not change its sign, as in a stroke in one direction.
        assert_eq!(of(&[&[0.1, 0.4]]), (0.0, 0.4));
        assert_eq!(of(&[]), (0.0, 0.0));
    }

    #[test]
    fn a_comparison_needs_a_reference_records_that_go_there_and_a_number_that_they_determine() {
        let determined = || {
            vec![
                estimate("gas_force", Standing::Identified),
                estimate("coulomb_force", Standing::NotIdentified),
                estimate("spring_linear", Standing::AtBound),
            ]
        };
        let mut own = group("a", &[&[-0.3, 0.5]], Vec::new(), determined()).diagnosis;
        let is = |own: &Diagnosis, name: &str, velocity| is_compared(own, name, velocity);
        assert!(is(&own, "rebound_curve", Some(0.5)) && is(&own, "compression_curve", Some(-0.3)));
        assert!(!is(&own, "rebound_high_speed", Some(1.0)) && !is(&own, "compression_high_speed", Some(-0.5)));
        // The change of the whole curve states the velocity in rebound, and concerns compression too.
        assert!(is(&own, "fv_curve", Some(0.3)) && !is(&own, "fv_curve", Some(0.4)));
        assert!(is(&own, "gas_force", None));
        for open in ["coulomb_force", "spring_linear", "oil_stiffness"] {
            assert!(!is(&own, open, None), "{open}");
        }
        own.reference = None;
        assert!(!is(&own, "rebound_curve", Some(0.1)) && !is(&own, "gas_force", None));
    }

    #[test]
    fn the_table_says_no_change_only_where_something_was_compared() {
        let gas = || vec![estimate("gas_force", Standing::Identified)];
        let changed = vec![change("rebound_high_speed", Some(1.0)), change("gas_force", None)];
        let answers = results(vec![
            group("fast", &[&[-1.1, 1.1]], changed, gas()),
            group("also_fast", &[&[-1.1, 1.1]], Vec::new(), gas()),
            group("slow", &[&[-0.9, 0.9]], Vec::new(), Vec::new()),
        ]);
        let table = numbers(&answers, &EN);
        let said: Vec<[&str; 3]> =
            table.rows.iter().map(|row| [0, 1, 2].map(|column| row[column].text.as_str())).collect();
        let of = |quantity: &str, group: &str| {
            let row = said.iter().find(|row| row[0].contains(quantity) && row[1] == group);
            row.unwrap_or_else(|| panic!("{quantity} {group} {said:?}"))[2]
        };
        for quantity in ["rebound_high_speed", "gas_force"] {
            assert_eq!(of(quantity, "good").replace('\u{a0}', " "), "1000 N");
            assert_eq!(of(quantity, "fast").replace('\u{a0}', " "), "1300 N");
            assert_eq!(of(quantity, "also_fast"), EN.no_change);
            assert_eq!(of(quantity, "slow"), EN.not_compared);
        }
    }

    #[test]
    fn curves_come_first_and_end_where_the_tests_of_their_group_end() {
        let mut far = group("far", &[&[-1.0, 1.0]], vec![change("gas_force", None)], Vec::new());
        far.diagnosis.improved.set(number!("gas_force"), 200.0).unwrap();
        let answers = results(vec![group("near", &[&[-0.2, 0.1]], Vec::new(), Vec::new()), far]);
        let made = Made { files: Vec::new(), ..Made::default() };
        let page = page(&answers, Path::new("good.toml"), made, &EN);
        let first = &page.sections[0].blocks;
        assert!(matches!(&first[0], Block::Wide(_)) && matches!(&first[1], Block::Table(_)));
        assert!(matches!(&page.sections[1].blocks[0], Block::Folded(..)));
        let Block::Table(table) = &first[1] else { panic!() };
        assert!(table.columns.iter().any(|column| column.heading == EN.col_answer && column.wraps));
        let html = page.render();
        // The folded table is open in print.
        assert!(html.contains("class=\"whole\"") && html.contains("beforeprint"));
        assert_eq!(reach(&answers.groups[0].diagnosis), (-0.2, 0.1));
    }
}
