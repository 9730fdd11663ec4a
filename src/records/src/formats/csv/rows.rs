//! Reads the rows below a header.

use csv::{ByteRecord, ReaderBuilder};

use super::header_search::Start;
use super::lines::{is_comment, is_figure, is_whole, uncommented};
use super::repeated_headers::{Block, Blocks};
use crate::columns::cell::number;
use crate::columns::crank::{self, Crank};
use crate::columns::delimiter::{self, split};
use crate::columns::heading::{Heading, HeadingUnit, heading};
use crate::columns::layout::{Column, Layout, channel_of};
use crate::columns::non_data_lines::{LABELS, NonDataLines};
use crate::columns::table::{HEADER_WITHIN, Rows, is_units_row};
use crate::data::samples::Samples;
use crate::data::test_metadata::TestMetadata;
use crate::dates::clock;
use crate::dates::date_order::DateOrder;
use crate::dates::file_dates::Dates;
use crate::error::{Place, RecordError, SampleError};
use crate::messages::phrases;
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use crate::source::Budget;
use dashpot_messages::Sentence;

/// Lines from the header to the first row of a table.
struct Head<'a> {
    /// The line with the headings. Empty if the table has none.
    text: &'a str,
    units: Option<Vec<String>>,
    first_row: Vec<String>,
    /// Number of lines, other than comments, before the lines that may be rows.
    to_skip: usize,
}

