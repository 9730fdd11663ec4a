//! The model's parameters.

use super::blocks::{Block, Column, Section, Table};
use super::numbers::digits;
use crate::words::Words;

/// One parameter of the model.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterRow {
    /// Name as in the model file.
    pub name: String,
    /// Value, in `unit`.
    pub value: f64,
    /// Unit.
    pub unit: String,
    /// Lower end of the range, where known.
    pub low: Option<f64>,
    /// Upper end of the range, where known.
    pub high: Option<f64>,
    /// Where the value comes from: identified, measured, default, given.
    pub source: String,
    /// Remark; may be empty.
    pub note: String,
    /// Whether the data could not determine it.
    pub missing: bool,
}

/// The table of parameters; `None` without any.
pub fn section(parameters: &[ParameterRow], words: &Words) -> Option<Section> {
    if parameters.is_empty() {
        return None;
    }
    let known = |value: Option<f64>| value.map_or_else(String::new, |value| digits(value, 4));
    let rows = parameters
        .iter()
        .map(|row| {
            vec![
                row.name.clone(),
                digits(row.value, 4),
                row.unit.clone(),
                known(row.low),
                known(row.high),
                row.source.clone(),
                if row.missing { words.not_identified.to_owned() } else { row.note.clone() },
            ]
        })
        .collect();
    let columns = vec![
        Column::words(words.col_name),
        Column::figures(words.col_value),
        Column::words(words.col_unit),
        Column::figures(words.col_low),
        Column::figures(words.col_high),
        Column::words(words.col_source),
        Column::words(words.col_note),
    ];
    let table = Table { caption: words.parameters_range.to_owned(), columns, rows, sortable: false };
    Some(Section::new("parameters", words.parameters_section, vec![Block::Table(table)]))
}
