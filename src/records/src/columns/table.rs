//! Builds the samples of the tests from a header and rows of cells, for all file formats.

use std::collections::HashMap;

use super::heading::{
    Heading, HeadingUnit, by_unit, heading, is_plain, is_setpoint, is_stopgap, nearest, nearest_to, unit_of_current,
    vocabulary, without_unit, written_unit,
};
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

/// Largest number of columns of a table. A rig records tens of columns. The limit bounds the comparisons of headings
/// with channels.
pub(crate) const MOST_COLUMNS: usize = 4096;

/// Assignment of columns to channels.
#[derive(Debug, Clone)]
pub(crate) struct Layout {
    pub columns: Vec<Column>,
    pub test: Option<usize>,
    ignored: Vec<String>,
    /// Columns assigned to a channel by their unit alone.
    guessed: Vec<(Channel, String)>,
    /// Columns in a unit of current of a table without a recognized setting: heading and unit.
    unread_currents: Vec<(String, String)>,
    /// Time between samples that the user gives for files without a time column, s.
    step: Option<f64>,
}

/// One column that is read.
#[derive(Debug, Clone)]
pub(crate) struct Column {
    pub channel: Channel,
    pub index: usize,
    pub unit: Unit,
    pub heading: String,
    /// Whether the column contains times of day.
    pub clock: bool,
}

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

