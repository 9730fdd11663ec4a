//! Reads RPC III time histories, a format of MTS test rigs.
//!
//! The header has keys and values in records of 128 bytes. Groups of samples follow. Within a group, the samples are
//! ordered by channel (MTS, RPC III file format, version 1).

use std::collections::HashMap;

use crate::columns::layout::{Layout, MOST_COLUMNS};
use crate::columns::table::{Rows, is_header, no_header};
use crate::data::samples::Samples;
use crate::error::{RecordError, RecordFileError};
use crate::options::Options;
use crate::source::Source;

/// Number of bytes of a header block, of one entry in it, and of the key at the beginning of the entry.
const BLOCK: usize = 512;
const ENTRY: usize = 128;
const KEY: usize = 32;

/// Reads the test of one file.
pub(crate) fn read(source: Source, name: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let (at, bytes) = (source.place(), &source.bytes);
    let wrong = |cause: String| RecordError::File(RecordFileError::Rpc { file: source.file.clone(), cause });
    let header = Header::read(bytes).map_err(wrong)?;
    let names: Vec<&str> =
        (1..=header.channels).map(|n| header.text(&format!("DESC.CHAN_{n}")).unwrap_or("")).collect();
    let units: Vec<&str> =
        (1..=header.channels).map(|n| header.text(&format!("UNITS.CHAN_{n}")).unwrap_or("")).collect();
    if !is_header(&names, options) {
        return Err(no_header(&at, &names));
    }
    let layout = Layout::new(&at, 1, &names, Some(&units), options, true)?;
    let columns: Vec<(usize, f64)> = layout
        .columns
        .iter()
        .map(|c| Ok((c.index, header.scale(c.index + 1)?)))
        .collect::<Result<_, String>>()
        .map_err(wrong)?;
    // The layout contains no time column, because the header states the time step.
    let mut rows = Rows::new(at, name.to_string(), layout, &source.budget);
    for row in 0..header.samples {
        let value = |(channel, scale): &(usize, f64)| scale * header.value(bytes, *channel, row);
        rows.push(row + 1, columns.iter().map(value), None)?;
    }
    rows.finish(Some(header.step))
}

/// The header, with every size checked against the file.
struct Header<'a> {
    entries: HashMap<String, &'a str>,
    channels: usize,
    samples: usize,
    group: usize,
    step: f64,
    start: usize,
    short: bool,
    big_endian: bool,
}

impl<'a> Header<'a> {
    fn read(bytes: &'a [u8]) -> Result<Header<'a>, String> {
        let mut entries: HashMap<String, &str> = HashMap::new();
        let entry = |at: usize| -> Option<(String, &'a str)> {
            let entry = bytes.get(at..at + ENTRY)?;
            let text = |part: &'a [u8]| {
                let end = part.iter().position(|b| *b == 0).unwrap_or(part.len());
                std::str::from_utf8(&part[..end]).ok().map(str::trim)
            };
            Some((text(&entry[..KEY])?.to_ascii_uppercase(), text(&entry[KEY..]).unwrap_or("")))
        };
        match entry(0) {
            Some((key, _)) if key == "FORMAT" => {}
            _ => return Err("it does not begin with the key FORMAT".to_owned()),
        }
        let mut blocks = 1;
        let mut at = 0;
        while at < blocks * BLOCK {
            let Some((key, value)) = entry(at) else { return Err("it ends in its header".to_owned()) };
            if key == "NUM_HEADER_BLOCKS" {
                blocks =
                    value.parse::<usize>().ok().filter(|n| (1..=bytes.len() / BLOCK).contains(n)).ok_or_else(|| {
                        format!("it announces {value} header blocks, and the file has room for {}", bytes.len() / BLOCK)
                    })?;
            }
            if !key.is_empty() {
                entries.insert(key, value);
            }
            at += ENTRY;
        }
        let text = |key: &str| entries.get(key).copied().ok_or_else(|| format!("its header lacks {key}"));
        let number = |key: &str| -> Result<usize, String> {
            let value = text(key)?;
            value.parse::<usize>().map_err(|_| format!("its header says {key} = '{value}', which is no count"))
        };
        let format = text("FORMAT")?;
        if !["BINARY_IEEE_LITTLE_END", "BINARY_IEEE_BIG_END", "BINARY"].contains(&format) {
            return Err(format!("its numbers are written as {format}; read are BINARY_IEEE_LITTLE_END and _BIG_END"));
        }
        if let Ok(kind) = text("FILE_TYPE")
            && kind != "TIME_HISTORY"
        {
            return Err(format!("it holds {kind}, no time history"));
        }
        let short = match text("DATA_TYPE").unwrap_or("SHORT_INTEGER") {
            "SHORT_INTEGER" => true,
            "FLOATING_POINT" => false,
            other => {
                return Err(format!("its samples are of the type {other}; read are SHORT_INTEGER and FLOATING_POINT"));
            }
        };
        let step: f64 = text("DELTA_T")?.parse().ok().filter(|s: &f64| s.is_finite() && *s > 0.0).ok_or_else(|| {
            format!("its header says DELTA_T = '{}', which is no time step", text("DELTA_T").unwrap_or(""))
        })?;
        let (channels, group) = (number("CHANNELS")?, number("PTS_PER_GROUP")?);
        let samples = number("FRAMES")?
            .checked_mul(number("PTS_PER_FRAME")?)
            .ok_or_else(|| "its header announces more samples than any file holds".to_owned())?;
        let start = blocks * BLOCK;
        let size = if short { 2 } else { 4 };
        let room = (bytes.len() - start) / size;
        if channels > MOST_COLUMNS {
            return Err(format!("its header announces {channels} channels; at most {MOST_COLUMNS} are read"));
        }
        let groups = if group == 0 { 0 } else { samples.div_ceil(group) };
        let needed = groups.checked_mul(group).and_then(|n| n.checked_mul(channels));
        // Check each count separately too. If one count is zero, the product is zero and always fits.
        if channels == 0 || group == 0 || group > room || samples == 0 || needed.is_none_or(|n| n > room) {
            return Err(format!(
                "its header announces {samples} samples of {channels} channels in groups of {group}, and the file holds {room} \
                 values"
            ));
        }
        let big_endian = format == "BINARY_IEEE_BIG_END";
        Ok(Header { entries, channels, samples, group, step, start, short, big_endian })
    }

