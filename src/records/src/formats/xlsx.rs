//! Reads workbooks: every sheet with a header is a source of records.

mod archive;

use calamine::{Data, DataRef, ExcelDateTime, Reader, Xlsx};

use crate::columns::cell::number;
use crate::columns::layout::{Column, Layout};
use crate::columns::non_data_lines::NonDataLines;
use crate::columns::table::{HEADER_WITHIN, Rows, is_header, is_units_row, no_header_near};
use crate::data::samples::Samples;
use crate::data::test_metadata::TestMetadata;
use crate::dates::clock;
use crate::dates::file_dates::Dates;
use crate::error::{Place, RecordError, RecordFileError, SampleError};
use crate::messages::phrases;
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::source::{Budget, Exhausted, Source};

/// Work of opening a sheet, of a cell in addition to its tags, and of a position in a row. A step is about a nanosecond
/// (see [`Budget`]).
const SHEET: u64 = 50_000;
const CELL: u64 = 100;
const PLACE: u64 = 20;
/// Largest number of columns that are read. Rigs have fewer channels.
const COLUMNS: u32 = 1000;

/// Reads the tests of all sheets of a workbook, cell by cell, so that announced sizes and remote cells use no memory.
pub(crate) fn read(source: Source, name: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let Source { file, budget, .. } = &source;
    let broken = |cause: String| RecordError::File(RecordFileError::Workbook { file: file.clone(), cause });
    let mut workbook = open(&source).map_err(broken)?;
    let sheets = workbook.sheet_names();
    let mut tests = Vec::new();
    let mut lines: Vec<(usize, Vec<String>)> = Vec::new();
    for sheet in &sheets {
        budget.work(SHEET + sheets.len() as u64).map_err(|e| e.into_error(&source.place()))?;
        let wrong = |e: calamine::XlsxError| broken(format!("sheet '{sheet}': {e}"));
        let mut cells = match workbook.worksheet_cells_reader(sheet) {
            Ok(cells) => cells,
            // Chart sheets have no cells, so they are skipped.
            Err(calamine::XlsxError::WorksheetNotFound(_) | calamine::XlsxError::NotAWorksheet(_)) => continue,
            Err(error) => return Err(wrong(error)),
        };
        let at = Place { file: file.clone(), part: Some(format!("sheet '{sheet}'")) };
        let test_name = if sheets.len() > 1 { format!("{name} {sheet}") } else { name.to_string() };
        let mut reading = Sheet::new(at, test_name, options, budget);
        let mut row: Vec<Data> = Vec::new();
        let mut row_index = 0;
        while let Some(cell) = cells.next_cell().map_err(wrong)? {
            let (r, c) = cell.get_position();
            budget.work(CELL).map_err(|e| e.into_error(&reading.at))?;
            if r != row_index {
                reading.take(row_index, &row)?;
                row.clear();
                row_index = r;
            }
            if c < COLUMNS && !matches!(cell.get_value(), DataRef::Empty) {
                row.resize(row.len().max(c as usize + 1), Data::Empty);
                row[c as usize] = copied(cell.get_value(), budget).map_err(|e| e.into_error(&reading.at))?;
            }
        }
        reading.take(row_index, &row)?;
        if lines.is_empty() {
            lines = std::mem::take(&mut reading.lines);
        }
        tests.extend(reading.finish()?);
    }
    if tests.is_empty() {
        let first = lines.first().map_or_else(String::new, |(_, cells)| cells.join(", "));
        return Err(no_header_near(&source.place(), &first, &lines));
    }
    Ok(tests)
}

/// Returns the cells of the first nonempty sheet as text, with the number of each row. Intended for short tables.
pub(crate) fn cells_of_workbook(source: &Source) -> Result<Vec<(usize, Vec<String>)>, RecordError> {
    /// Largest number of rows of a short table.
    const ROWS: usize = 10_000;
    let broken = |cause: String| RecordError::File(RecordFileError::Workbook { file: source.file.clone(), cause });
    let mut workbook = open(source).map_err(broken)?;
    for sheet in workbook.sheet_names() {
        let Ok(mut cells) = workbook.worksheet_cells_reader(&sheet) else { continue };
        let mut rows: Vec<(usize, Vec<String>)> = Vec::new();
        while let Some(cell) = cells.next_cell().map_err(|e| broken(format!("sheet '{sheet}': {e}")))? {
            let (row, column) = cell.get_position();
            source.budget.work(CELL).map_err(|e| broken(e.into()))?;
            if column >= COLUMNS || matches!(cell.get_value(), DataRef::Empty) {
                continue;
            }
            if rows.last().is_none_or(|(last, _)| *last != row as usize + 1) {
                if rows.len() == ROWS {
                    return Err(broken(format!(
                        "sheet '{sheet}' has more than {ROWS} rows, which is no table of peaks"
                    )));
                }
                rows.push((row as usize + 1, Vec::new()));
            }
            if let Some((_, cells)) = rows.last_mut() {
                cells.resize(cells.len().max(column as usize + 1), String::new());
                let cell = copied(cell.get_value(), &source.budget).map_err(|e| broken(e.into()))?;
                cells[column as usize] = cell.to_string();
            }
        }
        if !rows.is_empty() {
            return Ok(rows);
        }
    }
    Err(SampleError::NoData { at: source.place() }.into())
}

