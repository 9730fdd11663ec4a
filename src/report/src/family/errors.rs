//! Errors of a model of an adjustable damper at each setting.

use super::{named, named_summary};
use crate::blocks::{Column, Table};
use crate::cells::Cell;
use crate::errors::three;
use crate::numbers::{digits, error, percent};
use crate::words::Words;
use dashpot_core::family::Definition;
use dashpot_identification::family::{FamilyFit, SettingError};
use dashpot_identification::validation::{Summary, Validation};
use dashpot_records::setting_in_words;

/// Builds the table of the errors of the model and of its FV curve over the whole records of each setting.
///
/// Tests with a changing setting have a separate row.
pub fn validated(damper: &Definition, validation: &Validation, words: &Words) -> Table {
    let row = |name: String, summary: &Summary| {
        let mut row: Vec<Cell> = vec![name.into(), Cell::count(summary.tests)];
        row.extend(three(&summary.errors.model));
        row.extend(three(&summary.errors.fv_only));
        row
    };
    let mut rows: Vec<Vec<Cell>> =
        validation.settings.iter().map(|of| row(named_summary(damper, of, words), &of.summary)).collect();
    rows.extend(validation.changing.iter().map(|of| row(words.family_changing.to_owned(), &of.summary)));
    let figures = |group: &'static str| {
        [words.col_mean_error, words.col_error_percent, words.col_rms]
            .map(|heading| Column { group, ..Column::figures(heading) })
    };
    let mut columns = vec![Column::words(words.col_setting), Column::figures(words.col_number)];
    columns.extend(figures(words.model));
    columns.extend(figures(words.group_curve));
    Table { caption: words.family_table.to_owned(), columns, rows, sortable: false }
}

/// Describes the error at the setting that the model predicts worst from the other settings. Adds advice if this error
/// is much larger than the error of a fit at this setting.
pub fn between(fit: &FamilyFit, words: &Words) -> String {
    let Some(worst) = fit.worst_left_out() else { return words.family_between_unknown.to_owned() };
    let at = words.number(&setting_in_words(worst.setting, &fit.setting.unit));
    let figures = [digits(worst.error.mean_error_n, 3), percent(worst.error.error_percent), digits(worst.ratio, 2)];
    let [error, percent, ratio] = figures.each_ref();
    // Records with a doubtful setting cause a large error at a left-out setting. Further records do not help then, so
    // the advice is to check the settings.
    let advice = match fit.label_doubts.is_empty() {
        true => words.fill(words.family_between_records, &[("at", &at)]),
        false => words.family_between_labels.to_owned(),
    };
    let text = if worst.is_worse() { words.family_between_worse } else { words.family_between };
    let values = [("at", &*at), ("error", error), ("percent", percent), ("ratio", ratio), ("advice", &advice)];
    words.fill(text, &values)
}

/// Builds a table of the errors of three models at each setting. They are a fit at this setting alone, the family (one
/// fit over all settings), and the family without this setting.
pub fn left_out(damper: &Definition, fit: &FamilyFit, words: &Words) -> Table {
    let pair = |of: Option<&SettingError>| match of {
        Some(of) => [Cell::number(of.mean_error_n, error), Cell::number(of.error_percent, percent)],
        None => [Cell::none(), Cell::none()],
    };
    let rows = fit.settings.iter().map(|of| {
        let mut row: Vec<Cell> = vec![named(damper, of.setting, words).into(), Cell::count(of.tests)];
        row.extend(pair(Some(&of.own_fit)));
        row.extend(pair(Some(&of.family)));
        row.extend(pair(of.left_out.as_ref()));
        row.push(of.left_out_ratio.map_or_else(Cell::none, |ratio| Cell::number(ratio, |value| digits(value, 3))));
        row
    });
    let mut columns = vec![Column::words(words.col_setting), Column::figures(words.col_number)];
    for group in [words.family_own_fit, words.family_fit, words.family_without] {
        let headings = [words.col_mean_error, words.col_error_percent];
        columns.extend(headings.map(|heading| Column::figures(heading).in_group(group)));
    }
    columns.push(Column::figures(words.col_ratio).in_group(words.family_without));
    Table { caption: words.family_left_out_table.to_owned(), columns, rows: rows.collect(), sortable: false }
}
