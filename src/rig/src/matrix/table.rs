//! The test matrix as a CSV file. The file is in mm and mm/s, the units of test engineers, and [`Matrix`] in SI units.

use std::f64::consts::TAU;
use std::path::Path;

use dashpot_messages::format_number;

use super::point::{default_cycles, sine_name};
use super::{Matrix, TestPoint};
use crate::RigError;
use crate::files::{read_table, replace_file};

/// Names of the columns of a matrix file, in the order of writing.
const COLUMNS: [&str; 7] =
    ["name", "amplitude_mm", "frequency_hz", "peak_velocity_mm_s", "mean_displacement_mm", "side_force_n", "cycles"];
const NAME: usize = 0;
const AMPLITUDE: usize = 1;
const FREQUENCY: usize = 2;
const PEAK_VELOCITY: usize = 3;
const MEAN_DISPLACEMENT: usize = 4;
const SIDE_FORCE: usize = 5;
const CYCLES: usize = 6;

impl Matrix {
    /// Reads a matrix from a CSV file.
    ///
    /// Columns (any order, upper or lower case): `name`, `amplitude_mm`, `frequency_hz`, `peak_velocity_mm_s`,
    /// `mean_displacement_mm`, `side_force_n`, `cycles`.
    ///
    /// Two of amplitude A, frequency f and peak velocity Vp are required. The third follows from `Vp = 2 pi A f`. The
    /// other columns may be missing or empty. Comma, semicolon or tab separates the columns (only semicolon or tab in
    /// files with decimal commas). Empty lines and lines that begin with `#` are skipped.
    ///
    /// # Errors
    /// [`RigError::Io`] if the file is not readable; [`RigError::MatrixFile`] or [`RigError::MatrixCell`], with line
    /// and column, if its content is invalid.
    pub fn read(file: &Path) -> Result<Self, RigError> {
        let bytes = read_table(file).map_err(RigError::io("read", file))?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
            RigError::MatrixFile {
                file: file.to_owned(),
                line: 1 + before.iter().filter(|byte| **byte == b'\n').count() as u64,
                problem: "this is not text in UTF-8; save the matrix as CSV (UTF-8)".into(),
            }
        })?;
        parse(file, text.trim_start_matches('\u{feff}'))
    }

    /// Writes the matrix as a CSV file for [`Matrix::read`], and replaces an existing file atomically.
    ///
    /// # Errors
    /// [`RigError::Io`] if the file is not writable.
    pub fn write(&self, file: &Path) -> Result<(), RigError> {
        replace_file(file, |out| out.write_all(self.to_csv().as_bytes()))
    }

    /// Formats the matrix as CSV text.
    pub fn to_csv(&self) -> String {
        let mut text = COLUMNS.join(",");
        text.push('\n');
        for point in self.points() {
            text += &format!(
                "{},{},{},{},{},{},{}\n",
                point.name,
                rounded(point.amplitude_m * 1e3),
                rounded(point.frequency_hz),
                rounded(point.peak_velocity_m_s * 1e3),
                rounded(point.mean_displacement_m * 1e3),
                rounded(point.side_force_n),
                point.cycles
            );
        }
        text
    }
}

