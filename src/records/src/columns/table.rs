//! Builds the samples of the tests from a header and rows of cells, for all file formats.

use std::collections::HashMap;

use super::cell::number;
use super::crank;
use super::heading::{Heading, by_unit, heading, vocabulary};
use super::layout::{LISTED, Layout, MOST_COLUMNS, channel_of, names};
use crate::data::record::{Note, UNREAD_CURRENT};
use crate::data::samples::Samples;
use crate::data::test_metadata::TestMetadata;
use crate::dates::clock;
use crate::dates::file_dates::Dates;
use crate::error::{ColumnError, Place, RecordError, SampleError};
use crate::messages::phrases;
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use crate::source::{Budget, Exhausted};
use dashpot_messages::Sentence;

/// Number of lines at the top of a file that the search for the header covers.
pub(crate) const HEADER_WITHIN: usize = 60;

/// Returns whether a line of cells can be a header.
///
/// Two cells must be known headings, other than that of a current, or named in the options. If there is a time and no
/// cell is a number, a unit that indicates a channel also counts. A table without a time contains results instead of a
/// record.
pub(crate) fn is_header<S: AsRef<str>>(cells: &[S], options: &Options) -> bool {
    let cells = &cells[..cells.len().min(MOST_COLUMNS)];
    let known = cells.iter().filter(|c| {
        let text = c.as_ref().trim();
        matches!(heading(text), Heading::Channel(channel, _) if channel != Channel::Current)
            || options.columns.values().any(|wanted| names(wanted, text))
    });
    let known = known.count();
    let says = |channel| cells.iter().any(|c| by_unit(c.as_ref(), None) == Some(channel));
    let spoken_for = usize::from(says(Channel::Force)) + usize::from(says(Channel::Displacement));
    let figures = || cells.iter().any(|c| number(c.as_ref(), true).is_some_and(f64::is_finite));
    let timed = || {
        options.sample_rate_hz.is_some() || cells.iter().any(|c| channel_of(c.as_ref(), options) == Some(Channel::Time))
    };
    known >= 2 || (known + spoken_for >= 2 && timed() && !figures())
}

/// Returns whether a line of cells below the header is a row of units: no number, and at least one unit.
pub(crate) fn is_units_row<S: AsRef<str>>(cells: &[S]) -> bool {
    let mut units = 0;
    for cell in cells {
        let text = cell.as_ref().trim();
        if text.is_empty() {
            continue;
        }
        if number(text, true).is_some() {
            return false;
        }
        units += usize::from(text.parse::<Unit>().is_ok());
    }
    units > 0
}

/// Makes the error for a file without a known header. `cells` are the cells of its first line.
pub(crate) fn no_header<S: AsRef<str>>(at: &Place, cells: &[S]) -> RecordError {
    let line: Vec<&str> = cells.iter().map(AsRef::as_ref).collect();
    no_header_near(at, &line.join(", "), &[(1, line)])
}

/// Makes the error for a table without a heading. The error shows the line with the most recognized columns.
pub(crate) fn no_header_near<S: AsRef<str>>(at: &Place, first_line: &str, lines: &[(usize, Vec<S>)]) -> RecordError {
    let shortened = |text: &str| {
        let mut short: String = text.trim().chars().filter(|c| !c.is_control()).take(120).collect();
        if short.len() < text.trim().len() {
            short.push_str(" ...");
        }
        short
    };
    let understood = |cells: &[S]| -> Vec<(Channel, String)> {
        let of = |text: &str| match heading(text) {
            Heading::Channel(channel, _) => Some((channel, shortened(text))),
            _ => by_unit(text, None).map(|channel| (channel, shortened(text))),
        };
        cells.iter().take(MOST_COLUMNS).map(AsRef::as_ref).filter_map(of).collect()
    };
    // Of several lines with the largest number of recognized columns, use the first.
    let best = lines.iter().rev().map(|(line, cells)| (line, understood(cells))).max_by_key(|(_, known)| known.len());
    let first = lines.first();
    let figures =
        |cells: &[S]| cells.len() > 1 && cells.iter().all(|c| number(c.as_ref(), true).is_some_and(f64::is_finite));
    let angle = lines.iter().flat_map(|(_, cells)| cells).map(AsRef::as_ref).find(|cell| crank::is_angle(cell));
    let near = match (best, first) {
        _ if angle.is_some() => {
            Some(Sentence::from(phrases::ANGLE_ALONE).with("column", shortened(angle.unwrap_or_default())))
        }
        (Some((line, known)), _) if !known.is_empty() => {
            let said = |(channel, text): &(Channel, String)| {
                Sentence::from(phrases::TAKEN_FOR).with("column", text).with_sentence("channel", channel.message())
            };
            let known = known.iter().take(LISTED).map(said).collect();
            Some(Sentence::from(phrases::BEST_LINE).with("line", line).with_list("known", known, phrases::COMMA))
        }
        (_, Some((_, cells))) if figures(cells) => {
            let options = match cells.len() {
                2 => {
                    "--column displacement=1 --column force=2 --unit displacement=mm --unit force=N --sample-rate 1000"
                }
                _ => {
                    "--column time=1 --column displacement=2 --column force=3 --unit time=s --unit displacement=mm --unit force=N"
                }
            };
            Some(Sentence::from(phrases::FIGURES_ALONE).with("count", cells.len()).with("options", options))
        }
        _ => None,
    };
    RecordError::Column(ColumnError::Header {
        at: at.clone(),
        found: shortened(first_line),
        near,
        understood: vocabulary(),
    })
}

