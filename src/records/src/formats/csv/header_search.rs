//! Finds the line with the column headings of a text, and its delimiter.

use super::lines::{is_comment, is_figure, uncommented};
use crate::columns::cell::number;
use crate::columns::delimiter::{self, split};
use crate::columns::heading::{Heading, heading};
use crate::columns::layout::{column_number, numbered};
use crate::columns::table::{HEADER_WITHIN, is_header, is_units_row};
use crate::dates::clock;
use crate::options::Options;

/// Start of the table in a text.
pub(super) struct Start {
    /// Line of the header, or of the first row if there is no header. Counts from 0.
    pub index: usize,
    /// Byte offset of the line `index` in the text.
    pub offset: usize,
    pub delimiter: u8,
    pub header: Vec<String>,
    /// Whether the line `index` is the header.
    pub headed: bool,
    /// Whether the header is a comment line, a form that numerical programs write.
    pub commented: bool,
}

impl Start {
    pub fn headed(index: usize, offset: usize, delimiter: u8, header: Vec<String>) -> Start {
        Start { index, offset, delimiter, header, headed: true, commented: false }
    }
}

/// Finds the header and its delimiter. If the user names columns by number, the header may be missing. The table then
/// begins with the first row of numbers. If no other line is the header, the header may be a comment line. The second
/// value is the first line that is not a comment.
pub(super) fn start(text: &str, options: &Options) -> (Option<Start>, Option<String>) {
    let mut offset = 0;
    let mut first_line = None;
    let mut numbers: Option<Start> = None;
    let by_number = options.columns.values().any(|wanted| column_number(wanted).is_some());
    let mut above: Vec<String> = Vec::new();
    let mut commented: Option<Start> = None;
    for (index, line) in text.split_inclusive('\n').enumerate().take(HEADER_WITHIN) {
        if !is_comment(line) {
            first_line.get_or_insert_with(|| line.to_owned());
            let trimmed = line.trim_end();
            for delimiter in delimiter::ALL {
                let header = split(trimmed, delimiter);
                // A row of numbers is not a header, even if a cell contains the number by which the user selected its
                // column.
                let row = header.len() > 1
                    && header.iter().any(|c| !c.trim().is_empty())
                    && header.iter().all(|c| number(c, delimiter != b',').is_some() || clock::seconds(c).is_some());
                if !row && is_header(&header, options) {
                    return (Some(Start::headed(index, offset, delimiter, header)), first_line);
                }
                if by_number && row && numbers.is_none() {
                    let names = numbered(header.len());
                    let header = if above.len() == names.len() { std::mem::take(&mut above) } else { names };
                    numbers = Some(Start { headed: false, ..Start::headed(index, offset, delimiter, header) });
                }
            }
            above = split(trimmed, delimiter::detect(trimmed));
        } else {
            // Use the last comment that names the columns, because earlier comments may describe an earlier table.
            let found = delimiter::ALL.into_iter().find_map(|delimiter| {
                let header = split(uncommented(line), delimiter);
                let found = Start { commented: true, ..Start::headed(index, offset, delimiter, header) };
                is_header(&found.header, options).then_some(found)
            });
            commented = found.or(commented);
        }
        offset += line.len();
    }
    (numbers.or(commented), first_line)
}

/// Replaces blanks between columns by tabs. Two or more blanks are a separator, because names may contain single
/// blanks. With `any`, and in a line of numbers, one blank is a separator too.
pub(super) fn with_tabs(text: &str, any: bool) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.lines() {
        let any = any || line.split_whitespace().all(|cell| is_figure(cell, true));
        let mut blanks = 0;
        for c in line.trim().chars() {
            if c == ' ' {
                blanks += 1;
                continue;
            }
            if blanks > usize::from(!any) {
                out.push('\t');
            } else if blanks == 1 {
                out.push(' ');
            }
            blanks = 0;
            out.push(c);
        }
        out.push('\n');
    }
    out
}

/// Splits names that a single blank separates. Plain files of MTS stations have such headings.
///
/// The number of names equals the number of units below. The split maximizes the number of known names.
pub(super) fn part_names(found: &mut Start, text: &str) {
    /// Largest number of columns of a file whose names are separated by single blanks.
    const MOST: usize = 32;
    let below = text[found.offset..].lines().skip(1).find(|line| !is_comment(line)).unwrap_or_default();
    let units: Vec<&str> = below.split_whitespace().collect();
    let words: Vec<&str> = found.header.iter().flat_map(|cell| cell.split_whitespace()).collect();
    let columns = units.len();
    if !is_units_row(&units) || columns == found.header.len() || columns > MOST || words.len() > 4 * MOST {
        return;
    }
    // Best split of the first words into names: the number of known names, and the start of the last name. The first
    // index is the number of names, and the second is the number of words.
    let mut best: Vec<Vec<Option<(usize, usize)>>> = vec![vec![None; words.len() + 1]; columns + 1];
    best[0][0] = Some((0, 0));
    for column in 1..=columns {
        for end in column..=words.len() {
            for begin in column - 1..end {
                let Some((known, _)) = best[column - 1][begin] else { continue };
                let is_known = matches!(heading(&words[begin..end].join(" ")), Heading::Channel(..));
                let now = (known + usize::from(is_known), begin);
                if best[column][end].is_none_or(|(most, _)| now.0 > most) {
                    best[column][end] = Some(now);
                }
            }
        }
    }
    let (mut names, mut end) = (Vec::new(), words.len());
    for column in (1..=columns).rev() {
        let Some((_, begin)) = best[column][end] else { return };
        names.push(words[begin..end].join(" "));
        end = begin;
    }
    names.reverse();
    found.header = names;
}
