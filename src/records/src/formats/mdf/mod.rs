//! Reads measurement files of MDF 4 (ASAM MDF 4.x): sorted and unsorted, plain and compressed. Also reads MDF 2 and 3.
//!
//! | file | content |
//! |---|---|
//! | [`blocks`] | blocks and links, each checked against the file size |
//! | [`data`] | the records of a data group, from plain, listed and compressed blocks |
//! | [`conversion`] | conversion of stored numbers to physical values |
//! | [`version3`] | reader of MDF 2 and 3, whose blocks have another form |
//! | this file | groups and channels, and the selection of tests |
//!
//! A group of channels with one time axis is a test. Groups with equal time axes belong together, because loggers may
//! write one group per channel. A group with only the force and a group with only the motion are joined at the times of
//! the slower one. A slow channel with another time axis, such as a temperature, is interpolated at the times of the
//! test.

mod blocks;
mod conversion;
mod data;
mod version3;

use std::borrow::Cow;
use std::collections::HashMap;

use crate::columns::layout::{Layout, channel_of};
use crate::columns::table::{Rows, is_header, no_header};
use crate::data::samples::Samples;
use crate::error::{Place, RecordError, RecordFileError};
use crate::messages::phrases;
use crate::options::Options;
use crate::quantities::channel::Channel as Kind;
use crate::source::{Budget, Exhausted, Source};
use crate::tuning::mdf::TOGETHER;
use blocks::{Block, Mdf};
use conversion::Conversion;
use dashpot_messages::Sentence;

/// Name of MDF files in messages.
const KIND: &str = "an MDF file";
/// Largest number of groups in a file, and of channels in a group. A rig has tens of them.
const MOST: usize = 4096;
/// Memory of a channel without its values, bytes.
const CHANNEL: u64 = 1024;
const NAMING: u64 = 20_000;
/// Work of converting a stored value to a physical value, in steps of about a nanosecond (see [`Budget`]).
const CONVERTING: u64 = 10;

/// Returns whether a file begins like an MDF file, regardless of its name.
pub(crate) fn is_one(bytes: &[u8]) -> bool {
    bytes.starts_with(b"MDF     ")
}

/// Reads the tests of one MDF file.
pub(crate) fn read(source: Source, name: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let Source { file, bytes, budget } = &source;
    let wrong = |cause: String| RecordError::File(RecordFileError::Binary { file: file.clone(), kind: KIND, cause });
    let found = if version3::is_one(bytes) {
        version3::groups(bytes, budget)
    } else {
        Mdf::new(bytes, budget).and_then(|mdf| Ok((groups(&mdf)?, begins(&mdf).ok().flatten())))
    };
    let (groups, begins) = found.map_err(wrong)?;
    let mut joined = joined(groups);
    let of_two_rates = join_rates(&mut joined, options, budget).map_err(|exhausted| wrong(exhausted.into()))?;
    let slow = take_slow(&mut joined, options);
    let resampled: Vec<Vec<String>> = joined
        .iter_mut()
        .map(|test| with_slow(test, &slow, options, budget))
        .collect::<Result<_, _>>()
        .map_err(|exhausted| wrong(exhausted.into()))?;
    let headers: Vec<Vec<&str>> = joined.iter().map(|g| g.channels.iter().map(|c| c.name.as_str()).collect()).collect();
    let recorded: Vec<usize> = (0..joined.len()).filter(|k| is_header(&headers[*k], options)).collect();
    if recorded.is_empty() {
        let all: Vec<&str> = headers.iter().flatten().copied().collect();
        return Err(no_header(&Place::file(file), &all));
    }
    let mut tests = Vec::new();
    for (number, k) in recorded.iter().enumerate() {
        let (at, name) = if recorded.len() == 1 {
            (Place::file(file), name.to_owned())
        } else {
            let part = format!("group {}", number + 1);
            (Place { file: file.clone(), part: Some(part) }, format!("{name} {}", number + 1))
        };
        let channels = &joined[*k].channels;
        let units: Vec<&str> = channels.iter().map(|c| c.unit.as_str()).collect();
        let layout = Layout::new(&at, 1, &headers[*k], Some(&units), options, false)?;
        let mut rows = Rows::new(at, name, layout, budget);
        rows.begins = begins;
        let times: Option<&[f64]> = channels.iter().find(|c| c.is_time).map(|c| c.values.as_slice());
        if let Some((_, names)) = of_two_rates.iter().find(|(time, _)| times.is_some_and(|own| own == time)) {
            let text = Sentence::from(phrases::TWO_RATES).with_names("names", names, phrases::COMMA);
            rows.note("resampled", text);
        }
        if !resampled[*k].is_empty() {
            let text = Sentence::from(phrases::RESAMPLED).with_names("names", &resampled[*k], phrases::COMMA);
            rows.note("resampled", text);
        }
        let columns: Vec<usize> = rows.layout().columns.iter().map(|c| c.index).collect();
        for row in 0..joined[*k].rows {
            rows.push(row + 1, columns.iter().map(|c| channels[*c].values[row]), None)?;
        }
        tests.extend(rows.finish(None)?);
    }
    Ok(tests)
}

