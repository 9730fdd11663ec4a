//! Blocks of an MDF file: an identification, a length, links to other blocks, and data. Sizes and links that exceed the
//! file are rejected.

use crate::source::Budget;

/// Largest number of blocks in one chain. A longer chain is circular or does not belong to a measurement.
const CHAIN: usize = 1 << 16;

/// Work of visiting a block, in steps of about a nanosecond (see [`Budget`]).
const VISIT: u64 = 100;
/// Largest number of characters that are read of a text.
const LETTERS: usize = 200;
/// Largest number of bytes of an XML comment that are searched for its text.
const COMMENT: usize = 1 << 16;

/// An MDF 4 file.
pub(super) struct Mdf<'a> {
    bytes: &'a [u8],
    pub budget: &'a Budget,
}

/// A block of an MDF 4 file.
pub(super) struct Block<'a> {
    /// Identification of two letters.
    pub id: &'a [u8],
    links: &'a [u8],
    /// The bytes after the links.
    pub data: &'a [u8],
}

impl<'a> Mdf<'a> {
    /// Checks the identification of the file: a finished recording of MDF version 4.
    pub fn new(bytes: &'a [u8], budget: &'a Budget) -> Result<Self, String> {
        let begins = |text: &[u8]| bytes.starts_with(text);
        if begins(b"UnFinMF ") {
            return Err("its recording was never finished; open it in the tool that wrote it and save it again".into());
        }
        if !begins(b"MDF     ") {
            return Err("it does not begin with MDF".into());
        }
        let version: String =
            bytes.get(8..16).unwrap_or_default().iter().map(|b| char::from(*b)).filter(|c| !c.is_control()).collect();
        if !version.starts_with('4') {
            return Err(format!("it is of version {}; save it as MDF 4", version.trim()));
        }
        Ok(Mdf { bytes, budget })
    }

    pub fn len(&self) -> usize {
        self.bytes.len()
    }

    /// Counts a step along a chain of blocks, and rejects a chain that is too long.
    pub fn count(&self, steps: &mut usize) -> Result<(), String> {
        *steps += 1;
        if *steps > CHAIN.min(self.bytes.len() / 24 + 1) {
            return Err("its blocks lead in a circle".into());
        }
        Ok(())
    }

    /// Returns the block at a position, which must be of the given type.
    pub fn block(&self, at: u64, id: &str) -> Result<Block<'a>, String> {
        let block = self.any(at)?;
        if block.id == id.as_bytes() { Ok(block) } else { Err(format!("at byte {at} there is no {id} block")) }
    }

    /// Returns the block at a position.
    pub fn any(&self, at: u64) -> Result<Block<'a>, String> {
        let outside = || format!("a block at byte {at} lies outside the file");
        self.budget.work(VISIT)?;
        let from = usize::try_from(at).map_err(|_| outside())?;
        let head = self.bytes.get(from..from.checked_add(24).ok_or_else(outside)?).ok_or_else(outside)?;
        if &head[..2] != b"##" {
            return Err(format!("at byte {at} there is no block"));
        }
        let long = |k: usize| u64::from_le_bytes(head[k..k + 8].try_into().unwrap_or_default());
        let whole = usize::try_from(long(8)).ok().and_then(|n| from.checked_add(n)).ok_or_else(outside)?;
        let rest = self.bytes.get(from + 24..whole).ok_or_else(outside)?;
        let links = usize::try_from(long(16)).ok().and_then(|n| n.checked_mul(8)).filter(|n| *n <= rest.len());
        let (links, data) =
            rest.split_at(links.ok_or_else(|| format!("the block at byte {at} has more links than room"))?);
        Ok(Block { id: &head[2..4], links, data })
    }

    /// Returns the text of the block at a position, plain or as the first text of an XML comment. Returns an empty
    /// string if there is no text.
    pub fn text(&self, at: u64) -> String {
        let Ok(block) = self.any(at) else { return String::new() };
        // Limit the length, because many channels may link to one long text.
        let data = &block.data[..block.data.len().min(COMMENT)];
        let end = data.iter().position(|b| *b == 0).unwrap_or(data.len());
        if self.budget.work(end as u64).is_err() {
            return String::new();
        }
        let text = String::from_utf8_lossy(&data[..end]);
        let text = if block.id == b"MD" {
            text.split_once("<TX>").and_then(|(_, rest)| rest.split_once("</TX>")).map_or("", |(text, _)| text)
        } else {
            &text
        };
        text.trim().chars().take(LETTERS).collect()
    }
}

impl Block<'_> {
    /// Returns the number of links.
    pub fn links(&self) -> usize {
        self.links.len() / 8
    }

    /// Returns the target of a link, 0 for none.
    pub fn link(&self, index: usize) -> u64 {
        let at = 8 * index;
        self.links.get(at..at + 8).map_or(0, |b| u64::from_le_bytes(b.try_into().unwrap_or_default()))
    }

    fn part<const N: usize>(&self, at: usize) -> Result<[u8; N], String> {
        let part = self.data.get(at..at + N).and_then(|b| b.try_into().ok());
        part.ok_or_else(|| format!("a {} block is too short", String::from_utf8_lossy(self.id)))
    }

    pub fn u8(&self, at: usize) -> Result<u8, String> {
        Ok(self.part::<1>(at)?[0])
    }

    pub fn i16(&self, at: usize) -> Result<i16, String> {
        Ok(i16::from_le_bytes(self.part(at)?))
    }

    pub fn u16(&self, at: usize) -> Result<u16, String> {
        Ok(u16::from_le_bytes(self.part(at)?))
    }

    pub fn u32(&self, at: usize) -> Result<u32, String> {
        Ok(u32::from_le_bytes(self.part(at)?))
    }

    pub fn u64(&self, at: usize) -> Result<u64, String> {
        Ok(u64::from_le_bytes(self.part(at)?))
    }

    pub fn f64(&self, at: usize) -> Result<f64, String> {
        Ok(f64::from_le_bytes(self.part(at)?))
    }
}
