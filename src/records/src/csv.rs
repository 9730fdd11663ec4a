//! Reads delimited text: comma, semicolon, tab or bar; decimal point or comma; comment lines; a row of units.

use std::borrow::Cow;

use csv::{ByteRecord, ReaderBuilder};

use super::about::About;
use super::beside::{Beside, LABELS};
use super::channel::Channel;
use super::clock;
use super::crank;
use super::date_order::DateOrder;
use super::delimiter::{self, split};
use super::error::{Place, RecordError};
use super::file_dates::Dates;
use super::heading::{Heading, HeadingUnit, heading, nearest};
use super::lvm;
use super::options::Options;
use super::phrases;
use super::samples::Samples;
use super::sentence::Sentence;
use super::source::{Budget, Source};
use super::table::{
    Column, HEADER_WITHIN, Layout, MOST_COLUMNS, Rows, channel_of, column_number, is_header, is_units_row,
    no_header_near, number, numbered,
};
use super::unit::Unit;

/// Reads the tests of one delimited text file.
pub(crate) fn read(source: Source, name: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let at = source.place();
    let Source { bytes, budget, .. } = source;
    let (text, guessed) = decode(&bytes);
    let read = parse(&at, name, &text, options, &budget);
    if guessed && matches!(read, Err(RecordError::Header { .. } | RecordError::MissingColumn { .. })) {
        // Chinese systems write GB 18030 where others write Latin-1; only the headings can tell.
        let (text, _, wrong) = encoding_rs::GB18030.decode(&bytes);
        if !wrong && let Ok(tests) = parse(&at, name, &text, options, &budget) {
            return Ok(tests);
        }
    }
    read
}

/// Longest line among those that may be the heading, bytes: each is cut into cells in every way.
const LONGEST_LINE: usize = 1 << 20;
/// Memory of a cell beside its text, bytes.
const CELL: u64 = 24;

/// The cells of a short table of text, line by line with its number, under the delimiter that makes most columns of its first
/// line.
pub(crate) fn cells_of_text(source: &Source) -> Result<Vec<(usize, Vec<String>)>, RecordError> {
    let (text, _) = decode(&source.bytes);
    let text = text.trim_start_matches('\u{feff}');
    let lines = || text.lines().enumerate().filter(|(_, line)| !is_comment(line));
    let first = lines().next().map_or("", |(_, line)| line);
    let delimiter = delimiter::detect(first);
    let cells = |(k, line): (usize, &str)| {
        let cells = split(line, delimiter);
        let size = CELL * cells.len() as u64 + line.len() as u64;
        source.budget.hold(size).map_err(|exhausted| exhausted.into_error(&source.place()))?;
        Ok((k + 1, cells))
    };
    lines().map(cells).collect()
}

/// The text of a short table as spreadsheets save it, without the mark that may stand before it.
pub fn text(bytes: &[u8]) -> String {
    decode(bytes).0.trim_start_matches('\u{feff}').to_owned()
}

/// Decodes a file in UTF-8 or UTF-16 with byte order mark, else in the code page of western Windows, which is a
/// guess.
///
/// Old exports use it for µ and °, and so do spreadsheets that save no UTF-8. Where the page has no character it is
/// Latin-1.
fn decode(bytes: &[u8]) -> (Cow<'_, str>, bool) {
    let (text, guessed) = characters(bytes);
    // Old Macintosh programs end lines by a carriage return alone.
    let returns_alone = text.contains('\r') && !text.contains('\n');
    (if returns_alone { text.replace('\r', "\n").into() } else { text }, guessed)
}

fn characters(bytes: &[u8]) -> (Cow<'_, str>, bool) {
    let utf16 = |from: fn([u8; 2]) -> u16| -> String {
        let units: Vec<u16> = bytes[2..].chunks_exact(2).map(|b| from([b[0], b[1]])).collect();
        String::from_utf16_lossy(&units)
    };
    match bytes {
        [0xFF, 0xFE, ..] => return (utf16(u16::from_le_bytes).into(), false),
        [0xFE, 0xFF, ..] => return (utf16(u16::from_be_bytes).into(), false),
        _ => {}
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => (text.into(), false),
        Err(_) => (encoding_rs::WINDOWS_1252.decode_without_bom_handling(bytes).0, true),
    }
}

/// A line that is no data: empty or a comment.
fn is_comment(line: &str) -> bool {
    matches!(line.trim_start().bytes().next(), None | Some(b'#' | b'%')) || line.trim_start().starts_with("//")
}

/// Where the table of a text begins.
struct Start {
    /// Line of the header, or of the first row where there is none; from 0.
    index: usize,
    /// Where that line begins in the text.
    offset: usize,
    delimiter: u8,
    header: Vec<String>,
    /// Whether that line is the header.
    headed: bool,
    /// Whether it stands behind a comment mark, as numerical programs write it.
    commented: bool,
}

