//! Reads MDF 2 and 3.
//!
//! Blocks begin with two letters and a length of 16 bits. Links have 32 bits at fixed positions. The file states the
//! byte order of its numbers. The results have the form of the MDF 4 results.

use super::conversion::Conversion;
use super::data::{self, Record};
use super::{CHANNEL, Channel, Format, Group, MOST, NAMING, Stored};
use crate::dates::clock;
use crate::source::Budget;

/// An MDF 2 or 3 file.
struct File<'a> {
    bytes: &'a [u8],
    big_endian: bool,
    budget: &'a Budget,
}

/// A block. Positions of its numbers count from its first byte, as in the MDF standard.
struct Block<'a> {
    file: &'a File<'a>,
    bytes: &'a [u8],
}

/// Largest number of blocks in one chain. A longer chain is circular or does not belong to a measurement.
const CHAIN: usize = 1 << 16;
/// Position of the header block, bytes.
const HEADER: u32 = 64;

/// Returns whether a file states version 2 or 3 of MDF.
pub(super) fn is_one(bytes: &[u8]) -> bool {
    bytes.starts_with(b"MDF     ") && bytes.get(8).is_some_and(|version| [b'2', b'3'].contains(version))
}

/// Reads all groups of the file with their channels, and the date and time of the time zero, s since 1970.
pub(super) fn groups(bytes: &[u8], budget: &Budget) -> Result<(Vec<Group>, Option<f64>), String> {
    let order = bytes.get(24..26).ok_or("it ends in its identification")?;
    let file = File { bytes, big_endian: order != [0, 0], budget };
    let header = file.block(HEADER, "HD")?;
    let mut found = Vec::new();
    for group in file.chain(header.u32(4)?, "DG")? {
        data_group(&file, &group, &mut found)?;
    }
    // The texts of date and time have the form `25:11:2026` and `10:03:22`. A writer without a clock states the first
    // instant of 1980, which counts as no date.
    let text = header.bytes.get(18..36).map(latin).unwrap_or_default();
    let (date, time) = text.split_at_checked(10).unwrap_or_default();
    let begins = clock::seconds(&format!("{} {time}", date.replace(':', ".")));
    Ok((found, begins.filter(|begins| *begins != clock::FIRST_OF_1980)))
}

fn data_group(file: &File<'_>, group: &Block<'_>, found: &mut Vec<Group>) -> Result<(), String> {
    // If a record has two identification numbers, the second one follows the record.
    let ids = usize::from(group.u16(22)?);
    if ids > 2 {
        return Err(format!("it has {ids} record numbers a record; none, one or two are possible"));
    }
    let mut channel_groups = Vec::new();
    for block in file.chain(group.u32(8)?, "CG")? {
        let record = Record {
            id: u64::from(block.u16(16)?),
            variable: false,
            // This length includes the identification number after the record.
            bytes: usize::from(block.u16(20)?) + usize::from(ids == 2),
            count: u64::from(block.u32(22)?),
        };
        channel_groups.push((record, channels(file, block.u32(8)?)?));
        if channel_groups.len() > MOST {
            return Err(format!("it has more than {MOST} groups of channels"));
        }
    }
    let from = group.u32(16)? as usize;
    if from == 0 || channel_groups.iter().all(|(_, channels)| channels.is_empty()) {
        return Ok(());
    }
    // The file does not state the length of the data. They end after the announced number of records.
    let announced = channel_groups.iter().try_fold(0_usize, |sum, (record, _)| {
        let bytes = record.bytes + usize::from(ids > 0);
        usize::try_from(record.count).ok()?.checked_mul(bytes)?.checked_add(sum)
    });
    let end = announced.and_then(|size| size.checked_add(from)).filter(|end| *end <= file.bytes.len());
    let end = end.ok_or("it announces more records than the file holds")?;
    let bytes = &file.bytes[from..end];
    let layout: Vec<Record> = channel_groups.iter().map(|(record, _)| *record).collect();
    let places = data::places(bytes, ids.min(1), &layout, file.budget)?;
    let places_held: u64 = places.iter().map(|starts| 8 * starts.len() as u64).sum();
    for ((record, channels), starts) in channel_groups.into_iter().zip(places) {
        if channels.is_empty() || starts.is_empty() {
            continue;
        }
        let values = starts.len().saturating_mul(channels.len());
        file.budget.numbers(values as u64)?;
        let whole = channels.into_iter().filter(|c| c.format.fits(record.bytes));
        let channels = whole.map(|c| {
            let value = |start: &usize| c.conversion.physical(c.format.number(&bytes[*start..*start + record.bytes]));
            let values = starts.iter().map(value).collect();
            Channel { name: c.name, unit: c.unit, is_time: c.is_time, values }
        });
        found.push(Group { rows: starts.len(), channels: channels.collect() });
    }
    file.budget.free(places_held);
    Ok(())
}