    fn text(&self, key: &str) -> Option<&'a str> {
        self.entries.get(key).copied()
    }

    /// Returns the factor for a channel's stored numbers. Floating-point samples are already in the unit.
    fn scale(&self, channel: usize) -> Result<f64, String> {
        if !self.short {
            return Ok(1.0);
        }
        let key = format!("SCALE.CHAN_{channel}");
        let text = self.text(&key).ok_or_else(|| format!("its header lacks {key}"))?;
        let scale = text.parse::<f64>().ok().filter(|s| s.is_finite() && *s != 0.0);
        scale.ok_or_else(|| format!("its header says {key} = '{text}', which is no scale"))
    }

    fn value(&self, bytes: &[u8], channel: usize, sample: usize) -> f64 {
        let size = if self.short { 2 } else { 4 };
        let (group, within) = (sample / self.group, sample % self.group);
        let at = self.start + size * ((group * self.channels + channel) * self.group + within);
        // The constructor has checked the sizes against the file.
        let mut raw = [0; 4];
        raw[..size].copy_from_slice(&bytes[at..at + size]);
        match (self.short, self.big_endian) {
            (true, false) => f64::from(i16::from_le_bytes([raw[0], raw[1]])),
            (true, true) => f64::from(i16::from_be_bytes([raw[0], raw[1]])),
            (false, false) => f64::from(f32::from_le_bytes(raw)),
            (false, true) => f64::from(f32::from_be_bytes(raw)),
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use dashpot_test_support::drawn;
    use proptest::prelude::*;

    use super::*;

    /// Writes a time history in the form that rigs write: a header with the necessary number of blocks, then groups of
    /// samples.
    pub(crate) fn rpc(channels: &[(&str, &str, &[f64])], step: f64, short: bool, big_endian: bool) -> Vec<u8> {
        const FRAME: usize = 8;
        let group = 2 * FRAME;
        let samples = channels[0].2.len();
        let frames = samples.div_ceil(FRAME);
        let scale = |values: &[f64]| values.iter().fold(0.0_f64, |m, v| m.max(v.abs())) / 32752.0;
        let format = if big_endian { "BINARY_IEEE_BIG_END" } else { "BINARY_IEEE_LITTLE_END" };
        let mut entries = vec![
            ("FORMAT".to_owned(), format.to_owned()),
            ("NUM_HEADER_BLOCKS".to_owned(), String::new()),
            ("NUM_PARAMS".to_owned(), String::new()),
            ("FILE_TYPE".to_owned(), "TIME_HISTORY".to_owned()),
            ("TIME_TYPE".to_owned(), "RESPONSE".to_owned()),
            ("DELTA_T".to_owned(), format!("{step:e}")),
            ("PTS_PER_FRAME".to_owned(), FRAME.to_string()),
            ("CHANNELS".to_owned(), channels.len().to_string()),
            ("PTS_PER_GROUP".to_owned(), group.to_string()),
            ("BYPASS_FILTER".to_owned(), "0".to_owned()),
            ("HALF_FRAMES".to_owned(), "0".to_owned()),
            ("REPEATS".to_owned(), "1".to_owned()),
            ("FRAMES".to_owned(), frames.to_string()),
            ("INT_FULL_SCALE".to_owned(), "32752".to_owned()),
            ("DATA_TYPE".to_owned(), if short { "SHORT_INTEGER" } else { "FLOATING_POINT" }.to_owned()),
        ];
        for (n, (name, unit, values)) in channels.iter().enumerate() {
            entries.push((format!("DESC.CHAN_{}", n + 1), (*name).to_owned()));
            entries.push((format!("UNITS.CHAN_{}", n + 1), (*unit).to_owned()));
            entries.push((format!("SCALE.CHAN_{}", n + 1), format!("{:e}", if short { scale(values) } else { 1.0 })));
        }
        let blocks = entries.len().div_ceil(BLOCK / ENTRY);
        entries[1].1 = blocks.to_string();
        entries[2].1 = entries.len().to_string();
        let mut out = vec![0; blocks * BLOCK];
        for (k, (key, value)) in entries.iter().enumerate() {
            out[k * ENTRY..k * ENTRY + key.len()].copy_from_slice(key.as_bytes());
            out[k * ENTRY + KEY..k * ENTRY + KEY + value.len()].copy_from_slice(value.as_bytes());
        }
        for first in (0..frames * FRAME).step_by(group) {
            for (_, _, values) in channels {
                for i in first..first + group {
                    let value = values.get(i).copied().unwrap_or(0.0);
                    if short {
                        let raw = (value / scale(values)).round() as i16;
                        out.extend(if big_endian { raw.to_be_bytes() } else { raw.to_le_bytes() });
                    } else {
                        let raw = value as f32;
                        out.extend(if big_endian { raw.to_be_bytes() } else { raw.to_le_bytes() });
                    }
                }
            }
        }
        out
    }

    fn read_bytes(bytes: &[u8]) -> Result<Vec<Samples>, RecordError> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("rig.rsp");
        std::fs::write(&file, bytes).unwrap();
        read(Source::read(&file)?, "rig", &Options::default())
    }

    fn wave(n: usize, size: f64, phase: f64) -> Vec<f64> {
        (0..n).map(|i| size * libm::sin(0.1 * i as f64 + phase)).collect()
    }

    #[test]
    fn time_histories_of_both_types_and_orders_are_read() {
        let (x, f) = (wave(40, 25.0, 0.0), wave(40, 1.5, 1.0));
        for short in [false, true] {
            for big_endian in [false, true] {
                let bytes = rpc(
                    &[("Axial Displacement", "mm", &x), ("Pump", "bar", &f), ("Axial Force", "kN", &f)],
                    0.005,
                    short,
                    big_endian,
                );
                let samples = read_bytes(&bytes).unwrap().remove(0);
                assert_eq!(samples.len(), 40);
                for i in 0..40 {
                    assert!((samples.time[i] - 0.005 * i as f64).abs() < 1e-12);
                    assert!((samples.displacement.as_ref().unwrap()[i] - 1e-3 * x[i]).abs() < 1e-6);
                    assert!((samples.force[i] - 1e3 * f[i]).abs() < 0.1, "{short} {big_endian} {i}");
                }
            }
        }
    }

    #[test]
    fn what_the_file_cannot_hold_is_refused_in_words() {
        let (x, f) = (wave(40, 25.0, 0.0), wave(40, 1.5, 1.0));
        let sound = rpc(&[("Displacement", "mm", &x), ("Force", "kN", &f)], 0.005, true, false);
        let with = |key: &str, value: &str| {
            let mut bytes = sound.clone();
            let at = bytes.chunks(ENTRY).position(|e| e.starts_with(format!("{key}\0").as_bytes())).unwrap() * ENTRY;
            bytes[at + KEY..at + ENTRY].fill(0);
            bytes[at + KEY..at + KEY + value.len()].copy_from_slice(value.as_bytes());
            read_bytes(&bytes).unwrap_err().to_string()
        };
        assert!(with("FRAMES", "4000000000").contains("announces 32000000000 samples"));
        assert!(with("FRAMES", "18446744073709551615").contains("more samples than any file"));
        assert!(with("CHANNELS", "0").contains("0 channels"));
        assert!(with("NUM_HEADER_BLOCKS", "99999").contains("header blocks"));
        assert!(with("DELTA_T", "-1").contains("no time step"));
        assert!(with("FORMAT", "BINARY_VAX").contains("BINARY_VAX"));
        assert!(with("FILE_TYPE", "FATIGUE").contains("no time history"));
        assert!(with("DESC.CHAN_2", "Pump").contains("no header"));
        assert!(read_bytes(&sound[..sound.len() - 9]).unwrap_err().to_string().contains("announces 40 samples"));
        assert!(read_bytes(b"FORMATS").unwrap_err().to_string().contains("FORMAT"));
    }

    proptest! {
        #![proptest_config(drawn(2000))]
        #[test]
        fn a_damaged_file_is_read_or_refused(at in 0..4000_usize, byte in any::<u8>(), keep in 0..6000_usize) {
            let x = wave(40, 25.0, 0.0);
            let mut bytes = rpc(&[("Displacement", "mm", &x), ("Force", "kN", &x)], 0.005, true, false);
            let at = at % bytes.len();
            bytes[at] = byte;
            bytes.truncate(keep.max(1));
            if let Ok(tests) = read_bytes(&bytes) {
                prop_assert!(tests.iter().all(|t| t.len() == t.force.len()));
            }
        }
    }
}