impl Start {
    fn headed(index: usize, offset: usize, delimiter: u8, header: Vec<String>) -> Start {
        Start { index, offset, delimiter, header, headed: true, commented: false }
    }
}

/// The text of a comment line behind its mark.
fn uncommented(line: &str) -> &str {
    line.trim_start().trim_start_matches(['#', '%', '/']).trim()
}

/// Finds the header, and with it the delimiter: the one under which it is a header. Where the user names columns by number
/// it may be missing: then the first row of numbers begins the table.
fn start(text: &str, options: &Options) -> (Option<Start>, Option<String>) {
    let mut offset = 0;
    let mut first_line = None;
    let mut numbers: Option<Start> = None;
    let by_number = options.columns.values().any(|wanted| column_number(wanted).is_some());
    let mut above: Vec<String> = Vec::new();
    let mut commented: Option<Start> = None;
    for (index, line) in text.split_inclusive('\n').enumerate().take(HEADER_WITHIN) {
        if !is_comment(line) {
            first_line.get_or_insert_with(|| line.to_owned());
            let trimmed = line.trim_end();
            for delimiter in delimiter::ALL {
                let header = split(trimmed, delimiter);
                // A row of numbers is no header, even where a column that the user names by its number has a number's name there.
                let row = header.len() > 1
                    && header.iter().any(|c| !c.trim().is_empty())
                    && header.iter().all(|c| number(c, delimiter != b',').is_some() || clock::seconds(c).is_some());
                if !row && is_header(&header, options) {
                    return (Some(Start::headed(index, offset, delimiter, header)), first_line);
                }
                if by_number && row && numbers.is_none() {
                    let names = numbered(header.len());
                    let header = if above.len() == names.len() { std::mem::take(&mut above) } else { names };
                    numbers = Some(Start { headed: false, ..Start::headed(index, offset, delimiter, header) });
                }
            }
            above = split(trimmed, delimiter::detect(trimmed));
        } else {
            // The last comment that names the columns: above it may stand what an earlier table had.
            let found = delimiter::ALL.into_iter().find_map(|delimiter| {
                let header = split(uncommented(line), delimiter);
                let found = Start { commented: true, ..Start::headed(index, offset, delimiter, header) };
                is_header(&found.header, options).then_some(found)
            });
            commented = found.or(commented);
        }
        offset += line.len();
    }
    (numbers.or(commented), first_line)
}

/// Replaces blanks between columns by tabs: two and more, or any. Figures stand closer than names.
fn with_tabs(text: &str, any: bool) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.lines() {
        let any = any || line.split_whitespace().all(|cell| is_figure(cell, true));
        let mut blanks = 0;
        for c in line.trim().chars() {
            if c == ' ' {
                blanks += 1;
                continue;
            }
            if blanks > usize::from(!any) {
                out.push('\t');
            } else if blanks == 1 {
                out.push(' ');
            }
            blanks = 0;
            out.push(c);
        }
        out.push('\n');
    }
    out
}

/// Parts names that a single blank separates, as in the plain files of MTS stations.
///
/// There are as many as units below them, and so that most of them are known.
fn part_names(found: &mut Start, text: &str) {
    /// Columns of such a file.
    const MOST: usize = 32;
    let below = text[found.offset..].lines().skip(1).find(|line| !is_comment(line)).unwrap_or_default();
    let units: Vec<&str> = below.split_whitespace().collect();
    let words: Vec<&str> = found.header.iter().flat_map(|cell| cell.split_whitespace()).collect();
    let columns = units.len();
    if !is_units_row(&units) || columns == found.header.len() || columns > MOST || words.len() > 4 * MOST {
        return;
    }
    // The best way to part the first words into so many names: how many are known, and where the last name begins.
    let mut best: Vec<Vec<Option<(usize, usize)>>> = vec![vec![None; words.len() + 1]; columns + 1];
    best[0][0] = Some((0, 0));
    for column in 1..=columns {
        for end in column..=words.len() {
            for begin in column - 1..end {
                let Some((known, _)) = best[column - 1][begin] else { continue };
                let is_known = matches!(heading(&words[begin..end].join(" ")), Heading::Channel(..));
                let now = (known + usize::from(is_known), begin);
                if best[column][end].is_none_or(|(most, _)| now.0 > most) {
                    best[column][end] = Some(now);
                }
            }
        }
    }
    let (mut names, mut end) = (Vec::new(), words.len());
    for column in (1..=columns).rev() {
        let Some((_, begin)) = best[column][end] else { return };
        names.push(words[begin..end].join(" "));
        end = begin;
    }
    names.reverse();
    found.header = names;
}

