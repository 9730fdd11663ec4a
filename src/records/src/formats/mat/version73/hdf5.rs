//! HDF5 files as MATLAB and h5py write them (The HDF Group, HDF5 File Format Specification, version 3.0).
//!
//! The reader supports both forms of groups, and compact, contiguous or chunked numeric data sets, which may be
//! deflated and shuffled.
//!
//! Every visited block, every chunk and every number is charged to the budget. Each node of a tree is visited at most
//! once.

use std::collections::HashSet;
use std::io::Read as _;

use crate::source::Budget;

/// Signature of the superblock.
const SIGNATURE: &[u8] = b"\x89HDF\r\n\x1a\n";
/// Work of visiting a block, in steps of about a nanosecond (see [`Budget`]).
const VISIT: u64 = 200;
/// Memory of a link in addition to its name, bytes.
const LINK: u64 = 64;
/// Largest number of dimensions of a data set. MATLAB's matrices have two.
const MOST_DIMENSIONS: usize = 8;

/// An HDF5 file.
pub(super) struct File<'a> {
    /// The bytes from the superblock on. Addresses are relative to their start.
    bytes: &'a [u8],
    budget: &'a Budget,
    /// Number of bytes of an address and of a length.
    offset: usize,
    length: usize,
    root: u64,
}

/// A data set of numbers.
pub(super) struct DataSet {
    /// Number of elements along every dimension.
    pub shape: Vec<u64>,
    number: Number,
    layout: Layout,
    filters: Vec<Filter>,
}

/// Storage format of a number.
#[derive(Clone, Copy)]
struct Number {
    size: usize,
    big_endian: bool,
    kind: Kind,
}

#[derive(Clone, Copy)]
enum Kind {
    Unsigned,
    Signed,
    Float,
}

enum Layout {
    /// Position and length of data in the header itself.
    Compact { at: usize, size: usize },
    /// Position of the single block of data, or `None` if it was never written.
    Contiguous { at: Option<u64>, size: u64 },
    /// Chunks of equal shape, indexed by a tree.
    Chunked { tree: Option<u64>, chunk: Vec<u64> },
    /// A single chunk for all data. `stored` is its stored size if filters apply.
    OneChunk { at: Option<u64>, stored: Option<u64>, chunk: Vec<u64> },
}

#[derive(Clone, Copy, PartialEq)]
enum Filter {
    Deflate,
    Shuffle,
    /// A checksum of four bytes after the data.
    Fletcher,
}

/// A message of an object header: its type, and the position of its data.
struct Message {
    kind: u16,
    at: usize,
}

fn too_short() -> String {
    "it ends in the middle of a block".to_owned()
}

