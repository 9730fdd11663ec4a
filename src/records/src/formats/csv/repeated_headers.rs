//! Headers that an acquisition system repeats between its rows.

use super::lines::is_comment;
use crate::columns::cell::number;
use crate::dates::clock;

/// Headers that an acquisition system, such as an MTS station, repeats before every block of rows.
pub(super) struct Blocks {
    /// Ranges of lines between one block of rows and the next, ascending, counted from 0.
    ///
    /// A range extends from the first line that is not a row to the last line before the next row.
    headers: Vec<std::ops::Range<usize>>,
    next: usize,
    /// Whether the next row is the first row below a header.
    fresh: bool,
    last_time: Option<f64>,
}

pub(super) enum Block {
    Data,
    Header,
}

impl Blocks {
    pub fn new(text: &str, header: &str, delimiter: u8) -> Blocks {
        let mut headers: Vec<std::ops::Range<usize>> = Vec::new();
        let header_again = || text.lines().filter(|line| line.trim_end() == header).nth(1).is_some();
        if !header.trim().is_empty() && header_again() {
            // Extend each repetition of the header to the row before and to the row after.
            let is_row = |line: &str| {
                let cells = split_plain(line, delimiter);
                cells.clone().next().is_some_and(|c| !c.trim().is_empty())
                    && cells.clone().count() > 1
                    && cells.filter(|c| !c.trim().is_empty()).all(|c| {
                        number(c.trim().trim_matches('"'), delimiter != b',').is_some() || clock::seconds(c).is_some()
                    })
            };
            let mut seen = false;
            let mut between: Option<usize> = None;
            let mut repeated = false;
            // The CSV reader counts empty lines as part of the next row.
            let mut empty: Option<usize> = None;
            for (index, line) in text.lines().enumerate() {
                let is_header = line.trim_end() == header;
                if is_header && !seen {
                    seen = true;
                    between = None;
                    continue;
                }
                if !seen {
                    continue;
                }
                if is_comment(line) {
                    empty.get_or_insert(index);
                    continue;
                }
                let begins = empty.take().unwrap_or(index);
                if is_row(line) {
                    if let (Some(from), true) = (between.take(), repeated) {
                        headers.push(from..begins);
                    }
                    repeated = false;
                } else {
                    between.get_or_insert(begins);
                    repeated |= is_header;
                }
            }
        }
        Blocks { headers, next: 0, fresh: false, last_time: None }
    }

    pub fn classify(&mut self, line: usize) -> Block {
        while self.headers.get(self.next).is_some_and(|range| range.end <= line) {
            self.next += 1;
            self.fresh = true;
        }
        match self.headers.get(self.next) {
            Some(range) if range.contains(&line) => Block::Header,
            _ => Block::Data,
        }
    }

    pub fn begins_anew(&mut self, time: Option<f64>) -> bool {
        let anew = self.fresh && matches!((time, self.last_time), (Some(now), Some(before)) if now < before);
        self.fresh = false;
        self.last_time = time.filter(|t| t.is_finite()).or(self.last_time);
        anew
    }
}

/// Splits a line without regard to quotes, which is sufficient to distinguish rows from text.
fn split_plain(line: &str, delimiter: u8) -> std::str::Split<'_, char> {
    line.split(delimiter as char)
}
