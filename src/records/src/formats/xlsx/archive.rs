//! Limits the unpacked size of a workbook's zip archive, and charges the budget for each reading of its parts.

use std::io::{Cursor, Error, Read, Result, Seek, SeekFrom};

use crate::source::{Budget, Exhausted};

/// Total unpacked size of a workbook's parts that is always allowed, bytes.
///
/// The part with the strings has a lower limit: [`LARGEST_STRINGS`] or the file size, whichever is larger. In memory,
/// strings need several times their unpacked size.
const LARGEST_UNPACKED: u64 = 256 << 20;
const LARGEST_STRINGS: u64 = 48 << 20;
/// Allowed ratio of a workbook's unpacked size to its file size, if the result exceeds [`LARGEST_UNPACKED`]. For sheets
/// of numbers the ratio is below twelve.
const UNPACKED: u64 = 20;
/// Longest tag with the text after it, bytes. A cell contains at most 32,767 letters.
const LONGEST: u64 = 1 << 20;
/// Memory of a style in addition to its texts, bytes. Each style refers to a font, a fill and borders.
const STYLE: u64 = 512;
/// Work per unpacked byte of XML and per tag, in steps of about a nanosecond (see [`Budget`]). Empty rows consist of
/// tags only. Without the charge per tag, such rows took three times as long as charged (tests/costly.rs).
const PARSED: u64 = 6;
const TAG: u64 = 40;

/// Unpacks every part once without storing it, and rejects a workbook that would not fit into memory. The check does
/// not rely on sizes that the archive states. The returned reader charges the budget for every later reading.
pub(super) fn check<'a>(bytes: &'a [u8], budget: &Budget) -> std::result::Result<Metered<'a>, String> {
    let size = bytes.len() as u64;
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(|e| e.to_string())?;
    let mut left = LARGEST_UNPACKED.max(UNPACKED * size);
    let mut parts = Vec::new();
    for index in 0..archive.len() {
        let mut part = archive.by_index(index).map_err(|e| e.to_string())?;
        let name = part.name().map_err(|e| e.to_string())?.to_ascii_lowercase();
        let (start, packed) = (part.data_start().unwrap_or(0), part.compressed_size());
        let strings = name.ends_with("sharedstrings.xml");
        let mut scan = Scan::default();
        if strings {
            // The parser reserves memory for any announced count, so reject a count that the text cannot contain.
            let mut start = Vec::new();
            (&mut part).take(4096).read_to_end(&mut start).map_err(|e| e.to_string())?;
            scan.take(&start);
            let start = String::from_utf8_lossy(&start).into_owned();
            let count = start
                .split_once("uniqueCount")
                .and_then(|(_, rest)| rest.split(['"', '\'']).nth(1)?.trim().parse::<u64>().ok());
            if count.is_some_and(|count| count > LARGEST_STRINGS / 8) {
                return Err(format!("it announces {} strings, more than it can hold", count.unwrap_or(0)));
            }
        }
        let of_strings = LARGEST_STRINGS.max(size);
        let limit = if strings { left.min(of_strings) } else { left };
        let is_xml = [".xml", ".rels"].iter().any(|ending| name.ends_with(ending));
        let mut piece = [0; 1 << 14];
        loop {
            let read = part.read(&mut piece).map_err(|e| e.to_string())?;
            if read == 0 {
                break;
            }
            scan.take(&piece[..read]);
            if scan.bytes > limit {
                return Err(if limit == of_strings && strings {
                    format!("its part {name} unpacks to more than {} MiB", limit >> 20)
                } else {
                    format!("it unpacks to more than {} MiB", LARGEST_UNPACKED.max(UNPACKED * size) >> 20)
                });
            }
            if is_xml && scan.longest > LONGEST {
                return Err(format!(
                    "its part {name} holds a text of more than {} MiB, which no cell can",
                    LONGEST >> 20
                ));
            }
        }
        left -= scan.bytes;
        parts.push(Part { start, end: start.saturating_add(packed), work: scan.work().div_ceil(packed.max(1)) });
        if strings {
            budget.hold(scan.tags * 12 + scan.bytes)?;
        }
        if name.ends_with("styles.xml") {
            // Every style copies the items to which it refers.
            budget.hold(scan.tags.saturating_mul(scan.longest + STYLE))?;
        }
    }
    budget.work(size + (LARGEST_UNPACKED.max(UNPACKED * size) - left))?;
    parts.sort_by_key(|part| part.start);
    if parts.windows(2).any(|pair| pair[0].end > pair[1].start) {
        return Err("its parts overlap".into());
    }
    Ok(Metered { bytes: Cursor::new(bytes), parts, budget: budget.clone() })
}

/// Size of a part, its number of tags, and the longest tag with the text after it. Sizes are in bytes.
#[derive(Default)]
struct Scan {
    bytes: u64,
    tags: u64,
    longest: u64,
    current: u64,
}

impl Scan {
    /// Returns the work for parsing the part once.
    fn work(&self) -> u64 {
        PARSED * self.bytes + TAG * self.tags
    }

    fn take(&mut self, piece: &[u8]) {
        self.bytes += piece.len() as u64;
        let mut rest = piece;
        while let Some(at) = rest.iter().position(|b| *b == b'<') {
            self.longest = self.longest.max(self.current + at as u64);
            self.tags += 1;
            self.current = 1;
            rest = &rest[at + 1..];
        }
        self.current += rest.len() as u64;
        self.longest = self.longest.max(self.current);
    }
}

/// A part of the archive: start and end of its bytes, and the work per byte.
struct Part {
    start: u64,
    end: u64,
    work: u64,
}

/// Reader of an archive that charges the budget for each reading of a part, because many sheets may share one part.
pub(crate) struct Metered<'a> {
    bytes: Cursor<&'a [u8]>,
    /// Parts, sorted by position.
    parts: Vec<Part>,
    budget: Budget,
}

impl Read for Metered<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let from = self.bytes.position();
        let read = self.bytes.read(buffer)? as u64;
        let first = self.parts.partition_point(|part| part.end <= from);
        let work = self.parts[first..].iter().take_while(|part| part.start < from + read).map(|part| part.work).max();
        self.budget.work(work.unwrap_or(0).max(PARSED) * read).map_err(|_| Error::other(Exhausted::CAUSE))?;
        Ok(read as usize)
    }
}

impl Seek for Metered<'_> {
    fn seek(&mut self, to: SeekFrom) -> Result<u64> {
        self.bytes.seek(to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_and_the_longest_are_counted_across_pieces() {
        let mut scan = Scan::default();
        scan.take(b"<a>xyz<b/");
        scan.take(b">12345<c>");
        assert_eq!((scan.bytes, scan.tags, scan.longest), (18, 3, 9));
    }
}