/// Opens a workbook. Rejects one whose parts do not fit into memory.
fn open(source: &Source) -> Result<Xlsx<archive::Metered<'_>>, String> {
    let metered = archive::check(&source.bytes, &source.budget)?;
    Xlsx::new(metered).map_err(|e: calamine::XlsxError| e.to_string())
}

/// Copies a cell's value. Charges its text to the budget, because thousands of cells may share one text.
fn copied(cell: &DataRef<'_>, budget: &Budget) -> Result<Data, Exhausted> {
    let text = match cell {
        DataRef::SharedString(text) => text.len(),
        DataRef::String(text) | DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => text.len(),
        _ => return Ok(Data::from(cell.clone())),
    };
    // The row, its heading and its messages each store a copy of the text.
    budget.hold(3 * text as u64)?;
    Ok(Data::from(cell.clone()))
}

/// State of reading one sheet row by row.
struct Sheet<'a> {
    at: Place,
    name: String,
    options: &'a Options,
    /// Nonempty lines that the search for the header inspects, and their numbers.
    lines: Vec<(usize, Vec<String>)>,
    beside: NonDataLines,
    budget: &'a Budget,
    /// Rows that the search for the header inspects, as text. They may state the start of the test.
    above: Vec<String>,
    /// Metadata of the test from the rows above the header.
    about: TestMetadata,
    header: Option<(u32, Vec<String>)>,
    units: Option<Vec<String>>,
    rows: Option<Rows>,
}

impl<'a> Sheet<'a> {
    fn new(at: Place, name: String, options: &'a Options, budget: &'a Budget) -> Self {
        Sheet {
            at,
            budget,
            name,
            options,
            lines: Vec::new(),
            above: Vec::new(),
            about: TestMetadata::default(),
            header: None,
            units: None,
            rows: None,
            beside: NonDataLines::default(),
        }
    }

    /// Processes the next row, with its index from 0.
    fn take(&mut self, index: u32, row: &[Data]) -> Result<(), RecordError> {
        if row.is_empty() {
            return Ok(());
        }
        self.budget.work(PLACE * row.len() as u64).map_err(|e| e.into_error(&self.at))?;
        if self.header.is_none() {
            self.inspect_for_header(index, row);
            return Ok(());
        }
        if self.rows.is_none() && !self.begin_rows(index, row)? {
            return Ok(());
        }
        self.add_row(index as usize + 1, row)
    }

    /// Stores a row above the table, and the header once it is found.
    fn inspect_for_header(&mut self, index: u32, row: &[Data]) {
        if self.above.len() < HEADER_WITHIN {
            self.above.push(row.iter().map(with_its_date).collect::<Vec<_>>().join(" "));
            self.about.of_row(row.iter().map(with_its_date));
            let cells = texts(row);
            if cells.iter().any(|c| !c.is_empty()) {
                self.lines.push((index as usize + 1, cells.clone()));
            }
            if is_header(&cells, self.options) {
                self.header = Some((index, cells));
            }
        }
    }

