//! Numbers and texts of a TDMS file, read in sequence and never beyond the end of the file.

use crate::dates::clock::DAY;

/// Types of numbers in raw data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Number {
    I8,
    I16,
    I32,
    I64,
    U8,
    U16,
    U32,
    U64,
    F32,
    F64,
}

impl Number {
    /// Returns the type for its code in the format.
    pub fn from_code(code: u32) -> Option<Self> {
        Some(match code {
            1 => Self::I8,
            2 => Self::I16,
            3 => Self::I32,
            4 => Self::I64,
            5 => Self::U8,
            6 => Self::U16,
            7 => Self::U32,
            8 => Self::U64,
            9 | 0x19 => Self::F32,
            10 | 0x1a => Self::F64,
            _ => return None,
        })
    }

    /// Returns the number of bytes of the type.
    pub fn width(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// Converts stored bytes to a value.
    pub fn value(self, stored: &[u8], big_endian: bool) -> f64 {
        let mut raw = [0_u8; 8];
        let width = self.width().min(stored.len());
        raw[..width].copy_from_slice(&stored[..width]);
        if big_endian {
            raw[..width].reverse();
        }
        let bits = u64::from_le_bytes(raw);
        match self {
            Self::I8 => f64::from(bits as i8),
            Self::I16 => f64::from(bits as i16),
            Self::I32 => f64::from(bits as i32),
            Self::I64 => bits as i64 as f64,
            Self::U8 | Self::U16 | Self::U32 | Self::U64 => bits as f64,
            Self::F32 => f64::from(f32::from_bits(bits as u32)),
            Self::F64 => f64::from_bits(bits),
        }
    }
}

/// A position in the bytes of a file.
#[derive(Debug, Clone)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    big_endian: bool,
}

impl<'a> Cursor<'a> {
    pub fn new(bytes: &'a [u8], big_endian: bool) -> Self {
        Cursor { bytes, at: 0, big_endian }
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], String> {
        let part = self.at.checked_add(count).and_then(|end| self.bytes.get(self.at..end));
        let part = part.ok_or_else(|| "it ends in the middle of its properties".to_owned())?;
        self.at += count;
        Ok(part)
    }

    pub fn u32(&mut self) -> Result<u32, String> {
        let value = self.take(4)?.try_into().unwrap_or_default();
        Ok(if self.big_endian { u32::from_be_bytes(value) } else { u32::from_le_bytes(value) })
    }

    pub fn u64(&mut self) -> Result<u64, String> {
        let value = self.take(8)?.try_into().unwrap_or_default();
        Ok(if self.big_endian { u64::from_be_bytes(value) } else { u64::from_le_bytes(value) })
    }

    pub fn text(&mut self) -> Result<String, String> {
        let length = self.u32()? as usize;
        Ok(String::from_utf8_lossy(self.take(length)?).into_owned())
    }

    /// Reads the value of a property: a number, a text, a time, or another type that is ignored.
    pub fn property(&mut self) -> Result<Property, String> {
        let code = self.u32()?;
        if let Some(number) = Number::from_code(code) {
            return Ok(Property::Number(number.value(self.take(number.width())?, self.big_endian)));
        }
        match code {
            0x20 => Ok(Property::Text(self.text()?)),
            0x21 => self.take(1).map(|_| Property::Other),
            0x44 => {
                // A time consists of fractions of 2^-64 s and whole seconds since 1904. In a big-endian file, the
                // seconds come first.
                let (first, second) = (self.u64()?, self.u64()?);
                let (fraction, seconds) = if self.big_endian { (second, first) } else { (first, second) };
                Ok(Property::Time(seconds as i64 as f64 - FROM_1904_TO_1970 + fraction as f64 / 2f64.powi(64)))
            }
            0x0008_000c => self.take(8).map(|_| Property::Other),
            0x0010_000d => self.take(16).map(|_| Property::Other),
            _ => Err(format!("a property has the type {code:#x}, which is not known")),
        }
    }
}

/// Seconds from the first instant of 1904, the epoch of TDMS files, to the first instant of 1970.
const FROM_1904_TO_1970: f64 = 24_107.0 * DAY;

impl Property {
    /// Returns the memory of the property in addition to that of this type itself, bytes.
    pub fn size(&self) -> u64 {
        match self {
            Property::Text(text) => text.len() as u64,
            _ => 0,
        }
    }
}

/// The value of a property.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Property {
    Number(f64),
    Text(String),
    /// Seconds since 1970.
    Time(f64),
    Other,
}
