//! File formats of rigs that are not supported, recognized by their first bytes.
//!
//! Each entry states the format and a supported alternative.

/// Signature of a format, from byte `at` on.
struct Kind {
    at: usize,
    begins: &'static [u8],
    is: &'static str,
    instead: &'static str,
}

const KINDS: &[Kind] = &[
    Kind {
        at: 0,
        begins: b"|CF,",
        is: "an imc FAMOS file",
        instead: "export it from imc FAMOS or imc STUDIO as CSV, MDF 4 or TDMS",
    },
    Kind {
        at: 0,
        begins: b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1",
        is: "a workbook of Excel 97 to 2003 (.xls), or a document of that time",
        instead: "save it as .xlsx",
    },
    Kind { at: 30, begins: b"mimetypeapplication/vnd.oasis", is: "an OpenDocument file", instead: "save it as .xlsx" },
    Kind {
        at: 0,
        begins: b"DIAEXTENDED",
        is: "the heading of a DIAdem data set, whose numbers lie in other files",
        instead: "save it in DIAdem as TDMS",
    },
    Kind { at: 0, begins: b"DIADEM", is: "a DIAdem data set", instead: "save it in DIAdem as TDMS" },
    Kind {
        at: 0,
        begins: b"\x89HDF\r\n\x1a\n",
        is: "an HDF5 file",
        instead: "save its channels as CSV or as a MAT file",
    },
    Kind { at: 0, begins: b"SQLite format 3", is: "a database", instead: "export the test as CSV" },
    Kind { at: 0, begins: b"PK\x03\x04", is: "a zip archive", instead: "unpack it, and name the folder" },
    Kind { at: 0, begins: b"\x1f\x8b", is: "a packed file (gzip)", instead: "unpack it" },
    Kind { at: 0, begins: b"%PDF", is: "a PDF", instead: "export the test as CSV" },
    Kind { at: 0, begins: b"<?xml", is: "an XML file", instead: "export the test as CSV" },
];

/// First numbers of catman binary files: versions 5.0 to 5.99 as a 16-bit number (HBM, catman file format).
const CATMAN: std::ops::RangeInclusive<u16> = 5000..=5999;
const OF_CATMAN: (&str, &str) = ("a binary file of catman", "export it from catman as ASCII, MDF 4 or MAT");

/// Returns all texts about such files.
pub(crate) fn words() -> impl Iterator<Item = &'static str> {
    KINDS.iter().flat_map(|kind| [kind.is, kind.instead]).chain([OF_CATMAN.0, OF_CATMAN.1])
}

/// Returns the format of an unsupported file and the advice. Returns `None` if the file may be a text.
pub(crate) fn known(bytes: &[u8]) -> Option<(&'static str, &'static str)> {
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
            assert!(is.contains(wanted) && !instead.is_empty(), "{is}");
        }
        for head in [&b"Time [s];Force [N]\n"[..], b"MTS793|MPT|ENU|1", b"", b"1", "\u{feff}Zeit".as_bytes()] {
            assert_eq!(known(head), None);
        }
    }
}