    /// Assigns the columns if a row below the header is the first row of the table, and returns whether it is.
    fn begin_rows(&mut self, index: u32, row: &[Data]) -> Result<bool, RecordError> {
        let Some((header_index, header)) = &self.header else { return Ok(false) };
        if self.units.is_none() {
            let mut cells = texts(row);
            if is_units_row(&cells) {
                cells.resize(header.len().max(cells.len()), String::new());
                self.units = Some(cells);
                return Ok(false);
            }
        }
        if !row.iter().any(|cell| !is_empty(cell) && is_figure(Some(cell))) {
            if !row.iter().all(is_empty) {
                let fault = SampleError::NoData { at: self.at.clone() }.into();
                self.beside.take(false, index as usize + 1, &texts(row), false, fault)?;
            }
            return Ok(false);
        }
        let (line, units) = (*header_index as usize + 1, self.units.as_deref());
        let is_clock = |column: usize| row.get(column).is_some_and(|cell| clock_of(cell).is_some());
        let layout = Layout::with_clock(&self.at, line, header, units, self.options, false, &is_clock)?;
        let mut rows = Rows::new(self.at.clone(), self.name.clone(), layout, self.budget);
        let above = || self.above.iter().map(String::as_str);
        let began = clock::begins(above());
        rows.begins = began.map(|began| began.at);
        rows.dates = Dates::of_lines(above(), began.and_then(|began| began.date));
        rows.about = self.about.clone();
        self.rows = Some(rows);
        Ok(true)
    }

    /// Processes a row below the header, which is a row of the table or another line. `line` counts from 1.
    fn add_row(&mut self, line: usize, row: &[Data]) -> Result<(), RecordError> {
        let Some(rows) = &mut self.rows else { return Ok(()) };
        let columns = &rows.layout().columns;
        if !columns.iter().any(|c| row.get(c.index).is_some_and(|cell| !is_empty(cell))) {
            return Ok(());
        }
        let text_in = |c: &&Column| !is_figure(row.get(c.index));
        let time = columns.iter().find(|c| c.channel == Channel::Time);
        let figures = columns
            .iter()
            .filter(|c| c.channel != Channel::Time && !text_in(c))
            .filter_map(|c| row.get(c.index))
            .any(|cell| !is_empty(cell));
        // A message of the acquisition system between rows may have a time, but no other number.
        let column = match time {
            Some(time) if figures => Some(time).filter(text_in),
            _ => columns.iter().find(text_in),
        };
        if let Some(column) = column
            && let Some(cell) = row.get(column.index)
        {
            let fault = no_number(&self.at, line, column, cell);
            return self.beside.take(!rows.is_empty(), line, &texts(row), figures, fault);
        }
        self.beside.row()?;
        note_dates(rows, row);
        let values: Vec<f64> =
            rows.layout().columns.iter().map(|column| value(&self.at, line, column, row)).collect::<Result<_, _>>()?;
        let test = rows.layout().test.map(|i| row.get(i).map(ToString::to_string).unwrap_or_default());
        rows.push(line, values.into_iter(), test.as_deref())
    }

    /// Returns the tests of the sheet, or an empty list if the sheet has no header. A header without rows is an error.
    fn finish(mut self) -> Result<Vec<Samples>, RecordError> {
        match (self.rows.take(), &self.header) {
            (Some(mut rows), _) => {
                self.beside.report(&mut rows)?;
                rows.finish(None)
            }
            (None, Some((line, header))) => {
                // Check the header even if there are no rows below it.
                Layout::new(&self.at, *line as usize + 1, header, self.units.as_deref(), self.options, false)?;
                Err(SampleError::NoData { at: self.at }.into())
            }
            (None, None) => Ok(Vec::new()),
        }
    }
}

fn texts(row: &[Data]) -> Vec<String> {
    row.iter().map(ToString::to_string).collect()
}

fn no_number(at: &Place, line: usize, column: &Column, cell: &Data) -> RecordError {
    let error = SampleError::Cell {
        at: at.clone(),
        line,
        column: column.heading.clone(),
        text: cell.to_string().chars().take(40).collect(),
        hint: Some(phrases::FORMAT_AS_NUMBERS),
    };
    error.into()
}

/// Adds the times of day in a row to the evidence for the order of day and month.
fn note_dates(rows: &mut Rows, row: &[Data]) {
    let clocks: Vec<usize> = rows.layout().columns.iter().filter(|c| c.clock).map(|c| c.index).collect();
    for cell in clocks.iter().filter_map(|index| row.get(*index)) {
        // A column of dates has precedence over the lines above the table.
        if rows.is_empty() {
            rows.dates = Dates::default();
        }
        if let (Data::DateTimeIso(text) | Data::String(text), true) = (cell, rows.is_empty() || rows.dates.is_open()) {
            rows.dates.see(text);
        }
    }
}