fn parse(at: &Place, name: &str, text: &str, options: &Options, budget: &Budget) -> Result<Vec<Samples>, RecordError> {
    let text = text.trim_start_matches('\u{feff}');
    if lvm::is_one(text) {
        return lvm::parse(at, name, text, options, budget);
    }
    if let Some((k, line)) = text.lines().enumerate().take(HEADER_WITHIN).find(|(_, line)| line.len() > LONGEST_LINE) {
        let columns = |delimiter: &u8| line.bytes().filter(|b| b == delimiter).count() + 1;
        let found = delimiter::ALL.iter().map(columns).max().unwrap_or(1);
        if found > MOST_COLUMNS {
            return Err(RecordError::TooManyColumns { at: at.clone(), line: k + 1, found, most: MOST_COLUMNS });
        }
        return Err(no_header_near::<&str>(at, line, &[]));
    }
    let (found, first_line) = start(text, options);
    let Some(first_line) = first_line else {
        return Err(RecordError::NoData { at: at.clone() });
    };
    if let Some(found) = found {
        return table(at, name, text, found, options, budget);
    }
    for any in [false, true] {
        let tabbed = with_tabs(text, any);
        if let (Some(mut found), _) = start(&tabbed, options) {
            part_names(&mut found, &tabbed);
            return table(at, name, &tabbed, found, options, budget);
        }
    }
    let trimmed = first_line.trim_end();
    let delimiter = delimiter::detect(trimmed);
    let header = split(trimmed, delimiter);
    if options.columns.values().any(|wanted| nearest(wanted, header.iter().map(String::as_str)).is_some()) {
        // A heading nearly as the user wrote it: the layout says which is meant.
        return table(at, name, text, Start::headed(0, 0, delimiter, header), options, budget);
    }
    // What the lines hold under the delimiter that makes most of each, or parted by blanks.
    let parted: Vec<(usize, Vec<String>)> = text
        .lines()
        .enumerate()
        .take(HEADER_WITHIN)
        .filter(|(_, line)| !is_comment(line))
        .map(|(k, line)| {
            let cells = split(line.trim_end(), delimiter::detect(line.trim_end()));
            let blank = cells.len() == 1 && line.split_whitespace().all(|cell| is_figure(cell, true));
            (k + 1, if blank { line.split_whitespace().map(str::to_owned).collect() } else { cells })
        })
        .collect();
    Err(no_header_near(at, &first_line, &parted))
}

