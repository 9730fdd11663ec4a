//! Reads text tables whose columns are separated by comma, semicolon, tab, vertical bar or blanks.
//!
//! Recognizes decimal points and commas, comment lines, and a row of units.

mod encoding;
mod header_search;
mod lines;
mod repeated_headers;
mod rows;

use self::encoding::decode;
pub use self::encoding::text;
use self::header_search::{Start, part_names, start, with_tabs};
use self::lines::{is_comment, is_figure};
use self::rows::table;
use super::lvm;
use crate::columns::delimiter::{self, split};
use crate::columns::heading::nearest;
use crate::columns::layout::MOST_COLUMNS;
use crate::columns::table::{HEADER_WITHIN, no_header_near};
use crate::data::samples::Samples;
use crate::error::{ColumnError, Place, RecordError, SampleError};
use crate::options::Options;
use crate::source::{Budget, Source};

/// Reads the tests of one delimited text file.
pub(crate) fn read(source: Source, name: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let at = source.place();
    let Source { bytes, budget, .. } = source;
    let (text, guessed) = decode(&bytes);
    let read = parse(&at, name, &text, options, &budget);
    if guessed
        && matches!(
            read,
            Err(RecordError::Column(ColumnError::Header { .. })
                | RecordError::Column(ColumnError::MissingColumn { .. }))
        )
    {
        // Chinese systems write GB 18030 instead of Latin-1. Only the headings show the difference, so this encoding is
        // tried if they are unknown.
        let (text, _, wrong) = encoding_rs::GB18030.decode(&bytes);
        if !wrong && let Ok(tests) = parse(&at, name, &text, options, &budget) {
            return Ok(tests);
        }
    }
    read
}

/// Longest line in the search for the heading, bytes. The search splits each line with every delimiter.
const LONGEST_LINE: usize = 1 << 20;
/// Memory of a cell in addition to its text, bytes.
const CELL: u64 = 24;

/// Returns the line numbers and the cells of a short text table. The delimiter is that with which the first line has
/// the most columns.
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