/// A channel with its physical values.
struct Channel {
    name: String,
    unit: String,
    is_time: bool,
    values: Vec<f64>,
}

/// Channels with a common time axis.
struct Group {
    rows: usize,
    channels: Vec<Channel>,
}

/// Position and format of a channel's number in a record.
struct Stored {
    name: String,
    unit: String,
    is_time: bool,
    /// Whether the channel is virtual: its value is the number of the record itself.
    counted: bool,
    format: Format,
    conversion: Conversion,
}

/// Storage format of a number.
struct Format {
    kind: u8,
    byte: usize,
    bit: u32,
    bits: u32,
    big_endian: bool,
}

/// Returns the date and time of the file's time zero, s since 1970 by the rig's own clock. Returns `None` if the file
/// states no date.
fn begins(mdf: &Mdf<'_>) -> Result<Option<f64>, String> {
    let header = mdf.block(64, "HD")?;
    // The header states the time in nanoseconds, and the offset of local time in minutes. A flag marks the offset as
    // valid.
    let seconds = header.u64(0)? as f64 * 1e-9;
    let to_local = if header.u8(12)? & 2 == 0 { 0.0 } else { f64::from(header.i16(8)?) + f64::from(header.i16(10)?) };
    Ok((seconds > 0.0).then_some(seconds + 60.0 * to_local))
}

/// Reads all groups of the file with their channels.
fn groups(mdf: &Mdf<'_>) -> Result<Vec<Group>, String> {
    let mut found = Vec::new();
    let header = mdf.block(64, "HD")?;
    let mut next = header.link(0);
    let mut steps = 0;
    while next != 0 {
        mdf.count(&mut steps)?;
        let group = mdf.block(next, "DG")?;
        next = group.link(0);
        read_data_group(mdf, &group, &mut found)?;
    }
    Ok(found)
}

