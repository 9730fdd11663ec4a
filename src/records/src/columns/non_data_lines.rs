//! Lines of a table that are no rows.
//!
//! What a channel is below the heading, results or remarks below the last row, and what an acquisition writes between
//! its rows. They are told and not read; many of them, or figures in them, are a fault.

use super::heading::{Heading, heading};
use super::table::{Rows, is_units_row};
use crate::error::RecordError;
use crate::messages::phrases;
use dashpot_messages::{Sentence, Template};

/// Lines right below a heading that hold no figures: names of sensors, rates, remarks of a channel.
pub(crate) const LABELS: usize = 5;

/// The lines beside the rows of one table.
#[derive(Default)]
pub(crate) struct Beside {
    labels: Vec<(usize, String)>,
    foot: Option<Foot>,
    rows: usize,
    /// Lines between rows without a figure.
    remarks: Lot,
    /// Rows with text behind the columns of the heading, which are read without it.
    texts: Lot,
    /// Rows with figures behind the columns of the heading, which are left out.
    figures: Lot,
}

/// Lines of one kind.
#[derive(Default)]
struct Lot {
    count: usize,
    /// The first of them.
    lines: Vec<usize>,
    first: String,
    fault: Option<RecordError>,
}

impl Lot {
    /// Lines that a note names.
    const NAMED: usize = 5;

    /// Takes lines one after the other; text and fault are the first one's.
    fn add_all(&mut self, lines: &[usize], text: &str, fault: RecordError) {
        if self.fault.is_none() {
            (self.first, self.fault) = (text.to_owned(), Some(fault));
        }
        let room = Self::NAMED.saturating_sub(self.lines.len());
        self.lines.extend(lines.iter().take(room));
        self.count += lines.len();
    }

    /// Says that they were left; their fault where they are more than stray ones among so many rows.
    fn tell(self, rows: usize, few: bool, template: Template) -> Result<Option<Sentence>, RecordError> {
        /// Stray lines that any test may have, and the share of its rows; more is another table than its heading says.
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

/// What stands below the last row of figures, with the fault that it is where figures follow.
struct Foot {
    line: usize,
    text: String,
    fault: RecordError,
    /// Its lines, where it is a remark between rows: nothing in it is a figure, a heading or a unit.
    remarks: Option<Vec<usize>>,
}

impl Beside {
    /// Takes a line that is no row. Nothing where it lies below a row, or right below the heading without any figure
    /// (`figures` tells of the cells that are read, but for its time); else its fault.
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

    /// A row of figures comes: text between it and the rows before is no foot of the table.
    pub fn row(&mut self) -> Result<(), RecordError> {
        self.rows += 1;
        let Some(Foot { text, fault, remarks, .. }) = self.foot.take() else { return Ok(()) };
        let Some(lines) = remarks else { return Err(fault) };
        self.remarks.add_all(&lines, &text, fault);
        Ok(())
    }

    /// A row has more fields than the heading. Whether it can be read without them: as long as they are text.
    pub fn surplus(&mut self, line: usize, fields: &[String], figures: bool, fault: RecordError) -> bool {
        let kind = if figures { &mut self.figures } else { &mut self.texts };
        kind.add_all(&[line], &shortened(fields), fault);
        !figures
    }

    /// Says of the tests of a table what was not read beside them.
    ///
    /// # Errors
    /// The fault of lines that are too many to be stray ones.
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

/// Cells of a line, as a note quotes them.
fn shortened(cells: &[String]) -> String {
    let told = cells.iter().map(|c| c.trim()).filter(|c| !c.is_empty());
    let text: String = told.collect::<Vec<_>>().join(" ").chars().filter(|c| !c.is_control()).collect();
    let short: String = text.chars().take(80).collect();
    if short.len() < text.len() { format!("'{short} ...'") } else { format!("'{short}'") }
}