/// Rows of a table whose columns have one layout.
pub(crate) struct Rows {
    at: Place,
    name: String,
    layout: Layout,
    lines: Vec<usize>,
    values: Vec<Vec<f64>>,
    tests: Vec<usize>,
    names: Vec<String>,
    by_name: HashMap<String, usize>,
    notes: Vec<Note>,
    budget: Budget,
    /// Date and time of the table's time zero, as [`Samples::begins`]. A column of dates has precedence.
    pub begins: Option<f64>,
    /// Evidence for the order of day and month in the table's dates.
    pub dates: Dates,
    /// Metadata of the tests that the file states.
    pub about: TestMetadata,
}

impl Rows {
    pub fn new(at: Place, name: String, layout: Layout, budget: &Budget) -> Self {
        // If the budget is exhausted here, it stays exhausted, and the first row reports the error.
        let names = layout.columns.iter().map(|c| &c.heading).chain(&layout.ignored);
        let _ = budget.hold(512 + names.map(|name| name.len() as u64 + 64).sum::<u64>());
        let values = vec![Vec::new(); layout.columns.len()];
        Rows {
            at,
            name,
            layout,
            lines: Vec::new(),
            values,
            tests: Vec::new(),
            names: Vec::new(),
            by_name: HashMap::new(),
            notes: Vec::new(),
            budget: budget.clone(),
            begins: None,
            dates: Dates::default(),
            about: TestMetadata::default(),
        }
    }

    /// Returns whether there are no rows yet.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// Adds a note to the tests of these rows.
    pub fn note(&mut self, kind: &'static str, text: Sentence) {
        self.notes.push(Note { kind, text });
    }

    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Adds a row: one value per column of the layout in the file's units, and the text of the test column.
    ///
    /// # Errors
    /// The file has exhausted its budget.
    pub fn push(
        &mut self,
        line: usize,
        values: impl Iterator<Item = f64>,
        test: Option<&str>,
    ) -> Result<(), RecordError> {
        let numbers = 1 + self.values.len() as u64;
        self.charge(Budget::numbers(&self.budget, numbers))?;
        self.lines.push(line);
        for ((column, channel), value) in self.values.iter_mut().zip(&self.layout.columns).zip(values) {
            column.push(channel.unit.to_si(value));
        }
        if let Some(test) = test {
            // The rows of a test are mostly consecutive, so compare with the last test first.
            let test = test.trim();
            let index = match self.tests.last() {
                Some(&last) if self.names[last] == test => last,
                _ => match self.by_name.get(test) {
                    Some(&known) => known,
                    None => {
                        self.charge(self.budget.hold(2 * test.len() as u64 + 64))?;
                        self.names.push(test.to_string());
                        self.by_name.insert(test.to_string(), self.names.len() - 1);
                        self.names.len() - 1
                    }
                },
            };
            self.tests.push(index);
        }
        Ok(())
    }

    fn charge(&self, charged: Result<(), Exhausted>) -> Result<(), RecordError> {
        charged.map_err(|exhausted| exhausted.into_error(&self.at))
    }

