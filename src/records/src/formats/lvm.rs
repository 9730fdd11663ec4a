//! Reads LabVIEW measurement files (`.lvm`): a header of keys for the file and for every packet, then columns. The
//! header of a packet states the units. The time is in one column, in one column per channel, or only stated as a step.
//! A packet that continues the clock of the previous packet belongs to the same test. Any other packet whose time
//! restarts is another test.

use crate::columns::cell::number;
use crate::columns::delimiter::split;
use crate::columns::layout::Layout;
use crate::columns::table::{Rows, is_header, no_header};
use crate::data::samples::Samples;
use crate::dates::clock;
use crate::dates::date_order::DateOrder;
use crate::dates::file_dates::Dates;
use crate::error::{Place, RecordError, RecordFileError, SampleError};
use crate::options::Options;
use crate::quantities::unit::Unit;
use crate::source::{Budget, Exhausted};
use crate::tuning::lvm::TOGETHER;

/// Name of LabVIEW measurement files in messages.
const KIND: &str = "a LabVIEW measurement file";
/// Start of the line that ends a header.
const END: &str = "***End_of_Header***";

/// Returns whether a text is a LabVIEW measurement file.
pub(crate) fn is_one(text: &str) -> bool {
    text.starts_with("LabVIEW Measurement")
}

/// A packet of rows.
struct Packet<'a> {
    /// Line of the column names, from 1.
    line: usize,
    names: Vec<String>,
    /// Keys of the packet's header, each with one cell per column.
    keys: Vec<Vec<String>>,
    /// Lines of numbers, each with its line number, from 1.
    rows: Vec<(usize, &'a str)>,
}

impl Packet<'_> {
    /// Returns the entry of the packet's header for a key and a column.
    fn said(&self, key: &str, column: usize) -> &str {
        let found = self.keys.iter().find(|cells| cells[0].trim() == key);
        found.and_then(|cells| cells.get(column)).map_or("", |cell| cell.trim())
    }

    /// Returns the number under a key for the first channel that has one.
    fn number(&self, key: &str) -> Option<f64> {
        (1..self.names.len()).find_map(|k| number(self.said(key, k), true).filter(|v| v.is_finite()))
    }

    /// Charges the budget for searching the keys for each column name, and each row for each column.
    fn charge(&self, budget: &Budget) -> Result<(), Exhausted> {
        let visits = self.names.len().saturating_mul(4 * self.keys.len() + self.rows.len());
        budget.work(10 * visits as u64)
    }

    fn is_x(&self, column: usize) -> bool {
        self.names[column].trim() == "X_Value"
    }

    /// Returns the clock time at the start of the packet, s since 1970 or since midnight.
    fn clock(&self) -> Option<f64> {
        let column = (1..self.names.len()).find(|k| !self.said("Time", *k).is_empty())?;
        clock::seconds(&format!("{} {}", self.said("Date", column), self.said("Time", column)))
    }

    /// Returns the evidence for the order of day and month in the packet's date.
    fn dates(&self) -> Dates {
        let mut dates = Dates::default();
        (1..self.names.len()).for_each(|k| dates.see(self.said("Date", k)));
        dates.likely = (self.said("Decimal_Separator", 1) == ",").then_some(DateOrder::DayFirst);
        dates
    }
}

