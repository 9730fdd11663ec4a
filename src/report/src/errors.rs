//! Errors of model and FV curve, by amplitude, by peak velocity and by test.

use super::blocks::{Block, Column, Figure, Section, Table};
use super::numbers::{error, force, frequency, milli, percent};
use crate::cells::Cell;
use crate::plot::overview;
use crate::words::Words;
use dashpot_identification::validation::{Deviation, ErrorMatrix, Errors, MatrixRow, SLOW_PEAK_VELOCITY, Validation};
use dashpot_messages::Message;

/// Builds the figures of the error by amplitude and peak velocity, and of the error of every test.
pub fn pictures(validation: &Validation, words: &Words) -> Section {
    let mut blocks = Vec::new();
    let map = overview::error_map(validation, words);
    blocks.extend(map.map(|svg| Block::Wide(Figure::new("overview-amplitude-velocity", svg))));
    if !blocks.is_empty() {
        blocks.push(Block::Paragraph(words.matrix_about.to_owned()));
    }
    blocks.push(Block::Wide(Figure::new("overview-tests", overview::error_of_tests(validation, words))));
    Section::new("matrix", words.matrix_section, blocks)
}

/// Builds the tables of the errors by amplitude and by peak velocity.
pub fn rows(validation: &Validation, words: &Words) -> Vec<Block> {
    let [by_amplitude, apart, second] = labelled(&validation.matrix, words, milli);
    if by_amplitude.is_empty() {
        return vec![Block::Table(table(words.row_rule.to_owned(), apart, words))];
    }
    let rule = [("rule", words.row_rule)];
    let first = by_amplitude.into_iter().chain(apart).collect();
    vec![
        Block::Table(table(words.fill(words.by_amplitude, &rule), first, words)),
        Block::Table(table(words.fill(words.by_peak_velocity, &rule), second, words)),
    ]
}

/// Labels three groups of rows of a matrix: by amplitude, tests outside the matrix (slow or not periodic), and by peak velocity.
fn labelled(matrix: &ErrorMatrix, words: &Words, write: fn(f64) -> String) -> [Vec<(String, MatrixRow)>; 3] {
    let named =
        |row: &MatrixRow, text: Message, value: f64| (words.fill(text, &[("value", &write(value))]), row.clone());
    let slow = matrix.slow.iter().map(|r| named(r, words.row_slow, SLOW_PEAK_VELOCITY));
    let other = matrix.not_periodic.iter().map(|r| (words.row_not_periodic.to_owned(), r.clone()));
    [
        matrix.by_amplitude.iter().map(|r| named(r, words.row_amplitude, r.value)).collect(),
        slow.chain(other).collect(),
        matrix.by_peak_velocity.iter().map(|r| named(r, words.row_peak_velocity, r.value)).collect(),
    ]
}

/// Builds the section with one table row per test.
pub fn tests(validation: &Validation, words: &Words) -> Section {
    let rows = validation
        .tests
        .iter()
        .map(|test| {
            let mut cells = vec![
                test.name.as_str().into(),
                Cell::milli(test.amplitude_m),
                Cell::known(Some(test.frequency_hz).filter(|f| *f > 0.0), |f| Cell::number(f, frequency)),
                Cell::milli(test.peak_velocity_m_s),
                Cell::number(test.max_force_n, force),
                if test.used_in_fit { words.yes.into() } else { words.no.into() },
            ];
            cells.extend(figures(&test.errors));
            cells
        })
        .collect();
    let mut columns = vec![
        Column::words(words.col_test),
        Column::figures(words.col_amplitude),
        Column::figures(words.col_frequency),
        Column::figures(words.col_peak_velocity),
        Column::figures(words.col_max_force),
        Column::words(words.col_in_fit),
    ];
    columns.extend(error_columns(words));
    let caption = words.tests_caption.to_owned();
    let table = Table { caption, columns, rows, sortable: true };
    Section::new("tests", words.tests_section, vec![Block::Table(table)])
}

