//! Handles lines of a table that are not rows.
//!
//! Such lines describe the channels below the heading, give results or remarks below the last row, or are messages of
//! the acquisition between rows. Notes report these lines. Lines below the last row are never an error. Lines between
//! rows are an error if they are many or contain numbers, and so are lines below the heading.

use super::heading::{Heading, heading};
use super::table::{Rows, is_units_row};
use crate::error::RecordError;
use crate::messages::phrases;
use dashpot_messages::{Sentence, Template};

/// Largest number of lines without numbers directly below a heading. Such lines contain sensor names, rates or remarks
/// on a channel.
pub(crate) const LABELS: usize = 5;

/// Lines of one table that are not rows, and rows with more fields than the heading.
#[derive(Default)]
pub(crate) struct NonDataLines {
    labels: Vec<(usize, String)>,
    foot: Option<Foot>,
    rows: usize,
    /// Lines without a number between two rows.
    remarks: Lot,
    /// Rows with extra text after the columns of the heading. The text is ignored.
    texts: Lot,
    /// Rows with extra numbers after the columns of the heading. The table leaves these rows out.
    figures: Lot,
}

/// Lines of one kind, which one note reports.
#[derive(Default)]
struct Lot {
    count: usize,
    /// Line numbers of the first lines.
    lines: Vec<usize>,
    first: String,
    fault: Option<RecordError>,
}

impl Lot {
    /// Largest number of lines that a note names.
    const NAMED: usize = 5;

    /// Adds lines. Stores the text and the fault of the first line.
    fn add_all(&mut self, lines: &[usize], text: &str, fault: RecordError) {
        if self.fault.is_none() {
            (self.first, self.fault) = (text.to_owned(), Some(fault));
        }
        let room = Self::NAMED.saturating_sub(self.lines.len());
        self.lines.extend(lines.iter().take(room));
        self.count += lines.len();
    }

    /// Returns a note about the lines. Returns their fault instead if `few` is set and the lines are too many to be
    /// stray lines.
    fn tell(self, rows: usize, few: bool, template: Template) -> Result<Option<Sentence>, RecordError> {
        /// Number of stray lines that any test may have, and number of rows per stray line in long tests. The larger
        /// allowance applies. More lines indicate that the table does not match its heading.
        const FEW: (usize, usize) = (3, 50);
        let stray = self.count <= FEW.0.max(rows / FEW.1) && 2 * self.count < rows;
        match self.fault {
            Some(fault) if few && !stray => Err(fault),
            Some(_) => {
                let mut lines: Vec<String> = self.lines.iter().map(ToString::to_string).collect();
                if self.count > lines.len() {
                    lines.push("...".to_owned());
                }
                let told =
                    Sentence::from(template).with("count", self.count).with_names("lines", &lines, phrases::COMMA);
                Ok(Some(told.with("text", self.first)))
            }
            None => Ok(None),
        }
    }
}

/// Text below the last row, with the fault that applies if further rows follow.
struct Foot {
    line: usize,
    text: String,
    fault: RecordError,
    /// Line numbers of the text if it may be a remark between rows. A remark contains no numbers, headings or units.
    remarks: Option<Vec<usize>>,
}

impl NonDataLines {
    /// Handles a line that is not a row. Accepts lines below a row, and up to [`LABELS`] lines without numbers directly
    /// below the heading. Returns the fault of other lines. `figures` states whether a cell of a channel other than the
    /// time contains a number.
    pub fn take(
        &mut self,
        below_rows: bool,
        line: usize,
        cells: &[String],
        figures: bool,
        fault: RecordError,
    ) -> Result<(), RecordError> {
        let is_remark =
            !figures && !is_units_row(cells) && !cells.iter().any(|c| matches!(heading(c), Heading::Channel(..)));
        if let Some(foot) = &mut self.foot {
            match &mut foot.remarks {
                Some(lines) if is_remark => lines.push(line),
                remarks => *remarks = None,
            }
            return Ok(());
        }
        let text = shortened(cells);
        if below_rows {
            self.foot = Some(Foot { line, text, fault, remarks: is_remark.then(|| vec![line]) });
        } else if !figures && self.labels.len() < LABELS {
            self.labels.push((line, text));
        } else {
            return Err(fault);
        }
        Ok(())
    }

    /// Handles a row of numbers. Any text since the previous row is then a remark or a fault, not the foot of the
    /// table.
    pub fn row(&mut self) -> Result<(), RecordError> {
        self.rows += 1;
        let Some(Foot { text, fault, remarks, .. }) = self.foot.take() else { return Ok(()) };
        let Some(lines) = remarks else { return Err(fault) };
        self.remarks.add_all(&lines, &text, fault);
        Ok(())
    }

    /// Handles a row with more fields than the heading. Returns whether the row is usable without the extra fields,
    /// because they are text.
    pub fn surplus(&mut self, line: usize, fields: &[String], figures: bool, fault: RecordError) -> bool {
        let kind = if figures { &mut self.figures } else { &mut self.texts };
        kind.add_all(&[line], &shortened(fields), fault);
        !figures
    }

    /// Adds notes to the tests of a table about the lines that were not read.
    ///
    /// # Errors
    /// The fault of the lines of one kind, if these lines are too many to be stray lines.
    pub fn report(self, rows: &mut Rows) -> Result<(), RecordError> {
        for (line, text) in self.labels {
            rows.note("ignored", Sentence::from(phrases::BELOW_HEADING).with("line", line).with("text", text));
        }
        for (lot, few, kind, template) in [
            (self.remarks, true, "missing", phrases::BETWEEN_ROWS),
            (self.texts, false, "ignored", phrases::BEHIND_ROWS),
            (self.figures, true, "missing", phrases::LONGER_ROWS),
        ] {
            if let Some(told) = lot.tell(self.rows, few, template)? {
                rows.note(kind, told);
            }
        }
        if let Some(Foot { line, text, .. }) = self.foot {
            rows.note("ignored", Sentence::from(phrases::BELOW_TABLE).with("line", line).with("text", text));
        }
        Ok(())
    }
}

/// Joins and shortens the cells of a line for a note.
fn shortened(cells: &[String]) -> String {
    let told = cells.iter().map(|c| c.trim()).filter(|c| !c.is_empty());
    let text: String = told.collect::<Vec<_>>().join(" ").chars().filter(|c| !c.is_control()).collect();
    let short: String = text.chars().take(80).collect();
    if short.len() < text.len() { format!("'{short} ...'") } else { format!("'{short}'") }
}