impl<'a> Head<'a> {
    /// Reads the head from a text that begins with the line `start.index`.
    fn read(text: &'a str, start: &Start, decimal_comma: bool) -> Head<'a> {
        let mut lines = text.split_inclusive('\n');
        let header_text = if start.headed { lines.next().unwrap_or_default().trim_end() } else { "" };
        let mut lines = lines.peekable();
        let mut units = None;
        if start.commented {
            // If the heading is a comment, its units are in a comment too.
            let below = lines.peek().filter(|line| is_comment(line));
            units = below.map(|line| split(uncommented(line), start.delimiter)).filter(|cells| is_units_row(cells));
        }
        let mut below = lines.filter(|line| !is_comment(line)).map(|line| split(line.trim_end(), start.delimiter));
        let mut first_row = below.next().unwrap_or_default();
        let mut to_skip = usize::from(start.headed && !start.commented);
        if start.headed && units.is_none() && is_units_row(&first_row) {
            units = Some(std::mem::replace(&mut first_row, below.next().unwrap_or_default()));
            to_skip += 1;
        }
        if let Some(units) = &mut units {
            units.resize(start.header.len(), String::new());
        }
        // Sensor names and rates may be between the heading and the first row, so such lines are skipped.
        for _ in 0..LABELS {
            if first_row.iter().any(|cell| !cell.trim().is_empty() && is_figure(cell, decimal_comma)) {
                break;
            }
            first_row = below.next().unwrap_or_default();
        }
        Head { text: header_text, units, first_row, to_skip }
    }

    /// Returns the likely order of day and month. Programs that write a decimal comma, or a semicolon as delimiter,
    /// write dates with the day first.
    fn likely_date_order(&self, delimiter: u8) -> Option<DateOrder> {
        let is_comma = |cell: &String| delimiter != b',' && cell.contains(',') && number(cell, true).is_some();
        (delimiter == b';' || self.first_row.iter().any(is_comma)).then_some(DateOrder::DayFirst)
    }
}

/// Reads the tests of a table whose header was found.
pub(super) fn table(
    at: &Place,
    name: &str,
    text: &str,
    mut start: Start,
    options: &Options,
    budget: &Budget,
) -> Result<Vec<Samples>, RecordError> {
    let (above, table) = text.split_at(start.offset);
    let decimal_comma = start.delimiter != b',' || delimiter::quotes_decimal_commas(table);
    let mut head = Head::read(table, &start, decimal_comma);
    let timed = start.header.iter().any(|h| channel_of(h, options) == Some(Channel::Time));
    let crank = if timed { None } else { crank::find(&mut start.header, head.units.as_mut(), above.lines()) };
    let step = options.sample_rate_hz.map(|rate| 1.0 / rate).or_else(|| sample_time(above.lines()));
    let is_clock = |index: usize| {
        let cell = head.first_row.get(index);
        cell.is_some_and(|cell| number(cell, decimal_comma).is_none() && clock::seconds(cell).is_some())
    };
    let (header_line, units) = (start.index + 1, head.units.as_deref());
    let layout = Layout::with_clock(at, header_line, &start.header, units, options, step.is_some(), &is_clock)?;
    let mut rows = Rows::new(at.clone(), name.to_string(), layout, budget);
    rows.about = TestMetadata::of_lines(above.lines());
    if let Some(crank) = &crank {
        rows.note("crank", Sentence::from(phrases::CRANK).with("rpm", crank.rpm));
    }
    let date_order = head.likely_date_order(start.delimiter);
    rows.dates.likely = date_order;
    let mut reader = TableReader {
        at,
        name,
        text,
        budget,
        decimal_comma,
        date_order,
        crank,
        to_skip: head.to_skip,
        values: vec![f64::NAN; rows.layout().columns.len()],
        blocks: Blocks::new(text, head.text, start.delimiter),
        beside: NonDataLines::default(),
        rows,
        complete: Vec::new(),
        starts: vec![TestStart::read(above, date_order)],
        behind: start.offset,
        start,
    };
    let mut lines = ReaderBuilder::new()
        .has_headers(false)
        .delimiter(reader.start.delimiter)
        .flexible(true)
        .from_reader(table.as_bytes());
    let mut record = ByteRecord::new();
    while lines.read_byte_record(&mut record).unwrap_or(false) {
        reader.add(&record)?;
    }
    reader.finish(step)
}

/// Start of a test that the lines above its rows state.
struct TestStart {
    at: Option<f64>,
    dates: Dates,
}

impl TestStart {
    fn read(lines: &str, date_order: Option<DateOrder>) -> TestStart {
        let began = clock::begins(lines.lines());
        let mut dates = Dates::of_lines(lines.lines(), began.and_then(|began| began.date));
        dates.likely = date_order;
        TestStart { at: began.map(|began| began.at), dates }
    }
}

/// Reader of the rows of one table, which may contain several tests.
struct TableReader<'a> {
    at: &'a Place,
    name: &'a str,
    /// The whole text of the file.
    text: &'a str,
    start: Start,
    budget: &'a Budget,
    decimal_comma: bool,
    date_order: Option<DateOrder>,
    crank: Option<Crank>,
    /// Number of lines that are still to be skipped.
    to_skip: usize,
    /// Values of one row in the file's units.
    values: Vec<f64>,
    blocks: Blocks,
    beside: NonDataLines,
    /// Rows of the current test.
    rows: Rows,
    /// Tests before the current one.
    complete: Vec<Rows>,
    /// Start of each test.
    starts: Vec<TestStart>,
    /// Byte offset of the last row, after which the lines above a next test begin.
    behind: usize,
}

/// Returns a cell of a row. The text is valid UTF-8 and is split at ASCII bytes, so the cells are valid too.
fn cell(record: &ByteRecord, index: usize) -> &str {
    std::str::from_utf8(record.get(index).unwrap_or_default()).unwrap_or("?")
}

fn is_comment_record(record: &ByteRecord) -> bool {
    let first = record.get(0).unwrap_or_default().trim_ascii_start();
    matches!(first.first(), Some(b'#' | b'%')) || first.starts_with(b"//")
}