/// Builds the errors by amplitude and peak velocity, before and after an improvement of the model. In each row of `matrix`, `fv_only`
/// contains the errors before, and `model` contains the errors after.
pub fn before_and_after(matrix: &ErrorMatrix, words: &Words) -> Vec<Block> {
    let [by_amplitude, apart, by_peak_velocity] = labelled(matrix, words, short);
    let about = |text: Message, rule: &str| words.fill(text, &[("rule", rule)]).trim_end().to_owned();
    let first = by_amplitude.into_iter().chain(apart).collect();
    let mut blocks = vec![two_sided(about(words.by_amplitude, words.mean_cycles_rule), first, words)];
    if !by_peak_velocity.is_empty() {
        blocks.push(two_sided(about(words.by_peak_velocity, ""), by_peak_velocity, words));
    }
    blocks
}

/// Formats a displacement, m, or a velocity, m/s, with [`milli`], and removes trailing zeros after the decimal point.
fn short(si: f64) -> String {
    let text = milli(si);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

fn two_sided(caption: String, rows: Vec<(String, MatrixRow)>, words: &Words) -> Block {
    let rows = rows
        .into_iter()
        .map(|(label, row)| {
            let Errors { model: after, fv_only: before } = &row.errors;
            let mut cells = start(label.into(), &row);
            for one in [before, after] {
                cells.extend(three(one));
            }
            cells
        })
        .collect();
    let mut columns =
        vec![Column::words(words.col_tests), Column::figures(words.col_number), Column::figures(words.col_max_force)];
    for group in [words.before, words.after] {
        let headings = [words.col_mean_error, words.col_error_percent, words.col_rms];
        columns.extend(headings.map(|heading| Column::figures(heading).in_group(group)));
    }
    Block::Table(Table { caption, columns, rows, sortable: false })
}

fn table(caption: String, rows: Vec<(String, MatrixRow)>, words: &Words) -> Table {
    let rows = rows
        .into_iter()
        .map(|(label, row)| {
            let mut cells = start(label.into(), &row);
            cells.extend(figures(&row.errors));
            cells
        })
        .collect();
    let mut columns =
        vec![Column::words(words.col_tests), Column::figures(words.col_number), Column::figures(words.col_max_force)];
    columns.extend(error_columns(words));
    Table { caption, columns, rows, sortable: false }
}

fn error_columns(words: &Words) -> Vec<Column> {
    let of_both = [words.col_mean_error, words.col_error_percent, words.col_rms];
    let regions = [words.col_region1, words.col_region2];
    let of_model = [of_both[0], of_both[1], regions[0], regions[1], of_both[2]];
    let model = of_model.map(|heading| Column::figures(heading).in_group(words.model));
    let curve = of_both.map(|heading| Column::figures(heading).in_group(words.group_curve));
    model.into_iter().chain(curve).collect()
}

/// Builds the cells for the columns of [`error_columns`].
fn figures(errors: &Errors) -> Vec<Cell> {
    let Errors { model, fv_only } = errors;
    let mut cells = vec![
        Cell::number(model.mean_error_n, error),
        Cell::number(model.error_percent, percent),
        Cell::number(model.region1_n, error),
        Cell::number(model.region2_n, error),
        Cell::number(model.rmse_n, error),
    ];
    cells.extend(three(fv_only));
    cells
}

/// Builds the cells of mean error, N, error in percent of the force, and rms error, N.
pub(crate) fn three(figures: &Deviation) -> [Cell; 3] {
    [
        Cell::number(figures.mean_error_n, error),
        Cell::number(figures.error_percent, percent),
        Cell::number(figures.rmse_n, error),
    ]
}

/// Builds the first cells of a row that summarizes several tests.
fn start(label: Cell, row: &MatrixRow) -> Vec<Cell> {
    vec![label, Cell::count(row.tests), Cell::number(row.max_force_n, force)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::of_test::tests::{compared, record};
    use crate::words::EN;
    use dashpot_identification::validation::validate;

    #[test]
    fn the_map_of_the_errors_says_what_its_percent_is_of() {
        let record = record(2, true);
        let section = pictures(&validate(&[compared(&record)]).unwrap(), &EN);
        let has_text = |block: &Block| matches!(block, Block::Paragraph(text) if text.contains("of the largest force"));
        assert!(section.blocks.iter().any(has_text));
    }
}