fn read_data_group(mdf: &Mdf<'_>, group: &Block<'_>, found: &mut Vec<Group>) -> Result<(), String> {
    let id_size = usize::from(group.u8(0)?);
    if ![0, 1, 2, 4, 8].contains(&id_size) {
        return Err(format!("its record numbers have {id_size} bytes; 0, 1, 2, 4 or 8 are possible"));
    }
    let mut channel_groups = Vec::new();
    let mut next = group.link(1);
    let mut steps = 0;
    while next != 0 {
        mdf.count(&mut steps)?;
        let block = mdf.block(next, "CG")?;
        next = block.link(0);
        let flags = block.u16(16)?;
        let record = data::Record {
            id: block.u64(0)?,
            variable: flags & 1 != 0,
            bytes: block.u32(24)? as usize + block.u32(28)? as usize,
            count: block.u64(8)?,
        };
        let channels = if record.variable { Vec::new() } else { channels(mdf, block.link(1))? };
        channel_groups.push((record, channels));
        if channel_groups.len() > MOST {
            return Err(format!("it has more than {MOST} groups of channels"));
        }
    }
    let wanted = channel_groups.iter().any(|(_, channels)| !channels.is_empty());
    if !wanted || group.link(2) == 0 {
        return Ok(());
    }
    let layout: Vec<data::Record> = channel_groups.iter().map(|(record, _)| *record).collect();
    let bytes = data::bytes(mdf, group.link(2))?;
    let places = data::places(&bytes, id_size, &layout, mdf.budget)?;
    let places_held: u64 = places.iter().map(|starts| 8 * starts.len() as u64).sum();
    for ((record, channels), starts) in channel_groups.into_iter().zip(places) {
        if channels.is_empty() || starts.is_empty() {
            continue;
        }
        let values = starts.len().saturating_mul(channels.len());
        mdf.budget.numbers(values as u64)?;
        mdf.budget.work(CONVERTING * values as u64)?;
        let channels = channels
            .into_iter()
            .filter(|c| c.counted || c.format.fits(record.bytes))
            .map(|c| {
                let value = |(k, start): (usize, &usize)| {
                    let raw = if c.counted { k as f64 } else { c.format.number(&bytes[*start..*start + record.bytes]) };
                    c.conversion.physical(raw)
                };
                let values = starts.iter().enumerate().map(value).collect();
                Channel { name: c.name, unit: c.unit, is_time: c.is_time, values }
            })
            .collect();
        found.push(Group { rows: starts.len(), channels });
    }
    mdf.budget.free(places_held);
    if let Cow::Owned(bytes) = bytes {
        mdf.budget.free(bytes.len() as u64);
    }
    Ok(())
}

/// Returns the numeric channels of a group.
fn channels(mdf: &Mdf<'_>, first: u64) -> Result<Vec<Stored>, String> {
    const FIXED: u8 = 0;
    const MASTER: u8 = 2;
    const VIRTUAL_MASTER: u8 = 3;
    const VIRTUAL: u8 = 6;
    const TIME: u8 = 1;
    let mut found = Vec::new();
    let mut next = first;
    let mut steps = 0;
    while next != 0 {
        mdf.count(&mut steps)?;
        let block = mdf.block(next, "CN")?;
        next = block.link(0);
        mdf.budget.hold(CHANNEL)?;
        mdf.budget.work(NAMING)?;
        let (kind, sync, data_type) = (block.u8(0)?, block.u8(1)?, block.u8(2)?);
        let numeric = data_type <= 5;
        if !numeric || ![FIXED, MASTER, VIRTUAL_MASTER, VIRTUAL].contains(&kind) {
            continue;
        }
        let is_time = [MASTER, VIRTUAL_MASTER].contains(&kind) && sync <= TIME;
        let conversion = Conversion::read(mdf, block.link(4))?;
        let mut unit = mdf.text(block.link(6));
        if unit.is_empty() {
            unit = conversion.unit.clone();
        }
        if is_time && unit.is_empty() {
            // The unit of time master channels is the second by definition of the format.
            unit = "s".into();
        }
        let name = if is_time { "time".to_owned() } else { mdf.text(block.link(2)) };
        let (bit, byte, bits) = (u32::from(block.u8(3)?), block.u32(4)? as usize, block.u32(8)?);
        let format = Format { kind: data_type / 2, byte, bit, bits, big_endian: data_type % 2 == 1 };
        let counted = [VIRTUAL_MASTER, VIRTUAL].contains(&kind);
        found.push(Stored { name, unit, is_time, counted, format, conversion });
        if found.len() > MOST {
            return Err(format!("a group has more than {MOST} channels"));
        }
    }
    Ok(found)
}

impl Format {
    /// Returns the number of bytes of a record that contain the number.
    fn width(&self) -> usize {
        (self.bit as usize + self.bits as usize).div_ceil(8)
    }

    fn fits(&self, record: usize) -> bool {
        let whole = match self.kind {
            2 => self.bit == 0 && [32, 64].contains(&self.bits),
            _ => self.bits > 0 && self.width() <= 8,
        };
        whole && self.byte.checked_add(self.width()).is_some_and(|end| end <= record)
    }

