//! Reads TDMS files (National Instruments, TDMS file format internal structure): segments of properties and raw data.
//!
//! A group of channels is a test. If there is no time channel, the step of the waveform gives the time. Linear scalings
//! are applied.

mod segments;
mod value;

use std::collections::HashMap;

use crate::columns::layout::Layout;
use crate::columns::table::{Rows, is_header, no_header};
use crate::data::samples::Samples;
use crate::dates::file_dates::Dates;
use crate::error::{Place, RecordError, RecordFileError};
use crate::messages::phrases;
use crate::options::Options;
use crate::source::Source;
use dashpot_messages::Sentence;
use segments::{Channel, channels};

/// Name of TDMS files in messages.
const KIND: &str = "a TDMS file";

/// Reads the tests of one TDMS file.
pub(crate) fn read(source: Source, name: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let Source { file, bytes, budget } = &source;
    let wrong = |cause: String| RecordError::File(RecordFileError::Binary { file: file.clone(), kind: KIND, cause });
    let (channels, cut) = channels(bytes, budget).map_err(wrong)?;
    let mut groups: Vec<(&str, Vec<&Channel>)> = Vec::new();
    let mut by_name: HashMap<&str, usize> = HashMap::new();
    for channel in channels.iter().filter(|c| !c.values.is_empty()) {
        let place = *by_name.entry(&channel.group).or_insert_with(|| {
            groups.push((&channel.group, Vec::new()));
            groups.len() - 1
        });
        groups[place].1.push(channel);
    }
    let names = |members: &[&Channel]| -> Vec<String> { members.iter().map(|c| c.name.clone()).collect() };
    let recorded: Vec<&(&str, Vec<&Channel>)> = groups.iter().filter(|(_, m)| is_header(&names(m), options)).collect();
    if recorded.is_empty() {
        let all: Vec<String> = groups.iter().flat_map(|(_, m)| names(m)).collect();
        return Err(no_header(&Place::file(file), &all));
    }
    let several = recorded.len() > 1;
    let mut tests = Vec::new();
    for (group, members) in recorded {
        let at = Place { file: file.clone(), part: several.then(|| format!("group '{group}'")) };
        let step = members.iter().find_map(|c| c.step);
        let began = members.iter().find_map(|c| c.begins);
        let header = names(members);
        let units: Vec<String> = members.iter().map(|c| c.unit.clone()).collect();
        let layout = Layout::new(&at, 1, &header, Some(&units), options, step.is_some())?;
        // All channels of a test must have equal lengths.
        let lengths = || layout.columns.iter().map(|c| members[c.index].values.len());
        // In a truncated file, one channel may have more values than another channel. The shortest channel then counts.
        let length = if cut { lengths().min() } else { lengths().max() }.unwrap_or(0);
        if let Some(column) = layout.columns.iter().find(|c| members[c.index].values.len() != length && !cut) {
            let found = members[column.index].values.len();
            let cause = format!("'{}' has {found} values where another channel has {length}", column.heading);
            return Err(wrong(cause));
        }
        let name = if several { format!("{name} {group}") } else { name.to_owned() };
        let mut rows = Rows::new(at, name, layout, budget);
        let columns: Vec<usize> = rows.layout().columns.iter().map(|c| c.index).collect();
        if cut {
            rows.note("cut_off", Sentence::from(phrases::CUT_OFF).with("rows", length));
        }
        for row in 0..length {
            rows.push(row + 1, columns.iter().map(|c| members[*c].values[row]), None)?;
        }
        tests.extend(rows.finish(step)?.into_iter().map(|test| test.beginning(began, Dates::default())));
    }
    Ok(tests)
}
