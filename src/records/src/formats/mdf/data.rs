//! The records of an MDF data group in one block or in a list of blocks, plain or compressed.

use std::borrow::Cow;
use std::collections::HashMap;
use std::io::Read as _;

use super::blocks::{Block, Mdf};
use crate::source::Budget;

/// Unpacked size of the data that is always allowed, bytes.
const UNPACKED: usize = 48 << 20;
/// Allowed ratio of unpacked size to file size, if the result exceeds [`UNPACKED`]. Slowly varying channels compress
/// well when transposed.
const RATIO: usize = 4;

/// Work per byte that is unpacked or copied, in steps of about a nanosecond (see [`Budget`]).
const UNPACKING: u64 = 6;

/// Largest number of records of a file: two hours at 2 kHz. For more records, positions and values would exceed the
/// memory.
const RECORDS: usize = 16 << 20;

/// Layout of the records of a channel group.
#[derive(Debug, Clone, Copy)]
pub(super) struct Record {
    /// Identification number before each record, if a data group has several channel groups.
    pub id: u64,
    /// Whether each record has its own length.
    pub variable: bool,
    /// Bytes of a record, including validity bits.
    pub bytes: usize,
    /// Number of records that the file announces.
    pub count: u64,
}

/// Returns all bytes of the records of a data group, from its data block or list at the byte `at`. Charges them to the
/// budget, unless they are borrowed from the file.
pub(super) fn bytes<'a>(mdf: &Mdf<'a>, at: u64) -> Result<Cow<'a, [u8]>, String> {
    let limit = UNPACKED.max(RATIO * mdf.len()).min(mdf.budget.bytes_remaining() as usize);
    let first = mdf.any(at)?;
    if first.id == b"DT" {
        return Ok(Cow::Borrowed(first.data));
    }
    let mut out = Vec::new();
    match first.id {
        b"HL" => list(mdf, first.link(0), limit, &mut out)?,
        b"DL" => list(mdf, at, limit, &mut out)?,
        _ => append(&first, limit, &mut out)?,
    }
    mdf.budget.hold(out.len() as u64)?;
    mdf.budget.work(UNPACKING * out.len() as u64)?;
    Ok(Cow::Owned(out))
}

/// Appends the data of all blocks of a list to `out`, at most `limit` bytes in total.
fn list(mdf: &Mdf<'_>, first: u64, limit: usize, out: &mut Vec<u8>) -> Result<(), String> {
    let (mut next, mut steps) = (first, 0);
    while next != 0 {
        mdf.count(&mut steps)?;
        let block = mdf.block(next, "DL")?;
        next = block.link(0);
        for k in 1..block.links() {
            mdf.count(&mut steps)?;
            if block.link(k) != 0 {
                append(&mdf.any(block.link(k))?, limit, out)?;
            }
        }
    }
    Ok(())
}

fn append(block: &Block<'_>, limit: usize, out: &mut Vec<u8>) -> Result<(), String> {
    let room = limit.saturating_sub(out.len());
    let too_much = || format!("it unpacks to more than {} MiB", limit >> 20);
    match block.id {
        b"DT" if block.data.len() <= room => out.extend_from_slice(block.data),
        b"DT" => return Err(too_much()),
        b"DZ" => {
            let (kind, columns) = (block.u8(2)?, block.u32(4)? as usize);
            if &block.data[..2] != b"DT" {
                return Err("its compressed data are no records".into());
            }
            let packed =
                usize::try_from(block.u64(16)?).ok().and_then(|n| block.data.get(24..24_usize.checked_add(n)?));
            let packed = packed.ok_or("its compressed data end outside their block")?;
            let before = out.len();
            let mut unpacker = flate2::read::ZlibDecoder::new(packed).take(room as u64 + 1);
            unpacker.read_to_end(out).map_err(|e| format!("its compressed data are damaged: {e}"))?;
            let size = out.len() - before;
            if size > room {
                return Err(too_much());
            }
            if size as u64 != block.u64(8)? {
                return Err("its compressed data unpack to another size than announced".into());
            }
            match kind {
                0 => {}
                1 => turn_back(&mut out[before..], columns),
                _ => {
                    return Err(format!(
                        "its data are compressed in the way {kind}; read are deflate, plain and transposed"
                    ));
                }
            }
        }
        b"DV" | b"LD" => return Err("its data are stored by columns (MDF 4.2); save it as MDF 4.1".into()),
        other => {
            return Err(format!("its data stand in a {} block, which is not read", String::from_utf8_lossy(other)));
        }
    }
    Ok(())
}

/// Reverses the transposition of whole rows of `columns` bytes. Trailing bytes that do not fill a row stay unchanged.
fn turn_back(bytes: &mut [u8], columns: usize) {
    if columns == 0 {
        return;
    }
    let rows = bytes.len() / columns;
    let turned = bytes[..rows * columns].to_vec();
    for row in 0..rows {
        for column in 0..columns {
            bytes[row * columns + column] = turned[column * rows + row];
        }
    }
}

/// Returns the positions in `bytes` of the records of every channel group, after their identification numbers of
/// `id_size` bytes.
pub(super) fn places(
    bytes: &[u8],
    id_size: usize,
    groups: &[Record],
    budget: &Budget,
) -> Result<Vec<Vec<usize>>, String> {
    let mut places: Vec<Vec<usize>> = vec![Vec::new(); groups.len()];
    if id_size == 0 {
        let [only] = groups else { return Err("its groups share records without numbers to tell them apart".into()) };
        if only.bytes == 0 || only.variable {
            return Ok(places);
        }
        let held = (bytes.len() / only.bytes).min(RECORDS) as u64;
        if only.count > held {
            return Err(format!("it announces {} records and holds {held}", only.count));
        }
        budget.numbers(only.count)?;
        places[0] = (0..only.count as usize).map(|k| k * only.bytes).collect();
        return Ok(places);
    }
    let by_id: HashMap<u64, usize> = groups.iter().enumerate().rev().map(|(k, group)| (group.id, k)).collect();
    let (mut at, mut records) = (0, 0);
    while at + id_size <= bytes.len() {
        records += 1;
        if records > RECORDS {
            return Err(format!("it holds more than {RECORDS} records; cut it"));
        }
        let mut raw = [0; 8];
        raw[..id_size].copy_from_slice(&bytes[at..at + id_size]);
        let id = u64::from_le_bytes(raw);
        at += id_size;
        // Charge the memory of the position and the search for its group.
        budget.numbers(1)?;
        budget.work(50)?;
        let Some(&k) = by_id.get(&id) else {
            return Err(format!("a record has the number {id}, which no group has"));
        };
        let size = if groups[k].variable {
            let length = bytes.get(at..at + 4).and_then(|b| b.try_into().ok()).map(u32::from_le_bytes);
            at += 4;
            length.ok_or("it ends in the middle of a record")? as usize
        } else {
            groups[k].bytes
        };
        let end = at.checked_add(size).filter(|end| *end <= bytes.len()).ok_or("it ends in the middle of a record")?;
        places[k].push(at);
        at = end;
    }
    Ok(places)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn transposed_bytes_are_turned_back_but_for_the_rest() {
        let mut bytes = *b"adbecfXY";
        turn_back(&mut bytes, 3);
        assert_eq!(&bytes, b"abcdefXY");
        turn_back(&mut bytes, 0);
        turn_back(&mut bytes, 100);
        assert_eq!(&bytes, b"abcdefXY");
    }
}
