//! Reads workbooks: every sheet with a header is a source of records.

use std::path::Path;

use calamine::{Data, Reader, Xlsx, open_workbook};

use super::error::{Place, RecordError};
use super::options::Options;
use super::samples::Samples;
use super::table::{HEADER_WITHIN, Layout, Rows, is_header, is_units_row, no_header, number};

/// Reads the tests of all sheets of a workbook.
pub(crate) fn read(file: &Path, name: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let broken = |cause: String| RecordError::Workbook { file: file.into(), cause };
    let mut workbook: Xlsx<_> = open_workbook(file).map_err(|e: calamine::XlsxError| broken(e.to_string()))?;
    let sheets = workbook.sheet_names();
    let mut tests = Vec::new();
    let mut first_line = None;
    for sheet in &sheets {
        let range = workbook.worksheet_range(sheet).map_err(|e| broken(format!("sheet '{sheet}': {e}")))?;
        let at = Place { file: file.into(), part: Some(format!("sheet '{sheet}'")) };
        let top = range.start().map_or(0, |(row, _)| row as usize);
        let text = |row: &[Data]| row.iter().map(|cell| cell.to_string()).collect::<Vec<String>>();
        let found = range.rows().take(HEADER_WITHIN).position(|row| {
            let cells = text(row);
            if cells.iter().any(|c| !c.is_empty()) {
                first_line.get_or_insert_with(|| cells.join(", "));
            }
            is_header(&cells, options)
        });
        let Some(header_index) = found else { continue };
        let mut rows = range.rows().enumerate().skip(header_index);
        let header = rows.next().map(|(_, row)| text(row)).unwrap_or_default();
        let units = rows.clone().next().map(|(_, row)| text(row)).filter(|cells| is_units_row(cells));
        if units.is_some() {
            rows.next();
        }
        let layout = Layout::new(&at, top + header_index + 1, &header, units.as_deref(), options, false)?;
        let test_name = if sheets.len() > 1 { format!("{name} {sheet}") } else { name.to_string() };
        let mut collected = Rows::new(at.clone(), test_name, layout);
        let mut values = vec![f64::NAN; collected.layout().columns.len()];
        for (index, row) in rows {
            let line = top + index + 1;
            let empty = |cell: &Data| matches!(cell, Data::Empty) || cell.to_string().trim().is_empty();
            let used = |index: usize| row.get(index).is_some_and(|cell| !empty(cell));
            if !collected.layout().columns.iter().any(|c| used(c.index)) {
                continue;
            }
            for (value, column) in values.iter_mut().zip(&collected.layout().columns) {
                *value = match row.get(column.index) {
                    Some(Data::Float(v)) if v.is_finite() => *v,
                    Some(Data::Int(v)) => *v as f64,
                    None | Some(Data::Empty | Data::Float(_) | Data::Error(_)) => f64::NAN,
                    Some(other) => number(&other.to_string(), true).ok_or_else(|| RecordError::Cell {
                        at: at.clone(),
                        line,
                        column: column.heading.clone(),
                        text: other.to_string().chars().take(40).collect(),
                        hint: "; format the cells as numbers",
                    })?,
                };
            }
            let test = collected.layout().test.map(|i| row.get(i).map(|cell| cell.to_string()).unwrap_or_default());
            collected.push(line, values.iter().copied(), test.as_deref());
        }
        tests.extend(collected.finish(None)?);
    }
    if tests.is_empty() {
        return Err(no_header(&Place::file(file), &first_line.unwrap_or_default()));
    }
    Ok(tests)
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::*;

    /// CRC-32 as zip archives use it.
    fn crc32(data: &[u8]) -> u32 {
        !data.iter().fold(!0_u32, |crc, &byte| {
            (0..8).fold(crc ^ u32::from(byte), |c, _| if c & 1 == 1 { (c >> 1) ^ 0xEDB8_8320 } else { c >> 1 })
        })
    }

    /// An archive of stored (uncompressed) files.
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

    /// A workbook; cells that are numbers are written as such, others as text.
    fn workbook(sheets: &[(&str, &[&[&str]])]) -> Vec<u8> {
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
        zip(&files)
    }

    fn read_bytes(bytes: &[u8]) -> Result<Vec<Samples>, RecordError> {
        let mut file = tempfile::Builder::new().suffix(".xlsx").tempfile().unwrap();
        file.write_all(bytes).unwrap();
        read(file.path(), "rig", &Options::default())
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
