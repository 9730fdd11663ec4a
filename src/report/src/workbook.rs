//! The tables of a report as one workbook for Excel.
//!
//! Each table has a sheet. The first sheet lists the tables and their origin.
//!
//! A number keeps all its digits, and Excel displays the digits of the page. Equal input gives equal bytes. The date in the file's
//! properties is therefore fixed, and the displayed date is the date of the report.

use crate::blocks::{Block, Column, Section, Table};
use crate::cells::{Cell, Value};
use crate::made::{self, Made};
use crate::words::Words;
use anyhow::Context as _;
use rust_xlsxwriter::{DocProperties, ExcelDateTime, Format, FormatAlign, Workbook as Book, Worksheet, XlsxError};
use std::path::Path;

/// Contents of a workbook.
#[derive(Debug, Clone)]
pub struct Workbook<'a> {
    /// Title of the report.
    pub title: String,
    /// Second line of the first sheet: names of the compared model and data.
    pub subtitle: String,
    /// Sections of the report. Each table of a section becomes a sheet.
    pub sections: Vec<Section>,
    /// Origin of the results.
    pub made: Made,
    /// Texts in the language of the workbook.
    pub words: &'a Words,
}

/// Longest name of a sheet that Excel accepts, UTF-16 units.
const LONGEST_NAME: usize = 31;
/// Largest width of a column, characters. A reader would have to scroll in a wider column.
const WIDEST: usize = 60;
/// Number of first rows that determine the width of a column. Longer texts in further rows are rare.
const ROWS_LOOKED_AT: usize = 1000;

impl Workbook<'_> {
    /// Returns the content of the Excel file.
    ///
    /// # Errors
    /// A table has more rows or columns than a sheet of Excel allows.
    pub fn bytes(&self) -> anyhow::Result<Vec<u8>> {
        Ok(self.book()?.save_to_buffer()?)
    }

    fn book(&self) -> Result<Book, XlsxError> {
        let mut book = Book::new();
        // The author property distinguishes generated workbooks from edited ones (`dashpot_output::Kind`).
        let properties = DocProperties::new()
            .set_author(dashpot_output::AUTHOR)
            .set_title(&self.title)
            .set_creation_datetime(&ExcelDateTime::from_ymd(2000, 1, 1)?);
        book.set_properties(&properties);
        let sheets = self.sheets();
        self.first(book.add_worksheet(), &sheets)?;
        for sheet in &sheets {
            fill_sheet(book.add_worksheet().set_name(&sheet.name)?, sheet.table, self.words)?;
        }
        Ok(book)
    }

    /// Returns all tables with the names of their sheets. Tables of the section on the origin are omitted, because the first sheet contains
    /// the origin.
    fn sheets(&self) -> Vec<Sheet<'_>> {
        let mut sheets: Vec<Sheet<'_>> = Vec::new();
        let parts = self.sections.iter().flat_map(Section::parts).filter(|part| part.id != made::ID);
        for part in parts {
            let mut heading = "";
            for block in &part.blocks {
                match block {
                    Block::Heading(text) => heading = text,
                    Block::Table(table) | Block::Folded(_, table) => {
                        let name = free_name(&part.title, &sheets, self.words);
                        sheets.push(Sheet { name, section: &part.title, heading, table });
                    }
                    _ => {}
                }
            }
        }
        sheets
    }

    /// Writes the title, the result, the list of sheets, and the origin of the workbook.
    fn first(&self, sheet: &mut Worksheet, sheets: &[Sheet<'_>]) -> Result<(), XlsxError> {
        let (bold, wrapped) = (Format::new().set_bold(), Format::new().set_text_wrap().set_align(FormatAlign::Top));
        let large = Format::new().set_bold().set_font_size(14);
        sheet.set_name(safe(self.words.workbook_contents))?;
        sheet.set_column_width(0, LONGEST_NAME as f64)?.set_column_width(1, 100)?.set_column_width(2, 66)?;
        sheet.write_string_with_format(0, 0, &self.title, &large)?;
        sheet.write_string(1, 0, &self.subtitle)?;
        let mut row = 2;
        let mut line = |sheet: &mut Worksheet, text: &str| -> Result<(), XlsxError> {
            sheet.write_string(row, 0, text)?;
            row += 1;
            Ok(())
        };
        for block in self.sections.iter().flat_map(|part| &part.blocks) {
            if let Block::Lead(text) | Block::Verdict(_, text) = block {
                line(sheet, text)?;
            }
        }
        for text in made::lines(&self.made, self.words) {
            line(sheet, &text)?;
        }
        row += 1;
        for (column, text) in (0..).zip([self.words.workbook_sheet, self.words.workbook_about]) {
            sheet.write_string_with_format(row, column, text, &bold)?;
        }
        for listed in sheets {
            row += 1;
            let link = format!("internal:'{}'!A1", listed.name.replace('\'', "''"));
            sheet.write_url_with_text(row, 0, link.as_str(), &listed.name)?;
            sheet.write_string_with_format(row, 1, listed.about(), &wrapped)?;
        }
        if !self.made.files.is_empty() {
            row += 2;
            for (column, text) in (0..).zip([self.words.col_file, self.words.col_bytes, "SHA-256"]) {
                sheet.write_string_with_format(row, column, text, &bold)?;
            }
            for file in &self.made.files {
                row += 1;
                sheet.write_string(row, 0, &file.name)?;
                sheet.write_number(row, 1, file.bytes as f64)?;
                sheet.write_string(row, 2, &file.sha256)?;
            }
        }
        Ok(())
    }
}