impl<'a> File<'a> {
    /// Finds the superblock at the beginning, or after a user block, whose length is 512 bytes times a power of two.
    pub fn open(bytes: &'a [u8], budget: &'a Budget) -> Result<File<'a>, String> {
        let starts = std::iter::once(0).chain((0..24).map(|k| 512_usize << k)).take_while(|at| *at < bytes.len());
        let at = starts.into_iter().find(|at| bytes[*at..].starts_with(SIGNATURE));
        let bytes = &bytes[at.ok_or("it is no HDF5 file")?..];
        let mut file = File { bytes, budget, offset: 8, length: 8, root: 0 };
        let version = file.uint(8, 1)?;
        // Positions of the sizes of addresses and lengths, and of the first address.
        let (sizes, addresses) = match version {
            0 => (13, 24),
            1 => (13, 28),
            2 | 3 => (9, 12),
            _ => return Err(format!("its superblock has the version {version}, which is not known")),
        };
        (file.offset, file.length) = (file.uint(sizes, 1)? as usize, file.uint(sizes + 1, 1)? as usize);
        if ![2, 4, 8].contains(&file.offset) || ![2, 4, 8].contains(&file.length) {
            return Err("its addresses have a size that no file has".into());
        }
        // The base address, the extension or free-space address, and the end address precede the root address. The old
        // form also has the address of the driver block and a name offset.
        let before = if version < 2 { 5 } else { 3 };
        file.root = file.uint(addresses + before * file.offset, file.offset)?;
        Ok(file)
    }

    /// Returns the objects at the top level of the file, by name and address, sorted by name.
    pub fn objects(&self) -> Result<Vec<(String, u64)>, String> {
        let mut found = Vec::new();
        for message in self.messages(self.root)? {
            match message.kind {
                0x11 => {
                    let tree = self.uint(message.at, self.offset)?;
                    let heap = self.uint(message.at + self.offset, self.offset)?;
                    self.old_group(tree, heap, &mut found)?;
                }
                0x06 => found.extend(self.link(&message)?),
                0x02 => {
                    let flags = self.uint(message.at + 1, 1)?;
                    let heap = self.address(message.at + 2 + if flags & 1 == 0 { 0 } else { 8 })?;
                    if heap.is_some() {
                        return Err("it lists its variables in a form that MATLAB does not write".into());
                    }
                }
                _ => {}
            }
        }
        found.sort();
        Ok(found)
    }

    /// Returns the data set at an address, or `None` for a group and for data that are not plain numbers.
    pub fn data_set(&self, at: u64) -> Result<Option<DataSet>, String> {
        let (mut shape, mut number, mut layout, mut filters) = (None, None, None, Vec::new());
        for message in self.messages(at)? {
            match message.kind {
                0x01 => shape = Some(self.shape(&message)?),
                0x03 => number = self.number(&message)?,
                0x08 => layout = Some(self.layout(&message)?),
                0x0B => filters = self.filters(&message)?,
                _ => {}
            }
        }
        let (Some(Some(shape)), Some(number), Some(layout)) = (shape, number, layout) else { return Ok(None) };
        Ok(Some(DataSet { shape, number, layout, filters }))
    }

    /// Returns all numbers of a data set, in file order. Numbers that the file does not store become missing values.
    pub fn values(&self, data: &DataSet) -> Result<Vec<f64>, String> {
        let count = product(&data.shape);
        self.budget.numbers(count)?;
        let size = data.number.size;
        let mut values = vec![f64::NAN; count as usize];
        let fill = |values: &mut [f64], stored: &[u8]| {
            values
                .iter_mut()
                .zip(stored.chunks_exact(size))
                .for_each(|(value, stored)| *value = data.number.value(stored));
        };
        if let Layout::OneChunk { chunk, .. } | Layout::Chunked { chunk, .. } = &data.layout
            && (chunk.len() != data.shape.len() || chunk.contains(&0))
        {
            return Err("its chunks have another shape than its data".into());
        }
        match &data.layout {
            Layout::Compact { at, size } => fill(&mut values, self.bytes.get(*at..at + size).ok_or_else(too_short)?),
            Layout::Contiguous { at: Some(at), size } => fill(&mut values, self.block(*at, *size)?),
            Layout::Contiguous { at: None, .. }
            | Layout::Chunked { tree: None, .. }
            | Layout::OneChunk { at: None, .. } => {}
            Layout::OneChunk { at: Some(at), stored, chunk } => {
                let whole = product(chunk).saturating_mul(size as u64);
                let stored = self.block(*at, stored.unwrap_or(whole))?;
                self.place(data, chunk, &vec![0; chunk.len()], &self.unpacked(data, stored, whole, 0)?, &mut values);
            }
            Layout::Chunked { tree: Some(tree), chunk } => {
                let mut seen = HashSet::new();
                self.chunks(*tree, None, data, chunk, &mut seen, &mut values)?;
            }
        }
        Ok(values)
    }

    /// Copies the chunks below a node into `values`. `above` is the level of the parent node, which exceeds that of the
    /// node by one; `None` at the root.
    fn chunks(
        &self,
        at: u64,
        above: Option<u64>,
        data: &DataSet,
        chunk: &[u64],
        seen: &mut HashSet<u64>,
        values: &mut [f64],
    ) -> Result<(), String> {
        let (level, used, from) = self.node(at, 1, above, seen)?;
        // A key contains size, filter mask, an offset along every dimension, and an offset within the element.
        let key = 8 + 8 * (chunk.len() + 1);
        for k in 0..used {
            let entry = from + k * (key + self.offset);
            let child = self.uint(entry + key, self.offset)?;
            if level > 0 {
                self.chunks(child, Some(level), data, chunk, seen, values)?;
                continue;
            }
            let (stored, mask) = (self.uint(entry, 4)?, self.uint(entry + 4, 4)?);
            let begins =
                (0..chunk.len()).map(|d| self.uint(entry + 8 + 8 * d, 8)).collect::<Result<Vec<u64>, String>>()?;
            let whole = product(chunk).saturating_mul(data.number.size as u64);
            let unpacked = self.unpacked(data, self.block(child, stored)?, whole, mask)?;
            self.place(data, chunk, &begins, &unpacked, values);
        }
        Ok(())
    }

    /// Reverses the filters of a chunk, beginning with the last filter. A bit of the mask marks a filter that was not
    /// applied.
    fn unpacked(&self, data: &DataSet, stored: &[u8], whole: u64, mask: u64) -> Result<Vec<u8>, String> {
        // Charge the stored, the unpacked and the unshuffled bytes.
        self.budget.hold(whole.saturating_mul(2).saturating_add(stored.len() as u64))?;
        let mut bytes = stored.to_vec();
        for (k, filter) in data.filters.iter().enumerate().rev() {
            if mask >> k & 1 == 1 {
                continue;
            }
            bytes = match filter {
                Filter::Deflate => {
                    let mut unpacked = Vec::new();
                    let unpacker = flate2::read::ZlibDecoder::new(bytes.as_slice());
                    let most = whole.saturating_add(8);
                    unpacker.take(most).read_to_end(&mut unpacked).map_err(|e| format!("a chunk is damaged: {e}"))?;
                    unpacked
                }
                Filter::Shuffle => unshuffled(&bytes, data.number.size),
                Filter::Fletcher => {
                    bytes.truncate(bytes.len().saturating_sub(4));
                    bytes
                }
            };
        }
        if (bytes.len() as u64) < whole {
            return Err("a chunk is shorter than its shape".into());
        }
        self.budget.free(whole.saturating_mul(2).saturating_add(stored.len() as u64));
        Ok(bytes)
    }

    /// Copies a chunk to its position `begins` in the data set. Ignores elements outside the data set, which are
    /// padding.
    fn place(&self, data: &DataSet, chunk: &[u64], begins: &[u64], bytes: &[u8], values: &mut [f64]) {
        let size = data.number.size;
        for (k, stored) in bytes.chunks_exact(size).take(product(chunk) as usize).enumerate() {
            let (mut rest, mut place, mut stride) = (k as u64, 0_u64, 1_u64);
            let mut inside = true;
            for d in (0..chunk.len()).rev() {
                let at = begins[d].saturating_add(rest % chunk[d]);
                rest /= chunk[d];
                inside &= at < data.shape[d];
                place = place.saturating_add(at.saturating_mul(stride));
                stride = stride.saturating_mul(data.shape[d]);
            }
            if inside && let Some(value) = values.get_mut(place as usize) {
                *value = data.number.value(stored);
            }
        }
    }

    /// Reads a node of a version-1 tree: its level, the number of its entries and the position of the first entry.
    fn node(
        &self,
        at: u64,
        kind: u64,
        above: Option<u64>,
        seen: &mut HashSet<u64>,
    ) -> Result<(u64, usize, usize), String> {
        self.budget.work(VISIT)?;
        if !seen.insert(at) {
            return Err("a tree leads twice to the same node".into());
        }
        let from = self.place_of(at, b"TREE")?;
        let (level, used) = (self.uint(from + 5, 1)?, self.uint(from + 6, 2)? as usize);
        if self.uint(from + 4, 1)? != kind || above.is_some_and(|above| level + 1 != above) {
            return Err("a tree leads to a node of another kind".into());
        }
        Ok((level, used, from + 8 + 2 * self.offset))
    }

    /// Collects names and addresses of an old-style group.
    fn old_group(&self, tree: u64, heap: u64, found: &mut Vec<(String, u64)>) -> Result<(), String> {
        let heap = self.place_of(heap, b"HEAP")?;
        let size = self.uint(heap + 8, self.length)?;
        let names = self.uint(heap + 8 + 2 * self.length, self.offset)?;
        let names = self.block(names, size)?;
        self.symbols(tree, None, names, &mut HashSet::new(), found)
    }

    fn symbols(
        &self,
        at: u64,
        above: Option<u64>,
        names: &[u8],
        seen: &mut HashSet<u64>,
        found: &mut Vec<(String, u64)>,
    ) -> Result<(), String> {
        let (level, used, from) = self.node(at, 0, above, seen)?;
        for k in 0..used {
            let child = self.uint(from + k * (self.length + self.offset) + self.length, self.offset)?;
            if level > 0 {
                self.symbols(child, Some(level), names, seen, found)?;
                continue;
            }
            self.budget.work(VISIT)?;
            if !seen.insert(child) {
                return Err("a tree leads twice to the same node".into());
            }
            let node = self.place_of(child, b"SNOD")?;
            for s in 0..self.uint(node + 6, 2)? as usize {
                let entry = node + 8 + s * (2 * self.offset + 24);
                let name = names.get(self.uint(entry, self.offset)? as usize..).ok_or_else(too_short)?;
                let end = name.iter().position(|b| *b == 0).ok_or_else(too_short)?;
                self.budget.hold(end as u64 + LINK)?;
                let name = String::from_utf8_lossy(&name[..end]).into_owned();
                found.push((name, self.uint(entry + self.offset, self.offset)?));
            }
        }
        Ok(())
    }

    /// Reads a new-style link. Returns `None` if the link does not point to an object of this file.
    fn link(&self, message: &Message) -> Result<Option<(String, u64)>, String> {
        let flags = self.uint(message.at + 1, 1)?;
        let mut at = message.at + 2;
        let mut takes = |flag: u64, bytes: usize| -> Result<Option<u64>, String> {
            if flags & flag == 0 {
                return Ok(None);
            }
            at += bytes;
            self.uint(at - bytes, bytes).map(Some)
        };
        let kind = takes(1 << 3, 1)?.unwrap_or(0);
        takes(1 << 2, 8)?;
        takes(1 << 4, 1)?;
        let width = 1 << (flags & 3);
        let length = self.uint(at, width)?;
        at += width;
        self.budget.hold(length.saturating_add(LINK))?;
        let end = usize::try_from(length).ok().and_then(|n| at.checked_add(n)).ok_or_else(too_short)?;
        let name = String::from_utf8_lossy(self.bytes.get(at..end).ok_or_else(too_short)?).into_owned();
        Ok(if kind == 0 { Some((name, self.uint(end, self.offset)?)) } else { None })
    }

    /// Returns the messages of an object, including those in its continuation blocks.
    fn messages(&self, at: u64) -> Result<Vec<Message>, String> {
        let from = self.place_of(at, b"")?;
        let new = self.bytes[from..].starts_with(b"OHDR");
        let mut found = Vec::new();
        let mut seen = HashSet::new();
        // Position and length of each block of messages.
        let mut blocks = Vec::new();
        let mut head = 8;
        if new {
            let flags = self.uint(from + 5, 1)?;
            let times = if flags & 1 << 5 == 0 { 0 } else { 16 };
            let phases = if flags & 1 << 4 == 0 { 0 } else { 4 };
            let width = 1 << (flags & 3);
            let size = from + 6 + times + phases;
            blocks.push((size + width, self.uint(size, width)?));
            head = if flags & 1 << 2 == 0 { 4 } else { 6 };
        } else if self.uint(from, 1)? == 1 {
            blocks.push((from + 16, self.uint(from + 8, 4)?));
        } else {
            return Err(format!("at byte {at} there is no object"));
        }
        while let Some((from, size)) = blocks.pop() {
            if !seen.insert(from) {
                return Err("the header of an object leads in a circle".into());
            }
            let end = usize::try_from(size).ok().and_then(|size| from.checked_add(size));
            let end = end.filter(|end| *end <= self.bytes.len()).ok_or_else(too_short)?;
            let mut at = from;
            while at + head <= end {
                self.budget.work(VISIT)?;
                self.budget.hold(LINK)?;
                let (kind, size) = if new {
                    (self.uint(at, 1)? as u16, self.uint(at + 1, 2)? as usize)
                } else {
                    (self.uint(at, 2)? as u16, self.uint(at + 2, 2)? as usize)
                };
                let data = at + head;
                if data + size > end {
                    // Bytes after the last message of a new-style header are unused.
                    break;
                }
                if kind == 0x10 {
                    let to = self.uint(data, self.offset)?;
                    let length = self.uint(data + self.offset, self.length)?;
                    let (from, around) =
                        if new { (self.place_of(to, b"OCHK")? + 4, 8) } else { (self.place_of(to, b"")?, 0) };
                    blocks.push((from, length.saturating_sub(around)));
                } else {
                    found.push(Message { kind, at: data });
                }
                at = data + size;
            }
        }
        Ok(found)
    }

    /// Reads the number of elements along every dimension. Returns `None` for a data set without elements.
    fn shape(&self, message: &Message) -> Result<Option<Vec<u64>>, String> {
        let (version, rank) = (self.uint(message.at, 1)?, self.uint(message.at + 1, 1)? as usize);
        if version == 2 && self.uint(message.at + 3, 1)? == 2 {
            return Ok(None);
        }
        if rank > MOST_DIMENSIONS {
            return Err(format!("it has {rank} dimensions; at most {MOST_DIMENSIONS} are read"));
        }
        let from = message.at + if version == 1 { 8 } else { 4 };
        (0..rank).map(|d| self.uint(from + d * self.length, self.length)).collect::<Result<_, _>>().map(Some)
    }

    /// Reads the type of number. Returns `None` for texts, structures and references.
    fn number(&self, message: &Message) -> Result<Option<Number>, String> {
        let class = self.uint(message.at, 1)? & 15;
        let (bits, size) = (self.uint(message.at + 1, 1)?, self.uint(message.at + 4, 4)? as usize);
        let kind = match (class, size) {
            (0, 1 | 2 | 4 | 8) if bits & 8 == 0 => Kind::Unsigned,
            (0, 1 | 2 | 4 | 8) => Kind::Signed,
            (1, 4 | 8) => Kind::Float,
            _ => return Ok(None),
        };
        Ok(Some(Number { size, big_endian: bits & 1 == 1, kind }))
    }

    fn layout(&self, message: &Message) -> Result<Layout, String> {
        let at = message.at;
        let (version, class) = (self.uint(at, 1)?, self.uint(at + 1, 1)?);
        match (version, class) {
            (3 | 4, 0) => Ok(Layout::Compact { at: at + 4, size: self.uint(at + 2, 2)? as usize }),
            (3 | 4, 1) => Ok(Layout::Contiguous {
                at: self.address(at + 2)?,
                size: self.uint(at + 2 + self.offset, self.length)?,
            }),
            (3, 2) => {
                // The last number is the size of an element, not a dimension.
                let rank = (self.uint(at + 2, 1)? as usize).saturating_sub(1);
                let from = at + 3 + self.offset;
                let chunk = self.sizes(from, 4, rank)?;
                Ok(Layout::Chunked { tree: self.address(at + 3)?, chunk })
            }
            (4, 2) => {
                let (flags, rank) = (self.uint(at + 2, 1)?, (self.uint(at + 3, 1)? as usize).saturating_sub(1));
                let width = self.uint(at + 4, 1)? as usize;
                let chunk = self.sizes(at + 5, width, rank)?;
                let index = at + 5 + width * (rank + 1);
                if self.uint(index, 1)? != 1 {
                    return Err("its chunks are listed in a form that MATLAB does not write".into());
                }
                let filtered = flags & 2 != 0;
                let stored = if filtered { Some(self.uint(index + 1, self.length)?) } else { None };
                let address = index + 1 + if filtered { self.length + 4 } else { 0 };
                Ok(Layout::OneChunk { at: self.address(address)?, stored, chunk })
            }
            _ => Err(format!("its data are laid out in the way {version}.{class}, which is not read")),
        }
    }

    fn sizes(&self, from: usize, width: usize, rank: usize) -> Result<Vec<u64>, String> {
        if !(1..=8).contains(&width) || rank > MOST_DIMENSIONS {
            return Err("its chunks have a shape that no data have".into());
        }
        (0..rank).map(|d| self.uint(from + width * d, width)).collect()
    }

    fn filters(&self, message: &Message) -> Result<Vec<Filter>, String> {
        let (version, count) = (self.uint(message.at, 1)?, self.uint(message.at + 1, 1)?);
        let mut at = message.at + if version == 1 { 8 } else { 2 };
        let mut found = Vec::new();
        for _ in 0..count {
            let id = self.uint(at, 2)?;
            let named = version == 1 || id >= 256;
            let name = if named { self.uint(at + 2, 2)? as usize } else { 0 };
            let numbers = self.uint(at + if named { 6 } else { 4 }, 2)? as usize;
            found.push(match id {
                1 => Filter::Deflate,
                2 => Filter::Shuffle,
                3 => Filter::Fletcher,
                _ => return Err(format!("its data are packed by the filter {id}, which is not read")),
            });
            let padded = if version == 1 { name.next_multiple_of(8) + 4 * (numbers % 2) } else { name };
            at += if named { 8 } else { 6 } + padded + 4 * numbers;
        }
        Ok(found)
    }

    /// Checks the signature at an address, and returns its position.
    fn place_of(&self, at: u64, signature: &[u8]) -> Result<usize, String> {
        let from = usize::try_from(at).ok().filter(|from| *from < self.bytes.len());
        let from = from.ok_or_else(|| format!("a block at byte {at} lies outside the file"))?;
        if !self.bytes[from..].starts_with(signature) {
            return Err(format!("at byte {at} there is no {} block", String::from_utf8_lossy(signature)));
        }
        Ok(from)
    }

    fn block(&self, at: u64, size: u64) -> Result<&'a [u8], String> {
        let from = self.place_of(at, b"")?;
        let end = usize::try_from(size).ok().and_then(|size| from.checked_add(size)).ok_or_else(too_short)?;
        self.budget.work(VISIT)?;
        self.bytes.get(from..end).ok_or_else(too_short)
    }

    /// Reads an address. Returns `None` if all its bits are set.
    fn address(&self, at: usize) -> Result<Option<u64>, String> {
        let address = self.uint(at, self.offset)?;
        Ok((address != u64::MAX >> (64 - 8 * self.offset)).then_some(address))
    }

    fn uint(&self, at: usize, width: usize) -> Result<u64, String> {
        let stored = at.checked_add(width).and_then(|end| self.bytes.get(at..end)).ok_or_else(too_short)?;
        let mut raw = [0; 8];
        raw[..width].copy_from_slice(stored);
        Ok(u64::from_le_bytes(raw))
    }
}

