//! Reads delimited text: comma, semicolon or tab; decimal point or comma; comment lines; a row of units.

use std::path::Path;

use csv::{ByteRecord, ReaderBuilder};

use super::error::{Place, RecordError};
use super::options::Options;
use super::samples::Samples;
use super::table::{HEADER_WITHIN, Layout, Rows, is_header, is_units_row, no_header, number};

/// Reads the tests of one delimited text file.
pub(crate) fn read(file: &Path, name: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let bytes = std::fs::read(file).map_err(|source| RecordError::Read { file: file.into(), source })?;
    parse(&Place::file(file), name, &decode(bytes), options)
}

/// Text of a file in UTF-8 or UTF-16 with byte order mark, else read as Latin-1 (old exports, for µ and °).
fn decode(bytes: Vec<u8>) -> String {
    let utf16 = |from: fn([u8; 2]) -> u16| -> String {
        let units: Vec<u16> = bytes[2..].chunks_exact(2).map(|b| from([b[0], b[1]])).collect();
        String::from_utf16_lossy(&units)
    };
    match bytes.as_slice() {
        [0xFF, 0xFE, ..] => return utf16(u16::from_le_bytes),
        [0xFE, 0xFF, ..] => return utf16(u16::from_be_bytes),
        _ => {}
    }
    match String::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => error.into_bytes().iter().map(|&b| b as char).collect(),
    }
}

/// A line that is no data: empty or a comment.
fn is_comment(line: &str) -> bool {
    matches!(line.trim_start().bytes().next(), None | Some(b'#' | b'%')) || line.trim_start().starts_with("//")
}

/// Splits one line at a delimiter, honouring quotes.
fn split(line: &str, delimiter: u8) -> Vec<String> {
    let mut reader =
        ReaderBuilder::new().has_headers(false).delimiter(delimiter).flexible(true).from_reader(line.as_bytes());
    reader.records().next().and_then(Result::ok).map(|r| r.iter().map(str::to_string).collect()).unwrap_or_default()
}

fn parse(at: &Place, name: &str, text: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let text = text.trim_start_matches('\u{feff}');
    // Find the header, and with it the delimiter: the one under which it is a header.
    let mut offset = 0;
    let mut first_line = None;
    let mut found = None;
    for (index, line) in text.split_inclusive('\n').enumerate().take(HEADER_WITHIN) {
        if !is_comment(line) {
            first_line.get_or_insert(line);
            let line = line.trim_end();
            let delimiter = [b'\t', b';', b','].into_iter().find(|&d| is_header(&split(line, d), options));
            if let Some(delimiter) = delimiter {
                found = Some((index, offset, delimiter));
                break;
            }
        }
        offset += line.len();
    }
    let Some(first_line) = first_line else {
        return Err(RecordError::NoData { at: at.clone() });
    };
    let (header_index, offset, delimiter) = found.ok_or_else(|| no_header(at, first_line))?;
    let header_line = header_index + 1;
    let mut lines = text[offset..].split_inclusive('\n');
    let header = split(lines.next().unwrap_or_default().trim_end(), delimiter);
    let below = lines.find(|line| !is_comment(line)).map(|line| split(line.trim_end(), delimiter));
    let mut units = below.filter(|cells| is_units_row(cells));
    if let Some(units) = &mut units {
        units.resize(header.len(), String::new());
    }
    let layout = Layout::new(at, header_line, &header, units.as_deref(), options, false)?;
    let mut rows = Rows::new(at.clone(), name.to_string(), layout);

    let decimal_comma = delimiter != b',';
    let mut reader = ReaderBuilder::new()
        .has_headers(false)
        .delimiter(delimiter)
        .flexible(true)
        .from_reader(&text.as_bytes()[offset..]);
    let mut record = ByteRecord::new();
    let mut values = vec![f64::NAN; rows.layout().columns.len()];
    let mut to_skip = 1 + usize::from(units.is_some());
    while reader.read_byte_record(&mut record).unwrap_or(false) {
        let line = header_index + record.position().map_or(0, |p| p.line() as usize);
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
        if record.len() > header.len() && record.iter().skip(header.len()).any(|cell| !cell.trim_ascii().is_empty()) {
            let hint = if decimal_comma { "" } else { "; decimal commas need a semicolon or tab between the columns" };
            let (found, expected) = (record.len(), header.len());
            return Err(RecordError::Fields { at: at.clone(), line, found, expected, hint });
        }
        for (value, column) in values.iter_mut().zip(&rows.layout().columns) {
            // The text was valid UTF-8 and fields are cut at ASCII bytes, so the fields are valid too.
            let cell = std::str::from_utf8(record.get(column.index).unwrap_or_default()).unwrap_or("?");
            *value = number(cell, decimal_comma).ok_or_else(|| RecordError::Cell {
                at: at.clone(),
                line,
                column: column.heading.clone(),
                text: cell.trim().chars().take(40).collect(),
                hint: if cell.contains(',') && cell.contains('.') {
                    "; write it without thousands separators"
                } else {
                    ""
                },
            })?;
        }
        let test = rows
            .layout()
            .test
            .map(|index| std::str::from_utf8(record.get(index).unwrap_or_default()).unwrap_or("?").to_string());
        rows.push(line, values.iter().copied(), test.as_deref());
    }
    rows.finish(None)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::channel::{Channel, Unit};
    use super::*;

    fn try_read(text: &str) -> Result<Vec<Samples>, RecordError> {
        parse(&Place::file("a.csv"), "a", text, &Options::default())
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
            let samples = read(&decode(bytes));
            assert_eq!(samples.temperature.as_deref(), Some([20.0].as_slice()));
            assert_eq!(samples.displacement.as_deref(), Some([1e-6].as_slice()));
        }
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
    fn bad_cells_are_named_by_line_and_column() {
        let error = try_read("time_s,x_mm,force_N\n0,1,1\n1,oops,2\n").unwrap_err().to_string();
        assert!(error.contains("line 3") && error.contains("'x_mm'") && error.contains("'oops'"), "{error}");
        let error = try_read("time_s,x_mm,force_N\n0,01,1,5,10,2\n").unwrap_err().to_string();
        assert!(error.contains("line 2") && error.contains("decimal commas"), "{error}");
        let samples = read("time_s,x_mm,force_N\n0,1,1\n1,NaN,2\n2,,3\n3,1\n");
        assert!(samples.displacement.unwrap()[1..3].iter().all(|v| v.is_nan()) && samples.force[3].is_nan());
    }

    #[test]
    fn options_name_columns_and_units() {
        let text = "time,Load Cell 1,Load Cell 2,x [mm],force_N\n0,1,2,3,4\n";
        let mut options = Options {
            units: BTreeMap::from([(Channel::Time, Unit::Millisecond), (Channel::Force, Unit::Kilonewton)]),
            columns: BTreeMap::from([(Channel::Force, "load cell 1".to_string())]),
            ..Options::default()
        };
        let samples = parse(&Place::file("a.csv"), "a", text, &options).unwrap().remove(0);
        assert_eq!(samples.force, [1000.0]);
        options.columns.insert(Channel::Force, "Load Cell 9".to_string());
        let error = parse(&Place::file("a.csv"), "a", text, &options).unwrap_err().to_string();
        assert!(error.contains("'Load Cell 9'") && error.contains("'Load Cell 2'"), "{error}");
    }
}
