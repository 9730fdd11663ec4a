//! Force hysteresis of every test with whole cycles: gap, area and energy of the loop.

use super::blocks::{Block, Column, Section, Table};
use super::numbers::{comparable, error};
use crate::cells::Cell;
use crate::words::Words;
use dashpot_identification::validation::{Hysteresis, OfEach, TestValidation, Validation};

/// Builds the section with the table of hysteresis. Returns `None` if no test has whole cycles.
pub fn section(validation: &Validation, words: &Words) -> Option<Section> {
    let measured: Vec<(&TestValidation, &Hysteresis)> =
        validation.tests.iter().filter_map(|test| Some((test, test.hysteresis.as_ref()?))).collect();
    if measured.is_empty() {
        return None;
    }
    let rows = measured
        .iter()
        .map(|(test, hysteresis)| {
            let mut cells = vec![test.name.as_str().into(), Cell::count(hysteresis.cycles)];
            cells.extend(each(&hysteresis.mean_gap_n, error));
            cells.extend([hysteresis.gap_error_n, hysteresis.gap_error_fv_only_n].map(|gap| Cell::number(gap, error)));
            cells.extend(each(&hysteresis.area_n_m_s, |value| comparable(value, hysteresis.area_n_m_s.measured)));
            cells.extend(each(&hysteresis.energy_j, |value| comparable(value, hysteresis.energy_j.measured)));
            cells
        })
        .collect();
    let mut columns = vec![Column::words(words.col_test), Column::figures(words.col_cycles)];
    let names = [words.col_measured, words.model, words.col_curve];
    columns.extend(names.map(|name| Column::figures(name).in_group(words.group_gap)));
    columns.extend([words.model, words.col_curve].map(|name| Column::figures(name).in_group(words.group_gap_error)));
    columns.extend(names.map(|name| Column::figures(name).in_group(words.group_area)));
    columns.extend(names.map(|name| Column::figures(name).in_group(words.group_energy)));
    let table = Table { caption: words.hysteresis_caption.to_owned(), columns, rows, sortable: true };
    Some(Section::new("hysteresis", words.hysteresis_section, vec![Block::Table(table)]))
}

fn each(of: &OfEach, text: impl Fn(f64) -> String) -> [Cell; 3] {
    [of.measured, of.model, of.fv_only].map(|value| Cell::number(value, &text))
}