    /// Returns the number in a record for which [`Self::fits`] is true.
    fn number(&self, record: &[u8]) -> f64 {
        let stored = &record[self.byte..self.byte + self.width()];
        let mut raw = [0_u8; 8];
        raw[..stored.len()].copy_from_slice(stored);
        if self.big_endian {
            raw[..stored.len()].reverse();
        }
        let bits = u64::from_le_bytes(raw);
        match (self.kind, self.bits) {
            (2, 32) => f64::from(f32::from_bits(bits as u32)),
            (2, _) => f64::from_bits(bits),
            (kind, wide) => {
                let shifted = bits >> self.bit;
                let kept = if wide >= 64 { shifted } else { shifted & ((1 << wide) - 1) };
                if kind == 1 && wide < 64 && kept >> (wide - 1) & 1 == 1 {
                    (kept as i64 - (1_i64 << wide)) as f64
                } else if kind == 1 {
                    kept as i64 as f64
                } else {
                    kept as f64
                }
            }
        }
    }
}

/// Channels that may be slower than the motion, because they vary slowly or serve only for comparison.
const SLOW: [Kind; 2] = [Kind::Temperature, Kind::SideForce];

/// Removes and returns the groups with a slow channel but without force and motion. If there are no other groups, it
/// removes none.
fn take_slow(groups: &mut Vec<Group>, options: &Options) -> Vec<Group> {
    let holds = |group: &Group, kinds: &[Kind]| {
        group.channels.iter().any(|c| channel_of(&c.name, options).is_some_and(|kind| kinds.contains(&kind)))
    };
    let is_slow = |group: &Group| {
        group.channels.iter().any(|c| c.is_time)
            && holds(group, &SLOW)
            && !holds(group, &[Kind::Force, Kind::Displacement, Kind::Velocity])
    };
    if groups.iter().all(is_slow) {
        return Vec::new();
    }
    let (slow, tests) = std::mem::take(groups).into_iter().partition(is_slow);
    *groups = tests;
    slow
}

/// Adds missing slow channels to a test, interpolated at the times of the test. Returns their names.
fn with_slow(test: &mut Group, slow: &[Group], options: &Options, budget: &Budget) -> Result<Vec<String>, Exhausted> {
    let Some(time) = test.channels.iter().find(|c| c.is_time).map(|c| c.values.clone()) else { return Ok(Vec::new()) };
    let mut names = Vec::new();
    for group in slow {
        budget.work(NAMING * group.channels.len() as u64)?;
        let Some(theirs) = group.channels.iter().find(|c| c.is_time) else { continue };
        let (Some(from), Some(to), Some(begin), Some(end)) =
            (theirs.values.first(), theirs.values.last(), time.first(), time.last())
        else {
            continue;
        };
        // A group whose times do not overlap the test belongs to another test of the file.
        if from > end || to < begin {
            continue;
        }
        for channel in group.channels.iter().filter(|c| !c.is_time) {
            let Some(kind) = channel_of(&channel.name, options).filter(|kind| SLOW.contains(kind)) else { continue };
            if test.channels.iter().any(|c| channel_of(&c.name, options) == Some(kind)) {
                continue;
            }
            budget.numbers(time.len() as u64)?;
            let values = time.iter().map(|t| at_time(&theirs.values, &channel.values, *t)).collect();
            names.push(channel.name.clone());
            test.channels.push(Channel {
                name: channel.name.clone(),
                unit: channel.unit.clone(),
                is_time: false,
                values,
            });
        }
    }
    Ok(names)
}

/// Interpolates `values` linearly at `time`, s, between the samples at `times`, s. Outside the samples, the result is
/// the value of the nearest sample.
fn at_time(times: &[f64], values: &[f64], time: f64) -> f64 {
    let next = times.partition_point(|t| *t < time);
    match (next.checked_sub(1), values.get(next)) {
        (None, _) => values[0],
        (Some(last), None) => values[last],
        (Some(last), Some(value)) => {
            let share = (time - times[last]) / (times[next] - times[last]);
            values[last] + share * (value - values[last])
        }
    }
}

