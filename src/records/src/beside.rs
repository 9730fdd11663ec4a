//! Lines of a table that are no rows: what a channel is below the heading, and results or remarks below the last row. They are
//! told and not read; text between rows is a fault.

use super::error::RecordError;
use super::phrases;
use super::sentence::Sentence;
use super::table::Rows;

/// Lines right below a heading that hold no figures: names of sensors, rates, remarks of a channel.
pub(crate) const LABELS: usize = 5;

/// The lines beside the rows of one table.
#[derive(Default)]
pub(crate) struct Beside {
    labels: Vec<(usize, String)>,
    foot: Option<Foot>,
}

/// What stands below the last row of figures, with the fault that it is where figures follow.
struct Foot {
    line: usize,
    text: String,
    fault: RecordError,
}

impl Beside {
    /// Takes a line that has no time in figures. Nothing where it lies below a row, or right below the heading without any figure
    /// (`figures` tells of the cells that are read); else its fault.
    pub fn take(
        &mut self,
        below_rows: bool,
        line: usize,
        cells: &[String],
        figures: bool,
        fault: RecordError,
    ) -> Result<(), RecordError> {
        if self.foot.is_some() {
            return Ok(());
        }
        let text = shortened(cells);
        if below_rows {
            self.foot = Some(Foot { line, text, fault });
        } else if !figures && self.labels.len() < LABELS {
            self.labels.push((line, text));
        } else {
            return Err(fault);
        }
        Ok(())
    }

    /// A row of figures comes: text between it and the rows before is no foot of the table.
    pub fn row(&mut self) -> Result<(), RecordError> {
        self.foot.take().map_or(Ok(()), |foot| Err(foot.fault))
    }

    /// Says of the tests of a table what was not read beside them.
    pub fn tell(self, rows: &mut Rows) {
        for (line, text) in self.labels {
            rows.note("ignored", Sentence::from(phrases::BELOW_HEADING).with("line", line).with("text", text));
        }
        if let Some(Foot { line, text, .. }) = self.foot {
            rows.note("ignored", Sentence::from(phrases::BELOW_TABLE).with("line", line).with("text", text));
        }
    }
}

/// Cells of a line, as a note quotes them.
fn shortened(cells: &[String]) -> String {
    let told = cells.iter().map(|c| c.trim()).filter(|c| !c.is_empty());
    let text: String = told.collect::<Vec<_>>().join(" ").chars().filter(|c| !c.is_control()).collect();
    let short: String = text.chars().take(80).collect();
    if short.len() < text.len() { format!("'{short} ...'") } else { format!("'{short}'") }
}