impl TableReader<'_> {
    /// Processes a line below the heading, which is a row or another line.
    fn add(&mut self, record: &ByteRecord) -> Result<(), RecordError> {
        if is_comment_record(record) {
            return Ok(());
        }
        if self.to_skip > 0 {
            self.to_skip -= 1;
            return Ok(());
        }
        if record.iter().all(|cell| cell.trim_ascii().is_empty()) {
            return Ok(());
        }
        let (line, offset) = self.locate(record);
        match self.blocks.classify(line - 1) {
            Block::Data => {}
            Block::Header => return Ok(()),
        }
        let has_figures = self.has_figures(record);
        if !self.is_row(record, has_figures) {
            return self.add_other_line(record, line, has_figures);
        }
        self.beside.row()?;
        if !self.is_usable(record, line) {
            return Ok(());
        }
        self.read_values(record, line)?;
        self.split_tests(offset);
        let test = self.rows.layout().test.map(|index| cell(record, index));
        self.rows.push(line, self.values.iter().copied(), test)
    }

    /// Returns the line of a row in the file and its byte offset.
    fn locate(&self, record: &ByteRecord) -> (usize, usize) {
        let Some(position) = record.position() else { return (self.start.index, self.start.offset) };
        let offset = self.start.offset + position.byte() as usize;
        // The CSV reader counts empty lines as part of the next row.
        let before = self.text.as_bytes().get(offset..).unwrap_or_default();
        let ends = before.iter().take_while(|b| matches!(b, b'\r' | b'\n'));
        let empty = ends.filter(|b| **b == b'\n').count();
        (self.start.index + position.line() as usize + empty, offset)
    }

    #[inline]
    fn is_text(&self, record: &ByteRecord, column: &Column) -> bool {
        !is_figure(cell(record, column.index), self.decimal_comma)
    }

    /// Returns whether a cell of a channel other than the time contains a number.
    fn has_figures(&self, record: &ByteRecord) -> bool {
        let is_empty = |column: &Column| cell(record, column.index).trim().is_empty();
        let mut others = self.rows.layout().columns.iter().filter(|c| c.channel != Channel::Time);
        others.any(|c| !is_empty(c) && !self.is_text(record, c))
    }

    /// Returns whether a line is a row. The time of a row is a number. Without a time column, every channel must be a
    /// number.
    fn is_row(&self, record: &ByteRecord, has_figures: bool) -> bool {
        let columns = &self.rows.layout().columns;
        let has_texts = || columns.iter().any(|c| self.is_text(record, c));
        match columns.iter().find(|c| c.channel == Channel::Time) {
            // A message of the acquisition system between rows may have a time, but no other number.
            Some(time) => !self.is_text(record, time) && (has_figures || !has_texts()),
            None => !has_texts(),
        }
    }

    /// Handles a line that is not a row.
    fn add_other_line(&mut self, record: &ByteRecord, line: usize, has_figures: bool) -> Result<(), RecordError> {
        let cells = record.iter().map(|cell| String::from_utf8_lossy(cell).into_owned()).collect::<Vec<_>>();
        let column = self.rows.layout().columns.iter().find(|c| self.is_text(record, c));
        let fault = column.map_or_else(
            || SampleError::NoData { at: self.at.clone() }.into(),
            |c| no_number(self.at, line, &c.heading, cell(record, c.index)),
        );
        let below_rows = !self.rows.is_empty() || !self.complete.is_empty();
        self.beside.take(below_rows, line, &cells, has_figures, fault)
    }

    /// Returns whether a row is usable. Fields beyond the columns of the heading may make a row unusable.
    fn is_usable(&mut self, record: &ByteRecord, line: usize) -> bool {
        let (found, expected) = (record.len(), self.start.header.len());
        let surplus = || record.iter().skip(expected).map(String::from_utf8_lossy).filter(|f| !f.trim().is_empty());
        if found <= expected || surplus().next().is_none() {
            return true;
        }
        // If the delimiter is a comma, decimal commas split every number in two. The parts then contain no point.
        let commas = self.start.delimiter == b',' && found <= 2 * expected && record.iter().all(is_whole);
        let hint = commas.then_some(phrases::QUOTE_DECIMAL_COMMAS);
        let fault = SampleError::Fields { at: self.at.clone(), line, found, expected, hint }.into();
        let fields: Vec<String> = surplus().map(std::borrow::Cow::into_owned).collect();
        let figures = fields.iter().any(|field| is_figure(field, self.decimal_comma));
        self.beside.surplus(line, &fields, figures, fault)
    }

    /// Reads the values of a row.
    #[inline]
    fn read_values(&mut self, record: &ByteRecord, line: usize) -> Result<(), RecordError> {
        if let Some(column) = self.rows.layout().columns.iter().find(|c| c.clock).map(|c| c.index)
            && (self.rows.is_empty() || self.rows.dates.is_open())
        {
            self.rows.dates.see(cell(record, column));
        }
        for (value, column) in self.values.iter_mut().zip(&self.rows.layout().columns) {
            let cell = cell(record, column.index);
            let read = if column.clock { clock::seconds(cell) } else { None };
            *value = read
                .or_else(|| number(cell, self.decimal_comma))
                .ok_or_else(|| no_number(self.at, line, &column.heading, cell))?;
            if let Some(crank) = self.crank.as_mut().filter(|crank| crank.index == column.index) {
                *value = crank.time(*value);
            }
        }
        Ok(())
    }

    /// Begins another test if the time restarts below a repeated header. `offset` is that of the row in the file.
    #[inline]
    fn split_tests(&mut self, offset: usize) {
        let time = self.rows.layout().columns.iter().position(|c| c.channel == Channel::Time).map(|i| self.values[i]);
        if self.blocks.begins_anew(time) {
            let layout = self.rows.layout().clone();
            let name = format!("{} {}", self.name, self.complete.len() + 2);
            let mut next = Rows::new(self.at.clone(), name, layout, self.budget);
            next.about = self.rows.about.clone();
            next.dates.likely = self.date_order;
            self.complete.push(std::mem::replace(&mut self.rows, next));
            let above = self.text.get(self.behind..offset).unwrap_or_default();
            self.starts.push(TestStart::read(above, self.date_order));
        }
        self.behind = offset;
    }

    /// Returns the tests. `step` is the time between samples, s, that the file or the user states.
    fn finish(mut self, step: Option<f64>) -> Result<Vec<Samples>, RecordError> {
        self.beside.report(&mut self.rows)?;
        self.complete.push(self.rows);
        let mut read = Vec::new();
        for (rows, TestStart { at, dates }) in self.complete.into_iter().zip(self.starts) {
            read.extend(rows.finish(step)?.into_iter().map(|test| test.beginning(at, dates.clone())));
        }
        Ok(read)
    }
}