/// Formats a value with nine decimals, finer than a rig's resolution, and without trailing zeros.
fn rounded(value: f64) -> String {
    let text = format!("{value:.9}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

fn parse(file: &Path, text: &str) -> Result<Matrix, RigError> {
    let file_error = |line, problem: String| RigError::MatrixFile { file: file.to_owned(), line, problem };
    let header_text = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#')).unwrap_or("");
    let delimiter = [b'\t', b';'].into_iter().find(|d| header_text.as_bytes().contains(d)).unwrap_or(b',');
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .delimiter(delimiter)
        .from_reader(text.as_bytes());

    let mut header: Option<Header> = None;
    let mut points: Vec<TestPoint> = Vec::new();
    let mut lines: Vec<u64> = Vec::new();
    for row in reader.records() {
        let row = row.map_err(|error| {
            let line = error.position().map_or(1, csv::Position::line);
            file_error(line, format!("{error}"))
        })?;
        let line = row.position().map_or(1, csv::Position::line);
        if row.iter().all(str::is_empty) {
            continue;
        }
        let Some(header) = &header else {
            header = Some(Header::read(&row).map_err(|problem| file_error(line, problem))?);
            continue;
        };
        let row = Row { file, line, header, cells: &row, decimal_comma: delimiter != b',' };
        let point = row.point()?;
        if let Some(first) = points.iter().position(|earlier| earlier.name.eq_ignore_ascii_case(&point.name)) {
            return Err(row.fault(
                COLUMNS[NAME],
                format!(
                    "the name '{}' is used in line {} already; every test needs a name of its own",
                    point.name, lines[first]
                ),
            ));
        }
        points.push(point);
        lines.push(line);
    }
    if header.is_none() {
        return Err(file_error(
            1,
            format!("the file is empty; its first line must name the columns, e.g. {}", COLUMNS.join(",")),
        ));
    }
    if points.is_empty() {
        return Err(file_error(2, "the file contains no test below its header; add one line per test".into()));
    }
    Matrix::new(points)
}

/// Positions of the known columns in the file, and the number of all columns in the file.
struct Header {
    places: [Option<usize>; COLUMNS.len()],
    width: usize,
}

impl Header {
    fn read(cells: &csv::StringRecord) -> Result<Self, String> {
        let mut places = [None; COLUMNS.len()];
        for (place, cell) in cells.iter().enumerate() {
            if cell.is_empty() {
                continue;
            }
            let Some(column) = COLUMNS.iter().position(|known| known.eq_ignore_ascii_case(cell)) else {
                return Err(format!(
                    "column {} is called '{cell}', which is not known; the columns are {}",
                    place + 1,
                    COLUMNS.join(", ")
                ));
            };
            if places[column].replace(place).is_some() {
                return Err(format!("column '{}' appears twice; remove one", COLUMNS[column]));
            }
        }
        let given =
            [AMPLITUDE, FREQUENCY, PEAK_VELOCITY].into_iter().filter(|column| places[*column].is_some()).count();
        if given < 2 {
            return Err(format!(
                "two of the columns {}, {} and {} are needed; add them",
                COLUMNS[AMPLITUDE], COLUMNS[FREQUENCY], COLUMNS[PEAK_VELOCITY]
            ));
        }
        Ok(Self { places, width: cells.len() })
    }
}

struct Row<'a> {
    file: &'a Path,
    line: u64,
    header: &'a Header,
    cells: &'a csv::StringRecord,
    decimal_comma: bool,
}

impl Row<'_> {
    fn fault(&self, column: &str, problem: String) -> RigError {
        RigError::MatrixCell { file: self.file.to_owned(), line: self.line, column: column.to_owned(), problem }
    }

    fn text(&self, column: usize) -> Option<&str> {
        let cell = self.cells.get(self.header.places[column]?)?;
        (!cell.is_empty()).then_some(cell)
    }

    fn number(&self, column: usize) -> Result<Option<f64>, RigError> {
        let Some(cell) = self.text(column) else {
            return Ok(None);
        };
        let parsed = if self.decimal_comma { cell.replace(',', ".").parse::<f64>() } else { cell.parse::<f64>() };
        match parsed {
            Ok(value) if value.is_finite() => Ok(Some(value)),
            _ => Err(self.fault(COLUMNS[column], format!("'{cell}' is not a number; write e.g. 12.5"))),
        }
    }

    /// Reads the number in a column, or `None` from an empty or missing cell. Rejects values that are not positive.
    fn positive(&self, column: usize) -> Result<Option<f64>, RigError> {
        match self.number(column)? {
            Some(value) if value <= 0.0 => Err(self
                .fault(COLUMNS[column], format!("{} is not above zero; give a positive number", format_number(value)))),
            value => Ok(value),
        }
    }

    fn point(&self) -> Result<TestPoint, RigError> {
        if self.cells.len() > self.header.width {
            return Err(self.fault(
                &format!("{}", self.header.width + 1),
                format!(
                    "the line has {} values, the header {} columns; remove the surplus (write decimals with a point)",
                    self.cells.len(),
                    self.header.width
                ),
            ));
        }
        let amplitude = self.positive(AMPLITUDE)?.map(|mm| mm * 1e-3);
        let frequency = self.positive(FREQUENCY)?;
        let peak_velocity = self.positive(PEAK_VELOCITY)?.map(|mm_s| mm_s * 1e-3);
        let missing = |column: usize| {
            self.fault(
                COLUMNS[column],
                format!(
                    "no value; give two of {}, {} and {}",
                    COLUMNS[AMPLITUDE], COLUMNS[FREQUENCY], COLUMNS[PEAK_VELOCITY]
                ),
            )
        };
        let (amplitude_m, frequency_hz, peak_velocity_m_s) = match (amplitude, frequency, peak_velocity) {
            (Some(a), Some(f), Some(v)) => (a, f, v),
            (Some(a), Some(f), None) => (a, f, TAU * a * f),
            (Some(a), None, Some(v)) => (a, v / (TAU * a), v),
            (None, Some(f), Some(v)) => (v / (TAU * f), f, v),
            (None, ..) => return Err(missing(AMPLITUDE)),
            (_, None, None) => return Err(missing(FREQUENCY)),
        };
        let cycles = match self.text(CYCLES) {
            None => default_cycles(frequency_hz),
            Some(cell) => cell
                .parse::<u32>()
                .map_err(|_| self.fault(COLUMNS[CYCLES], format!("'{cell}' is not a whole number of cycles")))?,
        };
        let point = TestPoint {
            name: self.text(NAME).map_or_else(|| sine_name(amplitude_m, peak_velocity_m_s, 0), str::to_owned),
            amplitude_m,
            frequency_hz,
            peak_velocity_m_s,
            mean_displacement_m: self.number(MEAN_DISPLACEMENT)?.unwrap_or(0.0) * 1e-3,
            side_force_n: self.number(SIDE_FORCE)?.unwrap_or(0.0),
            cycles,
            road_seed: None,
        };
        point.check().map_err(|fault| self.fault(fault.column, fault.problem))?;
        // The peak velocity is computed from amplitude and frequency, because the stated peak velocity may be rounded.
        Ok(TestPoint { peak_velocity_m_s: TAU * point.amplitude_m * point.frequency_hz, ..point })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::PathBuf;

    fn parsed(text: &str) -> Result<Matrix, RigError> {
        parse(&PathBuf::from("m.csv"), text)
    }

    fn refusal(text: &str) -> String {
        parsed(text).unwrap_err().to_string()
    }

    #[test]
    fn written_matrix_reads_back_the_same() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("matrix.csv");
        let mut points = Matrix::default().points().to_vec();
        points[3].mean_displacement_m = -0.02;
        points[4].side_force_n = 300.0;
        points[5].cycles = 7;
        let matrix = Matrix::new(points).unwrap();
        matrix.write(&file).unwrap();
        let back = Matrix::read(&file).unwrap();
        assert_eq!(back.points().len(), matrix.points().len());
        for (a, b) in back.points().iter().zip(matrix.points()) {
            assert_eq!((&a.name, a.cycles), (&b.name, b.cycles));
            for (a, b) in [
                (a.amplitude_m, b.amplitude_m),
                (a.frequency_hz, b.frequency_hz),
                (a.peak_velocity_m_s, b.peak_velocity_m_s),
                (a.mean_displacement_m, b.mean_displacement_m),
                (a.side_force_n, b.side_force_n),
            ] {
                assert!((a - b).abs() <= 1e-6 * b.abs(), "{a} against {b}");
            }
        }
        assert!(fs::read_to_string(&file).unwrap().contains("a50mm_v1571mm_s,50,5,1570.796326795,0,0,5\n"));
    }

    #[test]
    fn missing_columns_follow_from_the_others() {
        let matrix = parsed("amplitude_mm,peak_velocity_mm_s\n50,1570.796\n\n# a remark\n1,52.36\n").unwrap();
        assert!((matrix.points()[0].frequency_hz - 5.0).abs() < 1e-5);
        assert_eq!(matrix.points()[0].name, "a50mm_v1571mm_s");
        assert_eq!(matrix.points()[1].name, "a01mm_v0052mm_s");
        let matrix = parsed("Frequency_Hz, NAME ,peak_velocity_mm_s\n5,x,1570.796\n").unwrap();
        assert!((matrix.points()[0].amplitude_m - 0.05).abs() < 1e-7);
        for text in ["amplitude_mm;frequency_hz\n12,5;1\n", "amplitude_mm\tfrequency_hz\n12,5\t1\n"] {
            let matrix = parsed(text).unwrap();
            assert!((matrix.points()[0].amplitude_m - 0.0125).abs() < 1e-12, "{text}");
        }
    }

    #[test]
    fn faults_name_file_line_and_column() {
        let header = "name,amplitude_mm,frequency_hz,mean_displacement_mm,side_force_n,cycles\n";
        let row = |row: &str| refusal(&format!("{header}ok,10,1\n{row}\n"));
        for (text, words) in [
            (row("a,ten,1"), "m.csv, line 3, column amplitude_mm: 'ten' is not a number"),
            (row("a,-10,1"), "m.csv, line 3, column amplitude_mm: -10 is not above zero"),
            (row("a,,1"), "m.csv, line 3, column amplitude_mm: no value"),
            (row("a,10,"), "m.csv, line 3, column frequency_hz: no value"),
            (row("a,10,NaN"), "m.csv, line 3, column frequency_hz: 'NaN'"),
            (row("a,10,60"), "m.csv, line 3, column frequency_hz: 60 Hz is outside"),
            (row("a,50,20"), "m.csv, line 3, column frequency_hz: 50.000 mm at 20.0000 Hz needs 6.28 m/s"),
            (row("a,90,0.1"), "m.csv, line 3, column amplitude_mm: amplitude and mean"),
            (row("a,50,1,40"), "m.csv, line 3, column mean_displacement_mm: amplitude and mean"),
            (row("a,10,1,,1e9"), "m.csv, line 3, column side_force_n"),
            (row("a,10,1,,,2.5"), "m.csv, line 3, column cycles: '2.5'"),
            (row("a,10,1,,,0"), "m.csv, line 3, column cycles: 0 cycles"),
            (row("a/b,10,1"), "m.csv, line 3, column name: the name 'a/b' contains '/'"),
            (row("OK,10,1"), "m.csv, line 3, column name: the name 'OK' is used in line 2"),
            (row("a,10,1,0,0,3,9"), "m.csv, line 3, column 7: the line has 7 values"),
            (refusal(""), "m.csv, line 1: the file is empty"),
            (refusal(header), "m.csv, line 2: the file contains no test"),
            (refusal("name,amplitude_mm\n"), "m.csv, line 1: two of the columns"),
            (refusal("name,amplitude\n"), "m.csv, line 1: column 2 is called 'amplitude'"),
            (refusal("amplitude_mm,amplitude_mm\n"), "m.csv, line 1: column 'amplitude_mm' appears twice"),
            (
                refusal("amplitude_mm,frequency_hz,peak_velocity_mm_s\n50,5,785\n"),
                "m.csv, line 2, column peak_velocity_mm_s: 785.000 mm/s contradicts",
            ),
        ] {
            assert!(text.starts_with(words), "{text}");
        }
    }

    #[test]
    fn unreadable_files_are_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("absent.csv");
        assert!(Matrix::read(&file).unwrap_err().to_string().contains("absent.csv"));
        fs::write(&file, b"name,amplitude_mm\n\xff").unwrap();
        let message = Matrix::read(&file).unwrap_err().to_string();
        assert!(message.contains("line 2: this is not text in UTF-8"), "{message}");
    }
}