/// Times of two joined groups, and the names of the channels that were interpolated at these times.
type JoinedAt = (Vec<f64>, Vec<String>);

/// Joins groups that contain only the force with groups that contain only the motion and cover the same time.
///
/// Loggers write channels of different rates into separate groups. The result has the times of the slower group,
/// because its values between the samples are unknown.
fn join_rates(groups: &mut Vec<Group>, options: &Options, budget: &Budget) -> Result<Vec<JoinedAt>, Exhausted> {
    let holds = |group: &Group, kinds: &[Kind]| {
        group.channels.iter().any(|c| channel_of(&c.name, options).is_some_and(|kind| kinds.contains(&kind)))
    };
    budget.work(NAMING * groups.iter().map(|g| 2 * g.channels.len() as u64).sum::<u64>())?;
    let is_timed = |group: &Group| group.channels.iter().any(|c| c.is_time) && group.rows > 1;
    let kinds: Vec<(bool, bool)> = groups
        .iter()
        .map(|g| (holds(g, &[Kind::Force]), holds(g, &[Kind::Displacement, Kind::Velocity]), is_timed(g)))
        .map(|(force, motion, timed)| if timed { (force, motion) } else { (false, false) })
        .collect();
    let span = |group: &Group| {
        let time = &group.channels.iter().find(|c| c.is_time)?.values;
        Some((*time.first()?, *time.last()?))
    };
    let overlap = |a: &Group, b: &Group| {
        let ((a0, a1), (b0, b1)) = (span(a)?, span(b)?);
        let shared = a1.min(b1) - a0.max(b0);
        (shared > TOGETHER * (a1 - a0).min(b1 - b0)).then_some(shared)
    };
    let of_kind = |kind: (bool, bool)| (0..kinds.len()).filter(|k| kinds[*k] == kind).collect::<Vec<usize>>();
    let (forces, motions) = (of_kind((true, false)), of_kind((false, true)));
    budget.work(20 * (forces.len() as u64).saturating_mul(motions.len() as u64))?;
    let (mut told, mut taken) = (Vec::new(), vec![false; groups.len()]);
    for force in forces {
        let shared = |k: &usize| if taken[*k] { None } else { overlap(&groups[force], &groups[*k]).map(|s| (s, *k)) };
        let Some((_, motion)) = motions.iter().filter_map(shared).max_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
        let rate = |k: usize| span(&groups[k]).map_or(0.0, |(from, to)| (groups[k].rows - 1) as f64 / (to - from));
        let (slow, fast) = if rate(motion) <= rate(force) { (motion, force) } else { (force, motion) };
        let clock = |k: usize| groups[k].channels.iter().find(|c| c.is_time).map(|c| c.values.clone());
        let (Some(from), Some(time)) = (clock(fast), clock(slow)) else { continue };
        let other = std::mem::replace(&mut groups[fast], Group { rows: 0, channels: Vec::new() });
        (taken[fast], taken[slow]) = (true, true);
        // Use only times within the range of the faster group.
        let inside =
            |t: f64| from.first().is_some_and(|first| t >= *first) && from.last().is_some_and(|last| t <= *last);
        let kept: Vec<usize> = (0..time.len()).filter(|i| inside(time[*i])).collect();
        let group = &mut groups[slow];
        group.channels.iter_mut().for_each(|c| c.values = kept.iter().map(|i| c.values[*i]).collect());
        group.rows = kept.len();
        let time: Vec<f64> = kept.iter().map(|i| time[*i]).collect();
        let mut names = Vec::new();
        for channel in other.channels.into_iter().filter(|c| !c.is_time) {
            budget.numbers(time.len() as u64)?;
            names.push(channel.name.clone());
            let values = time.iter().map(|t| at_time(&from, &channel.values, *t)).collect();
            group.channels.push(Channel { values, ..channel });
        }
        told.push((time, names));
    }
    let mut places = 0..groups.len();
    groups.retain(|group| places.next().is_some_and(|k| !taken[k] || group.rows > 0));
    Ok(told)
}