/// Writes the workbook. An older workbook is replaced only when the new workbook is complete.
///
/// # Errors
/// A table is too large for a sheet, the folder is missing, or another file exists at the path.
pub fn write_workbook(workbook: &Workbook<'_>, path: &Path) -> anyhow::Result<()> {
    let named = || format!("writing the workbook {}", path.display());
    let bytes = workbook.bytes().with_context(named)?;
    dashpot_output::replace_file(path, &bytes).with_context(named)
}

/// A table with the properties of its sheet.
struct Sheet<'a> {
    name: String,
    section: &'a str,
    heading: &'a str,
    table: &'a Table,
}

impl Sheet<'_> {
    /// Describes the table: its section, the heading above it, and its caption.
    fn about(&self) -> String {
        let texts = [self.section, self.heading, &self.table.caption];
        texts.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" – ")
    }
}

/// Replaces characters that Excel rejects in the name of a sheet by spaces, and limits the length.
fn safe(text: &str) -> String {
    let kept: String = text.chars().map(|c| if "[]:*?/\\".contains(c) { ' ' } else { c }).collect();
    shortened(kept.trim().trim_matches('\''), LONGEST_NAME)
}

/// Truncates a text to `most` UTF-16 units. Excel counts in these units.
fn shortened(text: &str, most: usize) -> String {
    let mut units = 0;
    let fits = |c: &char| {
        units += c.len_utf16();
        units <= most
    };
    text.chars().take_while(fits).collect::<String>().trim_end().to_owned()
}