fn no_number(at: &Place, line: usize, heading: &str, cell: &str) -> RecordError {
    RecordError::Sample(SampleError::Cell {
        at: at.clone(),
        line,
        column: heading.to_owned(),
        text: cell.trim().chars().take(40).collect(),
        hint: cell.contains(',').then_some(phrases::WITHOUT_SEPARATORS),
    })
}

/// Reads the time between samples, s, from the lines above a table: `Sample Rate: 1000 Hz`, `dt [ms];0,5`. If several
/// lines state this time, the last one counts.
fn sample_time<'a>(above: impl Iterator<Item = &'a str>) -> Option<f64> {
    let mut found = None;
    for line in above.take(HEADER_WITHIN) {
        let line = uncommented(line);
        // If another separator follows the name, a comma may be a decimal comma.
        let separator = line.chars().find(|c| "\t;:=".contains(*c)).unwrap_or(',');
        let mut cells = line.split(separator).map(|c| c.trim().trim_matches('"'));
        let what = heading(cells.next().unwrap_or_default());
        let mut rest = cells.filter(|c| !c.is_empty());
        let Some(value) = rest.next() else { continue };
        let (value, unit) = match value.split_once(' ') {
            Some((value, unit)) => (value, Some(unit.trim())),
            None => (value, rest.next()),
        };
        let Some(value) = number(value, true).filter(|v| v.is_finite() && *v > 0.0) else { continue };
        let unit = unit.map(|u| u.trim_matches(|c| "[]()".contains(c)));
        found = match (&what, unit) {
            (Heading::SampleRate, None | Some("Hz" | "1/s" | "S/s" | "samples/s")) => Some(1.0 / value),
            (Heading::SampleRate, Some("kHz")) => Some(1e-3 / value),
            (Heading::SampleTime(HeadingUnit::Known(unit)), None) => Some(unit.to_si(value)),
            (Heading::SampleTime(_), Some(unit)) => unit.parse::<Unit>().ok().map(|unit| unit.to_si(value)),
            _ => found,
        };
    }
    found
}
