//! Decodes the character encodings of text files.

use std::borrow::Cow;

/// Returns the text of a short table that a spreadsheet saved, without the byte order mark.
pub fn text(bytes: &[u8]) -> String {
    decode(bytes).0.trim_start_matches('\u{feff}').to_owned()
}

/// Decodes a file in UTF-8, or in UTF-16 with a byte order mark. For all other files, assumes the code page of western
/// Windows (1252) and returns `true` as the second value.
///
/// Old exports, and spreadsheets that do not save UTF-8, use this code page for µ and °. Bytes that are undefined in
/// the code page are read as Latin-1.
pub(super) fn decode(bytes: &[u8]) -> (Cow<'_, str>, bool) {
    let (text, guessed) = characters(bytes);
    // Old Macintosh programs end lines with only a carriage return. It becomes a line feed.
    let returns_alone = text.contains('\r') && !text.contains('\n');
    (if returns_alone { text.replace('\r', "\n").into() } else { text }, guessed)
}

fn characters(bytes: &[u8]) -> (Cow<'_, str>, bool) {
    let utf16 = |from: fn([u8; 2]) -> u16| -> String {
        let units: Vec<u16> = bytes[2..].chunks_exact(2).map(|b| from([b[0], b[1]])).collect();
        String::from_utf16_lossy(&units)
    };
    match bytes {
        [0xFF, 0xFE, ..] => return (utf16(u16::from_le_bytes).into(), false),
        [0xFE, 0xFF, ..] => return (utf16(u16::from_be_bytes).into(), false),
        _ => {}
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => (text.into(), false),
        Err(_) => (encoding_rs::WINDOWS_1252.decode_without_bom_handling(bytes).0, true),
    }
}