/// Returns the value of a column in a row, in the file's unit.
fn value(at: &Place, line: usize, column: &Column, row: &[Data]) -> Result<f64, RecordError> {
    Ok(match row.get(column.index) {
        Some(cell) if column.clock && clock_of(cell).is_some() => clock_of(cell).unwrap_or(f64::NAN),
        Some(Data::Float(v)) if v.is_finite() => *v,
        Some(Data::Int(v)) => *v as f64,
        None | Some(Data::Empty | Data::Float(_) | Data::Error(_)) => f64::NAN,
        Some(other) => number(&other.to_string(), true).ok_or_else(|| no_number(at, line, column, other))?,
    })
}

fn is_empty(cell: &Data) -> bool {
    matches!(cell, Data::Empty) || cell.to_string().trim().is_empty()
}

/// Returns whether a cell contains a number or a time. An empty cell counts as a missing number.
fn is_figure(cell: Option<&Data>) -> bool {
    match cell {
        None | Some(Data::Empty | Data::Float(_) | Data::Int(_) | Data::Error(_)) => true,
        Some(cell) => clock_of(cell).is_some() || number(&cell.to_string(), true).is_some(),
    }
}

/// Returns the time, s, of a cell that contains a date or a time, as a value or as text.
///
/// With a date, the time counts from 1970. Without a date, it counts from midnight.
fn clock_of(cell: &Data) -> Option<f64> {
    match cell {
        Data::DateTime(date) => Some(day_of(date).unwrap_or(0.0) + within_day(date)),
        Data::DateTimeIso(text) | Data::String(text) => clock::seconds(text),
        _ => None,
    }
}

/// Returns the day of a cell with a date, s since 1970, or `None` if the cell has only a time or a duration. Workbooks
/// have the epoch 1900 or 1904.
fn day_of(date: &ExcelDateTime) -> Option<f64> {
    let (year, month, day, ..) = date.to_ymd_hms_milli();
    let has_day = date.is_datetime() && date.as_f64() >= 1.0;
    has_day.then(|| clock::seconds(&format!("{year:04}-{month:02}-{day:02} 00:00")))?
}

/// Returns the time of day of a cell, s, or the whole value of a duration.
fn within_day(date: &ExcelDateTime) -> f64 {
    let days = date.as_f64();
    clock::DAY * if day_of(date).is_some() { days - days.floor() } else { days }
}