/// Returns a name for a new sheet: the section's title, with a number if a sheet of that name already exists.
fn free_name(title: &str, sheets: &[Sheet<'_>], words: &Words) -> String {
    let first = safe(title);
    // Excel treats names that differ only in case as equal.
    let same = |a: &str, b: &str| a.to_lowercase() == b.to_lowercase();
    let taken = |name: &str| same(name, &safe(words.workbook_contents)) || sheets.iter().any(|s| same(&s.name, name));
    let numbered = (2..).map(|k: u32| {
        let number = format!(" {k}");
        shortened(&first, LONGEST_NAME - number.len()) + &number
    });
    let mut names = std::iter::once(first.clone()).chain(numbered).filter(|name| !name.is_empty() && !taken(name));
    names.next().unwrap_or(first)
}

/// Layout in the workbook of a column of the report's page.
enum Kind {
    /// Text, or one number.
    One,
    /// A number and its unit in a second column, because the rows have different units.
    WithUnit,
    /// Both ends of an interval, and a column for the unit if the rows have different units.
    Ends(bool),
}

/// Returns the layout in the workbook of the column `place` of a table, and the unit of its cells if they all have one unit.
fn kind(table: &Table, place: usize) -> (Kind, Option<&str>) {
    let mut units: Vec<&str> = Vec::new();
    let mut ends = false;
    for cell in table.rows.iter().filter_map(|row| row.get(place)) {
        match &cell.value {
            Value::Measured(_, unit) | Value::Between(_, unit) if !units.contains(&unit.as_str()) => units.push(unit),
            _ => {}
        }
        ends |= matches!(cell.value, Value::Between(..));
    }
    let one = if units.len() == 1 { units.first().copied().filter(|unit| !unit.is_empty()) } else { None };
    let many = units.len() > 1;
    match (ends, many) {
        (true, many) => (Kind::Ends(many), one),
        (false, true) => (Kind::WithUnit, None),
        (false, false) => (Kind::One, one),
    }
}

fn fill_sheet(sheet: &mut Worksheet, table: &Table, words: &Words) -> Result<(), XlsxError> {
    let heading =
        Format::new().set_bold().set_text_wrap().set_align(FormatAlign::VerticalCenter).set_background_color("E8EEF4");
    let mut at: u16 = 0;
    let width = |sheet: &mut Worksheet, at: u16, text: &str, cells: &[String]| -> Result<(), XlsxError> {
        sheet.write_string_with_format(0, at, text, &heading)?;
        let widest = cells.iter().take(ROWS_LOOKED_AT).map(|c| columns_of(c)).max().unwrap_or(0);
        // A third of the heading's width suffices, because the heading wraps to three lines.
        let wanted = widest.max(columns_of(text).div_ceil(3)).max(10) + 2;
        sheet.set_column_width(at, wanted.min(WIDEST) as f64).map(drop)
    };
    for (place, column) in table.columns.iter().enumerate() {
        let (kind, unit) = kind(table, place);
        let name = named(column, unit);
        let cells: Vec<&Cell> = table.rows.iter().filter_map(|row| row.get(place)).collect();
        let shown: Vec<String> = cells.iter().map(|cell| cell.text.clone()).collect();
        let parts = if matches!(kind, Kind::Ends(_)) { 2 } else { 1 };
        for part in 0..parts {
            let end = [words.col_low, words.col_high][part];
            let text = if parts == 2 { format!("{name} ({end})") } else { name.clone() };
            let wide: &[String] = if parts == 2 { &[] } else { &shown };
            width(sheet, at, &text, wide)?;
            for (row, cell) in (1..).zip(&cells) {
                write_cell(sheet, row, at, cell, part)?;
            }
            at += 1;
        }
        if matches!(kind, Kind::WithUnit | Kind::Ends(true)) {
            width(sheet, at, &format!("{}: {}", column.heading, words.col_unit), &[])?;
            for (row, cell) in (1..).zip(&cells) {
                if let Value::Measured(_, unit) | Value::Between(_, unit) = &cell.value {
                    sheet.write_string(row, at, unit)?;
                }
            }
            at += 1;
        }
    }
    sheet.set_freeze_panes(1, 0)?.set_repeat_rows(0, 0)?.set_landscape().set_print_fit_to_pages(1, 0);
    if let (Some(last), Ok(rows)) = (at.checked_sub(1), u32::try_from(table.rows.len())) {
        sheet.autofilter(0, 0, rows, last)?;
    }
    Ok(())
}

/// Writes one part of a cell: the whole cell, or the low or high end of an interval. If the number is missing or not finite, the cell stays
/// empty.
fn write_cell(sheet: &mut Worksheet, row: u32, at: u16, cell: &Cell, part: usize) -> Result<(), XlsxError> {
    let number = match &cell.value {
        Value::Words => {
            let is_nothing = cell.text.is_empty() || *cell == Cell::none();
            return if is_nothing || part > 0 { Ok(()) } else { sheet.write_string(row, at, &cell.text).map(drop) };
        }
        Value::Number(value) | Value::Measured(value, _) => *value,
        Value::Between(ends, _) => ends[part],
    };
    if !number.is_finite() {
        return Ok(());
    }
    let format = Format::new().set_num_format(number_format(&cell.text));
    sheet.write_number_with_format(row, at, number, &format).map(drop)
}

/// Returns the number format with which Excel displays as many decimals as `text`, the cell's text on the page.
fn number_format(text: &str) -> String {
    let number: String =
        text.chars().skip_while(|c| !c.is_ascii_digit()).take_while(|c| c.is_ascii_digit() || *c == '.').collect();
    let decimals = number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let point = if decimals == 0 { String::new() } else { format!(".{}", "0".repeat(decimals)) };
    if text.contains("\u{b7}10") { format!("0{point}E+00") } else { format!("0{point}") }
}

/// Formats the heading in one line: group, heading, unit of the cells.
fn named(column: &Column, unit: Option<&str>) -> String {
    let mut name = column.heading.replace('\u{a0}', " ");
    if !column.group.is_empty() {
        name = format!("{}: {name}", column.group);
    }
    match unit {
        // The heading may already contain the unit, such as percent.
        Some(unit) if !name.contains(unit) => format!("{name}, {unit}"),
        _ => name,
    }
}

/// Counts the width of a text in units of a Latin letter. Chinese characters have the width 2.
fn columns_of(text: &str) -> usize {
    text.chars().map(|c| if c > '\u{2e80}' { 2 } else { 1 }).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::made::MadeFrom;
    use crate::words::{EN, ZH};
    use calamine::{Data, Reader as _, Xlsx};
    use std::io::Cursor;

    fn made() -> Made {
        let file = MadeFrom { name: "rig/a.csv".into(), bytes: 12, sha256: "00".into() };
        Made { version: "9.9".into(), command: "dashpot x".into(), files: vec![file], ..Made::default() }
    }

    fn table() -> Table {
        Table {
            caption: "What it shows.".into(),
            columns: vec![
                Column::words("test"),
                Column::figures("force,\u{a0}N").in_group("before"),
                Column::figures("value"),
                Column::figures("95 % interval"),
                Column::figures("share"),
            ],
            rows: vec![
                row("=SUM(A1)", 1234.5678, [0.0125, 0.01, 0.02], "m", 0.5),
                row("b", f64::NAN, [2412.0, 2371.0, 2453.0], "N/m", f64::NAN),
            ],
            sortable: true,
        }
    }

    fn row(name: &str, force: f64, [value, low, high]: [f64; 3], unit: &str, share: f64) -> Vec<Cell> {
        let [value, interval] = Cell::with_interval(value, low, high, unit, &EN);
        vec![name.into(), Cell::number(force, crate::numbers::error), value, interval, Cell::fraction(share)]
    }

    fn bytes(words: &'static Words) -> Vec<u8> {
        let long = "A very long title: of [what] / was compared";
        let sections = vec![
            Section::new("a", long, vec![Block::Lead("Close.".into()), Block::Table(table()), Block::Table(table())]),
            made::section(&made(), words),
        ];
        Workbook { title: "Model".into(), subtitle: "a against b".into(), sections, made: made(), words }
            .bytes()
            .unwrap()
    }

    fn read(bytes: Vec<u8>) -> Xlsx<Cursor<Vec<u8>>> {
        Xlsx::new(Cursor::new(bytes)).unwrap()
    }

    #[test]
    fn numbers_are_numbers_in_full_with_their_unit_in_the_heading_or_beside_them() {
        let mut book = read(bytes(&EN));
        let names = book.sheet_names();
        assert_eq!(names, ["Contents", "A very long title  of  what", "A very long title  of  what 2"]);
        let range = book.worksheet_range(&names[1]).unwrap();
        let headings: Vec<String> = range.rows().next().unwrap().iter().map(ToString::to_string).collect();
        assert_eq!(
            headings,
            [
                "test",
                "before: force, N",
                "value",
                "value: unit",
                "95 % interval (low)",
                "95 % interval (high)",
                "95 % interval: unit",
                "share, %"
            ]
        );
        let rows: Vec<&[Data]> = range.rows().skip(1).collect();
        assert_eq!(rows.len(), 2);
        // A text that begins with `=` stays a text.
        assert_eq!(rows[0][0], Data::String("=SUM(A1)".into()));
        assert_eq!(rows[0][1], Data::Float(1234.5678));
        assert_eq!((&rows[0][2], &rows[0][3]), (&Data::Float(12.5), &Data::String("mm".into())));
        assert_eq!((&rows[1][4], &rows[1][5]), (&Data::Float(2.371), &Data::Float(2.453)));
        assert_eq!((&rows[0][7], &rows[1][7]), (&Data::Float(50.0), &Data::Empty));
        assert_eq!(rows[1][1], Data::Empty);
    }

    #[test]
    fn the_first_sheet_says_what_it_is_and_what_it_was_made_from() {
        for words in [&EN, &ZH] {
            let mut book = read(bytes(words));
            let first = book.worksheet_range(&book.sheet_names()[0]).unwrap();
            let cells: Vec<String> = first.rows().flatten().map(ToString::to_string).collect();
            let has = |text: &str| cells.iter().any(|cell| cell.contains(text));
            for text in ["Model", "a against b", "Close.", "9.9", "dashpot x", "rig/a.csv", "What it shows."] {
                assert!(has(text), "{text}");
            }
            assert!(has(words.workbook_sheet));
        }
    }

    #[test]
    fn the_same_input_gives_the_same_bytes_which_are_known_as_our_own() {
        assert!(bytes(&EN) == bytes(&EN));
        assert_eq!(dashpot_output::Kind::detect(&bytes(&EN)), dashpot_output::Kind::Workbook);
    }

    #[test]
    fn digits_are_those_of_the_page() {
        for (text, format) in [("12.50 mm", "0.00"), ("\u{2212}3", "0"), ("2.50\u{b7}10⁸", "0.00E+00"), ("–", "0")]
        {
            assert_eq!(number_format(text), format, "{text}");
        }
    }
}
