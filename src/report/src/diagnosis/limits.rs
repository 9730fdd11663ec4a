//! Effects that the diagnosed records cannot show, tests that would resolve open questions, and remarks.

use crate::blocks::{Block, Column, Section, Table};
use crate::cells::Cell;
use crate::words::Words;
use dashpot_diagnosis::Diagnosis;

/// Builds the section of proposed tests, and of the effects that the diagnosed records cannot show.
pub fn section(found: &Diagnosis, words: &Words) -> Section {
    let mut blocks = Vec::new();
    if !found.next_tests.is_empty() {
        blocks.push(Block::Heading(words.next_tests_section.into()));
        blocks.push(Block::Table(next_tests(found, words)));
    }
    blocks.push(Block::Heading(words.cannot_show_section.into()));
    if found.could_not_test.is_empty() {
        blocks.push(Block::Paragraph(words.all_would_show.into()));
    } else {
        let rows =
            found.could_not_test.iter().map(|c| vec![words.named(c.effect).into(), words.say(&c.why).into()]).collect();
        let columns = vec![Column::words(words.col_effect), Column::words(words.col_cannot_show)];
        let caption = words.cannot_show_caption.to_owned();
        blocks.push(Block::Table(Table { caption, columns, rows, sortable: false }));
    }
    Section::new("limits", words.limits_section, blocks)
}

/// Lists the remarks of the diagnosis and those from reading the records (`reading`). Returns `None` without remarks.
pub fn remarks(found: &Diagnosis, reading: &[String], words: &Words) -> Option<Section> {
    // The remark on the reference model is next to the verdict, in the first section of the report.
    let notes = found.notes.iter().filter(|note| Some(*note) != found.about_the_reference.as_ref());
    let remarks: Vec<String> = notes.map(|note| words.say(note)).chain(reading.iter().cloned()).collect();
    (!remarks.is_empty()).then(|| Section::new("remarks", words.remarks, vec![Block::List(remarks)]))
}

fn next_tests(found: &Diagnosis, words: &Words) -> Table {
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
                words.say(&t.text).into(),
            ]
        })
        .collect();
    let columns = vec![
        Column::figures(words.col_next_amplitude),
        Column::figures(words.col_next_frequency),
        Column::figures(words.col_next_mean),
        Column::figures(words.col_side_force),
        Column::figures(words.col_difference_rms),
        Column::words(words.col_what_to_do),
    ];
    Table { caption: words.next_tests_caption.to_owned(), columns, rows, sortable: false }
}