    /// Returns the tests in the rows. Without a time column, the time step is that of the user, else `sample_time`, s,
    /// else 1 s. No rows are an error.
    pub fn finish(mut self, sample_time: Option<f64>) -> Result<Vec<Samples>, RecordError> {
        if self.lines.is_empty() {
            return Err(SampleError::NoData { at: self.at }.into());
        }
        let mut notes = std::mem::take(&mut self.notes);
        if !self.layout.ignored.is_empty() {
            let columns = Sentence::from(phrases::COLUMNS_NOT_READ);
            let text = columns.with_names("names", &self.layout.ignored, phrases::COMMA);
            notes.push(Note { kind: "ignored", text });
        }
        for (channel, column) in &self.layout.guessed {
            let text =
                Sentence::from(phrases::BY_UNIT).with("column", column).with_sentence("channel", channel.message());
            notes.push(Note { kind: "guessed", text });
        }
        for (column, unit, channel) in &self.layout.unread_settings {
            let is_current = *channel == Channel::Current;
            let phrase = if is_current { phrases::UNREAD_CURRENT } else { phrases::UNREAD_SETTING };
            let text = Sentence::from(phrase).with("column", column).with("unit", unit);
            notes.push(Note { kind: UNREAD_CURRENT, text });
        }
        let converted: Vec<Sentence> = self
            .layout
            .columns
            .iter()
            .filter(|c| c.unit.to_si(1.0) != 1.0)
            .map(|c| {
                Sentence::from(phrases::FROM_UNIT).with_sentence("channel", c.channel.message()).with("unit", c.unit)
            })
            .collect();
        if !converted.is_empty() {
            let text = Sentence::from(phrases::CONVERTED).with_list("channels", converted, phrases::COMMA);
            notes.push(Note { kind: "converted", text });
        }
        if let Some(index) = self.layout.columns.iter().position(|c| c.clock) {
            self.dates.resolve_column(&mut self.values[index]);
            self.begins = clock::from_first(&mut self.values[index]).or(self.begins);
            notes.push(Note { kind: "converted", text: phrases::TIME_OF_DAY.into() });
        }
        let groups: Vec<(String, Place, Option<Vec<usize>>)> = if self.layout.test.is_some() {
            let mut members = vec![Vec::new(); self.names.len()];
            for (row, &test) in self.tests.iter().enumerate() {
                members[test].push(row);
            }
            let place = |name: &str| Place { part: Some(format!("test '{name}'")), ..self.at.clone() };
            self.names.iter().zip(members).map(|(name, rows)| (name.clone(), place(name), Some(rows))).collect()
        } else {
            vec![(self.name.clone(), self.at.clone(), None)]
        };
        // Notes and metadata are stored with every test, so the budget counts them for every test.
        let beside = 256
            + notes.iter().map(|note| note.text.to_string().len()).sum::<usize>()
            + [&self.about.part, &self.about.serial, &self.about.tester, &self.about.rig]
                .into_iter()
                .flatten()
                .map(String::len)
                .sum::<usize>()
            + self.layout.columns.iter().map(|c| c.heading.len()).sum::<usize>();
        self.charge(self.budget.hold((groups.len() * beside) as u64))?;
        let mut columns = self.values;
        let mut tests = Vec::with_capacity(groups.len());
        for (name, at, rows) in groups {
            let mut take = |channel: Channel| {
                let index = self.layout.columns.iter().position(|c| c.channel == channel)?;
                Some(match &rows {
                    Some(rows) => rows.iter().map(|&r| columns[index][r]).collect::<Vec<f64>>(),
                    None => std::mem::take(&mut columns[index]),
                })
            };
            let lines: Vec<usize> = match &rows {
                Some(rows) => rows.iter().map(|&r| self.lines[r]).collect(),
                None => self.lines.clone(),
            };
            let time = take(Channel::Time).unwrap_or_else(|| {
                let step = self.layout.step.or(sample_time).unwrap_or(1.0);
                (0..lines.len()).map(|i| i as f64 * step).collect()
            });
            tests.push(Samples {
                at,
                name,
                lines,
                time,
                begins: self.begins,
                dates: self.dates.clone(),
                about: self.about.clone(),
                force: take(Channel::Force).unwrap_or_default(),
                displacement: take(Channel::Displacement),
                velocity: take(Channel::Velocity),
                side_force: take(Channel::SideForce),
                temperature: take(Channel::Temperature),
                current: take(Channel::Current),
                setting: take(Channel::Setting),
                headings: self.layout.columns.iter().map(|c| (c.channel, c.heading.clone())).collect(),
                units: self.layout.columns.iter().map(|c| (c.channel, c.unit)).collect(),
                notes: notes.clone(),
            });
        }
        Ok(tests)
    }
}
