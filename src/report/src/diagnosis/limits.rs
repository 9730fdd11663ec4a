//! What these records cannot show, the tests that would tell more, and remarks.

use crate::blocks::{Block, Column, Section, Table};
use crate::cells::Cell;
use dashpot_diagnosis::Diagnosis;

/// The last words.
pub fn section(found: &Diagnosis, reading: &[String]) -> Section {
    let mut blocks = Vec::new();
    if !found.next_tests.is_empty() {
        blocks.push(Block::Heading("Tests worth running next".into()));
        blocks.push(Block::Table(next_tests(found)));
    }
    blocks.push(Block::Heading("What these records cannot show".into()));
    if found.could_not_test.is_empty() {
        blocks.push(Block::Paragraph("Every known effect would have shown in these records.".into()));
    } else {
        let rows = found.could_not_test.iter().map(|c| vec![c.effect.into(), c.why.as_str().into()]).collect();
        let columns = vec![Column::words("effect"), Column::words("why, and what would show it")];
        let caption = "Neither found nor ruled out.".to_owned();
        blocks.push(Block::Table(Table { caption, columns, rows, sortable: false }));
    }
    let remarks: Vec<String> = found.notes.iter().chain(reading).cloned().collect();
    if !remarks.is_empty() {
        blocks.push(Block::Heading("Remarks".into()));
        blocks.push(Block::List(remarks));
    }
    Section::new("limits", "What to measure next", blocks)
}

fn next_tests(found: &Diagnosis) -> Table {
    let three = |value: Option<f64>| Cell::known(value, |v| Cell::digits(v, 3));
    let rows = found
        .next_tests
        .iter()
        .map(|t| {
            vec![
                Cell::known(t.amplitude_m, Cell::milli),
                three(t.frequency_hz),
                Cell::known(t.mean_displacement_m, Cell::milli),
                three(t.side_force_n),
                three(t.difference_n),
                t.text.as_str().into(),
            ]
        })
        .collect();
    let columns = vec![
        Column::figures("amplitude, mm"),
        Column::figures("frequency, Hz"),
        Column::figures("mean position, mm"),
        Column::figures("side force, N"),
        Column::figures("difference, N rms"),
        Column::words("what to do"),
    ];
    let caption =
        "Difference: by how much the explanations' predictions differ there. A test decides where that is well above \
                   the noise."
            .to_owned();
    Table { caption, columns, rows, sortable: false }
}