fn parse(at: &Place, name: &str, text: &str, options: &Options, budget: &Budget) -> Result<Vec<Samples>, RecordError> {
    let text = text.trim_start_matches('\u{feff}');
    if lvm::is_one(text) {
        return lvm::parse(at, name, text, options, budget);
    }
    if let Some((k, line)) = text.lines().enumerate().take(HEADER_WITHIN).find(|(_, line)| line.len() > LONGEST_LINE) {
        let columns = |delimiter: &u8| line.bytes().filter(|b| b == delimiter).count() + 1;
        let found = delimiter::ALL.iter().map(columns).max().unwrap_or(1);
        if found > MOST_COLUMNS {
            return Err(ColumnError::TooManyColumns { at: at.clone(), line: k + 1, found, most: MOST_COLUMNS }.into());
        }
        return Err(no_header_near::<&str>(at, line, &[]));
    }
    let (found, first_line) = start(text, options);
    let Some(first_line) = first_line else {
        return Err(SampleError::NoData { at: at.clone() }.into());
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
        // A heading of the file resembles a heading that the user stated. The error of the layout names that heading of
        // the file.
        return table(at, name, text, Start::headed(0, 0, delimiter, header), options, budget);
    }
    // Split the lines with the delimiter that gives the most cells, or else at blanks.
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::quantities::channel::Channel;
    use crate::quantities::unit::Unit;

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
    fn a_crank_angle_is_told_what_it_lacks() {
        let message = |text: &str| try_read(text).unwrap_err().to_string();
        for head in [
            "Speed: 6 rpm\nStroke: 50 mm\nCrank angle [deg],Force [N]\n",
            "Drehzahl: 6 1/min\nHub: 50 mm\nKurbelwinkel [°];Kraft [N]\n",
        ] {
            let alone = message(&format!("{head}0,1\n1,2\n"));
            assert!(alone.contains("is the angle of a crank") && alone.contains("column of its own"), "{alone}");
        }
        let without_speed = message("Crank angle [deg],Displacement [mm],Force [N],rpm\n0,1,1,6\n1,2,2,6\n");
        assert!(without_speed.contains("as in 'Speed: 6 rpm'"), "{without_speed}");
        assert!(!without_speed.contains("--sample-rate"), "{without_speed}");
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
            assert_eq!(describe(&test).matches("by its unit alone").count(), guessed, "{header}");
        }
        // A heading that counts only if no other names the quantity has lower precedence than a common name.
        let test = read(
            "time_s,tout [s],Millis,dist [mm],x_mm,forc [N],Lead Force [N],force_N\n1,9,9,9,1,9,9,1\n2,9,9,9,2,9,9,2\n",
        );
        assert_eq!((test.time.as_slice(), test.force.as_slice()), ([1.0, 2.0].as_slice(), [1.0, 2.0].as_slice()));
        // If there is a velocity, another column with a unit of length may be any length.
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

    /// Formats rows of a sine between two times: displacement in mm, force in kN, time in s.
    fn rows(from: f64, to: f64, delimiter: &str) -> String {
        let count = ((to - from) * 100.0).round() as usize;
        (0..count)
            .map(|i| {
                let t = from + 0.01 * i as f64;
                format!("{:.5}{delimiter}{:.5}{delimiter}{t:.5}\n", 20.0 * (6.0 * t).sin(), 1.5 * (6.0 * t).cos())
            })
            .collect()
    }

    fn describe(samples: &Samples) -> String {
        samples.notes.iter().map(|n| n.text.to_string() + "\n").collect()
    }

    #[test]
    fn events_and_remarks_of_an_acquisition_do_not_cost_the_test() {
        let row = |i: i32| format!("{i},{}.5,{},,\n", i % 7, 10 * i);
        let table = |from: i32, to: i32| (from..to).map(row).collect::<String>();
        let header = "time_s,x_mm,force_N,a,b\n";
        // Lines with a time and a text instead of a reading, and lines of text, are skipped with a note.
        let text = format!(
            "{header}{}20,Switched from 6 to 9,,,\n{}Pause,,,,\n{}",
            table(0, 20),
            table(21, 40),
            table(40, 60)
        );
        let test = read(&text);
        assert_eq!((test.len(), test.lines[20]), (59, 23));
        let expected = "2 lines between the rows hold no figures and were passed over (line 22, 42), the first: '20 Switched from 6 to 9'";
        assert!(describe(&test).contains(expected), "{}", describe(&test));
        // Text after the last column does not make the row unusable.
        let text = format!("{header}{}20,1.5,3,,,\"DAQ Pause\",DAQ Stop\n", table(0, 20));
        let test = read(&text);
        assert!(test.len() == 21 && test.force[20] == 3.0, "{test:?}");
        assert!(describe(&test).contains("(line 22), the first: 'DAQ Pause DAQ Stop'"), "{}", describe(&test));
        // The position of a surplus number is unknown, so the row is omitted.
        let test = read(&format!("{header}{}20,1,5,3,0,0,0\n", table(0, 20)));
        assert!(test.len() == 20 && describe(&test).contains("this row is left out (line 22)"), "{}", describe(&test));
        // If most rows have too many fields, the table does not match its heading. A row with only some numbers is an
        // error.
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
        // A note reports a text line that is not a repeated header.
        let stray = file(&[0.0])
            + "operator stopped here\toperator stopped here\toperator stopped here\n"
            + &rows(2.0, 3.0, "\t");
        let stray = read(&stray);
        assert!(stray.len() == 300 && describe(&stray).contains("operator stopped"), "{}", describe(&stray));
    }

    #[test]
    fn text_exports_of_dyno_software_are_read() {
        // Blocks of remarks precede the line of names, which has units in brackets. Blanks separate the columns.
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
        // Each quantity has an additional column of raw volts.
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

    #[test]
    fn a_unit_below_a_heading_names_the_setting_and_an_unread_current_is_noted() {
        let read = |heading: &str, options: &Options| {
            let text = format!("Zeit;Weg;Kraft;{heading}\ns;mm;kN;mA\n0;0;1;400\n1;1;1;400\n");
            parse(&Place::file("a.csv"), "a", &text, options, &Budget::new(0)).unwrap().remove(0)
        };
        let none = Options::default();
        for heading in ["Strom", "Strom Soll", "I"] {
            let samples = read(heading, &none);
            assert_eq!(samples.current, Some(vec![0.4, 0.4]), "{heading}");
            assert_eq!(samples.heading(Channel::Current), format!("{heading} [mA]"));
        }
        let named = Options { columns: BTreeMap::from([(Channel::Setting, "Signal 7".into())]), ..Options::default() };
        assert_eq!(read("Signal 7", &named).heading(Channel::Setting), "Signal 7 [mA]");
        let noted = |samples: &Samples| {
            let notes = samples.notes.iter().filter(|note| note.kind == "unread_current");
            notes.map(|note| note.text.to_string()).collect::<String>()
        };
        let unread = read("Signal 7", &none);
        assert!(unread.current.is_none() && noted(&unread).contains("--column current='Signal 7'"), "{unread:?}");
        // A command in another unit than one of current is named as the setting.
        for (heading, unit) in [("current [%]", "%"), ("PWM duty (%)", "%"), ("Tastgrad", "mA")] {
            let text = format!(
                "Zeit;Weg;Kraft;{heading}\ns;mm;kN;{}\n0;0;1;40\n1;1;1;40\n",
                if unit == "%" { "" } else { "1/100" }
            );
            let samples = parse(&Place::file("a.csv"), "a", &text, &none, &Budget::new(0)).unwrap().remove(0);
            assert!(noted(&samples).contains(&format!("--column setting='{heading}'")), "{samples:?}");
        }
        let ignored = Options { ignore: [Channel::Current].into(), ..Options::default() };
        for other in [read("Signal 7", &named), read("Signal 7", &ignored), read("Strom", &none)] {
            assert_eq!(noted(&other), "");
        }
    }
}