impl Number {
    fn value(self, stored: &[u8]) -> f64 {
        let mut raw = [0; 8];
        raw[..self.size].copy_from_slice(stored);
        if self.big_endian {
            raw[..self.size].reverse();
        }
        let bits = u64::from_le_bytes(raw);
        match (self.kind, self.size) {
            (Kind::Float, 4) => f64::from(f32::from_bits(bits as u32)),
            (Kind::Float, _) => f64::from_bits(bits),
            (Kind::Unsigned, _) => bits as f64,
            (Kind::Signed, size) => {
                let unused = 64 - 8 * size as u32;
                ((bits << unused) as i64 >> unused) as f64
            }
        }
    }
}

fn product(shape: &[u64]) -> u64 {
    shape.iter().fold(1, |n, k| n.saturating_mul(*k))
}

/// Reverses the shuffle filter, which stores the first bytes of all elements, then the second bytes, and so on.
/// Trailing bytes that do not fill an element stay unchanged.
fn unshuffled(bytes: &[u8], size: usize) -> Vec<u8> {
    let count = bytes.len() / size;
    let mut out = Vec::with_capacity(bytes.len());
    for k in 0..count {
        out.extend((0..size).map(|b| bytes[b * count + k]));
    }
    out.extend_from_slice(&bytes[count * size..]);
    out
}
