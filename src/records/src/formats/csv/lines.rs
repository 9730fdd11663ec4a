//! Comments and figures in the lines of a text.

use crate::columns::table::number;
use crate::dates::clock;

/// A line that is no data: empty or a comment.
pub(super) fn is_comment(line: &str) -> bool {
    matches!(line.trim_start().bytes().next(), None | Some(b'#' | b'%')) || line.trim_start().starts_with("//")
}

/// The text of a comment line behind its mark.
pub(super) fn uncommented(line: &str) -> &str {
    line.trim_start().trim_start_matches(['#', '%', '/']).trim()
}

/// Whether a cell is a whole number: digits, and a sign at most.
pub(super) fn is_whole(cell: &[u8]) -> bool {
    let cell = cell.trim_ascii();
    cell.strip_prefix(b"-").unwrap_or(cell).iter().all(u8::is_ascii_digit)
}

/// Whether a cell holds a number or a time of day.
pub(super) fn is_figure(cell: &str, decimal_comma: bool) -> bool {
    number(cell, decimal_comma).is_some() || clock::seconds(cell).is_some()
}
