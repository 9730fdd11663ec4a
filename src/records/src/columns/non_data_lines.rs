//! Handles lines of a table that are not rows.
//!
//! Such lines describe the channels below the heading, give results or remarks below the last row, or are messages of
//! the acquisition between rows. Notes report these lines. Many of them, or lines with figures, are an error.

use super::heading::{Heading, heading};
use super::table::{Rows, is_units_row};
use crate::error::RecordError;
use crate::messages::phrases;
use dashpot_messages::{Sentence, Template};

/// Largest number of lines without figures right below a heading: names of sensors, rates, remarks on a channel.
pub(crate) const LABELS: usize = 5;

/// The lines of one table that are not rows.
#[derive(Default)]
pub(crate) struct Beside {
    labels: Vec<(usize, String)>,
    foot: Option<Foot>,
    rows: usize,
    /// Lines between rows without a figure.
    remarks: Lot,
    /// Rows with extra text after the columns of the heading. The text is ignored.
    texts: Lot,
    /// Rows with extra figures after the columns of the heading. The rows are left out.
    figures: Lot,
}

/// Lines of one kind.
#[derive(Default)]
struct Lot {
    count: usize,
    /// Line numbers of the first of them.
    lines: Vec<usize>,
    first: String,
    fault: Option<RecordError>,
}

impl Lot {
    /// Number of lines that a note names.
    const NAMED: usize = 5;

    /// Adds lines. Keeps the text and the fault of the first one.
    fn add_all(&mut self, lines: &[usize], text: &str, fault: RecordError) {
        if self.fault.is_none() {
            (self.first, self.fault) = (text.to_owned(), Some(fault));
        }
        let room = Self::NAMED.saturating_sub(self.lines.len());
        self.lines.extend(lines.iter().take(room));
        self.count += lines.len();
    }

    /// Returns a note about the lines, or their fault if `few` is set and they are more than single stray lines.
    fn tell(self, rows: usize, few: bool, template: Template) -> Result<Option<Sentence>, RecordError> {
        /// Number of stray lines that any test may have, and the number of rows per further stray line. More lines
        /// indicate another table than the heading says.
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

/// Text below the last row of figures, with the fault that applies if figures follow.
struct Foot {
    line: usize,
    text: String,
    fault: RecordError,
    /// Line numbers if the text is a remark between rows, without figures, headings or units.
    remarks: Option<Vec<usize>>,
}

impl Beside {
    /// Handles a line that is no row. Accepts lines below a row, and lines without figures right below the heading.
    /// Returns the fault of other lines. `figures` states whether a cell of a channel other than the time contains a
    /// figure.
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

    /// Handles a row of figures. Text between two rows is then no foot of the table, but a remark or a fault.
    pub fn row(&mut self) -> Result<(), RecordError> {
        self.rows += 1;
        let Some(Foot { text, fault, remarks, .. }) = self.foot.take() else { return Ok(()) };
        let Some(lines) = remarks else { return Err(fault) };
        self.remarks.add_all(&lines, &text, fault);
        Ok(())
    }

    /// Handles a row with more fields than the heading. Returns whether the row is usable without them, which is so if
    /// they are text.
    pub fn surplus(&mut self, line: usize, fields: &[String], figures: bool, fault: RecordError) -> bool {
        let kind = if figures { &mut self.figures } else { &mut self.texts };
        kind.add_all(&[line], &shortened(fields), fault);
        !figures
    }

    /// Adds notes to the tests of a table about the lines that were not read.
    ///
    /// # Errors
    /// The fault of lines that are too many to be stray lines.
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