/// Returns the numeric channels of a group.
fn channels(file: &File<'_>, first: u32) -> Result<Vec<Stored>, String> {
    let mut found = Vec::new();
    for block in file.chain(first, "CN")? {
        file.budget.hold(CHANNEL)?;
        file.budget.work(NAMING)?;
        let is_time = block.u16(24)? == 1;
        // The types are unsigned, signed and two widths of floating point, then the same types with explicit byte
        // order. All other types are texts.
        let (kind, big_endian) = match block.u16(190)? {
            kind @ 0..=3 => (kind, file.big_endian),
            kind @ 9..=12 => (kind - 9, true),
            kind @ 13..=16 => (kind - 13, false),
            _ => continue,
        };
        let (start, bits) = (usize::from(block.u16(186)?), u32::from(block.u16(188)?));
        // Newer versions have an additional byte offset beyond the range of the 16-bit bit offset.
        let more = if block.bytes.len() >= 228 { usize::from(block.u16(226)?) } else { 0 };
        // Numeric types as in MDF 4: unsigned, signed, floating.
        let format =
            Format { kind: kind.min(2) as u8, byte: start / 8 + more, bit: (start % 8) as u32, bits, big_endian };
        let conversion = conversion(file, block.u32(8)?)?;
        let mut unit = conversion.unit.clone();
        if is_time && unit.is_empty() {
            unit = "s".into();
        }
        let long = if block.bytes.len() >= 222 { block.u32(218)? } else { 0 };
        let name = match (is_time, file.text(long)) {
            (true, _) => "time".to_owned(),
            (false, Some(long)) => long,
            (false, None) => latin(block.bytes.get(26..58).unwrap_or_default()),
        };
        found.push(Stored { name, unit, is_time, counted: false, format, conversion });
        if found.len() > MOST {
            return Err(format!("a group has more than {MOST} channels"));
        }
    }
    Ok(found)
}

/// Reads the conversion that a channel links to.
fn conversion(file: &File<'_>, at: u32) -> Result<Conversion, String> {
    if at == 0 {
        return Ok(Conversion::default());
    }
    let block = file.block(at, "CC")?;
    let unit = latin(block.bytes.get(22..42).unwrap_or_default());
    let count = usize::from(block.u16(44)?);
    let number = |k: usize| block.f64(46 + 8 * k);
    let numbers = |wanted: usize| -> Result<Vec<f64>, String> {
        if count < wanted {
            return Err(format!("a conversion has {count} numbers where it needs {wanted}"));
        }
        (0..wanted).map(number).collect()
    };
    Ok(match block.u16(42)? {
        0 => Conversion::linear(&numbers(2)?, unit),
        kind @ (1 | 2) => {
            file.budget.numbers(2 * count as u64)?;
            let pairs = (0..count).map(|k| Ok([number(2 * k)?, number(2 * k + 1)?]));
            Conversion::table(pairs.collect::<Result<_, String>>()?, kind == 1, unit)
        }
        9 => Conversion::rational(&numbers(6)?, unit),
        65535 => Conversion::same(unit),
        // A channel with a polynomial of two numbers, a formula or texts is not a measurement of a rig.
        _ => Conversion::none(unit),
    })
}

/// Decodes a text with one byte per character, up to its first zero. Some tools write UTF-8 instead.
fn latin(bytes: &[u8]) -> String {
    let end = bytes.iter().position(|b| *b == 0).unwrap_or(bytes.len());
    let text = match std::str::from_utf8(&bytes[..end]) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes[..end].iter().map(|b| char::from(*b)).collect(),
    };
    text.trim().to_owned()
}

impl<'a> File<'a> {
    /// Returns the block at a position, which must be of the given type.
    fn block(&'a self, at: u32, id: &str) -> Result<Block<'a>, String> {
        let outside = || format!("a block at byte {at} lies outside the file");
        let from = at as usize;
        let head = self.bytes.get(from..from + 4).ok_or_else(outside)?;
        if &head[..2] != id.as_bytes() {
            return Err(format!("at byte {at} there is no {id} block"));
        }
        let length = usize::from(self.number([head[2], head[3]], u16::from_le_bytes, u16::from_be_bytes));
        let bytes = self.bytes.get(from..from + length).ok_or_else(outside)?;
        Ok(Block { file: self, bytes })
    }

    /// Returns a block and all blocks of its chain. The link to the next block is at byte 4, counted from 0.
    fn chain(&'a self, first: u32, id: &str) -> Result<Vec<Block<'a>>, String> {
        let (mut next, mut blocks) = (first, Vec::new());
        while next != 0 {
            let block = self.block(next, id)?;
            next = block.u32(4)?;
            self.budget.hold(32)?;
            self.budget.work(100)?;
            blocks.push(block);
            if blocks.len() > CHAIN.min(self.bytes.len() / 4 + 1) {
                return Err("its blocks lead in a circle".into());
            }
        }
        Ok(blocks)
    }

    /// Returns the text that a link points to, if there is one.
    fn text(&'a self, at: u32) -> Option<String> {
        let block = if at == 0 { None } else { self.block(at, "TX").ok() }?;
        self.budget.hold(block.bytes.len() as u64).ok()?;
        Some(latin(block.bytes.get(4..)?)).filter(|text| !text.is_empty())
    }

    fn number<const N: usize, T>(&self, bytes: [u8; N], little: fn([u8; N]) -> T, big: fn([u8; N]) -> T) -> T {
        if self.big_endian { big(bytes) } else { little(bytes) }
    }
}

impl Block<'_> {
    fn part<const N: usize>(&self, at: usize) -> Result<[u8; N], String> {
        let part = self.bytes.get(at..at + N).and_then(|part| part.try_into().ok());
        part.ok_or_else(|| format!("a {} block is too short", String::from_utf8_lossy(&self.bytes[..2])))
    }

    fn u16(&self, at: usize) -> Result<u16, String> {
        Ok(self.file.number(self.part(at)?, u16::from_le_bytes, u16::from_be_bytes))
    }

    fn u32(&self, at: usize) -> Result<u32, String> {
        Ok(self.file.number(self.part(at)?, u32::from_le_bytes, u32::from_be_bytes))
    }

    fn f64(&self, at: usize) -> Result<f64, String> {
        Ok(self.file.number(self.part(at)?, f64::from_le_bytes, f64::from_be_bytes))
    }
}