/// Formats a cell as text. Writes a date as a date, and a time of day as a time.
fn with_its_date(cell: &Data) -> String {
    let Data::DateTime(date) = cell else { return cell.to_string() };
    // Spreadsheets store times as fractions of a day, which cannot represent seconds exactly.
    let time = (within_day(date) * 1e3).round() / 1e3;
    let text = clock::written(day_of(date).unwrap_or(0.0) + time);
    match text.split_once(' ') {
        Some((day, _)) if time == 0.0 => day.to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::*;

    /// Computes the CRC-32 of zip archives.
    fn crc32(data: &[u8]) -> u32 {
        !data.iter().fold(!0_u32, |crc, &byte| {
            (0..8).fold(crc ^ u32::from(byte), |c, _| if c & 1 == 1 { (c >> 1) ^ 0xEDB8_8320 } else { c >> 1 })
        })
    }

    /// Makes an archive of stored (uncompressed) files.
    fn zip(files: &[(String, String)]) -> Vec<u8> {
        let (mut out, mut directory) = (Vec::new(), Vec::new());
        for (name, text) in files {
            let offset = out.len() as u32;
            let size = (text.len() as u32).to_le_bytes();
            let mut common = vec![20, 0, 0, 0, 0, 0, 0, 0, 0, 0];
            common.extend(crc32(text.as_bytes()).to_le_bytes());
            common.extend([size, size].concat());
            common.extend((name.len() as u16).to_le_bytes());
            common.extend([0, 0]);
            out.extend(b"PK\x03\x04");
            out.extend(&common);
            out.extend(name.as_bytes());
            out.extend(text.as_bytes());
            directory.extend(b"PK\x01\x02\x14\x00");
            directory.extend(&common);
            directory.extend([0; 10]);
            directory.extend(offset.to_le_bytes());
            directory.extend(name.as_bytes());
        }
        let (start, size, count) = (out.len() as u32, directory.len() as u32, files.len() as u16);
        out.extend(directory);
        out.extend(b"PK\x05\x06\0\0\0\0");
        out.extend([count.to_le_bytes(), count.to_le_bytes()].concat());
        out.extend([size.to_le_bytes(), start.to_le_bytes()].concat());
        out.extend([0, 0]);
        out
    }

    /// Makes a workbook. Numbers become numeric cells, other texts become text cells.
    fn workbook(sheets: &[(&str, &[&[&str]])]) -> Vec<u8> {
        zip(&parts(sheets))
    }

    /// Returns names and contents of the files in the archive of a workbook.
    fn parts(sheets: &[(&str, &[&[&str]])]) -> Vec<(String, String)> {
        const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
        const RELATIONS: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
        const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
        let mut files = vec![
            ("[Content_Types].xml".to_string(), "<Types/>".to_string()),
            (
                "_rels/.rels".to_string(),
                format!(
                    "<Relationships xmlns=\"{RELATIONS}\"><Relationship Id=\"r1\" Type=\"{OFFICE}/officeDocument\" \
                         Target=\"xl/workbook.xml\"/></Relationships>"
                ),
            ),
        ];
        let (mut list, mut relations) = (String::new(), String::new());
        for (k, (name, rows)) in sheets.iter().enumerate() {
            list += &format!("<sheet name=\"{name}\" sheetId=\"{}\" r:id=\"s{k}\"/>", k + 1);
            relations +=
                &format!("<Relationship Id=\"s{k}\" Type=\"{OFFICE}/worksheet\" Target=\"worksheets/sheet{k}.xml\"/>");
            let mut data = String::new();
            for (r, row) in rows.iter().enumerate() {
                data += &format!("<row r=\"{}\">", r + 1);
                for (c, cell) in row.iter().enumerate() {
                    let at = format!("{}{}", (b'A' + c as u8) as char, r + 1);
                    data += &match cell.parse::<f64>() {
                        _ if cell.is_empty() => String::new(),
                        Ok(_) => format!("<c r=\"{at}\"><v>{cell}</v></c>"),
                        Err(_) => {
                            format!("<c r=\"{at}\" t=\"inlineStr\"><is><t>{cell}</t></is></c>")
                        }
                    };
                }
                data += "</row>";
            }
            files.push((
                format!("xl/worksheets/sheet{k}.xml"),
                format!("<worksheet xmlns=\"{MAIN}\"><sheetData>{data}</sheetData></worksheet>"),
            ));
        }
        files.push((
            "xl/workbook.xml".to_string(),
            format!("<workbook xmlns=\"{MAIN}\" xmlns:r=\"{OFFICE}\"><sheets>{list}</sheets></workbook>"),
        ));
        files.push((
            "xl/_rels/workbook.xml.rels".to_string(),
            format!("<Relationships xmlns=\"{RELATIONS}\">{relations}</Relationships>"),
        ));
        files
    }

    fn read_bytes(bytes: &[u8]) -> Result<Vec<Samples>, RecordError> {
        let mut file = tempfile::Builder::new().suffix(".xlsx").tempfile().unwrap();
        file.write_all(bytes).unwrap();
        read(Source::read(file.path())?, "rig", &Options::default())
    }

    #[test]
    fn every_sheet_with_a_header_is_a_source() {
        let book = workbook(&[
            ("Notes", &[&["measured on a sunny day"]]),
            (
                "slow",
                &[
                    &["Rig 7"],
                    &[],
                    &["Time", "Stroke", "Load"],
                    &["s", "mm", "kN"],
                    &["0", "1.5", "0.1"],
                    &["0.5", "", "0,2"],
                ],
            ),
            ("fast", &[&["t [s]", "v [m/s]", "F [N]", "Test"], &["0", "1", "2", "a"], &["1", "1", "3", "b"]]),
        ]);
        let tests = read_bytes(&book).unwrap();
        assert_eq!(tests.iter().map(|t| t.name.as_str()).collect::<Vec<_>>(), ["rig slow", "a", "b"]);
        assert_eq!(tests[0].force, [100.0, 200.0]);
        assert_eq!(tests[0].lines, [5, 6]);
        let x = tests[0].displacement.as_ref().unwrap();
        assert!(x[0] == 0.0015 && x[1].is_nan());
        assert!(tests[0].at.to_string().ends_with("(sheet 'slow')"));
    }

    #[test]
    fn sizes_that_a_workbook_announces_cost_nothing() {
        const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
        let rows: &[&[&str]] = &[&["time_s", "x_mm", "F_N"], &["0", "1", "2"], &["1", "2", "3"]];
        let book = |sheet: &str, strings: Option<&str>| {
            let mut files = parts(&[("one", rows)]);
            for (name, text) in &mut files {
                if name.contains("sheet0") {
                    *text = text.replace("</sheetData>", &format!("{sheet}</sheetData>"));
                }
            }
            if let Some(strings) = strings {
                files.push(("xl/sharedStrings.xml".into(), format!("<sst xmlns=\"{MAIN}\" {strings}></sst>")));
            }
            read_bytes(&zip(&files))
        };
        // This row contains the last possible cell of a sheet.
        let far = "<row r=\"1048576\"><c r=\"XFD1048576\"><v>1</v></c></row>";
        assert_eq!(book(far, None).unwrap()[0].force, [2.0, 3.0]);
        assert!(book("", Some("uniqueCount=\"12\"")).is_ok());
        let message = book("", Some("count=\"1\" uniqueCount=\"4294967295\"")).unwrap_err().to_string();
        assert!(message.contains("4294967295 strings"), "{message}");
    }

    #[test]
    fn text_below_the_heading_and_below_the_table_is_told_and_not_read() {
        let rows: &[&[&str]] = &[
            &["time_s", "x_mm", "F_N"],
            &["clock", "LVDT", "U9B"],
            &["0", "1", "10"],
            &["1", "2", "20"],
            &["Max", "2", "20"],
            &["end of test"],
        ];
        let test = read_bytes(&workbook(&[("one", rows)])).unwrap().remove(0);
        assert_eq!((test.time.as_slice(), test.force.as_slice()), ([0.0, 1.0].as_slice(), [10.0, 20.0].as_slice()));
        let told: Vec<String> = test.notes.iter().map(|n| n.text.to_string()).collect();
        assert!(
            told.iter().any(|text| text == "line 2, below the heading, holds no figures: 'clock LVDT U9B'"),
            "{told:?}"
        );
        assert!(told.iter().any(|text| text == "from line 5 on, below the table, not read: 'Max 2 20'"), "{told:?}");
        let broken: Vec<&[&str]> = rows.iter().chain(&rows[2..4]).copied().collect();
        let error = read_bytes(&workbook(&[("one", &broken)])).unwrap_err().to_string();
        assert!(error.contains("line 5") && error.contains("'Max' is no number"), "{error}");
    }

    #[test]
    fn dates_of_cells_are_days_and_times_of_the_calendar() {
        use calamine::ExcelDateTimeType::{DateTime, TimeDelta};
        let cell = |days: f64, kind, from_1904| Data::DateTime(ExcelDateTime::new(days, kind, from_1904));
        let morning = clock::seconds("2026-11-25 10:03:22").unwrap();
        let share = (10.0 * 3600.0 + 3.0 * 60.0 + 22.0) / 86_400.0;
        for (days, from_1904) in [(46_351.0, false), (44_889.0, true)] {
            let both = cell(days + share, DateTime, from_1904);
            assert!((clock_of(&both).unwrap() - morning).abs() < 1e-4);
            assert_eq!(with_its_date(&both), "2026-11-25 10:03:22");
            assert_eq!(with_its_date(&cell(days, DateTime, from_1904)), "2026-11-25");
        }
        assert_eq!(with_its_date(&cell(share, DateTime, false)), "10:03:22");
        assert!((clock_of(&cell(1.5, TimeDelta, false)).unwrap() - 1.5 * 86_400.0).abs() < 1e-6);
    }

    #[test]
    fn the_rows_above_the_table_say_when_the_test_began() {
        let rows: &[&[&str]] = &[
            &["Prüfung", "2026-11-25"],
            &["Uhrzeit", "10:03:22"],
            &["time_s", "x_mm", "F_N"],
            &["0", "1", "10"],
            &["1", "2", "20"],
        ];
        let test = read_bytes(&workbook(&[("one", rows)])).unwrap().remove(0);
        assert_eq!(test.begins, clock::seconds("2026-11-25 10:03:22"));
    }

    #[test]
    fn faults_are_named_by_sheet_and_row() {
        let error = read_bytes(&workbook(&[("one", &[&["time_s", "x_mm", "F_N"], &["0", "zero", "1"]])]))
            .unwrap_err()
            .to_string();
        assert!(error.contains("sheet 'one'") && error.contains("line 2") && error.contains("'zero'"), "{error}");
        let error = read_bytes(&workbook(&[("one", &[&["alpha", "beta"]])])).unwrap_err().to_string();
        assert!(error.contains("alpha, beta") && error.contains("Understood"), "{error}");
        assert!(read_bytes(b"no workbook").unwrap_err().to_string().contains("workbook"));
    }
}