/// Reads the tests of a text for which [`is_one`] is true.
pub(crate) fn parse(
    at: &Place,
    name: &str,
    text: &str,
    options: &Options,
    budget: &Budget,
) -> Result<Vec<Samples>, RecordError> {
    let wrong = |cause: String| RecordError::File(RecordFileError::Binary { file: at.file.clone(), kind: KIND, cause });
    let separator = if text.lines().take(40).any(|l| l.starts_with("Separator,")) { b',' } else { b'\t' };
    let packets = packets(text, separator);
    let Some(first) = packets.first() else {
        return Err(SampleError::NoData { at: at.clone() }.into());
    };
    packets.iter().try_for_each(|packet| packet.charge(budget)).map_err(|exhausted| exhausted.into_error(at))?;
    let header = header(first, options, separator);
    if !is_header(&header, options) {
        return Err(no_header(at, &first.names));
    }
    let units: Vec<String> = (0..header.len()).map(|k| first.said("Y_Unit_Label", k).to_owned()).collect();
    let has_x = header.iter().any(|h| h == TIME);
    let step = first.number("Delta_X").filter(|step| *step > 0.0);
    let mut layout = Layout::new(at, first.line, &header, Some(&units), options, step.is_some() && !has_x)?;
    if !has_x && layout.columns.iter().all(|c| c.channel != crate::Channel::Time) {
        // The time from the packet headers becomes the last column.
        layout.columns.push(crate::columns::layout::Column {
            channel: crate::Channel::Time,
            index: usize::MAX,
            unit: Unit::Second,
            heading: "X_Value".into(),
            clock: false,
        });
    }
    let time = layout.columns.iter().position(|c| c.channel == crate::Channel::Time);
    let mut rows = Rows::new(at.clone(), name.to_owned(), layout, budget);
    rows.begins = first.clock();
    rows.dates = first.dates();
    let mut tests: Vec<Rows> = Vec::new();
    let mut last: Option<f64> = None;
    for packet in &packets {
        if packet.names.len() != first.names.len() {
            let (line, found, wanted) = (packet.line, packet.names.len(), first.names.len());
            return Err(wrong(format!("the packet at line {line} has {found} columns where the first has {wanted}")));
        }
        let length = packet.rows.len() as f64 * step.unwrap_or(0.0);
        let start = packet.number("X0").unwrap_or(0.0);
        let mut shift = 0.0;
        for (k, (line, text)) in packet.rows.iter().enumerate() {
            let cells = split(text, separator);
            let mut values = Vec::with_capacity(rows.layout().columns.len());
            for column in &rows.layout().columns {
                if column.index == usize::MAX {
                    values.push(start + k as f64 * step.unwrap_or(1.0));
                    continue;
                }
                let cell = cells.get(column.index).map_or("", String::as_str);
                values.push(number(cell, separator != b',').ok_or_else(|| {
                    RecordError::Sample(SampleError::Cell {
                        at: at.clone(),
                        line: *line,
                        column: column.heading.clone(),
                        text: cell.trim().chars().take(40).collect(),
                        hint: None,
                    })
                })?);
            }
            same_clock(packet, &cells, has_x, separator).map_err(|()| {
                wrong(format!("line {line}: its channels have different times; export one time for all"))
            })?;
            let Some(time) = time else { continue };
            if k == 0
                && let (Some(before), now) = (last, values[time])
                && now <= before
            {
                let clocks = rows.begins.zip(packet.clock()).map(|(first, own)| own - first);
                let next = before + step.unwrap_or(0.0);
                if clocks.is_some_and(|clock| (clock + now - next).abs() <= TOGETHER * length) {
                    shift = next - now;
                } else {
                    let layout = rows.layout().clone();
                    let name = format!("{name} {}", tests.len() + 2);
                    tests.push(std::mem::replace(&mut rows, Rows::new(at.clone(), name, layout, budget)));
                    rows.begins = packet.clock();
                    rows.dates = packet.dates();
                }
            }
            values[time] += shift;
            last = Some(values[time]).filter(|t| t.is_finite()).or(last);
            rows.push(*line, values.into_iter(), None)?;
        }
    }
    tests.push(rows);
    let mut read = Vec::new();
    for rows in tests {
        read.extend(rows.finish(step)?);
    }
    Ok(read)
}

/// Heading that replaces `X_Value` as the heading of the time column.
const TIME: &str = "Time [s]";

/// Returns the heading of each column. The first filled `X_Value` column of dimension time becomes [`TIME`], unless the
/// user names a time column. Other `X_Value` columns get an empty heading.
fn header(packet: &Packet<'_>, options: &Options, separator: u8) -> Vec<String> {
    let given = options.columns.contains_key(&crate::Channel::Time);
    let filled = packet.rows.first().map(|(_, text)| split(text, separator)).unwrap_or_default();
    let mut taken = given;
    (0..packet.names.len())
        .map(|k| {
            if !packet.is_x(k) {
                return packet.names[k].clone();
            }
            let dimension = packet.said("X_Dimension", k + 1);
            let is_time = dimension.is_empty() || dimension.eq_ignore_ascii_case("time");
            let there = filled.get(k).is_some_and(|cell| !cell.trim().is_empty());
            if taken || !is_time || !there {
                return String::new();
            }
            taken = true;
            TIME.to_owned()
        })
        .collect()
}

