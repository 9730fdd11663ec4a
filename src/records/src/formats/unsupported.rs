//! File formats of rigs that are not supported, recognized by their first bytes.
//!
//! Each entry states the format and a supported alternative.

use crate::messages::phrases;
use dashpot_messages::Template;

/// An unsupported format: its bytes from position `at` on, its name, and the supported alternative.
struct Kind {
    at: usize,
    begins: &'static [u8],
    is: Template,
    instead: Template,
}

const KINDS: &[Kind] = &[
    Kind { at: 0, begins: b"|CF,", is: phrases::FAMOS, instead: phrases::EXPORT_FROM_IMC },
    Kind {
        at: 0,
        begins: b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1",
        is: phrases::OLD_WORKBOOK,
        instead: phrases::SAVE_AS_XLSX,
    },
    Kind {
        at: 30,
        begins: b"mimetypeapplication/vnd.oasis",
        is: phrases::OPEN_DOCUMENT,
        instead: phrases::SAVE_AS_XLSX,
    },
    Kind { at: 0, begins: b"DIAEXTENDED", is: phrases::DIADEM_HEADING, instead: phrases::SAVE_AS_TDMS },
    Kind { at: 0, begins: b"DIADEM", is: phrases::DIADEM, instead: phrases::SAVE_AS_TDMS },
    Kind { at: 0, begins: b"\x89HDF\r\n\x1a\n", is: phrases::HDF5, instead: phrases::SAVE_CHANNELS },
    Kind { at: 0, begins: b"SQLite format 3", is: phrases::DATABASE, instead: phrases::EXPORT_AS_CSV },
    Kind { at: 0, begins: b"PK\x03\x04", is: phrases::ZIP, instead: phrases::UNPACK_FOLDER },
    Kind { at: 0, begins: b"\x1f\x8b", is: phrases::GZIP, instead: phrases::UNPACK },
    Kind { at: 0, begins: b"%PDF", is: phrases::PDF, instead: phrases::EXPORT_AS_CSV },
    Kind { at: 0, begins: b"<?xml", is: phrases::XML, instead: phrases::EXPORT_AS_CSV },
];

/// First numbers of catman binary files: versions 5.0 to 5.99 as a 16-bit number (HBM, catman file format).
const CATMAN: std::ops::RangeInclusive<u16> = 5000..=5999;
const OF_CATMAN: (Template, Template) = (phrases::CATMAN, phrases::EXPORT_FROM_CATMAN);

/// Returns the name of an unsupported format and the advice for it, or `None` for all other files.
pub(crate) fn known(bytes: &[u8]) -> Option<(Template, Template)> {
    let head = &bytes[..bytes.len().min(80)];
    if let Some(kind) = KINDS.iter().find(|k| head.get(k.at..).is_some_and(|rest| rest.starts_with(k.begins))) {
        return Some((kind.is, kind.instead));
    }
    let first = u16::from_le_bytes([*head.first()?, *head.get(1)?]);
    // Two letters of a text may give the same number. The next number, a length, would then be too large.
    let second = u32::from_le_bytes(head.get(2..6)?.try_into().ok()?);
    (CATMAN.contains(&first) && second < 1 << 24 && head.contains(&0)).then_some(OF_CATMAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn foreign_formats_are_named_and_texts_are_not() {
        for (head, wanted) in [
            (&b"|CF,2,1,1;|CK,1,3,1,1;"[..], "imc FAMOS"),
            (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0\0", ".xls"),
            (b"DIAEXTENDED  {@:ENGLISH\r\n", "DIAdem"),
            (b"\x93\x13\x10\x04\x00\x00\x05\x00\0\0", "catman"),
        ] {
            let (is, instead) = known(head).unwrap_or_else(|| panic!("{wanted}"));
            assert!(is.english().contains(wanted) && !instead.english().is_empty(), "{is:?}");
        }
        for head in [&b"Time [s];Force [N]\n"[..], b"MTS793|MPT|ENU|1", b"", b"1", "\u{feff}Zeit".as_bytes()] {
            assert_eq!(known(head), None);
        }
    }
}
