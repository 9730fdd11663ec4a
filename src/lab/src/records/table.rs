//! From a header and rows of cells to the samples of the tests they hold, whatever the file format.

use super::channel::{Channel, Heading, HeadingUnit, Unit, heading, vocabulary};
use super::error::{Place, RecordError};
use super::options::Options;
use super::record::Note;
use super::samples::Samples;

/// How many lines at the top of a file are searched for the header.
pub(crate) const HEADER_WITHIN: usize = 60;

/// Which column holds what.
#[derive(Debug)]
pub(crate) struct Layout {
    pub columns: Vec<Column>,
    pub test: Option<usize>,
    ignored: Vec<String>,
}

/// One column that is read.
#[derive(Debug, Clone)]
pub(crate) struct Column {
    pub channel: Channel,
    pub index: usize,
    pub unit: Unit,
    pub heading: String,
}

/// Whether a line of cells can be a header: two cells are headings known here or named in the options.
pub(crate) fn is_header<S: AsRef<str>>(cells: &[S], options: &Options) -> bool {
    let known = cells.iter().filter(|c| {
        let text = c.as_ref().trim();
        matches!(heading(text), Heading::Channel(..)) || options.columns.values().any(|wanted| same(wanted, text))
    });
    known.count() >= 2
}

/// Whether a line of cells below the header is a row of units: nothing but units, at least one of them.
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

fn same(wanted: &str, text: &str) -> bool {
    wanted.trim().eq_ignore_ascii_case(text.trim())
}

/// A number, also with a decimal comma where the delimiter allows one. Empty and not-a-number cells are NaN.
pub(crate) fn number(text: &str, decimal_comma: bool) -> Option<f64> {
    let text = text.trim();
    if let Ok(value) = text.parse::<f64>() {
        return Some(if value.is_finite() { value } else { f64::NAN });
    }
    if ["", "-", "--", "n/a", "na", "#n/a", "null", "#num!", "1.#qnan", "-1.#ind"]
        .iter()
        .any(|empty| text.eq_ignore_ascii_case(empty))
    {
        return Some(f64::NAN);
    }
    if decimal_comma && text.bytes().filter(|&b| b == b',').count() == 1 && !text.contains('.') {
        return text.replace(',', ".").parse().ok().filter(|v: &f64| v.is_finite());
    }
    None
}

/// The error for a file without a header known here.
pub(crate) fn no_header(at: &Place, first_line: &str) -> RecordError {
    let mut found: String = first_line.trim().chars().filter(|c| !c.is_control()).take(120).collect();
    if found.len() < first_line.trim().len() {
        found.push_str(" ...");
    }
    RecordError::Header { at: at.clone(), found, understood: vocabulary() }
}

impl Layout {
    /// Assigns the columns of a header to channels.
    ///
    /// `sample_time_given` is true where the source brings its own sample time, so that no time column is needed.
    pub fn new<S: AsRef<str>>(
        at: &Place,
        line: usize,
        header: &[S],
        units: Option<&[S]>,
        options: &Options,
        sample_time_given: bool,
    ) -> Result<Layout, RecordError> {
        let header: Vec<&str> = header.iter().map(|cell| cell.as_ref().trim().trim_start_matches('\u{feff}')).collect();
        let found = || header.iter().map(|h| format!("'{h}'")).collect::<Vec<_>>().join(", ");
        let headings: Vec<Heading> = header.iter().map(|h| heading(h)).collect();
        let mut columns = Vec::new();
        for channel in Channel::ALL {
            if options.ignore.contains(&channel) {
                continue;
            }
            let index = if let Some(wanted) = options.columns.get(&channel) {
                let index = header.iter().position(|h| same(wanted, h)).ok_or_else(|| RecordError::NoSuchColumn {
                    at: at.clone(),
                    line,
                    channel,
                    wanted: wanted.clone(),
                    found: found(),
                })?;
                Some(index)
            } else {
                let taken = |i: usize| {
                    options.columns.iter().any(|(other, wanted)| *other != channel && same(wanted, header[i]))
                };
                let mut candidates = headings
                    .iter()
                    .enumerate()
                    .filter(|(i, h)| matches!(h, Heading::Channel(c, _) if *c == channel) && !taken(*i))
                    .map(|(i, _)| i);
                let first = candidates.next();
                if let (Some(first), Some(second)) = (first, candidates.next()) {
                    return Err(RecordError::TwoColumns {
                        at: at.clone(),
                        line,
                        channel,
                        first: header[first].to_string(),
                        second: header[second].to_string(),
                    });
                }
                first
            };
            let Some(index) = index else { continue };
            let unit =
                unit_of(at, line, channel, header[index], &headings[index], units.map(|u| u[index..].iter()), options)?;
            columns.push(Column { channel, index, unit, heading: header[index].to_string() });
        }
        let has = |channel| columns.iter().any(|c: &Column| c.channel == channel);
        let missing = if !has(Channel::Time) && !sample_time_given {
            Some(("time", Channel::Time))
        } else if !has(Channel::Force) && !options.ignore.contains(&Channel::Force) {
            Some(("force", Channel::Force))
        } else if !has(Channel::Displacement) && !has(Channel::Velocity) {
            Some(("displacement or velocity", Channel::Displacement))
        } else {
            None
        };
        if let Some((missing, example)) = missing {
            return Err(RecordError::MissingColumn { at: at.clone(), line, missing, example, found: found() });
        }
        let test = headings.iter().position(|h| *h == Heading::Test);
        let ignored = (0..header.len())
            .filter(|i| !header[*i].is_empty() && Some(*i) != test && columns.iter().all(|c| c.index != *i))
            .filter(|i| !matches!(headings[*i], Heading::SampleTime(_)))
            .map(|i| header[i].to_string())
            .collect();
        Ok(Layout { columns, test, ignored })
    }
}

