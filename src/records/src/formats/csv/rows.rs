//! Reads the rows below a header.

use csv::{ByteRecord, ReaderBuilder};

use super::header_search::Start;
use super::lines::{is_comment, is_figure, is_whole, uncommented};
use super::repeated_headers::{Block, Blocks};
use crate::columns::crank;
use crate::columns::delimiter::{self, split};
use crate::columns::heading::{Heading, HeadingUnit, heading};
use crate::columns::layout::{Column, Layout, channel_of};
use crate::columns::non_data_lines::{LABELS, NonDataLines};
use crate::columns::table::{HEADER_WITHIN, Rows, is_units_row, number};
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

pub(super) fn table(
    at: &Place,
    name: &str,
    text: &str,
    found: Start,
    options: &Options,
    budget: &Budget,
) -> Result<Vec<Samples>, RecordError> {
    let Start { index: header_index, offset, delimiter, mut header, headed, commented } = found;
    let header_line = header_index + 1;
    let decimal_comma = delimiter != b',' || delimiter::quotes_decimal_commas(&text[offset..]);
    let mut lines = text[offset..].split_inclusive('\n');
    let header_text = if headed { lines.next().unwrap_or_default().trim_end() } else { "" };
    let mut lines = lines.peekable();
    let mut units = None;
    if commented {
        // If the heading is a comment, its units are in a comment too.
        let below = lines.peek().filter(|line| is_comment(line)).map(|line| split(uncommented(line), delimiter));
        units = below.filter(|cells| is_units_row(cells));
    }
    let mut below = lines.filter(|line| !is_comment(line)).map(|line| split(line.trim_end(), delimiter));
    let mut first_row = below.next().unwrap_or_default();
    let mut to_skip = usize::from(headed && !commented);
    if headed && units.is_none() && is_units_row(&first_row) {
        units = Some(std::mem::replace(&mut first_row, below.next().unwrap_or_default()));
        to_skip += 1;
    }
    if let Some(units) = &mut units {
        units.resize(header.len(), String::new());
    }
    // Sensor names and rates may be between the heading and the first row, so such lines are skipped.
    for _ in 0..LABELS {
        if first_row.iter().any(|cell| !cell.trim().is_empty() && is_figure(cell, decimal_comma)) {
            break;
        }
        first_row = below.next().unwrap_or_default();
    }
    let is_clock = |index: usize| {
        first_row.get(index).is_some_and(|cell| number(cell, decimal_comma).is_none() && clock::seconds(cell).is_some())
    };
    let timed = header.iter().any(|h| channel_of(h, options) == Some(Channel::Time));
    let mut crank = if timed { None } else { crank::find(&mut header, units.as_mut(), text[..offset].lines()) };
    let step = options.sample_rate_hz.map(|rate| 1.0 / rate).or_else(|| sample_time(text[..offset].lines()));
    let layout = Layout::with_clock(at, header_line, &header, units.as_deref(), options, step.is_some(), &is_clock)?;
    let mut rows = Rows::new(at.clone(), name.to_string(), layout, budget);
    rows.about = TestMetadata::of_lines(text[..offset].lines());
    if let Some(crank) = &crank {
        rows.note("crank", Sentence::from(phrases::CRANK).with("rpm", crank.rpm));
    }
    // `began` has the start of each test, from the lines above its rows. `behind` is the position of the last row,
    // after which the lines above a next test begin. Programs that write a decimal comma, or a semicolon as delimiter,
    // write dates with the day first.
    let is_comma = |cell: &String| delimiter != b',' && cell.contains(',') && number(cell, true).is_some();
    let usual = (delimiter == b';' || first_row.iter().any(is_comma)).then_some(DateOrder::DayFirst);
    let began_by = |lines: &str| {
        let began = clock::begins(lines.lines());
        let mut dates = Dates::of_lines(lines.lines(), began.and_then(|began| began.date));
        dates.likely = usual;
        (began.map(|began| began.at), dates)
    };
    rows.dates.likely = usual;
    let mut began = vec![began_by(&text[..offset])];
    let mut behind = offset;

    let mut reader = ReaderBuilder::new()
        .has_headers(false)
        .delimiter(delimiter)
        .flexible(true)
        .from_reader(&text.as_bytes()[offset..]);
    let mut record = ByteRecord::new();
    let mut values = vec![f64::NAN; rows.layout().columns.len()];
    let mut blocks = Blocks::new(text, header_text, delimiter);
    let mut tests = Vec::new();
    let mut beside = NonDataLines::default();
    while reader.read_byte_record(&mut record).unwrap_or(false) {
        // The CSV reader counts empty lines as part of the next row.
        let (begins, empty) = record.position().map_or((0, 0), |p| {
            let before = text.as_bytes().get(offset + p.byte() as usize..).unwrap_or_default();
            let ends = before.iter().take_while(|b| matches!(b, b'\r' | b'\n'));
            (p.line() as usize, ends.filter(|b| **b == b'\n').count())
        });
        let line = header_index + begins + empty;
        let here = record.position().map_or(offset, |p| offset + p.byte() as usize);
        let first = record.get(0).unwrap_or_default().trim_ascii_start();
        if matches!(first.first(), Some(b'#' | b'%')) || first.starts_with(b"//") {
            continue;
        }
        if to_skip > 0 {
            to_skip -= 1;
            continue;
        }
        if record.iter().all(|cell| cell.trim_ascii().is_empty()) {
            continue;
        }
        match blocks.classify(line - 1) {
            Block::Data => {}
            Block::Header => continue,
        }
        // The text is valid UTF-8 and is split at ASCII bytes, so the fields are valid too.
        let cell = |index: usize| std::str::from_utf8(record.get(index).unwrap_or_default()).unwrap_or("?");
        // The time of a row is a number. Without a time column, every channel must be a number.
        let columns = &rows.layout().columns;
        let text_of = |c: &Column| !is_figure(cell(c.index), decimal_comma);
        // A message of the acquisition system between rows may have a time, but no other number.
        let figures =
            columns.iter().any(|c| c.channel != Channel::Time && !cell(c.index).trim().is_empty() && !text_of(c));
        let is_row = match columns.iter().find(|c| c.channel == Channel::Time) {
            Some(time) => !text_of(time) && (figures || !columns.iter().any(text_of)),
            None => !columns.iter().any(text_of),
        };
        if !is_row {
            let cells = record.iter().map(|cell| String::from_utf8_lossy(cell).into_owned()).collect::<Vec<_>>();
            let column = columns.iter().find(|c| text_of(c));
            let fault = column.map_or_else(
                || RecordError::Sample(SampleError::NoData { at: at.clone() }),
                |c| no_number(at, line, &c.heading, cell(c.index)),
            );
            beside.take(!rows.is_empty() || !tests.is_empty(), line, &cells, figures, fault)?;
            continue;
        }
        beside.row()?;
        let surplus = || record.iter().skip(header.len()).map(String::from_utf8_lossy).filter(|f| !f.trim().is_empty());
        if surplus().next().is_some() {
            let (found, expected) = (record.len(), header.len());
            // If the delimiter is a comma, decimal commas split every number in two. The parts then contain no point.
            let commas = delimiter == b',' && found <= 2 * expected && record.iter().all(is_whole);
            let hint = commas.then_some(phrases::QUOTE_DECIMAL_COMMAS);
            let fault = RecordError::Sample(SampleError::Fields { at: at.clone(), line, found, expected, hint });
            let fields: Vec<String> = surplus().map(std::borrow::Cow::into_owned).collect();
            let figures = fields.iter().any(|field| is_figure(field, decimal_comma));
            if !beside.surplus(line, &fields, figures, fault) {
                continue;
            }
        }
        if let Some(column) = rows.layout().columns.iter().find(|c| c.clock).map(|c| c.index)
            && (rows.is_empty() || rows.dates.is_open())
        {
            rows.dates.see(cell(column));
        }
        for (value, column) in values.iter_mut().zip(&rows.layout().columns) {
            let cell = cell(column.index);
            let read = if column.clock { clock::seconds(cell) } else { None };
            *value = read
                .or_else(|| number(cell, decimal_comma))
                .ok_or_else(|| no_number(at, line, &column.heading, cell))?;
            if let Some(crank) = crank.as_mut().filter(|crank| crank.index == column.index) {
                *value = crank.time(*value);
            }
        }
        // If the time restarts below a repeated header, another test begins.
        let time = rows.layout().columns.iter().position(|c| c.channel == Channel::Time).map(|i| values[i]);
        if blocks.begins_anew(time) {
            let layout = rows.layout().clone();
            let name = format!("{name} {}", tests.len() + 2);
            let mut next = Rows::new(at.clone(), name, layout, budget);
            next.about = rows.about.clone();
            next.dates.likely = usual;
            tests.push(std::mem::replace(&mut rows, next));
            began.push(began_by(text.get(behind..here).unwrap_or_default()));
        }
        behind = here;
        let test = rows
            .layout()
            .test
            .map(|index| std::str::from_utf8(record.get(index).unwrap_or_default()).unwrap_or("?").to_string());
        rows.push(line, values.iter().copied(), test.as_deref())?;
    }
    beside.report(&mut rows)?;
    tests.push(rows);
    let mut read = Vec::new();
    for (rows, (began, dates)) in tests.into_iter().zip(began) {
        read.extend(rows.finish(step)?.into_iter().map(|test| test.beginning(began, dates.clone())));
    }
    Ok(read)
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