fn table(
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
        // Units of such a heading stand in a comment too.
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
    // Sensors and rates may stand between the heading and the first figures.
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
    rows.about = About::of_lines(text[..offset].lines());
    if let Some(crank) = &crank {
        rows.note("crank", Sentence::from(phrases::CRANK).with("rpm", crank.rpm));
    }
    // When each test began, as the lines above its figures say; up to where these lines are read.
    // A decimal comma, or what stands between columns where there is one, is of those who write the day first.
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
    let mut beside = Beside::default();
    while reader.read_byte_record(&mut record).unwrap_or(false) {
        // The reader counts empty lines to the record behind them.
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
        match blocks.look(line - 1) {
            Block::Data => {}
            Block::Header => continue,
        }
        // The text was valid UTF-8 and fields are cut at ASCII bytes, so the fields are valid too.
        let cell = |index: usize| std::str::from_utf8(record.get(index).unwrap_or_default()).unwrap_or("?");
        // A row has its time in figures; where there is no time, everything that is read.
        let columns = &rows.layout().columns;
        let text_of = |c: &Column| !is_figure(cell(c.index), decimal_comma);
        // What an acquisition writes between its rows may bear a time, but nothing else in figures.
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
                || RecordError::NoData { at: at.clone() },
                |c| no_number(at, line, &c.heading, cell(c.index)),
            );
            beside.take(!rows.is_empty() || !tests.is_empty(), line, &cells, figures, fault)?;
            continue;
        }
        beside.row()?;
        let surplus = || record.iter().skip(header.len()).map(String::from_utf8_lossy).filter(|f| !f.trim().is_empty());
        if surplus().next().is_some() {
            let (found, expected) = (record.len(), header.len());
            // Decimal commas part every number in two, and leave no point in any.
            let commas = delimiter == b',' && found <= 2 * expected && record.iter().all(is_whole);
            let hint = commas.then_some(phrases::QUOTE_DECIMAL_COMMAS);
            let fault = RecordError::Fields { at: at.clone(), line, found, expected, hint };
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
        // Time that begins anew below a repeated header is another test.
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

/// Whether a cell is a whole number: digits, and a sign at most.
fn is_whole(cell: &[u8]) -> bool {
    let cell = cell.trim_ascii();
    cell.strip_prefix(b"-").unwrap_or(cell).iter().all(u8::is_ascii_digit)
}

/// Whether a cell holds a number or a time of day.
fn is_figure(cell: &str, decimal_comma: bool) -> bool {
    number(cell, decimal_comma).is_some() || clock::seconds(cell).is_some()
}

fn no_number(at: &Place, line: usize, heading: &str, cell: &str) -> RecordError {
    RecordError::Cell {
        at: at.clone(),
        line,
        column: heading.to_owned(),
        text: cell.trim().chars().take(40).collect(),
        hint: cell.contains(',').then_some(phrases::WITHOUT_SEPARATORS),
    }
}

/// The time from sample to sample that the lines above a table state: `Sample Rate: 1000 Hz`, `dt [ms];0,5`.
fn sample_time<'a>(above: impl Iterator<Item = &'a str>) -> Option<f64> {
    let mut found = None;
    for line in above.take(HEADER_WITHIN) {
        let line = uncommented(line);
        // A comma may be a decimal one where something else stands behind the name.
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

/// Headers that an acquisition writes again before every block of rows, as MTS stations do.
struct Blocks {
    /// Lines, from 0 and in order, of the text between a block of rows and the next.
    ///
    /// From the first line that is no row to the last line before the next row.
    headers: Vec<std::ops::Range<usize>>,
    next: usize,
    /// Whether the row to come is the first below a header.
    fresh: bool,
    last_time: Option<f64>,
}

enum Block {
    Data,
    Header,
}

impl Blocks {
    fn new(text: &str, header: &str, delimiter: u8) -> Blocks {
        let mut headers: Vec<std::ops::Range<usize>> = Vec::new();
        let header_again = || text.lines().filter(|line| line.trim_end() == header).nth(1).is_some();
        if !header.trim().is_empty() && header_again() {
            // From every repetition of the header up to the row before and down to the row after.
            let is_row = |line: &str| {
                let cells = split_plain(line, delimiter);
                cells.clone().next().is_some_and(|c| !c.trim().is_empty())
                    && cells.clone().count() > 1
                    && cells.filter(|c| !c.trim().is_empty()).all(|c| {
                        number(c.trim().trim_matches('"'), delimiter != b',').is_some() || clock::seconds(c).is_some()
                    })
            };
            let mut seen = false;
            let mut between: Option<usize> = None;
            let mut repeated = false;
            // The reader counts empty lines to the record behind them.
            let mut empty: Option<usize> = None;
            for (index, line) in text.lines().enumerate() {
                let is_header = line.trim_end() == header;
                if is_header && !seen {
                    seen = true;
                    between = None;
                    continue;
                }
                if !seen {
                    continue;
                }
                if is_comment(line) {
                    empty.get_or_insert(index);
                    continue;
                }
                let begins = empty.take().unwrap_or(index);
                if is_row(line) {
                    if let (Some(from), true) = (between.take(), repeated) {
                        headers.push(from..begins);
                    }
                    repeated = false;
                } else {
                    between.get_or_insert(begins);
                    repeated |= is_header;
                }
            }
        }
        Blocks { headers, next: 0, fresh: false, last_time: None }
    }

    fn look(&mut self, line: usize) -> Block {
        while self.headers.get(self.next).is_some_and(|range| range.end <= line) {
            self.next += 1;
            self.fresh = true;
        }
        match self.headers.get(self.next) {
            Some(range) if range.contains(&line) => Block::Header,
            _ => Block::Data,
        }
    }

    fn begins_anew(&mut self, time: Option<f64>) -> bool {
        let anew = self.fresh && matches!((time, self.last_time), (Some(now), Some(before)) if now < before);
        self.fresh = false;
        self.last_time = time.filter(|t| t.is_finite()).or(self.last_time);
        anew
    }
}

/// Cells of a line without regard to quotes: enough to tell rows from text.
fn split_plain(line: &str, delimiter: u8) -> std::str::Split<'_, char> {
    line.split(delimiter as char)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::unit::Unit;
    use super::*;

    fn try_read(text: &str) -> Result<Vec<Samples>, RecordError> {
        parse(&Place::file("a.csv"), "a", text, &Options::default(), &Budget::new(0))
    }

    fn read(text: &str) -> Samples {
        let mut tests = try_read(text).unwrap();
        assert_eq!(tests.len(), 1);
        tests.remove(0)
    }

    #[test]
    fn delimiters_decimal_commas_comments_and_units_row_give_the_same_samples() {
        let plain = read("time_s,displacement_mm,force_N\n0,1.5,10\n0.5,2.5,20\n");
        assert_eq!(plain.time, [0.0, 0.5]);
        assert_eq!(plain.displacement.as_deref(), Some([0.0015, 0.0025].as_slice()));
        assert_eq!(plain.force, [10.0, 20.0]);
        assert_eq!(plain.lines, [2, 3]);
        for text in [
            "\u{feff}Time [s];Position [mm];Load [N]\r\n0;1,5;10\r\n0,5;2,5;20\r\n",
            "# rig 7\n% operator\n\nt_ms\tx_cm\tF_kN\n0\t0,15\t0,01\n500\t0,25\t0.02\n",
            "Rig export of today\nTime,Displacement,Force\n(s),(mm),(N)\n0,1.5,10\n0.5,2.5,20\n",
            "Time,Damper Displacement,Force,Comment\ns,mm,N,\n0,1.5,10,start\n# pause\n0.5,2.5,20,\n",
            "\"Time, s\",\"Displacement, mm\",\"Force, N\",\n0,1.5,10,\n0.5,2.5,20,\n",
        ] {
            let other = read(text);
            assert_eq!(
                (&other.time, &other.displacement, &other.force),
                (&plain.time, &plain.displacement, &plain.force)
            );
        }
    }

    #[test]
    fn utf16_and_latin1_are_decoded() {
        let text = "time_s,T [°C],x [µm],F [N]\n0,20,1,1\n";
        let utf16: Vec<u8> = [0xFEFF].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
        let latin1: Vec<u8> = text.chars().map(|c| c as u8).collect();
        for bytes in [utf16, latin1, text.as_bytes().to_vec()] {
            let samples = read(&decode(&bytes).0);
            assert_eq!(samples.temperature.as_deref(), Some([20.0].as_slice()));
            assert_eq!(samples.displacement.as_deref(), Some([1e-6].as_slice()));
        }
    }

    #[test]
    fn what_a_spreadsheet_saves_without_utf8_keeps_its_dashes_and_umlauts() {
        assert_eq!(text(b"D\xE4mpfer \x96 vorn, 5 \x80"), "Dämpfer – vorn, 5 €");
        assert_eq!(text("\u{feff}Dämpfer – vorn".as_bytes()), "Dämpfer – vorn");
    }

    #[test]
    fn a_test_column_makes_one_test_per_value() {
        let tests = try_read("test,time_s,v_m_s,F_N\nslow,0,1,2\nslow,1,1,3\nfast,0,1,4\nslow,2,1,5\n").unwrap();
        assert_eq!(tests.iter().map(|t| t.name.as_str()).collect::<Vec<_>>(), ["slow", "fast"]);
        assert_eq!(tests[0].force, [2.0, 3.0, 5.0]);
        assert_eq!(tests[0].lines, [2, 3, 5]);
        assert_eq!(tests[1].at.to_string(), "a.csv (test 'fast')");
    }

    #[test]
    fn wrong_headers_are_refused_in_words() {
        let message = |text: &str| try_read(text).unwrap_err().to_string();
        let unknown = message("alpha,beta\n1,2\n");
        assert!(unknown.contains("alpha,beta") && unknown.contains("daN") && unknown.contains("--column"), "{unknown}");
        let two = message("time_s,x_mm,Force [N],Load Cell [kN]\n0,1,1,1\n");
        assert!(two.contains("line 1") && two.contains("'Force [N]'") && two.contains("'Load Cell [kN]'"), "{two}");
        let three = message("time_s,x_mm,Force [N],Load Cell [kN],ring (kip)\n0,1,1,1,1\n");
        assert!(three.contains("'Force [N]', 'Load Cell [kN]', 'ring (kip)'"), "{three}");
        let two = message("time_s,x_mm,front (kip),rear (kip)\n0,1,1,1\n");
        assert!(two.contains("'front (kip)', 'rear (kip)'") && two.contains("could be force"), "{two}");
        let units = message("time,x,force\n0,1,1\n");
        assert!(
            units.contains("--unit time=s --unit displacement=mm --unit force=N") && units.contains("heading"),
            "{units}"
        );
        let units = message("time,x\n0,1\n");
        assert!(
            units.contains("no column for force") && units.contains("--unit time=s --unit displacement=mm"),
            "{units}"
        );
        let best = message("Rig 7\nOperator,NN\ntime,Fh,u\n0,1,1\n");
        assert!(best.contains("line 3, with 'time' for time"), "{best}");
        for figures in ["0,1.5,10\n1,2.5,20\n", "0 1.5 10\n1 2.5 20\n"] {
            let message = message(figures);
            assert!(message.contains("3 columns of figures") && message.contains("--unit force=N"), "{message}");
        }
        let pairs = message("0.1,10\n0.2,20\n");
        assert!(pairs.contains("--column force=2") && pairs.contains("--sample-rate"), "{pairs}");
        let unit = message("#\ntime_s,x_mm,Force\n0,1,1\n");
        assert!(unit.contains("line 2") && unit.contains("'Force' has no unit") && unit.contains("lbf"), "{unit}");
        let wrong = message("time_s,x_mm,Force [tons]\n0,1,1\n");
        assert!(wrong.contains("'tons'") && wrong.contains("kN"), "{wrong}");
        let missing = message("time_s,x_mm,gap\n0,1,1\n");
        assert!(missing.contains("no column for force"), "{missing}");
        assert!(message("time_s,x_mm,force_N\n").contains("no data rows"));
        assert!(message("").contains("no data rows"));
    }

    #[test]
    fn a_column_is_found_by_its_unit_where_no_heading_names_it() {
        for (header, guessed) in [
            ("time (s),displacement (in),friction force (kip)", 1),
            ("times(s),u [in],Fh [kip]", 2),
            ("Seconds,Lead Actuator Displacment (in),Fh (kip),pressure [bar],gap command [mm]", 1),
        ] {
            let more = ",9".repeat(header.split(',').count() - 3);
            let test = read(&format!("{header}\n0,1,1{more}\n1,2,2{more}\n"));
            let (x, force) = (test.displacement.as_ref().unwrap(), &test.force);
            assert!((x[1] - 0.0508).abs() < 1e-9 && (force[1] - 8896.443).abs() < 1e-3, "{header}: {test:?}");
            assert_eq!(told(&test).matches("by its unit alone").count(), guessed, "{header}");
        }
        // A name that is understood at need gives way to the usual one.
        let test = read(
            "time_s,tout [s],Millis,dist [mm],x_mm,forc [N],Lead Force [N],force_N\n1,9,9,9,1,9,9,1\n2,9,9,9,2,9,9,2\n",
        );
        assert_eq!((test.time.as_slice(), test.force.as_slice()), ([1.0, 2.0].as_slice(), [1.0, 2.0].as_slice()));
        // A length beside a velocity may be any.
        let test = read("time (s),velocity (m/s),wear (mm),force (N)\n0,1,1,1\n1,2,2,2\n");
        assert!(test.displacement.is_none(), "{test:?}");
        let options = Options { sample_rate_hz: Some(100.0), ..Options::default() };
        let text = "Lead Actuator Force ,Lead Actuator Displacment\nkN,mm\n1,2\n3,4\n";
        let test = parse(&Place::file("a.csv"), "a", text, &options, &Budget::new(0)).unwrap().remove(0);
        assert_eq!((test.time.as_slice(), test.force.as_slice()), ([0.0, 0.01].as_slice(), [1e3, 3e3].as_slice()));
    }

    #[test]
    fn units_of_a_table_without_headings_are_asked_for_at_once() {
        let columns = [(Channel::Time, "1"), (Channel::Displacement, "2"), (Channel::Force, "3")];
        let columns = columns.map(|(channel, number)| (channel, number.to_owned())).into();
        let options = Options { columns, ..Options::default() };
        let error = parse(&Place::file("a.csv"), "a", "0,1.5,10\n1,2.5,20\n", &options, &Budget::new(0))
            .unwrap_err()
            .to_string();
        assert!(error.contains("--unit time=s --unit displacement=mm --unit force=N"), "{error}");
        assert!(!error.contains("heading"), "{error}");
    }

    #[test]
    fn bad_cells_are_named_by_line_and_column() {
        let error = try_read("time_s,x_mm,force_N\n0,1,1\n1,oops,2\n").unwrap_err().to_string();
        assert!(error.contains("line 3") && error.contains("'x_mm'") && error.contains("'oops'"), "{error}");
        let error = try_read("time_s,x_mm,force_N\n0,01,1,5,10,2\n").unwrap_err().to_string();
        assert!(error.contains("line 2") && error.contains("decimal commas"), "{error}");
        let samples = read("time_s,x_mm,force_N\n0,1,1\n1,NaN,2\n2,,3\n3,1\n");
        assert!(samples.displacement.unwrap()[1..3].iter().all(|v| v.is_nan()) && samples.force[3].is_nan());
    }

    /// Rows of a sine between two times, as text.
    fn rows(from: f64, to: f64, delimiter: &str) -> String {
        let count = ((to - from) * 100.0).round() as usize;
        (0..count)
            .map(|i| {
                let t = from + 0.01 * i as f64;
                format!("{:.5}{delimiter}{:.5}{delimiter}{t:.5}\n", 20.0 * (6.0 * t).sin(), 1.5 * (6.0 * t).cos())
            })
            .collect()
    }

    fn told(samples: &Samples) -> String {
        samples.notes.iter().map(|n| n.text.to_string() + "\n").collect()
    }

    #[test]
    fn events_and_remarks_of_an_acquisition_do_not_cost_the_test() {
        let row = |i: i32| format!("{i},{}.5,{},,\n", i % 7, 10 * i);
        let table = |from: i32, to: i32| (from..to).map(row).collect::<String>();
        let header = "time_s,x_mm,force_N,a,b\n";
        // A time and a text in the place of a reading, or a line of text.
        let text = format!(
            "{header}{}20,Switched from 6 to 9,,,\n{}Pause,,,,\n{}",
            table(0, 20),
            table(21, 40),
            table(40, 60)
        );
        let test = read(&text);
        assert_eq!((test.len(), test.lines[20]), (59, 23));
        let expected = "2 lines between the rows hold no figures and were passed over (line 22, 42), the first: '20 Switched from 6 to 9'";
        assert!(told(&test).contains(expected), "{}", told(&test));
        // Text behind the columns: the row is read without it.
        let text = format!("{header}{}20,1.5,3,,,\"DAQ Pause\",DAQ Stop\n", table(0, 20));
        let test = read(&text);
        assert!(test.len() == 21 && test.force[20] == 3.0, "{test:?}");
        assert!(told(&test).contains("(line 22), the first: 'DAQ Pause DAQ Stop'"), "{}", told(&test));
        // A figure too many may stand anywhere.
        let test = read(&format!("{header}{}20,1,5,3,0,0,0\n", table(0, 20)));
        assert!(test.len() == 20 && told(&test).contains("these rows are left out (line 22)"), "{}", told(&test));
        // Where most rows are like that, the table is another one; where a row has some figures, its fault is one.
        let message = |text: String| try_read(&text).unwrap_err().to_string();
        let every = message(header.to_owned() + &"0,1.5,2,3,4,5,6\n".repeat(20));
        assert!(every.contains("line 2: has 7 fields where the header has 5") && !every.contains("decimal"), "{every}");
        let commas = message("time_s,x_mm,force_N\n".to_owned() + &"0,01,1,5,10\n".repeat(20));
        assert!(commas.contains("decimal commas need quotes"), "{commas}");
        let many = message(format!("{header}{}{}{}", table(0, 9), "pause,,,,\n".repeat(6), table(9, 18)));
        assert!(many.contains("line 11") && many.contains("'pause' is no number"), "{many}");
        let heading = message(format!("{header}{}time_s,force_N,x_mm,,\n{}", table(0, 30), table(30, 60)));
        assert!(heading.contains("line 32"), "{heading}");
    }

    #[test]
    fn acquisitions_of_mts_stations_repeat_their_header() {
        let header = |t: f64| {
            format!(
                "\nData Acquisition: Cyclic\tStation Name: Damper 3\tTime:\t{t:.4}\tSec\t3/22/2004 10:11:12 AM\n\
                 Axial Displacement\tAxial Force\tRunning Time\nmm\tkN\tSec\n"
            )
        };
        let file = |starts: &[f64]| {
            let blocks = starts.iter().map(|t| header(*t) + &rows(*t, t + 2.0, "\t"));
            format!("MTS793|BTW|ENU|1|2|.|/|:|1|0|0|A\n{}", blocks.collect::<String>())
        };
        let going_on = read(&file(&[0.0, 2.0, 10.0]));
        assert_eq!(going_on.len(), 600);
        assert!(going_on.time.windows(2).all(|t| t[1] > t[0]));
        assert!((going_on.displacement.as_ref().unwrap()[1] - 0.02 * 0.06_f64.sin()).abs() < 1e-7);
        assert!((going_on.force[0] - 1500.0).abs() < 1e-9);
        let anew = try_read(&file(&[0.0, 0.0])).unwrap();
        assert_eq!(anew.iter().map(|t| (t.name.as_str(), t.len())).collect::<Vec<_>>(), [("a", 200), ("a 2", 200)]);
        // A text line that is no repeated header is told.
        let stray = file(&[0.0])
            + "operator stopped here\toperator stopped here\toperator stopped here\n"
            + &rows(2.0, 3.0, "\t");
        let stray = read(&stray);
        assert!(stray.len() == 300 && told(&stray).contains("operator stopped"), "{}", told(&stray));
    }

    #[test]
    fn text_exports_of_dyno_software_are_read() {
        // Blocks of remarks, then names with units in brackets; columns by blanks.
        let shock = "SHOCK 6.3 Export\nTest: front left 12 clicks\nGas Force   180 N\n\n\
                     Time (sec)   Stroke (mm)   Velocity (mm/sec)   Force (N)   Temperature (C)\n\
                     0.000        1.0           10.0                200         25.1\n\
                     0.001        1.1           11.0                210         25.1\n";
        let samples = read(shock);
        assert_eq!(
            (samples.force.as_slice(), samples.time.as_slice()),
            ([200.0, 210.0].as_slice(), [0.0, 0.001].as_slice())
        );
        assert_eq!(samples.velocity.unwrap(), [0.01, 0.011]);
        // Raw volts beside every quantity.
        let pairs = "Time (s),Displacement (V),Displacement (mm),Force (V),Force (lbf)\n0,1,2,3,100\n";
        assert!((read(pairs).force[0] - 444.822).abs() < 1e-3);
    }

    #[test]
    fn times_of_day_need_no_unit() {
        for (header, rows) in [
            ("Time,x_mm,F_N", "12:00:59.900,1,2\n12:01:00.000,2,3\n12:01:00.100,3,4\n"),
            (
                "Zeitstempel;Weg [mm];Kraft [N]",
                "01.03.2024 23:59:59,9;1;2\n02.03.2024 00:00:00,0;2;3\n02.03.2024 00:00:00,1;3;4\n",
            ),
            (
                "DateTime\tx_mm\tF_N",
                "2024-03-01T23:59:59.9Z\t1\t2\n2024-03-02T00:00:00.0Z\t2\t3\n2024-03-02T00:00:00.1Z\t3\t4\n",
            ),
            ("Uhrzeit\tx_mm\tF_N", "23:59:59.9\t1\t2\n00:00:00.0\t2\t3\n00:00:00.1\t3\t4\n"),
        ] {
            let samples = read(&format!("{header}\n{rows}"));
            for (time, wanted) in samples.time.iter().zip([0.0, 0.1, 0.2]) {
                assert!((time - wanted).abs() < 1e-5, "{header}: {:?}", samples.time);
            }
        }
        let error = try_read("Time,x_mm,F_N\n0.1,1,2\n").unwrap_err().to_string();
        assert!(error.contains("'Time' has no unit"), "{error}");
    }

    #[test]
    fn chinese_files_in_their_own_encoding_are_read() {
        let (bytes, _, _) = encoding_rs::GB18030.encode("时间(s),位移(mm),阻尼力(kN)\n0,1,0.5\n");
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.csv");
        std::fs::write(&file, &bytes).unwrap();
        let samples = super::read(Source::read(&file).unwrap(), "a", &Options::default()).unwrap();
        assert_eq!(samples[0].force, [500.0]);
    }

    #[test]
    fn columns_are_found_by_name_without_unit_and_by_number() {
        let with = |text: &str, columns: &[(Channel, &str)]| {
            let options = Options {
                columns: columns.iter().map(|(c, h)| (*c, (*h).to_string())).collect(),
                units: [
                    (Channel::Displacement, Unit::Millimetre),
                    (Channel::Force, Unit::Newton),
                    (Channel::Time, Unit::Second),
                ]
                .into(),
                ..Options::default()
            };
            parse(&Place::file("a.csv"), "a", text, &options, &Budget::new(0))
        };
        use Channel::{Displacement, Force, Time};
        let named = with(
            "Abtastung [s];Signal A;Signal B\n0;1;2\n",
            &[(Time, "abtastung"), (Displacement, "signal a"), (Force, "3")],
        );
        assert_eq!(named.unwrap()[0].force, [2.0]);
        let numbers = [(Time, "1"), (Displacement, "2"), (Force, "3")];
        for text in [
            "0;1;2\n0,5;2;3\n",
            "0,1,2\n0.5,2,3\n",
            "0 1 2\n0.5 2 3\n",
            "Messung 7\nk1;k2;k3\n0;1;2\n0,5;2;3\n",
            "# c\n0\t1\t2\n0.5\t2\t3\n",
        ] {
            let read = with(text, &numbers).unwrap_or_else(|e| panic!("{text}: {e}"));
            assert_eq!(
                (read[0].time.as_slice(), read[0].force.as_slice()),
                ([0.0, 0.5].as_slice(), [2.0, 3.0].as_slice()),
                "{text}"
            );
        }
        let message =
            with("Zeit [s];Wegg;Kratf\n0;1;2\n", &[(Displacement, "Weg"), (Force, "Kraft")]).unwrap_err().to_string();
        assert!(message.contains("Is 'Wegg' meant?"), "{message}");
        let message = with("Zeit [s];Weg [mm];Kratf\n0;1;2\n", &[]).unwrap_err().to_string();
        assert!(message.contains("Is 'Kratf' meant?"), "{message}");
    }

    #[test]
    fn options_name_columns_and_units() {
        let text = "time,Load Cell 1,Load Cell 2,x [mm],force_N\n0,1,2,3,4\n";
        let mut options = Options {
            units: BTreeMap::from([(Channel::Time, Unit::Millisecond), (Channel::Force, Unit::Kilonewton)]),
            columns: BTreeMap::from([(Channel::Force, "load cell 1".to_string())]),
            ..Options::default()
        };
        let samples = parse(&Place::file("a.csv"), "a", text, &options, &Budget::new(0)).unwrap().remove(0);
        assert_eq!(samples.force, [1000.0]);
        options.columns.insert(Channel::Force, "Load Cell 9".to_string());
        let error = parse(&Place::file("a.csv"), "a", text, &options, &Budget::new(0)).unwrap_err().to_string();
        assert!(error.contains("'Load Cell 9'") && error.contains("'Load Cell 2'"), "{error}");
    }
}
