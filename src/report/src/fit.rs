//! Result of a fit as the tables of a workbook; a fit has no HTML report.

use crate::blocks::{Block, Column, Section, Table};
use crate::cells::Cell;
use crate::inventory;
use crate::made::Made;
use crate::parameters;
use crate::whole_records::in_words;
use crate::words::Words;
use crate::workbook::Workbook;
use dashpot_identification::Fit;
use dashpot_identification::validation::Deviation;
use dashpot_records::Unusable;

/// Builds the tables of a fit, with its error over whole records, the unusable files, and the names of model and data.
pub fn workbook(
    (fit, error): (&Fit, &Deviation),
    unusable: &[Unusable],
    [model, data]: [&str; 2],
    made: Made,
    words: &'static Words,
) -> Workbook<'static> {
    Workbook {
        title: words.fit_title.to_owned(),
        subtitle: words.fill(words.fit_subtitle, &[("model", model), ("data", data)]),
        sections: sections(fit, error, unusable, words),
        made,
        words,
    }
}

/// Builds the sections on a fit: error over whole records, inventory of effects, estimates, measurement errors, used
/// tests, and remarks.
fn sections(fit: &Fit, over_whole_records: &Deviation, unusable: &[Unusable], words: &Words) -> Vec<Section> {
    let count = fit.tests.len().to_string();
    let answer = words.fill(words.fit_answer, &[("tests", &count), ("error", &in_words(over_whole_records, words))]);
    let mut sections = vec![Section::new("answer", words.answer, vec![Block::Lead(answer)])];
    let inventory = inventory::table(&fit.inventory, false, words).map(|table| vec![Block::Table(table)]);
    sections.extend(inventory.map(|blocks| Section::new("inventory", words.inventory_section, blocks)));
    sections.extend(parameters::section(&parameters::of_fit(fit, words), words));
    let table = |columns, rows| vec![Block::Table(Table { caption: String::new(), columns, rows, sortable: false })];
    if !fit.measured.is_empty() {
        let columns =
            vec![Column::words(words.col_name), Column::figures(words.col_value), Column::figures(words.col_interval)];
        let row = |m: &dashpot_identification::Measured| {
            let mut row = vec![Cell::from(words.named(m.name))];
            row.extend(Cell::of_reading(m.shown(), &m.reading(), words));
            row
        };
        sections.push(Section::new(
            "measured",
            words.fit_measured,
            table(columns, fit.measured.iter().map(row).collect()),
        ));
    }
    let rows = fit.tests.iter().map(|name| vec![name.as_str().into()]).collect();
    sections.push(Section::new("tests", words.fit_tests, table(vec![Column::words(words.col_test)], rows)));
    let notes = fit.notes.iter().chain(unusable.iter().map(|one| &one.why));
    let rows: Vec<Vec<Cell>> = notes.map(|note| vec![words.say(note).into()]).collect();
    if !rows.is_empty() {
        sections.push(Section::new("notes", words.remarks, table(vec![Column::words(words.col_note)], rows)));
    }
    sections
}
