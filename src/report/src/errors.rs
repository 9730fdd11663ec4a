//! Errors by amplitude, by peak velocity and test by test.

use super::blocks::{Block, Column, Figure, Section, Table};
use super::numbers::{error, force, frequency, milli, percent};
use crate::plot::overview;
use dashpot_identification::validation::{Errors, MatrixRow, Validation};

const MODEL: &str = "model";
const CURVE: &str = "FV curve alone";

/// The error matrix.
pub fn section(validation: &Validation) -> Section {
    let matrix = &validation.matrix;
    let mut blocks = Vec::new();
    blocks.extend(
        overview::error_map(validation).map(|svg| Block::Wide(Figure::new("overview-amplitude-velocity", svg))),
    );
    let apart: Vec<&MatrixRow> = matrix.slow.iter().chain(&matrix.not_periodic).collect();
    let rule = "Each test has equal weight in its row; the percent is of the largest force of the row.";
    if !matrix.by_amplitude.is_empty() {
        let rows = matrix.by_amplitude.iter().chain(apart.iter().copied());
        blocks.push(Block::Table(table(format!("Tests of one amplitude together. {rule}"), rows)));
        let rows = matrix.by_peak_velocity.iter();
        blocks.push(Block::Table(table(format!("Tests of one peak velocity together. {rule}"), rows)));
    } else {
        blocks.push(Block::Table(table(rule.to_owned(), apart.iter().copied())));
    }
    Section::new("matrix", "Errors by amplitude and peak velocity", blocks)
}

/// The table of single tests.
pub fn tests(validation: &Validation) -> Section {
    let rows = validation
        .tests
        .iter()
        .map(|test| {
            let mut cells = vec![
                test.name.clone(),
                milli(test.amplitude_m),
                if test.frequency_hz > 0.0 { frequency(test.frequency_hz) } else { "–".into() },
                milli(test.peak_velocity_m_s),
                force(test.max_force_n),
                if test.used_in_fit { "yes".into() } else { "no".into() },
            ];
            cells.extend(figures(&test.errors));
            cells
        })
        .collect();
    let mut columns = vec![
        Column::words("test"),
        Column::figures("amplitude,\u{a0}mm"),
        Column::figures("frequency,\u{a0}Hz"),
        Column::figures("peak velocity,\u{a0}mm/s"),
        Column::figures("largest force,\u{a0}N"),
        Column::words("in fit"),
    ];
    columns.extend(error_columns());
    let caption = "Every test by itself; the percent is of its own largest force.".to_owned();
    Section::new("tests", "Errors of every test", vec![Block::Table(Table { caption, columns, rows, sortable: true })])
}

/// Errors of one row per amplitude or peak velocity, before and after an improvement of the model, which stands in the
/// places of the curve and the model.
pub fn before_and_after<'a>(caption: String, rows: impl Iterator<Item = &'a MatrixRow>) -> Table {
    let rows = rows
        .map(|row| {
            let Errors { model: after, fv_only: before } = &row.errors;
            let mut cells = vec![row.label.clone(), row.tests.to_string(), force(row.max_force_n)];
            for one in [before, after] {
                cells.extend([error(one.mean_error_n), percent(one.error_percent), error(one.rmse_n)]);
            }
            cells
        })
        .collect();
    let mut columns = vec![Column::words("tests"), Column::figures("number"), Column::figures("largest force,\u{a0}N")];
    for group in ["before", "after"] {
        let headings = ["mean error,\u{a0}N", "error,\u{a0}%", "rms error,\u{a0}N"];
        columns.extend(headings.map(|heading| Column::figures(heading).of(group)));
    }
    Table { caption, columns, rows, sortable: false }
}

fn table<'a>(caption: String, rows: impl Iterator<Item = &'a MatrixRow>) -> Table {
    let rows = rows
        .map(|row| {
            let mut cells = vec![row.label.clone(), row.tests.to_string(), force(row.max_force_n)];
            cells.extend(figures(&row.errors));
            cells
        })
        .collect();
    let mut columns = vec![Column::words("tests"), Column::figures("number"), Column::figures("largest force,\u{a0}N")];
    columns.extend(error_columns());
    Table { caption, columns, rows, sortable: false }
}

fn error_columns() -> Vec<Column> {
    vec![
        Column::figures("mean error,\u{a0}N").of(MODEL),
        Column::figures("error,\u{a0}%").of(MODEL),
        Column::figures("region 1,\u{a0}N").of(MODEL),
        Column::figures("region 2,\u{a0}N").of(MODEL),
        Column::figures("rms error,\u{a0}N").of(MODEL),
        Column::figures("mean error,\u{a0}N").of(CURVE),
        Column::figures("error,\u{a0}%").of(CURVE),
        Column::figures("rms error,\u{a0}N").of(CURVE),
    ]
}

/// Cells below [`error_columns`].
fn figures(errors: &Errors) -> Vec<String> {
    let Errors { model, fv_only } = errors;
    vec![
        error(model.mean_error_n),
        percent(model.error_percent),
        error(model.region1_n),
        error(model.region2_n),
        error(model.rmse_n),
        error(fv_only.mean_error_n),
        percent(fv_only.error_percent),
        error(fv_only.rmse_n),
    ]
}