/// Joins groups with equal time axes. Groups without a time axis stay separate.
fn joined(groups: Vec<Group>) -> Vec<Group> {
    let mut joined: Vec<Group> = Vec::new();
    // The key consists of bits, so that NaN equals NaN. A map is fast even for thousands of groups.
    let mut by_time: HashMap<Vec<u64>, usize> = HashMap::new();
    for group in groups {
        let time = group.channels.iter().find(|c| c.is_time);
        let Some(bits) = time.map(|time| time.values.iter().map(|t| t.to_bits()).collect::<Vec<u64>>()) else {
            joined.push(group);
            continue;
        };
        match by_time.get(&bits) {
            Some(&place) => joined[place].channels.extend(group.channels.into_iter().filter(|c| !c.is_time)),
            None => {
                by_time.insert(bits, joined.len());
                joined.push(group);
            }
        }
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::*;

    fn group(channels: &[(&str, &str, &[f64])]) -> Group {
        let channel = |(name, unit, values): &(&str, &str, &[f64])| Channel {
            name: (*name).into(),
            unit: (*unit).into(),
            is_time: *name == "time",
            values: values.to_vec(),
        };
        Group { rows: channels[0].2.len(), channels: channels.iter().map(channel).collect() }
    }

    #[test]
    fn force_and_motion_of_two_rates_are_joined_at_the_slower_times() {
        let fine: Vec<f64> = (0..101).map(|k| 0.01 * f64::from(k)).collect();
        let coarse: Vec<f64> = (0..30).map(|k| 0.05 * f64::from(k) - 0.1).collect();
        let force: Vec<f64> = fine.iter().map(|t| 10.0 * t).collect();
        let mut groups = vec![
            group(&[("time", "s", &fine), ("Force", "N", &force), ("Pump", "bar", &fine)]),
            group(&[("time", "s", &coarse), ("Stroke", "mm", &coarse)]),
            group(&[("time", "s", &[8.0, 9.0]), ("Weg", "mm", &[1.0, 2.0])]),
        ];
        let told = join_rates(&mut groups, &Options::default(), &Budget::new(0)).unwrap();
        assert_eq!((told.len(), &told[0].1[..]), (1, &["Force".to_owned(), "Pump".to_owned()][..]));
        assert_eq!(groups.len(), 2, "the later group stays alone");
        let [time, stroke, force, _] = &groups[0].channels[..] else { panic!() };
        assert!(time.values.len() > 18 && time.values == stroke.values && time.values == told[0].0);
        assert!(time.values.iter().zip(&force.values).all(|(t, f)| (f - 10.0 * t).abs() < 1e-9));
    }

    #[test]
    fn a_slow_temperature_is_put_onto_the_times_of_the_test() {
        let (mut options, budget) = (Options::default(), Budget::new(0));
        options.columns.insert(Kind::Temperature, "Rohr".into());
        let times = [0.0, 1.0, 2.0, 3.0, 4.0];
        let test = || group(&[("time", "s", &times), ("force", "N", &times), ("displacement", "mm", &times)]);
        let slow = || group(&[("time", "s", &[1.0, 3.0]), ("Rohr", "degC", &[20.0, 24.0])]);
        let mut groups = vec![slow(), test()];
        let taken = take_slow(&mut groups, &options);
        assert_eq!((taken.len(), groups.len()), (1, 1));
        assert_eq!(with_slow(&mut groups[0], &taken, &options, &budget).unwrap(), ["Rohr"]);
        assert_eq!(groups[0].channels[3].values, [20.0, 20.0, 22.0, 24.0, 24.0]);
        // A slow group without a requested channel stays in the list. A group that covers another time is not joined.
        assert!(take_slow(&mut vec![slow(), test()], &Options::default()).is_empty());
        let later = group(&[("time", "s", &[8.0, 9.0]), ("Rohr", "degC", &[20.0, 24.0])]);
        assert!(with_slow(&mut test(), &[later], &options, &budget).unwrap().is_empty());
    }
}