/// Checks that channels with their own times have equal times.
fn same_clock(packet: &Packet<'_>, cells: &[String], has_x: bool, separator: u8) -> Result<(), ()> {
    if !has_x {
        return Ok(());
    }
    let mut times = (0..packet.names.len())
        .filter(|k| packet.is_x(*k))
        .filter_map(|k| number(cells.get(k)?, separator != b','))
        .filter(|t| t.is_finite());
    let first = times.next();
    if first.is_some_and(|first| times.any(|t| (t - first).abs() > 1e-9 * (1.0 + first.abs()))) {
        Err(())
    } else {
        Ok(())
    }
}

/// Splits a file into its packets.
fn packets(text: &str, separator: u8) -> Vec<Packet<'_>> {
    let mut packets: Vec<Packet<'_>> = Vec::new();
    let mut keys: Vec<Vec<String>> = Vec::new();
    // The header of the file comes before the headers of the packets.
    let (mut of_file, mut in_heading, mut names_next, mut special) = (true, true, false, false);
    for (index, line) in text.lines().enumerate() {
        let line = line.trim_end_matches('\r');
        if line.starts_with("***Start_Special***") || line.starts_with("***End_Special***") {
            special = line.starts_with("***Start_Special***");
            continue;
        }
        if special {
            continue;
        }
        if line.starts_with(END) {
            (names_next, in_heading) = (!of_file, of_file);
            of_file = false;
        } else if names_next {
            let names = split(line, separator);
            packets.push(Packet { line: index + 1, names, keys: std::mem::take(&mut keys), rows: Vec::new() });
            (names_next, in_heading) = (false, false);
        } else if line.trim().is_empty() {
        } else if in_heading || line.starts_with("Channels") || !keys.is_empty() {
            if !of_file {
                keys.push(split(line, separator));
            }
        } else if let Some(packet) = packets.last_mut() {
            packet.rows.push((index + 1, line));
        }
    }
    packets.retain(|packet| !packet.rows.is_empty());
    packets
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t.\n\
        Multi_Headings\tYes\nX_Columns\tOne\nTime_Pref\tRelative\nDate\t2024/03/01\nTime\t10:45:47.5\n***End_of_Header***\t\n\t\n";

    /// Writes the header of a packet that began `seconds` after 10:45:47.5.
    fn heading(seconds: f64, columns: &[&str]) -> String {
        let all = |text: &str| columns.iter().map(|_| format!("\t{text}")).collect::<String>();
        let time = format!("10:45:{:09.6}", 47.5 + seconds);
        format!(
            "Channels\t2\nSamples{}\nDate{}\nTime{}\nY_Unit_Label\tmm\tkN\nX_Dimension{}\nX0{}\nDelta_X{}\n***End_of_Header***\t\n{}\n",
            all("3"),
            all("2024/03/01"),
            all(&time),
            all("Time"),
            all("0.0E+0"),
            all("0.5"),
            columns.join("\t")
        )
    }

    fn read(text: &str) -> Result<Vec<Samples>, RecordError> {
        assert!(is_one(text));
        parse(&Place::file("a.lvm"), "a", text, &Options::default(), &Budget::new(0))
    }

    #[test]
    fn one_time_column_none_and_one_a_channel_give_the_same() {
        let one = heading(0.0, &["X_Value", "Displacement", "Force", "Comment"])
            + "0.0\t1\t0.1\n0.5\t2\t0.2\tstart\n1.0\t3\t0.3\n";
        let none =
            heading(0.0, &["X_Value", "Displacement", "Force", "Comment"]) + "\t1\t0,1\n\t2\t0,2\tstart\n\t3\t0,3\n";
        let several = heading(0.0, &["X_Value", "Displacement", "X_Value", "Force", "Comment"])
            .replace("Y_Unit_Label\tmm\tkN", "Y_Unit_Label\tmm\t\tkN\t")
            + "0.0\t1\t0.0\t0.1\n0.5\t2\t0.5\t0.2\n1.0\t3\t1.0\t0.3\n";
        for table in [one, none, several] {
            let text = FILE.to_owned() + &table;
            let test = read(&text).unwrap().remove(0);
            assert_eq!(test.time, [0.0, 0.5, 1.0], "{table}");
            assert_eq!(test.displacement.as_deref(), Some([0.001, 0.002, 0.003].as_slice()));
            for (force, wanted) in test.force.iter().zip([100.0, 200.0, 300.0]) {
                assert!((force - wanted).abs() < 1e-9, "{table}: {:?}", test.force);
            }
            assert_eq!(test.lines[0], FILE.lines().count() + 11, "{table}");
        }
    }

    #[test]
    fn an_empty_time_column_is_seen_with_commas_too() {
        let table = heading(0.0, &["X_Value", "Displacement", "Force", "Comment"]) + "\t1\t0.1\n\t2\t0.2\n\t3\t0.3\n";
        let text = (FILE.to_owned() + &table).replace("Separator\tTab", "Separator\tComma").replace('\t', ",");
        let test = read(&text).unwrap().remove(0);
        assert_eq!(test.time, [0.0, 0.5, 1.0]);
    }

    #[test]
    fn packets_that_go_on_are_one_test_and_others_are_more() {
        let names = ["X_Value", "Displacement", "Force", "Comment"];
        let rows = "\t1\t0.1\n\t2\t0.2\n\t3\t0.3\n";
        let with = |later: &[f64]| {
            let packets: String = later.iter().map(|s| heading(*s, &names) + rows + "\t\n").collect();
            read(&(FILE.to_owned() + &packets)).unwrap()
        };
        let together = with(&[0.0, 1.5, 3.0]);
        assert_eq!(together.len(), 1);
        assert_eq!(together[0].time, (0..9).map(|k| 0.5 * f64::from(k)).collect::<Vec<_>>());
        let apart = with(&[0.0, 7.0]);
        assert_eq!(apart.iter().map(|t| (t.name.as_str(), t.len())).collect::<Vec<_>>(), [("a", 3), ("a 2", 3)]);
        assert_eq!(apart[1].time, [0.0, 0.5, 1.0]);
    }

    #[test]
    fn what_cannot_be_read_is_said() {
        let table = |names: &[&str], rows: &str| FILE.to_owned() + &heading(0.0, names) + rows;
        let said = |text: &str| read(text).unwrap_err().to_string();
        let other = said(&table(&["X_Value", "ax", "ay", "Comment"], "0\t1\t2\n"));
        assert!(other.contains("no header") && other.contains("ax"), "{other}");
        let clocks = table(&["X_Value", "Displacement", "X_Value", "Force"], "0.0\t1\t0.0\t2\n0.5\t1\t0.6\t2\n")
            .replace("Y_Unit_Label\tmm\tkN", "Y_Unit_Label\tmm\t\tkN");
        assert!(said(&clocks).contains("different times"), "{}", said(&clocks));
        let cell = said(&table(&["X_Value", "Displacement", "Force"], "0\t1\toops\n"));
        assert!(cell.contains("'Force'") && cell.contains("'oops'"), "{cell}");
        assert!(said(FILE).contains("no data rows"));
    }

    #[test]
    fn packets_join_over_a_gap_of_a_fiftieth_of_their_length() {
        let names = ["X_Value", "Displacement", "Force", "Comment"];
        let rows = "\t1\t0.1\n\t2\t0.2\n\t3\t0.3\n";
        // A packet lasts 1.5 s.
        let tests = |gap: f64| {
            let packets = heading(0.0, &names) + rows + "\t\n" + &heading(1.5 * (1.0 + gap), &names) + rows;
            read(&(FILE.to_owned() + &packets)).unwrap().len()
        };
        assert_eq!((tests(0.015), tests(-0.015)), (1, 1));
        assert_eq!((tests(0.03), tests(-0.03)), (2, 2));
    }
}