/// Returns names for the columns of a table without a header.
pub(crate) fn numbered(columns: usize) -> Vec<String> {
    (1..=columns).map(|n| format!("column {n}")).collect()
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

fn same(wanted: &str, text: &str) -> bool {
    wanted.trim().eq_ignore_ascii_case(text.trim())
}

/// Returns whether a name given by the user matches this heading, exactly or without its unit.
fn names(wanted: &str, text: &str) -> bool {
    same(wanted, text) || {
        let (wanted, text) = (without_unit(wanted), without_unit(text));
        !wanted.is_empty() && wanted == text
    }
}

/// Returns the channel of a heading, as named by the user or as recognized.
pub(crate) fn channel_of(text: &str, options: &Options) -> Option<Channel> {
    let named = options.columns.iter().find(|(_, wanted)| names(wanted, text)).map(|(channel, _)| *channel);
    named.or_else(|| match heading(text.trim()) {
        Heading::Channel(channel, _) => Some(channel),
        _ => None,
    })
}

/// Returns the column number if the user states a number instead of a heading. Columns count from 1.
pub(crate) fn column_number(wanted: &str) -> Option<usize> {
    wanted.trim().parse::<usize>().ok().filter(|n| *n > 0)
}

/// Returns the columns that match the user's name: the whole heading, else the heading without its unit, else the
/// number. Of several equal headings, the first counts. Several returned columns mean that the name is ambiguous.
fn wanted_column(wanted: &str, header: &[&str]) -> Vec<usize> {
    let at = |found: &dyn Fn(&str) -> bool| -> Vec<usize> { (0..header.len()).filter(|i| found(header[*i])).collect() };
    let exact = at(&|h| same(wanted, h));
    if let Some(first) = exact.first() {
        return vec![*first];
    }
    let by_name = at(&|h| names(wanted, h));
    if !by_name.is_empty() {
        return by_name;
    }
    column_number(wanted).filter(|n| *n <= header.len()).map(|n| n - 1).into_iter().collect()
}

fn maybe(near: Option<&str>) -> Option<Sentence> {
    near.map(|near| Sentence::from(phrases::MEANT).with("near", near))
}

/// Reads a number. `decimal_comma` also allows a decimal comma. Empty and not-a-number cells give NaN. Other texts give
/// `None`.
pub(crate) fn number(text: &str, decimal_comma: bool) -> Option<f64> {
    let text = text.trim();
    if let Ok(value) = text.parse::<f64>() {
        return Some(if value.is_finite() { value } else { f64::NAN });
    }
    // Handle a typographic minus sign, and the exponents that Fortran writes.
    if let Some(plain) = text.strip_prefix('\u{2212}') {
        return number(plain, decimal_comma).map(|value| -value);
    }
    if let Some((mantissa, exponent)) = text.split_once(['D', 'd'])
        && let (Some(mantissa), Ok(exponent)) = (number(mantissa, decimal_comma), exponent.parse::<i32>())
        && mantissa.is_finite()
    {
        return format!("{mantissa}e{exponent}").parse().ok().filter(|v: &f64| v.is_finite());
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
    let near = match (best, first) {
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

/// Largest number of columns that a message lists.
const LISTED: usize = 40;

impl Layout {
    /// Assigns the columns of a header to channels.
    ///
    /// `line` is the line of the header in the file, for messages. A column beyond the end of `units` has no unit.
    /// `sample_time_given` is true if the source states its own sample time and requires no time column.
    pub fn new<S: AsRef<str>>(
        at: &Place,
        line: usize,
        header: &[S],
        units: Option<&[S]>,
        options: &Options,
        sample_time_given: bool,
    ) -> Result<Layout, RecordError> {
        Layout::with_clock(at, line, header, units, options, sample_time_given, &|_| false)
    }

    /// Assigns the columns of a header to channels. `is_clock` returns whether a column contains times of day, which
    /// require no unit.
    pub fn with_clock<S: AsRef<str>>(
        at: &Place,
        line: usize,
        header: &[S],
        units: Option<&[S]>,
        options: &Options,
        sample_time_given: bool,
        is_clock: &dyn Fn(usize) -> bool,
    ) -> Result<Layout, RecordError> {
        if header.len() > MOST_COLUMNS {
            return Err(
                ColumnError::TooManyColumns { at: at.clone(), line, found: header.len(), most: MOST_COLUMNS }.into()
            );
        }
        let header: Vec<&str> = header.iter().map(|cell| cell.as_ref().trim().trim_start_matches('\u{feff}')).collect();
        let found = || {
            let listed = header.iter().take(LISTED).map(|h| format!("'{h}'")).collect::<Vec<_>>().join(", ");
            let more = header.len().saturating_sub(LISTED);
            if more > 0 { format!("{listed} and {more} more") } else { listed }
        };
        let headings: Vec<Heading> = header.iter().map(|h| heading(h)).collect();
        let below =
            |i: usize| units.and_then(|u| u.get(i)).map(|u| u.as_ref().trim().trim_matches(|c| "[]()".contains(c)));
        let headed = header.iter().zip(numbered(header.len())).any(|(own, number)| *own != number);
        let mut columns: Vec<Column> = Vec::new();
        let mut guessed = Vec::new();
        let mut without_unit = Vec::new();
        for channel in Channel::ALL {
            if options.ignore.contains(&channel) {
                continue;
            }
            let index = if let Some(wanted) = options.columns.get(&channel) {
                match wanted_column(wanted, &header)[..] {
                    [index] => Some(index),
                    // If the name of a test states a constant setting, the table has no setting column. The missing
                    // column is therefore no error here.
                    [] if channel == Channel::Setting => None,
                    [] => {
                        return Err(ColumnError::NoSuchColumn {
                            at: at.clone(),
                            line,
                            channel,
                            wanted: wanted.clone(),
                            found: found(),
                            near: maybe(nearest(wanted, header.iter().copied())),
                        }
                        .into());
                    }
                    ref several => return Err(several_columns(at, line, channel, &header, several)),
                }
            } else {
                let taken = |i: usize| {
                    options
                        .columns
                        .iter()
                        .any(|(other, wanted)| *other != channel && wanted_column(wanted, &header).contains(&i))
                };
                let mut candidates: Vec<usize> = headings
                    .iter()
                    .enumerate()
                    .filter(|(i, h)| matches!(h, Heading::Channel(c, _) if *c == channel) && !taken(*i))
                    .map(|(i, _)| i)
                    .collect();
                let speaks = |i: &usize| by_unit(header[*i], below(*i)) == Some(channel) && !taken(*i);
                let by_their_unit: Vec<usize> = (0..header.len()).filter(speaks).collect();
                let mut possible = candidates.clone();
                possible.extend(&by_their_unit);
                possible.sort_unstable();
                // A heading that contains only the quantity has precedence over a heading that also contains the
                // sensor. Of a pair such as `Force (V)` and `Force (kN)`, use the column with a unit of the quantity.
                prefer(&mut candidates, |i| !is_setpoint(header[i]));
                prefer(&mut candidates, |i| is_plain(header[i]) && !is_stopgap(header[i]));
                prefer(&mut candidates, |i| is_plain(header[i]));
                prefer(&mut candidates, |i| {
                    matches!(&headings[i], Heading::Channel(_, HeadingUnit::Known(u)) if u.dimension() == channel.dimension())
                        || units.is_some_and(|u| {
                            u.get(i)
                                .and_then(|u| u.as_ref().parse::<Unit>().ok())
                                .is_some_and(|u| u.dimension() == channel.dimension())
                        })
                });
                // If no heading names the channel, use the only column with a unit of the channel. For a displacement,
                // this requires that no column is a velocity.
                let wanted = match channel {
                    Channel::Displacement => {
                        !options.columns.contains_key(&Channel::Velocity)
                            && !headings.iter().any(|h| matches!(h, Heading::Channel(Channel::Velocity, _)))
                    }
                    _ => channel == Channel::Force,
                };
                if candidates.is_empty() && wanted {
                    candidates = by_their_unit;
                    if let [index] = candidates[..] {
                        guessed.push((channel, header[index].to_string()));
                    }
                }
                // A current may belong to any device, so only a column with a unit of current counts.
                let is_known = |i: &usize| {
                    let unit = unit_of(
                        at,
                        line,
                        channel,
                        header[*i],
                        &headings[*i],
                        units.map(|u| u.get(*i..).unwrap_or_default().iter()),
                        options,
                    );
                    matches!(unit, Ok(Some(_)))
                };
                if channel == Channel::Current && !(candidates.len() == 1 && candidates.iter().all(is_known)) {
                    continue;
                }
                // Several columns of clicks occur in a table of peaks or for two adjusters, so none of them is used.
                if channel == Channel::Setting && candidates.len() > 1 {
                    continue;
                }
                if candidates.len() > 1 {
                    return Err(several_columns(at, line, channel, &header, &possible));
                }
                candidates.first().copied()
            };
            let Some(index) = index else { continue };
            let clock = channel == Channel::Time && is_clock(index);
            let unit = if clock {
                Unit::Second
            } else {
                let below = units.map(|u| u.get(index..).unwrap_or_default().iter());
                match unit_of(at, line, channel, header[index], &headings[index], below, options)? {
                    Some(unit) => unit,
                    None => {
                        without_unit.push((channel, header[index].to_string()));
                        channel.example()
                    }
                }
            };
            // The name and unit of a setting follow from its heading, so a unit below the heading is added to it.
            let heading = match below(index).filter(|unit| !unit.is_empty()) {
                Some(unit)
                    if matches!(channel, Channel::Current | Channel::Setting)
                        && written_unit(header[index]).is_none() =>
                {
                    format!("{} [{unit}]", header[index])
                }
                _ => header[index].to_string(),
            };
            columns.push(Column { channel, index, unit, heading, clock });
        }
        let has = |channel| columns.iter().any(|c: &Column| c.channel == channel);
        let missing = if !has(Channel::Time) && !sample_time_given && options.sample_rate_hz.is_none() {
            Some(("time", Channel::Time))
        } else if !has(Channel::Force) && !options.ignore.contains(&Channel::Force) {
            Some(("force", Channel::Force))
        } else if !has(Channel::Displacement) && !has(Channel::Velocity) {
            Some(("displacement or velocity", Channel::Displacement))
        } else {
            None
        };
        if let Some((missing, example)) = missing {
            let free: Vec<&str> =
                (0..header.len()).filter(|i| columns.iter().all(|c| c.index != *i)).map(|i| header[i]).collect();
            let near = maybe(nearest_to(example, &free));
            let units = without_unit.iter().map(|(channel, _)| *channel).collect();
            return Err(ColumnError::MissingColumn {
                at: at.clone(),
                line,
                missing,
                example,
                found: found(),
                near,
                units,
            }
            .into());
        }
        if !without_unit.is_empty() {
            return Err(ColumnError::MissingUnit { at: at.clone(), line, columns: without_unit, headed }.into());
        }
        let test = headings.iter().position(|h| *h == Heading::Test);
        let ignored = (0..header.len())
            .filter(|i| !header[*i].is_empty() && Some(*i) != test && columns.iter().all(|c| c.index != *i))
            .filter(|i| !matches!(headings[*i], Heading::SampleTime(_) | Heading::SampleRate))
            .map(|i| header[i].to_string())
            .take(100)
            .collect();
        let has = |channel| columns.iter().any(|c: &Column| c.channel == channel);
        let is_read = has(Channel::Current) || has(Channel::Setting) || options.ignore.contains(&Channel::Current);
        let unread_currents = (0..if is_read { 0 } else { header.len() })
            .filter_map(|i| Some((header[i].to_owned(), unit_of_current(header[i], below(i))?.to_owned())))
            .take(LISTED)
            .collect();
        Ok(Layout {
            columns,
            test,
            ignored,
            guessed,
            unread_currents,
            step: options.sample_rate_hz.map(|rate| 1.0 / rate),
        })
    }
}

/// Makes the error that asks the user to select one of several columns.
fn several_columns(at: &Place, line: usize, channel: Channel, header: &[&str], several: &[usize]) -> RecordError {
    let headings = several.iter().take(LISTED).map(|i| header[*i].to_string()).collect();
    RecordError::Column(ColumnError::SeveralColumns { at: at.clone(), line, channel, headings })
}

/// Retains only the candidates for which `better` is true, if there are several candidates and some are better.
fn prefer(candidates: &mut Vec<usize>, better: impl Fn(usize) -> bool) {
    if candidates.len() > 1 && candidates.iter().any(|i| better(*i)) {
        candidates.retain(|i| better(*i));
    }
}

/// Returns the unit of a column, or `None` if no source states it. An unknown unit, or one of another quantity, is an
/// error.
fn unit_of<'a, S: AsRef<str> + 'a>(
    at: &Place,
    line: usize,
    channel: Channel,
    column: &str,
    heading: &Heading,
    mut units: Option<impl Iterator<Item = &'a S>>,
    options: &Options,
) -> Result<Option<Unit>, RecordError> {
    let unknown = |unit: &str| {
        RecordError::Column(ColumnError::UnknownUnit {
            at: at.clone(),
            line,
            column: column.to_string(),
            unit: unit.to_string(),
            channel,
        })
    };
    if channel == Channel::Setting {
        return Ok(Some(Unit::AsWritten));
    }
    if let Some(&unit) = options.units.get(&channel) {
        return if unit.dimension() == channel.dimension() { Ok(Some(unit)) } else { Err(unknown(unit.name())) };
    }
    match heading {
        Heading::Channel(_, HeadingUnit::Known(unit)) if unit.dimension() == channel.dimension() => {
            return Ok(Some(*unit));
        }
        Heading::Channel(_, HeadingUnit::Known(unit)) => return Err(unknown(unit.name())),
        Heading::Channel(_, HeadingUnit::Unknown(text)) => return Err(unknown(text)),
        _ => {}
    }
    // The heading of a column that the user selected may contain its unit: `Load Cell 1 [kN]`.
    let written = column.rsplit_once(['[', '(']).map(|(_, unit)| unit);
    let below = units.as_mut().and_then(|u| u.next()).map(|u| u.as_ref().trim()).filter(|u| !u.is_empty());
    let parsed = |text: &str| text.parse::<Unit>().ok().filter(|unit| unit.dimension() == channel.dimension());
    if let Some(unit) = written.and_then(parsed).or_else(|| below.and_then(parsed)) {
        return Ok(Some(unit));
    }
    if let Some(text) = below.or(written) {
        return Err(unknown(text.trim_matches(|c| "[]()".contains(c))));
    }
    Ok(None)
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
        for (column, unit) in &self.layout.unread_currents {
            let text = Sentence::from(phrases::UNREAD_CURRENT).with("column", column).with("unit", unit);
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