fn unit_of<'a, S: AsRef<str> + 'a>(
    at: &Place,
    line: usize,
    channel: Channel,
    column: &str,
    heading: &Heading,
    mut units: Option<impl Iterator<Item = &'a S>>,
    options: &Options,
) -> Result<Unit, RecordError> {
    let unknown = |unit: &str| RecordError::UnknownUnit {
        at: at.clone(),
        line,
        column: column.to_string(),
        unit: unit.to_string(),
        channel,
    };
    if let Some(&unit) = options.units.get(&channel) {
        return if unit.dimension() == channel.dimension() { Ok(unit) } else { Err(unknown(unit.name())) };
    }
    match heading {
        Heading::Channel(_, HeadingUnit::Known(unit)) if unit.dimension() == channel.dimension() => {
            return Ok(*unit);
        }
        Heading::Channel(_, HeadingUnit::Known(unit)) => return Err(unknown(unit.name())),
        Heading::Channel(_, HeadingUnit::Unknown(text)) => return Err(unknown(text)),
        _ => {}
    }
    // A column chosen by name may still carry its unit: `Load Cell 1 [kN]`.
    let written = column.rsplit_once(['[', '(']).map(|(_, unit)| unit);
    let below = units.as_mut().and_then(|u| u.next()).map(|u| u.as_ref().trim()).filter(|u| !u.is_empty());
    let parsed = |text: &str| text.parse::<Unit>().ok().filter(|unit| unit.dimension() == channel.dimension());
    if let Some(unit) = written.and_then(parsed).or_else(|| below.and_then(parsed)) {
        return Ok(unit);
    }
    if let Some(text) = below.or(written) {
        return Err(unknown(text.trim_matches(|c| "[]()".contains(c))));
    }
    Err(RecordError::MissingUnit {
        at: at.clone(),
        line,
        column: column.to_string(),
        channel,
        example: match channel {
            Channel::Time => "s",
            Channel::Displacement => "mm",
            Channel::Velocity => "m/s",
            Channel::Force | Channel::SideForce => "N",
            Channel::Temperature => "degC",
        },
    })
}

/// Rows collected under one layout.
pub(crate) struct Rows {
    at: Place,
    name: String,
    layout: Layout,
    lines: Vec<usize>,
    values: Vec<Vec<f64>>,
    tests: Vec<usize>,
    names: Vec<String>,
}

impl Rows {
    pub fn new(at: Place, name: String, layout: Layout) -> Self {
        let values = vec![Vec::new(); layout.columns.len()];
        Rows { at, name, layout, lines: Vec::new(), values, tests: Vec::new(), names: Vec::new() }
    }

    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Adds a row: one value per column of the layout in the file's units, and the text of the test column.
    pub fn push(&mut self, line: usize, values: impl Iterator<Item = f64>, test: Option<&str>) {
        self.lines.push(line);
        for ((column, channel), value) in self.values.iter_mut().zip(&self.layout.columns).zip(values) {
            column.push(channel.unit.to_si(value));
        }
        if let Some(test) = test {
            // Tests mostly come in blocks: look at the last one first.
            let test = test.trim();
            let index = match self.tests.last() {
                Some(&last) if self.names[last] == test => last,
                _ => self.names.iter().position(|n| n == test).unwrap_or_else(|| {
                    self.names.push(test.to_string());
                    self.names.len() - 1
                }),
            };
            self.tests.push(index);
        }
    }

    /// The tests that the rows hold. `sample_time` stands in for a missing time column.
    pub fn finish(self, sample_time: Option<f64>) -> Result<Vec<Samples>, RecordError> {
        if self.lines.is_empty() {
            return Err(RecordError::NoData { at: self.at });
        }
        let mut notes = Vec::new();
        if !self.layout.ignored.is_empty() {
            notes.push(Note { kind: "ignored", text: format!("columns not read: {}", self.layout.ignored.join(", ")) });
        }
        let converted: Vec<String> = self
            .layout
            .columns
            .iter()
            .filter(|c| c.unit.to_si(1.0) != 1.0)
            .map(|c| format!("{} from {}", c.channel, c.unit))
            .collect();
        if !converted.is_empty() {
            notes.push(Note { kind: "converted", text: format!("converted to SI: {}", converted.join(", ")) });
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
                let step = sample_time.unwrap_or(1.0);
                (0..lines.len()).map(|i| i as f64 * step).collect()
            });
            tests.push(Samples {
                at,
                name,
                lines,
                time,
                force: take(Channel::Force).unwrap_or_default(),
                displacement: take(Channel::Displacement),
                velocity: take(Channel::Velocity),
                side_force: take(Channel::SideForce),
                temperature: take(Channel::Temperature),
                notes: notes.clone(),
            });
        }
        Ok(tests)
    }
}
