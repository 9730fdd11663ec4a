//! Recognizes comments and numbers in the lines of a text.

use crate::columns::cell::number;
use crate::dates::clock;

/// Returns whether a line is empty or a comment.
pub(super) fn is_comment(line: &str) -> bool {
    matches!(line.trim_start().bytes().next(), None | Some(b'#' | b'%')) || line.trim_start().starts_with("//")
}

/// Returns the text of a comment line after its mark.
pub(super) fn uncommented(line: &str) -> &str {
    line.trim_start().trim_start_matches(['#', '%', '/']).trim()
}

/// Returns whether a cell is a whole number: digits, and optionally a minus sign. An empty cell counts too.
pub(super) fn is_whole(cell: &[u8]) -> bool {
    let cell = cell.trim_ascii();
    cell.strip_prefix(b"-").unwrap_or(cell).iter().all(u8::is_ascii_digit)
}

/// Returns whether a cell contains a number or a time of day.
pub(super) fn is_figure(cell: &str, decimal_comma: bool) -> bool {
    number(cell, decimal_comma).is_some() || clock::seconds(cell).is_some()
}
