//! Reads TDMS files (National Instruments, TDMS file format internal structure): segments of properties and raw data.
//!
//! A group of channels is a test. The step of a waveform stands in for a time channel; scalings of the linear kind are applied.

mod segments;
mod value;

use std::path::Path;

use super::error::{Place, RecordError};
use super::file_dates::Dates;
use super::options::Options;
use super::samples::Samples;
use super::table::{Layout, Rows, is_header, no_header};
use segments::{Channel, channels};

/// What a message calls these files.
const KIND: &str = "a TDMS file";

/// Reads the tests of one file.
pub(crate) fn read(file: &Path, name: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let bytes = std::fs::read(file).map_err(|source| RecordError::Read { file: file.into(), source })?;
    if bytes.is_empty() {
        return Err(RecordError::EmptyFile { file: file.into() });
    }
    let wrong = |cause: String| RecordError::Binary { file: file.into(), kind: KIND, cause };
    let channels = channels(&bytes).map_err(wrong)?;
    let mut groups: Vec<(&str, Vec<&Channel>)> = Vec::new();
    for channel in channels.iter().filter(|c| !c.values.is_empty()) {
        match groups.iter_mut().find(|(group, _)| *group == channel.group) {
            Some((_, members)) => members.push(channel),
            None => groups.push((&channel.group, vec![channel])),
        }
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
        let at = Place { file: file.into(), part: several.then(|| format!("group '{group}'")) };
        let step = members.iter().find_map(|c| c.step);
        let began = members.iter().find_map(|c| c.begins);
        let header = names(members);
        let units: Vec<String> = members.iter().map(|c| c.unit.clone()).collect();
        let layout = Layout::new(&at, 1, &header, Some(&units), options, step.is_some())?;
        // Channels of one length belong together.
        let length = layout.columns.iter().map(|c| members[c.index].values.len()).max().unwrap_or(0);
        if let Some(column) = layout.columns.iter().find(|c| members[c.index].values.len() != length) {
            let found = members[column.index].values.len();
            let cause = format!("'{}' has {found} values where another channel has {length}", column.heading);
            return Err(wrong(cause));
        }
        let name = if several { format!("{name} {group}") } else { name.to_owned() };
        let mut rows = Rows::new(at, name, layout);
        let columns: Vec<usize> = rows.layout().columns.iter().map(|c| c.index).collect();
        for row in 0..length {
            rows.push(row + 1, columns.iter().map(|c| members[*c].values[row]), None);
        }
        tests.extend(rows.finish(step)?.into_iter().map(|test| test.beginning(began, Dates::default())));
    }
    Ok(tests)
}
